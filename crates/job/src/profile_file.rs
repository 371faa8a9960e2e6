//! A measured profile as a table: CSV with the columns w_mm and f_um.

use std::path::Path;

use super::decimal_comma::with_points;
use super::diagnostic::Diagnostic;
use super::job_error::JobError;
use super::source::Source;
use super::table_rows::TableForm;

const FORM: TableForm<2> =
    TableForm { columns: ["w_mm", "f_um"], optional: None, row: "each point of the profile" };

/// Reads points `[w_mm, f_um]` in the order of the file; places without a value are left out.
///
/// # Errors
/// Those of [`Source::read`]; `invalid-table`, `invalid-number` with line and value.
pub fn read_profile(path: &Path) -> Result<Vec<[f64; 2]>, JobError> {
    parse_profile(Source::read(path)?)
}

/// As [`read_profile`], from a text.
///
/// # Errors
/// As [`read_profile`].
pub fn parse_profile(source: Source) -> Result<Vec<[f64; 2]>, JobError> {
    points(source.text()).map_err(|finding| JobError::single(source, finding))
}

fn points(text: &str) -> Result<Vec<[f64; 2]>, Diagnostic> {
    let text = with_points(text);
    let mut points = Vec::new();
    for row in FORM.rows(&text)? {
        let point = [row.length_of_roll(0)?, row.deviation(1)?];
        if !point[1].is_nan() {
            points.push(point);
        }
    }
    Ok(points)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_come_in_any_spelling_of_the_table() {
        let of = |text: &str| parse_profile(Source::new("profile.csv", text));
        let expected = vec![[10.0, 1.5], [12.0, -0.5]];
        assert_eq!(of("# as measured\nw_mm,f_um\n10,1.5\n11,\n12,-0.5\n").unwrap(), expected);
        assert_eq!(of("f_um;w_mm\n1,5;10\n-0,5;12\n").unwrap(), expected);
        for text in ["", "w_mm\n1\n", "w_mm,f_um\n-1,2\n", "w_mm,f_um\n1,x\n", "w_mm,f_um\n1,2,3\n"] {
            assert!(of(text).is_err(), "{text}");
        }
    }
}
