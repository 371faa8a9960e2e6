//! Rows of CSV tables whose columns are named in the first line, with errors that tell line, column and value. Knows no content of them.

use std::ops::Range;
use std::str::FromStr;

use super::diagnostic::{Diagnostic, Problem};
use foundation::geometry::Flank;

/// Longest piece of a cell in a message, characters.
const SHOWN: usize = 60;

/// The columns that a table has to have.
pub struct TableForm<const N: usize> {
    /// Their names.
    pub columns: [&'static str; N],
    /// One more that it may have.
    pub optional: Option<&'static str>,
    /// What a row stands for.
    pub row: &'static str,
}

/// A row in the order of the form's columns.
pub struct Row<'a, const N: usize> {
    form: &'a TableForm<N>,
    cells: [Place<'a>; N],
    /// The cell of the column that the table may have, where it has it.
    optional: Option<Place<'a>>,
    span: Range<usize>,
}

/// A cell without the blanks around it, and its place in the text.
type Place<'a> = (&'a str, Range<usize>);

fn cells(line: &str, start: usize) -> Vec<Place<'_>> {
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

/// Where the columns stand.
#[derive(Clone, Copy)]
struct Order<const N: usize> {
    columns: [usize; N],
    optional: Option<usize>,
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
        let mut order: Option<Order<N>> = None;
        let mut offset = 0;
        for line in text.split_inclusive(['\n', '\r']) {
            let start = offset;
            offset += line.len();
            let line = line.trim_end();
            if line.trim().is_empty() || line.starts_with('#') {
                continue;
            }
            let span = start..start + line.len();
            let mut cells = cells(line, start);
            let Some(places) = order else {
                order = Some(self.places(&cells, span)?);
                continue;
            };
            let count = N + usize::from(places.optional.is_some());
            if cells.len() != count {
                return Err(self
                    .malformed(format!("a row of {} values", cells.len()))
                    .value(shortened(line))
                    .way_out(format!("give {count} values with a decimal point, separated by commas"))
                    .span(Some(span)));
            }
            let optional = places.optional.map(|place| std::mem::take(&mut cells[place]));
            let cells = places.columns.map(|place| std::mem::take(&mut cells[place]));
            rows.push(Row { form: self, cells, optional, span });
        }
        if rows.is_empty() {
            let way_out =
                format!("begin it with the line `{}`, followed by one row for {}", self.header(), self.row);
            return Err(self.malformed("the table has no rows").value("an empty table").way_out(way_out));
        }
        Ok(rows)
    }

    /// Positions of the columns.
    fn places(&self, titles: &[Place<'_>], span: Range<usize>) -> Result<Order<N>, Diagnostic> {
        let named = || shortened(&titles.iter().map(|(title, _)| *title).collect::<Vec<_>>().join(","));
        let mut order = [0; N];
        for (place, column) in order.iter_mut().zip(self.columns) {
            *place = titles.iter().position(|(title, _)| *title == column).ok_or_else(|| {
                self.malformed(format!("the table has no column `{column}`"))
                    .field(column)
                    .value(named())
                    .way_out(format!("begin the table with the line `{}`", self.header()))
                    .span(Some(span.clone()))
            })?;
        }
        let optional = self.optional.and_then(|column| titles.iter().position(|(title, _)| *title == column));
        if titles.len() != N + usize::from(optional.is_some()) {
            return Err(self
                .malformed(format!("the table has {} columns", titles.len()))
                .value(named())
                .way_out("remove the other columns")
                .span(Some(span)));
        }
        Ok(Order { columns: order, optional })
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
    /// Where the row stands in the text.
    pub fn place(&self) -> Range<usize> {
        self.span.clone()
    }

    /// A cell as it stands.
    pub fn text(&self, column: usize) -> &str {
        self.cells[column].0
    }

    /// A finding about a cell.
    pub fn wrong(&self, problem: Problem, column: usize, allowed: impl Into<String>) -> Diagnostic {
        let (cell, place) = &self.cells[column];
        let (cell, name) = (shortened(cell), self.form.columns[column]);
        Diagnostic::new(problem, format!("`{name}` cannot be {cell}"))
            .field(name)
            .value(cell)
            .allowed(allowed.into())
            .way_out("correct the value in this row")
            .span(Some(place.clone()))
    }

    /// One of some words.
    ///
    /// # Errors
    /// `unknown-value`.
    pub fn word<T: Copy>(&self, column: usize, words: &[(&str, T)], allowed: &str) -> Result<T, Diagnostic> {
        let found = words.iter().find(|(word, _)| *word == self.text(column)).map(|(_, value)| *value);
        found.ok_or_else(|| self.wrong(Problem::UnknownValue, column, allowed))
    }

    /// A flank.
    ///
    /// # Errors
    /// `unknown-value`.
    pub fn flank(&self, column: usize) -> Result<Flank, Diagnostic> {
        self.word(column, &Flank::BOTH.map(|flank| (flank.name(), flank)), "left or right")
    }

    /// A number of any kind within its range.
    ///
    /// # Errors
    /// `invalid-number`.
    pub fn parsed<T: FromStr>(
        &self,
        column: usize,
        allowed: &str,
        in_range: impl Fn(&T) -> bool,
    ) -> Result<T, Diagnostic> {
        let found = self.text(column).parse().ok().filter(in_range);
        found.ok_or_else(|| self.wrong(Problem::InvalidNumber, column, allowed))
    }

    /// The number of a tooth.
    ///
    /// # Errors
    /// `invalid-number`.
    pub fn tooth(&self, column: usize) -> Result<u32, Diagnostic> {
        self.parsed(column, "a whole number from 0 to 65535", |tooth| *tooth <= 65_535)
    }

    /// The cell of the column that the table may have; `None` where it has it not.
    pub fn optional(&self) -> Option<&str> {
        self.optional.as_ref().map(|(cell, _)| *cell)
    }

    /// A finding about that cell, or about the row.
    pub fn wrong_optional(&self, problem: Problem, allowed: impl Into<String>) -> Diagnostic {
        let (cell, place) = self.optional.clone().unwrap_or(("", self.span.clone()));
        let (cell, name) = (shortened(cell), self.form.optional.unwrap_or_default());
        Diagnostic::new(problem, format!("`{name}` cannot be {cell}"))
            .field(name)
            .value(cell)
            .allowed(allowed.into())
            .way_out("correct the value in this row")
            .span(Some(place))
    }

    /// Which reading of several, from 1; 1 where the table does not number them.
    ///
    /// # Errors
    /// `invalid-number`.
    pub fn reading(&self) -> Result<u32, Diagnostic> {
        let Some(cell) = self.optional() else { return Ok(1) };
        cell.parse().ok().filter(|reading| (1..=1000).contains(reading)).ok_or_else(|| {
            self.wrong_optional(Problem::InvalidNumber, "a whole number from 1 to 1000")
                .way_out("number the readings of a tooth from 1")
        })
    }

    /// A finite number.
    ///
    /// # Errors
    /// `invalid-number`.
    pub fn number(&self, column: usize) -> Result<f64, Diagnostic> {
        self.parsed(column, "a finite number with a decimal point", |v: &f64| v.is_finite())
    }

    /// A length of roll.
    ///
    /// # Errors
    /// `invalid-number`.
    pub fn length_of_roll(&self, column: usize) -> Result<f64, Diagnostic> {
        self.parsed(column, "a length of roll in mm, not below 0", |v: &f64| v.is_finite() && *v >= 0.0)
    }

    /// A deviation; NaN where the cell is empty or says so.
    ///
    /// # Errors
    /// `invalid-number`.
    pub fn deviation(&self, column: usize) -> Result<f64, Diagnostic> {
        let cell = self.text(column);
        if cell.is_empty() || cell.eq_ignore_ascii_case("nan") {
            return Ok(f64::NAN);
        }
        let allowed = "a deviation in micrometres from -100000 to 100000, or nothing where none was measured";
        self.parsed(column, allowed, |v: &f64| v.abs() <= 1e5)
    }
}

/// Cells come from the file and may be of any length.
fn shortened(text: &str) -> String {
    format!("`{}`", text.chars().take(SHOWN).collect::<String>())
}
