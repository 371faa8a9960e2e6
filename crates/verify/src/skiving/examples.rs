//! Block `examples`: every quantity that an example expects.

use super::super::expected::Expected;
use super::super::given::{Checked, check_object};
use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::edges::check_edges;
use super::example::{ExampleInput, SkivingExample};
use super::poses::check_poses;
use foundation::geometry::{EdgeRounding, Flank};
use serde::Deserialize;
use serde_json::Value;
use skiving::{MeasuringTrack, default_track_places, setting_sensitivity};

/// Block `examples`.
pub(crate) fn examples(reference: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    let Some(list) = block.as_object() else {
        return ledger.fail(
            "examples",
            "",
            block.clone(),
            "an object of named examples is needed here".into(),
        );
    };
    for (name, value) in list {
        let mut expected = Expected::new(name, "", value, ledger);
        expected.informative(&["input", "beam"]);
        check_object(expected, ledger, |expected, ledger| check_example(reference, value, expected, ledger));
    }
}

fn check_example(
    reference: &Reference<'_>,
    value: &Value,
    expected: &mut Expected<'_>,
    ledger: &mut Ledger,
) -> Checked {
    let example = SkivingExample::of(value)?;
    let input = ExampleInput::deserialize(&value["input"])?;
    let tolerances = reference.tolerances();
    if let Some(derived) = expected.object("derived", ledger) {
        check_object(derived, ledger, |derived, ledger| {
            check_derived(
                &example,
                derived,
                [tolerances.get("length_mm"), tolerances.get("angle_deg")],
                ledger,
            );
            Ok(())
        });
    }
    let sharp = EdgeRounding { radius: 0.0, rake_chamfer_width: 0.0, ..input.rounding() };
    let pair = example.edges.left.pair();
    let sharp = pair.with_tool(pair.tool().with_rounding(sharp)?)?;
    for flank in Flank::BOTH {
        let edge = &example.edges[flank];
        let sharp = input.edge(&sharp, flank)?;
        if let Some(object) = expected.peek("edges") {
            check_edges(&tolerances, edge, &sharp, &object[flank.name()], ledger)?;
        }
        if let Some(object) = expected.peek("poses") {
            check_poses(&tolerances, &example, flank, &object[flank.name()], ledger)?;
        }
        if let Some(object) = expected.peek("sensitivity") {
            let mut rows = Expected::new(expected.case(), "sensitivity", object, ledger);
            let tracks = default_track_places().into_iter().map(|place| MeasuringTrack::new(edge, place));
            let motion = pair.motion();
            let of = |track: MeasuringTrack| setting_sensitivity(motion, &track.contact);
            let actual: Vec<f64> = tracks.map(|track| track.map(of)).collect::<Result<Vec<_>, _>>()?.concat();
            rows.table(flank.name(), (&actual, 4), tolerances.get("sensitivity"), ledger);
        }
    }
    for key in ["edges", "poses", "sensitivity"] {
        sides_only(expected, key, ledger);
    }
    Ok(())
}

/// Both flanks of a key have been checked; nothing else may stand there.
fn sides_only(expected: &mut Expected<'_>, key: &str, ledger: &mut Ledger) {
    if let Some(mut object) = expected.object(key, ledger) {
        object.informative(&["left", "right"]);
        object.finish(ledger);
    }
}

fn check_derived(
    example: &SkivingExample,
    derived: &mut Expected<'_>,
    [mm, degrees]: [f64; 2],
    ledger: &mut Ledger,
) {
    let edge = &example.edges.left;
    let pair = edge.pair();
    let (tool, gear, motion) = (pair.tool(), pair.gear(), pair.motion());
    let helicoid = edge.flank().helicoid();
    let [from, to] = edge.flank().range();
    derived.numbers(
        &[
            ("s_I", helicoid.external_sign()),
            ("r2", gear.pitch_radius()),
            ("r_b2", helicoid.base_radius()),
            ("helix_rad_per_mm", helicoid.twist()),
            ("r1", tool.pitch_radius()),
            ("d", motion.centre_distance),
            ("ratio_i21", motion.ratio),
            ("w_from", from),
            ("w_to", to),
            ("centre_depth_h_c", tool.rounding().depth()),
            ("cutting_sense_omega1", edge.cutting_direction()),
        ],
        mm,
        ledger,
    );
    for (key, angle) in [
        ("alpha_t_deg", gear.transverse_pressure_angle(Flank::Left)),
        ("beta_b2_deg", helicoid.base_helix_angle()),
        ("eta_b2_deg", helicoid.base_space_half_angle()),
        ("gamma_deg", motion.crossed_axes_angle),
        ("phi_20_deg", motion.work_angle),
        ("phi_10_deg", motion.tool_angle),
    ] {
        derived.periodic(key, angle.to_degrees(), 360.0, degrees, ledger);
    }
}
