//! Catalogues ranked by plans: what the target wants over the width, what the pairs make of it, taken at their word by a plan of the pair as
//! a job of its own.

use foundation::geometry::{Flank, Sides};
use foundation::numerics::Silent;
use generating_grinding::catalogue::catalogue_of_job;
use generating_grinding::job::{
    Dresser, DresserContact, DresserModification, FixedDresser, LoadedJob, RankBy, Worm,
};
use generating_grinding::workflow::{plan_job, rank_catalogue};
use job::read_job_of;
use std::path::PathBuf;
use verdict::Status;

fn load() -> LoadedJob {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../examples/catalogue-whole-target.toml");
    let mut loaded: LoadedJob = read_job_of(&path).unwrap();
    (loaded.job.grid.profile_points, loaded.job.grid.helix_points) = (9, 9);
    loaded
}

/// Height of the parabola through three values at -1, 0 and 1, least squares over more by the normal equations of 1, u, u^2.
fn crowning(values: &[f64]) -> f64 {
    let n = values.len();
    let rows: Vec<[f64; 3]> = (0..n)
        .map(|i| {
            let u = 2.0 * i as f64 / (n - 1) as f64 - 1.0;
            [1.0, u, u * u]
        })
        .collect();
    let a = nalgebra::Matrix3::from_fn(|i, j| rows.iter().map(|r| r[i] * r[j]).sum::<f64>());
    let b = nalgebra::Vector3::from_fn(|i, _| rows.iter().zip(values).map(|(r, f)| r[i] * f).sum::<f64>());
    -a.lu().solve(&b).unwrap()[2]
}

#[test]
fn pairs_are_ranked_by_what_their_plans_leave() {
    let mut loaded = load();
    loaded.job.catalogue.as_mut().unwrap().plans = Some(3);
    let bodies = catalogue_of_job(&loaded).unwrap().unwrap();
    let found = rank_catalogue(&loaded, &bodies, &Silent).unwrap();
    assert_eq!(found.pairs.iter().filter(|pair| pair.plan.is_some()).count(), 3);
    // The target: 3 um and 3 v^2 um, v = z/20, over the whole involute, which is evaluated here.
    for name in ["left", "right"] {
        for (at, wanted) in found.wanted_over_width[name].iter().zip([6.0, 3.75, 3.0, 3.75, 6.0]) {
            assert!((at.wanted_um - wanted).abs() < 1e-6, "{at:?}");
        }
    }
    let places: Vec<u8> = found
        .pairs
        .iter()
        .map(|pair| match (&pair.plan, pair.refused.as_ref().map(|refused| refused.code)) {
            (Some(plan), _) if plan.status == Status::Met => 0,
            (Some(_), _) => 1,
            (None, Some("not-planned")) => 2,
            (None, _) => 3,
        })
        .collect();
    assert_eq!(places[0], 0, "{:?}", found.pairs[0]);
    assert!(places[..3].windows(2).all(|pair| pair[0] <= pair[1]), "{places:?}");
    // The best pair as a job of its own.
    let best = &found.pairs[0];
    let worm = bodies.catalogue.worm.iter().find(|w| w.name == best.worm).unwrap();
    let dresser = bodies.catalogue.dresser.iter().find(|d| d.name == best.dresser).unwrap();
    let mut alone = loaded.clone();
    alone.job.catalogue = None;
    alone.job.worm = Worm {
        threads: worm.threads,
        hand: worm.hand,
        pitch_diameter: worm.pitch_diameter,
        tip_diameter: worm.tip_diameter,
        normal_pressure_angle_deg: worm.normal_pressure_angle_deg,
        width: Some(worm.width),
        ..Worm::absent()
    };
    let Sides { left: carried, .. } = dresser.profile_crowning_um.sides();
    let profile = format!("{{ \"kind\": \"profile_crowning\", \"amount_um\": {carried} }}");
    alone.job.dresser = Some(Dresser {
        others: Vec::new(),
        tip_diameter: dresser.tip_diameter,
        contact: DresserContact::Line,
        tip_radius: None,
        pitch_diameter: dresser.pitch_diameter,
        root_clearance: None,
        tip_land: dresser.tip_land,
        modification: match carried {
            0.0 => DresserModification::Rule(FixedDresser::None),
            _ => DresserModification::Given(serde_json::from_str(&profile).unwrap()),
        },
        designed_for: Some(dresser.designed_for),
    });
    let planned = plan_job(&alone, &Silent).unwrap().result;
    let plan = best.plan.as_ref().unwrap();
    assert_eq!(plan.status, planned.verdict.status());
    let deviation = planned.flanks.values().map(|f| f.max_deviation_um).fold(0.0, f64::max);
    assert!((plan.deviation_um - deviation).abs() < 1e-6, "{} {deviation}", plan.deviation_um);
    for flank in Flank::BOTH {
        let made = &planned.flanks[flank.name()];
        // Ends and middle of the width are rows of the grid.
        for (at, k) in [(0, 0), (2, 4), (4, 8)] {
            let profile: Vec<f64> = made.simulated_um.iter().map(|row| row[k]).collect();
            let target: Vec<f64> = made.target_um.iter().map(|row| row[k]).collect();
            let shown = plan.crowning[flank.name()][at];
            // Both are normal: their proportion to the transverse one is the same.
            let share = crowning(&profile) / crowning(&target);
            assert!((shown.made_um.unwrap() / shown.wanted_um - share).abs() < 1e-6, "{shown:?} {share}");
        }
        // What is wanted lies within what the pair makes, with the dresser that it has.
        let range = best.crowning_range[flank.name()];
        assert!(range.least_um < range.largest_um);
        assert_eq!(range.serves_the_width, range.least_um <= 3.0 && 6.0 <= range.largest_um);
    }
}

#[test]
fn a_ranking_by_profiles_is_as_it_was() {
    let mut loaded = load();
    let source = loaded.job.catalogue.as_mut().unwrap();
    (source.rank_by, source.plans, source.crowning_at) = (RankBy::Profile, None, None);
    let bodies = catalogue_of_job(&loaded).unwrap().unwrap();
    let found = rank_catalogue(&loaded, &bodies, &Silent).unwrap();
    assert!(found.wanted_over_width.is_empty());
    assert!(found.pairs.iter().all(|pair| pair.plan.is_none() && pair.crowning_range.is_empty()));
    let shares: Vec<f64> =
        found.pairs.iter().filter(|p| p.ok).map(|p| p.largest_share_of_limit.unwrap()).collect();
    assert!(!shares.is_empty() && shares.windows(2).all(|pair| pair[0] <= pair[1]));
}
