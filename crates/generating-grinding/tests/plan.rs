//! The example jobs from file to referee: plans, settings round trip, independence of the number of threads.

use foundation::geometry::Flank;
use foundation::numerics::Silent;
use generating::PlannedTool;
use generating_grinding::job::{LoadedJob, Prefer};
use generating_grinding::workflow::{Outcome, plan_job, simulate_job};
use job::read_job_of as read_job;
use run::RunFailure;
use std::path::PathBuf;
use verdict::Status;

fn load(name: &str) -> LoadedJob {
    read_job(&PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(name)).unwrap()
}

fn planned(loaded: &LoadedJob) -> Outcome {
    plan_job(loaded, &Silent).unwrap_or_else(|e| panic!("{e:?}"))
}

/// An example with the ratio of least corrections.
fn accurate(name: &str) -> LoadedJob {
    let mut loaded = load(name);
    loaded.job.grinding.prefer = Some(Prefer::Accuracy);
    loaded
}

#[test]
fn twist_free_crowning_meets_its_figures() {
    let outcome = planned(&accurate("twist-free-crowning.toml"));
    let result = &outcome.result;
    assert_eq!(result.verdict.status(), Status::Met);
    assert!((result.settings.settings.diagonal_ratio + 1.916_053_716_653_319_6).abs() < 2e-9);
    assert!((result.settings.worm_length_mm - 79.041_377_6).abs() < 1e-5);
    for flank in Flank::BOTH {
        let f = &result.flanks[flank.name()];
        assert!(f.max_deviation_um <= 0.05, "{}", f.max_deviation_um);
        assert!(f.model_difference_um <= 0.02 && f.model_difference_um <= f.referee_error_um);
        assert!(f.simulated_characteristics.twist_corner_um.abs() <= 0.02);
        assert!(f.simulated_characteristics.twist_fit_um.abs() <= 0.02);
        assert!((f.simulated_characteristics.helix_crowning_um - 20.0).abs() < 0.01);
        // Dressing is a pure change of d_phi_S over v: 0.22 deg (`docs/mathematics/planning.md#how-it-is-verified`).
        let planned = outcome.plan.as_ref().unwrap().flanks[flank].as_ref().unwrap();
        let PlannedTool::Dressed(dressed) = &planned.tool else { panic!("the job has a dresser") };
        let largest = dressed.nodes.iter().map(|n| n.dk[0].abs()).fold(0.0, f64::max).to_degrees();
        assert!((largest - 0.2187).abs() < 0.001, "{largest}");
    }
}

#[test]
fn radial_feed_shows_the_natural_twist() {
    let result = planned(&load("radial-feed-crowning.toml")).result;
    assert_eq!(result.verdict.status(), Status::Missed);
    assert_eq!(result.verdict.reason().unwrap().code, "natural-twist");
    for (flank, s) in [("left", 1.0), ("right", -1.0)] {
        let c = &result.flanks[flank].simulated_characteristics;
        assert!((c.twist_corner_um + s * 51.5389).abs() < 0.02, "{}", c.twist_corner_um);
        assert!((c.twist_corner_normal_um + s * 43.1439).abs() < 0.02);
        assert!((c.twist_fit_um + s * 51.3993).abs() < 0.02);
        assert!((result.flanks[flank].max_deviation_um - 13.458).abs() < 0.01);
    }
}

#[test]
fn automotive_bias_keeps_its_wanted_twist() {
    let result = planned(&accurate("automotive-bias.toml")).result;
    assert_eq!(result.verdict.status(), Status::Met);
    let score = |k: f64| {
        let c = result.settings.candidates.iter().find(|c| c.diagonal_ratio == k);
        c.map_or(f64::INFINITY, |c| c.score)
    };
    assert!(score(result.settings.settings.diagonal_ratio) <= 1.1 * 0.351_829_4);
    for f in result.flanks.values() {
        assert!(f.max_deviation_um <= 0.055, "{}", f.max_deviation_um);
        assert!(
            f.model_difference_um <= f.referee_error_um,
            "{} {}",
            f.model_difference_um,
            f.referee_error_um
        );
        assert!((f.simulated_characteristics.twist_corner_um + 6.0).abs() < 0.05);
    }
}

#[test]
fn settings_of_a_plan_simulate_to_the_same_flank() {
    let mut loaded = load("twist-free-crowning.toml");
    loaded.job.grid.profile_points = 9;
    loaded.job.grid.helix_points = 9;
    let plan = planned(&loaded);
    assert!(
        matches!(simulate_job(&loaded, &Silent), Err(RunFailure::BadInput(d)) if d.field.as_deref() == Some("settings"))
    );
    loaded.job.settings = Some(plan.execution.settings());
    let again = simulate_job(&loaded, &Silent).unwrap_or_else(|e| panic!("{e:?}"));
    for flank in Flank::BOTH {
        let (a, b) = (&plan.result.flanks[flank.name()], &again.result.flanks[flank.name()]);
        for (x, y) in a.simulated_um.iter().flatten().zip(b.simulated_um.iter().flatten()) {
            assert!((x - y).abs() < 1e-6, "{x} {y}");
        }
    }
}

#[test]
fn the_number_of_threads_does_not_show() {
    let mut loaded = load("automotive-bias.toml");
    loaded.job.grid.profile_points = 7;
    loaded.job.grid.helix_points = 7;
    let run = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let mut result = pool.install(|| planned(&loaded)).result;
        result.timing_s.clear();
        serde_json::to_string(&result).unwrap()
    };
    assert_eq!(run(1), run(2));
}
