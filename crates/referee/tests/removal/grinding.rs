//! Stage two against the exact contact solver and against zero.

use super::setups::{area, feeds, field, list, meshing, motion, pair, reference, worm_function};
use contact::{ExactContact, ModifiedThread};
use foundation::geometry::Flank;
use foundation::kinematics::{MotionLaw, Point};
use foundation::numerics::{Polynomial2, Silent};
use proptest::prelude::*;
use referee::{ActiveThreads, Grinding, GrindingMode, RayGrid, Unmodified, grind};

#[test]
fn ground_flanks_are_the_exact_contact() {
    let file = reference("20-generating-contact.json");
    for case in file["ground_flank"]["cases"].as_array().unwrap() {
        let input = &case["input"];
        let pair = pair(input);
        for flank in Flank::BOTH {
            let motion = motion(input, &pair, flank);
            let function = worm_function(input, flank);
            let expected = &case["expected"][flank.name()];
            let mut w = list(&expected["points_w_mm"]);
            let mut z = list(&expected["points_z_mm"]);
            for axis in [&mut w, &mut z] {
                axis.sort_by(f64::total_cmp);
                axis.dedup();
            }
            let grid = RayGrid::new(w, z).unwrap();
            let setup = Grinding {
                worm: pair.worm.flank(flank),
                area: area(&pair, flank, &grid, &motion, [3.0, 8.0]),
                modification: &function,
                work: pair.work.flank(flank),
                motion: &motion,
                feed_range: feeds(&pair, flank, &grid, &motion, 4.0),
                stock: 0.2,
                threads: ActiveThreads::All,
                mode: GrindingMode::Continuous,
            };
            let left = grind(&setup, &grid, &Silent).unwrap();
            let thread = ModifiedThread::new(*pair.worm.flank(flank), &function);
            let exact = ExactContact::new(&pair, flank, &motion, &thread);
            let wanted = list(&expected["f_n2_ray_um"]);
            for (index, f) in left.lengths().unwrap().iter().enumerate() {
                let (w, z) = grid.ray(index);
                let solved = exact.solve(w, z).unwrap().f_n;
                let off = (f - solved).abs() * 1e3;
                assert!(off < 1e-6 && off <= left.error_um, "{} {flank} {w} {z}: {off} um", case["name"]);
                assert!((f * 1e3 - wanted[index]).abs() < 1e-5);
            }
        }
    }
}

/// Uniform numbers in [0, 1) from a linear congruential generator (Knuth's MMIX constants).
fn uniform(state: &mut u64) -> f64 {
    *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*state >> 11) as f64 / (1u64 << 53) as f64
}

#[test]
fn no_pose_of_the_whole_motion_cuts_deeper() {
    let file = reference("20-generating-contact.json");
    let input = &file["ground_flank"]["cases"][2]["input"];
    let (pair, flank) = (pair(input), Flank::Right);
    let motion = motion(input, &pair, flank);
    let function = worm_function(input, flank);
    let grid = RayGrid::equidistant([5.0, 22.0], 4, [-18.0, 18.0], 4).unwrap();
    let setup = Grinding {
        worm: pair.worm.flank(flank),
        area: area(&pair, flank, &grid, &motion, [3.0, 8.0]),
        modification: &function,
        work: pair.work.flank(flank),
        motion: &motion,
        feed_range: feeds(&pair, flank, &grid, &motion, 4.0),
        stock: 0.2,
        threads: ActiveThreads::All,
        mode: GrindingMode::Continuous,
    };
    let left = grind(&setup, &grid, &Silent).unwrap();
    let [from, to] = setup.feed_range;
    let (worm, area) = (setup.worm, setup.area);
    let whole_turn = 2.0 * std::f64::consts::PI * motion.teeth / motion.threads;
    let mut state = 1;
    let (mut near, mut lowest) = (0, f64::INFINITY);
    for (index, ray) in left.rays.iter().enumerate() {
        let (w, z) = grid.ray(index);
        let ray = ray.unwrap();
        let frame = setup.work.frame(w, z);
        let end = Point::from_vector(setup.work.point_in(&frame, w, z) + frame.n * ray.f);
        let coupled = motion.state(0.0, ray.feed, motion.phase[flank]).work_angle - ray.work_angle;
        for k in 0..40_000 {
            // Half of the poses anywhere, half of them near the cut.
            let (feed, angle) = if k % 2 == 0 {
                (from + (to - from) * uniform(&mut state), whole_turn * uniform(&mut state))
            } else {
                let feed = (ray.feed + 4.0 * (uniform(&mut state) - 0.5)).clamp(from, to);
                (feed, coupled * motion.teeth / motion.threads + 0.4 * (uniform(&mut state) - 0.5))
            };
            let pose = motion.chain.pose(&motion.state(angle, feed, motion.phase[flank]));
            let at = worm.deviation(&pose.point(&end).xyz);
            let exists = at.w > area.w[0] && at.w < area.w[1] && at.z > area.z[0] && at.z < area.z[1];
            let gap = at.f_n - Polynomial2::value(&function, at.w, at.z);
            if exists && gap.abs() < 0.2 {
                near += 1;
                lowest = lowest.min(gap);
            }
        }
    }
    assert!(near > 50_000, "{near}");
    assert!(lowest > -1e-11 && lowest < 1e-5, "{lowest}");
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 12, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn an_unmodified_pair_leaves_nothing(
        teeth in 14..60i32,
        module in 1.0..5.0f64,
        alpha in 15.0..25.0f64,
        beta in -35.0..35.0f64,
        threads in 1..6i32,
        ratio in -2.0..2.0f64,
        slimness in 30.0..60.0f64,
    ) {
        let pair = meshing(teeth, module, alpha, beta, threads, slimness * module);
        let motion = pair.motion(MotionLaw::polynomial(0.0, vec![0.0, ratio]));
        for flank in Flank::BOTH {
            let grid = field(&pair.work, flank, 7, 8.0 * module, 7);
            // A worm that reaches beyond the contact at the gear's base circle would undercut the gear.
            let f = &pair.flanks[flank];
            let tip = 0.5 * grid.w()[0] * f.hat_w2 / f.hat_w1;
            let setup = Grinding {
                worm: pair.worm.flank(flank),
                area: area(&pair, flank, &grid, &motion, [tip, 4.0 * module]),
                modification: &Unmodified,
                work: pair.work.flank(flank),
                motion: &motion,
                feed_range: feeds(&pair, flank, &grid, &motion, 2.0),
                stock: 0.1,
                threads: ActiveThreads::All,
                mode: GrindingMode::Continuous,
            };
            let left = grind(&setup, &grid, &Silent).unwrap();
            prop_assert!(left.error_um < 1e-5);
            for f in left.lengths().unwrap() {
                prop_assert!(f.abs() * 1e3 <= left.error_um, "{f} mm, stated {} um", left.error_um);
            }
        }
    }
}
