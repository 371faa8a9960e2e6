//! What was measured on the grid of a bevel gear as a table: CSV with the columns tooth, flank, row, column and f_um, or x_mm, y_mm, z_mm;
//! one point a row.

use std::collections::HashSet;
use std::path::Path;

use super::trace_table::READING;
use foundation::geometry::Flank;
use job::decimal_comma::with_points;
use job::table_rows::{Row, TableForm};
use job::{Diagnostic, JobError, Problem, Source};

/// Normal deviations.
const DEVIATIONS: TableForm<5> = TableForm {
    columns: ["tooth", "flank", "row", "column", "f_um"],
    optional: Some(READING),
    row: "each point",
};

/// Points in space.
const POINTS: TableForm<7> = TableForm {
    columns: ["tooth", "flank", "row", "column", "x_mm", "y_mm", "z_mm"],
    optional: Some(READING),
    row: "each point",
};

/// Size of the grid that was measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct GridSize {
    /// Teeth of the gear.
    pub teeth: u32,
    /// Rows, from root to tip.
    pub rows: usize,
    /// Columns, from toe to heel.
    pub columns: usize,
}

/// What a probe found at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Touched {
    /// Deviation along the normal, um, > 0 material; NaN where nothing was measured.
    Deviation(f64),
    /// Where the flank lies, mm in the coordinates of the gear.
    At([f64; 3]),
}

/// A point that was measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GridReading {
    /// Tooth, from 1.
    pub tooth: u32,
    /// Its flank.
    pub flank: Flank,
    /// Row, from 1.
    pub row: usize,
    /// Column, from 1.
    pub column: usize,
    /// Which reading, from 1.
    pub reading: u32,
    /// What was found.
    pub found: Touched,
}

/// Reads the table of a gear with a grid of this size. The first line names the columns in any order; lines that begin with `#` are
/// comments. A column `reading` numbers what was measured more than once.
///
/// # Errors
/// Those of [`Source::read`]; `invalid-table`, `unknown-value`, `invalid-number` with line, column and value.
pub fn read_grid_table(path: &Path, size: GridSize) -> Result<Vec<GridReading>, JobError> {
    parse_grid_table(Source::read(path)?, size)
}

/// As [`read_grid_table`], from a text.
///
/// # Errors
/// As there.
pub fn parse_grid_table(source: Source, size: GridSize) -> Result<Vec<GridReading>, JobError> {
    let text = with_points(source.text());
    let head = text.lines().find(|line| !line.trim().is_empty() && !line.starts_with('#'));
    let of_points = head.unwrap_or_default().split(',').any(|title| title.trim() == "x_mm");
    let found = if of_points {
        let at = |row: &Row<'_, 7>| Ok(Touched::At([row.number(4)?, row.number(5)?, row.number(6)?]));
        readings(&POINTS, &text, size, at)
    } else {
        readings(&DEVIATIONS, &text, size, |row| Ok(Touched::Deviation(row.deviation(4)?)))
    };
    drop(text);
    found.map_err(|finding| JobError::single(source, finding))
}

fn readings<const N: usize>(
    form: &TableForm<N>,
    text: &str,
    size: GridSize,
    found: impl Fn(&Row<'_, N>) -> Result<Touched, Diagnostic>,
) -> Result<Vec<GridReading>, Diagnostic> {
    let mut known = HashSet::new();
    let mut readings = Vec::new();
    for row in form.rows(text)? {
        let number = |column: usize, most: usize| {
            row.parsed(column, &format!("a whole number from 1 to {most}"), |n: &usize| {
                (1..=most).contains(n)
            })
        };
        let teeth = size.teeth;
        let tooth =
            row.parsed(0, &format!("a tooth from 1 to {teeth}"), |n: &u32| (1..=teeth).contains(n))?;
        let one = GridReading {
            tooth,
            flank: row.flank(1)?,
            row: number(2, size.rows)?,
            column: number(3, size.columns)?,
            reading: row.reading()?,
            found: found(&row)?,
        };
        if !known.insert((one.tooth, one.flank, one.row, one.column, one.reading)) {
            let text = format!(
                "row {}, column {} of the {} flank of tooth {} stands here twice",
                one.row, one.column, one.flank, one.tooth
            );
            return Err(Diagnostic::new(Problem::InvalidTable, text)
                .field("row")
                .value(one.row)
                .allowed("every point once, or readings with numbers")
                .way_out("leave one of them out, or number both in a column `reading`")
                .span(Some(row.place())));
        }
        readings.push(one);
    }
    Ok(readings)
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZE: GridSize = GridSize { teeth: 16, rows: 5, columns: 9 };

    fn read(text: &str) -> Result<Vec<GridReading>, String> {
        parse_grid_table(Source::new("grid.csv", text), SIZE).map_err(|error| error.to_string())
    }

    #[test]
    fn deviations_and_points_are_told_apart_by_their_columns() {
        let found = read("column,row,f_um,flank,tooth\n9,5,-1.5,right,16\n# none\n1,1,,left,1\n").unwrap();
        assert_eq!((found[0].tooth, found[0].flank, found[0].row, found[0].column), (16, Flank::Right, 5, 9));
        assert_eq!(found[0].found, Touched::Deviation(-1.5));
        assert!(matches!(found[1].found, Touched::Deviation(f) if f.is_nan()));
        let found = read("tooth,flank,row,column,x_mm,y_mm,z_mm\n2,left,1,3,1.25,-2,30\n").unwrap();
        assert_eq!(found[0].found, Touched::At([1.25, -2.0, 30.0]));
        let twice = "tooth,flank,row,column,f_um,reading\n1,left,1,1,2,1\n1,left,1,1,3,2\n";
        assert_eq!(read(twice).unwrap()[1].reading, 2);
    }

    #[test]
    fn what_is_wrong_is_named() {
        for (text, told) in [
            ("", "the table has no rows"),
            ("tooth,flank,row,column\n1,left,1,1\n", "no column `f_um`"),
            ("tooth,flank,row,column,f_um\n17,left,1,1,0\n", "`tooth` cannot be `17`"),
            ("tooth,flank,row,column,f_um\n0,left,1,1,0\n", "`tooth` cannot be `0`"),
            ("tooth,flank,row,column,f_um\n1,up,1,1,0\n", "`flank` cannot be `up`"),
            ("tooth,flank,row,column,f_um\n1,left,6,1,0\n", "`row` cannot be `6`"),
            ("tooth,flank,row,column,f_um\n1,left,1,10,0\n", "`column` cannot be `10`"),
            ("tooth,flank,row,column,f_um\n1,left,1,1,1e9\n", "`f_um` cannot be `1e9`"),
            ("tooth,flank,row,column,x_mm,y_mm,z_mm\n1,left,1,1,2,3,\n", "`z_mm` cannot be ``"),
            ("tooth,flank,row,column,f_um\n1,left,1,1,0\n1,left,1,1,2\n", "stands here twice"),
        ] {
            let error = read(text).unwrap_err();
            assert!(error.contains(told), "{text:?}: {error}");
        }
    }
}
