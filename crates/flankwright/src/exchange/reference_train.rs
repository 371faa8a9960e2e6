//! Reference pulses of a slide as a table: CSV with the columns tick and sign, one pulse a row. Reads it and keeps the place of
//! every pulse; whether ticks rise and which signs there are is left to the gearbox.

use std::ops::Range;
use std::path::Path;

use super::diagnostic::{Diagnostic, JobError, Problem};
use super::gearbox_job::GREATEST_TICK;
use super::source::Source;

const COLUMNS: [&str; 2] = ["tick", "sign"];

/// Reference pulses with the place of each in its file.
#[derive(Clone, Debug, PartialEq)]
pub struct ReferenceTrain {
    references: Vec<(u64, i64)>,
    source: Source,
    places: Vec<Option<Range<usize>>>,
}

impl ReferenceTrain {
    /// Pulses `(tick, sign)` of a text, with the place of each.
    pub(super) fn new(
        references: Vec<(u64, i64)>,
        source: Source,
        places: Vec<Option<Range<usize>>>,
    ) -> Self {
        Self { references, source, places }
    }

    /// The pulses `(tick, sign)` in the order of the file.
    pub fn references(&self) -> &[(u64, i64)] {
        &self.references
    }

    /// An error about the pulse of this number, from 0, at its place in the table or in the job.
    pub fn error(&self, index: u64, diagnostic: Diagnostic) -> JobError {
        let place = usize::try_from(index).ok().and_then(|i| self.places.get(i).cloned().flatten());
        JobError::single(self.source.clone(), diagnostic.span(place))
    }
}

/// Reads the table; the first line names the columns in any order. Lines that begin with `#` are comments.
///
/// # Errors
/// Those of [`Source::read`], among them `file-too-large` above [`super::MAXIMUM_BYTES`]; `invalid-table`, `invalid-number` with
/// line, column and value.
pub fn read_reference_train(path: &Path) -> Result<ReferenceTrain, JobError> {
    parse_reference_train(Source::read(path)?)
}

/// As [`read_reference_train`], from a text.
///
/// # Errors
/// As [`read_reference_train`].
pub fn parse_reference_train(source: Source) -> Result<ReferenceTrain, JobError> {
    match rows(source.text()) {
        Ok((references, places)) => Ok(ReferenceTrain::new(references, source, places)),
        Err(finding) => Err(JobError::single(source, finding)),
    }
}

/// Pulses, and the place of the row of each.
type Rows = (Vec<(u64, i64)>, Vec<Option<Range<usize>>>);

fn rows(text: &str) -> Result<Rows, Diagnostic> {
    let (mut references, mut places) = (Vec::new(), Vec::new());
    let mut order: Option<[usize; 2]> = None;
    let mut offset = 0;
    for line in text.split_inclusive('\n') {
        let start = offset;
        offset += line.len();
        let line = line.trim_end();
        if line.trim().is_empty() || line.starts_with('#') {
            continue;
        }
        let cells = cells(line, start);
        let Some([tick, sign]) = order else {
            order = Some(columns(&cells)?);
            continue;
        };
        let place = start..start + line.len();
        if cells.len() != COLUMNS.len() {
            return Err(malformed(format!("a row of {} values", cells.len()))
                .value(shortened(line))
                .way_out("give a tick and a sign, separated by a comma")
                .span(Some(place)));
        }
        let allowed = format!("a whole number from 1 to 2^53 = {GREATEST_TICK}");
        let tick = number(&cells[tick], COLUMNS[0], &allowed, |tick: &u64| *tick <= GREATEST_TICK)?;
        let sign = number(&cells[sign], COLUMNS[1], "1 or -1", |_: &i64| true)?;
        references.push((tick, sign));
        places.push(Some(place));
    }
    if references.is_empty() {
        return Err(malformed("the table has no reference pulse")
            .value("an empty table")
            .way_out("begin it with the line `tick,sign`, followed by one row for each pulse"));
    }
    Ok((references, places))
}

/// A cell without the blanks around it, and its place in the text.
type Cell<'a> = (&'a str, Range<usize>);

fn cells(line: &str, start: usize) -> Vec<Cell<'_>> {
    let mut offset = start;
    line.split(',')
        .map(|cell| {
            let from = offset + (cell.len() - cell.trim_start().len());
            offset += cell.len() + 1;
            let cell = cell.trim();
            (cell, from..from + cell.len())
        })
        .collect()
}

/// Positions of the columns.
fn columns(titles: &[Cell<'_>]) -> Result<[usize; 2], Diagnostic> {
    let whole = titles.first().zip(titles.last()).map(|(first, last)| first.1.start..last.1.end);
    let named = titles.iter().map(|(title, _)| *title).collect::<Vec<_>>().join(",");
    let mut order = [0; 2];
    for (place, column) in order.iter_mut().zip(COLUMNS) {
        *place = titles.iter().position(|(title, _)| *title == column).ok_or_else(|| {
            malformed(format!("the table has no column `{column}`"))
                .field(column)
                .value(shortened(&named))
                .way_out("begin the table with the line `tick,sign`")
                .span(whole.clone())
        })?;
    }
    if titles.len() != COLUMNS.len() {
        return Err(malformed(format!("the table has {} columns", titles.len()))
            .value(shortened(&named))
            .way_out("remove the other columns")
            .span(whole));
    }
    Ok(order)
}

fn number<T: std::str::FromStr>(
    (cell, place): &Cell<'_>,
    column: &str,
    allowed: &str,
    in_range: impl Fn(&T) -> bool,
) -> Result<T, Diagnostic> {
    cell.parse().ok().filter(in_range).ok_or_else(|| {
        Diagnostic::new(Problem::InvalidNumber, format!("`{column}` cannot be {}", shortened(cell)))
            .field(column)
            .value(shortened(cell))
            .allowed(allowed)
            .way_out("correct the value in this row")
            .span(Some(place.clone()))
    })
}

fn malformed(message: impl Into<Box<str>>) -> Diagnostic {
    Diagnostic::new(Problem::InvalidTable, message).allowed("the columns tick,sign, one row for each pulse")
}

/// Cells come from the file and may be of any length.
fn shortened(text: &str) -> String {
    const LONGEST: usize = 60;
    format!("`{}`", text.chars().take(LONGEST).collect::<String>())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<ReferenceTrain, JobError> {
        parse_reference_train(Source::new("train.csv", text))
    }

    #[test]
    fn reads_pulses_in_any_order_of_columns() {
        let train = read("# measured\r\nsign, tick\r\n1,100\r\n\r\n -1 , 260\r\n").unwrap();
        assert_eq!(train.references(), [(100, 1), (260, -1)]);
        // What the gearbox refuses is refused there.
        let odd = read("tick,sign\n7,1\n0,3\n9007199254740992,-1\n").unwrap();
        assert_eq!(odd.references(), [(7, 1), (0, 3), (1 << 53, -1)]);
    }

    #[test]
    fn an_error_of_the_gearbox_names_the_row() {
        let train = read("# measured\ntick,sign\n100,1\n\n90,1\n").unwrap();
        let finding = Diagnostic::with_code("bad-reference-train", "the ticks do not rise");
        let told = train.error(1, finding.clone()).to_string();
        assert!(told.starts_with("train.csv:5:1: the ticks do not rise"), "{told}");
        assert_eq!(train.error(2, finding).diagnostics[0].span, None);
    }

    #[test]
    fn what_is_wrong_is_told_with_line_and_column() {
        let cases = [
            ("", "invalid-table", "train.csv: "),
            ("tick,sign\n", "invalid-table", "train.csv: "),
            ("ticks,sign\n1,1\n", "invalid-table", "train.csv:1:1: "),
            ("tick,sign,kind\n1,1,R\n", "invalid-table", "train.csv:1:1: "),
            ("tick,sign,tick\n1,1,1\n", "invalid-table", "train.csv:1:1: "),
            ("tick,sign\n1,1\n2\n", "invalid-table", "train.csv:3:1: "),
            ("tick,sign\n1,1\n2,1,3\n", "invalid-table", "train.csv:3:1: "),
            ("tick,sign\n1,1\n-2,1\n", "invalid-number", "train.csv:3:1: "),
            ("tick,sign\n1,1\n2.5,1\n", "invalid-number", "train.csv:3:1: "),
            ("tick,sign\n1,1\n9007199254740993,1\n", "invalid-number", "train.csv:3:1: "),
            ("tick,sign\n1,1\n2, up\n", "invalid-number", "train.csv:3:4: "),
            ("tick,sign\n1,1\n2,\n", "invalid-number", "train.csv:3:3: "),
            ("tick,sign\n1,1\nnan,1\n", "invalid-number", "train.csv:3:1: "),
        ];
        for (text, code, place) in cases {
            let error = read(text).unwrap_err();
            let finding = &error.diagnostics[0];
            assert_eq!(finding.code, code, "{text}: {error}");
            assert!(error.to_string().starts_with(place), "{text}: {error}");
            assert!(finding.value.is_some() && finding.allowed.is_some() && finding.way_out.is_some());
        }
    }
}
