//! Which way a dressing motion is driven on the machine: side, and the law of the axis that the poses leave free
//! (`docs/mathematics/dressing.md#axes-and-their-deviations`). Ways are evaluated in `machine_motion`.
//!
//! Kept for planning of the swivel while dressing: no command reaches it yet.

use crate::axes::machine_motion::{PreparedTask, comparable};
use crate::{DressingError, MachineMotion, MachineTask, MachineWay, SwivelLaw};
use foundation::kinematics::{DressingAxis, DressingBranch, MachineError, MotionLaw};
use foundation::numerics::equidistant;
use rayon::prelude::*;

/// What the choice is after. Travel is kept in every case; what is left equal is decided by the other criteria.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AxisCriterion {
    /// Uncertain positions of the axes deviate the worm flank as little as possible.
    SmallestDeviation,
    /// No axis reverses; where that cannot be had, reversals leave as little of the tolerance as possible.
    NoReversal,
    /// The axes stay as far from the ends of their travel as possible.
    WidestTravel,
}

/// What may be chosen.
#[derive(Clone, Debug, PartialEq)]
pub enum SwivelChoice {
    /// Straight laws C5(v), and Z1 = 0.
    Free,
    /// This law; only the side is chosen.
    Given(SwivelLaw),
}

/// The way chosen and why.
#[derive(Clone, Debug, PartialEq)]
pub struct MachineChoice {
    /// The motion in axes.
    pub motion: MachineMotion,
    /// How many ways were looked at, and how many of them the machine can drive.
    pub ways: [usize; 2],
    /// The reason in words.
    pub reason: String,
}

/// Swivels and slopes of the scan.
const SCAN: [usize; 2] = [17, 9];
/// Share of the reach over which swivels are tried: at the reach itself both sides meet and the axes run away.
const REACH: f64 = 0.95;
/// Halvings of the step of the scan in the search round its best way.
const HALVINGS: usize = 6;
/// Two figures of merit are equal up to this share.
const EQUAL: f64 = 1e-6;

/// What a way is judged by, the smaller the better, in the order of the criterion.
type Merit = [f64; 4];

impl MachineTask<'_> {
    /// Positions of all axes for one way.
    ///
    /// # Errors
    /// [`DressingError::InvalidNumber`], [`DressingError::NoContact`] and those of the machine. Travel is not enforced.
    pub fn drive(&self, way: &MachineWay) -> Result<MachineMotion, DressingError> {
        PreparedTask::new(self)?.drive(way)
    }

    /// The best way by the criterion.
    ///
    /// # Errors
    /// As [`MachineTask::drive`] if no way can be driven at all; [`MachineError::AxisLimit`] of the way that stands least
    /// beyond its travel if all of them do.
    pub fn choose(
        &self,
        criterion: AxisCriterion,
        swivel: &SwivelChoice,
        branch: Option<DressingBranch>,
    ) -> Result<MachineChoice, DressingError> {
        let prepared = PreparedTask::new(self)?;
        let branches: Vec<DressingBranch> =
            DressingBranch::BOTH.into_iter().filter(|b| branch.is_none_or(|wanted| wanted == *b)).collect();
        let search = Search { task: self, prepared, criterion };
        let mut ways: Vec<Candidate> = Vec::new();
        match swivel {
            SwivelChoice::Given(law) => ways.extend(
                branches.iter().map(|&branch| Candidate::Law(MachineWay { branch, law: law.clone() })),
            ),
            SwivelChoice::Free => {
                let [swivels, slopes] = if self.machine.swivel { SCAN } else { [1, 1] };
                for &branch in &branches {
                    for middle in spread(swivels) {
                        for slope in spread(slopes) {
                            ways.push(Candidate::Straight { branch, middle, slope });
                        }
                    }
                    if self.machine.swivel {
                        let law = SwivelLaw::AxialSlide(MotionLaw::zero());
                        ways.push(Candidate::Law(MachineWay { branch, law }));
                    }
                }
            }
        }
        search.best(ways)
    }
}

/// A way of the scan: mean swivel and swivel gained from the middle to the end, as shares of the reach.
#[derive(Clone, Debug)]
enum Candidate {
    Straight { branch: DressingBranch, middle: f64, slope: f64 },
    Law(MachineWay),
}

/// Odd numbers of shares from -1 to 1 with 0 first: among equals the machine is not swivelled.
fn spread(count: usize) -> Vec<f64> {
    let mut shares = if count < 2 { vec![0.0] } else { equidistant([-1.0, 1.0], count) };
    shares.sort_by(|a, b| a.abs().total_cmp(&b.abs()).then(b.total_cmp(a)));
    shares
}

struct Search<'a> {
    task: &'a MachineTask<'a>,
    prepared: PreparedTask<'a>,
    criterion: AxisCriterion,
}

impl Search<'_> {
    fn way(&self, candidate: &Candidate) -> MachineWay {
        match candidate {
            Candidate::Law(way) => way.clone(),
            Candidate::Straight { branch, middle, slope } => {
                let reach = REACH * self.prepared.reach();
                let [from, to] = self.task.interval;
                let (centre, half) = (0.5 * (from + to), 0.5 * (to - from));
                let law = MotionLaw::polynomial(centre, vec![middle * reach, slope * reach / half]);
                MachineWay { branch: *branch, law: SwivelLaw::Swivel(law) }
            }
        }
    }

    fn drive(&self, candidate: &Candidate) -> Option<Result<(Merit, MachineMotion), DressingError>> {
        if let Candidate::Straight { middle, slope, .. } = candidate
            && middle.abs() + slope.abs() > 1.0
        {
            return None;
        }
        Some(self.prepared.drive(&self.way(candidate)).map(|motion| (self.merit(&motion), motion)))
    }

    fn merit(&self, motion: &MachineMotion) -> Merit {
        let (axis, margin) = motion.tightest();
        let room = -comparable(axis, margin);
        // Rounding beyond an end of travel is none.
        let beyond = (room - 1e-9).max(0.0);
        let (deviation, reversal) = (motion.deviation_share, motion.worst_reversal());
        match self.criterion {
            AxisCriterion::SmallestDeviation => [beyond, deviation, reversal, room],
            AxisCriterion::NoReversal => [beyond, reversal, deviation, room],
            AxisCriterion::WidestTravel => [beyond, room, reversal, deviation],
        }
    }

    fn best(&self, candidates: Vec<Candidate>) -> Result<MachineChoice, DressingError> {
        let driven: Vec<_> = candidates
            .into_par_iter()
            .filter_map(|candidate| self.drive(&candidate).map(|result| (candidate, result)))
            .collect();
        let looked_at = driven.len();
        let mut refused: Option<DressingError> = None;
        let mut drivable = 0;
        let mut best: Option<(Merit, Candidate, MachineMotion)> = None;
        for (candidate, result) in driven {
            match result {
                Ok((merit, motion)) => {
                    drivable += usize::from(merit[0] == 0.0);
                    if best.as_ref().is_none_or(|(other, ..)| better(&merit, other)) {
                        best = Some((merit, candidate, motion));
                    }
                }
                Err(error) => refused = refused.or(Some(error)),
            }
        }
        let Some((mut merit, mut candidate, mut motion)) = best else {
            return Err(refused.unwrap_or(DressingError::Machine(MachineError::PoleOfChart)));
        };
        // Steps towards better neighbours of the best straight law.
        let mut step = SCAN.map(|count| 1.0 / (count - 1) as f64);
        for _ in 0..HALVINGS {
            while let Candidate::Straight { branch, middle, slope } = candidate.clone()
                && self.task.machine.swivel
            {
                let around = [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)].map(|(a, b)| {
                    Candidate::Straight { branch, middle: middle + a * step[0], slope: slope + b * step[1] }
                });
                let next = around.into_iter().filter_map(|c| Some((self.drive(&c)?.ok()?, c))).fold(
                    None::<((Merit, MachineMotion), Candidate)>,
                    |held, new| match held {
                        Some(held) if !better(&new.0.0, &held.0.0) => Some(held),
                        _ => Some(new),
                    },
                );
                match next {
                    Some(((m, driven), c)) if better(&m, &merit) => {
                        (merit, candidate, motion) = (m, c, driven)
                    }
                    _ => break,
                }
            }
            step = step.map(|s| 0.5 * s);
        }
        if merit[0] > 0.0 {
            let (axis, margin) = motion.tightest();
            return Err(self.task.machine.limit(axis, -margin).into());
        }
        let reason = self.reason(&motion, [looked_at, drivable]);
        Ok(MachineChoice { motion, ways: [looked_at, drivable], reason })
    }

    fn reason(&self, motion: &MachineMotion, [looked_at, drivable]: [usize; 2]) -> String {
        let wanted = match self.criterion {
            AxisCriterion::SmallestDeviation => "smallest deviation of the worm flank by uncertain axes",
            AxisCriterion::NoReversal if motion.reversals.is_empty() => "no axis reverses",
            AxisCriterion::NoReversal => "reversals take the least of the tolerance",
            AxisCriterion::WidestTravel => "widest distance to the ends of travel",
        };
        let side = match motion.way.branch {
            DressingBranch::Direct => "direct side",
            DressingBranch::Turned => "turned side",
        };
        let [low, high] = motion.travel(DressingAxis::Swivel).map(f64::to_degrees);
        let swivel = match (&motion.way.law, high - low < 1e-9) {
            (SwivelLaw::AxialSlide(_), _) => format!("C5 {low:.3} .. {high:.3} deg as the axial slide asks"),
            (_, true) => format!("C5 at {high:.3} deg"),
            (_, false) => format!("C5 {low:.3} .. {high:.3} deg"),
        };
        let reversals = match motion.reversals.len() {
            0 => "without reversal".to_owned(),
            count => {
                let um = motion.reversals.iter().map(|r| r.trace).fold(0.0, f64::max) * 1e3;
                format!("{count} reversals, worst trace {um:.3} um")
            }
        };
        let travel = match motion.tightest() {
            (_, margin) if margin.is_infinite() => "no end of travel given".to_owned(),
            (axis, margin) => {
                format!(
                    "{} {:.3} {} from the end of its travel",
                    axis.name(),
                    axis.shown(margin),
                    axis.unit()
                )
            }
        };
        format!(
            "{wanted}: {side}, {swivel}; probable deviation {:.3} um, {reversals}, {travel}; {looked_at} ways looked at, \
             {drivable} within travel",
            motion.deviation * 1e3
        )
    }
}

/// Whether a merit beats another one: the first figure that differs decides.
fn better(a: &Merit, b: &Merit) -> bool {
    for (x, y) in a.iter().zip(b) {
        // Equal infinities (no ends of travel) differ by nothing.
        if x != y && (x - y).abs() > EQUAL * (x.abs() + y.abs()) {
            return x < y;
        }
    }
    false
}
