//! Stage two for cylinder and cone on both sides: an unmodified worm leaves nothing, a modified one what the exact contact
//! says.

use super::setups::{area, feeds, meshing_with, pair, reference};
use contact::{ExactContact, ModifiedThread, Pair};
use foundation::geometry::{Flank, GearData, Sides};
use foundation::kinematics::{GeneratingMotion, MotionLaw};
use foundation::numerics::{Polynomial2, Silent};
use proptest::prelude::*;
use referee::{
    ActiveThreads, Grinding, GrindingMode, GroundFlank, RayGrid, Unmodified, WormModification, grind,
};

/// Rays between the form circle that the pair can reach and one module above the pitch circle; on a beveloid the tooth
/// moves with z, and the rays stay clear of the ends of both faces.
fn rays(pair: &Pair, flank: Flank, motion: &GeneratingMotion, width: f64) -> RayGrid {
    let work = pair.work.flank(flank);
    let (m, r) = (pair.work.data().normal_module, pair.work.pitch_radius());
    let rise = 0.5 * width * pair.work.data().cone_angle.tan().abs();
    let low = work.length_of_roll((r - 0.7 * m + rise).max(1.02 * work.base_radius)).unwrap();
    let high = work.length_of_roll(r + 0.9 * m).unwrap();
    let f = &pair.flanks[flank];
    assert!(f.worm_roll(high, motion.shift.value(0.0), 0.0) > 0.0);
    RayGrid::equidistant([low, high], 5, [-0.5 * width, 0.5 * width], 5).unwrap()
}

fn shot(
    pair: &Pair,
    flank: Flank,
    motion: &GeneratingMotion,
    modification: &dyn WormModification,
    grid: &RayGrid,
) -> GroundFlank {
    let m = pair.work.data().normal_module;
    let f = &pair.flanks[flank];
    // A worm that reaches beyond the contact at the gear's base circle would undercut the gear.
    let tip = 0.4 * grid.w()[0] * f.hat_w2 / f.hat_w1;
    let setup = Grinding {
        worm: pair.worm.flank(flank),
        area: area(pair, flank, grid, motion, [tip, 3.0 * m]),
        modification,
        work: pair.work.flank(flank),
        motion,
        feed_range: feeds(pair, flank, grid, motion, 2.0),
        stock: 0.1,
        threads: ActiveThreads::All,
        mode: GrindingMode::Continuous,
    };
    grind(&setup, grid, &Silent).unwrap()
}

/// A crowning, a twist and a slope of some 10 um about the middle of the worm's area.
fn function(pair: &Pair, flank: Flank, grid: &RayGrid, motion: &GeneratingMotion) -> Polynomial2 {
    let area = area(pair, flank, grid, motion, [0.0, 0.0]);
    let middle = |[from, to]: [f64; 2]| 0.5 * (from + to);
    let half = |[from, to]: [f64; 2]| 0.5 * (to - from);
    let (w, z) = (half(area.w), half(area.z));
    let terms = [
        (0, 0, 4.0),
        (1, 0, 1.5 / w),
        (0, 1, -5.0 / z),
        (1, 1, 1.0 / (w * z)),
        (2, 0, -1.0 / (w * w)),
        (0, 2, -10.0 / (z * z)),
    ];
    Polynomial2::from_terms(terms.map(|(i, j, um)| (i, j, um * 1e-3)))
        .shifted(-middle(area.w), -middle(area.z))
}

fn compare(pair: &Pair, flank: Flank, motion: &GeneratingMotion, width: f64) {
    let grid = rays(pair, flank, motion, width);
    let plain = shot(pair, flank, motion, &Unmodified, &grid);
    for f in plain.lengths().unwrap() {
        assert!(f.abs() * 1e3 < 1e-6 && f.abs() * 1e3 <= plain.error_um, "{flank}: {f} mm");
    }
    let function = function(pair, flank, &grid, motion);
    let modified = shot(pair, flank, motion, &function, &grid);
    let thread = ModifiedThread::new(*pair.worm.flank(flank), &function);
    let exact = ExactContact::new(pair, flank, motion, &thread);
    let mut largest: f64 = 0.0;
    for (index, ray) in modified.rays.iter().enumerate() {
        let (w, z) = grid.ray(index);
        let solved = exact.solve(w, z).unwrap();
        let ray = ray.unwrap();
        assert!((ray.f - solved.f_n).abs() * 1e3 < 1e-4, "{flank} {w} {z}: {} {}", ray.f, solved.f_n);
        largest = largest.max(ray.f.abs());
    }
    assert!(largest > 1e-3, "the modification leaves no trace: {largest}");
}

#[test]
fn every_reference_pair_grinds_what_the_exact_contact_says() {
    let file = reference("20-generating-contact.json");
    let cases = file["cases"].as_array().unwrap();
    let mut seen = [[0; 2]; 2];
    for case in cases {
        let pair = pair(&case["input"]);
        seen[usize::from(pair.chain.worm_cone != 0.0)][usize::from(pair.chain.work_cone != 0.0)] += 1;
        let motion = pair.motion(MotionLaw::polynomial(0.0, vec![1.5, 0.8, 0.02, -3e-4]));
        for flank in Flank::BOTH {
            compare(&pair, flank, &motion, 14.0);
        }
    }
    assert!(seen.iter().flatten().all(|&count| count > 0), "{seen:?}");
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn random_cones_grind_what_the_exact_contact_says(
        teeth in 18..50i32,
        module in 1.5..4.0f64,
        left in 17.0..24.0f64,
        right in 17.0..24.0f64,
        beta in -30.0..30.0f64,
        threads in 1..5i32,
        slimness in 35.0..60.0f64,
        right_hand in any::<bool>(),
        cones in (-9.0..9.0f64, -7.0..7.0f64, 0..4u8),
        law in (-1.0..1.0f64, -0.02..0.02f64),
    ) {
        let (worm_cone, work_cone, kind) = cones;
        let data = GearData {
            teeth,
            normal_module: module,
            pressure_angle: Sides { left: left.to_radians(), right: right.to_radians() },
            helix_angle: beta.to_radians(),
            profile_shift: 0.1,
            cone_angle: if kind & 1 == 0 { 0.0 } else { work_cone.to_radians() },
        };
        let worm_cone = if kind & 2 == 0 { 0.0 } else { worm_cone.to_radians() };
        let pair = meshing_with(data, (threads, if right_hand { 1.0 } else { -1.0 }), slimness * module, worm_cone);
        let motion = pair.motion(MotionLaw::polynomial(0.0, vec![0.0, law.0, law.1]));
        for flank in Flank::BOTH {
            compare(&pair, flank, &motion, 5.0 * module);
        }
    }
}
