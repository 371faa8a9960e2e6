//! Block `conventional_axis_parallel_beam`: what the usual way reports, and where it touches.

use super::super::expected::Expected;
use super::super::given::{Checked, check_object};
use super::super::ledger::Ledger;
use super::super::reference::{Reference, Tolerances};
use super::band::by_differences;
use super::example::SkivingExample;
use foundation::geometry::Sides;
use nalgebra::Vector3;
use serde_json::Value;
use skiving::measuring::{
    Barrier, Beam, EdgeErrors, RealTool, conventional_pose, conventional_reading, first_order_deviation,
};
use skiving::{MeasuringTrack, SkivingError, default_track_places};

/// Growth of the rounding that the files ask for, mm.
const GROWTH: f64 = 0.01;

/// Block `conventional_axis_parallel_beam`.
pub(crate) fn conventional(reference: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    let Some(examples) = block.as_object() else {
        return ledger.fail("conventional", "", block.clone(), "an object of lists is needed here".into());
    };
    for (name, list) in examples {
        let case = format!("conventional {name}");
        let example = SkivingExample::named(reference, name);
        for (k, item) in list.as_array().map_or(&[] as &[Value], Vec::as_slice).iter().enumerate() {
            let expected = Expected::new(&case, &format!("[{k}]"), item, ledger);
            check_object(expected, ledger, |expected, ledger| {
                let example = example.as_ref().map_err(ToString::to_string)?;
                check_item(&reference.tolerances(), example, expected, ledger)
            });
        }
    }
}

fn check_item(
    tolerances: &Tolerances<'_>,
    example: &SkivingExample,
    expected: &mut Expected<'_>,
    ledger: &mut Ledger,
) -> Checked {
    let flank = expected.given_flank(ledger).ok_or("flank is missing")?;
    let number =
        expected.take("track").and_then(Value::as_u64).ok_or("track: a whole number is needed here")?;
    let places = default_track_places();
    let place = places.get(usize::try_from(number)?).ok_or("track: there are five tracks")?;
    let edge = &example.edges[flank];
    let track = MeasuringTrack::new(edge, *place)?;
    let beam = Beam { direction: Vector3::z(), ..example.beam };
    let ideal = RealTool::ideal(example.teeth());
    let grown = EdgeErrors { growth: vec![GROWTH], ..EdgeErrors::default() };
    let grown = RealTool { edges: Sides::both(vec![grown; example.teeth()]), ..ideal.clone() };
    let reading = |tool: &RealTool| conventional_reading(edge, tool, &track, &beam, 0);
    let theta = tolerances.get("theta_deg");
    let on_rounding = match reading(&ideal) {
        Ok(found) => {
            let um = tolerances.get("conventional_um");
            let reported = reading(&grown)?.deviation - found.deviation;
            expected.number("ideal_tool_reported_um", 1e3 * found.deviation, um, ledger);
            expected.number("growth10um_reported_um", 1e3 * reported, um, ledger);
            let true_growth = first_order_deviation(edge, &grown, &track, 0);
            expected.number("growth10um_true_um", 1e3 * true_growth, um, ledger);
            true
        }
        Err(SkivingError::BodyTouched { .. }) => false,
        Err(error) => return Err(error.into()),
    };
    if let Some(value) = expected.take("touch_on_rounding") {
        ledger.equal(expected.case(), &expected.name("touch_on_rounding"), value.clone(), on_rounding.into());
    }
    let pose = conventional_pose(&track, &beam);
    let barrier = Barrier { beam: &beam, pose: &pose };
    let touch = barrier.anywhere(edge, &ideal, 0, beam.radius, [track.contact.w, pose.turn])?;
    let (w, angle) = by_differences(&barrier, edge, &ideal, [touch.w, touch.turn])?;
    for (key, angle) in [
        ("touch_theta_deg", angle),
        ("silhouette_theta_deg", angle),
        ("contact_theta_deg", track.section.contact_angle),
        ("theta_hi_deg", edge.section(w).range[1]),
    ] {
        expected.number(key, angle.to_degrees(), theta, ledger);
    }
    Ok(())
}
