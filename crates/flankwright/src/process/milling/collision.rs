//! Whether a cutter on its way keeps away from what it must not touch (spec 50 section 9): at every place and between them.

use super::{Clearance, CutterPlace, Patch};
use crate::geometry::Cutter;
use nalgebra::Vector3;

/// A surface that a cutter must keep away from.
#[derive(Clone, Copy, Debug)]
pub struct Obstacle<'a> {
    /// What it is, for messages.
    pub name: &'static str,
    /// The surface.
    pub patch: Patch<'a>,
    /// What the cutter has to keep, mm; < 0 allows it to go in by that.
    pub wanted: f64,
    /// Whether blocks between places are followed. Along the flank that the cutter touches they cannot be: there it keeps nothing, and
    /// what the blocks leave is a matter of micrometres, which the referee's rays tell.
    pub between: bool,
}

/// Where a cutter comes too near.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Collision {
    /// Number of the place on the path after which it happens.
    pub block: usize,
    /// Share of the block that begins there.
    pub share: f64,
    /// What it comes near to.
    pub name: &'static str,
    /// Distance there and the nearest point.
    pub clearance: Clearance,
    /// What it should keep, mm.
    pub wanted: f64,
}

/// Motion between two neighbouring checks below which a violation between them is reported, not looked for any further: mm.
const STEP: f64 = 1e-3;

/// The first place of a path at which a cutter does not keep what an obstacle wants; blocks between places included.
///
/// # Errors
/// The [`Collision`].
pub fn check_path(
    cutter: &Cutter,
    places: &[CutterPlace],
    obstacles: &[Obstacle],
) -> Result<(), Box<Collision>> {
    for obstacle in obstacles {
        let ball = Ball::around(&obstacle.patch);
        let check = Check { cutter, obstacle, ball };
        if !obstacle.between || places.len() == 1 {
            for (number, place) in places.iter().enumerate() {
                check.block(number, [place, place], [0.0, 0.0])?;
            }
            continue;
        }
        for (block, ends) in places.windows(2).enumerate() {
            check.block(block, [&ends[0], &ends[1]], [0.0, 1.0])?;
        }
    }
    Ok(())
}

struct Check<'a> {
    cutter: &'a Cutter,
    obstacle: &'a Obstacle<'a>,
    ball: Ball,
}

impl Check<'_> {
    /// A piece of a block: safe if its middle keeps more than anything of the tool near the obstacle can move from there; else both
    /// halves.
    fn block(&self, block: usize, ends: [&CutterPlace; 2], shares: [f64; 2]) -> Result<(), Box<Collision>> {
        let [from, to] = shares.map(|share| between(ends, share));
        let share = 0.5 * (shares[0] + shares[1]);
        let middle = between(ends, share);
        let lever = (self.ball.middle - middle.tip).norm() + self.ball.radius;
        let reach =
            |end: &CutterPlace| (end.tip - middle.tip).norm() + lever * (end.axis - middle.axis).norm();
        let moves = reach(&from).max(reach(&to));
        let Obstacle { name, patch, wanted, .. } = self.obstacle;
        let keeps = |wanted| patch.keeps(self.cutter, &middle.tip, &middle.axis, wanted);
        if keeps(wanted + moves).is_ok() {
            return Ok(());
        }
        let collision = |clearance| Box::new(Collision { block, share, name, clearance, wanted: *wanted });
        keeps(*wanted).map_err(collision)?;
        if moves < STEP {
            return Ok(());
        }
        self.block(block, ends, [shares[0], share])?;
        self.block(block, ends, [share, shares[1]])
    }
}

/// The cutter at a share of a block: tip linear, axis linear and made a unit vector.
fn between([from, to]: [&CutterPlace; 2], share: f64) -> CutterPlace {
    CutterPlace {
        tip: from.tip + (to.tip - from.tip) * share,
        axis: (from.axis + (to.axis - from.axis) * share).normalize(),
        contact: None,
    }
}

/// A ball that holds a patch.
struct Ball {
    middle: Vector3<f64>,
    radius: f64,
}

impl Ball {
    fn around(patch: &Patch) -> Self {
        let turn = nalgebra::Rotation3::from_axis_angle(&Vector3::z_axis(), patch.turn);
        let [a, b] = [patch.heights, patch.lengths].map(|[from, to]| 0.5 * (from + to));
        let middle = patch.surface.point(a, b);
        Self { middle: turn * middle, radius: reach(patch, [patch.heights, patch.lengths], &middle, PIECES) }
    }
}

/// How often a piece without a bound is halved both ways.
const PIECES: usize = 8;

/// How far a piece of a patch reaches from a point, mm; one that is too large for a statement by its parts.
fn reach(patch: &Patch, [heights, lengths]: [[f64; 2]; 2], from: &Vector3<f64>, halvings: usize) -> f64 {
    let [a, b] = [heights, lengths].map(|[from, to]| 0.5 * (from + to));
    let [x, y] = [heights, lengths].map(|[from, to]| 0.5 * (to - from));
    let speeds = patch.surface.speed_bounds(heights, lengths);
    let radius = speeds[0] * x + speeds[1] * y;
    if radius.is_finite() || halvings == 0 {
        return (patch.surface.point(a, b) - from).norm() + radius;
    }
    let halves = |[from, to]: [f64; 2], middle: f64| [[from, middle], [middle, to]];
    let parts = halves(heights, a)
        .into_iter()
        .flat_map(|heights| halves(lengths, b).map(|lengths| [heights, lengths]));
    parts.map(|part| reach(patch, part, from, halvings - 1)).fold(0.0, f64::max)
}
