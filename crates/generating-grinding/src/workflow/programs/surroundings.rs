//! What stands around worm and workpiece: clamping, bodies of the machine, the dresser while the gear is ground and the gear while the worm
//! is dressed. From the texts: how near the worm and what its spindle carries come to them, over all blocks, strokes included. Worm against
//! blank in grinding and worm against dresser in dressing stand in `clearance.rs`. Knows no flank.

use super::build::Built;
use super::task::ProgramTask;
use super::technology::Technology;
use foundation::geometry::TurnedBody;
use foundation::kinematics::{Dresser, Workpiece, Worm};
use foundation::numerics::least_over;
use job::Diagnostic;
use job::machine::LoadedMachine;
use machine::{Joint, Machine, Mount, Positions, Role, Station};
use motion::{MotionError, Tracked, track};
use run::RunFailure;
use run::program_check::BodyClearance;
use std::collections::BTreeMap;
use verdict::Remark;

/// What a least distance is known to beside the accuracy of one distance, mm.
const HIDDEN: f64 = 0.01;
/// A worm of unknown width counts as this long, mm.
const ENDLESS: f64 = 1000.0;

/// Which part of the machine a body belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Side {
    Worm,
    Work,
    Dresser,
    Bed,
}

/// What a body is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    /// The worm, the blank or the dresser itself.
    Own,
    /// `machine.clamping` by its number.
    Clamping(usize),
    /// A body of the machine's description.
    Machine,
}

/// A body that axes carry.
#[derive(Clone, Debug)]
struct Carried {
    name: String,
    kind: Kind,
    side: Side,
    /// Axes from the bed outwards.
    carriers: Vec<usize>,
    /// With all axes at zero, in the machine frame.
    body: TurnedBody,
}

/// The bodies of a machine with a job clamped in it.
#[derive(Clone, Debug)]
pub struct Surroundings<'a> {
    machine: &'a Machine,
    bodies: Vec<Carried>,
    /// Whether the machine's description has workpiece and dresser in different places. Otherwise one of them is away while the other is
    /// used, and how is not known.
    apart: bool,
    /// Whether the job names a clamping.
    clamped: bool,
    /// Whether the worm has a width.
    ends_known: bool,
    /// Angle at which the dresser's swivel stands while no dressing program moves it, rad.
    swivel: f64,
    /// What is kept, mm.
    kept: f64,
}

/// What was found in a text.
#[derive(Clone, Debug, Default)]
pub struct Around {
    /// Least distance of everything that was looked at, with its block.
    pub least: Vec<BodyClearance>,
    /// Places with less than is kept, one for each block and body, with the key that says what stands there; by blocks.
    pub faults: Vec<(usize, String, Remark)>,
}

impl<'a> Surroundings<'a> {
    /// The bodies of a job on a machine.
    pub fn new(loaded: &'a LoadedMachine, technology: &Technology) -> Self {
        let machine = &loaded.machine;
        let mut bodies = Vec::new();
        let on_tool = |mount: &Mount, body: &TurnedBody| {
            let pose = machine.tool_at_zero().then(&mount.pose::<_, Worm>());
            body.moved(pose.rotation(), pose.translation())
        };
        let mut own = |name: &str, kind: Kind, side: Side, carriers: &[usize], body: Option<TurnedBody>| {
            let carriers = carriers.to_vec();
            bodies.extend(body.map(|body| Carried { name: name.to_owned(), kind, side, carriers, body }));
        };
        let cylinder = |radius: f64, half: f64| TurnedBody::about_z([-half, half], [radius; 2]);
        let mut ends_known = true;
        if let Some(cylinders) = &technology.cylinders {
            ends_known = cylinders.worm_half_width.is_some();
            let worm = cylinder(cylinders.worm_radius, cylinders.worm_half_width.unwrap_or(0.5 * ENDLESS));
            let worm = worm.map(|body| on_tool(&technology.grinding.tool, &body));
            own("worm", Kind::Own, Side::Worm, &machine.tool().axes, worm);
        }
        if let (Ok(limb), Ok(spindle)) =
            (machine.station(Station::Work), machine.station_at_zero(Station::Work))
        {
            let pose = spindle.then(&technology.grinding.counterpart.pose::<_, Workpiece>());
            let placed = |body: TurnedBody| body.moved(pose.rotation(), pose.translation());
            if let Some(cylinders) = &technology.cylinders {
                let blank = cylinder(cylinders.radius, cylinders.half_width).map(placed);
                own("blank", Kind::Own, Side::Work, &limb.axes, blank);
            }
            for (number, clamping) in technology.clamping.iter().enumerate() {
                let body = clamping.body().map(placed);
                own(&clamping.name, Kind::Clamping(number), Side::Work, &limb.axes, body);
            }
        }
        if let (Ok(limb), Ok(spindle), Some(dresser)) = (
            machine.station(Station::Dresser),
            machine.station_at_zero(Station::Dresser),
            &technology.dresser,
        ) {
            let pose = spindle.then(&technology.dressing.counterpart.pose::<_, Dresser>());
            let body = cylinder(dresser.radius, dresser.half_width);
            let body = body.map(|body| body.moved(pose.rotation(), pose.translation()));
            own("dresser", Kind::Own, Side::Dresser, &limb.axes, body);
        }
        for entry in &loaded.file.bodies {
            let carried = entry.axis.as_deref().and_then(|name| machine.carriers(machine.axis_named(name)?));
            let (side, carriers) = match carried {
                Some((None, carriers)) => (Side::Worm, carriers),
                Some((Some(Station::Work), carriers)) => (Side::Work, carriers),
                Some((Some(Station::Dresser), carriers)) => (Side::Dresser, carriers),
                None => (Side::Bed, Vec::new()),
            };
            own(&entry.name, Kind::Machine, side, &carriers, entry.body());
        }
        let of = |side: Side| {
            bodies.iter().find(|body| body.kind == Kind::Own && body.side == side).map(|body| body.body)
        };
        let apart = match (of(Side::Work), of(Side::Dresser)) {
            (Some(blank), Some(dresser)) => blank.distance(&dresser, f64::INFINITY) > 0.0,
            _ => false,
        };
        Self {
            machine,
            apart,
            clamped: !technology.clamping.is_empty(),
            ends_known,
            swivel: technology.swivel,
            kept: technology.body_clearance,
            bodies,
        }
    }

    /// What is kept, mm.
    pub fn kept(&self) -> f64 {
        self.kept
    }

    /// Bodies of the worm's side and what they may meet at a station, by their numbers.
    fn pairs(&self, station: Station) -> Vec<(usize, Vec<usize>)> {
        let (here, there) = match station {
            Station::Work => (Side::Work, Side::Dresser),
            Station::Dresser => (Side::Dresser, Side::Work),
        };
        let met = |k: &usize| {
            let side = self.bodies[*k].side;
            side == here || side == Side::Bed || (side == there && self.apart)
        };
        let numbers = 0..self.bodies.len();
        let tools: Vec<usize> = numbers.clone().filter(|&k| self.bodies[k].side == Side::Worm).collect();
        let own = |k: usize| self.bodies[k].kind == Kind::Own;
        // What works here is looked at beside the strokes only.
        let works = |tool: usize, other: usize| own(tool) && own(other) && self.bodies[other].side == here;
        let against = |other: usize| -> Vec<usize> {
            tools.iter().copied().filter(|&tool| !works(tool, other)).collect()
        };
        numbers
            .filter(met)
            .map(|other| (other, against(other)))
            .filter(|(_, tools)| !tools.is_empty())
            .collect()
    }

    /// What no body stands for, in words.
    pub fn not_covered(&self) -> Vec<&'static str> {
        let side = |side: Side| self.bodies.iter().any(|b| b.kind == Kind::Machine && b.side == side);
        let mut not = Vec::new();
        if !self.clamped {
            not.push("clamping");
        }
        let sides = [
            (side(Side::Worm), "head and spindle of the worm"),
            (side(Side::Work) || side(Side::Bed), "table and tailstock"),
            (side(Side::Dresser), "spindle of the dresser"),
        ];
        if sides.iter().all(|(known, _)| !known) {
            not.push("parts of the machine");
        } else {
            not.extend(sides.iter().filter(|(known, _)| !known).map(|(_, name)| *name));
        }
        not
    }

    /// What is not looked at because the machine's description has gear and dresser in one place, in words.
    pub fn exchanged(&self) -> Option<&'static str> {
        let dressed = self.bodies.iter().any(|body| body.kind == Kind::Own && body.side == Side::Dresser);
        (dressed && !self.apart).then_some(
            "the dresser while the gear is ground and the gear while the worm is dressed, which the machine has in one place",
        )
    }

    /// Follows a text over all its blocks.
    pub fn follow(&self, tracked: &Tracked, station: Station) -> Around {
        let mut around = Around::default();
        let pairs = self.pairs(station);
        for (other, tools) in &pairs {
            let other = &self.bodies[*other];
            // Of every block the least distance that counts.
            let mut faults: BTreeMap<usize, (f64, &Carried)> = BTreeMap::new();
            let mut least: Option<BodyClearance> = None;
            for tool in tools {
                let tool = &self.bodies[*tool];
                for (block, ends) in tracked.moves() {
                    let known = least.as_ref().map_or(f64::INFINITY, |least| least.least_mm);
                    let search = Search {
                        machine: self.machine,
                        bodies: [tool, other],
                        ends: ends.map(|at| self.at_rest(at, station)),
                    };
                    let found = search.least((known - HIDDEN).max(self.kept));
                    if found < known {
                        least = Some(BodyClearance {
                            body: other.name.clone(),
                            of: tool.name.clone(),
                            least_mm: found,
                            block,
                            file: String::new(),
                        });
                    }
                    if found < self.kept {
                        let of_block = faults.entry(block).or_insert((found, tool));
                        if found < of_block.0 {
                            *of_block = (found, tool);
                        }
                    }
                }
            }
            around.least.extend(least);
            around
                .faults
                .extend(faults.into_iter().map(|(block, (gap, tool))| self.fault(block, gap, tool, other)));
        }
        around.faults.sort_by_key(|(block, _, _)| *block);
        around
    }

    /// Spindles turn bodies of revolution: their angle is nothing. What dresses stands where the job clamps it while the gear is ground.
    fn at_rest(&self, at: &Positions, station: Station) -> Positions {
        let mut at = *at;
        for role in [Role::Worm, Role::Work, Role::Dresser] {
            if let Some(axis) = self.machine.role(role) {
                at[axis] = 0.0;
            }
        }
        if let (Station::Work, Some(axis)) = (station, self.machine.role(Role::Swivel)) {
            at[axis] = self.swivel;
        }
        at
    }

    fn fault(&self, block: usize, gap: f64, tool: &Carried, other: &Carried) -> (usize, String, Remark) {
        let kept = self.kept;
        let come = if gap > 0.0 {
            format!("{} and {} come to {gap:.3} mm of each other", tool.name, other.name)
        } else {
            format!("{} and {} run into each other", tool.name, other.name)
        };
        let (field, key, way_out) = match other.kind {
            Kind::Clamping(number) => (
                format!("machine.clamping[{number}]"),
                format!(" (`machine.clamping[{number}]`)"),
                "make it thinner or shorter, or let it begin farther from the face: the worm runs out beside the face until it is clear of the blank",
            ),
            _ if [tool.kind, other.kind].contains(&Kind::Machine) => (
                "machine.file".to_owned(),
                " (`bodies` of the machine)".to_owned(),
                "clamp worm, gear or dresser elsewhere along its spindle (machine.worm, machine.work, machine.dresser), or correct the body in the machine's description",
            ),
            Kind::Machine | Kind::Own => (
                "machine".to_owned(),
                String::new(),
                "clamp worm, gear or dresser elsewhere along its spindle (machine.worm, machine.work, machine.dresser)",
            ),
        };
        let length = if self.ends_known || tool.kind != Kind::Own {
            ""
        } else {
            "; a worm without worm.width counts as endless, so give its width"
        };
        let text = format!("block {block}: {come}{key}; {kept} mm are kept (`machine.body_clearance`)");
        (block, field, Remark::new("bodies-too-close", text, format!("{way_out}{length}")))
    }
}

/// Two bodies over a straight block.
struct Search<'a> {
    machine: &'a Machine,
    bodies: [&'a Carried; 2],
    ends: [Positions; 2],
}

impl Search<'_> {
    /// Positions with the linear axes at one share of the block and the rotary ones at another.
    fn at(&self, linear: f64, rotary: f64) -> Positions {
        let [from, to] = &self.ends;
        let mut at = Positions::default();
        for (k, axis) in self.machine.axes().iter().enumerate() {
            let share = if axis.joint == Joint::Linear { linear } else { rotary };
            at[k] = from[k] + share * (to[k] - from[k]);
        }
        at
    }

    fn distance(&self, linear: f64, rotary: f64, enough: f64) -> f64 {
        let at = self.at(linear, rotary);
        let [a, b] = self.bodies.map(|carried| {
            let pose = self.machine.carried(&carried.carriers, &at);
            carried.body.moved(pose.rotation(), pose.translation())
        });
        a.distance(&b, enough)
    }

    /// What linear axes and what rotary axes move any point of a body by over the block at most, of both bodies together, mm.
    fn ways(&self) -> [f64; 2] {
        let [from, to] = &self.ends;
        let of = |carried: &&Carried| {
            let linear = carried.carriers.iter().filter(|&&k| self.machine.axes()[k].joint == Joint::Linear);
            let linear: f64 = linear.map(|&k| (to[k] - from[k]).abs()).sum();
            [linear, self.machine.way_by_turning(&carried.carriers, &carried.body, [from, to])]
        };
        self.bodies.iter().map(of).fold([0.0; 2], |sum, way| [sum[0] + way[0], sum[1] + way[1]])
    }

    /// Distance in the middle of a part of the block, and what it cannot be less than anywhere in that part.
    ///
    /// While only linear axes move, the distance of convex bodies is a convex function of the share: three values of it bound it from below.
    /// What rotary axes do beside that is bounded by how far they move any point.
    fn part(&self, [first, last]: [f64; 2], turning: f64) -> [f64; 2] {
        let (middle, half) = (0.5 * (first + last), 0.5 * (last - first));
        let at = self.distance(middle, middle, f64::INFINITY);
        // Beyond twice the value of the middle an end bounds nothing.
        let ends = [first, last].map(|share| self.distance(share, middle, 2.0 * at));
        let convex = ends.iter().fold(at, |bound, end| bound.min(2.0 * at - end));
        [at, convex - turning * half]
    }

    /// The least distance over the block, mm, above it by [`HIDDEN`] at most; infinite where it is not below `enough`.
    fn least(&self, enough: f64) -> f64 {
        let [linear, turning] = self.ways();
        let far = enough + 0.5 * (linear + turning);
        if far.is_finite() && self.distance(0.5, 0.5, far) >= far {
            return f64::INFINITY;
        }
        // Where the block is nearest at an end, this says so at once and exactly.
        let ends = self.distance(0.0, 0.0, enough).min(self.distance(1.0, 1.0, enough));
        let inside = least_over(enough.min(ends), HIDDEN, |part, _| self.part(part, turning));
        let found = ends.min(inside);
        if found < enough { found } else { f64::INFINITY }
    }
}

/// Least distances over the texts of a task, one for each body; the nearest first.
///
/// # Errors
/// A text that cannot be followed; a place with less than is kept, with block, bodies and the key that says what stands there.
pub fn check(
    task: &ProgramTask<'_>,
    built: &Built,
    around: &Surroundings<'_>,
) -> Result<Vec<BodyClearance>, RunFailure> {
    let machine = &task.machine.machine;
    let mut least: Vec<BodyClearance> = Vec::new();
    for program in &built.programs {
        let refused = |error: MotionError| {
            let finding = Diagnostic::with_code(error.code(), format!("{}: {error}", program.file));
            RunFailure::not_producible(finding.field("machine").way_out(error.way_out()))
        };
        if around.pairs(program.station).is_empty() {
            continue;
        }
        let tracked = track(&program.read, machine, &program.words, &program.start).map_err(refused)?;
        let found = around.follow(&tracked, program.station);
        if let Some((_, field, fault)) = found.faults.into_iter().next() {
            let finding = Diagnostic::with_code(fault.code, format!("{}, {}", program.file, fault.text));
            let way_out = format!("{}; nothing was written", fault.way_out);
            return Err(RunFailure::not_producible(finding.field(field).way_out(way_out)));
        }
        for one in found.least {
            let one = BodyClearance { file: program.file.clone(), ..one };
            match least.iter_mut().find(|known| known.body == one.body) {
                Some(known) if known.least_mm <= one.least_mm => {}
                Some(known) => *known = one,
                None => least.push(one),
            }
        }
    }
    least.sort_by(|a, b| a.least_mm.total_cmp(&b.least_mm));
    Ok(least)
}
