//! Rows of CSV tables whose columns are named in the first line, with errors that tell line, column and value. Knows no measurement.

use std::ops::Range;

use crate::exchange::diagnostic::{Diagnostic, Problem};
use crate::geometry::Flank;

/// Longest piece of a cell in a message, characters.
const SHOWN: usize = 60;

/// The columns that a table has to have.
pub(super) struct TableForm<const N: usize> {
    /// Their names.
    pub columns: [&'static str; N],
    /// What a row stands for.
    pub row: &'static str,
}

/// A row in the order of the form's columns.
pub(super) struct Row<'a, const N: usize> {
    form: &'a TableForm<N>,
    cells: [&'a str; N],
    span: Range<usize>,
}

impl<const N: usize> TableForm<N> {
    /// The first line of such a table.
    pub fn header(&self) -> String {
        self.columns.join(",")
    }

    /// All rows. The first line names the columns in any order; lines that begin with `#` and empty ones are left out.
    ///
    /// # Errors
    /// `invalid-table` for a header without a column, or with others, for rows of another length, and for a table without rows.
    pub fn rows<'a>(&'a self, text: &'a str) -> Result<Vec<Row<'a, N>>, Diagnostic> {
        let mut rows = Vec::new();
        let mut order: Option<[usize; N]> = None;
        let mut offset = 0;
        for line in text.split_inclusive('\n') {
            let start = offset;
            offset += line.len();
            let line = line.trim_end();
            if line.trim().is_empty() || line.starts_with('#') {
                continue;
            }
            let span = start..start + line.len();
            let cells: Vec<&str> = line.split(',').map(str::trim).collect();
            let Some(places) = order else {
                order = Some(self.places(&cells, span)?);
                continue;
            };
            if cells.len() != N {
                return Err(self
                    .malformed(format!("a row of {} values", cells.len()))
                    .value(shortened(line))
                    .way_out(format!("give {N} values with a decimal point, separated by commas"))
                    .span(Some(span)));
            }
            rows.push(Row { form: self, cells: places.map(|place| cells[place]), span });
        }
        if rows.is_empty() {
            let way_out =
                format!("begin it with the line `{}`, followed by one row for {}", self.header(), self.row);
            return Err(self.malformed("the table has no rows").value("an empty table").way_out(way_out));
        }
        Ok(rows)
    }

    /// Positions of the columns.
    fn places(&self, titles: &[&str], span: Range<usize>) -> Result<[usize; N], Diagnostic> {
        let mut order = [0; N];
        for (place, column) in order.iter_mut().zip(self.columns) {
            *place = titles.iter().position(|title| *title == column).ok_or_else(|| {
                self.malformed(format!("the table has no column `{column}`"))
                    .field(column)
                    .value(shortened(&titles.join(",")))
                    .way_out(format!("begin the table with the line `{}`", self.header()))
                    .span(Some(span.clone()))
            })?;
        }
        if titles.len() != N {
            return Err(self
                .malformed(format!("the table has {} columns", titles.len()))
                .value(shortened(&titles.join(",")))
                .way_out("remove the other columns")
                .span(Some(span)));
        }
        Ok(order)
    }

    /// A finding about the whole table.
    pub fn malformed(&self, message: impl Into<Box<str>>) -> Diagnostic {
        Diagnostic::new(Problem::InvalidTable, message).allowed(format!(
            "the columns {}, one row for {}",
            self.header(),
            self.row
        ))
    }
}

impl<const N: usize> Row<'_, N> {
    /// A cell as it stands.
    pub fn text(&self, column: usize) -> &str {
        self.cells[column]
    }

    /// A finding about a cell.
    pub fn wrong(&self, problem: Problem, column: usize, allowed: &str) -> Diagnostic {
        let cell = shortened(self.cells[column]);
        Diagnostic::new(problem, format!("`{}` cannot be {cell}", self.form.columns[column]))
            .field(self.form.columns[column])
            .value(cell)
            .allowed(allowed)
            .way_out("correct the cell")
            .span(Some(self.span.clone()))
    }

    /// The number of a tooth.
    ///
    /// # Errors
    /// `invalid-number`.
    pub fn tooth(&self, column: usize) -> Result<u32, Diagnostic> {
        let found = self.cells[column].parse().ok().filter(|tooth| *tooth <= 65_535);
        found.ok_or_else(|| self.wrong(Problem::InvalidNumber, column, "a whole number from 0 to 65535"))
    }

    /// A flank.
    ///
    /// # Errors
    /// `unknown-value`.
    pub fn flank(&self, column: usize) -> Result<Flank, Diagnostic> {
        let found = Flank::BOTH.into_iter().find(|flank| flank.name() == self.cells[column]);
        found.ok_or_else(|| self.wrong(Problem::UnknownValue, column, "left or right"))
    }

    /// A finite number.
    ///
    /// # Errors
    /// `invalid-number`.
    pub fn number(&self, column: usize) -> Result<f64, Diagnostic> {
        let found = self.cells[column].parse().ok().filter(|v: &f64| v.is_finite());
        let allowed = "a finite number with a decimal point";
        found.ok_or_else(|| self.wrong(Problem::InvalidNumber, column, allowed))
    }

    /// A deviation; NaN where the cell is empty or says so.
    ///
    /// # Errors
    /// `invalid-number`.
    pub fn deviation(&self, column: usize) -> Result<f64, Diagnostic> {
        if self.cells[column].is_empty() || self.cells[column].eq_ignore_ascii_case("nan") {
            return Ok(f64::NAN);
        }
        self.number(column)
    }
}

/// Cells come from the file and may be of any length.
fn shortened(text: &str) -> String {
    format!("`{}`", text.chars().take(SHOWN).collect::<String>())
}
