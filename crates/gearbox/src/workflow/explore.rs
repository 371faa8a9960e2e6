//! `[explore]` of the electronic gearbox: every combination of scale, clock, interpolation and encoder judged by its error budget at the
//! flank, ranked by cost; the cheapest that is accurate enough is simulated.

use super::figures::{budget, counting};
use super::finding::of_feed;
use super::measuring::measuring;
use super::prepare::{Chain, Driven, Measured, Offer, Offers, SetUp};
use super::result::{BestSetUpResult, ExploreResult, SetUpResult};
use control::Extremes;
use electronic_gearbox::Error as GearboxError;
use foundation::numerics::Progress;
use run::RunFailure;
use run::control::on_field;
use std::f64::consts::TAU;
use verdict::Remark;

/// The rule of the ranking, in words.
const RANKING: &str = "accurate and fast enough before the others, those by cost, then by error; the others by error, those without a coupling last";

/// Judges all set-ups; the remark says why none is accurate enough, if so.
///
/// # Errors
/// [`RunFailure`]: what the interpolator or the motion says of a set-up.
pub(super) fn explore(
    offers: &Offers,
    chain: &Chain,
    driven: &Driven,
    measured: &Measured,
    progress: &dyn Progress,
) -> Result<(ExploreResult, Option<Remark>), RunFailure> {
    progress.start("set-ups", offers.all.len() as u64);
    // Distance of the outermost lines; the scales to choose from have the same slide.
    let travel = driven.travel(&chain.interpolation);
    // The same for all: scale and encoder to choose from are taken to be as good as those of the job.
    let measuring_um = measuring(measured, chain, driven).map_or(0.0, |errors| errors.sum_flank_um);
    let mut judged: Vec<(SetUp, SetUpResult)> = Vec::with_capacity(offers.all.len());
    for offer in &offers.all {
        judged.push((offer.set_up, judge(offer, offers, chain, [travel, measuring_um])?));
        progress.advance(1);
    }
    progress.finish();
    judged.sort_by(|(_, a), (_, b)| {
        let last = |s: &SetUpResult| s.flank_um.unwrap_or(f64::INFINITY);
        let by_error = last(a).total_cmp(&last(b));
        let by_cost =
            if a.feasible && b.feasible { a.cost.total_cmp(&b.cost) } else { std::cmp::Ordering::Equal };
        b.feasible.cmp(&a.feasible).then(by_cost).then(by_error).then(a.cost.total_cmp(&b.cost))
    });
    for (k, (_, result)) in judged.iter_mut().enumerate() {
        result.rank = k + 1;
    }
    let first = judged.first().filter(|(_, result)| result.feasible);
    let best = first.map(|(set_up, result)| simulate(set_up, result, chain, driven)).transpose()?;
    let set_ups: Vec<SetUpResult> = judged.into_iter().map(|(_, result)| result).collect();
    let reason = if best.is_none() { Some(nothing(&set_ups, offers)) } else { None };
    let result = ExploreResult {
        wanted_um: offers.wanted_um,
        speed_mm_per_min: 60.0 * offers.speed,
        acceleration_mm_per_s2: offers.acceleration,
        feasible: set_ups.iter().filter(|set_up| set_up.feasible).count(),
        ranking: RANKING,
        best,
        set_ups,
    };
    Ok((result, reason))
}

/// The budget of one set-up.
fn judge(
    offer: &Offer,
    offers: &Offers,
    chain: &Chain,
    [travel, measuring_um]: [f64; 2],
) -> Result<SetUpResult, RunFailure> {
    let Offer { set_up: offered, cost } = offer;
    let gear = &chain.gear;
    let interpolation = offered.interpolation()?;
    let budget = budget(chain, &interpolation, [offers.speed, offers.acceleration], None)
        .map_err(|error| of_feed(&error))?;
    let flank = |millimetres: f64| millimetres * 1e3 * budget.flank_share;
    let p = f64::from(interpolation.settings.pulses_per_interval());
    let part_um = TAU * gear.flank_per_angle() / (f64::from(offered.workpiece.pulses_per_revolution) * p);
    let resolution_um = 0.5 * part_um;
    let mut set_up = SetUpResult {
        rank: 0,
        pulses_per_metre: offered.feed.pulses_per_metre,
        clock_hz: offered.feed.clock_hz,
        pulses_per_interval: offered.feed.pulses_per_interval,
        pulses_per_revolution: offered.workpiece.pulses_per_revolution,
        cost: *cost,
        quantisation_um: flank(budget.quantisation),
        clock_um: flank(budget.truncation + budget.synchronisation),
        acceleration_um: flank(budget.acceleration),
        resolution_um,
        rounding_um: None,
        measuring_um,
        flank_um: None,
        greatest_speed_mm_per_min: 60.0 * budget.greatest_speed,
        feasible: false,
        refused: None,
    };
    match offered.rotation(gear, &interpolation) {
        Ok(rotation) => {
            // Half the stretch in which counting stays, beyond the half part that is resolution already.
            let [below, above] = counting(&rotation);
            let counted = (0.5 * (above - below) - 0.5) * part_um;
            let word = rotation.error_per_metre(interpolation.pitch / p).abs() * 1e-3 * travel;
            let rounding = counted + word * gear.flank_per_angle();
            let sum = budget.flank_um + resolution_um + rounding + measuring_um;
            (set_up.rounding_um, set_up.flank_um) = (Some(rounding), Some(sum));
            set_up.refused = if budget.speed > budget.greatest_speed {
                Some("interpolator-too-fast")
            } else if sum > offers.wanted_um {
                Some("not-accurate-enough")
            } else {
                None
            };
            set_up.feasible = set_up.refused.is_none();
        }
        Err(error @ GearboxError::CoefficientTooLarge { .. }) => set_up.refused = Some(error.code()),
        Err(error) => return Err(on_field(&error, "explore")),
    }
    Ok(set_up)
}

/// Runs the motion through a set-up.
fn simulate(
    set_up: &SetUp,
    result: &SetUpResult,
    chain: &Chain,
    driven: &Driven,
) -> Result<BestSetUpResult, RunFailure> {
    let unmeasured = BestSetUpResult { set_up: *result, measured_steady_um: None, measured_whole_um: None };
    let Some(motion) = &driven.motion else { return Ok(unmeasured) };
    let gear = &chain.gear;
    let interpolation = set_up.interpolation()?;
    let refused = |error: GearboxError| on_field(&error, "explore");
    let rotation = set_up.rotation(gear, &interpolation).map_err(refused)?;
    let again = Driven::of_motion(motion.clone(), driven.rest, &interpolation)?;
    let run = interpolation
        .run(&again.references, again.last_tick, Some(motion), Some(&rotation), &mut |_, _| {})
        .map_err(refused)?;
    let largest = |e: Extremes, um: f64| e.greatest.max(-e.least) * um;
    Ok(BestSetUpResult {
        measured_steady_um: run.steady.map(|e| largest(e, 1e3 * gear.flank_per_axial())),
        measured_whole_um: run.angle.map(|e| largest(e, gear.flank_per_angle())),
        ..unmeasured
    })
}

/// Why nothing is accurate enough, by the part that weighs most in the most accurate set-up.
fn nothing(set_ups: &[SetUpResult], offers: &Offers) -> Remark {
    let code = "no-set-up-accurate-enough";
    let wanted = offers.wanted_um;
    let makeable = || set_ups.iter().filter_map(|s| Some((s, s.flank_um?, s.rounding_um?)));
    let fast = makeable().find(|(s, ..)| s.refused != Some("interpolator-too-fast"));
    let Some((best, sum, rounding)) = fast else {
        return if makeable().next().is_some() {
            Remark {
                code,
                text: format!("no set-up follows a feed of {:.6} mm/min", 60.0 * offers.speed),
                way_out: "feed slower, or offer faster clocks, coarser scales or fewer pulses per interval"
                    .into(),
            }
        } else {
            Remark {
                code,
                text: "for every set-up the coefficient is too large for a rate multiplier".into(),
                way_out: "offer finer scales or encoders with fewer pulses, or take rate = \"exact\"".into(),
            }
        };
    };
    let parts = [
        (
            "the staircase of the interpolation",
            best.quantisation_um,
            "offer a finer scale or more pulses per interval",
        ),
        ("the clock", best.clock_um, "offer a faster clock, or feed slower"),
        (
            "the acceleration",
            best.acceleration_um,
            "offer a finer scale, accelerate more slowly or feed faster",
        ),
        (
            "the resolution of the rotation",
            best.resolution_um,
            "offer an encoder with more pulses per revolution or more pulses per interval",
        ),
        (
            "the rounding of the rotation",
            rounding,
            "take rate = \"exact\", or offer an encoder with more pulses per revolution",
        ),
        (
            "what is measured wrongly",
            best.measuring_um,
            "take a better scale or ball screw, or centre the encoder",
        ),
    ];
    let mut largest = parts[0];
    for part in parts {
        if part.1 > largest.1 {
            largest = part;
        }
    }
    let (name, um, help) = largest;
    Remark {
        code,
        text: format!(
            "no set-up reaches {wanted} um; the most accurate one ({} pulses per metre, {} Hz, P = {}, {} pulses per revolution) is at {sum:.4} um, \
             of which {name} takes {um:.4} um",
            best.pulses_per_metre, best.clock_hz, best.pulses_per_interval, best.pulses_per_revolution
        ),
        way_out: help.into(),
    }
}
