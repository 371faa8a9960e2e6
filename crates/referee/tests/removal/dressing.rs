//! Stage one against the exact envelope of the moving dresser.

use super::setups::{dressing_cases, list};
use dressing::{DressedWorm, dressing_motion};
use foundation::geometry::{Flank, ProfileOffset};
use foundation::kinematics::DressingMotion;
use foundation::numerics::Silent;
use referee::{DressedFlank, Dressing, RayGrid, dress};
use std::sync::Arc;

const STROKE: [f64; 2] = [-40.0, 40.0];

fn dressed(
    worm: &foundation::geometry::InvoluteFlank,
    dresser: &foundation::geometry::Revolution,
    motion: &DressingMotion,
    grid: &RayGrid,
) -> DressedFlank {
    let setup = Dressing { worm, dresser, motion, shift_range: STROKE, stock: 0.2 };
    dress(&setup, grid, &Silent).unwrap()
}

/// Largest distance from the exact envelope, um.
fn distance(flank: &DressedFlank, envelope: &DressedWorm) -> f64 {
    let mut worst: f64 = 0.0;
    for (index, ray) in flank.rays.iter().enumerate() {
        let (w, z) = flank.grid.ray(index);
        let (f, _, v) = envelope.modification(w, z).unwrap();
        let ray = ray.unwrap();
        worst = worst.max((ray.f - f).abs() * 1e3);
        assert!((ray.shift - v).abs() < 1e-3, "{} {v}", ray.shift);
    }
    worst
}

#[test]
fn the_unmodified_dresser_leaves_the_unmodified_worm() {
    for case in dressing_cases() {
        for flank in Flank::BOTH {
            let grid =
                RayGrid::equidistant([case.range.w_nf, case.range.w_na], 9, [-15.0, 15.0], 11).unwrap();
            let motion = DressingMotion::constant(case.tool.flanks.left.chain, [0.0; 4]);
            let tool = &case.tool.flanks[flank];
            let left = dressed(case.worm.flank(flank), &tool.profile, &motion, &grid);
            assert!(left.error_um < 1e-6, "{}", left.error_um);
            for f in left.lengths().unwrap() {
                assert!(f.abs() * 1e3 <= left.error_um, "{f} {}", left.error_um);
            }
        }
    }
}

#[test]
fn topological_dressing_is_the_exact_envelope() {
    for case in dressing_cases() {
        let motion = dressing_motion(case.tool.flanks.left.chain, &case.corrections);
        for flank in Flank::BOTH {
            let envelope = DressedWorm::new(&case.tool, flank, &case.corrections);
            let grid =
                RayGrid::equidistant([case.range.w_nf, case.range.w_na], 9, [-15.0, 15.0], 11).unwrap();
            let left = dressed(case.worm.flank(flank), &case.tool.flanks[flank].profile, &motion, &grid);
            let worst = distance(&left, &envelope);
            assert!(worst < 1e-7, "{worst} um, stated {}", left.error_um);
            assert!(worst <= left.error_um, "{worst} um, stated {}", left.error_um);
        }
        let t = &case.expected;
        let (w, b, f) = (list(&t["w_mm"]), list(&t["b_mm"]), list(&t["f_exact_um"]));
        for k in 0..w.len() {
            let grid = RayGrid::new(vec![w[k]], vec![b[k]]).unwrap();
            let tool = &case.tool.flanks.left.profile;
            let left = dressed(case.worm.flank(Flank::Left), tool, &motion, &grid);
            assert!((left.lengths().unwrap()[0] * 1e3 - f[k]).abs() < 1e-5);
        }
    }
}

/// A parabola of 5 um over 7 mm.
#[derive(Debug)]
struct Crowned {
    middle: f64,
}

impl ProfileOffset for Crowned {
    fn jet(&self, t: f64) -> [f64; 3] {
        let (c, x) = (0.005 / (3.5 * 3.5), t - self.middle);
        [c * x * x, 2.0 * c * x, 2.0 * c]
    }
}

#[test]
fn a_modified_dresser_leaves_its_envelope() {
    for case in dressing_cases() {
        let mut tool = case.tool.clone();
        let offset = Arc::new(Crowned { middle: case.range.middle() });
        for flank in Flank::BOTH {
            tool.flanks[flank].profile = case.tool.flanks[flank].profile.with_offset(offset.clone());
        }
        let motion = dressing_motion(case.tool.flanks.left.chain, &case.corrections);
        let envelope = DressedWorm::new(&tool, Flank::Right, &case.corrections);
        let grid = RayGrid::equidistant([case.range.w_nf, case.range.w_na], 7, [-12.0, 12.0], 7).unwrap();
        let left = dressed(case.worm.flank(Flank::Right), &tool.flanks.right.profile, &motion, &grid);
        let worst = distance(&left, &envelope);
        assert!(worst < 1e-6 && worst <= left.error_um, "{worst} um, stated {}", left.error_um);
    }
}

#[test]
fn the_surface_states_what_it_misses() {
    let case = &dressing_cases()[0];
    let motion = dressing_motion(case.tool.flanks.left.chain, &case.corrections);
    let envelope = DressedWorm::new(&case.tool, Flank::Left, &case.corrections);
    let dresser = &case.tool.flanks.left.profile;
    let mut last = f64::INFINITY;
    for step in [2.0, 1.0, 0.5] {
        let grid =
            RayGrid::spaced([case.range.w_nf, case.range.w_na], step, [-15.0, 15.0], 2.0 * step).unwrap();
        let surface = dressed(case.worm.flank(Flank::Left), dresser, &motion, &grid).surface().unwrap();
        assert!(surface.interpolation_um < last);
        last = surface.interpolation_um;
        for k in 0..200 {
            // Low-discrepancy points: golden-ratio steps in w, equal ones in z.
            let w = case.range.w_nf + case.range.length() * (0.618_033_988_75 * k as f64).fract();
            let z = -15.0 + 30.0 * k as f64 / 199.0;
            let (exact, ..) = envelope.modification(w, z).unwrap();
            let miss = (referee::WormModification::value(&surface, w, z) - exact).abs() * 1e3;
            assert!(miss <= 1.5 * surface.error_um, "{miss} {}", surface.error_um);
        }
    }
    assert!(last < 1e-4, "{last}");
}
