//! Cycles within the limits of a job: by the rule of thumb, the fastest, and how the time goes with the load.

use super::dressing::dressing_of;
use crate::workflow::prepare::{Prepared, RemovalTask};
use grinding_technology::{
    Axes, Axis, Bodies, CostGoal, Ground, Life, Optimum, OptimumTask, StockField, TechnologyError, ZoneLimits,
};
use machine::Role;
use std::time::Instant;

/// An axis without a limit, mm or deg, s.
const FREE: f64 = 1e9;
/// A worm whose load the job does not bound: parts without end, mm^3/mm.
const NO_WEAR: f64 = 1e12;

/// What the limits allow.
#[derive(Clone, Debug)]
pub struct CycleOffers {
    /// Largest stock of the flanks, for which the cycles are made, mm.
    pub stock: f64,
    /// The cycles.
    pub optimum: Optimum,
    /// What time and dressings cost, where the job has rates.
    pub cost: Option<CostGoal>,
    /// Whether the limits of a machine's axes are in the times.
    pub on_machine: bool,
    /// Whether dressing is in the times.
    pub with_dressing: bool,
    /// Seconds that it took to find them.
    pub seconds: f64,
}

impl CycleOffers {
    /// `None` for a job without limits of the removal rate; an error where no cycle keeps them.
    pub fn new(
        (prepared, task): (&Prepared, &RemovalTask),
        (bodies, field): (&Bodies, &StockField),
        (passes, [ratio_roughing, ratio_finishing]): (&[Ground], [f64; 2]),
        life: Option<&Life>,
    ) -> Option<Result<Self, TechnologyError>> {
        let (rate_roughing, rate_finishing) = (task.rates.roughing?, task.rates.finishing?);
        let ground = passes.iter().flat_map(|pass| pass.flanks());
        let stock = ground.map(|flank| field.extent(bodies, flank)[1]).fold(f64::MIN, f64::max);
        let axes = prepared.machine.as_ref().map(|machine| axes_of(&machine.machine));
        let on_machine = axes.is_some();
        let axes = axes.unwrap_or_else(free_axes);
        let clearance = prepared.technology.clearance;
        let begun = Instant::now();
        let solved = || {
            let wear = task.loads.finishing.zip(task.zone_width);
            let over = |width: f64| dressing_of(prepared, task, width);
            let dressing = match (wear, task.zone_width.and_then(over)) {
                (Some(_), Some(dressing)) => dressing.time(bodies, &axes, clearance)?.total(),
                _ => 0.0,
            };
            let zones = match wear {
                Some((finishing, zone_width)) => ZoneLimits {
                    zone_width,
                    zone_gap: task.zone_gap,
                    allowed_roughing: task.loads.roughing.unwrap_or(finishing),
                    allowed_finishing: finishing,
                },
                None => ZoneLimits {
                    zone_width: 1.0,
                    zone_gap: 0.0,
                    allowed_roughing: NO_WEAR,
                    allowed_finishing: NO_WEAR,
                },
            };
            let limits = &task.cycle_limits;
            let times = task.times.unwrap_or_default();
            let cost = task.cost.zip(life.filter(|_| wear.is_some()));
            let cost = cost.map(|(rates, life)| rates.goal(life.full_dressings()));
            let optimum = OptimumTask {
                passes: passes.to_vec(),
                cost,
                stock,
                cutting_speed: prepared.technology.cutting_speed(bodies.worm_tip_radius),
                least_feed: limits.feed[0],
                largest_feed: limits.feed[1],
                feed_mark: limits.feed_mark,
                rate_roughing,
                rate_finishing,
                least_finishing: limits.finishing[0],
                most_finishing: limits.finishing[1],
                most_roughing_strokes: limits.most_roughing_strokes,
                ratio_roughing,
                ratio_finishing,
                overrun: prepared.cycle.overrun,
                clearance,
                auxiliary: times.load + times.index + times.other,
                between_strokes: axes.way_back(bodies.face_width + 2.0 * prepared.cycle.overrun),
                dressing: dressing + times.dressing_aux,
                zones,
            }
            .solve(bodies, &axes)?;
            let seconds = begun.elapsed().as_secs_f64();
            Ok(Self { stock, optimum, cost, on_machine, with_dressing: wear.is_some(), seconds })
        };
        Some(solved())
    }
}

/// Limits of the axes that a stroke moves; an axis without a limit, or none, is free.
pub(super) fn axes_of(machine: &machine::Machine) -> Axes {
    let of = |role: Role| {
        let limits = machine.role(role).map(|axis| machine.axes()[axis].limits);
        let turns = matches!(role, Role::Worm | Role::Work);
        // Degrees for what turns.
        let shown =
            |limit: Option<f64>| limit.map_or(FREE, |limit| if turns { limit.to_degrees() } else { limit });
        limits.map_or_else(free, |limits| Axis {
            speed: shown(limits.velocity),
            acceleration: shown(limits.acceleration),
            jerk: shown(limits.jerk),
        })
    };
    Axes { x: of(Role::Radial), z: of(Role::Axial), v: of(Role::Shift), b: of(Role::Worm), c: of(Role::Work) }
}

fn free() -> Axis {
    Axis { speed: FREE, acceleration: FREE, jerk: FREE }
}

fn free_axes() -> Axes {
    Axes { x: free(), z: free(), v: free(), b: free(), c: free() }
}
