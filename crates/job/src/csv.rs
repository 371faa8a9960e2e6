//! Tables of numbers as comma-separated text, units in the header.

use std::fmt::Write;

use thiserror::Error;

/// Name and unit of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Column {
    /// What stands in the column, e.g. `v_zS`.
    pub name: &'static str,
    /// Its unit, e.g. `mm`; empty for a number without one.
    pub unit: &'static str,
}

impl Column {
    /// A column with its unit.
    pub const fn new(name: &'static str, unit: &'static str) -> Self {
        Self { name, unit }
    }
}

/// A cell of a table that holds more than numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cell<'a> {
    /// A number.
    Number(f64),
    /// A word, quoted where it must be.
    Word(&'a str),
    /// Nothing.
    Empty,
}

/// A row that does not fit a table.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum CsvError {
    /// Another number of values than columns.
    #[error("a row of {values} values in a table of {columns} columns")]
    WrongWidth {
        /// Values of the row.
        values: usize,
        /// Columns of the table.
        columns: usize,
    },
    /// A value that is not finite.
    #[error("the value {value} in column `{column}` of row {row} is not finite")]
    InvalidNumber {
        /// The column's name.
        column: &'static str,
        /// Row, from 1.
        row: usize,
        /// The value.
        value: f64,
    },
}

/// A table that grows row by row; a labelled one begins each row with a word. Numbers are written with as many digits as it takes to read the same back.
#[derive(Clone, Debug, PartialEq)]
pub struct CsvTable {
    columns: Vec<Column>,
    label: bool,
    rows: usize,
    text: String,
}

impl CsvTable {
    /// A table with its header `name_unit,...`.
    pub fn new(columns: &[Column]) -> Self {
        let titles: Vec<String> = columns
            .iter()
            .map(|c| if c.unit.is_empty() { c.name.to_owned() } else { format!("{}_{}", c.name, c.unit) })
            .collect();
        Self { columns: columns.to_vec(), label: false, rows: 0, text: titles.join(",") + "\n" }
    }

    /// A table whose rows begin with a word, under the heading `label`.
    pub fn labelled(label: &str, columns: &[Column]) -> Self {
        let mut table = Self::new(columns);
        table.text.insert_str(0, &format!("{label},"));
        table.label = true;
        table
    }

    /// Adds a row.
    ///
    /// # Errors
    /// A row of another width or with a value that is not finite; the table stays as it was.
    pub fn push(&mut self, row: &[f64]) -> Result<(), CsvError> {
        self.push_labelled("", row)
    }

    /// Adds a row that begins with `label` (a plain word; only in a labelled table).
    ///
    /// # Errors
    /// As [`CsvTable::push`].
    pub fn push_labelled(&mut self, label: &str, row: &[f64]) -> Result<(), CsvError> {
        if row.len() != self.columns.len() {
            return Err(CsvError::WrongWidth { values: row.len(), columns: self.columns.len() });
        }
        if let Some(i) = row.iter().position(|v| !v.is_finite()) {
            return Err(CsvError::InvalidNumber {
                column: self.columns[i].name,
                row: self.rows + 1,
                value: row[i],
            });
        }
        if self.label {
            self.text.push_str(label);
        }
        for (i, value) in row.iter().enumerate() {
            let comma = if i == 0 && !self.label { "" } else { "," };
            // Writing to a text cannot fail.
            let _ = write!(self.text, "{comma}{value}");
        }
        self.text.push('\n');
        self.rows += 1;
        Ok(())
    }

    /// Adds a row of numbers, words and empty cells.
    ///
    /// # Errors
    /// As [`CsvTable::push`].
    pub fn push_cells(&mut self, row: &[Cell<'_>]) -> Result<(), CsvError> {
        if row.len() != self.columns.len() || self.label {
            return Err(CsvError::WrongWidth { values: row.len(), columns: self.columns.len() });
        }
        for (cell, column) in row.iter().zip(&self.columns) {
            if let Cell::Number(value) = *cell
                && !value.is_finite()
            {
                return Err(CsvError::InvalidNumber { column: column.name, row: self.rows + 1, value });
            }
        }
        for (i, cell) in row.iter().enumerate() {
            let comma = if i == 0 { "" } else { "," };
            // Writing to a text cannot fail.
            let _ = match cell {
                Cell::Number(value) => write!(self.text, "{comma}{value}"),
                Cell::Word(word) if word.contains([',', '"', '\n', '\r']) => {
                    write!(self.text, "{comma}\"{}\"", word.replace('"', "\"\""))
                }
                Cell::Word(word) => write!(self.text, "{comma}{word}"),
                Cell::Empty => write!(self.text, "{comma}"),
            };
        }
        self.text.push('\n');
        self.rows += 1;
        Ok(())
    }

    /// The whole table as text.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Number of rows without the header.
    pub fn rows(&self) -> usize {
        self.rows
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn header_with_units_and_exact_numbers() {
        let mut table = CsvTable::new(&[Column::new("v_zS", "mm"), Column::new("share", "")]);
        table.push(&[0.1, -2.0]).unwrap();
        assert_eq!(table.text(), "v_zS_mm,share\n0.1,-2\n");
        assert_eq!(table.push(&[1.0]), Err(CsvError::WrongWidth { values: 1, columns: 2 }));
        assert!(matches!(
            table.push(&[1.0, f64::NAN]),
            Err(CsvError::InvalidNumber { column: "share", row: 2, .. })
        ));
        assert_eq!(table.rows(), 1);
        let mut labelled = CsvTable::labelled("flank", &[Column::new("w", "mm")]);
        labelled.push_labelled("left", &[2.5]).unwrap();
        assert_eq!(labelled.text(), "flank,w_mm\nleft,2.5\n");
    }

    #[test]
    fn cells_hold_numbers_words_and_nothing() {
        let mut table = CsvTable::new(&[Column::new("w", "mm"), Column::new("why", "")]);
        table.push_cells(&[Cell::Number(-0.5), Cell::Word("axis, \"limit\"")]).unwrap();
        table.push_cells(&[Cell::Empty, Cell::Word("plain")]).unwrap();
        assert_eq!(table.text(), "w_mm,why\n-0.5,\"axis, \"\"limit\"\"\"\n,plain\n");
        assert_eq!(table.push_cells(&[Cell::Empty]), Err(CsvError::WrongWidth { values: 1, columns: 2 }));
        let refused = table.push_cells(&[Cell::Number(f64::INFINITY), Cell::Empty]);
        assert!(matches!(refused, Err(CsvError::InvalidNumber { column: "w", row: 3, .. })));
        assert_eq!(table.rows(), 2);
    }
}
