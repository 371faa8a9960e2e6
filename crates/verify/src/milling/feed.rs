//! Blocks `feed` and `screw_row`: times of the blocks of a row, and what straight blocks of the axes do without RTCP.

use super::super::given::{
    Checked, check_block, compare_pairs, compare_texts, compare_vectors, requires, tolerance,
};
use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::rotary::degrees;
use super::row::{RowInput, course};
use machine::Positions;
use motion::milling::{BlockTime, block_times, straight_error, straight_runs};
use nalgebra::Vector3;
use serde_json::Value;

/// Places from column to column at which the screw row is looked at.
const BETWEEN: usize = 4;

/// Block `feed`.
pub(crate) fn feed(reference: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    check_block("feed", block, ledger, |expected, ledger| {
        expected.informative(&RowInput::KEYS);
        let [mm, relative] = ["tolerance_mm", "tolerance_rel"].map(|key| tolerance(expected, key, ledger));
        let row = RowInput::of(reference)?;
        let machine = row.machine()?;
        let (setup, course) = course(&machine, &row.places(reference, 1)?)?;
        let angles: Vec<[f64; 2]> = course.nodes.iter().map(|at| degrees(&setup, at)).collect();
        // The file states no tolerance of angles; 1 deg moves by 1 mm what stands 57 mm beside the axis.
        compare_pairs(expected, "CA_deg", &angles, mm, ledger);
        let slides = |at: &Positions| Vector3::from(setup.axes().linear.map(|axis| at[axis]));
        let slides: Vec<Vector3<f64>> = course.nodes.iter().map(slides).collect();
        compare_vectors(expected, "XYZ_mm", &slides, mm, ledger);
        let times = block_times(&setup, &course.places, &course.nodes, row.contact_feed_mm_per_min)?;
        let share = |value: f64| relative * value.abs();
        let of = |value: fn(&BlockTime) -> f64| -> Vec<f64> { times.iter().map(value).collect() };
        expected.list_to("block_time_s", &of(|time| time.seconds), share, ledger);
        expected.list_to("tip_feed_mm_per_min", &of(|time| time.tip_feed), share, ledger);
        expected.list_to("g93_per_min", &of(|time| time.inverse_time), share, ledger);
        let limits: Vec<&str> = times.iter().map(|time| time.limit.name()).collect();
        compare_texts(expected, "limited_by", &limits, ledger);
        let nodes = course.places.iter().zip(&course.nodes).collect::<Vec<_>>();
        let errors = nodes.windows(2).map(|ends| Ok(straight_error(&setup, [ends[0], ends[1]])?.middle));
        let errors = errors.collect::<Checked<Vec<_>>>()?;
        compare_vectors(expected, "tip_error_without_rtcp_mid_block_mm", &errors, mm, ledger);
        Ok(())
    });
}

/// Block `screw_row`.
pub(crate) fn screw_row(reference: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    check_block("screw_row", block, ledger, |expected, ledger| {
        requires(expected, "of", &["feed"], ledger)?;
        let mm = tolerance(expected, "tolerance_mm", ledger);
        let row = RowInput::of(reference)?;
        let machine = row.machine()?;
        let (setup, course) = course(&machine, &row.places(reference, BETWEEN)?)?;
        // One block whatever it misses: the deviation is what is asked for.
        let runs = straight_runs(&setup, &course, f64::MAX, f64::MAX)?;
        let [run] = runs[..] else { return Err("the row is not one block".into()) };
        expected.number("max_tip_deviation_single_block_rtcp_off_mm", run.tip, mm, ledger);
        Ok(())
    });
}
