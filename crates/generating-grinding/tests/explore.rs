//! Studies of the example jobs: ranking, combinations that fail, worms with equal ratios, independence of threads.

use foundation::numerics::Silent;
use generating_grinding::job::LoadedJob;
use generating_grinding::job::{Explore, Steps};
use generating_grinding::workflow::{
    EqualRatioOffer, ExploreOutcome, MOST_COMBINATIONS, equal_ratio_offers, explore_job, plan_job, prepare,
    write_exploration,
};
use job::tables::{Flanks, OneOrSides};
use job::{parse_job_of as parse_job, read_job_of as read_job};
use run::RunFailure;
use std::path::PathBuf;

/// Cone angle at which the end reliefs of the asymmetric example ask for one ratio
/// (`docs/mathematics/generating-contact.md#contact-path-lines-and-the-diagonal-ratio`), and that ratio.
const COMMON: (f64, f64) = (-3.197_009_462_252_167, 4.688_453_926_84);

fn load(name: &str) -> LoadedJob {
    read_job(&PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(name)).unwrap()
}

fn explored(loaded: &LoadedJob) -> ExploreOutcome {
    explore_job(loaded, &Silent).unwrap_or_else(|e| panic!("{e:?}"))
}

fn steps(from: f64, to: f64, count: usize) -> Option<Steps> {
    Some(Steps { from, to, count })
}

/// The asymmetric job with reliefs of another amount.
fn with_amount(amount_um: f64) -> LoadedJob {
    let loaded = load("asymmetric-conical-worm.toml");
    let text = loaded.document.source().text();
    let changed = text.replace("amount_um = 12.0", &format!("amount_um = {amount_um}"));
    assert_ne!(changed, text);
    parse_job(job::Source::new("job.toml", &changed)).unwrap()
}

#[test]
fn twist_free_crowning_finds_its_ratio() {
    let outcome = explored(&load("twist-free-crowning.toml"));
    assert_eq!(outcome.varied, ["diagonal_ratio"]);
    let best = outcome.best().unwrap();
    assert!((best.diagonal_ratio.unwrap() + 1.916_053_716_653_319_6).abs() < 1e-6, "{best:?}");
    assert!((best.worm_occupation_mm.unwrap() - 79.041_377_6).abs() < 1e-5);
    assert!(best.residual_um.unwrap() < 0.01 && best.flanks.len() == 2);
    // 24 values of each sign, 0 and K*, which is the same on both flanks.
    assert_eq!(outcome.candidates.len(), 50);
    let signs =
        |sign: f64| outcome.candidates.iter().filter(|c| c.diagonal_ratio.unwrap() * sign > 0.0).count();
    assert_eq!((signs(1.0), signs(-1.0)), (24, 25));
    let allowed: Vec<_> = outcome.candidates.iter().take_while(|c| c.allowed).collect();
    assert_eq!(allowed.len(), outcome.allowed);
    assert!(allowed.windows(2).all(|pair| pair[0].score <= pair[1].score));
    assert!(
        outcome
            .candidates
            .iter()
            .zip(1..)
            .all(|(c, rank)| c.rank == rank && c.allowed == c.refused.is_none())
    );
    // Every allowed candidate keeps the limits of the rule.
    for c in &allowed {
        assert!(c.score.unwrap() <= 1.0 && c.residual_um.unwrap() <= 0.5 * outcome.tolerance_um);
        assert!(c.worm_occupation_mm.unwrap() + 2.0 * (1.5 * 3.5 + 3.0) <= 100.0);
        assert!(c.least_determinant_ratio.unwrap() >= 0.3);
        for f in c.flanks.values() {
            assert!(f.rms_residual_um > 0.0 && f.rms_residual_um <= f.max_residual_um);
        }
    }
    // Without a shift the natural twist stays.
    let radial = outcome.candidates.iter().find(|c| c.diagonal_ratio == Some(0.0)).unwrap();
    assert!(radial.residual_um.unwrap() > 5.0 && radial.refused.as_ref().unwrap().code == "model-error");
    let codes: Vec<_> = outcome.candidates.iter().filter_map(|c| Some(c.refused.as_ref()?.code)).collect();
    assert!(codes.contains(&"worm-too-short") && codes.contains(&"axis-limit"), "{codes:?}");
    assert!(outcome.levers.is_empty());
}

#[test]
fn the_cone_angle_brings_both_flanks_to_one_ratio() {
    let mut loaded = with_amount(1.2);
    loaded.job.explore = Some(Explore { worm_cone_angle_deg: steps(-6.0, 0.0, 7), ..Explore::default() });
    let outcome = explored(&loaded);
    assert_eq!((outcome.varied.as_slice(), outcome.candidates.len()), (&["worm_cone_angle_deg"][..], 7));
    let difference = |cone: f64| {
        let found = outcome.candidates.iter().find(|c| (c.worm_cone_angle_deg - cone).abs() < 1e-9).unwrap();
        found.demanded_ratio_difference.unwrap()
    };
    let differences: Vec<f64> = (-6..=0).map(|cone| difference(f64::from(cone))).collect();
    let least = differences.iter().copied().fold(f64::INFINITY, f64::min);
    assert_eq!(least, difference(-3.0));
    // 4.7659 - 4.6189 by the ratios of the cylindrical worm.
    assert!((difference(0.0) - 0.147).abs() < 1e-4, "{}", difference(0.0));
    for c in &outcome.candidates {
        assert!(
            (c.worm_pitch_diameter_mm.unwrap() - 240.0).abs() < 1e-9 && c.diagonal_ratio.is_some(),
            "{c:?}"
        );
    }

    // At the common angle nothing is left to offer, and the rule takes the common ratio.
    assert!(outcome.levers.is_empty());
    assert!((loaded.job.worm.cone_angle_deg - COMMON.0).abs() < 1e-15);
    loaded.job.explore =
        Some(Explore { diagonal_ratio: steps(COMMON.1, COMMON.1 + 0.3, 2), ..Explore::default() });
    let there = explored(&loaded);
    assert!(there.candidates.iter().all(|c| c.demanded_ratio_difference.unwrap() < 1e-9));
    assert!(there.best().is_some());
}

#[test]
fn equal_ratios_are_offered() {
    let mut loaded = with_amount(1.2);
    assert!(offers_of(&loaded).is_empty());
    let coarse = |loaded: &mut LoadedJob| {
        (loaded.job.grid.profile_points, loaded.job.grid.helix_points) = (7, 7);
    };
    coarse(&mut loaded);
    let code = |loaded: &LoadedJob| {
        let outcome = plan_job(loaded, &Silent).unwrap_or_else(|e| panic!("{e:?}"));
        outcome.result.warnings.into_iter().find(|w| w.code == "equal-ratio-offered")
    };
    assert_eq!(code(&loaded), None);
    loaded.job.worm.cone_angle_deg = 0.0;
    let ready = prepare(&loaded).unwrap_or_else(|e| panic!("{e:?}"));
    let offers = equal_ratio_offers(&ready.setup, &ready.targets);
    // Lines along the generatrix of a cylindrical pair answer to the cone angle only.
    assert_eq!(offers.len(), 1, "{offers:?}");
    let offer = &offers[0];
    assert_eq!((offer.lever, offer.keys[0].0), ("cone_angle", "worm.cone_angle_deg"));
    assert!((offer.value_deg - COMMON.0).abs() < 1e-9 && (offer.keys[0].1 - offer.value_deg).abs() == 0.0);
    assert!((offer.diagonal_ratio - COMMON.1).abs() < 1e-9);
    let remark = code(&loaded).unwrap();
    assert!(remark.text.contains(&format!("{:.4}", offer.value_deg)), "{}", remark.text);
    assert!(remark.way_out.contains(&format!("{:.6}", offer.value_deg)), "{}", remark.way_out);
    // One flank alone has nothing to agree with.
    let mut one = loaded.clone();
    one.job.grinding.flanks = Flanks::Left;
    assert!(offers_of(&one).is_empty());
    // The offered worm does what the offer says.
    loaded.job.worm.cone_angle_deg = offer.value_deg;
    let made = prepare(&loaded).unwrap_or_else(|e| panic!("{e:?}"));
    let task = made.task();
    let demanded = task.demanded(&task.planning_grid());
    assert!((demanded.left[0] - offer.diagonal_ratio).abs() < 1e-9);
    assert!((demanded.right[0] - offer.diagonal_ratio).abs() < 1e-9);
}

/// The job's worm with the keys of an offer.
fn with_keys(loaded: &LoadedJob, keys: &[(&str, f64)]) -> LoadedJob {
    let mut changed = loaded.clone();
    let worm = &mut changed.job.worm;
    let value = |wanted: &str| keys.iter().find(|(key, _)| *key == wanted).map(|(_, value)| *value);
    if let Some(angle) = value("worm.cone_angle_deg") {
        worm.cone_angle_deg = angle;
    }
    if let Some(diameter) = value("worm.pitch_diameter") {
        worm.pitch_diameter = Some(diameter);
    }
    if let (Some(left), Some(right)) =
        (value("worm.normal_pressure_angle_deg.left"), value("worm.normal_pressure_angle_deg.right"))
    {
        worm.normal_pressure_angle_deg = Some(OneOrSides::Each { left, right });
    }
    changed
}

#[test]
fn given_directions_answer_to_other_levers_too() {
    let mut start = with_amount(1.2);
    start.job.worm.cone_angle_deg = 0.0;
    // A rack mates on both flanks if the base pitches of the gear stay: cos(alpha) changes by one factor.
    let right = (18f64.to_radians().cos() * 26f64.to_radians().cos() / 25f64.to_radians().cos()).acos();
    let profile = [
        ("worm.normal_pressure_angle_deg.left", 26.0),
        ("worm.normal_pressure_angle_deg.right", right.to_degrees()),
    ];
    for (lever, keys) in
        [("crossing_angle", &[("worm.pitch_diameter", 300.0)][..]), ("profile_angle", &profile[..])]
    {
        // Directions of the tool's lines with which the known worm has one ratio: the left one chosen, the right one from the
        // relation of ratio and directions solved for tan(rho_1).
        let mut known = with_keys(&start, keys);
        known.job.worm.direction_deg = Some(OneOrSides::Each { left: 12.0, right: -12.0 });
        let ready = prepare(&known).unwrap_or_else(|e| panic!("{lever} {e:?}"));
        let task = ready.task();
        let ratio = task.demanded(&task.planning_grid()).left[0];
        let lines = ready.setup.lines.right;
        let wanted = ready.targets.right.as_ref().unwrap().rest[0].line_direction().unwrap();
        let p_2 = 1.0 / (lines.cos_b2 * (wanted - lines.t_k));
        let at = |c: [f64; 2]| c[0] * ratio + c[1];
        let p_1 = (at(lines.roll_feeds) - p_2 * at(lines.work_feeds)) / at(lines.worm_feeds);
        let t_1 = 1.0 / (p_1 * lines.cos_b1) + lines.worm_path;
        let direction = OneOrSides::Each { left: 12.0, right: t_1.atan().to_degrees() };
        let mut loaded = start.clone();
        loaded.job.worm.direction_deg = Some(direction);
        let offers = offers_of(&loaded);
        let near =
            |offer: &EqualRatioOffer| offer.lever == lever && (offer.keys[0].1 - keys[0].1).abs() < 1e-6;
        assert!(offers.iter().any(near), "{lever} {offers:?}");
        for offer in &offers {
            let made = with_keys(&loaded, &offer.keys);
            let ready = prepare(&made).unwrap_or_else(|e| panic!("{offer:?} {e:?}"));
            let task = ready.task();
            let demanded = task.demanded(&task.planning_grid());
            for k in [demanded.left[0], demanded.right[0]] {
                assert!((k - offer.diagonal_ratio).abs() < 1e-7 * k.abs(), "{offer:?} {demanded:?}");
            }
        }
    }
}

#[test]
fn crossing_angles_come_about_by_the_pitch_diameter() {
    let mut loaded = load("twist-free-crowning.toml");
    loaded.job.worm.pitch_diameter = Some(191.25);
    let ratio = steps(-1.9, -1.5, 2);
    loaded.job.explore = Some(Explore {
        crossed_axes_angle_deg: steps(60.0, 122.0, 32),
        diagonal_ratio: ratio,
        ..Explore::default()
    });
    let outcome = explored(&loaded);
    assert_eq!(outcome.varied, ["crossed_axes_angle_deg", "diagonal_ratio"]);
    assert_eq!(outcome.candidates.len(), 64);
    let mut reached = 0;
    for c in &outcome.candidates {
        let gamma = c.crossed_axes_angle_deg.unwrap();
        if let Some(pitch) = c.worm_pitch_diameter_mm {
            reached += 1;
            let asked = 60.0 + 2.0 * ((gamma - 60.0) / 2.0).round();
            assert!((gamma - asked).abs() < 1e-9, "{gamma}");
            // Left-hand worm of 3 threads: gamma = acos(z_1 m/d) + 35 deg.
            let helix = (3.0f64 * 3.5 / pitch).acos().to_degrees();
            assert!((helix + 35.0 - gamma).abs() < 1e-9, "{helix} {gamma}");
        } else {
            assert!(!c.refused.as_ref().unwrap().code.is_empty() && c.residual_um.is_none());
        }
    }
    assert!(reached > 0 && reached < 64, "{reached}");
    assert!(outcome.candidates.iter().any(|c| c.allowed));
    // What no worm of this hand reaches is listed as such.
    loaded.job.explore =
        Some(Explore { crossed_axes_angle_deg: steps(-30.0, 20.0, 3), ..Explore::default() });
    let none = explored(&loaded);
    assert!(none.candidates.iter().all(|c| c.refused.as_ref().unwrap().code == "invalid-number"));
    assert!(none.best().is_none() && !none.is_producible());
}

#[test]
fn combinations_that_fail_are_listed() {
    let mut loaded = load("twist-free-crowning.toml");
    loaded.job.worm.width = None;
    loaded.job.explore = Some(Explore {
        worm_cone_angle_deg: steps(-1.0, 1.0, 3),
        diagonal_ratio: steps(-1.9, 0.0, 2),
        ..Explore::default()
    });
    let outcome = explored(&loaded);
    let codes: Vec<_> = outcome
        .candidates
        .iter()
        .map(|c| (c.worm_cone_angle_deg, c.refused.as_ref().map_or("allowed", |r| r.code)))
        .collect();
    assert_eq!(
        codes.iter().filter(|(_, code)| *code == "conical-worm-without-width").count(),
        4,
        "{codes:?}"
    );
    assert!(codes[0] == (0.0, "allowed") && codes[1] == (0.0, "model-error"), "{codes:?}");
    let directory = tempfile::tempdir().unwrap();
    let written = write_exploration(&outcome, directory.path()).unwrap();
    assert_eq!(written.len(), 3);
    let csv = std::fs::read_to_string(&written[1]).unwrap();
    assert_eq!(csv.lines().count(), 7);
    let width = csv.lines().next().unwrap().split(',').count();
    assert!(csv.lines().all(|line| line.split(',').count() == width) && !csv.contains("NaN"));
    let page = std::fs::read_to_string(&written[2]).unwrap();
    for words in ["tolerance 1 µm", "serves the rolls of its whole width", "cone 0°", "diagonal ratio K"] {
        assert!(page.contains(words), "{words}");
    }
}

#[test]
fn a_job_without_ratio_to_study_keeps_its_own() {
    let mut loaded = load("radial-feed-crowning.toml");
    let gamma = 121.852_8;
    loaded.job.explore =
        Some(Explore { crossed_axes_angle_deg: steps(gamma - 1.0, gamma, 2), ..Explore::default() });
    let outcome = explored(&loaded);
    for c in &outcome.candidates {
        assert_eq!((c.diagonal_ratio, c.allowed, c.within_tolerance), (Some(0.0), true, false), "{c:?}");
        assert!(c.residual_um.unwrap() > 5.0);
    }
    assert!(outcome.best().is_none() && outcome.is_producible());
}

#[test]
fn impossible_studies_are_refused() {
    let code = |loaded: &LoadedJob| match explore_job(loaded, &Silent) {
        Err(RunFailure::BadInput(d) | RunFailure::NotProducible(d)) => {
            assert!(d.way_out.is_some() && d.field.is_some(), "{d:?}");
            d.code
        }
        Ok(outcome) => panic!("{outcome:?}"),
    };
    let mut loaded = load("twist-free-crowning.toml");
    loaded.job.explore = Some(Explore {
        diagonal_ratio: steps(-3.0, 3.0, 10_000),
        worm_cone_angle_deg: steps(-3.0, 3.0, 10_000),
        crossed_axes_angle_deg: steps(-3.0, 3.0, 10_000),
        ..Explore::default()
    });
    assert_eq!(code(&loaded), "too-many-combinations");
    assert_eq!(MOST_COMBINATIONS, 100_000);
    loaded.job.explore = None;
    loaded.job.worm.pitch_diameter = Some(5.0);
    loaded.job.worm.tip_diameter = None;
    assert_eq!(code(&loaded), "worm-too-small");
    loaded.job.explore = Some(Explore { diagonal_ratio: steps(-2.0, -1.0, 2), ..Explore::default() });
    assert_eq!(code(&loaded), "worm-too-small");
    let mut missing = load("twist-free-crowning.toml");
    missing.job.target.modifications = None;
    missing.job.target.file = Some("nowhere.csv".into());
    assert_eq!(code(&missing), "file-unavailable");
}

#[test]
fn the_number_of_threads_does_not_show() {
    let mut loaded = with_amount(1.2);
    loaded.job.explore = Some(Explore {
        diagonal_ratio: steps(-3.0, 4.7, 5),
        worm_cone_angle_deg: steps(-4.0, 0.0, 3),
        ..Explore::default()
    });
    let run = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        serde_json::to_string(&pool.install(|| explored(&loaded))).unwrap()
    };
    assert_eq!(run(1), run(3));
}

#[test]
fn a_study_holds_the_tightest_tolerance_of_a_map() {
    let loaded = load("automotive-bias.toml");
    let text = loaded.document.source().text();
    let coarse = text.replace("[target]", "[target]\ntolerance_map = { w_mm = [0.0, 50.0], z_mm = [-20.0, 20.0], tolerance_um = [[1e-6, 100.0], [100.0, 100.0]] }");
    assert_ne!(coarse, text);
    let study = |text: &str| explored(&parse_job(job::Source::new("job.toml", text)).unwrap());
    let (plain, mapped) = (study(text), study(&coarse));
    assert!((mapped.tolerance_um - 1e-6).abs() < 1e-18);
    assert!(plain.candidates.iter().any(|c| c.within_tolerance));
    assert!(!mapped.candidates.iter().any(|c| c.within_tolerance && c.residual_um > Some(1e-6)));
    assert!(mapped.candidates.iter().any(|c| c.residual_um > Some(1e-6)));
}

/// The levers that a job is offered.
fn offers_of(loaded: &LoadedJob) -> Vec<EqualRatioOffer> {
    let ready = prepare(loaded).unwrap_or_else(|e| panic!("{e:?}"));
    equal_ratio_offers(&ready.setup, &ready.targets)
}
