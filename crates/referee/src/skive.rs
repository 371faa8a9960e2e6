//! Power skiving, refereed: the profile that a rounded edge leaves while it rolls through the space. The edge is the balls of its rounding
//! in a row; every ball on its way is held against the involute helicoid, over which the axial feed takes it along the helix.
//! Where a ball touches is found by trial.

use super::RemovalError;
use foundation::geometry::InvoluteFlank;
use foundation::kinematics::{GeneratingState, Point, SkivingMotion};
use foundation::numerics::{equidistant, golden_section};
use nalgebra::Vector3;
use rayon::prelude::*;

/// An edge, what it cuts and how both move. mm, rad.
#[derive(Clone, Copy)]
pub struct Skiving<'a> {
    /// The flank without modifications, from which everything is measured.
    pub flank: &'a InvoluteFlank,
    /// The motion that is really driven.
    pub motion: &'a SkivingMotion,
    /// What goes on beside it with the angle of the tool: added to the centre distance, mm, and to the angle of the workpiece, rad.
    pub law: Option<&'a (dyn Fn(f64) -> [f64; 2] + Sync)>,
    /// Centre of the rounding in tool coordinates and its radius over a place of the edge.
    pub edge: &'a (dyn Fn(f64) -> (Vector3<f64>, f64) + Sync),
    /// From where to where the edge reaches.
    pub places: [f64; 2],
    /// Angles of the tool in which the edge passes the space.
    pub tool_angles: [f64; 2],
}

/// What is left at a length of roll, and what left it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SkivedPlace {
    /// f_n, mm: > 0 is material left.
    pub left: f64,
    /// Place of the edge.
    pub place: f64,
    /// Angle of the tool.
    pub tool_angle: f64,
}

/// Places of the edge and angles of the tool that are tried before the best of them are refined: some hundredths of a millimetre of f_n
/// between neighbours on gears of module 1 to 8.
const PLACES: usize = 41;
const ANGLES: usize = 61;
/// Neighbours of the best place, on both sides, within which it is refined.
const AROUND: f64 = 3.0;
/// Evaluations of a search in one direction; f_n is flat there, 1e-7 of the way leaves less than 1e-12 mm.
const SEARCH: usize = 36;
/// The same for the best angle of a ball that is only tried.
const TRIAL: usize = 24;

impl Skiving<'_> {
    /// What is left at lengths of roll; `None` where no ball comes by.
    ///
    /// # Errors
    /// [`RemovalError::InvalidNumber`] for ranges without extent.
    pub fn profile(&self, lengths_of_roll: &[f64]) -> Result<Vec<Option<SkivedPlace>>, RemovalError> {
        for (field, [from, to]) in [("places", self.places), ("tool_angles", self.tool_angles)] {
            if from.is_nan() || to.is_nan() || from >= to {
                return Err(RemovalError::InvalidNumber { field, value: to - from, allowed: "> 0" });
            }
        }
        let [first, last] = self.places;
        let step = (last - first) / (PLACES - 1) as f64;
        let tried: Vec<Ball> =
            equidistant(self.places, PLACES).into_par_iter().map(|p| self.deepest(p)).collect();
        let of_roll = |&w: &f64| {
            let near = |ball: &Ball| (ball.w - w).abs();
            let found = tried.iter().filter(|ball| ball.off.is_finite());
            let start = found.min_by(|a, b| near(a).total_cmp(&near(b)))?;
            let places = [(start.place - AROUND * step).max(first), (start.place + AROUND * step).min(last)];
            let best_angle = |rounding: &Rounding| {
                let turn = self.angle_step();
                let [from, to] = [start.tool_angle - AROUND * turn, start.tool_angle + AROUND * turn];
                golden_section(from, to, SEARCH, |angle| self.left_by(w, rounding, angle))
            };
            let place = golden_section(places[0], places[1], SEARCH, |place| {
                let rounding = self.rounding(place);
                self.left_by(w, &rounding, best_angle(&rounding))
            });
            let rounding = self.rounding(place);
            let tool_angle = best_angle(&rounding);
            let left = self.left_by(w, &rounding, tool_angle);
            left.is_finite().then_some(SkivedPlace { left, place, tool_angle })
        };
        Ok(lengths_of_roll.par_iter().map(of_roll).collect())
    }

    fn rounding(&self, place: f64) -> Rounding {
        let (centre, radius) = (self.edge)(place);
        Rounding { place, centre, radius }
    }

    fn angle_step(&self) -> f64 {
        (self.tool_angles[1] - self.tool_angles[0]) / (ANGLES - 1) as f64
    }

    /// The ball of a place where it comes nearest to the material.
    fn deepest(&self, place: f64) -> Ball {
        let rounding = self.rounding(place);
        let mut best = Ball { place, tool_angle: f64::NAN, w: f64::NAN, off: f64::INFINITY };
        for tool_angle in equidistant(self.tool_angles, ANGLES) {
            let ball = self.ball(&rounding, tool_angle);
            if ball.off < best.off {
                best = ball;
            }
        }
        let turn = self.angle_step();
        let [from, to] = [best.tool_angle - turn, best.tool_angle + turn];
        let angle = golden_section(from, to, TRIAL, |angle| self.ball(&rounding, angle).off);
        let refined = self.ball(&rounding, angle);
        if refined.off < best.off { refined } else { best }
    }

    /// A ball at an angle of the tool: foot and distance of its surface from the flank of its own space.
    fn ball(&self, rounding: &Rounding, tool_angle: f64) -> Ball {
        let at = self.in_workpiece(&rounding.centre, tool_angle);
        let seen = self.flank.deviation(&at);
        let own = self.flank.nearest_space(&at) == 0 && seen.f_n.is_finite();
        let off = if own { seen.f_n - rounding.radius } else { f64::INFINITY };
        Ball { place: rounding.place, tool_angle, w: seen.w, off }
    }

    /// What a ball leaves at a length of roll: its own circle across the helix, along which the feed takes it.
    fn left_by(&self, w: f64, rounding: &Rounding, tool_angle: f64) -> f64 {
        let ball = self.ball(rounding, tool_angle);
        let radius = rounding.radius;
        let (aside, high) = (self.across_helix(0.5 * (w + ball.w)) * (w - ball.w), ball.off + radius);
        if radius == 0.0 {
            // A sharp edge leaves points only; next to them its neighbours do.
            return ball.off + aside.abs();
        }
        let square = radius * radius - aside * aside;
        if square > 0.0 { high - square.sqrt() } else { high + aside.abs() }
    }

    /// Way across the helix within the flank per length of roll.
    fn across_helix(&self, w: f64) -> f64 {
        let frame = self.flank.frame(w, 0.0);
        let at = self.flank.point_in(&frame, w, 0.0);
        let twist = self.flank.twist_per_length();
        let helix = Vector3::new(-twist * at.y, twist * at.x, 1.0).normalize();
        let along = frame.e_r.dot(&helix);
        (w / self.flank.base_radius) * (1.0 - along * along).sqrt()
    }

    fn in_workpiece(&self, point: &Vector3<f64>, tool_angle: f64) -> Vector3<f64> {
        let mut state: GeneratingState = self.motion.state(tool_angle, 0.0);
        if let Some(law) = self.law {
            let [distance, turn] = law(tool_angle);
            state.delta_d += distance;
            state.work_angle += turn;
        }
        let pose = self.motion.chain().pose(&state).inverse();
        pose.point(&Point::from_vector(*point)).xyz
    }
}

/// A ball of the rounding, in tool coordinates.
struct Rounding {
    place: f64,
    centre: Vector3<f64>,
    radius: f64,
}

/// A ball of the rounding on its way.
#[derive(Clone, Copy)]
struct Ball {
    place: f64,
    tool_angle: f64,
    w: f64,
    off: f64,
}
