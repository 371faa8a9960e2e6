//! Values over a flank as a table: CSV with the columns w_mm, z_mm and f_um or tolerance_um, on a full grid or
//! scattered; and rows of three numbers under other names. Reads and checks it; knows nothing of how values between
//! the points are found.

use std::ops::Range;
use std::path::Path;

use super::decimal_comma::with_points;
use super::diagnostic::{Diagnostic, Problem};
use super::job_error::JobError;
use super::source::Source;

/// What a table of three numbers a row holds.
#[derive(Clone, Copy)]
pub struct Layout {
    /// Names of the columns, of a grid over w and z their two and the value's.
    pub columns: [&'static str; 3],
    /// Fewest different w_mm and z_mm of a grid.
    pub least: [usize; 2],
    /// Most different w_mm.
    pub most_w: usize,
}

/// A flank: a cubic through its values needs four along each direction.
const FLANK: Layout = Layout { columns: ["w_mm", "z_mm", "f_um"], least: [4, 4], most_w: usize::MAX };

/// Helix traces: two or three, with a cubic along each.
const TRACES: Layout = Layout { columns: ["w_mm", "z_mm", "f_um"], least: [2, 4], most_w: 3 };

/// Tolerances: one value is one everywhere.
const TOLERANCES: Layout =
    Layout { columns: ["w_mm", "z_mm", "tolerance_um"], least: [1, 1], most_w: usize::MAX };

impl Layout {
    /// Name of the third column.
    fn value(self) -> &'static str {
        self.columns[2]
    }

    /// A table that is not of this layout.
    pub fn malformed(self, message: impl Into<Box<str>>) -> Diagnostic {
        Diagnostic::new(Problem::InvalidTable, message)
            .allowed(format!("the columns {}, one row for each point of the grid", self.columns.join(",")))
    }
}

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

/// How the rows of a table lie over w and z.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TableForm {
    /// Each pair of the different w and z once.
    Grid,
    /// Anything else.
    Scattered {
        /// Different pairs of w and z.
        points: usize,
        /// Different values of w and z.
        places: [usize; 2],
    },
}

/// Reads the table; rows in any order, each point of the grid once. Lines that begin with `#` are comments.
///
/// # Errors
/// Those of [`Source::read`]; `invalid-table`, `invalid-number` with line and value.
pub fn read_grid_target(path: &Path) -> Result<GridTarget, JobError> {
    parse_grid_target(Source::read(path)?)
}

/// As [`read_grid_target`], from a text.
///
/// # Errors
/// As [`read_grid_target`].
pub fn parse_grid_target(source: Source) -> Result<GridTarget, JobError> {
    parse_grid(source, FLANK)
}

/// Reads helix traces: the same columns, two or three values of w_mm.
///
/// # Errors
/// As [`read_grid_target`].
pub fn read_traces(path: &Path) -> Result<GridTarget, JobError> {
    parse_traces(Source::read(path)?)
}

/// As [`read_traces`], from a text.
///
/// # Errors
/// As [`read_grid_target`].
pub fn parse_traces(source: Source) -> Result<GridTarget, JobError> {
    parse_grid(source, TRACES)
}

/// Reads tolerances: columns w_mm, z_mm, tolerance_um on a grid of any size, each tolerance above 0. They are handed
/// out as `f_um`.
///
/// # Errors
/// As [`read_grid_target`]; `invalid-number` for a tolerance that is not above 0.
pub fn read_tolerances(path: &Path) -> Result<GridTarget, JobError> {
    parse_tolerances(Source::read(path)?)
}

/// As [`read_tolerances`], from a text.
///
/// # Errors
/// As [`read_tolerances`].
pub fn parse_tolerances(source: Source) -> Result<GridTarget, JobError> {
    parse_grid(source, TOLERANCES)
}

/// Reads the same table as scattered points `[w_mm, z_mm, f_um]` in the order of the file.
///
/// # Errors
/// Those of [`Source::read`]; `invalid-table`, `invalid-number` with line and value.
pub fn read_points(path: &Path) -> Result<Vec<[f64; 3]>, JobError> {
    parse_points(Source::read(path)?)
}

/// As [`read_points`], from a text.
///
/// # Errors
/// As [`read_points`].
pub fn parse_points(source: Source) -> Result<Vec<[f64; 3]>, JobError> {
    let rows = parse_rows(source.text(), FLANK).map_err(|finding| JobError::single(source, finding))?;
    Ok(rows.into_iter().map(|(row, _)| row).collect())
}

/// Whether the table of a flank is a grid. As many rows as a grid of its places would have make it one, so that a row
/// that stands twice is reported when the grid is read.
///
/// # Errors
/// As [`read_points`].
pub fn table_form(path: &Path) -> Result<TableForm, JobError> {
    let source = Source::read(path)?;
    let rows = parse_rows(source.text(), FLANK).map_err(|finding| JobError::single(source, finding))?;
    Ok(form(&rows))
}

fn form(rows: &[Row]) -> TableForm {
    let places = [0, 1].map(|index| different(rows, index).len());
    let enough = places[0] >= FLANK.least[0] && places[1] >= FLANK.least[1];
    if enough && places[0] * places[1] == rows.len() {
        TableForm::Grid
    } else {
        let mut points: Vec<[f64; 2]> = rows.iter().map(|([w, z, _], _)| [*w, *z]).collect();
        points.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
        points.dedup();
        TableForm::Scattered { points: points.len(), places }
    }
}

fn parse_grid(source: Source, layout: Layout) -> Result<GridTarget, JobError> {
    parse(source.text(), layout).map_err(|finding| JobError::single(source, finding))
}

fn parse(text: &str, layout: Layout) -> Result<GridTarget, Diagnostic> {
    let rows = parse_rows(text, layout)?;
    if layout.value() == TOLERANCES.value()
        && let Some((row, span)) = rows.iter().find(|(row, _)| row[2] <= 0.0)
    {
        return Err(Diagnostic::new(
            Problem::InvalidNumber,
            format!("the tolerance at w = {} mm, z = {} mm is not above 0", row[0], row[1]),
        )
        .field(layout.value())
        .value(row[2])
        .allowed("> 0")
        .way_out("give the largest deviation allowed there in micrometres")
        .span(Some(span.clone())));
    }
    assemble(rows, layout)
}

/// A row of the table with its place in the text.
pub type Row = ([f64; 3], Range<usize>);

/// All rows of a table in the order of the text.
pub fn parse_rows(text: &str, layout: Layout) -> Result<Vec<Row>, Diagnostic> {
    let mut rows: Vec<Row> = Vec::new();
    let mut header = None;
    let mut offset = 0;
    for line in with_points(text).split_inclusive('\n') {
        let start = offset;
        offset += line.len();
        let line = line.trim_end();
        let span = start..start + line.len();
        if line.trim().is_empty() || line.starts_with('#') {
            continue;
        }
        match header {
            None => header = Some(columns(line, span, layout)?),
            Some(order) => rows.push((values(line, order, &span, layout)?, span)),
        }
    }
    if header.is_none() {
        return Err(layout
            .malformed("the table is empty")
            .way_out(format!("begin it with the line `{}`", layout.columns.join(","))));
    }
    Ok(rows)
}

/// Positions of the three columns.
fn columns(line: &str, span: Range<usize>, layout: Layout) -> Result<[usize; 3], Diagnostic> {
    let titles: Vec<&str> = line.split(',').map(str::trim).collect();
    let mut order = [0; 3];
    for (place, column) in order.iter_mut().zip(layout.columns) {
        *place = titles.iter().position(|t| *t == column).ok_or_else(|| {
            layout
                .malformed(format!("the table has no column `{column}`"))
                .field(column)
                .value(line.chars().take(60).collect::<String>())
                .way_out(format!("begin the table with the line `{}`", layout.columns.join(",")))
                .span(Some(span.clone()))
        })?;
    }
    if let Some(unknown) = titles.iter().find(|t| !layout.columns.contains(*t)) {
        let message = format!("the column `{}` is not known", unknown.chars().take(60).collect::<String>());
        return Err(layout.malformed(message).way_out("remove the column").span(Some(span)));
    }
    if titles.len() != layout.columns.len() {
        return Err(layout
            .malformed("a column stands twice")
            .way_out("remove one of the two")
            .span(Some(span)));
    }
    Ok(order)
}

fn values(
    line: &str,
    order: [usize; 3],
    span: &Range<usize>,
    layout: Layout,
) -> Result<[f64; 3], Diagnostic> {
    let cells: Vec<&str> = line.split(',').map(str::trim).collect();
    if cells.len() != order.len() {
        return Err(layout
            .malformed(format!("a row of {} values", cells.len()))
            .way_out("give three values with a decimal point, separated by commas; or with a decimal comma, all separated by semicolons, the titles too")
            .span(Some(span.clone())));
    }
    let mut row = [0.0; 3];
    for ((value, column), place) in row.iter_mut().zip(layout.columns).zip(order) {
        let cell = cells[place];
        // Adding zero makes one place of 0 and -0.
        *value = cell.parse().ok().map(|v: f64| v + 0.0).filter(|v| v.is_finite()).ok_or_else(|| {
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

/// Values of a column, ascending, each once.
fn different(rows: &[Row], index: usize) -> Vec<f64> {
    let mut values: Vec<f64> = rows.iter().map(|(row, _)| row[index]).collect();
    values.sort_by(f64::total_cmp);
    values.dedup();
    values
}

fn assemble(rows: Vec<Row>, layout: Layout) -> Result<GridTarget, Diagnostic> {
    let (w_mm, z_mm) = (different(&rows, 0), different(&rows, 1));
    if w_mm.len() > layout.most_w {
        return Err(layout
            .malformed(format!("{} different values of `w_mm`", w_mm.len()))
            .field("w_mm")
            .value(w_mm.len())
            .allowed(format!("{} to {} different values of `w_mm`", layout.least[0], layout.most_w))
            .way_out("give fewer traces, or use the kind \"grid\""));
    }
    for ((column, values), least) in [("w_mm", &w_mm), ("z_mm", &z_mm)].into_iter().zip(layout.least) {
        if values.len() < least {
            return Err(layout
                .malformed(format!("the grid has {} different values of `{column}`", values.len()))
                .field(column)
                .value(values.len())
                .allowed(format!("at least {least} different values of `{column}`"))
                .way_out("give a finer grid"));
        }
    }
    // Beyond the number of rows a grid cannot be full; testing first keeps a scattered table from taking memory.
    if w_mm.len() * z_mm.len() != rows.len() {
        return Err(layout.malformed(format!(
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
            return Err(layout
                .malformed(format!("the point w = {}, z = {} stands twice", row[0], row[1]))
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

    #[test]
    fn zero_is_one_place_whatever_its_sign() {
        let read = |text: &str| parse_grid_target(Source::new("grid.csv", text));
        let rows = |zero: &str| -> String {
            let of = |w: &str| (0..4).map(|z| format!("{w},{z},1\n")).collect::<String>();
            format!(
                "w_mm,z_mm,f_um\n-0,0,1\n-0,1,1\n{zero},2,1\n{zero},3,1\n{}{}{}",
                of("1"),
                of("2"),
                of("3")
            )
        };
        assert_eq!(read(&rows("0")).unwrap().w_mm, [0.0, 1.0, 2.0, 3.0]);
        assert_eq!(read(&rows("0")).unwrap(), read(&rows("-0")).unwrap());
    }

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
        let grid = parse(&table(|_, _, line| Some(line)), FLANK).unwrap();
        assert_eq!(grid.w_mm, [0.0, 1.0, 2.0, 3.0]);
        assert_eq!(grid.z_mm, [-2.0, -1.0, 0.0, 1.0, 2.0]);
        assert_eq!(grid.f_um[3][1], 31.0);
    }

    #[test]
    fn scattered_points_need_no_grid() {
        let rows = parse_rows("w_mm,z_mm,f_um\n1,2,3\n4,5,6\n", FLANK).unwrap();
        assert_eq!(rows.iter().map(|r| r.0).collect::<Vec<_>>(), [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]);
    }

    #[test]
    fn traces_and_tolerances_have_their_own_sizes() {
        let rows = |count: u32| {
            (0..count).flat_map(|i| (0..4).map(move |j| format!("{i},{j},{}\n", i + 1))).collect::<String>()
        };
        let text = |value: &str, count| format!("w_mm,z_mm,{value}\n{}", rows(count));
        for (layout, counts) in [(FLANK, 4..=9), (TRACES, 2..=3), (TOLERANCES, 1..=9)] {
            for count in 1..=9 {
                let found = parse(&text(layout.value(), count), layout);
                assert_eq!(found.is_ok(), counts.contains(&count), "{} {count}: {found:?}", layout.value());
            }
        }
        assert_eq!(parse(&text("tolerance_um", 2), TOLERANCES).unwrap().f_um, [[1.0; 4], [2.0; 4]]);
        assert!(parse(&text("f_um", 2), TOLERANCES).unwrap_err().message.contains("tolerance_um"));
        for bad in ["0", "-1", "nan"] {
            let finding =
                parse(&format!("w_mm,z_mm,tolerance_um\n1,2,3\n1,3,{bad}\n"), TOLERANCES).unwrap_err();
            assert_eq!((finding.code, finding.field.as_deref()), ("invalid-number", Some("tolerance_um")));
            assert!(finding.span.is_some(), "{finding}");
        }
    }

    #[test]
    fn grids_and_clouds_are_told_apart() {
        let form = |text: &str| form(&parse_rows(text, FLANK).unwrap());
        assert_eq!(form(&table(|_, _, line| Some(line))), TableForm::Grid);
        let hole = table(|i, j, line| (i != 1 || j != 2).then_some(line));
        assert_eq!(form(&hole), TableForm::Scattered { points: 19, places: [4, 5] });
        let small = table(|i, _, line| (i < 3).then_some(line));
        assert_eq!(form(&small), TableForm::Scattered { points: 15, places: [3, 5] });
        let twice = table(|i, j, line| Some(if (i, j) == (1, 2) { "1, 1, 0".into() } else { line }));
        assert_eq!(form(&twice), TableForm::Grid);
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
            let finding = parse(text, FLANK).unwrap_err();
            assert_eq!(finding.code, code, "{text}: {finding}");
        }
    }
}
