//! A worm topography as the thing wanted: the worm is what the job says, and the gear is what rays of the referee cut with that worm.

use foundation::geometry::Flank;
use foundation::kinematics::MotionLaw;
use foundation::numerics::Silent;
use generating_grinding::job::LoadedJob;
use generating_grinding::workflow::{Outcome, plan_job};
use job::read_job_of;
use referee::{ActiveThreads, Grinding, GrindingMode, RayGrid, WormArea, WormModification, grind};
use run::RunFailure;
use std::path::PathBuf;
use verdict::Status;

fn load() -> LoadedJob {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../examples/dressing/wanted-worm.toml");
    let mut loaded: LoadedJob = read_job_of(&path).unwrap();
    (loaded.job.grid.profile_points, loaded.job.grid.helix_points) = (7, 7);
    loaded
}

fn planned(loaded: &LoadedJob) -> Outcome {
    match plan_job(loaded, &Silent) {
        Ok(outcome) => outcome,
        Err(RunFailure::BadInput(d) | RunFailure::NotProducible(d)) => panic!("{d:?}"),
    }
}

/// The example's formula by hand: u over the profile that grinds, v over the width of 100 mm; mm, normal.
struct ByHand {
    rolls: [f64; 2],
    cos: f64,
}

impl WormModification for ByHand {
    fn jet(&self, w: f64, z: f64) -> [f64; 3] {
        let [from, to] = self.rolls;
        let (u, u_w) = ((2.0 * w - from - to) / (to - from), 2.0 / (to - from));
        let (v, v_z) = (z / 50.0, 1.0 / 50.0);
        let unit = 1e-3 * self.cos;
        let f = 4.0 * u * u - 30.0 * (v / 0.6).powi(2) + 3.0 * u * v;
        let f_u = 8.0 * u + 3.0 * v;
        let f_v = -60.0 * v / 0.36 + 3.0 * u;
        [unit * f, unit * f_u * u_w, unit * f_v * v_z]
    }

    fn domain(&self) -> [[f64; 2]; 2] {
        [[0.5 * self.rolls[0], 2.0 * self.rolls[1]], [-200.0, 200.0]]
    }
}

/// How far the worm's flank goes beyond the profile that grinds, mm.
const BEYOND: f64 = 0.4;

#[test]
fn the_worm_is_dressed_as_wanted_and_the_gear_follows_from_it() {
    let loaded = load();
    let outcome = planned(&loaded);
    let result = &outcome.result;
    assert_eq!(result.verdict.status(), Status::Met, "{:?}", result.verdict);
    let setup = &outcome.prepared.setup;
    for flank in Flank::BOTH {
        let (worm, gear) = (&result.worm[flank.name()], &result.flanks[flank.name()]);
        let lines = &setup.lines[flank];
        let by_hand = ByHand { rolls: lines.worm_rolls(&MotionLaw::zero()), cos: lines.cos_b1 };
        for (i, &w) in worm.w_mm.iter().enumerate() {
            for (k, &z) in worm.z_mm.iter().enumerate() {
                let wanted = 1e3 * by_hand.value(w, z);
                assert!((worm.wanted_um[i][k] - wanted).abs() < 1e-9, "{flank} {w} {z}");
            }
        }
        assert!(worm.max_deviation_um < 0.5, "{flank}: {}", worm.max_deviation_um);
        // Rays of the gear, cut by the wanted worm itself.
        let motion = setup.pair.motion(outcome.execution.motion.shift.clone());
        assert_eq!(outcome.execution.motion.delta_d, motion.delta_d);
        let occupation = lines.occupation(&motion.shift);
        let rays = RayGrid::new(gear.w_mm.clone(), gear.z_mm.clone()).unwrap();
        let cutting = Grinding {
            worm: setup.pair.worm.flank(flank),
            area: WormArea {
                // The formula goes on beyond the profile that grinds, where no worm is dressed so.
                w: [by_hand.rolls[0] - BEYOND, by_hand.rolls[1] + BEYOND],
                z: [occupation[0] - 20.0, occupation[1] + 20.0],
            },
            modification: &by_hand,
            work: setup.pair.work.flank(flank),
            motion: &motion,
            feed_range: outcome.execution.feed_range,
            stock: 0.2,
            threads: ActiveThreads::All,
            mode: GrindingMode::Continuous,
        };
        let cut = grind(&cutting, &rays, &Silent).unwrap().lengths().unwrap();
        for (i, row) in gear.target_um.iter().enumerate() {
            for (k, target) in row.iter().enumerate() {
                let left = cut[i * gear.z_mm.len() + k] * 1e3;
                assert!((left - target).abs() < 0.02, "{flank}: {left} {target}");
            }
        }
        assert!(gear.max_deviation_um < 1.0 && gear.model_difference_um < 0.02);
    }
}

#[test]
fn a_worm_that_no_dresser_makes_is_missed_by_name() {
    let mut loaded = load();
    loaded.job.worm.modifications =
        Some(vec![serde_json::from_str(r#"{ "kind": "formula", "f_um": "30*u^3*v" }"#).unwrap()]);
    let result = planned(&loaded).result;
    assert_eq!(result.verdict.status(), Status::Missed);
    assert_eq!(result.verdict.reason().unwrap().code, "worm-not-dressed");
    assert!(result.worm["left"].max_deviation_um > 1.0);
}
