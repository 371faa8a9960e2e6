//! The electronic gearbox of a pass: which axes lead the workpiece and by how much, and a table for what is not linear.

use super::{LayoutOptions, Pass, STANDS_STILL, WorkGear};
use crate::path::AxisPath;
use crate::{AxisWords, Course, MotionError};
use foundation::numerics::CubicSpline;
use machine::{Joint, Machine, Positions, Role};
use nc::{
    Block, Coupling, CubicSpan, CurveTable, Gear, GearLeader, GearSynchronisation, Repetition, TablePiece,
    Word,
};

/// The gear of a pass.
pub(super) struct GearBlocks {
    gear: Gear,
    /// A table that has to stand before.
    pub table: Option<CurveTable>,
    /// Number of the follower in the machine.
    pub follower: usize,
    /// Its place in the program.
    pub word: usize,
    /// Numbers of the leaders in the machine.
    leaders: Vec<usize>,
    /// What the gear misses the paths by, seen on the flank, mm.
    pub deviation: f64,
}

impl GearBlocks {
    /// Defines the gear and switches it on where the axes stand.
    pub fn engage(&self, machine: &Machine, at: &Positions) -> [Block; 2] {
        let counted = |axis: usize| machine.axes()[axis].nc_sign * at[axis];
        let positions = GearSynchronisation {
            follower: counted(self.follower),
            leaders: self.leaders.iter().map(|&axis| counted(axis)).collect(),
        };
        [
            Block::GearDefine(Box::new(self.gear.clone())),
            Block::GearOn { follower: self.word, synchronisation: Some(Box::new(positions)) },
        ]
    }
}

impl GearBlocks {
    /// By how much the gear turns the workpiece from one place to another, rad.
    fn turned(&self, machine: &Machine, from: &Positions, to: &Positions) -> f64 {
        let counted = |axis: usize, at: &Positions| machine.axes()[axis].nc_sign * at[axis];
        let led = |(leader, &axis): (&GearLeader, &usize)| {
            let (begun, now) = (counted(axis, from), counted(axis, to));
            match &leader.coupling {
                Coupling::Ratio { num, den } => num / den * (now - begun),
                Coupling::Table(_) => {
                    self.table.as_ref().map_or(0.0, |table| table.value(now) - table.value(begun))
                }
            }
        };
        let sum: f64 = self.gear.leaders.iter().zip(&self.leaders).map(led).sum();
        machine.axes()[self.follower].nc_sign * sum
    }

    /// Lets the workpiece stand along infeed or retraction where the gear has it if it is right at `anchor`, the end of the stroke
    /// there. On conical bodies the way off the tool moves slides that lead: the workpiece follows them.
    pub fn settle(&self, machine: &Machine, path: &mut AxisPath, anchor: &Positions) {
        for (_, at) in &mut path.nodes {
            let wanted = anchor[self.follower] + self.turned(machine, anchor, at);
            if (wanted - at[self.follower]).abs() > STANDS_STILL {
                at[self.follower] = wanted;
            }
        }
    }
}

/// Normal deviation of the flank per turning of the workpiece, mm/rad.
fn per_turn(course: &Course) -> f64 {
    match course {
        Course::Grinding(course) => course.per_turn,
        Course::Dressing(_) | Course::Line(_) => 1.0,
    }
}

/// A gear that moves the flank by less than this over a stroke has the ratio zero, mm.
const NO_WAY: f64 = 1e-9;
/// Intervals of a table at first, and at the most.
const INTERVALS: [usize; 2] = [8, 4096];

/// The gear that keeps the workpiece on the paths of a pass.
pub(super) fn couple(
    machine: &Machine,
    words: &AxisWords,
    gear: &WorkGear,
    pass: &Pass,
    paths: [&AxisPath; 3],
    options: &LayoutOptions,
    tables: &mut u32,
) -> Result<GearBlocks, MotionError> {
    let unsupported = |reason: String| Err(MotionError::UnsupportedCoupling { reason });
    let rates = machine.gearbox(&gear.coupling, pass.course.mounts())?;
    let [worm, work, axial] = [Role::Worm, Role::Work, Role::Axial].map(|role| machine.needed(role));
    let (worm, work, axial) = (worm?, work?, axial?);
    let shift = machine.role(Role::Shift).or(machine.role(Role::Tangential));
    if let Some(tilt) = machine.role(Role::Tilt)
        && paths.iter().any(|path| path.range(tilt) > STANDS_STILL)
    {
        return unsupported(format!(
            "{} moves: the ratios of the gearbox hold for one tilt",
            machine.axes()[tilt].name
        ));
    }
    if words.place(worm).is_some_and(|k| matches!(words.words[k].word, Word::Spindle(_))) {
        let name = &machine.axes()[worm].name;
        return unsupported(format!(
            "{name} is a spindle: where it stands is not in the text, so that its phase cannot be proven"
        ));
    }
    let place = |axis: usize| {
        words.place(axis).ok_or_else(|| MotionError::NoWord {
            axis: machine.axes()[axis].name.clone(),
            travel: machine.axes()[axis].joint.shown(paths[1].range(axis)),
            unit: machine.axes()[axis].joint.unit(),
        })
    };
    // In the control's counts.
    let sense = |axis: usize| machine.axes()[axis].nc_sign;
    let signed = |rate: f64, leader: usize| rate * sense(work) * sense(leader);
    let numerator = signed(f64::from(rates.worm_numerator), worm);
    let mut leaders = vec![GearLeader {
        axis: place(worm)?,
        coupling: Coupling::Ratio { num: numerator, den: f64::from(rates.worm_denominator) },
    }];
    let mut numbers = vec![worm];
    let shifting = shift.filter(|&axis| paths.iter().any(|path| path.range(axis) > STANDS_STILL));
    // What the worm and the shift do not explain belongs to the axial slide.
    let Some(&(_, first)) = paths[1].nodes.first() else {
        return unsupported("the stroke has no way".into());
    };
    let rest = |at: &Positions| {
        let by_shift = shifting.map_or(0.0, |axis| rates.shift * (at[axis] - first[axis]));
        at[work] - first[work] - rates.worm() * (at[worm] - first[worm]) - by_shift
    };
    let per_turn = per_turn(&pass.course);
    // A lead correction belongs to the lead; what is left over of a straight line has to be seen on the flank to need a table.
    let Some(&(_, last)) = paths[1].nodes.last() else { return unsupported("the stroke has no way".into()) };
    let swept = last[axial] - first[axial];
    let lead = if swept.abs() > STANDS_STILL { rest(&last) / swept } else { rates.axial };
    // The lead of a spur gear is none: what rounding leaves of it turns the workpiece by nothing and is no ratio that a control takes.
    let lead = if (lead * swept).abs() * per_turn < NO_WAY { 0.0 } else { lead };
    let bent = |at: &Positions| (rest(at) - lead * (at[axial] - first[axial])).abs() * per_turn;
    // Infeed and retraction follow the gear from and to the ends of the stroke: [`GearBlocks::settle`].
    let deviation = paths[1].nodes.iter().map(|(_, at)| bent(at)).fold(0.0, f64::max);
    let moves_axially = paths[1].range(axial) > STANDS_STILL;
    let mut table = None;
    if deviation <= options.tolerance {
        if moves_axially {
            // Numerator and denominator in degrees and mm, as controls show them.
            let lead = signed(lead, axial);
            leaders
                .push(GearLeader { axis: place(axial)?, coupling: Coupling::Ratio { num: lead, den: 1.0 } });
            numbers.push(axial);
        }
    } else if moves_axially {
        *tables += 1;
        let made = table_of(
            machine,
            pass,
            options,
            [work, axial],
            &rest,
            paths[1],
            *tables,
            [place(work)?, place(axial)?],
        )?;
        leaders.push(GearLeader { axis: made.leader, coupling: Coupling::Table(made.id) });
        numbers.push(axial);
        table = Some(made);
    } else {
        return unsupported("the workpiece has to move by itself while the axial slide stands".into());
    }
    if let Some(axis) = shifting {
        let moved = rates.shift * paths[1].range(axis) * per_turn;
        let ratio = if moved.abs() < NO_WAY { 0.0 } else { signed(rates.shift, axis) };
        let coupling = Coupling::Ratio { num: ratio, den: 1.0 };
        leaders.push(GearLeader { axis: place(axis)?, coupling });
        numbers.push(axis);
    }
    if let Some(&other) = numbers.iter().find(|axis| !gear.leaders.is_empty() && !gear.leaders.contains(axis))
    {
        return unsupported(format!(
            "{} would have to lead and is not among its leaders",
            machine.axes()[other].name
        ));
    }
    let table_made = table.is_some();
    let word = place(work)?;
    Ok(GearBlocks {
        gear: Gear { follower: word, leaders, teeth: None },
        table,
        follower: work,
        word,
        leaders: numbers,
        deviation: if table_made { options.tolerance } else { deviation },
    })
}

/// Lead and correction of the workpiece over the axial slide as cubics, from the path driven at many places.
#[expect(clippy::too_many_arguments, reason = "one table of one pass")]
fn table_of(
    machine: &Machine,
    pass: &Pass,
    options: &LayoutOptions,
    [work, axial]: [usize; 2],
    rest: &impl Fn(&Positions) -> f64,
    stroke: &AxisPath,
    id: u32,
    [follower, leader]: [usize; 2],
) -> Result<CurveTable, MotionError> {
    use crate::Waypoint;
    use crate::drive::Drive;
    let per_turn = per_turn(&pass.course);
    let (Some(&(begin, start)), Some(&(end, _))) = (stroke.nodes.first(), stroke.nodes.last()) else {
        return Err(MotionError::UnsupportedCoupling { reason: "the stroke has no way".into() });
    };
    let (sense_work, sense_axial) = (machine.axes()[work].nc_sign, machine.axes()[axial].nc_sign);
    debug_assert!(machine.axes()[axial].joint == Joint::Linear);
    let mut intervals = INTERVALS[0];
    loop {
        // Every other place is a node, those between are compared.
        let count = 2 * intervals;
        let mut drive = Drive::new(machine, &pass.course, &pass.name, options.swivel);
        let mut leaders = Vec::with_capacity(count + 1);
        let mut followers = Vec::with_capacity(count + 1);
        let mut first = None;
        for k in 0..=count {
            let v = begin.v + (end.v - begin.v) * k as f64 / count as f64;
            let at = drive.stand(&Waypoint { v, ..Waypoint::default() })?;
            let zero = *first.get_or_insert(rest(&at));
            leaders.push(sense_axial * at[axial]);
            followers.push(sense_work * (rest(&at) - zero + rest(&start)));
        }
        let sign = (leaders[count] - leaders[0]).signum();
        if leaders.windows(2).any(|pair| (pair[1] - pair[0]) * sign <= 0.0) {
            return Err(MotionError::UnsupportedCoupling {
                reason: "the axial slide turns back within the stroke".into(),
            });
        }
        let nodes = |values: &[f64]| -> Vec<f64> { values.iter().step_by(2).copied().collect() };
        // Splines want ascending places.
        let ordered = |mut values: Vec<f64>| {
            if sign < 0.0 {
                values.reverse();
            }
            values
        };
        let (x, y) = (ordered(nodes(&leaders)), ordered(nodes(&followers)));
        let spline = CubicSpline::new(&x, &y)
            .map_err(|error| MotionError::UnsupportedCoupling { reason: error.to_string() })?;
        let miss = (0..intervals)
            .map(|k| (spline.value(leaders[2 * k + 1]) - followers[2 * k + 1]).abs() * per_turn)
            .fold(0.0, f64::max);
        if miss <= options.tolerance {
            let pieces = (0..intervals)
                .map(|k| {
                    let (from, to) = (leaders[2 * k], leaders[2 * k + 2]);
                    let slope = |at: f64| spline.derivatives(at)[1] * (to - from);
                    let span = CubicSpan {
                        end: followers[2 * k + 2],
                        start_slope: slope(from),
                        end_slope: slope(to),
                    };
                    TablePiece { leader: to, follower: span }
                })
                .collect();
            let start = [leaders[0], followers[0]];
            return Ok(CurveTable { id, follower, leader, start, pieces, repetition: Repetition::Held });
        }
        intervals *= 2;
        if intervals > INTERVALS[1] {
            return Err(MotionError::ToleranceNotReached {
                stroke: pass.name.clone(),
                pieces: intervals,
                deviation_um: miss * 1e3,
                tolerance_um: options.tolerance * 1e3,
            });
        }
    }
}
