//! Block `grid_surface`: splines through points of a flank, against that flank.

use super::super::given::{
    MOST, check_block, check_items, check_object, counts, number, requires, text, tolerance,
};
use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::case::MilledCase;
use super::columns::row_law;
use super::near_foot::foot;
use foundation::geometry::{GridSurface, NormalSide, Surface};
use foundation::numerics::equidistant;
use milling::FlankGrid;
use nalgebra::Vector3;
use serde_json::Value;

/// Block `grid_surface`.
pub(crate) fn grid_surface(reference: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    check_block("grid_surface", block, ledger, |expected, ledger| {
        let um = tolerance(expected, "tolerance_um", ledger);
        check_items(expected, "items", ledger, |item, ledger| {
            let case = MilledCase::given(reference, item, ledger)?;
            let [rows, columns] = counts(item, "grid", 4..=MOST)?;
            let range = [number(item, "u_from_mm", ledger)?, number(item, "u_to_mm", ledger)?];
            let law = row_law(text(item, "row_law", ledger)?)?;
            let start = "a = a_root + p (a_tip - a_root), b = u_from + q (u_to - u_from)";
            requires(item, "start_of_projection", &[start], ledger)?;
            let samples = item.object("samples", ledger).ok_or("samples are missing")?;
            let (mut sampled, mut ends) = ([0, 0], [0.0; 2]);
            check_object(samples, ledger, |given, ledger| {
                let known = "p (rows, root..tip), q (columns) of the spline, 0..1, chord lengths";
                requires(given, "parameters", &[known], ledger)?;
                sampled = counts(given, "count", 2..=MOST)?;
                ends = [number(given, "first", ledger)?, number(given, "last", ledger)?];
                Ok(())
            });
            let at = equidistant(range, columns);
            let grid = FlankGrid::build(&case.flank, &*case.lead, &at, rows, law)?;
            let of_row = |row: usize| grid.columns.iter().map(|c| c.places[row].jet.point).collect();
            let points: Vec<Vec<Vector3<f64>>> = (0..rows).map(of_row).collect();
            let known = grid.columns[0].places[0].jet;
            let along = known.by_height.cross(&known.by_length).dot(&known.normal) > 0.0;
            // Rows and columns run as the parameters do, but for flanks whose root has the larger one.
            let along = along == (case.heights()[1] > case.heights()[0]);
            let side = if along { NormalSide::Along } else { NormalSide::Against };
            let spline = GridSurface::new(&points, side)?;
            let (mut error, mut angle) = (0.0_f64, 0.0_f64);
            for p in equidistant(ends, sampled[0]) {
                for q in equidistant(ends, sampled[1]) {
                    let jet = spline.jet(p, q);
                    let start = [case.height_at(p), range[0] + q * (range[1] - range[0])];
                    let (flank, off) = foot(&*case.flank.surface, &jet.point, start)?;
                    error = error.max(1e3 * off.abs());
                    let sine = jet.normal.cross(&flank.normal).norm();
                    angle = angle.max(sine.atan2(jet.normal.dot(&flank.normal)).to_degrees());
                }
            }
            item.number("max_normal_error_um", error, um, ledger);
            // No tolerance of angles is stated: a hundredth of the micrometres' number as degrees.
            item.number("max_normal_angle_deg", angle, 1e-2 * um, ledger);
            Ok(())
        })
    });
}
