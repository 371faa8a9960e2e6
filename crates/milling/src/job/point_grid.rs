//! Points of a blade or of a flank as a table: CSV with the columns x_mm, y_mm, z_mm, row after row from the hub or root to the tip. Reads
//! and checks it; knows no surface.

use std::path::Path;

use super::{BladePoints, FlankPoints};
use job::{Diagnostic, JobError, Layout, Problem, Row, Source, parse_rows};

/// Points: the same number in every row.
#[derive(Clone, Debug, PartialEq)]
pub struct PointGrid {
    /// Points in mm, `[row][column]`; row 0 at the hub or root.
    pub points: Vec<Vec<[f64; 3]>>,
}

const POINTS: Layout = Layout { columns: ["x_mm", "y_mm", "z_mm"], least: [4, 4], most_w: usize::MAX };

/// Reads the table of a blade, which `path` names; `wanted` has the numbers of rows and columns. Lines that begin with `#` are comments.
///
/// # Errors
/// Those of [`Source::read`]; `invalid-table`, `invalid-number` with line and value.
pub fn read_point_grid(path: &Path, wanted: &BladePoints) -> Result<PointGrid, JobError> {
    parse_point_grid(Source::read(path)?, wanted)
}

/// Reads the points of a flank; `table` is that of its rows and columns in the job.
///
/// # Errors
/// As [`read_point_grid`].
pub fn read_flank_points(path: &Path, wanted: &FlankPoints, table: &str) -> Result<PointGrid, JobError> {
    let source = Source::read(path)?;
    parse(source.text(), [wanted.rows, wanted.columns], table)
        .map_err(|finding| JobError::single(source, finding))
}

/// As [`read_point_grid`], from a text.
///
/// # Errors
/// As [`read_point_grid`].
pub fn parse_point_grid(source: Source, wanted: &BladePoints) -> Result<PointGrid, JobError> {
    parse(source.text(), [wanted.rows, wanted.columns], "blade.points")
        .map_err(|finding| JobError::single(source, finding))
}

fn parse(text: &str, [rows, columns]: [usize; 2], table: &str) -> Result<PointGrid, Diagnostic> {
    let read = parse_rows(text, POINTS)?;
    if read.len() != rows * columns {
        let message =
            format!("the table has {} points, the job asks for {rows} rows of {columns}", read.len());
        return Err(Diagnostic::new(Problem::InvalidTable, message)
            .field(format!("{table}.rows"))
            .value(format!("{} points", read.len()))
            .allowed(format!("{} points, row after row", rows * columns))
            .way_out("correct `rows` and `columns` of the job, or the table"));
    }
    let lines: Vec<&[Row]> = read.chunks(columns).collect();
    for (i, line) in lines.iter().enumerate() {
        for (j, (point, span)) in line.iter().enumerate() {
            let before = [j.checked_sub(1).map(|j| &line[j]), i.checked_sub(1).map(|i| &lines[i][j])];
            if before.into_iter().flatten().any(|(other, _)| other == point) {
                let message = format!("the point at row {i}, column {j} is the same as its neighbour");
                return Err(Diagnostic::new(Problem::InvalidTable, message)
                    .field("x_mm")
                    .value(format!("{}, {}, {}", point[0], point[1], point[2]))
                    .allowed("points that lie apart along rows and columns")
                    .way_out("correct the point, or the numbers of rows and columns in the job")
                    .span(Some(span.clone())));
            }
        }
    }
    Ok(PointGrid {
        points: lines.iter().map(|line| line.iter().map(|(point, _)| *point).collect()).collect(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(change: impl Fn(usize, usize) -> [usize; 2]) -> String {
        let point = |i: usize, j: usize| {
            let [i, j] = change(i, j);
            format!("{},{j}.5,{}\n", 40 + i, 2 * j)
        };
        let points = (0..4).flat_map(|i| (0..5).map(move |j| (i, j))).map(|(i, j)| point(i, j));
        "# blade\nx_mm,y_mm,z_mm\n".to_owned() + &points.collect::<String>()
    }

    #[test]
    fn rows_follow_each_other() {
        let grid = parse(&table(|i, j| [i, j]), [4, 5], "blade.points").unwrap();
        assert_eq!((grid.points.len(), grid.points[3].len()), (4, 5));
        assert_eq!(grid.points[3][1], [43.0, 1.5, 2.0]);
    }

    #[test]
    fn wrong_tables_are_told_with_their_place() {
        let sound = table(|i, j| [i, j]);
        let finding = parse(&sound, [5, 5], "blade.points").unwrap_err();
        assert_eq!((finding.code, finding.field.as_deref()), ("invalid-table", Some("blade.points.rows")));
        for twice in [table(|i, j| [i, j.max(1)]), table(|i, j| [i.max(1), j])] {
            let finding = parse(&twice, [4, 5], "blade.points").unwrap_err();
            assert_eq!(finding.code, "invalid-table");
            assert!(finding.span.is_some() && finding.way_out.is_some(), "{finding}");
        }
        let finding = parse(&sound.replace("41,2.5", "nan,2.5"), [4, 5], "blade.points").unwrap_err();
        assert_eq!((finding.code, finding.field.as_deref()), ("invalid-number", Some("x_mm")));
        let finding = parse(&sound.replace("z_mm", "w_mm"), [4, 5], "blade.points").unwrap_err();
        assert_eq!((finding.code, finding.field.as_deref()), ("invalid-table", Some("z_mm")));
    }
}
