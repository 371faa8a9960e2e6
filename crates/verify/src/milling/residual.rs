//! Block `residual` of a case: what stays between two rows, by curvatures and by the referee's rays.

use super::super::expected::Expected;
use super::super::given::{Checked, MOST, check_items, count, number, tolerance};
use super::super::ledger::Ledger;
use super::case::{MilledCase, located};
use super::referee::{extremes, left_um, rays, row_paths};
use foundation::numerics::equidistant;
use milling::{ColumnPlane, FlankGrid, GridPlace, LocalContact, RowSpacing, row_distance};

/// Compares predictions and rays of some gaps between rows.
pub(super) fn residual(case: &MilledCase, expected: &mut Expected<'_>, ledger: &mut Ledger) -> Checked {
    let half = number(expected, "u_half_span", ledger)?;
    let tilt = number(expected, "tilt_mu_rad", ledger)?;
    let columns = count(expected, "columns", 3..=MOST)?;
    let rows = count(expected, "rows", 2..=MOST)?;
    let across = count(expected, "rays_across", 2..=MOST)?;
    let along = count(expected, "rays_along", 2..=MOST)?;
    let relative = tolerance(expected, "tolerance_prediction_rel", ledger);
    let um = tolerance(expected, "tolerance_measured_um", ledger);
    let [from, to] = case.range()?;
    let middle = 0.5 * (from + to);
    let at = equidistant([middle - half, middle + half], columns);
    let grid = FlankGrid::build(&case.flank, &*case.lead, &at, rows, RowSpacing::Arc)?;
    let paths = row_paths(&grid, &case.cutter, |_| case.contact_height, tilt)?;
    let m = columns / 2;
    let place = |row: usize, column: usize| &grid.columns[column].places[row];
    check_items(expected, "result", ledger, |gap, ledger| {
        let row = count(gap, "row", 0..=rows as u64 - 2)?;
        let (low, high) = (place(row, m), place(row + 1, m));
        let lead = grid.columns[m].lead;
        let section =
            ColumnPlane::new(&case.flank, lead).section(0.5 * (low.height + high.height), low.length)?;
        let between = GridPlace { jet: section.jet, ..*low };
        let location = located(&between, &lead, &case.cutter, case.contact_height, tilt)?;
        let local = LocalContact::new(&section.jet, &location, case.cutter.shape());
        let feed = section.jet.by_length;
        // The direction of the rows between both is taken at the length of the lower one.
        let row_feed = case.flank.surface.jet(section.height, low.length).by_length;
        let distance = row_distance(&row_feed, &(high.jet.point - low.jet.point));
        let block = (place(row, m + 1).jet.point - low.jet.point).norm();
        let curvatures = [local.flank.m11, local.flank.m12, local.flank.m22];
        gap.list_relative_to_largest("K_per_mm", &curvatures, relative, ledger);
        let (scallop, chord) = (1e3 * local.scallop(&feed, distance), 1e3 * local.chord(&feed, block));
        let mut share = |key: &str, actual: f64, size: f64| {
            gap.number(key, actual, relative * size.abs(), ledger);
        };
        let effective = local.effective_curvature(&feed);
        share("kappa_eff_per_mm", effective, effective);
        // The eigenvalue and the chord may be nothing; what they are laid beside is not.
        share("gouge_eig_per_mm", local.least_opening(), effective);
        share("row_distance_mm", distance, distance);
        share("block_length_mm", block, block);
        share("scallop_um", scallop, scallop);
        share("chord_um", chord, scallop.abs() + chord.abs());
        let reach = 0.25 * (place(row, m + 1).length - place(row, m - 1).length);
        let lengths = equidistant([low.length - reach, low.length + reach], along);
        let heights = equidistant([low.height, high.height], across);
        let [least, greatest] = extremes(&left_um(&case.cutter, &paths, &rays(case, &heights, &lengths))?);
        gap.numbers(&[("measured_max_um", greatest), ("measured_min_um", least)], um, ledger);
        Ok(())
    })
}
