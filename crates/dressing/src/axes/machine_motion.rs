//! A dressing motion in machine axes: their positions over the worm position v, where they reverse, what travel they need, and
//! what their uncertainty does to the worm flank (`docs/mathematics/dressing.md#axes-and-their-deviations`). One way is evaluated here; which way is best is decided in `machine_choice`.
//!
//! Kept for planning of the swivel while dressing: no command reaches it yet.

use crate::{DressedWorm, DressingError, WormContact};
use contact::ToolSurface;
use foundation::geometry::Flank;
use foundation::kinematics::{
    AxisTwist, DressingAxes, DressingAxis, DressingBranch, DressingMachine, DressingMotion, DressingPosition,
    DressingRule, LawError, MachineError, MotionLaw,
};
use foundation::numerics::{brent, equidistant, extremes};
use num_dual::Dual64;
use std::f64::consts::TAU;

/// Tolerance of a worm flank at (w_1, z_1), mm.
pub type WormTolerance<'a> = &'a (dyn Fn(Flank, f64, f64) -> f64 + Sync);

/// What an axis may stand off, and what it may miss where it reverses (backlash, friction peak): rad or mm, in the order of
/// [`DressingAxis::ALL`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxisUncertainty {
    /// Uncertainty of the position.
    pub position: [f64; 7],
    /// Uncertainty at a reversal.
    pub reversal: [f64; 7],
}

impl Default for AxisUncertainty {
    /// A good grinding machine: 1 um and 1 arcsec, the same at a reversal. The rotation of the dresser counts for nothing.
    fn default() -> Self {
        let of = |axis: DressingAxis| match axis {
            DressingAxis::Dresser => 0.0,
            axis if axis.is_rotary() => (1.0 / 3600.0f64).to_radians(),
            _ => 1e-3,
        };
        Self { position: DressingAxis::ALL.map(of), reversal: DressingAxis::ALL.map(of) }
    }
}

/// A dressing motion for which axis positions are wanted.
#[derive(Clone, Copy)]
pub struct MachineTask<'a> {
    /// The machine.
    pub machine: &'a DressingMachine,
    /// Pose of the dresser over v.
    pub motion: &'a DressingMotion,
    /// Worm positions v_zS of the stroke, mm.
    pub interval: [f64; 2],
    /// The flanks that the motion dresses.
    pub worms: &'a [&'a DressedWorm],
    /// Uncertainty of the axes.
    pub uncertainty: AxisUncertainty,
    /// Tolerance of the worm flank; without it every point counts alike, against 1 um.
    pub tolerance: Option<WormTolerance<'a>>,
}

/// How the axis that the poses leave free goes along the stroke.
#[derive(Clone, Debug, PartialEq)]
pub enum SwivelLaw {
    /// C5 over v, rad.
    Swivel(MotionLaw),
    /// Z1 over v, mm; C5 follows. At Z1 = 0 this is the chart without pole.
    AxialSlide(MotionLaw),
}

/// One way of driving a dressing motion.
#[derive(Clone, Debug, PartialEq)]
pub struct MachineWay {
    /// Side of the machine.
    pub branch: DressingBranch,
    /// Law of the free axis.
    pub law: SwivelLaw,
}

/// Positions and rates of all axes at one worm position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MachineRow {
    /// Worm position v_zS, mm.
    pub v: f64,
    /// Positions, full turns kept along the stroke: rad, mm.
    pub axes: DressingAxes,
    /// Rates by v: rad/mm, 1.
    pub rates: DressingAxes,
}

/// A place where an axis reverses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxisReversal {
    /// The axis.
    pub axis: DressingAxis,
    /// Worm position, mm.
    pub v: f64,
    /// Greatest trace that its uncertainty leaves on the worm along the contact there, mm.
    pub trace: f64,
    /// Greatest trace as a share of the tolerance there.
    pub share: f64,
}

/// A dressing motion in machine axes.
#[derive(Clone, Debug, PartialEq)]
pub struct MachineMotion {
    /// The way that is driven.
    pub way: MachineWay,
    /// Axes over v.
    pub rows: Vec<MachineRow>,
    /// Reversals in the order of v.
    pub reversals: Vec<AxisReversal>,
    /// Least distance of each axis to the ends of its travel, rad or mm; infinite without ends, negative beyond them.
    pub margins: [f64; 7],
    /// Greatest probable deviation of the worm flank from uncertain positions of all axes, mm (root of the sum of squares).
    pub deviation: f64,
    /// Greatest probable deviation as a share of the tolerance.
    pub deviation_share: f64,
}

impl MachineMotion {
    /// Least and greatest position of an axis, rad or mm.
    pub fn travel(&self, axis: DressingAxis) -> [f64; 2] {
        extremes(self.rows.iter().map(|row| row.axes.get(axis)))
    }

    /// One axis over v as a law: the spline through its positions.
    ///
    /// # Errors
    /// Those of [`MotionLaw::spline`].
    pub fn law(&self, axis: DressingAxis) -> Result<MotionLaw, LawError> {
        let [v, q] = [|row: &MachineRow, _| row.v, |row: &MachineRow, axis| row.axes.get(axis)].map(
            |of: fn(&MachineRow, DressingAxis) -> f64| {
                self.rows.iter().map(|row| of(row, axis)).collect::<Vec<_>>()
            },
        );
        MotionLaw::spline(&v, &q)
    }

    /// The largest share of the tolerance that a reversal takes; 0 without reversal.
    pub fn worst_reversal(&self) -> f64 {
        self.reversals.iter().map(|reversal| reversal.share).fold(0.0, f64::max)
    }

    /// The axis that stands nearest to (or furthest beyond) the end of its travel, with that distance; 1 rad counts as 100 mm.
    pub fn tightest(&self) -> (DressingAxis, f64) {
        let scaled = |axis: DressingAxis| comparable(axis, self.margins[axis as usize]);
        let tightest = DressingAxis::ALL.into_iter().min_by(|&a, &b| scaled(a).total_cmp(&scaled(b)));
        let axis = tightest.unwrap_or(DressingAxis::Worm);
        (axis, self.margins[axis as usize])
    }
}

/// A distance of an axis in one measure for turning and sliding, rad and 100 mm (`docs/mathematics/programs.md#from-bodies-to-axes`).
pub(crate) fn comparable(axis: DressingAxis, distance: f64) -> f64 {
    if axis.is_rotary() { distance } else { distance / 100.0 }
}

/// Rows of the table. Between two of them DK(v) of a modification along the worm bends at most once.
const ROWS: usize = 65;
/// Contacts looked at along the line in which the dresser touches a flank.
const CONTACTS: usize = 5;
/// An axis that moves by less than this over the stroke stands still, rad or mm: rounding of its closed form.
const STANDS_STILL: f64 = 1e-9;
/// Tolerance against which traces are weighed where none is given, mm.
const EVEN_TOLERANCE: f64 = 1e-3;

/// A contact with the tolerance of its place.
#[derive(Clone, Copy, Debug)]
struct Place {
    contact: WormContact,
    tolerance: f64,
}

/// What all ways have in common: poses with their rates and the contacts along the stroke.
pub(crate) struct PreparedTask<'a> {
    task: &'a MachineTask<'a>,
    v: Vec<f64>,
    positions: Vec<DressingPosition<Dual64>>,
    places: Vec<Vec<Place>>,
}

impl<'a> PreparedTask<'a> {
    /// # Errors
    /// [`DressingError::InvalidNumber`] for the interval, a tolerance or an uncertainty; [`DressingError::NoContact`] where
    /// the dresser does not touch.
    pub fn new(task: &'a MachineTask<'a>) -> Result<Self, DressingError> {
        let [from, to] = task.interval;
        let invalid = |field, value, allowed| Err(DressingError::InvalidNumber { field, value, allowed });
        if !(from.is_finite() && to.is_finite() && to > from) {
            return invalid("end of the dressing stroke", to, "finite and above its start");
        }
        let uncertainty = &task.uncertainty;
        for value in uncertainty.position.into_iter().chain(uncertainty.reversal) {
            if !(value.is_finite() && value >= 0.0) {
                return invalid("uncertainty of an axis", value, "0 or more");
            }
        }
        let v = equidistant(task.interval, ROWS);
        let moving = |&v: &f64| task.motion.position(Dual64::from_re(v).derivative());
        let positions = v.iter().map(moving).collect();
        let places = v.iter().map(|&v| places(task, v)).collect::<Result<_, _>>()?;
        Ok(Self { task, v, positions, places })
    }

    /// Least |gamma| of the stroke, rad: how far the dresser can be swivelled.
    pub fn reach(&self) -> f64 {
        self.positions.iter().map(|at| at.crossing_angle.re.abs()).fold(f64::INFINITY, f64::min)
    }

    /// Positions of all axes along the stroke when it is driven this way.
    ///
    /// # Errors
    /// Those of [`DressingMachine::axes`]; [`MachineError::Unreachable`] where this branch ends.
    pub fn drive(&self, way: &MachineWay) -> Result<MachineMotion, DressingError> {
        let mut rows: Vec<MachineRow> = Vec::with_capacity(ROWS);
        for (&v, position) in self.v.iter().zip(&self.positions) {
            rows.push(self.row(way, v, position, rows.last())?);
        }
        let reversals = self.reversals(way, &rows)?;
        let margins = DressingAxis::ALL.map(|axis| {
            let margin = |row: &MachineRow| self.task.machine.margin(axis, row.axes.get(axis));
            rows.iter().map(margin).fold(f64::INFINITY, f64::min)
        });
        let (mut deviation, mut deviation_share) = (0.0f64, 0.0f64);
        for (row, places) in rows.iter().zip(&self.places) {
            let twists = row.axes.twists();
            for place in places {
                let influence = place.contact.influence(&twists);
                let squares =
                    influence.iter().zip(&self.task.uncertainty.position).map(|(s, u)| (s * u).powi(2));
                let probable = squares.sum::<f64>().sqrt();
                deviation = deviation.max(probable);
                deviation_share = deviation_share.max(probable / place.tolerance);
            }
        }
        Ok(MachineMotion { way: way.clone(), rows, reversals, margins, deviation, deviation_share })
    }

    /// One row, its angles in the turn of the row before it.
    fn row(
        &self,
        way: &MachineWay,
        v: f64,
        position: &DressingPosition<Dual64>,
        before: Option<&MachineRow>,
    ) -> Result<MachineRow, MachineError> {
        let at = Dual64::from_re(v).derivative();
        let rule = match &way.law {
            SwivelLaw::Swivel(law) => DressingRule::Swivel(law.lifted(at)[0]),
            SwivelLaw::AxialSlide(law) => DressingRule::AxialSlide(law.lifted(at)[0]),
        };
        // At gamma = 0 the worm angle that the swivel leaves free is that of the pose.
        let solutions = self.task.machine.axes(position, rule, Some(position.worm_angle))?;
        // Distance of the worm's turn against the pose from that of the row before: the full turns of the screw are in both.
        let turn = |worm: f64, phi: f64| worm - phi;
        let here = position.worm_angle.re;
        let wanted = before.map(|row| turn(row.axes.worm, self.task.motion.position(row.v).worm_angle));
        let off = |worm: f64| match wanted {
            Some(wanted) => {
                let apart = turn(worm, here) - wanted;
                (apart - TAU * (apart / TAU).round()).abs()
            }
            None => 0.0,
        };
        let found = solutions
            .into_iter()
            .filter(|solution| before.is_some() || solution.branch == way.branch)
            .min_by(|a, b| off(a.axes.worm.re).total_cmp(&off(b.axes.worm.re)))
            .ok_or(MachineError::PoleOfChart)?;
        let mut axes = DressingAxes::from_values(found.axes.values().map(|x| x.re));
        let rates = DressingAxes::from_values(found.axes.values().map(|x| x.eps));
        if let Some(before) = before {
            let nearest = |x: f64, wanted: f64| x - TAU * ((x - wanted) / TAU).round();
            axes.worm = here + nearest(turn(axes.worm, here), wanted.unwrap_or(0.0));
            axes.dresser = nearest(axes.dresser, before.axes.dresser);
        }
        if rates.values().iter().any(|rate| !rate.is_finite()) {
            let value = axes.swivel.to_degrees();
            let limit = position.crossing_angle.re.abs().to_degrees();
            return Err(MachineError::Unreachable {
                axis: "C5 (deg)",
                value,
                least: -limit,
                greatest: limit,
            });
        }
        Ok(MachineRow { v, axes, rates })
    }

    /// Reversals of all axes but the rotation of the dresser, which is added to a spindle that turns anyway.
    fn reversals(&self, way: &MachineWay, rows: &[MachineRow]) -> Result<Vec<AxisReversal>, DressingError> {
        let mut found = Vec::new();
        for axis in DressingAxis::ALL.into_iter().filter(|&axis| axis != DressingAxis::Dresser) {
            let [low, high] = extremes(rows.iter().map(|row| row.axes.get(axis)));
            if high - low < STANDS_STILL {
                continue;
            }
            // Rates below the rounding of the whole way are none.
            let still = STANDS_STILL / (self.v[ROWS - 1] - self.v[0]);
            let moving: Vec<&MachineRow> =
                rows.iter().filter(|row| row.rates.get(axis).abs() > still).collect();
            for pair in moving.windows(2) {
                let rates = [pair[0].rates.get(axis), pair[1].rates.get(axis)];
                if (rates[0] > 0.0) == (rates[1] > 0.0) {
                    continue;
                }
                let rate = |v: f64| {
                    let position = self.task.motion.position(Dual64::from_re(v).derivative());
                    self.row(way, v, &position, Some(pair[0])).ok().map(|row| row.rates.get(axis))
                };
                let Some(v) = brent([pair[0].v, pair[1].v], rates, 1e-9, rate) else { continue };
                let position = self.task.motion.position(Dual64::from_re(v).derivative());
                let row = self.row(way, v, &position, Some(pair[0]))?;
                found.push(self.reversal(axis, &row)?);
            }
        }
        found.sort_by(|a, b| a.v.total_cmp(&b.v));
        Ok(found)
    }

    fn reversal(&self, axis: DressingAxis, row: &MachineRow) -> Result<AxisReversal, DressingError> {
        let twists: [AxisTwist; 7] = row.axes.twists();
        let uncertain = self.task.uncertainty.reversal[axis as usize];
        let (mut trace, mut share) = (0.0f64, 0.0f64);
        for place in places(self.task, row.v)? {
            let here = (place.contact.influence(&twists)[axis as usize] * uncertain).abs();
            trace = trace.max(here);
            share = share.max(here / place.tolerance);
        }
        Ok(AxisReversal { axis, v: row.v, trace, share })
    }
}

/// Contacts of all flanks at a worm position.
fn places(task: &MachineTask<'_>, v: f64) -> Result<Vec<Place>, DressingError> {
    let mut places = Vec::with_capacity(task.worms.len() * CONTACTS);
    for worm in task.worms {
        let (flank, range) = (worm.flank(), worm.range());
        for w in equidistant([range.w_nf, range.w_na], CONTACTS) {
            let (t, _) = worm.start(w, 0.0);
            let none = DressingError::NoContact { flank: flank.flank, t };
            let jet = worm.jet(t, v).ok_or(none)?;
            let foot = flank.deviation(&jet.p);
            let tolerance = match task.tolerance {
                Some(tolerance) => tolerance(flank.flank, foot.w, foot.z),
                None => EVEN_TOLERANCE,
            };
            if !(tolerance.is_finite() && tolerance > 0.0) {
                return Err(DressingError::InvalidNumber {
                    field: "tolerance of the worm flank",
                    value: tolerance,
                    allowed: "> 0 and finite",
                });
            }
            let nominal = flank.normal(foot.w, foot.z);
            places.push(Place { contact: WormContact { point: jet.p, normal: jet.n, nominal }, tolerance });
        }
    }
    Ok(places)
}
