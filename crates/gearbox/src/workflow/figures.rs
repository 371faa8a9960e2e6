//! What a run of the interpolator is in figures: counters, the budget, and errors beside the limits that the budget sets.

use super::prepare::{Chain, Driven};
use super::result::{
    AlongFeedResult, AngleResult, BudgetResult, CouplingResult, GearboxSettingsResult, PulseFigures, RangeUm,
};
use control::{
    BudgetInput, ControlError, ErrorBudget, Extremes, Interpolation, InterpolationRun, Rotation, RotationRule,
};
use electronic_gearbox::chain::RateRule;
use electronic_gearbox::coefficient::Coefficient;
use electronic_gearbox::pulse::Mode;
use foundation::numerics::extremes;
use std::f64::consts::TAU;

/// Rounding of positions in mm that no limit of the budget knows.
const ROUNDING: f64 = 1e-9;

/// Settings as they were in force.
pub(super) fn settings(chain: &Chain, driven: &Driven) -> GearboxSettingsResult {
    let (feed, workpiece) = (&chain.set_up.feed, &chain.set_up.workpiece);
    GearboxSettingsResult {
        pulses_per_metre: feed.pulses_per_metre,
        pitch_mm: chain.interpolation.pitch,
        clock_hz: feed.clock_hz,
        pulses_per_interval: feed.pulses_per_interval,
        mode: feed.mode,
        counter_limit: feed.counter_limit,
        workpiece_pulses_per_revolution: workpiece.pulses_per_revolution,
        rate: workpiece.rate,
        reversed: workpiece.reversed,
        greatest_speed_mm_per_min: 60.0 * feed.greatest_speed_mm_per_s(),
        last_tick: driven.last_tick,
        duration_s: driven.duration(&chain.interpolation),
    }
}

/// The coupling in figures.
pub(super) fn coupling(chain: &Chain) -> CouplingResult {
    let Chain { gear, set_up, interpolation, rotation, .. } = chain;
    let pulses = set_up.workpiece.pulses_per_revolution;
    let p = f64::from(interpolation.settings.pulses_per_interval());
    let of_multiplier = Coefficient::new(gear, pulses, set_up.feed.pulses_per_metre, set_up.sense()).ok();
    CouplingResult {
        lead_mm: gear.lead().ok(),
        coefficient: rotation.turns_per_millimetre.abs() * f64::from(pulses) * interpolation.pitch,
        coefficient_word: of_multiplier.map(|c| c.word()),
        coefficient_relative_error: of_multiplier.map(|c| c.relative_error()),
        rotation_error_um_per_m: rotation.error_per_metre(interpolation.pitch / p) * gear.flank_per_angle(),
        flank_um_per_workpiece_pulse: gear.flank_per_angle() * TAU / f64::from(pulses),
        flank_um_per_feed_um: gear.flank_per_axial(),
        flank_um_per_rad: gear.flank_per_angle(),
    }
}

/// The counters at the end of a run.
pub(super) fn pulses(
    run: &InterpolationRun,
    interpolation: &Interpolation,
    rotation: &Rotation,
) -> PulseFigures {
    let (counts, status) = (&run.counts, &run.status);
    let p = i64::from(interpolation.settings.pulses_per_interval());
    PulseFigures {
        pulses: counts.references + counts.intermediates + counts.corrections,
        references: counts.references,
        intermediates: counts.intermediates,
        corrections: counts.corrections,
        net_pulses: counts.net,
        net_references: counts.net_references,
        pending_corrections: status.pending,
        overruns: status.overruns,
        too_fast: status.too_fast,
        parts_turned: counts.passed,
        rotation_workpiece_pulses: run.rotation.div_euclid(p),
        rotation_rest_parts: run.rotation.rem_euclid(p),
        rotation_deg: 360.0 * run.rotation as f64 / rotation.parts_per_revolution,
    }
}

/// Limits along the feed widened by what the lines of the scale are off over the motion, mm.
pub(super) fn with_lines(limits: Option<Extremes>, driven: &Driven, pitch: f64) -> Option<Extremes> {
    let (limits, motion) = (limits?, driven.motion.as_ref()?);
    let lines = motion.line_errors();
    if lines.is_none() {
        return Some(limits);
    }
    // A line that is displaced upwards is passed late: pulses stay behind the slide.
    let (off, uneven) = (motion.line_limits(), lines.unevenness(pitch));
    Some(Extremes {
        least: limits.least - off.greatest - uneven,
        greatest: limits.greatest - off.least + uneven,
    })
}

/// The budget of an interpolation, that of the chain or another one, for one speed (mm/s), least speed and acceleration (mm/s^2).
///
/// # Errors
/// [`ControlError`].
pub(super) fn budget(
    chain: &Chain,
    interpolation: &Interpolation,
    [speed, acceleration]: [f64; 2],
    least_speed: Option<f64>,
) -> Result<ErrorBudget, ControlError> {
    ErrorBudget::new(&BudgetInput {
        multiplier: interpolation.settings.pulses_per_interval(),
        clock: interpolation.clock,
        pulses_per_metre: 1e3 / interpolation.pitch,
        speed,
        least_speed,
        acceleration,
        normal_pressure_angle: chain.pressure_angle,
        helix_angle: chain.gear.helix_angle(),
    })
}

/// A budget as it stands in the result.
pub(super) fn budget_result(budget: &ErrorBudget, acceleration: f64) -> BudgetResult {
    BudgetResult {
        speed_mm_per_min: 60.0 * budget.speed,
        acceleration_mm_per_s2: acceleration,
        quantisation_um: 1e3 * budget.quantisation,
        truncation_um: 1e3 * budget.truncation,
        synchronisation_um: 1e3 * budget.synchronisation,
        acceleration_um: 1e3 * budget.acceleration,
        flank_um: budget.flank_um,
        best_pulses_per_interval: budget.best_multiplier,
    }
}

/// Between which limits an error along the feed stays, mm: at the ticks those of the budget, between two ticks the slide moves on
/// by up to v/f1. The budget counts in the running sense; downwards a pulse belongs to the place one pulse further on, and in mode
/// one-way to one P - 1 pulses back from there. `None` where there are no limits.
pub(super) fn limits(
    budget: &ErrorBudget,
    interpolation: &Interpolation,
    references: &[(u64, i64)],
) -> Option<Extremes> {
    let bound = budget.bound().ok()?;
    let between = budget.synchronisation + ROUNDING;
    let p = f64::from(interpolation.settings.pulses_per_interval());
    let one = interpolation.pitch / p;
    let back = match interpolation.settings.mode() {
        Mode::Literal => return None,
        Mode::NoBacklash => 0.0,
        Mode::OneWay => one * (p - 1.0),
    };
    let upwards = [bound.lower, bound.upper];
    let downwards = [back - one - bound.upper, back - one - bound.lower];
    let driven = [(1, upwards), (-1, downwards)]
        .into_iter()
        .filter(|(sense, _)| references.iter().any(|(_, sign)| sign == sense));
    let [least, greatest] = extremes(driven.flat_map(|(_, ends)| ends));
    (least <= greatest).then_some(Extremes { least: least - between, greatest: greatest + between })
}

/// Errors along the feed beside their limits.
pub(super) fn along_feed(
    run: &InterpolationRun,
    whole_limits: Option<Extremes>,
    steady_limits: Option<Extremes>,
    flank_share: f64,
) -> AlongFeedResult {
    let keeps = |found: Option<Extremes>, limits: Option<Extremes>| match (found, limits) {
        (Some(found), Some(limits)) => Some(inside(found, limits)),
        _ => None,
    };
    let checks = [keeps(run.error, whole_limits), keeps(run.steady, steady_limits)];
    let offset = run.direction_offset().map(|mm| 1e3 * mm);
    AlongFeedResult {
        whole: run.error.map(|e| range(e, 1e3)),
        steady: run.steady.map(|e| range(e, 1e3)),
        bound: whole_limits.map(|e| range(e, 1e3)),
        steady_bound: steady_limits.map(|e| range(e, 1e3)),
        within_bound: checks.iter().flatten().copied().reduce(|a, b| a && b),
        mean_up_um: run.means[0].map(|mm| 1e3 * mm),
        mean_down_um: run.means[1].map(|mm| 1e3 * mm),
        direction_offset_um: offset,
        direction_offset_flank_um: offset.map(|um| um * flank_share),
    }
}

/// Errors of the angle beside their limits; `travel` is the way over which the rounding of the ratio adds up, mm.
pub(super) fn angle(
    run: &InterpolationRun,
    whole_limits: Option<Extremes>,
    chain: &Chain,
    travel: f64,
) -> Option<AngleResult> {
    let Chain { gear, interpolation, rotation, .. } = chain;
    let found = run.angle?;
    let p = f64::from(interpolation.settings.pulses_per_interval());
    let limits = whole_limits.map(|axial| {
        let turn = TAU * rotation.turns_per_millimetre;
        let ends = [turn * axial.least, turn * axial.greatest];
        let [below, above] = counting(rotation).map(|parts| parts * TAU / rotation.parts_per_revolution);
        let rounding = rotation.error_per_metre(interpolation.pitch / p).abs() * 1e-3 * travel;
        Extremes {
            least: ends[0].min(ends[1]) + below - rounding,
            greatest: ends[0].max(ends[1]) + above + rounding,
        }
    });
    Some(AngleResult {
        least_rad: found.least,
        greatest_rad: found.greatest,
        flank: range(found, gear.flank_per_angle()),
        bound: limits.map(|limits| range(limits, gear.flank_per_angle())),
        within_bound: limits.map(|limits| inside(found, limits)),
    })
}

/// How many parts of rotation counting alone is off at most, either way (`docs/mathematics/gearbox.md#from-pulses-to-counts`): an
/// accumulator rounds down, two lines of a rate multiplier each for itself.
pub(super) fn counting(rotation: &Rotation) -> [f64; 2] {
    match rotation.rule {
        RotationRule::Exact { .. } => [-1.0, 0.0],
        RotationRule::Multiplier { rule: RateRule::Bresenham, .. } => [-1.0, 1.0],
        RotationRule::Multiplier { rule: RateRule::Binary, .. } => {
            // Least and greatest deviation of one multiplier over all words, and two of them.
            const SPREAD: f64 = 2.8889 + 3.3889;
            [-SPREAD, SPREAD]
        }
    }
}

fn inside(found: Extremes, limits: Extremes) -> bool {
    limits.least <= found.least && found.greatest <= limits.greatest
}

/// Extremes in um, `um` for one of their units.
fn range(extremes: Extremes, um: f64) -> RangeUm {
    RangeUm { least_um: extremes.least * um, greatest_um: extremes.greatest * um }
}
