//! The dressing machine against its own forward kinematics, against matrices multiplied here and against central differences.

use foundation::kinematics::{
    DressingAxes, DressingAxis, DressingBranch, DressingMachine, DressingPosition, DressingRule, MachineError,
};
use nalgebra::{Matrix4, Rotation3, Translation3, Vector3};
use num_dual::Dual64;
use proptest::prelude::*;

const MACHINE: DressingMachine = DressingMachine::UNLIMITED;

fn turned(axis: usize, angle: f64) -> Matrix4<f64> {
    let axes = [Vector3::x_axis(), Vector3::y_axis(), Vector3::z_axis()];
    Rotation3::from_axis_angle(&axes[axis], angle).to_homogeneous()
}

fn moved(axis: usize, offset: f64) -> Matrix4<f64> {
    let mut v = Vector3::zeros();
    v[axis] = offset;
    Translation3::from(v).to_homogeneous()
}

/// H of `docs/mathematics/dressing.md#axes-and-their-deviations`, by plain matrices.
fn chain(q: &DressingAxes) -> Matrix4<f64> {
    turned(2, -q.worm)
        * moved(2, -q.shift)
        * turned(0, -q.tilt)
        * moved(0, -q.radial)
        * moved(1, q.axial)
        * turned(1, q.swivel)
        * turned(2, q.dresser)
}

/// Largest difference of H and K_R, rotation and mm.
fn apart(q: &DressingAxes, at: &DressingPosition) -> f64 {
    let (h, k) = (chain(q), at.pose());
    let rotation = (h.fixed_view::<3, 3>(0, 0) - k.rotation()).abs().max();
    let own = q.pose();
    let same =
        (own.rotation() - k.rotation()).abs().max().max((own.translation() - k.translation()).abs().max());
    rotation.max((h.fixed_view::<3, 1>(0, 3) - k.translation()).abs().max()).max(same)
}

fn positions(gamma: std::ops::Range<f64>) -> impl Strategy<Value = DressingPosition> {
    (-7.0..7.0f64, -80.0..80.0f64, gamma, any::<bool>(), 90.0..220.0f64, -20.0..20.0f64).prop_map(
        |(phi, v, gamma, negative, d, v_y)| DressingPosition {
            worm_angle: phi,
            worm_shift: v,
            crossing_angle: if negative { -gamma } else { gamma },
            centre_distance: d,
            offset: v_y,
        },
    )
}

/// Every rule at a pose; `share` places the free value within its reach.
fn rules(at: &DressingPosition, share: f64) -> [DressingRule; 4] {
    [
        DressingRule::Swivel(share * at.crossing_angle.abs()),
        DressingRule::WormAngle(at.worm_angle + 3.0 * share),
        DressingRule::AxialSlide(0.0),
        DressingRule::AxialSlide(share * 0.8 * at.centre_distance),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    /// Every solution of every rule is the pose, and the pair of parameters comes back from the axes.
    #[test]
    fn forward_of_the_inverse_is_the_pose(at in positions(0.01..1.2), share in -0.98..0.98f64) {
        for rule in rules(&at, share) {
            let solutions = MACHINE.axes(&at, rule, None).unwrap();
            let expected = match rule {
                DressingRule::WormAngle(_) => 1,
                _ => 2,
            };
            prop_assert!(solutions.len() >= expected, "{rule:?}: {solutions:?}");
            for found in &solutions {
                prop_assert!(apart(&found.axes, &at) < 1e-12 * 300.0, "{rule:?} {}", apart(&found.axes, &at));
                prop_assert!(found.axes.swivel.abs() <= at.crossing_angle.abs() + 1e-15);
                let kept = match rule {
                    DressingRule::Swivel(c) => found.axes.swivel - c,
                    DressingRule::WormAngle(b) => (found.axes.worm - b) / 10.0,
                    DressingRule::AxialSlide(z) => (found.axes.axial - z) / 1e3,
                };
                prop_assert!(kept.abs() < 1e-15 * 1e2, "{rule:?} {kept}");
                let back = found.axes.position(found.branch).unwrap();
                for (a, b, tolerance) in [
                    (back.worm_angle, at.worm_angle, 1e-12 / at.crossing_angle.sin().abs()),
                    (back.worm_shift, at.worm_shift, 1e-10),
                    (back.crossing_angle, at.crossing_angle, 1e-13 / at.crossing_angle.sin().abs()),
                    (back.centre_distance, at.centre_distance, 1e-10 / at.crossing_angle.sin().abs()),
                    (back.offset, at.offset, 1e-10 / at.crossing_angle.sin().abs()),
                ] {
                    let turns = ((a - b) / std::f64::consts::TAU).round() * std::f64::consts::TAU;
                    let turns = if a == back.worm_angle { turns } else { 0.0 };
                    prop_assert!((a - b - turns).abs() < tolerance, "{rule:?} {a} {b}");
                }
            }
            if expected == 2 {
                prop_assert!(solutions.iter().any(|s| s.branch == DressingBranch::Direct));
                prop_assert!(solutions.iter().any(|s| s.branch == DressingBranch::Turned));
            }
        }
    }

    /// Small crossing angles lose nothing: sin A1 never comes from 1 - cos^2.
    #[test]
    fn small_crossing_angles_keep_their_digits(at in positions(1e-9..1e-4), share in -0.999..0.999f64) {
        for rule in rules(&at, share) {
            for found in MACHINE.axes(&at, rule, None).unwrap() {
                prop_assert!(apart(&found.axes, &at) < 1e-12 * 300.0, "{rule:?} {}", apart(&found.axes, &at));
                // A1 itself, relative to its size.
                let sin_sq = at.crossing_angle.sin().powi(2) - found.axes.swivel.sin().powi(2);
                let tilt = (found.axes.swivel.cos() * found.axes.tilt.sin()).powi(2);
                prop_assert!((tilt - sin_sq).abs() < 1e-13 * at.crossing_angle.powi(2));
            }
        }
    }

    /// Rates from dual numbers against central differences of the closed form, every rule with a moving value.
    #[test]
    fn rates_are_those_of_central_differences(
        at in positions(0.05..0.6),
        share in -0.8..0.8f64,
        rates in prop::array::uniform5(-1.0..1.0f64),
    ) {
        let scale = [0.1, 1.0, 0.01, 1.0, 1.0];
        let rates: [f64; 5] = std::array::from_fn(|k| rates[k] * scale[k]);
        let lift = |t: f64| DressingPosition {
            worm_angle: at.worm_angle + rates[0] * t,
            worm_shift: at.worm_shift + rates[1] * t,
            crossing_angle: at.crossing_angle + rates[2] * t,
            centre_distance: at.centre_distance + rates[3] * t,
            offset: at.offset + rates[4] * t,
        };
        let dual = |value: f64, rate: f64| Dual64::new(value, rate);
        let moving = DressingPosition {
            worm_angle: dual(at.worm_angle, rates[0]),
            worm_shift: dual(at.worm_shift, rates[1]),
            crossing_angle: dual(at.crossing_angle, rates[2]),
            centre_distance: dual(at.centre_distance, rates[3]),
            offset: dual(at.offset, rates[4]),
        };
        for rule in rules(&at, share) {
            let rate = 0.003;
            let (here, there): (DressingRule<Dual64>, Box<dyn Fn(f64) -> DressingRule>) = match rule {
                DressingRule::Swivel(x) => {
                    (DressingRule::Swivel(dual(x, rate)), Box::new(move |t| DressingRule::Swivel(x + rate * t)))
                }
                DressingRule::WormAngle(x) => (
                    DressingRule::WormAngle(dual(x, rate)),
                    Box::new(move |t| DressingRule::WormAngle(x + rate * t)),
                ),
                DressingRule::AxialSlide(x) => (
                    DressingRule::AxialSlide(dual(x, rate)),
                    Box::new(move |t| DressingRule::AxialSlide(x + rate * t)),
                ),
            };
            let h = 1e-4;
            let exact = MACHINE.axes(&moving, here, None).unwrap();
            for found in exact {
                let near = |t: f64| {
                    MACHINE
                        .axes(&lift(t), there(t), None)
                        .unwrap()
                        .into_iter()
                        .min_by(|a, b| {
                            let off = |s: &DressingAxes| {
                                let turn = s.worm - found.axes.worm.re;
                                (turn - std::f64::consts::TAU * (turn / std::f64::consts::TAU).round()).abs()
                            };
                            off(&a.axes).total_cmp(&off(&b.axes))
                        })
                        .unwrap()
                        .axes
                };
                let (ahead, behind) = (near(h), near(-h));
                for axis in DressingAxis::ALL {
                    let step = ahead.get(axis) - behind.get(axis);
                    let turn = std::f64::consts::TAU;
                    let step = if axis.is_rotary() { step - turn * (step / turn).round() } else { step };
                    let (difference, rate) = (step / (2.0 * h), found.axes.get(axis).eps);
                    prop_assert!(
                        (difference - rate).abs() < 1e-4 * (1.0 + rate.abs()),
                        "{rule:?} {}: {difference} {rate}", axis.name()
                    );
                }
            }
        }
    }
}

fn position(gamma: f64, v_y: f64) -> DressingPosition {
    DressingPosition {
        worm_angle: -1.57,
        worm_shift: 4.0,
        crossing_angle: gamma,
        centre_distance: 107.2,
        offset: v_y,
    }
}

#[test]
fn without_swivel_the_axes_are_the_parameters() {
    let at = position(-0.17, 2.5);
    let [direct, turned] = MACHINE.axes(&at, DressingRule::Swivel(0.0), None).unwrap()[..] else { panic!() };
    assert_eq!((direct.branch, turned.branch), (DressingBranch::Direct, DressingBranch::Turned));
    let expected = [-1.57, 4.0, -0.17, -107.2, -2.5, 0.0, 0.0];
    for (axis, expected) in DressingAxis::ALL.into_iter().zip(expected) {
        assert!((direct.axes.get(axis) - expected).abs() < 1e-13, "{}", axis.name());
    }
    assert!((turned.axes.worm - (-1.57 - std::f64::consts::PI)).abs() < 1e-13);
    assert!((turned.axes.tilt - 0.17).abs() < 1e-13 && (turned.axes.radial - 107.2).abs() < 1e-12);
    let plain = DressingMachine::WITHOUT_SWIVEL;
    assert_eq!(plain.axes(&at, DressingRule::Swivel(0.0), None).unwrap(), [direct, turned]);
}

#[test]
fn the_pole_asks_for_a_worm_angle_or_the_slide() {
    let at = position(0.0, 1.5);
    assert_eq!(MACHINE.axes(&at, DressingRule::Swivel(0.0), None), Err(MachineError::PoleOfChart));
    let wanted = -1.2;
    let found = MACHINE.axes(&at, DressingRule::Swivel(0.0), Some(wanted)).unwrap();
    assert_eq!((found.len(), found[0].axes.worm), (1, wanted));
    assert!(apart(&found[0].axes, &at) < 3e-13);
    // The slide at rest passes through gamma = 0 without a jump.
    let row = |gamma: f64| {
        MACHINE.axes(&position(gamma, 1.5), DressingRule::AxialSlide(0.0), None).unwrap()[0].axes
    };
    let (before, here, after) = (row(-1e-6), row(0.0), row(1e-6));
    assert!(apart(&here, &at) < 3e-13);
    for axis in DressingAxis::ALL {
        assert!((before.get(axis) - here.get(axis)).abs() < 2e-4, "{}", axis.name());
        assert!((after.get(axis) - here.get(axis)).abs() < 2e-4, "{}", axis.name());
    }
}

#[test]
fn what_the_machine_cannot_do_is_named() {
    let at = position(-0.1, 1.5);
    let swivel = |c: f64| MACHINE.axes(&at, DressingRule::Swivel(c), None);
    let says = |error: MachineError, code: &str, parts: &[&str]| {
        assert_eq!(error.code(), code);
        let text = error.to_string();
        assert!(parts.iter().all(|part| text.contains(part)), "{text}");
        assert!(!error.way_out().is_empty());
    };
    says(swivel(0.11).unwrap_err(), "unreachable", &["C5 (deg)", "5.7295"]);
    says(swivel(3.1).unwrap_err(), "unreachable", &["C5 (deg)"]);
    assert_eq!(swivel(0.1).unwrap().len(), 1);
    assert!(apart(&swivel(0.1).unwrap()[0].axes, &at) < 1e-12);
    says(
        MACHINE.axes(&at, DressingRule::AxialSlide(500.0), None).unwrap_err(),
        "unreachable",
        &["Z1 (mm)", "500"],
    );
    says(
        MACHINE.axes(&position(0.0, 1.0), DressingRule::Swivel(0.01), Some(0.0)).unwrap_err(),
        "unreachable",
        &["C5"],
    );
    let across = position(std::f64::consts::FRAC_PI_2, 1.5);
    says(
        MACHINE.axes(&across, DressingRule::WormAngle(0.0), None).unwrap_err(),
        "machine-singular",
        &["90.0000 deg"],
    );
    let plain = DressingMachine::WITHOUT_SWIVEL;
    for rule in [DressingRule::Swivel(0.01), DressingRule::WormAngle(0.0), DressingRule::AxialSlide(0.0)] {
        says(plain.axes(&at, rule, None).unwrap_err(), "missing-axis", &["swivel"]);
    }
    let broken = DressingPosition { offset: f64::NAN, ..at };
    says(MACHINE.axes(&broken, DressingRule::Swivel(0.0), None).unwrap_err(), "invalid-number", &["v_yA"]);
    says(
        MACHINE.axes(&at, DressingRule::AxialSlide(f64::INFINITY), None).unwrap_err(),
        "invalid-number",
        &["rule"],
    );
    let mut short = MACHINE;
    short.travel[DressingAxis::Radial as usize] = Some([-100.0, 300.0]);
    short.travel[DressingAxis::Tilt as usize] = Some([-0.05, 0.05]);
    let [direct, turned] = short.axes(&at, DressingRule::Swivel(0.0), None).unwrap()[..] else { panic!() };
    says(short.within_travel(&direct.axes).unwrap_err(), "axis-limit", &["X1", "7.2000 mm", "-100"]);
    says(short.within_travel(&turned.axes).unwrap_err(), "axis-limit", &["A1", "deg"]);
}
