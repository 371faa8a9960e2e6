//! Blocks `orientation_comparison` and `shear_scan`: how smoothly the rotary axes run along a row with the axis in the column plane,
//! along parameter lines, and along lines that irregular patches have sheared (spec 50 section 14).

use super::super::expected::Expected;
use super::super::given::{
    Checked, MOST, check_block, check_items, count, number, requires, text, tolerance,
};
use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::case::{MilledCase, located};
use super::chain::{Places, chain};
use super::rotary::degrees;
use crate::geometry::SurfaceJet;
use crate::kinematics::{Direction, Point, Pose};
use crate::machine::Positions;
use crate::motion::milling::{CutterPlace, MillingSetup, PoleStrategy, RowSmoothness, choose, smoothness};
use crate::numerics::{equidistant, extremes};
use crate::process::milling::{AxisChoice, Column, ColumnPlane, other_axis};
use nalgebra::Vector3;
use serde_json::Value;
use std::f64::consts::PI;

/// The row and the machine that a scan of shears does not name.
const SCANNED: (&str, f64, usize) = ("AC_table_table", 0.5, 121);

/// A row of constant height.
struct Row<'c> {
    case: &'c MilledCase,
    height: f64,
    points: usize,
}

/// A course of the rotary axes along a row.
struct Course {
    figures: RowSmoothness,
    /// C and tilt at the first and at the last place, deg.
    ends: [[f64; 2]; 2],
}

/// A contact with an axis and the direction in which the row goes on.
struct Contact {
    place: CutterPlace,
    feed: Vector3<f64>,
}

impl Contact {
    fn new(jet: &SurfaceJet, axis: Vector3<f64>, tip: Vector3<f64>) -> Self {
        let place = CutterPlace {
            contact: Point::from_vector(jet.point),
            tip: Point::from_vector(tip),
            axis: Direction::from_vector(axis),
        };
        Self { place, feed: jet.by_length.normalize() }
    }
}

impl Row<'_> {
    /// With the axis in the column planes, equal steps of the lead parameter over its range; the lengths at both ends.
    fn column(&self) -> Checked<(Vec<Contact>, [f64; 2])> {
        let mut contacts = Vec::new();
        let mut lengths = Vec::new();
        for u in self.case.lead_parameters(self.points)? {
            let plane = ColumnPlane::new(&self.case.flank, self.case.lead.at(u)?);
            let column = Column::at_heights(&self.case.flank, &plane, &[self.height])?;
            let at = &column.places[0];
            let location = located(at, &column.lead, &self.case.cutter, self.case.contact_height, 0.0)?;
            lengths.push(at.length);
            contacts.push(Contact::new(&at.jet, location.axis, location.tip));
        }
        Ok((contacts, [lengths[0], lengths[self.points - 1]]))
    }

    /// With another choice of the axis, equal steps of the length parameter between two lengths.
    fn other(&self, choice: AxisChoice, ends: [f64; 2]) -> Checked<Vec<Contact>> {
        let mut contacts = Vec::new();
        for (k, length) in equidistant(ends, self.points).into_iter().enumerate() {
            let jet = self.case.flank.surface.jet(self.height, length);
            let along = k as f64 / (self.points - 1) as f64;
            // The lead curve says where the shank stands; that far, both parameters are one.
            let axis = other_axis(choice, &jet, &self.case.lead.at(length)?, along);
            // Only the axis matters here.
            contacts.push(Contact::new(&jet, axis, jet.point));
        }
        Ok(contacts)
    }

    fn sheared(&self, shear: f64) -> AxisChoice {
        let ([from, to], [root, tip]) = (self.case.flank.face, self.case.heights());
        AxisChoice::ShearedLines { shear, face: to - from, height: tip - root }
    }
}

/// The rotary axes along a row.
fn course(setup: &MillingSetup<'_>, contacts: &[Contact]) -> Checked<Course> {
    let places: Vec<CutterPlace> = contacts.iter().map(|contact| contact.place).collect();
    let course = choose(setup, &places, &Positions::default(), PoleStrategy::Slow)?;
    let mut figures = smoothness(setup, &course.places, &course.nodes);
    // The surface knows the feed direction better than places beside each other do.
    let lean = |contact: &Contact| contact.feed.dot(&contact.place.axis.xyz).asin();
    figures.lean = extremes(contacts.iter().map(lean));
    let (Some(first), Some(last)) = (course.nodes.first(), course.nodes.last()) else {
        return Err("the row has no places".into());
    };
    Ok(Course { figures, ends: [first, last].map(|at| degrees(setup, at)) })
}

/// Largest second differences of both axes, deg/mm^2.
fn accelerations(figures: &RowSmoothness) -> [f64; 2] {
    figures.rotary.map(|change| change.second.to_degrees())
}

fn travels(figures: &RowSmoothness) -> [f64; 2] {
    figures.rotary.map(|change| change.travel.to_degrees())
}

/// Block `orientation_comparison`.
pub(in super::super::super) fn orientation_comparison(
    reference: &Reference<'_>,
    block: &Value,
    ledger: &mut Ledger,
) {
    check_block("orientation_comparison", block, ledger, |expected, ledger| {
        let [deg, relative] =
            ["tolerance_deg", "tolerance_rate_rel"].map(|key| tolerance(expected, key, ledger));
        check_items(expected, "items", ledger, |item, ledger| {
            let case = MilledCase::given(reference, item, ledger)?;
            let machine = chain(text(item, "chain", ledger)?, &Places::default())?;
            let turned = requires(item, "mount", &["as modelled", "turned over about x"], ledger)? == 1;
            let mount = if turned { Pose::rx(PI) } else { Pose::identity() };
            let setup = MillingSetup::new(&machine, mount, 0.0)?;
            let height = case.height_at(number(item, "row_fraction", ledger)?);
            let row = Row { case: &case, height, points: count(item, "points", 3..=MOST)? };
            let sheared = row.sheared(number(item, "cad_shear_fraction", ledger)?);
            let (own, ends) = row.column()?;
            let rows = [
                ("column", own),
                ("iso", row.other(AxisChoice::ParameterLines, ends)?),
                ("cad", row.other(sheared, ends)?),
            ];
            let Some(mut result) = item.object("result", ledger) else { return Ok(()) };
            for (key, contacts) in rows {
                let course = course(&setup, &contacts)?;
                let Some(mut object) = result.object(key, ledger) else { continue };
                figures(&mut object, &course, [deg, relative], ledger);
                object.finish(ledger);
            }
            result.finish(ledger);
            Ok(())
        })
    });
}

/// The figures of one row; rates that are nothing are held against the tolerance of angles over the length of the row.
fn figures(expected: &mut Expected<'_>, course: &Course, [deg, relative]: [f64; 2], ledger: &mut Ledger) {
    let Course { figures, ends: [first, last] } = course;
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
    expected.list("first_deg", first, deg, ledger);
    expected.list("last_deg", last, deg, ledger);
}

/// Block `shear_scan`.
pub(in super::super::super) fn shear_scan(reference: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    check_block("shear_scan", block, ledger, |expected, ledger| {
        let case = MilledCase::given(reference, expected, ledger)?;
        let deg = tolerance(expected, "tolerance_deg", ledger);
        let (name, fraction, points) = SCANNED;
        let machine = chain(name, &Places::default())?;
        let setup = MillingSetup::new(&machine, Pose::identity(), 0.0)?;
        let row = Row { case: &case, height: case.height_at(fraction), points };
        let (_, ends) = row.column()?;
        check_items(expected, "items", ledger, |item, ledger| {
            let choice = row.sheared(number(item, "shear", ledger)?);
            let course = course(&setup, &row.other(choice, ends)?)?;
            item.list("travel_deg", &travels(&course.figures), deg, ledger);
            item.list("max_acc_deg_per_mm2", &accelerations(&course.figures), deg, ledger);
            Ok(())
        })
    });
}
