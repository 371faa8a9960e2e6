//! Line dressing: touch and curvature against distances of points, scallops against the referee's rays, limits against sampled
//! bodies, and free directions against the point map.

use contact::{DiagonalLine, DiagonalRatio, ModifiedThread, Pair, ThreadFunction, ToolSurface, Unmodified};
use dressing::{DressingError, LineDressing, TipDisc};
use foundation::geometry::{Flank, Gear, GearData, InvoluteFlank, Sides, WormChoice, worm_for_gear};
use foundation::kinematics::{Dresser, Point};
use foundation::numerics::{Jet2, Polynomial2, Silent, equidistant};
use generating::{equal_ratio_lines, generatrix, lines_for_ratio};
use nalgebra::Vector3;
use referee::{LinePasses, RayGrid, dress_lines};

const MODULE: f64 = 3.5;
const DIAMETER: f64 = 100.0;
const TIP: f64 = 53.2;

/// Worm of case A of `docs/mathematics/dressing.md`, either hand.
fn worm(hand: f64) -> Gear {
    Gear::new(GearData {
        teeth: 5,
        normal_module: MODULE,
        pressure_angle: Sides::both(17.5f64.to_radians()),
        helix_angle: hand * (5.0 * MODULE / DIAMETER).acos(),
        profile_shift: 0.0,
        cone_angle: 0.0,
    })
    .unwrap()
}

fn disc(tip_radius: f64) -> TipDisc {
    TipDisc::new(61.5, tip_radius).unwrap()
}

/// A modification with everything: slope, crowning, twist, 20 um.
fn modification() -> Polynomial2 {
    Polynomial2::from_terms([(1, 0, 5e-4), (2, 0, -6e-4), (0, 2, -3e-5), (1, 1, 1e-4), (0, 1, 2e-4)])
        .shifted(-44.0, 0.0)
}

fn task<'a, F: ThreadFunction>(
    gear: &Gear,
    flank: Flank,
    function: &'a F,
    tip_radius: f64,
    rho: f64,
) -> LineDressing<'a, F> {
    let p = gear.screw_parameter(flank);
    LineDressing {
        worm: ModifiedThread::new(*gear.flank(flank), function),
        counter: *gear.flank(flank.other()),
        worm_tip_radius: TIP,
        disc: disc(tip_radius),
        crossing_angle: -(2.0 * p / DIAMETER).atan(),
        offset: 0.0,
        area: [[41.0, 47.0], [-6.0, 6.0]],
        direction: DiagonalLine { rho },
        scallop: 2e-4,
    }
}

/// Distance of a worm point from the torus of the disc, and the outward normal there, both in the dresser's frame.
fn torus(
    task: &TipDisc,
    at: &foundation::kinematics::DressingPosition,
    x: &Vector3<f64>,
) -> (f64, Vector3<f64>) {
    let pose = at.pose().inverse();
    let p: Point<Dresser> = pose.point(&Point::from_vector(*x));
    let r = p.xyz.x.hypot(p.xyz.y);
    let centre = Vector3::new(p.xyz.x / r, p.xyz.y / r, 0.0) * task.centre_radius();
    let out = p.xyz - centre;
    (out.norm() - task.tip_radius(), out.normalize())
}

#[test]
fn the_disc_touches_where_it_should() {
    let f = modification();
    for hand in [1.0, -1.0] {
        let gear = worm(hand);
        for flank in Flank::BOTH {
            for (gamma, offset) in [(0.0, 0.0), (0.02, 3.0), (-0.03, -4.0)] {
                let base = task(&gear, flank, &f, 0.8, 0.0);
                let task = LineDressing { crossing_angle: base.crossing_angle + gamma, offset, ..base };
                for w in [41.0, 44.0, 47.0] {
                    for z in [-50.0, 0.0, 7.0] {
                        let touch = task.touch(w, z, 100.0).unwrap();
                        let jet = task.worm.jet(w, z).unwrap();
                        let (gap, normal) = torus(&task.disc, &touch.position, &jet.p);
                        assert!(gap.abs() < 1e-12 * 200.0, "{gap}");
                        let pose = touch.position.pose();
                        let outward = pose.rotation() * normal;
                        assert!((outward + jet.n / jet.n.norm()).norm() < 1e-12, "{flank} {w} {z}");
                        assert!((touch.position.crossing_angle - task.crossing_angle).abs() < 1e-15);
                        assert_eq!(touch.position.offset, offset);
                        assert!((touch.position.worm_angle - 100.0).abs() <= std::f64::consts::PI + 1e-12);
                        // Directions: unit, across each other, in the tangent plane.
                        for v in [touch.across, touch.around] {
                            assert!((v.norm() - 1.0).abs() < 1e-12 && v.dot(&jet.n).abs() < 1e-12);
                        }
                        assert!(touch.across.dot(&touch.around).abs() < 1e-12);
                        assert!((pose.translation() - touch.centre).norm() < 1e-11);
                    }
                }
            }
        }
    }
}

#[test]
fn the_relative_form_is_the_gap_to_second_order() {
    let (gear, f) = (worm(1.0), modification());
    for flank in Flank::BOTH {
        let task = task(&gear, flank, &f, 0.8, 0.0);
        for (w, z) in [(41.5, -4.0), (46.0, 3.0)] {
            let form = task.form(w, z).unwrap();
            let at = task.touch(w, z, 0.0).unwrap().position;
            let gap = |dw: f64, dz: f64| torus(&task.disc, &at, &task.worm.jet(w + dw, z + dz).unwrap().p).0;
            let h = 1e-3;
            let second = [
                (gap(h, 0.0) + gap(-h, 0.0)) / (h * h),
                (gap(h, h) + gap(-h, -h) - gap(h, -h) - gap(-h, h)) / (4.0 * h * h),
                (gap(0.0, h) + gap(0.0, -h)) / (h * h),
            ];
            for (numeric, exact) in second.into_iter().zip([form.q[(0, 0)], form.q[(0, 1)], form.q[(1, 1)]]) {
                assert!((numeric - exact).abs() < 2e-4 * (1.0 + exact.abs()), "{flank}: {numeric} {exact}");
            }
            assert!(form.is_point_contact());
        }
    }
}

/// Rays on a patch round (w, z), dense enough to see the scallops; height over the wanted surface, least and greatest.
fn rays(task: &LineDressing<'_, Polynomial2>, at: (f64, f64), span: [f64; 2], nodes: usize) -> [f64; 2] {
    let plan = task.plan().unwrap();
    let paths: Vec<_> =
        plan.lines.iter().map(|line| task.path(line, nodes.max(plan.nodes)).unwrap()).collect();
    let passes = LinePasses {
        worm: &task.worm.flank,
        centre_radius: task.disc.centre_radius(),
        tip_radius: task.disc.tip_radius(),
        paths: &paths,
        stock: 0.1,
    };
    let around = |x: f64, half: f64| [x - half, x + half];
    let grid = RayGrid::equidistant(around(at.0, span[0]), 7, around(at.1, span[1]), 41).unwrap();
    let cut = dress_lines(&passes, &grid, &Silent).unwrap().lengths().unwrap();
    let over = cut.iter().enumerate().map(|(k, f)| {
        let (w, z) = grid.ray(k);
        f - ThreadFunction::jet(task.worm.function, w, z).unwrap().f
    });
    foundation::numerics::extremes(over)
}

#[test]
fn rays_see_the_scallops_that_the_curvature_tells() {
    let f = modification();
    for (hand, flank, degrees) in [
        (1.0, Flank::Left, 0.0),
        (1.0, Flank::Right, 20.0),
        (-1.0, Flank::Left, 60.0),
        (1.0, Flank::Left, -19.0),
    ] {
        let gear = worm(hand);
        let base = task(&gear, flank, &f, 0.8, f64::to_radians(degrees));
        // A piece of the flank keeps the number of lines small.
        let task = LineDressing { area: [[41.0, 47.0], [-0.7, 0.7]], ..base };
        let plan = task.plan().unwrap();
        assert!(plan.scallop <= task.scallop * (1.0 + 1e-12) && plan.scallop > 0.5 * task.scallop);
        let (sin, cos) = task.direction.rho.sin_cos();
        for w in [41.0f64, 44.0, 46.9] {
            let pitches = [1.5 * plan.pitch * sin.abs() + 1e-3, 1.5 * plan.pitch * cos.abs() + 1e-4];
            let span = [pitches[0].min(0.09), pitches[1].min(0.6)];
            let [least, greatest] = rays(&task, (w.clamp(41.1, 46.9), 0.0), span, 0);
            let across = task.form(w, 0.0).unwrap().curvature_across(task.direction.rho);
            let height = across * plan.pitch * plan.pitch / 8.0;
            println!(
                "{flank} {degrees} deg w {w}: lines {} nodes {} least {least:.2e} greatest {greatest:.4e} told {height:.4e}",
                plan.lines.len(),
                plan.nodes
            );
            // Nothing is cut too deep but by the splines of the motions; scallops as told.
            assert!(least > -2e-6, "{least}");
            assert!((greatest - height).abs() < 0.04 * height + 1e-6, "{greatest} {height}");
        }
    }
}

#[test]
fn lines_cost_what_they_are_long() {
    let gear = worm(1.0);
    let base = task(&gear, Flank::Left, &Unmodified, 0.8, 0.0);
    let plan = base.plan().unwrap();
    // Lines z = const: the length of an involute helicoid's section, by points.
    let one: f64 = equidistant(plan.lines[0].range, 4001)
        .windows(2)
        .map(|t| {
            let x = |t: f64| {
                let (w, z) = plan.lines[0].point(t);
                base.worm.jet(w, z).unwrap().p
            };
            (x(t[1]) - x(t[0])).norm()
        })
        .sum();
    assert!((plan.length / plan.lines.len() as f64 - one).abs() < 1e-6 * one);
    // Half the height takes sqrt(2) times the lines.
    let finer = LineDressing { scallop: 0.5 * base.scallop, ..base }.plan().unwrap();
    let ratio = finer.lines.len() as f64 / plan.lines.len() as f64;
    assert!((ratio - 2f64.sqrt()).abs() < 0.02, "{ratio}");
    // The rim reaches below the contact at r = 47.64 by r_T (1 - n_r).
    assert!(plan.deepest > 46.9 && plan.deepest < 47.2, "{}", plan.deepest);
    // phi_S runs without jumps and the path leaves the flank by less than its tolerance.
    let positions = base.positions(&plan.lines[0], plan.nodes).unwrap();
    for pair in positions.windows(2) {
        assert!((pair[1].1.worm_angle - pair[0].1.worm_angle).abs() < 0.5);
    }
    let path = base.path(&plan.lines[0], plan.nodes).unwrap();
    for t in equidistant(path.domain, 777) {
        let (w, z) = plan.lines[0].point(t);
        let (gap, _) = torus(&base.disc, &path.position(t), &base.worm.jet(w, z).unwrap().p);
        assert!(gap.abs() < 2.0 * LineDressing::<Unmodified>::MOTION_TOLERANCE, "{t} {gap}");
    }
}

/// A wave with crests across the profile: 5 um, wave length 2 mm, hollow by A k^2 at its bottoms.
struct Wave;

impl ThreadFunction for Wave {
    fn jet(&self, w: f64, _: f64) -> Option<Jet2> {
        let (a, k) = (5e-3, std::f64::consts::PI);
        let (s, c) = (k * w).sin_cos();
        Some(Jet2 { f: a * s, fu: a * k * c, fuu: -a * k * k * s, ..Jet2::default() })
    }
}

#[test]
fn a_hollow_needs_a_rounder_tip() {
    let gear = worm(1.0);
    let says = |tip_radius: f64| task(&gear, Flank::Left, &Wave, tip_radius, 0.0).plan();
    assert!(says(0.8).is_ok());
    // 1/r_T against the hollow: with the real metric the limit lies where the library says, to a percent.
    let wide = |tip_radius: f64| {
        let base = task(&gear, Flank::Left, &Wave, tip_radius, 0.0);
        LineDressing { counter: far_counter(&gear), worm_tip_radius: 1e3, ..base }.plan()
    };
    let error = wide(24.0).unwrap_err();
    let DressingError::TipRadiusTooLarge { w, largest, .. } = error else { panic!("{error}") };
    assert!(error.code() == "tip-radius-too-large" && error.to_string().contains("24 mm"), "{error}");
    assert!((Wave.jet(w, 0.0).unwrap().fuu - 5e-3 * std::f64::consts::PI.powi(2)).abs() < 0.05, "{w}");
    assert!(largest < 24.0, "{largest}");
    // There the disc with that radius is just open, and a little larger one is not.
    let form = |tip_radius: f64| {
        task(&gear, Flank::Left, &Wave, tip_radius, 0.0).form(w, -6.0).unwrap().is_point_contact()
    };
    assert!(form(0.9 * largest) && !form(1.1 * largest), "{largest}");
}

/// A opposite flank so far away that nothing meets it.
fn far_counter(gear: &Gear) -> InvoluteFlank {
    let flank = *gear.flank(Flank::Right);
    InvoluteFlank { teeth: 1.0, base_space_half_angle: flank.base_space_half_angle + 0.6, ..flank }
}

#[test]
fn a_disc_too_thick_is_named_with_its_depth() {
    let gear = worm(1.0);
    let says = |tip_radius: f64| task(&gear, Flank::Left, &Unmodified, tip_radius, 0.0).plan();
    let slim = says(0.8).unwrap();
    let less = says(0.4).unwrap();
    assert!(slim.clearance > 0.0 && less.clearance > slim.clearance);
    // Brute force: points of the torus and of the sides against the opposite flank.
    let brute = |tip_radius: f64, w: f64| {
        let task = task(&gear, Flank::Left, &Unmodified, tip_radius, 0.0);
        let at = task.touch(w, 0.0, 0.0).unwrap().position;
        let pose = at.pose();
        let mut least = f64::INFINITY;
        for psi in equidistant([2.2, 4.1], 801) {
            for theta in equidistant([-1.57, 1.57], 101) {
                let r = task.disc.centre_radius() + tip_radius * theta.cos();
                let x = Vector3::new(r * psi.cos(), r * psi.sin(), tip_radius * theta.sin());
                let x = pose.point(&Point::<Dresser>::from_vector(x)).xyz;
                if x.x.hypot(x.y) < TIP {
                    let f = task.counter.deviation(&x).f_n;
                    let pitch = 2.0
                        * std::f64::consts::PI
                        * task.counter.base_radius
                        * task.counter.base_helix_angle.cos()
                        / task.counter.teeth;
                    least = least.min(if f < -0.25 * pitch { f + pitch } else { f });
                }
            }
        }
        least
    };
    let sampled =
        equidistant([41.0, 47.0], 13).into_iter().map(|w| brute(0.8, w)).fold(f64::INFINITY, f64::min);
    assert!((slim.clearance - sampled).abs() < 5e-3, "{} {sampled}", slim.clearance);
    let error = says(2.2).unwrap_err();
    let DressingError::DiscCollides { w, depth, with, .. } = error else { panic!("{error}") };
    assert_eq!(with, Flank::Right);
    assert!((depth + brute(2.2, w)).abs() < 0.02, "{depth} {}", brute(2.2, w));
    assert_eq!(error.code(), "disc-collides");
}

#[test]
fn unusable_input_is_named() {
    let gear = worm(1.0);
    let base = task(&gear, Flank::Left, &Unmodified, 0.8, 0.0);
    let says = |task: LineDressing<'_, Unmodified>, part: &str| {
        let error = task.plan().unwrap_err();
        assert_eq!(error.code(), "invalid-number", "{error}");
        assert!(error.to_string().contains(part) && !error.way_out().is_empty(), "{error}");
    };
    says(LineDressing { scallop: 0.0, ..base }, "scallop");
    says(LineDressing { scallop: 1e-15, ..base }, "200 000");
    says(LineDressing { crossing_angle: f64::NAN, ..base }, "crossing angle");
    says(LineDressing { area: [[47.0, 41.0], [-6.0, 6.0]], ..base }, "lengths of roll");
    says(LineDressing { area: [[41.0, 47.0], [6.0, 6.0]], ..base }, "worm to be dressed");
    says(LineDressing { direction: DiagonalLine { rho: f64::INFINITY }, ..base }, "direction");
    assert!(
        TipDisc::new(61.5, 0.0).is_err()
            && TipDisc::new(-1.0, 0.5).is_err()
            && TipDisc::new(1.0, 0.9).is_err()
    );
    // A modification that ends inside the area.
    struct Half;
    impl ThreadFunction for Half {
        fn jet(&self, w: f64, _: f64) -> Option<Jet2> {
            (w < 44.0).then(Jet2::default)
        }
    }
    let error = task(&gear, Flank::Left, &Half, 0.8, 0.0).plan().unwrap_err();
    assert_eq!(error.code(), "worm-surface-undefined");
    // A disc that stands across the thread touches its flank nowhere with its rim.
    let across = LineDressing { crossing_angle: base.crossing_angle + 1.45, ..base };
    let error = across.plan().unwrap_err();
    assert!(["disc-touches-not", "disc-collides", "tip-radius-too-large"].contains(&error.code()), "{error}");
}

/// The asymmetric gear of `docs/mathematics/generating-contact.md` with its cylindrical worm.
fn asymmetric() -> Pair {
    let gear = Gear::new(GearData {
        teeth: 31,
        normal_module: 2.5,
        pressure_angle: Sides { left: 25f64.to_radians(), right: 18f64.to_radians() },
        helix_angle: 20f64.to_radians(),
        profile_shift: 0.0,
        cone_angle: 0.0,
    })
    .unwrap();
    let choice = WormChoice {
        threads: 2,
        hand: 1.0,
        pitch_diameter: Some(240.0),
        tip_diameter: None,
        pressure_angle: None,
        profile_shift: 0.0,
        cone_angle: 0.0,
    };
    let made = worm_for_gear(&gear, &choice).unwrap();
    Pair::without_backlash(made.worm, gear, made.crossed_axes_angle).unwrap()
}

#[test]
fn free_lines_let_both_flanks_share_a_ratio() {
    let pair = asymmetric();
    let work = Sides {
        left: DiagonalLine { rho: 30f64.to_radians() },
        right: DiagonalLine { rho: -30f64.to_radians() },
    };
    let preferred = Sides::try_from_fn(|flank| generatrix(&pair.flanks[flank])).unwrap();
    let free = equal_ratio_lines(&pair, work, preferred).unwrap();
    // Along the generatrix the flanks differ (`docs/mathematics/generating-contact.md#how-it-is-verified`).
    let [left, right] = [free.preferred_ratios.left.unwrap(), free.preferred_ratios.right.unwrap()];
    assert!((left - 4.618861883).abs() < 1e-8 && (right - 4.765852080).abs() < 1e-8, "{left} {right}");
    assert!(free.ratio > left && free.ratio < right);
    for flank in Flank::BOTH {
        let relations = &pair.flanks[flank];
        let own = relations.ratio_of_directions(free.lines[flank], work[flank]).unwrap();
        assert!((own - free.ratio).abs() < 1e-11 * free.ratio, "{own}");
        // Points of one line of the workpiece lie on one line of the worm.
        let diagonal = DiagonalRatio { ratio: free.ratio, shift_origin: 0.4 };
        let x_1 = |t: f64| {
            let (sin, cos) = work[flank].rho.sin_cos();
            let at = relations.point_map(20.0 + t * cos, 2.0 - t * sin, diagonal).unwrap();
            free.lines[flank].coordinate(at.w_1, at.z_1)
        };
        assert!((x_1(5.0) - x_1(-3.0)).abs() < 1e-9, "{flank}");
        // The closed form of `docs/mathematics/dressing.md#conditions`.
        let (b_1, b_2) = (relations.worm.base_helix_angle, relations.work.base_helix_angle);
        let s = flank.sign();
        let k = -(b_1.cos() / b_2.cos()) * (free.lines[flank].rho.tan() - s * b_1.tan())
            / (work[flank].rho.tan() - s * b_2.tan());
        assert!((k - free.ratio).abs() < 1e-9 * free.ratio);
    }
    // No ratio beside it comes nearer to the lines preferred.
    let off = |k: f64| {
        let lines = lines_for_ratio(&pair, work, k).unwrap();
        Flank::BOTH.map(|f| (lines[f].rho - preferred[f].rho).powi(2)).iter().sum::<f64>()
    };
    for k in equidistant([left - 0.05, right + 0.05], 301) {
        assert!(off(k) >= off(free.ratio) - 1e-12);
    }
    // A ratio that asks for the contact path itself is refused.
    let along = Sides { left: pair.flanks.left.contact_path()[1], right: work.right };
    assert!(lines_for_ratio(&pair, along, 3.0).is_err());
    assert!(lines_for_ratio(&pair, work, 0.0).is_err());
}
