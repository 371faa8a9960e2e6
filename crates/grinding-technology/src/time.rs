//! How long strokes, infeeds and dressing take on given axes: moves from rest to rest in seven phases, as programs drive them.

use super::error::{in_range, positive};
use super::{Bodies, Cycle, DressingTechnology, ShiftRatios, StrokeFigures, TechnologyError};
use motion::SCurve;

/// Limits of an axis; mm or deg, and s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis {
    /// Greatest speed.
    pub speed: f64,
    /// Greatest acceleration.
    pub acceleration: f64,
    /// Greatest jerk.
    pub jerk: f64,
}

/// Limits of the axes that a stroke moves: infeed X, axial feed Z, shift V (mm); worm B, workpiece C (deg).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axes {
    /// Infeed.
    pub x: Axis,
    /// Axial feed.
    pub z: Axis,
    /// Shift.
    pub v: Axis,
    /// Worm.
    pub b: Axis,
    /// Workpiece.
    pub c: Axis,
}

/// Limits along a path.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Along {
    speed: f64,
    acceleration: f64,
    jerk: f64,
}

/// Long enough that any speed is reached.
const LONG: f64 = (1_u64 << 40) as f64;

impl Along {
    /// A path whose axes move by so much per mm, wanted at a speed.
    fn new(wanted: f64, moves: &[(Axis, f64)]) -> Self {
        let start = Self { speed: wanted, acceleration: f64::INFINITY, jerk: f64::INFINITY };
        moves.iter().filter(|(_, by)| *by != 0.0).fold(start, |along, (axis, by)| Self {
            speed: along.speed.min(axis.speed / by.abs()),
            acceleration: along.acceleration.min(axis.acceleration / by.abs()),
            jerk: along.jerk.min(axis.jerk / by.abs()),
        })
    }

    /// Time from rest to rest over a length.
    fn rest_to_rest(&self, length: f64) -> f64 {
        SCurve::new(length, self.speed, self.acceleration, self.jerk).duration()
    }

    /// Time of getting up to speed and down again, less what the same way takes at speed.
    fn ramp(&self) -> f64 {
        SCurve::new(LONG, self.speed, self.acceleration, self.jerk).ramp_time()
    }
}

impl Axis {
    fn rest_to_rest(&self, length: f64) -> f64 {
        Along { speed: self.speed, acceleration: self.acceleration, jerk: self.jerk }.rest_to_rest(length)
    }
}

impl Axes {
    /// Checks every number.
    ///
    /// # Errors
    /// `OutOfRange`.
    pub fn check(&self) -> Result<(), TechnologyError> {
        for (name, axis) in [("X", self.x), ("Z", self.z), ("V", self.v), ("B", self.b), ("C", self.c)] {
            for (what, value) in
                [("speed", axis.speed), ("acceleration", axis.acceleration), ("jerk", axis.jerk)]
            {
                positive(&format!("axes.{name}.{what}"), value)?;
            }
        }
        Ok(())
    }

    /// Time in which the axial slide goes back over a way (mm) from rest to rest, s.
    pub fn way_back(&self, way: f64) -> f64 {
        self.z.rest_to_rest(way)
    }
}

/// Wanted speed of an infeed, mm/s: the axis decides.
const INFEED_SPEED: f64 = 1000.0;

/// How long one stroke takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StrokeTime {
    /// Feed as driven, mm/s.
    pub speed: f64,
    /// Getting up to speed and down again, s.
    pub ramp: f64,
    /// Way with run-in and run-out, mm.
    pub driven: f64,
    /// Time of that way, s.
    pub stroke: f64,
    /// Infeed, and the same for retraction, s.
    pub infeed: f64,
    /// Stroke with both, s.
    pub total: f64,
    /// Way from the stroke before, s.
    pub rapid: f64,
    /// Pause, s.
    pub dwell: f64,
}

impl StrokeTime {
    /// All of it.
    pub fn sum(&self) -> f64 {
        self.total + self.rapid + self.dwell
    }
}

/// What the time of a stroke needs of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Driven {
    /// Axial feed, mm/s.
    pub feed: f64,
    /// Per workpiece revolution, mm.
    pub per_revolution: f64,
    /// K, the one farthest from 0 where it varies.
    pub ratio: f64,
    /// sigma.
    pub sign: f64,
    /// Way with overruns, mm.
    pub travel: f64,
}

impl Driven {
    fn of(figures: &StrokeFigures) -> Self {
        Self {
            feed: figures.feed,
            per_revolution: figures.stroke.feed_per_revolution,
            ratio: ShiftRatios::of(&figures.stroke.shift.law, figures.contact).steepest,
            sign: figures.sign(),
            travel: figures.travel,
        }
    }

    /// On these axes, with a clearance of the infeed.
    pub fn time(&self, bodies: &Bodies, axes: &Axes, clearance: f64) -> StrokeTime {
        let [threads, teeth] = [bodies.threads(), bodies.teeth()];
        let pair = &bodies.pair.flanks.left;
        let coupled = (pair.shift_coupling * self.ratio + pair.feed_coupling) / teeth;
        let by_b = 360.0 * teeth / (threads * self.per_revolution);
        let by_c = -self.sign * 360.0 / self.per_revolution + coupled.to_degrees();
        let along =
            Along::new(self.feed, &[(axes.z, 1.0), (axes.v, self.ratio), (axes.b, by_b), (axes.c, by_c)]);
        let ramp = along.ramp();
        let driven = self.travel + along.speed * ramp;
        let stroke = driven / along.speed + ramp;
        let infeed = if clearance > 0.0 {
            // Worm and workpiece turn on while the infeed runs.
            let by_b = by_b * along.speed * axes.x.rest_to_rest(clearance) / clearance;
            let by_c = by_b * threads / teeth;
            let along = Along::new(INFEED_SPEED, &[(axes.x, 1.0), (axes.b, by_b), (axes.c, by_c)]);
            along.rest_to_rest(clearance)
        } else {
            0.0
        };
        StrokeTime {
            speed: along.speed,
            ramp,
            driven,
            stroke,
            infeed,
            total: stroke + 2.0 * infeed,
            rapid: 0.0,
            dwell: 0.0,
        }
    }
}

/// How long dressing takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DressingTime {
    /// Axial way of a thread per revolution of the worm, mm.
    pub lead: f64,
    /// Way of a pass, mm.
    pub travel: f64,
    /// As driven, mm/s.
    pub speed: f64,
    /// Getting up to speed and down again, s.
    pub ramp: f64,
    /// One pass with infeed and retraction, s.
    pub pass: f64,
    /// Way back, s.
    pub back: f64,
    /// Passes in all.
    pub passes: usize,
}

impl DressingTime {
    /// All of it.
    pub fn total(&self) -> f64 {
        self.pass * self.passes as f64 + self.back * self.passes.saturating_sub(1) as f64
    }
}

/// Modules that a pass is longer than the width that is dressed.
const BEYOND_WIDTH: f64 = 3.0;

impl DressingTechnology {
    /// On these axes.
    ///
    /// # Errors
    /// `OutOfRange`.
    pub fn time(
        &self,
        bodies: &Bodies,
        axes: &Axes,
        clearance: f64,
    ) -> Result<DressingTime, TechnologyError> {
        self.check()?;
        axes.check()?;
        in_range("clearance", clearance, clearance >= 0.0, ">= 0 mm")?;
        let lead = bodies.thread_lead();
        let travel = self.worm_width + BEYOND_WIDTH * bodies.pair.worm.data().normal_module;
        let along = Along::new(lead * self.worm_speed, &[(axes.v, 1.0), (axes.b, 360.0 / lead)]);
        let ramp = along.ramp();
        Ok(DressingTime {
            lead,
            travel,
            speed: along.speed,
            ramp,
            pass: travel / along.speed + ramp + 2.0 * axes.x.rest_to_rest(clearance),
            back: axes.v.rest_to_rest(travel),
            passes: self.passes * if self.one_flank { 2 } else { 1 },
        })
    }
}

/// Times of a part beside grinding, s.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PartTimes {
    /// Loading and unloading.
    pub load: f64,
    /// Finding the spaces.
    pub index: f64,
    /// Whatever else there is.
    pub other: f64,
    /// Beside the dressing itself.
    pub dressing_aux: f64,
}

impl PartTimes {
    /// A part with its share of dressing, s.
    ///
    /// # Errors
    /// `OutOfRange`.
    pub fn part(
        &self,
        grinding: f64,
        dressing: &DressingTime,
        parts_per_dressing: f64,
    ) -> Result<f64, TechnologyError> {
        for (field, value) in [
            ("times.load_s", self.load),
            ("times.index_s", self.index),
            ("times.other_s", self.other),
            ("times.dressing_aux_s", self.dressing_aux),
        ] {
            in_range(field, value, value >= 0.0, ">= 0 s")?;
        }
        positive("parts_per_dressing", parts_per_dressing)?;
        let share = (dressing.total() + self.dressing_aux) / parts_per_dressing;
        Ok(self.load + self.index + self.other + grinding + share)
    }
}

impl Cycle {
    /// How long each stroke takes on these axes.
    ///
    /// # Errors
    /// `OutOfRange`.
    pub fn times(&self, axes: &Axes, clearance: f64) -> Result<Vec<StrokeTime>, TechnologyError> {
        axes.check()?;
        in_range("clearance", clearance, clearance >= 0.0, ">= 0 mm")?;
        let mut before: Option<(&StrokeFigures, [f64; 2])> = None;
        let mut times = Vec::with_capacity(self.strokes.len());
        for figures in &self.strokes {
            let mut time = Driven::of(figures).time(&self.bodies, axes, clearance);
            let beyond = figures.sign() * (figures.stroke.overrun + 0.5 * time.speed * time.ramp);
            let [start, end] = [figures.contact[0] - beyond, figures.contact[1] + beyond];
            if let Some((previous, [_, stands])) = before {
                let shift = |of: &StrokeFigures, v: f64| of.stroke.shift.law.value(v);
                let infeed = axes.x.rest_to_rest(figures.infeed.delta_d - previous.infeed.delta_d);
                let feed = axes.z.rest_to_rest(start - stands);
                let shift = axes.v.rest_to_rest(shift(figures, start) - shift(previous, stands));
                time.rapid = infeed + feed.max(shift);
            }
            time.dwell = figures.stroke.dwell;
            before = Some((figures, [start, end]));
            times.push(time);
        }
        Ok(times)
    }
}
