//! A text of a probe held against the workpiece: forward kinematics bring the ball into the workpiece's coordinates, where its distance from
//! the helicoids of both flanks is known exactly. On a scan it touches one flank from place to place; on all other ways it touches none.

use super::failure::of_machine;
use super::judge::{Followed, Judged, Motion, fault};
use super::probe::{ProbeCourse, ProbedProfile, back, base_pitch, swivelled_and_turned};
use super::task::ProbeWork;
use foundation::geometry::{Flank, Sides};
use foundation::kinematics::{Point, Pose, Workpiece};
use machine::{Mount, Positions, Station, StationSpindle};
use nalgebra::Vector3;
use run::RunFailure;

/// How far a speed may be off, as a share.
const SPEED: f64 = 1e-4;
/// How far a place may be from its length of roll, mm: the ball slides along the flank without changing its distance.
const ROLL: f64 = 1e-3;
/// Places of a way that are looked at.
const PLACES: usize = 24;

const AS_WRITTEN: &str = "correct these blocks, or take the text as it was written";

impl ProbeCourse<'_> {
    /// Centre of the ball in coordinates of the workpiece, and how far the probe leans from its orientation.
    fn ball(&self, work: &ProbeWork<'_>, at: &Positions) -> Result<(Vector3<f64>, f64), RunFailure> {
        let machine = self.course.stander.machine;
        let tool = machine.tool_spindle(at).map_err(|error| of_machine(&error, "read back"))?;
        let spindles = machine.pose(Station::Work, at).map_err(|error| of_machine(&error, "read back"))?;
        let mount = Mount { reversed: false, axial: work.work_height, angle: 0.0 };
        let tip = Point::from_vector(Vector3::new(work.reach, 0.0, work.length));
        let on_station: Point<StationSpindle> = spindles.inverse().point(&tip);
        let clamped: Pose<StationSpindle, Workpiece> = mount.pose();
        let [swivel, turn] = work.orientation;
        let wanted = swivelled_and_turned(swivel, turn);
        let lean = (tool.rotation() - wanted.matrix()).amax();
        Ok((clamped.inverse().point(&on_station).xyz, lean))
    }
}

/// Distance of a point from the nearest flank of a tooth, < 0 within a tooth, mm: in a tooth space the distances from both its flanks
/// make less than the base pitch together, in a tooth more.
fn off_flanks(work: &ProbeWork<'_>, at: &Vector3<f64>) -> f64 {
    let pitch = base_pitch(work);
    let [left, right] = Flank::BOTH
        .map(|flank| work.bodies.edges[flank].flank().helicoid().flank().deviation(at).f_n.rem_euclid(pitch));
    if left + right < pitch { left.min(right) } else { -(pitch - left).min(pitch - right) }
}

/// Deviations of the ball's centre from both flanks of a tooth space, and lengths of roll.
fn seen(work: &ProbeWork<'_>, gap: usize, ball: &Vector3<f64>) -> Sides<[f64; 2]> {
    let at = back(work, gap, ball);
    Sides::from_fn(|flank| {
        let found = work.bodies.edges[flank].flank().helicoid().flank().deviation(&at);
        [found.f_n, found.w]
    })
}

/// Judges the scans of a text; `allowed` is what digits explain, mm.
///
/// # Errors
/// Positions that are not finite.
pub(super) fn judged(
    laid: &ProbeCourse<'_>,
    work: &ProbeWork<'_>,
    followed: &Followed,
    allowed: f64,
) -> Result<(Judged, f64), RunFailure> {
    let mut judged = Judged { faults: followed.faults.clone(), ..Judged::default() };
    let mut between = 0.0f64;
    for (number, wanted) in laid.profiles.iter().enumerate() {
        let Some(stretch) = followed.stretches.get(number) else {
            let text = format!("{} is not scanned up to here", named(wanted));
            judged.faults.push(fault("probe-missing", followed.last_block(), &text, AS_WRITTEN));
            continue;
        };
        let [on, off] = stretch.blocks;
        let motions = &followed.motions[stretch.motions.clone()];
        let before = judged.faults.len();
        let mut faults = Vec::new();
        if motions.len() + 1 != wanted.lengths.len() {
            faults.push(format!("{} blocks for {} places", motions.len(), wanted.lengths.len()));
        } else {
            between = between.max(scan(laid, work, wanted, motions, allowed, &mut judged, &mut faults)?);
        }
        for reason in faults {
            let text = format!("{}, recorded in blocks {on} to {off}: {reason}", named(wanted));
            judged.faults.push(fault("probe-off", on, &text, AS_WRITTEN));
        }
        judged.sound += usize::from(judged.faults.len() == before);
    }
    for stretch in followed.stretches.iter().skip(laid.profiles.len()) {
        let text = "more is recorded than the job asks for";
        judged.faults.push(fault("probe-off", stretch.blocks[0], text, AS_WRITTEN));
    }
    for (number, motion) in followed.motions.iter().enumerate() {
        if followed.recorded(number) {
            continue;
        }
        let deepest = free(laid, work, motion)?;
        // A straight way ends on the flank or begins there; a rapid one keeps half of the clearance.
        let least = if motion.seconds.is_some() { -4.0 * allowed } else { 0.5 * work.clearance };
        // Written so that NaN is a fault.
        let is_free = deepest >= least;
        if !is_free {
            let text = format!(
                "the ball comes as near as {deepest:.4} mm to the workpiece; {least:.4} mm leave it free"
            );
            judged.faults.push(fault("probe-not-free", motion.block, &text, "draw the probe back before"));
        }
    }
    Ok((judged, between))
}

fn named(of: &ProbedProfile) -> String {
    format!("{} flank of tooth space {}", of.flank, of.gap)
}

/// What is wrong with a scan; what straight blocks leave between its places.
fn scan(
    laid: &ProbeCourse<'_>,
    work: &ProbeWork<'_>,
    wanted: &ProbedProfile,
    motions: &[Motion],
    allowed: f64,
    judged: &mut Judged,
    faults: &mut Vec<String>,
) -> Result<f64, RunFailure> {
    let Some(begin) = motions.first().and_then(|motion| motion.from) else {
        faults.push("it begins where the axes are not known".into());
        return Ok(0.0);
    };
    let digits = 4.0 * allowed;
    let opposite = if wanted.flank == Flank::Left { Flank::Right } else { Flank::Left };
    let mut between = 0.0f64;
    let stands = std::iter::once(begin).chain(motions.iter().map(|motion| motion.to));
    for (at, w) in stands.zip(&wanted.lengths) {
        let (ball, lean) = laid.ball(work, &at)?;
        let seen = seen(work, wanted.gap, &ball);
        let [f_n, found] = seen[wanted.flank];
        let aside = ((ball.z - work.height).abs() - work.ball_radius).max(0.0);
        if let Some(reason) = judged.off([f_n - work.ball_radius, lean + aside], digits) {
            faults.push(reason);
        }
        if (found - w).abs() > ROLL {
            faults.push(format!("it stands at length of roll {found:.4} mm in place of {w:.4} mm"));
        }
        if seen[opposite][0].rem_euclid(base_pitch(work)) < work.ball_radius {
            faults.push("the ball touches the other flank".into());
        }
    }
    for motion in motions {
        let Some(from) = motion.from else { continue };
        let mut middle = from;
        for &axis in &laid.course.stander.axes {
            middle[axis] = 0.5 * (from[axis] + motion.to[axis]);
        }
        let (ball, _) = laid.ball(work, &middle)?;
        between = between.max((seen(work, wanted.gap, &ball)[wanted.flank][0] - work.ball_radius).abs());
        let [a, b] = [laid.ball(work, &from)?.0, laid.ball(work, &motion.to)?.0];
        let turn = laid.turned(&from, &motion.to);
        let seconds = motion.seconds.unwrap_or(f64::NAN);
        // The way on the bed, or that of the workpiece under the ball.
        let on_bed = laid.way(&from, &motion.to);
        let way = on_bed.max(work.reach_of_turn(turn));
        let kept = (way / (seconds * work.speed) - 1.0).abs() <= SPEED;
        if !kept || (b - a).norm() == 0.0 {
            faults.push(format!("block {} takes {seconds:.4} s for {way:.4} mm", motion.block));
        }
    }
    Ok(between)
}

impl ProbeCourse<'_> {
    fn turned(&self, from: &Positions, to: &Positions) -> f64 {
        to[self.turning.0] - from[self.turning.0]
    }

    /// Way of the ball on the bed: its axes do not turn.
    fn way(&self, from: &Positions, to: &Positions) -> f64 {
        let [Ok(a), Ok(b)] = [from, to].map(|at| self.course.stander.tool(at)) else { return f64::NAN };
        (b.position - a.position).norm()
    }
}

/// Least distance of the ball from the workpiece on a way: from its tip circle outside, from both flanks inside, mm.
fn free(laid: &ProbeCourse<'_>, work: &ProbeWork<'_>, motion: &Motion) -> Result<f64, RunFailure> {
    let from = motion.from.unwrap_or(motion.to);
    let external = work.bodies.pair.gear().data().teeth > 0;
    let mut least = f64::INFINITY;
    for k in 0..=PLACES {
        let mut at = from;
        for &axis in &laid.course.stander.axes {
            at[axis] += (motion.to[axis] - from[axis]) * k as f64 / PLACES as f64;
        }
        let (ball, _) = laid.ball(work, &at)?;
        let radius = ball.xy().norm();
        let beside = if external { radius - work.tip_radius } else { work.tip_radius - radius };
        let inside = off_flanks(work, &ball);
        // Outside of the tip circle the helicoids go on, and nothing is there.
        let distance = if inside.is_nan() { beside } else { beside.max(inside) };
        least = least.min(distance - work.ball_radius);
    }
    Ok(least)
}
