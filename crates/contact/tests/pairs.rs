//! Contact relations and the exact solver against a search that uses only the chain of poses and the signed deviation
//! from the worm's flank; and every refusal of the contact room.

use contact::{
    ContactError, DiagonalLine, DiagonalRatio, ExactContact, Measure, ModifiedThread, Pair, ThreadFunction,
    ToolSurface, Unmodified,
};
use foundation::geometry::{Flank, Gear, GearData, Sides};
use foundation::kinematics::{Direction, GeneratingChain, GeneratingMotion, MotionLaw, Point};
use foundation::numerics::{Jet2, Polynomial2};
use nalgebra::Vector3;
use proptest::prelude::*;
use std::f64::consts::PI;

const UM: f64 = 1e-3;

/// A random pair without backlash, cylinders and cones on both sides, and a flank.
fn pair() -> impl Strategy<Value = (Pair, Flank)> {
    let work = (14..70i32, 1.2..5.0f64, 15.0..25.0f64, 15.0..25.0f64, -35.0..35.0f64, -0.2..0.4f64);
    let cones = (prop::option::weighted(0.3, -4.0..4.0f64), prop::option::weighted(0.3, -4.0..4.0f64));
    let worm = (1..6i32, any::<bool>(), 35.0..80.0f64);
    (work, worm, cones, any::<bool>()).prop_filter_map("no pair", |(work, worm, (cone_1, cone_2), left)| {
        let (teeth, normal_module, alpha_left, alpha_right, beta, profile_shift) = work;
        let (threads, right_hand, factor) = worm;
        let data = GearData {
            teeth,
            normal_module,
            pressure_angle: Sides { left: alpha_left.to_radians(), right: alpha_right.to_radians() },
            helix_angle: beta.to_radians(),
            profile_shift,
            cone_angle: cone_2.unwrap_or(0.0).to_radians(),
        };
        let hand = if right_hand { 1.0 } else { -1.0 };
        let helix_angle = hand * (f64::from(threads) / factor).acos();
        let cone_angle = cone_1.unwrap_or(0.0).to_radians();
        let worm =
            Gear::new(GearData { teeth: threads, helix_angle, profile_shift: 0.0, cone_angle, ..data })
                .ok()?;
        let gamma = -(helix_angle + data.helix_angle);
        let pair = Pair::without_backlash(worm, Gear::new(data).ok()?, gamma).ok()?;
        Some((pair, if left { Flank::Left } else { Flank::Right }))
    })
}

/// A workpiece point: share -1..1 over two thirds of a module about the pitch cylinder, z in face widths.
fn work_point(pair: &Pair, flank: Flank, share: f64, z: f64) -> (f64, f64) {
    let alpha = pair.work.transverse_pressure_angle(flank);
    let middle = pair.work.pitch_radius() * alpha.sin();
    let reach = (0.66 * pair.work.data().normal_module / alpha.sin()).min(0.6 * middle);
    (middle + share * reach, z)
}

/// Length left on the normal of (w_2, z_2) when the worm stands at (phi_1, v), mm: the ray's end point is moved until
/// its deviation from the modified thread vanishes.
struct Brute<'a, F: ThreadFunction> {
    pair: &'a Pair,
    flank: Flank,
    motion: &'a GeneratingMotion,
    function: &'a F,
    point: Vector3<f64>,
    normal: Vector3<f64>,
}

impl<F: ThreadFunction> Brute<'_, F> {
    fn length(&self, phi_1: f64, v: f64) -> f64 {
        let state = self.motion.state(phi_1, v, self.motion.phase[self.flank]);
        let pose = self.motion.chain.pose(&state);
        let worm = self.pair.worm.flank(self.flank);
        let direction = pose.direction(&Direction::from_vector(self.normal)).xyz;
        let mut l = 0.0;
        for _ in 0..60 {
            let x = pose.point(&Point::from_vector(self.point + self.normal * l)).xyz;
            let d = worm.deviation(&x);
            let excess = d.f_n - self.function.jet(d.w, d.z).unwrap().f;
            let step = excess / worm.normal(d.w, d.z).dot(&direction);
            l -= step;
            if step.abs() < 1e-14 {
                break;
            }
        }
        l
    }

    /// Least length over (phi_1, v) from a start, by Newton on differences; also checks that it is a minimum.
    fn least(&self, phi_1: f64, v: f64) -> f64 {
        let r = self.pair.worm.flank(self.flank).base_radius;
        let f = |x: [f64; 2]| self.length(phi_1 + x[0] / r, v + x[1]);
        let (mut x, h) = ([0.0; 2], 4e-3);
        for _ in 0..30 {
            let at = |i: f64, j: f64| f([x[0] + i * h, x[1] + j * h]);
            let (o, e, w, n, s) = (at(0., 0.), at(1., 0.), at(-1., 0.), at(0., 1.), at(0., -1.));
            let cross = (at(1., 1.) - at(1., -1.) - at(-1., 1.) + at(-1., -1.)) / (4.0 * h * h);
            let (a, b) = ((e - 2.0 * o + w) / (h * h), (n - 2.0 * o + s) / (h * h));
            let (p, q) = ((e - w) / (2.0 * h), (n - s) / (2.0 * h));
            let det = a * b - cross * cross;
            assert!(a > 0.0 && det > 0.0, "no minimum: {a} {b} {cross}");
            let step = [(b * p - cross * q) / det, (a * q - cross * p) / det];
            let size = step[0].hypot(step[1]);
            let limit = (2.0 / size).min(1.0);
            x = [x[0] - step[0] * limit, x[1] - step[1] * limit];
            if size < 1e-6 {
                break;
            }
        }
        // Nothing in the neighbourhood (well within a pitch) cuts deeper.
        let module = self.pair.work.data().normal_module;
        let least = f(x);
        for k in 0..24 {
            let (sin, cos) = (f64::from(k) * PI / 12.0).sin_cos();
            for reach in [0.02, 0.1, 0.3].map(|share| share * module) {
                assert!(f([x[0] + reach * cos, x[1] + reach * sin]) > least - 1e-12);
            }
        }
        least
    }

    /// Worm angle at which the coupling brings the space of (w_2, z_2) to the given workpiece angle.
    fn worm_angle(&self, work_angle: f64, v: f64) -> f64 {
        let state = self.motion.state(0.0, v, self.motion.phase[self.flank]);
        (state.work_angle - work_angle) * self.motion.teeth / self.motion.threads
    }
}

/// Random modification of thread and motion, about 20 um in all.
#[derive(Clone, Debug)]
struct Modified {
    thread: [f64; 7],
    d: [f64; 3],
    phi: [f64; 3],
    gamma: [f64; 3],
    shift: [f64; 3],
}

fn modified() -> impl Strategy<Value = Modified> {
    let three = || prop::array::uniform3(-1.0..1.0f64);
    (prop::array::uniform7(-1.0..1.0f64), three(), three(), three(), three(), 0..3u8).prop_map(
        |(thread, d, phi, gamma, shift, kind)| Modified {
            thread: if kind == 0 { [0.0; 7] } else { thread },
            d,
            phi,
            gamma: if kind == 2 { gamma } else { [0.0; 3] },
            // Radial: no shift at all.
            shift: if kind == 0 { [shift[0], 0.0, 0.0] } else { shift },
        },
    )
}

impl Modified {
    fn motion(&self, pair: &Pair) -> GeneratingMotion {
        let law = |c: [f64; 3], scale: [f64; 3]| {
            MotionLaw::polynomial(0.7, (0..3).map(|k| c[k] * scale[k]).collect())
        };
        GeneratingMotion {
            delta_d: law(self.d, [5e-3, 0.4e-3, 0.1e-3]),
            delta_phi_2: law(self.phi, [50e-6, 4e-6, 0.4e-6]),
            delta_gamma: law(self.gamma, [100e-6, 10e-6, 1e-6]),
            ..pair.motion(law(self.shift, [5.0, 1.8, 0.005]))
        }
    }

    /// The thread function about the worm point that grinds the middle of the flank.
    fn thread(&self, pair: &Pair, flank: Flank, motion: &GeneratingMotion) -> Polynomial2 {
        let f = &pair.flanks[flank];
        let (w_2, _) = work_point(pair, flank, 0.0, 0.0);
        let shift = motion.shift.value(0.0);
        let w_1 = f.worm_roll(w_2, shift, 0.0);
        let z_1 = f.worm_z(w_1, shift, 0.0);
        let t = self.thread.map(|x| x * UM);
        Polynomial2::from_terms([
            (0, 0, 5.0 * t[0]),
            (1, 0, 1.5 * t[1]),
            (0, 1, 0.3 * t[2]),
            (2, 0, 0.15 * t[3]),
            (1, 1, 0.04 * t[4]),
            (0, 2, 0.02 * t[5]),
            (0, 3, 2e-4 * t[6]),
        ])
        .shifted(-w_1, -z_1)
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    /// R4 to R7: at the predicted angles the chain lays the predicted worm point onto the workpiece point, normals against
    /// each other, and the coupling holds; both flanks without backlash.
    #[test]
    fn predicted_contacts_touch(
        (pair, flank) in pair(), share in -1.0..1.0f64, shift in -30.0..30.0f64, feed in -20.0..20.0f64,
    ) {
        let f = &pair.flanks[flank];
        let (w_2, _) = work_point(&pair, flank, share, 0.0);
        let z_2 = f.work_z(w_2, shift, feed);
        let w_1 = f.worm_roll(w_2, shift, feed);
        prop_assume!(w_1 > 1.0);
        let z_1 = f.worm_z(w_1, shift, feed);
        prop_assert!((f.work_roll(w_1, shift, feed) - w_2).abs() < 1e-10);
        let motion = pair.motion(MotionLaw::polynomial(0.0, vec![shift]));
        let phi_1 = f.worm_angle(w_1, z_1);
        let state = motion.state(phi_1, feed, motion.phase[flank]);
        let pitch = 2.0 * PI / motion.teeth;
        let apart = (f.work_angle(w_2, z_2) - state.work_angle) / pitch;
        prop_assert!((apart - apart.round()).abs() < 1e-10, "pitches apart: {apart}");
        let state = foundation::kinematics::GeneratingState { work_angle: f.work_angle(w_2, z_2), ..state };
        let pose = pair.chain.pose(&state);
        let carried = pose.point(&Point::from_vector(f.work.point(w_2, z_2))).xyz;
        prop_assert!((carried - f.worm.point(w_1, z_1)).norm() < 1e-9, "{}", (carried - f.worm.point(w_1, z_1)).norm());
        let normal = pose.direction(&Direction::from_vector(f.work.normal(w_2, z_2))).xyz;
        prop_assert!((normal + f.worm.normal(w_1, z_1)).norm() < 1e-11);
        let phases = (motion.phase.left - motion.phase.right) / (2.0 * PI);
        prop_assert!((phases - phases.round()).abs() < 1e-10);
        // The common tangent plane: generatrices and radial directions lie in it.
        for v in f.generatrices().iter().chain([&f.e_r1, &f.e_r2]) {
            prop_assert!((v.norm() - 1.0).abs() < 1e-12 && v.dot(&f.normal).abs() < 1e-12);
        }
    }

    /// The diagonal ratio answers all three questions alike, and its line map is that of the points.
    #[test]
    fn lines_and_points_agree(
        (pair, flank) in pair(), rho_1 in -80.0..80.0f64, rho_2 in -80.0..80.0f64, origin in -9.0..9.0f64, share in -1.0..1.0f64,
    ) {
        let f = &pair.flanks[flank];
        let (worm, work) = (DiagonalLine { rho: rho_1.to_radians() }, DiagonalLine { rho: rho_2.to_radians() });
        let Ok(ratio) = f.ratio_of_directions(worm, work) else { return Ok(()) };
        prop_assume!(ratio.abs() < 30.0 && (f.contact_path()[0].rho - worm.rho).abs() > 0.02);
        prop_assume!((f.contact_path()[1].rho - work.rho).abs() > 0.02 && ratio.abs() > 0.02);
        let modulo = |a: f64, b: f64| ((a - b) / PI - ((a - b) / PI).round()).abs();
        prop_assert!(modulo(f.work_direction(worm, ratio).unwrap().rho, work.rho) < 1e-9);
        prop_assert!(modulo(f.worm_direction(work, ratio).unwrap().rho, worm.rho) < 1e-9);
        let diagonal = DiagonalRatio { ratio, shift_origin: origin };
        let map = f.line_map(worm, work, diagonal).unwrap();
        let (w_2, z_2) = work_point(&pair, flank, share, 4.0);
        let at = f.point_map(w_2, z_2, diagonal).unwrap();
        let x_1 = worm.coordinate(at.w_1, at.z_1);
        let x_2 = work.coordinate(w_2, z_2);
        prop_assert!((map.slope * x_1 + map.offset - x_2).abs() < 1e-8 * (1.0 + map.slope.abs() * 1e2));
        let (p, q) = f.roll_along_line(worm, x_1, diagonal).unwrap();
        prop_assert!((p * w_2 + q - at.w_1).abs() < 1e-8);
        prop_assert!((f.work_z(w_2, at.shift, at.feed) - z_2).abs() < 1e-9);
        prop_assert!((f.worm_z(at.w_1, at.shift, at.feed) - at.z_1).abs() < 1e-9);
        // The working area holds every point of the field.
        let z = [-10.0, 10.0];
        let w = [work_point(&pair, flank, -1.0, 0.0).0, work_point(&pair, flank, 1.0, 0.0).0];
        if let Ok(area) = f.working_area(w, z, diagonal) {
            let inside = |range: [f64; 2], x: f64| x > range[0] - 1e-9 && x < range[1] + 1e-9;
            prop_assert!(inside(area.w_1, at.w_1) && inside(area.z_1, at.z_1));
            prop_assert!(inside(area.feed, at.feed) && inside(area.shift, at.shift));
            let lines = f.line_range(worm, w, z, diagonal).unwrap();
            prop_assert!(inside(lines, x_1));
        }
    }

    /// An unmodified worm leaves nothing, whatever the (uncorrected) motion.
    #[test]
    fn unmodified_worms_leave_nothing((pair, flank) in pair(), shift in prop::array::uniform3(-1.0..1.0f64), share in -1.0..1.0f64) {
        let motion = pair.motion(MotionLaw::polynomial(0.0, vec![shift[0], shift[1] * 2.0, shift[2] * 0.01]));
        let thread = ModifiedThread::new(pair.flanks[flank].worm, &Unmodified);
        let (w, z) = work_point(&pair, flank, share, 6.0);
        for measure in [Measure::Ray, Measure::Arc] {
            match ExactContact::new(&pair, flank, &motion, &thread).with_measure(measure).solve(w, z) {
                Ok(s) => {
                    prop_assert!(s.f_n.abs() < 1e-10, "{}", s.f_n);
                    prop_assert!((s.determinant_ratio - 1.0).abs() < 1e-6);
                }
                Err(e) => prop_assert_eq!(e.code(), "contact-below-base"),
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    /// What the exact solver finds is the least length of the ray over all positions, to 1e-6 um.
    #[test]
    fn exact_contact_is_the_least_ray(
        (pair, flank) in pair(), modified in modified(), share in -1.0..1.0f64, z in -10.0..10.0f64,
    ) {
        let motion = modified.motion(&pair);
        let function = modified.thread(&pair, flank, &motion);
        let thread = ModifiedThread::new(pair.flanks[flank].worm, &function);
        let (w_2, z_2) = work_point(&pair, flank, share, z);
        let exact = ExactContact::new(&pair, flank, &motion, &thread);
        let found = match exact.solve(w_2, z_2) {
            Ok(found) => found,
            Err(e) => {
                prop_assert!(["undercut", "contact-not-found", "contact-below-base", "worm-surface-missing"].contains(&e.code()), "{e}");
                return Err(TestCaseError::reject("no flank here"));
            }
        };
        // Near the fold the difference quotients of the search lose their digits.
        prop_assume!(found.determinant_ratio > 0.3);
        let work = pair.work.flank(flank);
        let frame = work.frame(w_2, z_2);
        let brute = Brute {
            pair: &pair,
            flank,
            motion: &motion,
            function: &function,
            point: work.point(w_2, z_2),
            normal: frame.n,
        };
        let start = brute.worm_angle(pair.flanks[flank].work_angle(w_2, z_2), found.feed);
        let least = brute.least(start, found.feed);
        prop_assert!((least - found.f_n).abs() < 1e-9, "{} um against {} um", found.f_n / UM, least / UM);
    }

    /// Sensitivities agree with differences of whole solutions, ray and arc.
    #[test]
    fn sensitivities_are_derivatives(
        (pair, flank) in pair(), modified in modified(), share in -0.8..0.8f64, z in -8.0..8.0f64, arc in any::<bool>(),
    ) {
        let motion = modified.motion(&pair);
        let function = modified.thread(&pair, flank, &motion);
        let (w_2, z_2) = work_point(&pair, flank, share, z);
        let measure = if arc { Measure::Arc } else { Measure::Ray };
        let solve = |motion: &GeneratingMotion, function: &Polynomial2| {
            let thread = ModifiedThread::new(pair.flanks[flank].worm, function);
            ExactContact::new(&pair, flank, motion, &thread).with_measure(measure).solve(w_2, z_2)
        };
        let Ok(at) = solve(&motion, &function) else { return Err(TestCaseError::reject("no flank here")) };
        prop_assume!(at.determinant_ratio > 0.4);
        let thread = ModifiedThread::new(pair.flanks[flank].worm, &function);
        let exact = ExactContact::new(&pair, flank, &motion, &thread).with_measure(measure);
        let s = exact.sensitivities(w_2, z_2, &at).unwrap();
        let central = |h: f64, change: &dyn Fn(&mut GeneratingMotion, &mut Polynomial2, f64)| {
            let value = |by: f64| {
                let (mut m, mut f) = (motion.clone(), function.clone());
                change(&mut m, &mut f, by);
                solve(&m, &f).unwrap().f_n
            };
            (8.0 * (value(h) - value(-h)) - (value(2.0 * h) - value(-2.0 * h))) / (12.0 * h)
        };
        let expected = [
            (s.centre_distance, central(1e-3, &|m, _, h| m.delta_d = m.delta_d.raised(h))),
            (s.work_angle, central(2e-5, &|m, _, h| m.delta_phi_2 = m.delta_phi_2.raised(h))),
            (s.crossed_axes_angle, central(2e-5, &|m, _, h| m.delta_gamma = m.delta_gamma.raised(h))),
            (s.tool_modification, central(1e-3, &|_, f, h| *f = f.add(&Polynomial2::constant(h)))),
        ];
        for (k, (found, difference)) in expected.into_iter().enumerate() {
            let size = 1.0 + difference.abs();
            prop_assert!((found - difference).abs() < 2e-7 * size, "{k}: {found} against {difference}");
        }
        // A shift that the coupling follows, at the feed of the contact.
        let shifted = central(1e-3, &|m, _, h| m.shift = m.shift.raised(h));
        prop_assert!((s.shift - shifted).abs() < 2e-7 * (1.0 + shifted.abs()), "shift {} against {shifted}", s.shift);
    }

    /// The local second-order estimate is exact up to the third order: halving the amounts divides its error by eight.
    #[test]
    fn second_order_is_second_order((pair, flank) in pair(), modified in modified(), share in -0.8..0.8f64) {
        let motion = pair.motion(MotionLaw::polynomial(0.0, vec![1.0, modified.shift[1]]));
        let ratio = modified.shift[1];
        let function = modified.thread(&pair, flank, &motion);
        let (w_2, z_2) = work_point(&pair, flank, share, 3.0);
        let f = &pair.flanks[flank];
        let Ok(at) = f.point_map(w_2, z_2, DiagonalRatio { ratio, shift_origin: 1.0 }) else {
            return Err(TestCaseError::reject("the feed does not move the contact"));
        };
        let error = |amount: f64| {
            let scaled = function.scale(amount);
            let thread = ModifiedThread::new(f.worm, &scaled);
            let exact = ExactContact::new(&pair, flank, &motion, &thread).solve(w_2, z_2).ok()?;
            let jet = scaled.jet(at.w_1, at.z_1);
            let estimate = -jet.f + f.relative_curvature(at.w_1, w_2, ratio).second_order(jet.fu, jet.fv);
            Some((exact.f_n - estimate, exact.determinant_ratio))
        };
        let (Some((whole, fold)), Some((half, _)), Some((quarter, _))) = (error(1.0), error(0.5), error(0.25)) else {
            return Err(TestCaseError::reject("no flank here"));
        };
        prop_assume!((fold - 1.0).abs() < 0.3);
        prop_assert!(half.abs() <= whole.abs() * 0.25 + 1e-10, "{whole} {half}");
        prop_assert!(quarter.abs() <= half.abs() * 0.25 + 1e-10, "{half} {quarter}");
    }

    /// Point, normal and derivatives of the modified thread belong together.
    #[test]
    fn the_thread_is_a_surface((pair, flank) in pair(), modified in modified(), w in 20.0..200.0f64, z in -30.0..30.0f64) {
        let function = Polynomial2::from_terms(
            modified.thread.iter().enumerate().map(|(k, t)| ((k + 1) % 3, k / 2, t * 2e-3)),
        )
        .shifted(-w, -z);
        let thread = ModifiedThread::new(pair.flanks[flank].worm, &function);
        let jet = thread.jet(w, z).unwrap();
        prop_assert!(jet.n.dot(&jet.p_p).abs() < 1e-11 * (1.0 + jet.p_p.norm()));
        prop_assert!(jet.n.dot(&jet.p_q).abs() < 1e-11 * (1.0 + jet.p_q.norm()));
        // The normal is across the tangents everywhere, so its derivatives are tied to those of the point.
        let h = 2e-4;
        let at = |i: f64, j: f64| thread.jet(w + i * h, z + j * h).unwrap();
        let slope = |pick: &dyn Fn(f64) -> Vector3<f64>| {
            (8.0 * (pick(1.0) - pick(-1.0)) - (pick(2.0) - pick(-2.0))) / (12.0 * h)
        };
        let close = |a: Vector3<f64>, b: Vector3<f64>| (a - b).norm() < 1e-8 * (1.0 + b.norm());
        prop_assert!(close(slope(&|i| at(i, 0.0).p), jet.p_p));
        prop_assert!(close(slope(&|j| at(0.0, j).p), jet.p_q));
        prop_assert!(close(slope(&|i| at(i, 0.0).n), jet.n_p));
        prop_assert!(close(slope(&|j| at(0.0, j).n), jet.n_q));
        let plain = thread.with_share(0.0);
        prop_assert!((plain.jet(w, z).unwrap().p - pair.flanks[flank].worm.point(w, z)).norm() == 0.0);
        prop_assert!(thread.jet(-1.0, z).is_none() && thread.jet(f64::NAN, z).is_none());
    }

    /// A grid gives what its points give one by one.
    #[test]
    fn grids_equal_their_points((pair, flank) in pair(), modified in modified()) {
        let motion = modified.motion(&pair);
        let function = modified.thread(&pair, flank, &motion);
        let thread = ModifiedThread::new(pair.flanks[flank].worm, &function);
        let exact = ExactContact::new(&pair, flank, &motion, &thread);
        let w = [-0.8, -0.3, 0.4, 0.8].map(|s| work_point(&pair, flank, s, 0.0).0);
        let z = [-8.0, -3.0, 1.0, 4.0, 8.0];
        let Ok(grid) = exact.solve_grid(&w, &z) else { return Err(TestCaseError::reject("no flank here")) };
        prop_assert_eq!(grid.len(), 20);
        for (i, &w) in w.iter().enumerate() {
            for (j, &z) in z.iter().enumerate() {
                let alone = exact.solve(w, z).unwrap();
                let together = grid[5 * i + j];
                prop_assert!((alone.f_n - together.f_n).abs() < 1e-12, "{} {}", alone.f_n, together.f_n);
                prop_assert!((alone.feed - together.feed).abs() < 1e-9);
            }
        }
        // All are found easily here, or from further away.
        for (k, easy) in exact.solve_grid_where_easy(&w, &z) {
            prop_assert!((easy.f_n - grid[k].f_n).abs() < 1e-12, "{} {}", easy.f_n, grid[k].f_n);
        }
    }
}

fn bodies() -> (Gear, Gear) {
    let work = GearData {
        teeth: 19,
        normal_module: 3.5,
        pressure_angle: Sides::both(17.5f64.to_radians()),
        helix_angle: -(35f64.to_radians()),
        profile_shift: 0.1,
        cone_angle: 0.0,
    };
    let worm = GearData { teeth: 3, helix_angle: (3.0 * 3.5 / 280f64).acos(), profile_shift: 0.0, ..work };
    (Gear::new(worm).unwrap(), Gear::new(work).unwrap())
}

fn tight() -> Pair {
    let (worm, work) = bodies();
    Pair::without_backlash(worm, work, -(worm.data().helix_angle + work.data().helix_angle)).unwrap()
}

fn refused<T: std::fmt::Debug>(result: Result<T, ContactError>, code: &str, words: &[&str]) {
    let error = result.unwrap_err();
    assert_eq!(error.code(), code, "{error}");
    for word in words {
        assert!(error.to_string().contains(word), "{error} does not say {word}");
    }
    assert!(!error.way_out().is_empty());
}

#[test]
fn the_first_reference_pair_comes_out() {
    let pair = tight();
    assert!((pair.chain.centre_distance - 180.940755076).abs() < 1e-9);
    let f = &pair.flanks.left;
    assert!((f.c_c1 - 438.662812435).abs() < 1e-9 && (f.hat_c + 477.659474467).abs() < 1e-9);
}

#[test]
fn impossible_pairs_are_refused() {
    let (worm, work) = bodies();
    let pair = tight();
    let with = |change: &dyn Fn(&mut GeneratingChain)| {
        let mut chain = pair.chain;
        change(&mut chain);
        Pair::new(worm, work, chain)
    };
    for d in [0.0, -3.0, f64::NAN, f64::INFINITY] {
        refused(with(&|c| c.centre_distance = d), "invalid-number", &["centre_distance", &d.to_string()]);
    }
    refused(with(&|c| c.crossed_axes_angle = f64::NAN), "invalid-number", &["crossed_axes_angle"]);
    refused(with(&|c| c.crossed_axes_angle = 0.0), "axes-parallel", &["0 deg"]);
    refused(with(&|c| c.crossed_axes_angle = 0.3), "no-common-normal", &["flank", "17.18"]);
    let ring = Gear::new(GearData { teeth: -61, ..*work.data() }).unwrap();
    refused(Pair::new(worm, ring, pair.chain), "internal-unsupported", &["-61 teeth"]);
    let other = Gear::new(GearData { normal_module: 3.6, ..*work.data() }).unwrap();
    refused(Pair::new(worm, other, pair.chain), "not-mating", &["left"]);
    // Left flanks mesh, right flanks do not.
    let right = Sides { left: 17.5f64.to_radians(), right: 17.6f64.to_radians() };
    let other = Gear::new(GearData { pressure_angle: right, ..*work.data() }).unwrap();
    refused(Pair::new(worm, other, pair.chain), "not-mating", &["right"]);
    let cone = Gear::new(GearData { cone_angle: 0.05, ..*worm.data() }).unwrap();
    let gamma = pair.chain.crossed_axes_angle;
    assert!(Pair::without_backlash(cone, work, gamma).is_ok());
    refused(Pair::without_backlash(cone, work, gamma + 0.02), "racks-not-congruent", &["deg"]);
}

#[test]
fn impossible_lines_and_ranges_are_refused() {
    let pair = tight();
    let f = &pair.flanks.left;
    let [worm_path, work_path] = f.contact_path();
    let line = |deg: f64| DiagonalLine { rho: deg.to_radians() };
    refused(f.ratio_of_directions(worm_path, line(30.0)), "direction-is-contact-path", &["72.37"]);
    refused(f.work_direction(worm_path, 1.0), "direction-is-contact-path", &["72.37"]);
    refused(f.worm_direction(work_path, 1.0), "direction-is-contact-path", &["-33.16"]);
    refused(f.ratio_of_directions(line(90.0), line(30.0)), "direction-is-profile", &["90"]);
    let diagonal = DiagonalRatio { ratio: 1.0, shift_origin: 0.0 };
    refused(f.roll_along_line(line(90.0), 1.0, diagonal), "direction-is-profile", &["90"]);
    refused(f.working_area([500.0, 600.0], [-9.0, 9.0], diagonal), "worm-below-base", &["base circle"]);
    // With a conical worm the feed stands still at one ratio.
    let (worm, work) = bodies();
    let cone = Gear::new(GearData { cone_angle: 0.05, ..*worm.data() }).unwrap();
    let conical = Pair::without_backlash(cone, work, pair.chain.crossed_axes_angle).unwrap();
    let f = &conical.flanks.left;
    let still = DiagonalRatio { ratio: -f.c_zv22 / f.c_zv12, shift_origin: 0.0 };
    refused(f.point_map(14.0, 0.0, still), "feed-does-not-move-contact", &["ratio"]);
    // A radial motion uses one line of a cylindrical worm: from there no feed can be told.
    let radial = DiagonalRatio { ratio: 0.0, shift_origin: 0.0 };
    refused(pair.flanks.left.work_point(90.0, 0.0, radial), "feed-does-not-move-contact", &["ratio 0"]);
    // The worm directions for which the denominator of K vanishes, as far as rounding lets it.
    let mut infinite = 0;
    for deg in [-50.0, -20.0, 0.0, 20.0, 30.0, 45.0, 60.0] {
        let work_line = line(deg);
        let p_2 = f.hat_w2 * work_line.rho.cos() / (work_line.rho.sin() + f.c_w2 * work_line.rho.cos());
        let p_1 = (f.hat_zv1 - p_2 * f.c_zv12) / f.c_zv11;
        let worm_line = DiagonalLine { rho: (f.hat_w1 / p_1 - f.c_w1).atan() };
        match f.ratio_of_directions(worm_line, work_line) {
            Ok(ratio) => assert!(ratio.abs() > 1e9, "{ratio}"),
            error => {
                refused(error, "diagonal-ratio-infinite", &[&format!("{}", line(deg).rho.to_degrees())]);
                infinite += 1;
            }
        }
    }
    assert!(infinite > 0);
}

/// A function that ends at a border of the dressed worm.
struct Ending(f64);

impl ThreadFunction for Ending {
    fn jet(&self, _: f64, z: f64) -> Option<Jet2> {
        (z < self.0).then(Jet2::default)
    }
}

/// A function whose curvature is nowhere finite.
struct Edged;

impl ThreadFunction for Edged {
    fn jet(&self, _: f64, _: f64) -> Option<Jet2> {
        Some(Jet2 { fuu: f64::INFINITY, ..Jet2::default() })
    }
}

#[test]
fn contacts_that_do_not_exist_are_refused() {
    let pair = tight();
    let motion = pair.motion(MotionLaw::polynomial(0.0, vec![0.0, 1.0]));
    let thread = ModifiedThread::new(pair.flanks.left.worm, &Unmodified);
    let exact = ExactContact::new(&pair, Flank::Left, &motion, &thread);
    refused(exact.solve(500.0, 0.0), "contact-below-base", &["500"]);
    refused(exact.solve(-1.0, 0.0), "contact-below-base", &["-1"]);
    refused(exact.solve(f64::NAN, 0.0), "no-start", &["NaN"]);
    refused(exact.solve(14.0, f64::INFINITY), "no-start", &["inf"]);
    refused(exact.solve_grid(&[14.0, 500.0], &[0.0, 1.0]), "contact-below-base", &["500"]);
    // What is there is found beside what is not.
    let easy = exact.solve_grid_where_easy(&[14.0, 500.0], &[0.0, 1.0]);
    assert_eq!(easy.iter().map(|(k, _)| *k).collect::<Vec<_>>(), [0, 1]);
    let ending = Ending(-1000.0);
    let short = ModifiedThread::new(pair.flanks.left.worm, &ending);
    let exact = ExactContact::new(&pair, Flank::Left, &motion, &short);
    refused(exact.solve(14.0, 0.0), "worm-surface-missing", &["parameters"]);
    // An edge across the thread: value and slope are there, the curvature is not.
    let edged = ModifiedThread::new(pair.flanks.left.worm, &Edged);
    let exact = ExactContact::new(&pair, Flank::Left, &motion, &edged);
    refused(exact.solve(14.0, 0.0), "not-smooth", &["kink"]);
    // A hollow sharper than the worm's own curvature folds the envelope.
    let f = &pair.flanks.left;
    let at = f.point_map(14.5, 0.0, DiagonalRatio { ratio: 1.0, shift_origin: 0.0 }).unwrap();
    for amount in [20.0, 200.0] {
        let hollow = Polynomial2::from_terms([(2, 0, amount * UM)]).shifted(-at.w_1, -at.z_1);
        let folded = ModifiedThread::new(f.worm, &hollow);
        let exact = ExactContact::new(&pair, Flank::Left, &motion, &folded);
        let codes: Vec<&str> =
            [10.0, 12.0, 14.5, 16.0].map(|w| exact.solve(w, 0.0).err().map_or("", |e| e.code())).into();
        assert!(codes.contains(&"undercut"), "{codes:?}");
    }
}

#[test]
fn solvers_may_be_shared_and_sent_between_threads() {
    fn shared<T: Send + Sync>() {}
    shared::<ExactContact<'_, ModifiedThread<'_, Polynomial2>>>();
}
