//! Both edges of a tooth of the ideal tool in one pose.

use super::super::expected::Expected;
use super::super::given::{Checked, check_object, requires};
use super::super::ledger::Ledger;
use super::super::reference::Tolerances;
use super::example::SkivingExample;
use super::measured::Measured;
use foundation::geometry::Flank;
use foundation::numerics::brent;
use skiving::VirtualEdge;
use skiving::measuring::{Barrier, RealTool, dark_band};
use std::f64::consts::TAU;

/// The files locate a touch along the edge by central differences over this share of its range; that place lies some 1e-5 um beside the
/// stationary one, on a rounding of hundredths of a millimetre it is 1e-6 deg.
const STEP: f64 = 1e-4;
/// A touch leaves nothing of its equations, mm.
const RESIDUAL: f64 = 1e-11;

/// Compares the dark band, if the file has one.
pub(super) fn check_band(
    tolerances: &Tolerances<'_>,
    measured: &Measured,
    outer: &mut Expected<'_>,
    ledger: &mut Ledger,
) -> Checked {
    let Some(expected) = outer.object("band", ledger) else { return Ok(()) };
    check_object(expected, ledger, |expected, ledger| {
        requires(expected, "pose", &["left flank, middle track, ideal tool"], ledger)?;
        let SkivingExample { edges, .. } = &measured.example;
        let tracks = &measured.flanks.left.tracks;
        let (track, pose) = &tracks[tracks.len() / 2];
        let barrier = Barrier { beam: &measured.beam, pose };
        let ideal = RealTool::ideal(measured.example.teeth());
        let band =
            dark_band(&barrier, edges, &ideal, (Flank::Left, track), 0)?.ok_or("the tooth is broken")?;
        let radians = tolerances.get("trigger_angle_rad");
        let pitch = TAU / measured.example.teeth() as f64;
        for (key, angle) in [
            ("measured_flank_B_rad", band.measured),
            ("opposite_flank_B_rad", band.opposite),
            ("dark_width_rad", (band.measured - band.opposite).abs()),
            ("pitch_rad", pitch),
        ] {
            expected.number(key, angle, radians, ledger);
        }
        let place = by_differences(&barrier, &edges.right, &ideal, [band.opposite_roll, band.opposite])?;
        expected.number("opposite_touch_w", place.0, tolerances.get("length_mm"), ledger);
        expected.number(
            "opposite_touch_theta_deg",
            place.1.to_degrees(),
            tolerances.get("theta_deg"),
            ledger,
        );
        expected.at_most("opposite_residual", band.residual, RESIDUAL, ledger);
        Ok(())
    });
    Ok(())
}

/// Length of roll and angle of a touch of tooth 0 as the files have them: where the gaps at equal distances to both sides are equal.
pub(super) fn by_differences(
    barrier: &Barrier<'_>,
    edge: &VirtualEdge,
    tool: &RealTool,
    [w, turn]: [f64; 2],
) -> Checked<(f64, f64)> {
    let [from, to] = edge.flank().range();
    let step = STEP * (to - from);
    let difference = |w: f64| {
        let [a, b] = [w - step, w + step].map(|w| barrier.distance(edge, tool, 0, [w, turn]).0);
        b - a
    };
    let ends = [w - step, w + step];
    let found = brent(ends, ends.map(difference), 0.0, |w| Some(difference(w)));
    let found = found.ok_or("no place where both sides are equally far")?;
    Ok((found, barrier.distance(edge, tool, 0, [found, turn]).1))
}
