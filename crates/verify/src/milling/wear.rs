//! Block `wear`: contact heights that root and opposite flank allow, and the load along the edge.

use super::super::given::{Checked, MOST, array, check_block, count, number, tolerance};
use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::case::MilledCase;
use super::cutter::of_shape;
use foundation::geometry::CutterShape;
use milling::{
    Bottom, FinishOptions, FinishedRow, FlankGrid, HeightRule, Kept, Obstacle, Orientation, Patch, RowLoad,
    RowSpacing, WearHistogram, finish,
};
use serde_json::Value;

/// Columns over the range.
const COLUMNS: usize = 9;

/// Block `wear`.
pub(crate) fn wear(reference: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    check_block("wear", block, ledger, |expected, ledger| {
        let case = MilledCase::given(reference, expected, ledger)?;
        let rows = count(expected, "rows", 2..=MOST)?;
        let fixed = number(expected, "h_fixed_mm", ledger)?;
        let ramp = HeightRule::Ramp(array(expected, "h_ramp_mm", ledger)?);
        let shape =
            CutterShape::end_mill(number(expected, "R_mm", ledger)?, number(expected, "rc_mm", ledger)?);
        let cap = number(expected, "h_cap_mm", ledger)?;
        let cutter = of_shape(shape, cap)?;
        // Limits are looked for up to the height that is asked for.
        let highest = HeightRule::Fixed(cap);
        let wanted = number(expected, "clearance_wanted_mm", ledger)?;
        let (bin, height) = (number(expected, "bin_mm", ledger)?, number(expected, "height_mm", ledger)?);
        if !(bin > 0.0 && height > 0.0 && height / bin <= MOST as f64) {
            return Err("bin_mm and height_mm: some bins are needed here".into());
        }
        let [limit, tight] =
            ["tolerance_h_limit_mm", "tolerance"].map(|key| tolerance(expected, key, ledger));
        let opposite = case.opposite.as_ref().ok_or("the case has no opposite flank")?;
        let [root, tip] = opposite.height_span();
        let patch = Patch {
            surface: &*opposite.surface,
            heights: [root.min(tip), root.max(tip)],
            lengths: opposite.face,
            turn: 0.0,
        };
        let opposite = Obstacle { name: "opposite flank", patch, wanted, between: true };
        let at = case.lead_parameters(COLUMNS)?;
        let grid = FlankGrid::build(&case.flank, &*case.lead, &at, rows, RowSpacing::Arc)?;
        let finished =
            |heights: &HeightRule, of_root: bool, of_opposite: bool| -> Checked<Vec<FinishedRow>> {
                let options = FinishOptions {
                    cutter: &cutter,
                    orientation: Orientation::default(),
                    tilt_at_tip: None,
                    heights,
                    bottom: of_root.then_some((Bottom::Level(0.0), wanted)),
                    kept: of_opposite.then_some(Kept::Surface(opposite)).into_iter().collect(),
                };
                Ok(finish(&grid, &options)?)
            };
        let limits = |rows: Vec<FinishedRow>| -> Vec<f64> {
            rows.iter().map(|row| row.window.map_or(f64::NAN, |window| window.greatest)).collect()
        };
        expected.list("h_limit_root_mm", &limits(finished(&highest, true, false)?), limit, ledger);
        expected.list("h_limit_opposite_mm", &limits(finished(&highest, false, true)?), limit, ledger);
        let used: Vec<f64> = finished(&ramp, true, true)?.iter().map(|row| row.contact_height).collect();
        expected.list("h_used_mm", &used, limit, ledger);
        let band = grid.along_columns().greatest_mean;
        let place = |row: usize, column: usize| grid.columns[column].places[row].jet.point;
        let length = |row: usize| -> f64 {
            (1..COLUMNS).map(|column| (place(row, column) - place(row, column - 1)).norm()).sum()
        };
        let lengths: Vec<f64> = (0..rows).map(length).collect();
        expected.number("band_mm", band, tight, ledger);
        expected.list("row_length_mm", &lengths, tight, ledger);
        let histogram = |height_of: &dyn Fn(usize) -> f64| {
            let load = |row: usize| RowLoad { height: height_of(row), band, length: lengths[row] };
            WearHistogram::new(&(0..rows).map(load).collect::<Vec<_>>(), height, bin)
        };
        let (same, spread) = (histogram(&|_| fixed), histogram(&|row| used[row]));
        expected.list("hist_fixed_m_per_mm", &same.load, tight, ledger);
        expected.list("hist_ramp_m_per_mm", &spread.load, tight, ledger);
        expected.number("peak_ratio", spread.peak() / same.peak(), tight, ledger);
        Ok(())
    });
}
