//! Bounds of speeds and of turning normals: they hold at random places of random boxes, and small boxes have tight ones.

use super::cases::{Sample, between, chances, offset, samples};
use foundation::geometry::{Modified, NormalOffset, OffsetBase, Surface};
use nalgebra::Vector3;

/// A box inside the sample's of a share of its sides, at a place by chance.
fn part(sample: &Sample, share: f64, chance: &mut impl FnMut() -> f64) -> [[f64; 2]; 2] {
    [sample.heights, sample.lengths].map(|range| {
        let from = chance() * (1.0 - share);
        [between(range, from), between(range, from + share)]
    })
}

/// Largest share of the bounds that is reached at places of a box by chance, corners and middle included.
fn reached(
    [heights, lengths]: [[f64; 2]; 2],
    bounds: [f64; 2],
    chance: &mut impl FnMut() -> f64,
    at: impl Fn(f64, f64) -> [f64; 2],
) -> [f64; 2] {
    let mut places = vec![[0.0, 0.0], [0.0, 1.0], [1.0, 0.0], [1.0, 1.0], [0.5, 0.5]];
    places.extend((0..60).map(|_| [chance(), chance()]));
    let mut largest = [0.0f64; 2];
    for [p, q] in places {
        let found = at(between(heights, p), between(lengths, q));
        for i in 0..2 {
            largest[i] = largest[i].max(found[i]);
        }
    }
    [0, 1].map(|i| if bounds[i] == 0.0 && largest[i] == 0.0 { 1.0 } else { largest[i] / bounds[i] })
}

fn speeds(surface: &impl Surface, a: f64, b: f64) -> [f64; 2] {
    let jet = surface.jet(a, b);
    [jet.by_height.norm(), jet.by_length.norm()]
}

const ROUNDING: f64 = 1.0 + 1e-12;

#[test]
fn speeds_of_every_surface_stay_below_their_bounds() {
    let mut chance = chances();
    for sample in samples() {
        let eased = Modified::new(sample.surface.clone(), offset(sample.heights, sample.lengths));
        for (share, least) in [(1.0, 0.0), (0.4, 0.0), (0.05, 0.8), (0.002, 0.97)] {
            for _ in 0..12 {
                let part = part(&sample, share, &mut chance);
                let bounds = sample.surface.speed_bounds(part[0], part[1]);
                let eased_bounds = eased.speed_bounds(part[0], part[1]);
                let plain = reached(part, bounds, &mut chance, |a, b| speeds(&sample.surface, a, b));
                let moved = reached(part, eased_bounds, &mut chance, |a, b| speeds(&eased, a, b));
                for reached in plain.into_iter().chain(moved) {
                    assert!(reached <= ROUNDING, "{} {share}: {reached} of the bound", sample.name);
                    assert!(reached >= least, "{} {share}: only {reached} of the bound", sample.name);
                }
            }
        }
    }
}

#[test]
fn normals_of_every_surface_turn_more_slowly_than_their_bounds() {
    let mut chance = chances();
    for sample in samples() {
        for (share, least) in [(0.4, 0.0), (0.05, 0.0), (0.002, 0.3)] {
            for _ in 0..12 {
                let part = part(&sample, share, &mut chance);
                let bounds = sample.surface.normal_speed_bounds(part[0], part[1]);
                let found = reached(part, bounds, &mut chance, |a, b| {
                    let jet = sample.surface.jet(a, b);
                    [jet.normal_by_height.norm(), jet.normal_by_length.norm()]
                });
                assert!(found[0].max(found[1]) <= ROUNDING, "{} {share}: {found:?}", sample.name);
                assert!(found[0] >= least, "{} {share}: {found:?}", sample.name);
                assert!(share > 0.01 || bounds.iter().all(|b| b.is_finite()), "{}: {bounds:?}", sample.name);
            }
        }
    }
}

#[test]
fn an_ease_off_stays_below_its_bounds() {
    let (heights, lengths) = ([2.0, 9.0], [-4.0, 6.0]);
    let ease_off = offset(heights, lengths);
    let mut chance = chances();
    for _ in 0..50 {
        let share = chance();
        let part = [heights, lengths].map(|range| {
            let from = chance() * (1.0 - share);
            [between(range, from), between(range, from + share)]
        });
        let bounds = ease_off.bounds(part[0], part[1]);
        for _ in 0..50 {
            let jet = ease_off.jet(between(part[0], chance()), between(part[1], chance()));
            assert!(jet.f.abs() <= bounds.value * ROUNDING && jet.fu.abs() <= bounds.by_height * ROUNDING);
            assert!(jet.fv.abs() <= bounds.by_length * ROUNDING);
        }
    }
}

/// A bound over a box, and what is to stay below it: a vector with its derivatives by height and length.
struct Linear<'a> {
    name: &'a str,
    bound: &'a dyn Fn([f64; 2], [f64; 2]) -> f64,
    at: &'a dyn Fn(f64, f64) -> [Vector3<f64>; 3],
}

impl Linear<'_> {
    /// The bound holds over the box, and in a small one a good part of it is reached, if it is `exact` there.
    fn check(&self, part: [[f64; 2]; 2], least: f64, chance: &mut impl FnMut() -> f64) {
        let middle = part.map(|range| between(range, 0.5));
        let [value, by_height, by_length] = (self.at)(middle[0], middle[1]);
        let bound = (self.bound)(part[0], part[1]);
        let [reached, _] = reached(part, [bound, 1.0], chance, |a, b| {
            let straight = value + by_height * (a - middle[0]) + by_length * (b - middle[1]);
            [((self.at)(a, b)[0] - straight).norm() - 1e-12, 0.0]
        });
        assert!(reached <= ROUNDING, "{}: {reached} of the bound {bound}", self.name);
        assert!(reached >= least, "{}: only {reached} of the bound {bound}", self.name);
    }
}

#[test]
fn surfaces_and_normals_leave_their_tangents_by_less_than_their_bounds() {
    let mut chance = chances();
    for sample in samples() {
        let surface = &sample.surface;
        let eased = Modified::new(surface.clone(), offset(sample.heights, sample.lengths));
        let of = |surface: &dyn Surface, a, b| {
            let jet = surface.jet(a, b);
            [jet.point, jet.by_height, jet.by_length]
        };
        let normal = |a, b| {
            let jet = surface.jet(a, b);
            [jet.normal, jet.normal_by_height, jet.normal_by_length]
        };
        let name = sample.name;
        let plain = Linear { name, bound: &|a, b| surface.off_tangent(a, b), at: &|a, b| of(surface, a, b) };
        let moved = Linear { name, bound: &|a, b| eased.off_tangent(a, b), at: &|a, b| of(&eased, a, b) };
        let turned = Linear { name, bound: &|a, b| surface.normal_off_tangent(a, b), at: &normal };
        for (share, least) in [(1.0, 0.0), (0.4, 0.0), (0.05, 0.2), (0.01, 0.35)] {
            for _ in 0..12 {
                let part = part(&sample, share, &mut chance);
                plain.check(part, least, &mut chance);
                moved.check(part, 0.0, &mut chance);
                turned.check(part, 0.0, &mut chance);
            }
        }
    }
}
