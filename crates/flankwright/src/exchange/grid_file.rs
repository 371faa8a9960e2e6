//! A target given as a table of values: CSV with the columns w_mm, z_mm, f_um, on a full grid or scattered. Reads and
//! checks it; knows nothing of how values between the points are found.

use std::ops::Range;
use std::path::Path;

use super::diagnostic::{Diagnostic, JobError, Problem};
use super::source::Source;

/// Fewest points along each direction: a cubic through them needs four.
const LEAST: usize = 4;

const COLUMNS: [&str; 3] = ["w_mm", "z_mm", "f_um"];

/// Values on a full grid; f positive = material.
#[derive(Clone, Debug, PartialEq)]
pub struct GridTarget {
    /// Lengths of roll in mm, ascending.
    pub w_mm: Vec<f64>,
    /// Positions along the face width in mm, ascending.
    pub z_mm: Vec<f64>,
    /// Values in um, `[w][z]`.
    pub f_um: Vec<Vec<f64>>,
}

/// Reads the table; rows in any order, each point of the grid once. Lines that begin with `#` are comments.
///
/// # Errors
/// Those of [`Source::read`]; `invalid-table`, `invalid-number` with line and value.
pub fn read_grid_target(path: &Path) -> Result<GridTarget, JobError> {
    let source = Source::read(path)?;
    parse(source.text()).map_err(|finding| JobError::single(source, finding))
}

/// Reads the same table as scattered points `[w_mm, z_mm, f_um]` in the order of the file.
///
/// # Errors
/// Those of [`Source::read`]; `invalid-table`, `invalid-number` with line and value.
pub fn read_points(path: &Path) -> Result<Vec<[f64; 3]>, JobError> {
    let source = Source::read(path)?;
    let rows = parse_rows(source.text()).map_err(|finding| JobError::single(source, finding))?;
    Ok(rows.into_iter().map(|(row, _)| row).collect())
}

fn parse(text: &str) -> Result<GridTarget, Diagnostic> {
    assemble(parse_rows(text)?)
}

/// A row of the table with its place in the text.
type Row = ([f64; 3], Range<usize>);

fn parse_rows(text: &str) -> Result<Vec<Row>, Diagnostic> {
    let mut rows: Vec<Row> = Vec::new();
    let mut header = None;
    let mut offset = 0;
    for line in text.split_inclusive('\n') {
        let start = offset;
        offset += line.len();
        let line = line.trim_end();
        let span = start..start + line.len();
        if line.trim().is_empty() || line.starts_with('#') {
            continue;
        }
        match header {
            None => header = Some(columns(line, span)?),
            Some(order) => rows.push((values(line, order, &span)?, span)),
        }
    }
    if header.is_none() {
        return Err(malformed("the table is empty").way_out("begin it with the line `w_mm,z_mm,f_um`"));
    }
    Ok(rows)
}

fn malformed(message: impl Into<Box<str>>) -> Diagnostic {
    Diagnostic::new(Problem::InvalidTable, message)
        .allowed("the columns w_mm,z_mm,f_um, one row for each point of the grid")
}

/// Positions of the three columns.
fn columns(line: &str, span: Range<usize>) -> Result<[usize; 3], Diagnostic> {
    let titles: Vec<&str> = line.split(',').map(str::trim).collect();
    let mut order = [0; 3];
    for (place, column) in order.iter_mut().zip(COLUMNS) {
        *place = titles.iter().position(|t| *t == column).ok_or_else(|| {
            malformed(format!("the table has no column `{column}`"))
                .field(column)
                .value(line.chars().take(60).collect::<String>())
                .way_out("begin the table with the line `w_mm,z_mm,f_um`")
                .span(Some(span.clone()))
        })?;
    }
    if let Some(unknown) = titles.iter().find(|t| !COLUMNS.contains(t)) {
        let message = format!("the column `{}` is not known", unknown.chars().take(60).collect::<String>());
        return Err(malformed(message).way_out("remove the column").span(Some(span)));
    }
    if titles.len() != COLUMNS.len() {
        return Err(malformed("a column stands twice").way_out("remove one of the two").span(Some(span)));
    }
    Ok(order)
}

fn values(line: &str, order: [usize; 3], span: &Range<usize>) -> Result<[f64; 3], Diagnostic> {
    let cells: Vec<&str> = line.split(',').map(str::trim).collect();
    if cells.len() != order.len() {
        return Err(malformed(format!("a row of {} values", cells.len()))
            .way_out("give three values with a decimal point, separated by commas")
            .span(Some(span.clone())));
    }
    let mut row = [0.0; 3];
    for ((value, column), place) in row.iter_mut().zip(COLUMNS).zip(order) {
        let cell = cells[place];
        *value = cell.parse().ok().filter(|v: &f64| v.is_finite()).ok_or_else(|| {
            Diagnostic::new(Problem::InvalidNumber, format!("`{column}` is not a finite number"))
                .field(column)
                .value(cell.chars().take(60).collect::<String>())
                .allowed("a finite number with a decimal point")
                .way_out("correct the value or measure the point again")
                .span(Some(span.clone()))
        })?;
    }
    Ok(row)
}

fn assemble(rows: Vec<Row>) -> Result<GridTarget, Diagnostic> {
    let axis = |index: usize| {
        let mut values: Vec<f64> = rows.iter().map(|(row, _)| row[index]).collect();
        values.sort_by(f64::total_cmp);
        values.dedup();
        values
    };
    let (w_mm, z_mm) = (axis(0), axis(1));
    for (column, values) in [("w_mm", &w_mm), ("z_mm", &z_mm)] {
        if values.len() < LEAST {
            return Err(malformed(format!("the grid has {} different values of `{column}`", values.len()))
                .field(column)
                .value(values.len())
                .allowed(format!("at least {LEAST} different values of `{column}`"))
                .way_out("give a finer grid"));
        }
    }
    // Beyond the number of rows a grid cannot be full; testing first keeps a scattered table from taking memory.
    if w_mm.len() * z_mm.len() != rows.len() {
        return Err(malformed(format!(
            "the points form no full grid: {} rows for {} x {} values of w_mm and z_mm",
            rows.len(),
            w_mm.len(),
            z_mm.len()
        ))
        .value(rows.len())
        .way_out("give every pair of w_mm and z_mm once; scattered points are the kind \"points\" of `modifications`"));
    }
    let mut f_um = vec![vec![f64::NAN; z_mm.len()]; w_mm.len()];
    for (row, span) in rows {
        let place = |values: &[f64], value: f64| values.partition_point(|v| v.total_cmp(&value).is_lt());
        let (i, j) = (place(&w_mm, row[0]), place(&z_mm, row[1]));
        if !f_um[i][j].is_nan() {
            return Err(malformed(format!("the point w = {}, z = {} stands twice", row[0], row[1]))
                .way_out("delete one of the two rows")
                .span(Some(span)));
        }
        f_um[i][j] = row[2];
    }
    Ok(GridTarget { w_mm, z_mm, f_um })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(change: impl Fn(usize, usize, String) -> Option<String>) -> String {
        let mut text = "# measured\nz_mm,w_mm,f_um\r\n".to_owned();
        for i in (0..4).rev() {
            for j in 0..5 {
                if let Some(line) = change(i, j, format!("{}, {}, {}", j as f64 - 2.0, i, 10 * i + j)) {
                    text += &(line + "\r\n");
                }
            }
        }
        text
    }

    #[test]
    fn reads_a_full_grid_in_any_order() {
        let grid = parse(&table(|_, _, line| Some(line))).unwrap();
        assert_eq!(grid.w_mm, [0.0, 1.0, 2.0, 3.0]);
        assert_eq!(grid.z_mm, [-2.0, -1.0, 0.0, 1.0, 2.0]);
        assert_eq!(grid.f_um[3][1], 31.0);
    }

    #[test]
    fn scattered_points_need_no_grid() {
        let rows = parse_rows("w_mm,z_mm,f_um\n1,2,3\n4,5,6\n").unwrap();
        assert_eq!(rows.iter().map(|r| r.0).collect::<Vec<_>>(), [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]);
    }

    #[test]
    fn refuses_what_is_no_grid() {
        let missing = table(|i, j, line| (i != 1 || j != 2).then_some(line));
        let twice = table(|i, j, line| Some(if (i, j) == (1, 2) { "1, 1, 0".into() } else { line }));
        let nan = table(|i, j, line| Some(if (i, j) == (1, 2) { "0, 1, nan".into() } else { line }));
        let text = table(|i, j, line| Some(if (i, j) == (1, 2) { "0, 1, x".into() } else { line }));
        let short = table(|i, j, line| Some(if (i, j) == (1, 2) { "0, 1".into() } else { line }));
        let small = table(|i, _, line| (i < 3).then_some(line));
        let cases = [
            (missing.as_str(), "invalid-table"),
            (&twice, "invalid-table"),
            (&nan, "invalid-number"),
            (&text, "invalid-number"),
            (&short, "invalid-table"),
            (&small, "invalid-table"),
            ("", "invalid-table"),
            ("w_mm,z_mm\n", "invalid-table"),
            ("w_mm,z_mm,f_um,x\n", "invalid-table"),
            ("w_mm,z_mm,f_um,f_um\n", "invalid-table"),
            ("w_mm,z_mm,f_um\n", "invalid-table"),
        ];
        for (text, code) in cases {
            let finding = parse(text).unwrap_err();
            assert_eq!(finding.code, code, "{text}: {finding}");
        }
    }
}
