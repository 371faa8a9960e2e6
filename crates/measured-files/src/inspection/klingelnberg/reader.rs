//! What each line of a file belongs to. Tables and curves end where their lines end; what is not understood is listed.

use super::block::{BlockHead, Heading, block_head, section};
use super::limits::{MAXIMUM_SAMPLES, MAXIMUM_TRACES, MAXIMUM_UNKNOWN_LINES, shown, too_large};
use super::number::{number, only_numbers};
use super::{Curve, KlingelnbergFile, UnknownLine, header, tables};
use crate::inspection::{InspectionError, InspectionWarning, WarningKind};
use foundation::geometry::Flank;

/// Most warnings that are kept, since the lines that cause them are bounded by the size of the file only; the number of further ones is reported.
const MOST_WARNINGS: usize = 2000;
/// The value for undefined where the preamble gives none.
const UNDEFINED: f64 = -2_147_483.648;

/// What lines of numbers belong to.
enum Open {
    Nothing,
    /// A curve that still lacks samples.
    Curve(Curve, usize),
    /// A curve with all its samples; whether too many have been reported.
    Full {
        line: usize,
        told: bool,
    },
    Pitch(Flank, Vec<usize>),
    Positions,
    Circle,
}

/// The reading of one file.
pub(super) struct Reader {
    file: KlingelnbergFile,
    undefined: f64,
    section: Option<Heading>,
    open: Open,
    /// No more codes of the header: curves, tables or values have begun.
    data: bool,
    /// Warnings that are not kept, and the line of the first.
    more: Option<(usize, usize)>,
}

impl Reader {
    /// Nothing read yet but the first line.
    pub fn new(file: KlingelnbergFile) -> Self {
        Self { file, undefined: UNDEFINED, section: None, open: Open::Nothing, data: false, more: None }
    }

    /// The end of the file; `cut` is the last line if that has no end.
    pub fn finish(mut self, cut: Option<usize>) -> KlingelnbergFile {
        self.close();
        if let Some(line) = cut {
            let message = "the last line has no end: the file may be cut short, and the last value with it";
            self.warn(WarningKind::FileCutShort, line, message);
        }
        if let Some((count, line)) = self.more {
            let message = format!("{count} more warnings from here on are not listed");
            self.file.warnings.push(InspectionWarning::at(WarningKind::MoreWarnings, line, message));
        }
        self.file
    }

    fn warn(&mut self, kind: WarningKind, line: usize, message: impl Into<String>) {
        if self.file.warnings.len() < MOST_WARNINGS {
            self.file.warnings.push(InspectionWarning::at(kind, line, message));
        } else {
            self.more.get_or_insert((0, line)).0 += 1;
        }
    }

    /// Takes a line that is not empty, without blanks around it.
    pub fn line(&mut self, at: usize, line: &str) -> Result<(), InspectionError> {
        if self.row(at, line) || self.heading(at, line)? || self.entry(at, line) {
            return Ok(());
        }
        let text = shown(line);
        if self.file.unknown_lines.len() == MAXIMUM_UNKNOWN_LINES {
            let first = &self.file.unknown_lines[0];
            let (line, text) = (first.line, first.text.clone());
            return Err(InspectionError::TooManyUnknownLines { most: MAXIMUM_UNKNOWN_LINES, line, text });
        }
        self.file.unknown_lines.push(UnknownLine { line: at, text });
        Ok(())
    }

    /// A line of the table or curve that is open. A line that does not fit ends a curve.
    fn row(&mut self, at: usize, line: &str) -> bool {
        let undefined = self.undefined;
        let defined = move |v: f64| if v == undefined { f64::NAN } else { v };
        match &mut self.open {
            Open::Nothing => false,
            Open::Curve(curve, samples) => {
                let Some(numbers) = only_numbers(line) else {
                    self.close();
                    return false;
                };
                let room = *samples - curve.values.len();
                curve.values.extend(numbers.iter().take(room).map(|v| defined(*v)));
                if curve.values.len() == *samples {
                    let told = numbers.len() > room;
                    let full = Open::Full { line: curve.line, told };
                    if let Open::Curve(curve, samples) = std::mem::replace(&mut self.open, full) {
                        self.complete(curve, samples, told.then_some(at));
                    }
                }
                true
            }
            Open::Full { line: head, told } => {
                let (head, known) = (*head, *told);
                if only_numbers(line).is_none() {
                    return false;
                }
                *told = true;
                if !known {
                    self.too_long(at, head);
                }
                true
            }
            Open::Pitch(flank, columns) => {
                if let Some(titles) = tables::pitch_columns(line) {
                    *columns = titles;
                    return true;
                }
                let row = tables::pitch_row(line, columns, defined);
                self.file.pitch[*flank].extend(row);
                row.is_some()
            }
            Open::Positions => {
                let row = tables::position_row(line);
                self.file.positions.extend(row);
                row.is_some() || tables::is_position_titles(line)
            }
            Open::Circle => {
                let numbers = only_numbers(line);
                let found = numbers.is_some();
                if let Some(circle) = self.file.circles.last_mut() {
                    circle.diameters_mm.extend(numbers.into_iter().flatten().map(defined));
                }
                found
            }
        }
    }

    /// A line that begins a section, a curve or a table.
    fn heading(&mut self, at: usize, line: &str) -> Result<bool, InspectionError> {
        let head = match section(line) {
            Some((heading, rest)) => {
                let head = block_head(rest);
                if head.is_none() && !rest.is_empty() {
                    return Ok(false);
                }
                self.section = Some(heading);
                self.begin(Open::Nothing);
                head
            }
            None => block_head(line),
        };
        if let Some(head) = head {
            self.curve(at, head)?;
        } else if let Some(flank) = tables::pitch_heading(line) {
            self.begin(Open::Pitch(flank, (0..tables::PITCH_COLUMNS.len()).collect()));
        } else if tables::is_position_heading(line) {
            self.begin(Open::Positions);
        } else if let Some(circle) = tables::circle_heading(line) {
            self.file.circles.push(circle);
            self.begin(Open::Circle);
        } else {
            return Ok(section(line).is_some());
        }
        Ok(true)
    }

    fn begin(&mut self, open: Open) {
        self.close();
        self.data = true;
        self.open = open;
    }

    fn curve(&mut self, at: usize, head: BlockHead) -> Result<(), InspectionError> {
        too_large(&format!("samples of the trace in line {at}"), head.samples, MAXIMUM_SAMPLES)?;
        let kind = head.kind(self.section);
        if kind != head.axis {
            let message = format!(
                "the trace is a {}, but its place is that of a {}; it is read as a {}",
                kind.name(),
                head.axis.name(),
                kind.name()
            );
            self.warn(WarningKind::Unusable, at, message);
        }
        let BlockHead { tooth, tag, flank, samples, position, .. } = head;
        let curve = Curve { kind, tooth, tag, flank, position_mm: position, values: Vec::new(), line: at };
        self.begin(Open::Nothing);
        if samples == 0 {
            self.complete(curve, 0, None);
            self.open = Open::Full { line: at, told: false };
        } else {
            self.open = Open::Curve(curve, samples);
        }
        // One more than is kept, so that the last curve allowed may be the last of the file.
        too_large("traces of the file", self.file.curves.len() + 1, MAXIMUM_TRACES)
    }

    /// Takes a curve that has all its samples.
    fn complete(&mut self, curve: Curve, samples: usize, surplus: Option<usize>) {
        let head = curve.line;
        if samples < 2 {
            self.warn(WarningKind::TraceEmpty, head, format!("a trace of {samples} samples is dropped"));
        } else {
            self.file.curves.push(curve);
        }
        if let Some(at) = surplus {
            self.too_long(at, head);
        }
    }

    fn too_long(&mut self, at: usize, head: usize) {
        let message =
            format!("the trace of line {head} has more values than it states; they are cut from here");
        self.warn(WarningKind::TraceTooLong, at, message);
    }

    /// Ends what is open; a curve that lacks samples is dropped.
    fn close(&mut self) {
        if let Open::Curve(curve, samples) = std::mem::replace(&mut self.open, Open::Nothing) {
            let found = curve.values.len();
            let message = format!("the trace ends after {found} of {samples} values and is dropped");
            self.warn(WarningKind::TraceTruncated, curve.line, message);
        }
    }

    /// A single line: a printed value, a code of the header, a line of the preamble.
    fn entry(&mut self, at: usize, line: &str) -> bool {
        if let Some((code, value)) = tables::result(line) {
            self.begin(Open::Nothing);
            if self.file.results.insert(code, value).is_some() {
                self.warn(
                    WarningKind::DuplicateCode,
                    at,
                    format!("the value {code} stands twice; this one holds"),
                );
            }
            return true;
        }
        if self.data {
            return false;
        }
        if let Some((code, entry)) = header::coded(line, at) {
            if self.file.header.insert(code, entry).is_some() {
                self.warn(
                    WarningKind::DuplicateCode,
                    at,
                    format!("the code {code} stands twice; this line holds"),
                );
            }
            return true;
        }
        let Some(entry) = header::preamble(line).filter(|_| self.file.header.is_empty()) else {
            return false;
        };
        if entry.key == "UNDEFINED" {
            match number(&entry.value) {
                Some(value) => self.undefined = value,
                None => {
                    self.warn(WarningKind::Unusable, at, "UNDEFINED is no number; the usual value stands in")
                }
            }
        }
        if entry.key == "LANGUAGE" && entry.value.split_whitespace().next() != Some("0") {
            self.warn(
                WarningKind::Language,
                at,
                "the labels are not German: sections may not be found, codes are",
            );
        }
        self.file.preamble.push(entry);
        true
    }
}
