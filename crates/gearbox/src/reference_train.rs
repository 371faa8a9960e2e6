//! Reference pulses of a slide as a table: CSV with the columns tick and sign, one pulse a row. Reads it and keeps the place of
//! every pulse; whether ticks rise and which signs there are is left to the gearbox.

use job::decimal_comma::with_points;
use std::ops::Range;
use std::path::Path;

use crate::job::GREATEST_TICK;
use job::table_rows::TableForm;
use job::{Diagnostic, JobError, Source};

const FORM: TableForm<2> = TableForm { columns: ["tick", "sign"], optional: None, row: "each pulse" };

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
/// Those of [`Source::read`], among them `file-too-large` above [`job::MAXIMUM_BYTES`]; `invalid-table`, `invalid-number` with
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
    let ticks = format!("a whole number from 1 to 2^53 = {GREATEST_TICK}");
    let (mut references, mut places) = (Vec::new(), Vec::new());
    for row in FORM.rows(&with_points(text))? {
        let tick = row.parsed(0, &ticks, |tick: &u64| *tick <= GREATEST_TICK)?;
        references.push((tick, row.parsed(1, "1 or -1", |_: &i64| true)?));
        places.push(Some(row.place()));
    }
    Ok((references, places))
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
