//! The measuring poses of an example, and what of the tool comes nearest to the beam in them.

use super::super::expected::Expected;
use super::super::given::{Checked, check_object, compare_vector, number};
use super::super::ledger::Ledger;
use super::super::reference::Tolerances;
use super::example::SkivingExample;
use foundation::geometry::Flank;
use serde_json::Value;
use skiving::MeasuringTrack;
use skiving::measuring::{MeasuringPose, PoseKind, measuring_poses, nearest_other_flank};

/// Depth of the clearance faces that may cast a shadow, mm (`docs/mathematics/skiving.md#tracks-and-poses`).
const BODY: f64 = 5.0;

/// Compares the poses of every track of a flank.
pub(super) fn check_poses(
    tolerances: &Tolerances<'_>,
    example: &SkivingExample,
    flank: Flank,
    list: &Value,
    ledger: &mut Ledger,
) -> Checked {
    let name = format!("poses.{flank}");
    let items = list.as_array().ok_or_else(|| format!("{name}: a list is needed here"))?;
    let edge = &example.edges[flank];
    for (k, item) in items.iter().enumerate() {
        let expected = Expected::new(&name, &format!("[{k}]"), item, ledger);
        check_object(expected, ledger, |expected, ledger| {
            let w = number(expected, "w", ledger)?;
            let track = MeasuringTrack::new(edge, edge.flank().edge_coordinate(w))?;
            let poses = |kind| measuring_poses(&track, &example.beam, kind, (flank, k));
            let tangent = poses(PoseKind::Tangent)?[0];
            if let Some(mut object) = expected.object("tangent", ledger) {
                check_pose(tolerances, &tangent, &mut object, ledger);
                object.finish(ledger);
            }
            let found = poses(PoseKind::AlongFlank)?;
            let objects = expected.objects("best", ledger);
            ledger.equal(&name, &format!("[{k}].best.length"), objects.len().into(), found.len().into());
            for (pose, mut object) in found.iter().zip(objects) {
                check_pose(tolerances, pose, &mut object, ledger);
                object.finish(ledger);
            }
            let nearest = nearest_other_flank(&example.edges, flank, &tangent, &example.beam, BODY);
            let gap = tolerances.get("shadow_gap_mm");
            expected.number("nearest_other_flank_gap_mm", nearest.gap, gap, ledger);
            let kind = if nearest.flank == flank { "same" } else { "opposite" };
            expected.text("nearest_other_flank", kind, ledger);
            expected.whole("nearest_other_tooth", nearest.tooth.into(), ledger);
            Ok(())
        });
    }
    Ok(())
}

fn check_pose(
    tolerances: &Tolerances<'_>,
    pose: &MeasuringPose,
    expected: &mut Expected<'_>,
    ledger: &mut Ledger,
) {
    let (mm, degrees) = (tolerances.get("length_mm"), tolerances.get("angle_deg"));
    expected.periodic("A_deg", pose.swivel.to_degrees(), 360.0, degrees, ledger);
    expected.periodic("B_deg", pose.turn.to_degrees(), 360.0, degrees, ledger);
    let [x, y, z] = pose.position.into();
    expected.numbers(&[("X", x), ("Y", y), ("Z", z)], mm, ledger);
    expected.number("eta_deg", pose.off_flank.to_degrees(), degrees, ledger);
    let unit = tolerances.get("unit_vector");
    compare_vector(expected, "beam_in_tool_frame", &pose.beam_in_tool, unit, ledger);
}
