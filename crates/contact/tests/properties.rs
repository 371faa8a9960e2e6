//! Random pairs of cylinders and cones, symmetric and asymmetric: the contact found by a search that knows the chain and
//! the flanks only lies on the closed-form path, the map of points goes both ways, and feeds move the contact one way.

use contact::{DiagonalRatio, Pair};
use foundation::geometry::{Flank, Gear, GearData, InvoluteFlank, Sides};
use foundation::kinematics::{Direction, GeneratingChain, GeneratingState, Point};
use nalgebra::{SMatrix, SVector, Vector3};
use proptest::prelude::*;

/// Cylinder and cone in all four combinations with the same weight.
fn pairs() -> impl Strategy<Value = (Pair, Flank)> {
    let work = (
        14..70i32,
        1.2..5.0f64,
        15.0..25.0f64,
        prop::option::of(15.0..25.0f64),
        -35.0..35.0f64,
        -0.2..0.4f64,
    );
    let cones = (-4.0..4.0f64, -5.0..5.0f64, 0..4u8);
    let worm = (1..6i32, any::<bool>(), 35.0..80.0f64);
    (work, worm, cones, any::<bool>()).prop_filter_map("no pair", |(work, worm, cones, left)| {
        let (teeth, normal_module, alpha, other, beta, profile_shift) = work;
        let (threads, right_hand, slimness) = worm;
        let (worm_cone, work_cone, kind) = cones;
        let cone = |deg: f64, bit: u8| if kind & bit == 0 { 0.0 } else { deg.to_radians() };
        let data = GearData {
            teeth,
            normal_module,
            pressure_angle: Sides { left: alpha.to_radians(), right: other.unwrap_or(alpha).to_radians() },
            helix_angle: beta.to_radians(),
            profile_shift,
            cone_angle: cone(work_cone, 1),
        };
        let hand = if right_hand { 1.0 } else { -1.0 };
        let worm = GearData {
            teeth: threads,
            helix_angle: hand * (f64::from(threads) / slimness).acos(),
            profile_shift: 0.0,
            cone_angle: cone(worm_cone, 2),
            ..data
        };
        let gamma = -(worm.helix_angle + data.helix_angle);
        let pair = Pair::without_backlash(Gear::new(worm).ok()?, Gear::new(data).ok()?, gamma).ok()?;
        Some((pair, if left { Flank::Left } else { Flank::Right }))
    })
}

/// Length of roll of a workpiece point: share -1..1 over two thirds of a module about the pitch cylinder.
fn roll(pair: &Pair, flank: Flank, share: f64) -> f64 {
    let alpha = pair.work.transverse_pressure_angle(flank);
    let middle = pair.work.pitch_radius() * alpha.sin();
    middle + share * (0.66 * pair.work.data().normal_module / alpha.sin()).min(0.6 * middle)
}

/// A flank point with the outward normal, by the formula of the conventions, and the two tangents as differences of it.
struct Surface<'a>(&'a InvoluteFlank);

impl Surface<'_> {
    fn point(&self, w: f64, z: f64) -> Vector3<f64> {
        let (f, s) = (self.0, self.0.flank.sign());
        let phi =
            s * (w / f.base_radius + f.base_space_half_angle) - z * f.base_helix_angle.tan() / f.base_radius;
        let (sin, cos) = phi.sin_cos();
        Vector3::new(f.base_radius * sin - s * w * cos, f.base_radius * cos + s * w * sin, z)
    }

    /// Tangents along w and z, by the product rule on the formula above.
    fn tangents(&self, w: f64, z: f64) -> [Vector3<f64>; 2] {
        let (f, s) = (self.0, self.0.flank.sign());
        let phi =
            s * (w / f.base_radius + f.base_space_half_angle) - z * f.base_helix_angle.tan() / f.base_radius;
        let (sin, cos) = phi.sin_cos();
        let turning =
            Vector3::new(f.base_radius * cos + s * w * sin, -f.base_radius * sin + s * w * cos, 0.0);
        let along_w = turning * (s / f.base_radius) + Vector3::new(-s * cos, s * sin, 0.0);
        let along_z = turning * (-f.base_helix_angle.tan() / f.base_radius) + Vector3::z();
        [along_w, along_z]
    }

    fn normal(&self, w: f64, z: f64) -> Vector3<f64> {
        let [a, b] = self.tangents(w, z);
        let n = a.cross(&b).normalize();
        // Out of the material: into the space, which on the left flank lies towards -x at the middle of the space.
        let point = self.point(w, z);
        let radial = Vector3::new(point.x, point.y, 0.0).normalize();
        let round = Vector3::new(radial.y, -radial.x, 0.0);
        if n.dot(&round) * self.0.flank.sign() > 0.0 { -n } else { n }
    }
}

/// Lengths are of this size, mm (`docs/mathematics/generating-contact.md#how-it-is-verified`).
const SCALE: f64 = 20.0;

/// The five conditions of a contact for x = (w_1, z_1, z_2)/20 mm, phi_1, phi_2.
fn conditions(
    chain: &GeneratingChain,
    [worm, work]: [&Surface<'_>; 2],
    [shift, feed, w_2]: [f64; 3],
    x: &SVector<f64, 5>,
) -> SVector<f64, 5> {
    let [w_1, z_1, z_2] = [x[0] * SCALE, x[1] * SCALE, x[2] * SCALE];
    let state =
        GeneratingState { worm_angle: x[3], work_angle: x[4], shift, feed, delta_d: 0.0, delta_gamma: 0.0 };
    let pose = chain.pose(&state);
    let apart = (worm.point(w_1, z_1) - pose.point(&Point::from_vector(work.point(w_2, z_2))).xyz) / SCALE;
    let normal = pose.direction(&Direction::from_vector(work.normal(w_2, z_2))).xyz;
    let [a, b] = worm.tangents(w_1, z_1).map(|t| t.normalize().dot(&normal));
    SVector::from([apart.x, apart.y, apart.z, a, b])
}

/// Newton with differences for the Jacobian; the solution does not depend on it. `None` where it does not settle.
fn solve(
    chain: &GeneratingChain,
    bodies: [&Surface<'_>; 2],
    at: [f64; 3],
    mut x: SVector<f64, 5>,
) -> Option<SVector<f64, 5>> {
    let f = |x: &SVector<f64, 5>| conditions(chain, bodies, at, x);
    let mut value = f(&x);
    for _ in 0..60 {
        let mut jacobian = SMatrix::<f64, 5, 5>::zeros();
        for k in 0..5 {
            let h = 1e-6;
            let (mut up, mut down) = (x, x);
            up[k] += h;
            down[k] -= h;
            jacobian.set_column(k, &((f(&up) - f(&down)) / (2.0 * h)));
        }
        let step = jacobian.lu().solve(&value)?;
        // Half steps while the conditions get worse.
        let mut share = 1.0;
        loop {
            let next = x - step * share;
            let there = f(&next);
            if there.norm() < value.norm() || share < 1e-3 {
                (x, value) = (next, there);
                break;
            }
            share *= 0.5;
        }
        if step.norm() < 1e-13 {
            break;
        }
    }
    (value.norm() < 1e-12).then_some(x)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    /// From a start somewhere near, the search without any relation ends on the closed-form path.
    #[test]
    fn contacts_found_by_search_lie_on_the_path(
        (pair, flank) in pairs(),
        share in -1.0..1.0f64,
        feeds in (-30.0..30.0f64, -20.0..20.0f64),
        away in prop::array::uniform5(-1.0..1.0f64),
    ) {
        let (shift, feed) = feeds;
        let f = &pair.flanks[flank];
        let w_2 = roll(&pair, flank, share);
        let w_1 = f.worm_roll(w_2, shift, feed);
        prop_assume!(w_1 > 1.0);
        let (z_1, z_2) = (f.worm_z(w_1, shift, feed), f.work_z(w_2, shift, feed));
        let (worm, work) = (Surface(pair.worm.flank(flank)), Surface(pair.work.flank(flank)));
        let at = [shift, feed, w_2];
        let exact = SVector::from([w_1 / SCALE, z_1 / SCALE, z_2 / SCALE, f.worm_angle(w_1, z_1), f.work_angle(w_2, z_2)]);
        // Up to 2 mm on the worm, 1 mm on the workpiece and 1 mm of their pitch circles away; nearer where the search from
        // there runs off.
        let arcs = [1.0 / pair.worm.pitch_radius(), 1.0 / pair.work.pitch_radius()];
        let offset = SVector::from([0.1, 0.1, 0.05, arcs[0], arcs[1]]).component_mul(&SVector::from(away));
        let found = [1.0, 0.3, 0.1, 0.03]
            .into_iter()
            .find_map(|share| solve(&pair.chain, [&worm, &work], at, exact + offset * share));
        prop_assert!(found.is_some(), "the search did not settle");
        let x = found.unwrap();
        // Accepted only as a real contact (`docs/mathematics/generating-contact.md#how-it-is-verified`).
        let (found_w_1, found_z_1, found_z_2) = (x[0] * SCALE, x[1] * SCALE, x[2] * SCALE);
        prop_assume!(found_w_1 > 0.0);
        let state = GeneratingState { worm_angle: x[3], work_angle: x[4], shift, feed, delta_d: 0.0, delta_gamma: 0.0 };
        let normal = pair.chain.pose(&state).direction(&Direction::from_vector(work.normal(w_2, found_z_2))).xyz;
        prop_assert!(normal.dot(&worm.normal(found_w_1, found_z_1)) < -0.999_999);
        // Rotations of the start may lead to the same contact a whole pitch on: the path is the same.
        prop_assert!((found_z_2 - z_2).abs() < 1e-9, "z_2 {found_z_2} {z_2}");
        prop_assert!((found_w_1 - w_1).abs() < 1e-9, "w_1 {found_w_1} {w_1}");
        // On the path of the worm point that was found; z_1 itself follows w_1 with the factor C_w1.
        prop_assert!((found_z_1 - f.worm_z(found_w_1, shift, feed)).abs() < 1e-9, "z_1 {found_z_1} {z_1}");
    }

    /// Workpiece to worm and back is the identity.
    #[test]
    fn points_go_to_the_worm_and_back(
        (pair, flank) in pairs(),
        share in -1.0..1.0f64,
        z_2 in -20.0..20.0f64,
        ratio in -5.0..5.0f64,
        shift_origin in -20.0..20.0f64,
    ) {
        let f = &pair.flanks[flank];
        let diagonal = DiagonalRatio { ratio, shift_origin };
        // Near the ratios at which a feed does not move the contact nothing can be told back.
        prop_assume!((f.c_zv11 * ratio + f.c_zv21).abs() > 0.1 && (f.c_zv12 * ratio + f.c_zv22).abs() > 0.1);
        let w_2 = roll(&pair, flank, share);
        let there = f.point_map(w_2, z_2, diagonal).unwrap();
        let back = f.work_point(there.w_1, there.z_1, diagonal).unwrap();
        prop_assert!((back.w_2 - w_2).abs() < 1e-10 && (back.z_2 - z_2).abs() < 1e-10, "{back:?} {w_2} {z_2}");
        prop_assert!((back.feed - there.feed).abs() < 1e-10 && (back.shift - there.shift).abs() < 1e-10);
        let again = f.point_map(back.w_2, back.z_2, diagonal).unwrap();
        prop_assert!((again.w_1 - there.w_1).abs() < 1e-10 && (again.z_1 - there.z_1).abs() < 1e-9);
    }

    /// As the feed grows, contacts found by search move along the row in one direction, and the map of points tells the feed
    /// of each.
    #[test]
    fn the_feed_moves_the_contact_one_way(
        (pair, flank) in pairs(), share in -1.0..1.0f64, ratio in -3.0..3.0f64, shift_origin in -10.0..10.0f64,
    ) {
        let f = &pair.flanks[flank];
        let g_2 = f.c_zv12 * ratio + f.c_zv22;
        prop_assume!(g_2.abs() > 0.05);
        let diagonal = DiagonalRatio { ratio, shift_origin };
        let (worm, work) = (Surface(pair.worm.flank(flank)), Surface(pair.work.flank(flank)));
        let w_2 = roll(&pair, flank, share);
        let mut last: Option<SVector<f64, 5>> = None;
        let mut places = Vec::new();
        // Ways short enough for the search to follow the contact from place to place.
        for k in 0..=96 {
            let feed = -12.0 + 0.25 * f64::from(k);
            let shift = ratio * feed + shift_origin;
            let w_1 = f.worm_roll(w_2, shift, feed);
            prop_assume!(w_1 > 1.0);
            // Only the first one starts from the relations, the others from their neighbour.
            let from = last.unwrap_or_else(|| {
                let (z_1, z_2) = (f.worm_z(w_1, shift, feed), f.work_z(w_2, shift, feed));
                SVector::from([w_1 / SCALE, z_1 / SCALE, z_2 / SCALE, f.worm_angle(w_1, z_1), f.work_angle(w_2, z_2)])
            });
            last = solve(&pair.chain, [&worm, &work], [shift, feed, w_2], from);
            prop_assert!(last.is_some(), "the search lost the contact at feed {feed}");
            places.push((feed, last.unwrap()[2] * SCALE));
        }
        for two in places.windows(2) {
            prop_assert!((two[1].1 - two[0].1) * g_2 > 0.0, "{places:?}");
        }
        for (feed, z_2) in places {
            let told = f.point_map(w_2, z_2, diagonal).unwrap().feed;
            prop_assert!((told - feed).abs() < 1e-8, "{told} {feed}");
        }
    }
}
