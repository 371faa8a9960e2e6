//! Blocks `orientation_comparison` and `shear_scan`: how smoothly the rotary axes run along a row with the axis in the column plane,
//! along parameter lines, and along lines that irregular patches have sheared (`docs/mathematics/milling.md#positions-of-five-axes`).

use super::super::expected::Expected;
use super::super::given::{
    Checked, MOST, check_block, check_items, count, number, requires, text, tolerance,
};
use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::case::MilledCase;
use super::chain::{Places, chain};
use super::rotary::degrees;
use flankwright::workflow::milling::{RotaryCourse, rotary_course};
use foundation::kinematics::Pose;
use milling::{AxisChoice, Orientation, OrientedRow, RowCutter};
use motion::milling::{MillingSetup, RowSmoothness};
use serde_json::Value;
use std::f64::consts::PI;

/// The row and the machine that a scan of shears does not name.
const SCANNED: (&str, f64, usize) = ("AC_table_table", 0.5, 121);

/// A row at a share of the height of a case.
fn row(case: &MilledCase, share: f64, points: usize) -> Checked<OrientedRow<'_>> {
    let cutter = RowCutter {
        cutter: &case.cutter,
        contact_height: case.contact_height,
        orientation: Orientation::default(),
    };
    Ok(OrientedRow::new(&case.flank, &*case.lead, cutter, case.height_at(share), points)?)
}

/// Largest second differences of both axes, deg/mm^2.
fn accelerations(figures: &RowSmoothness) -> [f64; 2] {
    figures.rotary.map(|change| change.second.to_degrees())
}

fn travels(figures: &RowSmoothness) -> [f64; 2] {
    figures.rotary.map(|change| change.travel.to_degrees())
}

/// Block `orientation_comparison`.
pub(crate) fn orientation_comparison(reference: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    check_block("orientation_comparison", block, ledger, |expected, ledger| {
        let [deg, relative] =
            ["tolerance_deg", "tolerance_rate_rel"].map(|key| tolerance(expected, key, ledger));
        check_items(expected, "items", ledger, |item, ledger| {
            let case = MilledCase::given(reference, item, ledger)?;
            let machine = chain(text(item, "chain", ledger)?, &Places::default())?;
            let turned = requires(item, "mount", &["as modelled", "turned over about x"], ledger)? == 1;
            let mount = if turned { Pose::rx(PI) } else { Pose::identity() };
            let setup = MillingSetup::new(&machine, mount, 0.0)?;
            let fraction = number(item, "row_fraction", ledger)?;
            let row = row(&case, fraction, count(item, "points", 3..=MOST)?)?;
            let sheared = row.sheared(number(item, "cad_shear_fraction", ledger)?);
            let rows = [
                ("column", row.in_columns().to_vec()),
                ("iso", row.with(AxisChoice::ParameterLines)?),
                ("cad", row.with(sheared)?),
            ];
            let Some(mut result) = item.object("result", ledger) else { return Ok(()) };
            for (key, places) in rows {
                let course = rotary_course(&setup, &places)?;
                let Some(mut object) = result.object(key, ledger) else { continue };
                figures(&mut object, &setup, &course, [deg, relative], ledger);
                object.finish(ledger);
            }
            result.finish(ledger);
            Ok(())
        })
    });
}

/// The figures of one row; rates that are nothing are held against the tolerance of angles over the length of the row.
fn figures(
    expected: &mut Expected<'_>,
    setup: &MillingSetup<'_>,
    RotaryCourse { figures, nodes, .. }: &RotaryCourse,
    [deg, relative]: [f64; 2],
    ledger: &mut Ledger,
) {
    let path = figures.path;
    let rates = figures.rotary.map(|change| change.rate.to_degrees());
    let reversals: usize = figures.rotary.iter().map(|change| change.reversals).sum();
    expected.list("travel_deg", &travels(figures), deg, ledger);
    let share = |nothing: f64| move |rate: f64| (relative * rate.abs()).max(nothing);
    expected.list_to("max_rate_deg_per_mm", &rates, share(deg / path), ledger);
    expected.list_to("max_acc_deg_per_mm2", &accelerations(figures), share(deg / (path * path)), ledger);
    expected.whole("reversals", reversals as i64, ledger);
    expected.number("path_mm", path, relative * path, ledger);
    expected.list("lean_min_max_deg", &figures.lean.map(f64::to_degrees), deg, ledger);
    for (key, at) in [("first_deg", nodes.first()), ("last_deg", nodes.last())] {
        if let Some(at) = at {
            expected.list(key, &degrees(setup, at), deg, ledger);
        }
    }
}

/// Block `shear_scan`.
pub(crate) fn shear_scan(reference: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    check_block("shear_scan", block, ledger, |expected, ledger| {
        let case = MilledCase::given(reference, expected, ledger)?;
        let deg = tolerance(expected, "tolerance_deg", ledger);
        let (name, fraction, points) = SCANNED;
        let machine = chain(name, &Places::default())?;
        let setup = MillingSetup::new(&machine, Pose::identity(), 0.0)?;
        let row = row(&case, fraction, points)?;
        check_items(expected, "items", ledger, |item, ledger| {
            let choice = row.sheared(number(item, "shear", ledger)?);
            let course = rotary_course(&setup, &row.with(choice)?)?;
            item.list("travel_deg", &travels(&course.figures), deg, ledger);
            item.list("max_acc_deg_per_mm2", &accelerations(&course.figures), deg, ledger);
            Ok(())
        })
    });
}
