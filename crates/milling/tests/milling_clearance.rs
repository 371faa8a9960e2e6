//! The search for the clearance of a cutter from a surface, against sampling: every surface, every cutter, poses by chance.

use crate::surface_cases::{between, offset, samples};
use foundation::geometry::{Cutter, CutterShape, Modified, ShankStep, Surface, in_tool};
use milling::{HIDDEN, Patch};
use nalgebra::{Rotation3, Vector3};
use proptest::prelude::*;

/// Mill, cone, ball, torus, barrel and drum, with neck and holder.
fn cutters() -> Vec<Cutter> {
    let cone = CutterShape::Conical { radius: 1.5, half_angle: 0.05, corner_radius: 0.5 };
    let barrel = CutterShape::Barrel { radius: 4.0, height: 6.0, profile_radius: 30.0 };
    let drum = CutterShape::Barrel { radius: 6.0, height: 3.0, profile_radius: 2.5 };
    let shank = || vec![ShankStep { radius: 2.0, from: 12.0 }, ShankStep { radius: 9.0, from: 25.0 }];
    [
        CutterShape::end_mill(3.0, 0.0),
        CutterShape::end_mill(2.5, 1.0),
        CutterShape::ball(2.0),
        cone,
        barrel,
        drum,
    ]
    .into_iter()
    .map(|shape| Cutter::new(shape, 12.0, shank()).unwrap())
    .collect()
}

/// Directions and lengths by chance, in shares of what they are of.
fn shares<const N: usize>() -> impl Strategy<Value = [f64; N]> {
    prop::array::uniform(0.0..1.0f64)
}

fn distance(patch: &Patch, cutter: &Cutter, tip: &Vector3<f64>, axis: &Vector3<f64>, at: [f64; 2]) -> f64 {
    let point =
        Rotation3::from_axis_angle(&Vector3::z_axis(), patch.turn) * patch.surface.point(at[0], at[1]);
    let [rho, z] = in_tool(&point, tip, axis);
    cutter.distance(rho, z)
}

/// Places over a box, its borders included.
const SAMPLED: usize = 40;

/// How far inside of a cutter a place may lie for its depth to be asked for, mm.
const DEEPEST: f64 = 0.2;

fn sampled(heights: [f64; 2], lengths: [f64; 2]) -> impl Iterator<Item = [f64; 2]> {
    let share = |k: usize| k as f64 / SAMPLED as f64;
    let row =
        move |i: usize| (0..=SAMPLED).map(move |j| [between(heights, share(i)), between(lengths, share(j))]);
    (0..=SAMPLED).flat_map(row)
}

fn check(patch: &Patch, cutter: &Cutter, tip: &Vector3<f64>, axis: &Vector3<f64>) {
    let at = |place| distance(patch, cutter, tip, axis, place);
    let least = sampled(patch.heights, patch.lengths).map(at).fold(f64::INFINITY, f64::min);
    if least < -DEEPEST {
        // How deep a cutter is inside matters to nobody, and is the same along whole lines.
        assert!(patch.keeps(cutter, tip, axis, 0.0).is_err());
        return;
    }
    let found = patch.clearance(cutter, tip, axis);
    assert!((at(found.place) - found.value).abs() < 1e-12, "{found:?}");
    assert!(found.lower_bound <= found.value && found.value - found.lower_bound <= HIDDEN, "{found:?}");
    assert!(found.lower_bound <= least + 1e-12 && found.value <= least + HIDDEN, "{found:?} against {least}");
    // Around the place nothing is nearer: it has been polished. Inside of a sharp corner the distance has an edge.
    let shares: &[f64] = if found.value > 0.0 { &[1e-2, 1e-3, 1e-4] } else { &[] };
    for share in shares {
        let [a, b] = [patch.heights, patch.lengths];
        let around = |[from, to]: [f64; 2], at: f64| {
            let reach = share * (to - from);
            [(at - reach).max(from), (at + reach).min(to)]
        };
        for place in sampled(around(a, found.place[0]), around(b, found.place[1])) {
            assert!(at(place) >= found.value - 1e-9, "{found:?} but {} at {place:?}", at(place));
        }
    }
    let keeps = |wanted| patch.keeps(cutter, tip, axis, wanted);
    assert!(keeps(found.value - 2.0 * HIDDEN).is_ok());
    let near = keeps(found.value + 1e-9).expect_err("it comes nearer");
    assert!((at(near.place) - near.value).abs() < 1e-12 && near.lower_bound < found.value + 1e-9);
    for wanted in [found.value - 3.0, found.value - 0.1] {
        let bound = patch.lower_bound(cutter, tip, axis, wanted, 1e-2);
        let enough = (0.5 * (wanted + found.value)).min(found.value - 1e-2) - 1e-9;
        assert!(bound <= least + 1e-12 && bound >= enough, "{bound} of {found:?}, {wanted} wanted");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 16, ..ProptestConfig::default() })]

    #[test]
    fn clearances_are_those_of_sampled_surfaces(
        number in 0usize..6,
        place in shares::<2>(),
        pose in shares::<5>(),
        eased in any::<bool>(),
    ) {
        let cutter = &cutters()[number];
        for sample in samples() {
            let (heights, lengths) = (sample.heights, sample.lengths);
            let modified;
            let surface: &dyn Surface = if eased {
                modified = Modified::new(sample.surface.clone(), offset(heights, lengths));
                &modified
            } else {
                &sample.surface
            };
            let patch = Patch { surface, heights, lengths, turn: 0.4 * (pose[4] - 0.5) };
            let turn = Rotation3::from_axis_angle(&Vector3::z_axis(), patch.turn);
            let jet = surface.jet(between(heights, place[0]), between(lengths, place[1]));
            let leant = Vector3::new(pose[0] - 0.5, pose[1] - 0.5, pose[2] - 0.5) * 1.6;
            let axis = (turn * (jet.normal + leant)).normalize();
            // From inside of the surface to far off.
            let tip = turn * (jet.point + jet.normal * (12.0 * pose[3] - 1.0));
            check(&patch, cutter, &tip, &axis);
        }
    }
}
