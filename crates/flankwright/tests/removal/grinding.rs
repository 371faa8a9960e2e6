//! Stage two against the exact contact solver and against zero.

use crate::setups::{area, feeds, field, list, meshing, motion, pair, reference, worm_function};
use flankwright::contact::{ExactContact, ModifiedThread};
use flankwright::geometry::Flank;
use flankwright::kinematics::MotionLaw;
use flankwright::numerics::Silent;
use flankwright::removal::{Grinding, GrindingMode, RayGrid, Unmodified, grind};
use proptest::prelude::*;

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
