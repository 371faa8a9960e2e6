//! The strokes of a run on its stock: those of the job, by the rule of thumb, or the fastest within the limits.

use super::offers::CycleOffers;
use super::worm::worm_life;
use crate::job::{CycleRule, StrokeZone};
use crate::workflow::execution::Execution;
use crate::workflow::partition::Partition;
use crate::workflow::prepare::{Prepared, RemovalTask, StrokesWanted, WantedStroke, bodies_on_stock};
use crate::workflow::programs::{GrindingStroke, StockContact, StrokeLaw};
use foundation::geometry::{Flank, Sides};
use foundation::kinematics::MotionLaw;
use grinding_technology::{
    Cycle, Direction, Ground, Life, OptimumRow, Shift, ShiftRatios, StockField, Stroke, StrokeFigures,
    TechnologyError,
};

/// Feeds of a chosen cycle are whole multiples of this, mm per revolution.
const FEED_STEP: f64 = 1e-3;

/// Strokes of a run with what they do.
#[derive(Clone, Debug)]
pub struct RunCycle {
    /// The strokes on the stock.
    pub cycle: Cycle,
    /// Cycles within the limits, where the job has some.
    pub offers: Option<CycleOffers>,
    /// The worm's states between two dressings, where the job has its life.
    pub life: Option<Life>,
    /// Whether a stroke shifts by a law of its own.
    own_shift: Vec<bool>,
}

/// Why strokes are not worked out.
pub fn beyond(prepared: &Prepared) -> Option<&'static str> {
    let setup = &prepared.setup;
    if !(setup.pair.worm.is_cylindrical() && setup.pair.work.is_cylindrical()) {
        Some("a body is conical")
    } else if prepared.cycle.strokes.is_some() {
        Some("some threads of the worm do not grind")
    } else {
        None
    }
}

/// What is ground by itself, one after the other, as programs drive it.
fn passes_of(execution: &Execution) -> Vec<Ground> {
    let ground: Vec<Flank> =
        Flank::BOTH.into_iter().filter(|&flank| execution.flanks[flank].is_some()).collect();
    if ground.len() == 2 && execution.grinds_both_at_once() {
        vec![Ground::Both]
    } else {
        ground.into_iter().map(Ground::Only).collect()
    }
}

/// Shifts of the plan, z_V1 over z_V2, for strokes that leave stock and for those that leave none, and whether these have areas of their own.
struct PlannedShifts {
    finishing: MotionLaw,
    /// One for each area, at least one.
    roughing: Vec<MotionLaw>,
    apart: bool,
}

impl PlannedShifts {
    fn new(prepared: &Prepared, execution: &Execution, partition: Option<&Partition>) -> Self {
        let planned = &execution.motion.shift;
        let apart = !prepared.cycle.roughing.is_empty();
        let areas = partition.and_then(|partition| partition.tool_areas(prepared, &execution.motion.shift));
        let Some(areas) = areas.filter(|_| apart) else {
            return Self { finishing: planned.clone(), roughing: vec![planned.clone()], apart };
        };
        let by = areas.finishing.first().copied().unwrap_or(0.0);
        let roughing = areas.roughing.iter().map(|pass| pass.shift.clone()).collect();
        Self { finishing: planned.raised(by), roughing, apart }
    }

    fn zone(&self, leaves: bool, wanted: Option<StrokeZone>) -> StrokeZone {
        wanted.unwrap_or(match (self.apart, leaves) {
            (false, _) => StrokeZone::All,
            (true, true) => StrokeZone::Roughing,
            (true, false) => StrokeZone::Finishing,
        })
    }

    /// Of a zone; `number`: of the stroke among those that leave stock, which use the roughing areas in turn.
    fn of_zone(&self, zone: StrokeZone, number: usize) -> &MotionLaw {
        if zone == StrokeZone::Roughing {
            &self.roughing[number % self.roughing.len()]
        } else {
            &self.finishing
        }
    }

    /// As the plan has it for an area, or with the ratio and the origin that are wanted.
    fn law(&self, (zone, number): (StrokeZone, usize), wanted: &WantedStroke) -> MotionLaw {
        let planned = self.of_zone(zone, number);
        if self.apart {
            return planned.clone();
        }
        let at_zero = planned.value(0.0);
        match (wanted.ratio, wanted.origin) {
            (None, None) => planned.clone(),
            (None, Some(origin)) => planned.raised(origin - at_zero),
            (Some(ratio), origin) => MotionLaw::polynomial(0.0, vec![origin.unwrap_or(at_zero), ratio]),
        }
    }
}

impl RunCycle {
    /// Of a run whose bodies and motion are within what is worked out.
    ///
    /// # Errors
    /// Those of bodies, stock and strokes; no cycle within the limits.
    pub fn new(
        prepared: &Prepared,
        execution: &Execution,
        (task, partition): (&RemovalTask, Option<&Partition>),
    ) -> Result<Self, TechnologyError> {
        let bodies = bodies_on_stock(&prepared.setup)?;
        let field = StockField::new(task.stock.clone(), &bodies)?;
        let shifts = PlannedShifts::new(prepared, execution, partition);
        let passes = passes_of(execution);
        let ratios = [&shifts.roughing[0], &shifts.finishing]
            .map(|law| ShiftRatios::of(law, execution.feed_range).mean);
        let life = task.life.map(|life| worm_life(&bodies, (prepared, task), life)).transpose()?;
        let offers = CycleOffers::new((prepared, task), (&bodies, &field), (&passes, ratios), life.as_ref());
        let (wanted, offers) = match (&task.strokes, offers) {
            (StrokesWanted::Listed(strokes), offers) => (strokes.clone(), offers.and_then(Result::ok)),
            (StrokesWanted::Offered, Some(Ok(offers))) => {
                (of_rule(&offers.optimum.standard, offers.stock, (prepared, task)), Some(offers))
            }
            (StrokesWanted::OfMachine | StrokesWanted::Offered, offers) => {
                (of_machine(prepared, task), offers.and_then(Result::ok))
            }
            (StrokesWanted::Rule(rule), Some(offers)) => {
                let offers = offers?;
                let row = match rule {
                    CycleRule::Standard => &offers.optimum.standard,
                    CycleRule::Fastest => &offers.optimum.best,
                    // The job's checks ask for the rates.
                    CycleRule::Cheapest => offers.optimum.cheapest.as_ref().unwrap_or(&offers.optimum.best),
                };
                (of_rule(row, offers.stock, (prepared, task)), Some(offers))
            }
            // The job's checks ask for the limits.
            (StrokesWanted::Rule(_), None) => (of_machine(prepared, task), None),
        };
        let stroke = |ground: Ground, number: usize, wanted: &WantedStroke| {
            let leaves = ground.flanks().any(|flank| wanted.left[flank] > 0.0);
            let zone = shifts.zone(leaves, wanted.zone);
            Stroke {
                ground,
                left: wanted.left,
                feed_per_revolution: wanted.feed_per_revolution,
                cutting_speed: wanted.cutting_speed,
                direction: wanted.direction,
                shift: Shift { law: shifts.law((zone, number), wanted), step_per_part: wanted.step_per_part },
                overrun: wanted.overrun,
                dwell: wanted.dwell,
                zone: zone.name().into(),
            }
        };
        // In areas of their own strokes shift as these lie on the worm.
        let own =
            |wanted: &WantedStroke| !shifts.apart && (wanted.ratio.is_some() || wanted.origin.is_some());
        let leaving =
            |ground: Ground, wanted: &WantedStroke| ground.flanks().any(|flank| wanted.left[flank] > 0.0);
        let (mut own_shift, mut strokes) = (Vec::new(), Vec::new());
        for &ground in &passes {
            let mut number = 0;
            for wanted in &wanted {
                own_shift.push(own(wanted));
                strokes.push(stroke(ground, number, wanted));
                number += usize::from(leaving(ground, wanted));
            }
        }
        Ok(Self { cycle: Cycle::new(bodies, field, strokes)?, offers, life, own_shift })
    }

    /// The strokes as programs drive them.
    pub fn program_strokes(&self) -> Vec<GrindingStroke> {
        let tip_radius = self.cycle.bodies.worm_tip_radius;
        let driven = |(figures, own): (&StrokeFigures, &bool)| {
            let stroke = &figures.stroke;
            GrindingStroke {
                ground: stroke.ground,
                left: stroke.left,
                worm_speed: 1e3 * stroke.cutting_speed / tip_radius,
                feed_per_revolution: stroke.feed_per_revolution,
                direction: stroke.direction,
                shift: if *own { StrokeLaw::Own(stroke.shift.law.clone()) } else { StrokeLaw::Planned },
                contact: Some(StockContact { feeds: figures.contact, overrun: stroke.overrun }),
                dwell: stroke.dwell,
            }
        };
        self.cycle.strokes.iter().zip(&self.own_shift).map(driven).collect()
    }

    /// Feed per workpiece revolution of the stroke that makes the flank, mm.
    pub fn finishing_feed(&self) -> Option<f64> {
        let finishing = self.cycle.strokes.iter().find(|figures| figures.stroke.finishes());
        finishing.map(|figures| figures.stroke.feed_per_revolution)
    }
}

/// A stroke with rising feed at the job's cutting speed.
fn usual(prepared: &Prepared, task: &RemovalTask, left: f64, feed: f64) -> WantedStroke {
    WantedStroke {
        left: Sides::both(left),
        feed_per_revolution: feed,
        cutting_speed: prepared.technology.cutting_speed(prepared.setup.largest_tip_radius),
        direction: Direction::Up,
        ratio: None,
        origin: None,
        step_per_part: task.step_per_part,
        overrun: prepared.cycle.overrun,
        dwell: 0.0,
        zone: None,
    }
}

/// Roughing, finishing and spark-out as `[machine]` has them.
fn of_machine(prepared: &Prepared, task: &RemovalTask) -> Vec<WantedStroke> {
    let stroke = |stroke: &GrindingStroke| {
        usual(prepared, task, stroke.left.left.max(stroke.left.right), stroke.feed_per_revolution)
    };
    prepared.technology.strokes.iter().map(stroke).collect()
}

/// Roughing strokes of equal depth and a finishing stroke, feeds rounded down.
fn of_rule(row: &OptimumRow, stock: f64, (prepared, task): (&Prepared, &RemovalTask)) -> Vec<WantedStroke> {
    let Some(cycle) = row.cycle else { return of_machine(prepared, task) };
    let roughing = row.roughing_strokes;
    let down = |feed: f64| {
        let whole = (feed / FEED_STEP).floor() * FEED_STEP;
        if whole > 0.0 { whole } else { feed }
    };
    let depth = (stock - cycle.finishing) / roughing.max(1) as f64;
    let rough = (1..=roughing).map(|k| (stock - depth * k as f64).max(cycle.finishing));
    let feeds = cycle.feeds.map(down);
    let mut strokes: Vec<WantedStroke> = rough.map(|left| usual(prepared, task, left, feeds[0])).collect();
    strokes.push(usual(prepared, task, 0.0, feeds[1]));
    strokes
}
