//! The tool with neck, shank, holder and spindle against what clamps the workpiece, over all moves of a text, rapid moves included. Bodies
//! on both sides are convex and turned; distances are theirs, not those of points on them.

use super::prepare::Mounting;
use super::programs::{FollowedMove, MillingWork};
use foundation::geometry::{Cutter, CutterShape, TurnedBody};
use foundation::numerics::least_over;
use job::tables::ClampingBody;
use nalgebra::{Rotation3, Vector3};
use referee::CutterPlace;
use run::program_check::{BodyClearance, ProgramFault};

/// What a least distance is known to beside the accuracy of one distance, mm.
const HIDDEN: f64 = 0.01;
/// The last cylinder of a tool goes on so far, mm.
const UPWARDS: f64 = 1000.0;
/// Faults of one body that are reported.
const MOST_OF_A_BODY: usize = 20;

/// Code of a move that comes too near.
pub(super) const TOO_CLOSE: &str = "bodies-too-close";

/// What clamps a workpiece.
#[derive(Clone, Copy, Debug)]
pub(super) struct Clamping<'a> {
    /// About the axis of the workpiece, in its coordinates.
    pub bodies: &'a [ClampingBody],
    /// What the tool keeps from them, mm.
    pub kept: f64,
}

/// What was found in a text.
#[derive(Clone, Debug, Default)]
pub(super) struct BesideClamping {
    /// Least distance of each body, the nearest first.
    pub least: Vec<BodyClearance>,
    /// Moves that come nearer than is kept, by blocks.
    pub faults: Vec<ProgramFault>,
}

/// A convex part of a tool: a turned body with a ball rolled around it, in tool coordinates.
struct Part {
    name: String,
    body: TurnedBody,
    /// Radius of the ball, mm.
    ball: f64,
    /// No point of it is farther from the tip, mm.
    reach: f64,
}

impl Part {
    fn new(name: String, heights: [f64; 2], radii: [f64; 2], ball: f64) -> Option<Self> {
        let body = TurnedBody::about_z(heights, radii)?;
        Some(Self { name, reach: body.reach(&Vector3::zeros()) + ball, body, ball })
    }

    /// The parts of a tool. A barrel counts as the cylinder around it.
    fn of_tool(number: u32, cutter: &Cutter) -> Vec<Self> {
        let mut steps = cutter.steps().to_vec();
        steps.sort_by(|a, b| a.from.total_cmp(&b.from));
        let end =
            steps.first().map_or(cutter.cutting_length(), |step| step.from.max(cutter.cutting_length()));
        let edges = |heights, radii, ball| Self::new(format!("edges of tool {number}"), heights, radii, ball);
        let edges = match *cutter.shape() {
            CutterShape::Conical { radius, half_angle, corner_radius } => {
                let (sin, cos) = half_angle.sin_cos();
                let bottom = (radius - corner_radius * (1.0 - sin) / cos).max(0.0);
                let top = (radius + end * half_angle.tan() - corner_radius / cos).max(0.0);
                edges([corner_radius, end.max(corner_radius + HIDDEN)], [bottom, top], corner_radius)
            }
            CutterShape::Barrel { radius, .. } => edges([0.0, end], [radius; 2], 0.0),
        };
        let held = steps.iter().enumerate().filter_map(|(k, step)| {
            let end = steps.get(k + 1).map_or(step.from + UPWARDS, |next| next.from);
            let name = format!("tool {number} from {} mm above its tip", step.from);
            Self::new(name, [step.from, end], [step.radius; 2], 0.0)
        });
        edges.into_iter().chain(held).collect()
    }
}

/// How far any point of a part moves at most between two places, mm.
fn way(part: &Part, a: &CutterPlace, b: &CutterPlace) -> f64 {
    (b.tip - a.tip).norm() + (b.axis - a.axis).norm() * part.reach
}

/// The tool at a share of a straight move.
fn between([from, to]: [&CutterPlace; 2], share: f64) -> CutterPlace {
    CutterPlace {
        tip: from.tip + (to.tip - from.tip) * share,
        axis: (from.axis + (to.axis - from.axis) * share).normalize(),
    }
}

/// One part of a tool against one body.
struct Approach<'a> {
    part: &'a Part,
    body: &'a TurnedBody,
}

impl Approach<'_> {
    /// Distance at a place, mm; beyond `enough` any value from there up to the distance.
    fn at(&self, place: &CutterPlace, enough: f64) -> f64 {
        let turned = Rotation3::rotation_between(&Vector3::z(), &place.axis)
            .unwrap_or_else(|| Rotation3::from_axis_angle(&Vector3::x_axis(), std::f64::consts::PI));
        let tool = self.part.body.moved(turned.matrix(), &place.tip);
        (tool.distance(self.body, enough + self.part.ball) - self.part.ball).max(0.0)
    }

    /// The least distance over a straight move, mm, above it by [`HIDDEN`] at most; infinite where it is not below `enough`.
    fn over(&self, ends: [&CutterPlace; 2], enough: f64) -> f64 {
        least_over(enough, HIDDEN, |[first, last], needed| {
            let [from, to] = [first, last].map(|share| between(ends, share));
            let middle = between(ends, 0.5 * (first + last));
            let moved = way(self.part, &middle, &from).max(way(self.part, &middle, &to));
            let at = self.at(&middle, needed + moved);
            [at, at - moved]
        })
    }

    /// Calls `near` with every move that may come nearer than `enough` says, which may fall meanwhile.
    fn near(&self, moves: &[&FollowedMove], near: &mut Near<'_>) {
        let Some(middle) = moves.get(moves.len() / 2).and_then(|made| made.places.last()) else {
            return;
        };
        let moved = moves.iter().flat_map(|made| &made.places).map(|place| way(self.part, middle, place));
        let moved = moved.fold(0.0, f64::max);
        let far = near.enough() + moved;
        if far.is_finite() && self.at(middle, far) >= far {
            return;
        }
        if let [one] = moves {
            let ends = one.places.windows(2).map(|pair| [&pair[0], &pair[1]]);
            let alone = one.places.first().filter(|_| one.places.len() == 1).map(|only| [only, only]);
            for ends in ends.chain(alone) {
                let found = self.over(ends, near.enough());
                near.note(found, &self.part.name, one, ends[1]);
            }
            return;
        }
        let (first, last) = moves.split_at(moves.len() / 2);
        self.near(first, near);
        self.near(last, near);
    }
}

/// What came near to a body.
struct Near<'a> {
    body: &'a ClampingBody,
    number: usize,
    kept: f64,
    least: Option<BodyClearance>,
    faults: Vec<ProgramFault>,
}

impl Near<'_> {
    /// A distance from which on nothing is to be known.
    fn enough(&self) -> f64 {
        let known = self.least.as_ref().map_or(f64::INFINITY, |least| least.least_mm);
        (known - HIDDEN).max(self.kept)
    }

    fn note(&mut self, found: f64, part: &str, made: &FollowedMove, place: &CutterPlace) {
        let name = &self.body.name;
        if self.least.as_ref().is_none_or(|least| found < least.least_mm) && found.is_finite() {
            self.least = Some(BodyClearance {
                body: name.clone(),
                of: part.to_owned(),
                least_mm: found,
                file: String::new(),
                block: made.block,
            });
        }
        if found >= self.kept || self.faults.iter().any(|known| known.block == made.block) {
            return;
        }
        let come =
            if found > 0.0 { format!("come to {found:.3} mm of {name}") } else { format!("run into {name}") };
        let [x, y, z] = place.tip.into();
        self.faults.push(ProgramFault {
            code: TOO_CLOSE,
            text: format!(
                "block {}, tip towards ({x:.3}, {y:.3}, {z:.3}) mm: {part}: {come} (`machine.clamping[{}]`); {} mm are kept \
                 (`machine.body_clearance`)",
                made.block, self.number, self.kept
            ),
            way_out: "make the body thinner or shorter, take a longer or thinner tool, or another tilt",
            block: made.block,
            space: None,
            surface: None,
            place_mm: place.tip.into(),
            amount_mm: Some(found),
        });
    }
}

impl<'a> Clamping<'a> {
    /// As the workpiece is held.
    pub fn of_mounting(mounting: &'a Mounting) -> Self {
        Self { bodies: &mounting.clamping, kept: mounting.body_clearance }
    }

    /// What is not looked at, in words.
    pub fn not_covered(&self) -> &'static str {
        if self.bodies.is_empty() {
            "spindle, clamping and parts of the machine"
        } else {
            "spindle against the workpiece, and parts of the machine"
        }
    }

    /// What was found, in words and before what follows; empty without bodies.
    pub fn statement(&self, least: &[BodyClearance]) -> String {
        let Some(nearest) = least.first() else { return String::new() };
        let names: Vec<&str> = self.bodies.iter().map(|body| body.name.as_str()).collect();
        format!(
            "all moves of tool, shank, holder and spindle against {}: {:.2} mm apart or more ({} and {}, block {}), {} mm are kept; ",
            names.join(", "),
            nearest.least_mm,
            nearest.of,
            nearest.body,
            nearest.block,
            self.kept
        )
    }

    /// How near the tools of a text come to every body.
    pub fn beside(&self, work: &MillingWork<'_>, moves: &[FollowedMove]) -> BesideClamping {
        let mut numbers: Vec<u32> = moves.iter().map(|made| made.tool).collect();
        numbers.sort_unstable();
        numbers.dedup();
        let tools: Vec<(Vec<Part>, Vec<&FollowedMove>)> = numbers
            .into_iter()
            .map(|number| {
                let cutter = &work.tools[work.tool(number)].cutter;
                (Part::of_tool(number, cutter), moves.iter().filter(|made| made.tool == number).collect())
            })
            .collect();
        let mut beside = BesideClamping::default();
        for (number, body) in self.bodies.iter().enumerate() {
            let Some(turned) = body.body() else { continue };
            let mut near = Near { body, number, kept: self.kept, least: None, faults: Vec::new() };
            for (parts, moves) in &tools {
                for part in parts {
                    Approach { part, body: &turned }.near(moves, &mut near);
                }
            }
            beside.least.extend(near.least);
            near.faults.sort_by_key(|fault| fault.block);
            beside.faults.extend(near.faults.into_iter().take(MOST_OF_A_BODY));
        }
        beside.least.sort_by(|a, b| a.least_mm.total_cmp(&b.least_mm));
        beside
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn place(tip: [f64; 3], axis: [f64; 3]) -> CutterPlace {
        CutterPlace { tip: tip.into(), axis: Vector3::from(axis).normalize() }
    }

    fn nut() -> ClampingBody {
        ClampingBody { name: "nut".into(), z: [10.0, 30.0], diameter: 40.0, end_diameter: None }
    }

    fn ball() -> Cutter {
        Cutter::new(CutterShape::ball(3.0), 20.0, Vec::new()).unwrap()
    }

    /// A ball beside a nut, along its axis, across it and leaning over it.
    #[test]
    fn distances_that_are_known_are_found() {
        let parts = Part::of_tool(1, &ball());
        let turned = nut().body().unwrap();
        let approach = Approach { part: &parts[0], body: &turned };
        // Upright beside it, the ball's middle 30 mm from the axis.
        let beside = approach.at(&place([30.0, 0.0, 12.0], [0.0, 0.0, 1.0]), f64::INFINITY);
        assert!((beside - 7.0).abs() < 1e-3, "{beside}");
        // Lying above it, pointing outwards.
        let above = approach.at(&place([5.0, 0.0, 40.0], [1.0, 0.0, 0.0]), f64::INFINITY);
        assert!((above - 7.0).abs() < 1e-3, "{above}");
        // A straight move past it, nearest in its middle.
        let ends = [place([25.0, -60.0, 12.0], [0.0, 0.0, 1.0]), place([25.0, 60.0, 12.0], [0.0, 0.0, 1.0])];
        let least = approach.over([&ends[0], &ends[1]], f64::INFINITY);
        assert!((least - 2.0).abs() < 0.02, "{least}");
        // The axis turns over it while the tip stays.
        let ends = [place([0.0, 0.0, 40.0], [0.0, 0.1, 1.0]), place([0.0, 0.0, 40.0], [1.0, 0.1, -0.2])];
        assert!(approach.over([&ends[0], &ends[1]], f64::INFINITY) < 7.0);
    }
}
