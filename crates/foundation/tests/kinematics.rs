//! Poses, chains and couplings against plain homogeneous matrices.

use foundation::geometry::Sides;
use foundation::kinematics::{
    Direction, DressingChain, DressingMotion, GeneratingChain, GeneratingMotion, GeneratingState, MotionLaw,
    Point, Pose, Workpiece, Worm,
};
use foundation::numerics::{gradient_of, variables};
use nalgebra::{Matrix4, Rotation3, Translation3, Vector3};
use proptest::prelude::*;

fn rotation(axis: usize, angle: f64) -> Matrix4<f64> {
    let axes = [Vector3::x_axis(), Vector3::y_axis(), Vector3::z_axis()];
    Rotation3::from_axis_angle(&axes[axis], angle).to_homogeneous()
}

fn translation(axis: usize, offset: f64) -> Matrix4<f64> {
    let mut v = Vector3::zeros();
    v[axis] = offset;
    Translation3::from(v).to_homogeneous()
}

/// Greatest difference of a pose and a matrix, lengths taken in units of `scale`.
fn apart<To, From>(pose: &Pose<To, From>, matrix: &Matrix4<f64>, scale: f64) -> f64 {
    let turned = (pose.rotation() - matrix.fixed_view::<3, 3>(0, 0)).abs().max();
    turned.max((pose.translation() - matrix.fixed_view::<3, 1>(0, 3)).abs().max() / scale)
}

/// A chain of elementary motions: (kind 0..6, amount).
fn motions() -> impl Strategy<Value = Vec<(usize, f64)>> {
    prop::collection::vec((0..6usize, -3.0..3.0f64), 1..12)
}

fn chain(motions: &[(usize, f64)]) -> (Pose<Worm, Worm>, Matrix4<f64>) {
    motions.iter().fold((Pose::identity(), Matrix4::identity()), |(pose, matrix), &(kind, amount)| {
        let length = 50.0 * amount;
        let (next, step) = match kind {
            0 => (Pose::rx(amount), rotation(0, amount)),
            1 => (Pose::ry(amount), rotation(1, amount)),
            2 => (Pose::rz(amount), rotation(2, amount)),
            3 => (Pose::tx(length), translation(0, length)),
            4 => (Pose::ty(length), translation(1, length)),
            _ => (Pose::tz(length), translation(2, length)),
        };
        (pose.then(&next), matrix * step)
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    /// Chains agree with homogeneous matrices, and a chain after its inverse is the identity to 1e-12.
    #[test]
    fn chains_compose_and_invert(list in motions(), x in -80.0..80.0f64, y in -80.0..80.0f64, z in -80.0..80.0f64) {
        let (pose, matrix) = chain(&list);
        prop_assert!(apart(&pose, &matrix, 100.0) < 1e-13);
        prop_assert!(apart(&pose.then(&pose.inverse()), &Matrix4::identity(), 1.0) < 1e-12);
        prop_assert!(apart(&pose.inverse().then(&pose), &Matrix4::identity(), 1.0) < 1e-12);
        let p = Point::new(x, y, z);
        prop_assert!((pose.inverse().point(&pose.point(&p)).xyz - p.xyz).norm() < 1e-12 * 1e2);
        let d = Direction::from_vector(Vector3::new(x, y, z));
        let turned = pose.direction(&d);
        prop_assert!((turned.xyz.norm() - d.xyz.norm()).abs() < 1e-12 * 1e2);
        let tip = pose.point(&Point::from_vector(p.xyz + d.xyz)).xyz - pose.point(&p).xyz;
        prop_assert!((tip - turned.xyz).norm() < 1e-11);
    }

    /// Dual numbers through a pose give the velocity: d/da of Rz(a) p is e_z x p.
    #[test]
    fn poses_differentiate(a in -3.0..3.0f64, b in -3.0..3.0f64, x in -9.0..9.0f64, y in -9.0..9.0f64, z in -9.0..9.0f64) {
        let [ad, bd] = variables([a, b]);
        let pose = Pose::<Worm, Worm, _>::rz(ad).then(&Pose::<Worm, Workpiece, _>::tx(bd));
        let p = pose.point(&Point::new(x.into(), y.into(), z.into())).xyz;
        let value = Pose::<Worm, Worm>::rz(a).then(&Pose::<Worm, Workpiece>::tx(b)).point(&Point::new(x, y, z)).xyz;
        let by = |k: usize| Vector3::new(gradient_of(&p.x)[k], gradient_of(&p.y)[k], gradient_of(&p.z)[k]);
        prop_assert!((by(0) - Vector3::z().cross(&value)).norm() < 1e-13);
        prop_assert!((by(1) - Vector3::new(a.cos(), a.sin(), 0.0)).norm() < 1e-14);
    }

    /// The chain of generating grinding is the product of `docs/mathematics/conventions.md`, both brackets included.
    #[test]
    fn the_generating_chain_is_that_of_the_conventions(
        angles in prop::array::uniform6(-2.0..2.0f64), lengths in prop::array::uniform6(-90.0..90.0f64),
    ) {
        let [gamma, theta_1, theta_2, phi_1, phi_2, delta_gamma] = angles;
        let [d, r_w1, r_w2, shift, feed, delta_d] = lengths;
        let chain = GeneratingChain {
            centre_distance: d,
            crossed_axes_angle: gamma,
            worm_cone: theta_1,
            work_cone: theta_2,
            worm_pivot: r_w1,
            work_pivot: r_w2,
        };
        let state = GeneratingState { worm_angle: phi_1, work_angle: phi_2, shift, feed, delta_d, delta_gamma };
        let matrix = rotation(2, -phi_1)
            * translation(1, r_w1)
            * rotation(0, theta_1)
            * translation(2, -shift)
            * translation(1, d + delta_d)
            * rotation(1, gamma + delta_gamma)
            * translation(2, feed)
            * rotation(0, -theta_2)
            * translation(1, -r_w2)
            * rotation(2, phi_2);
        prop_assert!(apart(&chain.pose(&state), &matrix, 100.0) < 1e-13);
    }

    /// The chain of dressing is the product of `docs/mathematics/conventions.md`; its motion follows the screw.
    #[test]
    fn the_dressing_chain_is_that_of_the_conventions(
        angles in prop::array::uniform3(-2.0..2.0f64), lengths in prop::array::uniform3(-90.0..90.0f64),
        dk in prop::array::uniform4(-0.01..0.01f64), v in -60.0..60.0f64, p in 3.0..20.0f64,
    ) {
        let chain = DressingChain {
            worm_angle: angles[0],
            crossing_angle: angles[1],
            centre_distance: lengths[0],
            offset: lengths[1],
            screw_parameter: p,
        };
        let position = DressingMotion::constant(chain, dk).position(v);
        let matrix = rotation(2, -(angles[0] + dk[0] + v / p))
            * translation(2, -v)
            * rotation(0, -(angles[1] + dk[1]))
            * translation(0, lengths[0] + dk[2])
            * translation(1, -(lengths[1] + dk[3]));
        prop_assert!(apart(&position.pose(), &matrix, 100.0) < 1e-13);
    }

    /// The coupling holds at every state: z_1 phi_1 + z_2 phi_2 = k_V1 z_V1 + k_V2 z_V2 + k_0, plus the corrections.
    #[test]
    fn states_obey_the_coupling(
        phi_1 in -9.0..9.0f64, v in -40.0..40.0f64, c in prop::array::uniform4(-0.5..0.5f64), phase in -3.0..3.0f64,
    ) {
        let law = |scale: f64| MotionLaw::polynomial(1.0, c.iter().map(|x| x * scale).collect());
        let chain = GeneratingChain {
            centre_distance: 150.0,
            crossed_axes_angle: 1.0,
            worm_cone: 0.0,
            work_cone: 0.0,
            worm_pivot: 0.0,
            work_pivot: 0.0,
        };
        let motion = GeneratingMotion {
            chain,
            threads: 3.0,
            teeth: 31.0,
            shift_coupling: 0.57,
            feed_coupling: -0.33,
            phase: Sides::both(phase),
            shift: law(1.0),
            delta_d: law(1e-3),
            delta_phi_2: law(1e-5),
            delta_gamma: law(1e-4),
        };
        let at = motion.state(phi_1, v, phase);
        let [f, ..] = motion.shift.jet(v);
        let sum = 3.0 * phi_1 + 31.0 * (at.work_angle - motion.delta_phi_2.value(v));
        prop_assert!((sum - (0.57 * f - 0.33 * v + phase)).abs() < 1e-9);
        prop_assert_eq!((at.shift, at.feed), (f, v));
        prop_assert_eq!((at.delta_d, at.delta_gamma), (motion.delta_d.value(v), motion.delta_gamma.value(v)));
        let plain = motion.uncorrected().state(phi_1, v, phase);
        prop_assert_eq!((plain.delta_d, plain.delta_gamma, plain.shift), (0.0, 0.0, f));
        let half = motion.with_share(0.5).state(phi_1, v, phase);
        prop_assert!((half.delta_d - 0.5 * at.delta_d).abs() < 1e-12);
        // A law lifted to dual numbers carries value and slope.
        let [x] = variables([v]);
        let [value, _] = motion.shift.lifted(x);
        prop_assert!((gradient_of(&value)[0] - motion.shift.jet(v)[1]).abs() < 1e-12);
    }
}
