//! 28-planning: whole plans, from the bodies to the flank that the dressed worm leaves.
//!
//! A plan is judged by its error and its use of the limits, not by its coefficients: the rule leaves the diagonal ratio some
//! freedom. So the file's choice is compared in two steps. First the plan that the rule finds: its ratio is the listed one, or its
//! score and its error are no worse than the tolerances allow. Then the plan with the listed ratio given: worm functions, motions,
//! corrections and flanks must be the listed ones. Errors may be smaller than listed without limit; so may the steps towards
//! them, because the library corrects the worm as dressed once more where the file does not.

mod bodies;
mod flank;

use super::expected::Expected;
use super::ledger::Ledger;
use super::reference::{self, Reference, Tolerances};
use bodies::Input;
use flank::PlannedFlank;
use foundation::geometry::Flank;
use foundation::kinematics::MotionLaw;
use generating::least_squares::FitNorm;
use generating::{
    Candidate, DEFAULT_LEAST_DETERMINANT, DressingRows, Effort, GeneratingError, GrindingPlan, GrindingSetup,
    PlanGauge, PlanTask, PlanningGrid, Prefer, RatioChoice,
};
use serde_json::Value;

const UM: f64 = 1e-3;
const MICRORADIAN: f64 = 1e-6;

/// Points over profile and face width on which the file plans and lists its flanks.
const GRID: usize = 9;

/// Block `cases`.
pub(super) fn cases(file: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    let tolerances = file.tolerances();
    for mut case in reference::cases("cases", block, ledger) {
        let Some(input) = reference::read::<Input>(&case.name, case.input, ledger) else { continue };
        if let Err(error) = one(&input, &mut case.expected, tolerances, ledger) {
            case.expected.refused(&error, ledger);
        }
        case.expected.finish(ledger);
    }
}

fn one(
    input: &Input,
    expected: &mut Expected<'_>,
    tolerances: Tolerances<'_>,
    ledger: &mut Ledger,
) -> Result<(), GeneratingError> {
    let setup = input.setup()?;
    input.derived(expected.case(), &setup, tolerances.get("K_star_relative"), ledger);
    let task = PlanTask {
        setup: &setup,
        targets: input.targets(&setup)?,
        tolerance: input.tolerance(),
        tolerance_map: None,
        limits: input.limits(),
        ratio: None,
        law: None,
        norm: FitNorm::default(),
        gauge: PlanGauge::default(),
        dressing: DressingRows::default(),
        places: input.places(),
        free_dresser: true,
        precompensation: true,
        grid: (GRID, GRID),
        // The rule of the listed ratios.
        prefer: Prefer::Accuracy,
        effort: Effort::Full,
        least_determinant: DEFAULT_LEAST_DETERMINANT,
    };
    let Some(listed) = expected.given("K_ZV1", ledger) else { return Ok(()) };
    let found = task.plan()?;
    let listed_error = Flank::BOTH
        .into_iter()
        .filter_map(|flank| expected.peek(flank.name())?.get("max_error_um")?.as_f64())
        .fold(0.0, f64::max);
    ratio_found(&found, listed, listed_error, expected, tolerances, ledger);
    closed_ratios(&setup, &found.choice, expected, tolerances, ledger);
    let given =
        |ratio: f64| PlanTask { ratio: Some(ratio), places: vec![found.choice.place], ..task.clone() };
    candidates(&setup, &given, expected, tolerances, ledger);
    let plan = given(listed).plan()?;
    motions(&setup, &plan, expected, tolerances, ledger);
    for flank in Flank::BOTH {
        let Some(mut side) = expected.object(flank.name(), ledger) else { continue };
        match &task.targets[flank] {
            Some(target) => {
                let planned = PlannedFlank { setup: &setup, plan: &plan, target, flank };
                if let Err(error) = planned.check(&mut side, tolerances, ledger) {
                    side.refused(&error, ledger);
                }
            }
            None => side.refused(&"no modifications are given for this flank", ledger),
        }
        side.finish(ledger);
    }
    Ok(())
}

fn largest_error(plan: &GrindingPlan) -> f64 {
    let flanks = plan.flanks.iter().filter_map(|(_, flank)| flank.as_ref());
    flanks
        .flat_map(|flank| flank.target.iter().zip(&flank.planned))
        .map(|(target, planned)| (target - planned.f_n).abs())
        .fold(0.0, f64::max)
}

fn score(choice: &RatioChoice) -> f64 {
    choice.candidates.iter().find(|c| c.ratio == choice.ratio).map_or(f64::NAN, Candidate::score)
}

/// The ratio that the rule finds: the listed one, or one as good.
fn ratio_found(
    plan: &GrindingPlan,
    listed: f64,
    listed_error: f64,
    expected: &Expected<'_>,
    tolerances: Tolerances<'_>,
    ledger: &mut Ledger,
) {
    let case = expected.case();
    let exact = tolerances.get("K_star_relative") * listed.abs();
    let scores = expected.peek("candidates").and_then(Value::as_array).into_iter().flatten();
    let best = scores
        .filter(|c| c["K_ZV1"].as_f64() == Some(listed))
        .find_map(|c| c["score"].as_f64())
        .unwrap_or(f64::NAN);
    if (plan.choice.ratio - listed).abs() <= exact {
        ledger.number(case, "K_ZV1", listed, plan.choice.ratio, exact);
    } else {
        let margin = (tolerances.get("score_factor") - 1.0) * best;
        ledger.at_most(case, "score of the K_ZV1 found", best, score(&plan.choice), margin);
    }
    ledger.at_most(
        case,
        "max_error_um of the K_ZV1 found",
        listed_error,
        largest_error(plan) / UM,
        tolerances.get("max_error_um"),
    );
}

/// K* and the ratio of level lines, per flank.
fn closed_ratios(
    setup: &GrindingSetup,
    choice: &RatioChoice,
    expected: &mut Expected<'_>,
    tolerances: Tolerances<'_>,
    ledger: &mut Ledger,
) {
    let relative = tolerances.get("K_star_relative");
    for flank in Flank::BOTH {
        let level = setup.lines[flank].ratio_of_direction(0.0);
        expected.number(&format!("K_rho_2_zero_{flank}"), level, relative * level.abs(), ledger);
        let star = choice.lead_correction[flank];
        let tolerance = relative * star.map_or(f64::NAN, f64::abs);
        expected.optional(&format!("K_star_{flank}"), star, tolerance, ledger);
    }
}

/// Every listed candidate, judged again by the rule's own measure.
fn candidates<'a>(
    setup: &GrindingSetup,
    given: &impl Fn(f64) -> PlanTask<'a>,
    expected: &mut Expected<'_>,
    tolerances: Tolerances<'_>,
    ledger: &mut Ledger,
) {
    let grid = PlanningGrid::new(setup, GRID, GRID);
    let share = tolerances.get("score_factor") - 1.0;
    for mut item in expected.objects("candidates", ledger) {
        let Some(ratio) = item.given("K_ZV1", ledger) else { continue };
        match given(ratio).choose(&grid) {
            Ok(RatioChoice { candidates, .. }) if candidates.len() == 1 => {
                let c = &candidates[0];
                let score = item.peek("score").and_then(Value::as_f64).unwrap_or(f64::NAN);
                let shares = [
                    ("dressing_share", c.dressing_share),
                    ("Delta_d_share", c.delta_d_share),
                    ("score", c.score()),
                ];
                item.numbers(&shares, share * score, ledger);
                item.number("worm_length_mm", c.occupation, tolerances.get("worm_length_mm"), ledger);
                item.at_most("ideal_error_um", c.error / UM, tolerances.get("max_error_um"), ledger);
            }
            Ok(_) => item.refused(&"the ratio was not judged", ledger),
            Err(error) => item.refused(&error, ledger),
        }
        item.finish(ledger);
    }
}

/// The common motions of both flanks at the listed ratio.
fn motions(
    setup: &GrindingSetup,
    plan: &GrindingPlan,
    expected: &mut Expected<'_>,
    tolerances: Tolerances<'_>,
    ledger: &mut Ledger,
) {
    let length = tolerances.get("worm_length_mm");
    let [from, to] = plan.ideal.occupation;
    expected.number("z_V01_mm", plan.ideal.motion.shift.value(0.0), length, ledger);
    expected.number("worm_length_mm", to - from, length, ledger);
    let which: Vec<Flank> = Flank::BOTH.into_iter().filter(|&f| plan.flanks[f].is_some()).collect();
    let Some(feeds) = expected.given_list("z_V2_mm", ledger) else { return };
    spans(expected, "z_V2_mm", &feeds, (setup.feed_range(&plan.ideal.motion.shift, &which), length), ledger);
    let motion = &plan.ideal.motion;
    let at = |law: &MotionLaw, unit: f64| feeds.iter().map(|&v| law.value(v) / unit).collect::<Vec<_>>();
    expected.list("Delta_d_um", &at(&motion.delta_d, UM), tolerances.get("Delta_d_um"), ledger);
    let angle = tolerances.get("Delta_phi_2_urad");
    expected.list("Delta_phi_2_urad", &at(&motion.delta_phi_2, MICRORADIAN), angle, ledger);
}

/// Coordinates at which values are listed run from one end of a range to the other.
fn spans(
    outer: &Expected<'_>,
    key: &str,
    list: &[f64],
    (range, tolerance): ([f64; 2], f64),
    ledger: &mut Ledger,
) {
    let ends = [list.first(), list.last()].map(|x| x.copied().unwrap_or(f64::NAN));
    for ((end, found), name) in ends.into_iter().zip(range).zip(["first", "last"]) {
        ledger.number(outer.case(), &format!("{key} {name}"), end, found, tolerance);
    }
}
