//! The workpiece that a tool will leave, under the referee: the rounding of every tooth, with its own errors, rolls through the space.

use super::measurement::Measurement;
use super::prepare::SkivingBodies;
use crate::measuring::RealTool;
use crate::runout::{PeriodicLaw, angle_of};
use crate::{EdgePiece, MeasuringTrack, VirtualEdge};
use foundation::geometry::{Flank, Sides};
use foundation::kinematics::SkivingMotion;
use foundation::numerics::Progress;
use job::Diagnostic;
use nalgebra::{Rotation3, Vector3};
use referee::Skiving;
use run::RunFailure;
use std::f64::consts::TAU;

/// f_n against the involute that every tooth leaves, [track][tooth] of each flank, mm.
pub(super) type Left = Sides<Vec<Vec<f64>>>;

/// The tool passes the space within this turn to both sides, rad: at least 8 deg (`docs/mathematics/skiving.md#how-it-is-verified`), of a
/// tool with few teeth more than a pitch.
const LEAST_PASSING: f64 = 8.0 * std::f64::consts::PI / 180.0;
const PITCHES: f64 = 1.25;
/// Share of the edge by which a piece begins behind the end of the one before, and by which it may cut beside itself.
const SEAM: f64 = 1e-9;
const BESIDE: f64 = 0.05;

/// What is added to centre distance, mm, and angle of the workpiece, rad, at an angle of the tool.
pub(super) type Law<'a> = dyn Fn(f64) -> [f64; 2] + Sync + 'a;

/// What a tool leaves with a motion and a law beside it, clocked by an angle.
///
/// # Errors
/// [`RunFailure`] where no part of an edge comes by.
pub(super) fn skived(
    bodies: &SkivingBodies,
    tool: &RealTool,
    clocking: f64,
    moved: (&SkivingMotion, Option<&Law<'_>>),
    progress: &dyn Progress,
) -> Result<Left, RunFailure> {
    let lengths = Sides::from_fn(|flank| lengths(bodies, flank));
    skived_at(bodies, (tool, clocking), moved, &lengths, progress)
}

/// The same at lengths of roll of one's own.
///
/// # Errors
/// As [`skived`].
pub(super) fn skived_at(
    bodies: &SkivingBodies,
    (tool, clocking): (&RealTool, f64),
    (motion, law): (&SkivingMotion, Option<&Law<'_>>),
    lengths: &Sides<Vec<f64>>,
    progress: &dyn Progress,
) -> Result<Left, RunFailure> {
    let teeth = tool.teeth();
    progress.start("referee", 2 * teeth as u64);
    let passing = LEAST_PASSING.max(PITCHES * TAU / teeth as f64);
    let left = Sides::try_from_fn(|flank| {
        let edge = &bodies.edges[flank];
        let lengths = &lengths[flank];
        let mut of_tracks = vec![Vec::with_capacity(teeth); lengths.len()];
        for tooth in 0..teeth {
            let ball = |w: f64| ball(edge, tool, tooth, clocking, w);
            let whole = edge.flank().range();
            let mut least: Vec<Option<f64>> = vec![None; lengths.len()];
            for places in places_of(edge) {
                let near = |w: f64| reaches(places, whole, w);
                let wanted: Vec<usize> = (0..lengths.len()).filter(|&k| near(lengths[k])).collect();
                if wanted.is_empty() {
                    continue;
                }
                // The law goes by the angle of the tool; balls are those of the tooth turned to where tooth 0 stands.
                let of_tooth = law.map(|law| move |angle: f64| law(angle_of(angle, tooth, teeth)));
                let skiving = Skiving {
                    law: of_tooth.as_ref().map(|law| law as &(dyn Fn(f64) -> [f64; 2] + Sync)),
                    flank: edge.flank().helicoid().flank(),
                    motion,
                    edge: &ball,
                    places,
                    tool_angles: [motion.tool_angle - passing, motion.tool_angle + passing],
                };
                let of_piece: Vec<f64> = wanted.iter().map(|&k| lengths[k]).collect();
                let found =
                    skiving.profile(&of_piece).map_err(|error| RunFailure::of_removal(&error, "skiving"))?;
                // Of all pieces that come by the one that cuts deepest leaves the flank.
                for (k, place) in wanted.into_iter().zip(found) {
                    let left = place.map(|place| place.left);
                    least[k] = least[k].into_iter().chain(left).reduce(f64::min);
                }
            }
            for ((of_track, left), w) in of_tracks.iter_mut().zip(least).zip(lengths) {
                of_track.push(left.ok_or_else(|| not_cut(flank, tooth, *w))?);
            }
            progress.advance(1);
        }
        Ok::<_, RunFailure>(of_tracks)
    })?;
    progress.finish();
    Ok(left)
}

/// From where to where each smooth piece of an edge reaches. Where one ends and the next begins belongs to the first.
fn places_of(edge: &VirtualEdge) -> Vec<[f64; 2]> {
    let whole = edge.flank().range();
    let inset = SEAM * (whole[1] - whole[0]);
    let of_piece = |(number, piece): (usize, &EdgePiece)| {
        let [from, to] = piece.range();
        [if number == 0 { from } else { from + inset }, to]
    };
    edge.pieces().iter().enumerate().map(of_piece).collect()
}

/// Whether a piece may cut at a length of roll: within it, or a little beside, where a setting that is off moves it.
fn reaches(piece: [f64; 2], whole: [f64; 2], w: f64) -> bool {
    let beside = BESIDE * (whole[1] - whole[0]);
    piece[0] - beside <= w && w <= piece[1] + beside
}

fn not_cut(flank: Flank, tooth: usize, w: f64) -> RunFailure {
    let message =
        format!("tooth {tooth} does not pass the {flank} flank of its space at length of roll {w} mm");
    let finding = Diagnostic::with_code("flank-not-cut", message)
        .field("skiving")
        .way_out("check centre distance, crossed-axes angle and tool shift");
    RunFailure::not_producible(finding)
}

/// What a tool leaves with the present setting, and after the correction where there is one.
pub(super) struct UnderReferee {
    pub now: Left,
    pub corrected: Option<Left>,
}

/// What the measured tool leaves, or the ideal one before anything is measured. Of a real tool its edges are those that its deviations
/// tell.
///
/// # Errors
/// As [`skived`].
pub(super) fn of_measurement(
    bodies: &SkivingBodies,
    measurement: Option<&Measurement>,
    law: Option<&PeriodicLaw>,
    progress: &dyn Progress,
) -> Result<UnderReferee, RunFailure> {
    let motion = bodies.pair.motion();
    let Some(measurement) = measurement else {
        let now = skived(bodies, &RealTool::ideal(bodies.teeth()), 0.0, (motion, None), progress)?;
        return Ok(UnderReferee { now, corrected: None });
    };
    let (tool, clocking) = (&measurement.cutting, measurement.cutting_clocking);
    let now = skived(bodies, tool, clocking, (motion, None), progress)?;
    let other = corrected(motion, &measurement.correction.change);
    let law = law.map(|law| |angle: f64| law.at(angle));
    let law = law.as_ref().map(|law| law as &Law<'_>);
    let corrected = Some(skived(bodies, tool, clocking, (&other, law), progress)?);
    Ok(UnderReferee { now, corrected })
}

/// The motion after a change of [d, gamma, z_V1, phi_1]; the coupling stays where it was, the tool is turned against it.
pub(super) fn corrected(motion: &SkivingMotion, change: &[f64; 4]) -> SkivingMotion {
    let [distance, angle, shift, turn] = *change;
    SkivingMotion {
        centre_distance: motion.centre_distance + distance,
        crossed_axes_angle: motion.crossed_axes_angle + angle,
        tool_shift: motion.tool_shift + shift,
        work_angle: motion.work_angle - motion.ratio * turn,
        ..*motion
    }
}

fn ball(edge: &VirtualEdge, tool: &RealTool, tooth: usize, clocking: f64, w: f64) -> (Vector3<f64>, f64) {
    let (centre, radius) = tool.ball(edge, tooth, w);
    (Rotation3::from_axis_angle(&Vector3::z_axis(), -clocking) * centre, radius)
}

fn lengths(bodies: &SkivingBodies, flank: Flank) -> Vec<f64> {
    let of_track = |(track, _): &(MeasuringTrack, _)| track.contact.w;
    bodies.flanks[flank].tracks.iter().map(of_track).collect()
}
