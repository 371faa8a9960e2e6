//! Which ratio a plan takes where several are good enough (`grinding.prefer`), and the limits that it keeps to.

use super::best_fit::{drawing, load};
use generating::{GrindingPlan, RatioReason};
use generating_grinding::workflow::prepare;
use serde_json::{Value, json};

/// A helical gear whose rule takes nearly all of the worm (K* on both flanks).
const DRAWING: &str = "d007";

fn plan(change: impl FnOnce(&mut Value)) -> (GrindingPlan, f64) {
    let mut job = drawing(DRAWING);
    change(&mut job);
    let ready = prepare(&load(&job)).unwrap();
    let plan = ready.task().plan().unwrap();
    (plan, ready.tolerance.tightest())
}

fn preferring(word: &str) -> (GrindingPlan, f64) {
    plan(|job| job["grinding"]["prefer"] = json!(word))
}

fn width(plan: &GrindingPlan) -> f64 {
    plan.ideal.occupation[1] - plan.ideal.occupation[0]
}

fn travel(plan: &GrindingPlan) -> f64 {
    let candidates = &plan.choice.candidates;
    candidates.iter().find(|c| c.ratio == plan.choice.ratio).unwrap().feed_travel
}

/// Largest deviation of the planned flanks, mm.
fn deviation(plan: &GrindingPlan) -> f64 {
    let flanks = plan.flanks.iter().filter_map(|(_, flank)| flank.as_ref());
    flanks.flat_map(|f| f.planned.iter().zip(&f.target)).map(|(at, t)| (at.f_n - t).abs()).fold(0.0, f64::max)
}

#[test]
fn least_worm_is_the_default_and_keeps_to_half_of_all() {
    let (accurate, tolerance) = preferring("accuracy");
    assert_eq!(accurate.choice.reason, RatioReason::LeadCorrection);
    let (plain, _) = plan(|_| ());
    let (economical, _) = preferring("worm");
    assert_eq!(economical.choice.reason, RatioReason::LeastWorm);
    assert_eq!(plain.choice.ratio, economical.choice.ratio);
    assert!(width(&economical) < 0.5 * width(&accurate), "{} {}", width(&economical), width(&accurate));
    assert!(deviation(&economical) <= 0.5 * tolerance);
    // Half of the limits of the axes, and no smaller ratio of a fifth less worm keeps to them.
    let chosen = economical.choice.candidates.iter().find(|c| c.ratio == economical.choice.ratio).unwrap();
    assert!(chosen.score() <= 0.5, "{}", chosen.score());
    let smaller: Vec<_> =
        economical.choice.candidates.iter().filter(|c| c.ratio.abs() < chosen.ratio.abs()).collect();
    assert!(!smaller.is_empty() && smaller.iter().all(|c| c.refusal.is_some() || c.score() > 0.5));
    assert!(smaller.iter().any(|c| c.ratio.abs() > 0.8 * chosen.ratio.abs()));
}

#[test]
fn the_shortest_feed_is_not_longer_than_that_of_the_rule() {
    let (accurate, tolerance) = preferring("accuracy");
    let (quick, _) = preferring("time");
    assert!(travel(&quick) <= travel(&accurate), "{} {}", travel(&quick), travel(&accurate));
    assert!(deviation(&quick) <= 0.5 * tolerance);
}

#[test]
fn wider_axes_allow_less_worm() {
    let (narrow, _) = plan(|_| ());
    let (wide, _) = plan(|job| {
        job["grinding"]["axis_limits"] = json!({ "d_phi_S_deg": 40.0, "d_gamma_deg": 12.0, "d_d_mm": 20.0,
            "d_v_yA_mm": 40.0, "delta_d_mm": 4.0 });
    });
    assert!(width(&wide) < width(&narrow), "{} {}", width(&wide), width(&narrow));
}
