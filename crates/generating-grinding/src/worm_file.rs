//! Points of a measured worm as a table: CSV with the columns flank, w_mm (length of roll on the worm), z_mm (along the worm) and um.

use foundation::geometry::{Flank, Sides};
use job::decimal_comma::with_points;
use job::table_rows::TableForm;
use job::{Diagnostic, JobError, Source};
use std::path::Path;

const FORM: TableForm<4> = TableForm {
    columns: ["flank", "w_mm", "z_mm", "um"],
    optional: None,
    row: "each measured point of the worm",
};
/// No worm is off by more than this, um.
const MOST_UM: f64 = 5000.0;
/// Most points.
const MOST_POINTS: usize = 20_000;

/// Length of roll, worm z and normal deviation from the unmodified flank of points on each flank, mm.
pub type WormPoints = Sides<Vec<[f64; 3]>>;

/// Reads the points of a worm.
///
/// # Errors
/// Those of [`Source::read`]; `invalid-table`, `unknown-value`, `invalid-number` with line, column and value.
pub fn read_measured_worm(path: &Path) -> Result<WormPoints, JobError> {
    parse_measured_worm(Source::read(path)?)
}

/// As [`read_measured_worm`], from a text.
///
/// # Errors
/// As [`read_measured_worm`].
pub fn parse_measured_worm(source: Source) -> Result<WormPoints, JobError> {
    points(source.text()).map_err(|finding| JobError::single(source, finding))
}

fn points(text: &str) -> Result<WormPoints, Diagnostic> {
    let mut found: WormPoints = Sides::both(Vec::new());
    let text = with_points(text);
    let rows = FORM.rows(&text)?;
    if rows.len() > MOST_POINTS {
        let finding = FORM.malformed(format!("the table has {} points", rows.len()));
        return Err(finding.value(rows.len()).way_out(format!("give up to {MOST_POINTS} points")));
    }
    for row in rows {
        let flank: Flank = row.flank(0)?;
        let within = |um: &f64| um.abs() <= MOST_UM;
        let um: f64 = row.parsed(3, &format!("um, from -{MOST_UM} to {MOST_UM}"), within)?;
        found[flank].push([row.length_of_roll(1)?, row.number(2)?, 1e-3 * um]);
    }
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_stand_on_their_flank_and_wrong_ones_are_told() {
        let read = |text: &str| parse_measured_worm(Source::new("worm.csv", text));
        let points = read("flank,w_mm,z_mm,um\nleft,50,-1,2\nright,51,1,-3.5\n").unwrap();
        assert_eq!((points.left, points.right), (vec![[50.0, -1.0, 2e-3]], vec![[51.0, 1.0, -3.5e-3]]));
        for (text, part) in [
            ("flank,w_mm,z_mm\nleft,50,1\n", "um"),
            ("flank,w_mm,z_mm,um\nabove,50,1,1\n", "left or right"),
            ("flank,w_mm,z_mm,um\nleft,-50,1,1\n", "length of roll"),
            ("flank,w_mm,z_mm,um\nleft,50,1,9e9\n", "5000"),
            ("flank,w_mm,z_mm,um\n", "no rows"),
        ] {
            let error = read(text).unwrap_err().to_string();
            assert!(error.contains(part), "{text}: {error}");
        }
    }
}
