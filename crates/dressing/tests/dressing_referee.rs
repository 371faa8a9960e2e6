//! The referee of `removal` against the closed forms of dressing on random worms: rays know bodies and motions only, the forward
//! calculation knows no ray.

use crate::dressing_bodies::{Bodies, CASE_A, bodies, flanks};
use dressing::{
    ConditionSolver, CrowningLimits, CrowningRows, DressedProfile, DressedWorm, DresserTool, FlankDresser,
    MeasuredFlank, Recovery, dressing_motion, recover_from_points, three_points_with_map, two_flank_points,
};
use foundation::geometry::{Flank, Revolution};
use foundation::kinematics::{DressingCorrection, DressingMotion};
use foundation::numerics::{Chebyshev, Silent};
use proptest::prelude::*;
use referee::{Dressing, RayGrid, dress};

/// Rows of rays over the used profile and their half width along the worm, mm.
const ROWS: usize = 5;
const HALF_WIDTH: f64 = 4.0;

/// Length that rays look up and down, mm.
const STOCK: f64 = 0.5;

/// Largest change of the crossing angle, rad: a disc that stands further askew in its groove meets more than the flank that the
/// closed form looks at, and rays tell so.
const LARGEST_TILT: f64 = 0.1;

/// Lengths of the rays over a stretch of the worm, row by row.
fn rays(
    dresser: &FlankDresser,
    profile: &Revolution,
    motion: &DressingMotion,
    margin: f64,
) -> (RayGrid, Vec<f64>) {
    let range = dresser.range;
    let grid = RayGrid::equidistant([range.w_nf, range.w_na], ROWS, [-HALF_WIDTH, HALF_WIDTH], 3).unwrap();
    let b = [range.w_nf, range.w_na].map(|w| dresser.line.value(w));
    let pitch = 2.0 * std::f64::consts::PI * dresser.chain.screw_parameter.abs() / dresser.worm.teeth;
    let beyond = HALF_WIDTH + 0.5 * pitch + margin;
    let stroke = [b[0].min(b[1]) - beyond, b[0].max(b[1]) + beyond];
    let base_pitch =
        2.0 * std::f64::consts::PI * dresser.worm.base_radius * dresser.worm.base_helix_angle.cos()
            / dresser.worm.teeth;
    let stock = f64::min(STOCK, 0.24 * base_pitch);
    let setup = Dressing { worm: &dresser.worm, dresser: profile, motion, shift_range: stroke, stock };
    let left = dress(&setup, &grid, &Silent).unwrap();
    let lengths = left.rays.iter().map(|ray| ray.map_or(f64::NAN, |ray| ray.f)).collect();
    (grid, lengths)
}

/// Largest distance of the rays from the closed form at a constant correction, mm.
fn apart(dresser: &FlankDresser, dk: DressingCorrection) -> f64 {
    let profile = DressedProfile::of_flank(dresser, dk);
    let range = dresser.range;
    let points: Vec<_> = (0..ROWS)
        .map(|k| range.w_nf + range.length() * k as f64 / (ROWS - 1) as f64)
        .map(|w| profile.at_roll(w).unwrap())
        .collect();
    // The line of contact moves with the correction: so far the stroke has to go beyond that of the nominal one.
    let moved = points.iter().map(|at| (at.b - dresser.line.value(at.w)).abs()).fold(0.0, f64::max);
    let motion = DressingMotion::constant(dresser.chain, dk);
    let (grid, lengths) = rays(dresser, &dresser.profile, &motion, moved);
    lengths
        .iter()
        .enumerate()
        .map(|(k, f)| (f - profile.at_roll(grid.ray(k).0).unwrap().f).abs())
        // A ray that is not finished is as far off as can be.
        .fold(0.0, |worst, off| if off.is_nan() { f64::INFINITY } else { f64::max(worst, off) })
}

/// Corrections of a useful size: shares of the producible crowning up to 10 um, and allowances and profile angles of both flanks.
fn useful(bodies: &Bodies, tool: &DresserTool, flank: Flank, shares: [f64; 5]) -> Vec<DressingCorrection> {
    let solver = ConditionSolver::new(tool, bodies.radius());
    let range = CrowningRows::new(&tool.flanks[flank], bodies.radius(), 0.5)
        .range(&CrowningLimits::default())
        .unwrap();
    let end = if shares[0] < 0.0 { range.smallest.crowning } else { range.largest.crowning };
    let crowning = shares[0].abs() * end.clamp(-0.01, 0.01);
    let crowned =
        solver.solve(&three_points_with_map(&tool.flanks[flank], [0.0, -0.87 * crowning, 0.0]), &[0.0; 4]);
    let [a, b, c, d] = [1, 2, 3, 4].map(|k| 0.006 * shares[k]);
    let allowance = solver.solve(&two_flank_points(tool, [a, b], [c, d]), &[0.0; 4]);
    [crowned, allowance].into_iter().flatten().filter(|dk| dk[1].abs() <= LARGEST_TILT).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn rays_leave_the_profile_of_the_closed_form(
        bodies in bodies(),
        flank in flanks(),
        shares in prop::array::uniform5(-0.8..0.8f64),
    ) {
        let Ok(tool) = bodies.tool() else { return Ok(()) };
        let corrections = useful(&bodies, &tool, flank, shares);
        prop_assume!(!corrections.is_empty());
        for dk in corrections {
            let worst = apart(&tool.flanks[flank], dk);
            prop_assert!(worst < 1e-9, "{dk:?}: {worst}");
        }
    }

    /// One motion for both flanks of symmetric and asymmetric worms.
    #[test]
    fn both_flanks_of_one_motion_are_what_was_asked(
        bodies in bodies(),
        f in prop::array::uniform4(-0.005..0.005f64),
    ) {
        let Ok(tool) = bodies.tool() else { return Ok(()) };
        let (left, right) = ([f[0], f[1]], [f[2], f[3]]);
        let Ok(dk) = ConditionSolver::new(&tool, bodies.radius())
            .solve(&two_flank_points(&tool, left, right), &[0.0; 4])
        else {
            return Ok(());
        };
        prop_assume!(dk[1].abs() <= LARGEST_TILT);
        for (flank, wanted) in [(Flank::Left, left), (Flank::Right, right)] {
            let dresser = &tool.flanks[flank];
            let profile = DressedProfile::of_flank(dresser, dk);
            for (w, f) in [(dresser.range.w_nf, wanted[0]), (dresser.range.w_na, wanted[1])] {
                prop_assert!((profile.at_roll(w).unwrap().f - f).abs() < 1e-9);
            }
            let worst = apart(dresser, dk);
            prop_assert!(worst < 1e-9, "{dk:?}: {worst}");
        }
    }

    /// The dressing motion that changes along the worm: parabolas between useful corrections.
    #[test]
    fn rays_leave_the_exact_envelope_of_a_motion(
        bodies in bodies(),
        flank in flanks(),
        shares in prop::array::uniform5(-0.5..0.5f64),
        bend in -0.5..0.5f64,
    ) {
        let Ok(tool) = bodies.tool() else { return Ok(()) };
        let dresser = &tool.flanks[flank];
        let Some(&dk) = useful(&bodies, &tool, flank, shares).first() else { return Ok(()) };
        // Beyond the pole of the K chart the straight way to a correction leads through no contact.
        prop_assume!(dk[0].abs() < 0.5);
        // From half the correction where the middle of the grid is dressed: all of it 20 mm further on, nothing 20 mm before.
        let middle = dresser.line.value(dresser.range.middle());
        let half = middle.abs() + 60.0;
        let series = dk.map(|x| {
            let law = |v: f64| x * (0.5 + (v - middle) / 40.0 * (1.0 + bend * (v - middle) / 40.0));
            Chebyshev::fit(-half, half, 5, |v| Ok::<_, ()>(law(v))).unwrap()
        });
        let motion = dressing_motion(dresser.chain, &series);
        let envelope = DressedWorm::new(&tool, flank, &series);
        let (grid, lengths) = rays(dresser, &dresser.profile, &motion, 3.0);
        for (k, f) in lengths.iter().enumerate() {
            let (w, b) = grid.ray(k);
            let Some((exact, ..)) = envelope.modification(w, b) else {
                return Err(TestCaseError::fail(format!("({w}, {b}) is not dressed: {dk:?}")));
            };
            // Between two corrections that make micrometres the K chart may lead far off.
            prop_assume!(exact.abs() < 0.5 * STOCK);
            prop_assert!((f - exact).abs() < 1e-7, "({w}, {b}): {f} {exact}");
        }
    }

    /// A flank of a conical worm is a helicoid with a lead of its own.
    #[test]
    fn rays_leave_the_profile_on_conical_worms(
        bodies in bodies(),
        cone in -4.0..4.0f64,
        flank in flanks(),
        shares in prop::array::uniform5(-0.6..0.6f64),
    ) {
        let conical = Bodies { cone, ..bodies };
        let worm = conical.worm();
        prop_assume!((worm.screw_parameter(Flank::Left) - worm.screw_parameter(Flank::Right)).abs() > 1e-6);
        let Ok(tool) = conical.tool() else { return Ok(()) };
        prop_assert!(tool.flanks.left.chain != tool.flanks.right.chain);
        // Both flanks at once are refused, so that at most the crowning of one is left.
        let corrections = useful(&conical, &tool, flank, shares);
        prop_assert!(corrections.len() < 2);
        prop_assume!(corrections.len() == 1);
        let worst = apart(&tool.flanks[flank], corrections[0]);
        prop_assert!(worst < 1e-9, "{worst}");
    }
}

/// The closed form holds up to the end of the range: rays meet nothing else of the dresser before contact is lost.
#[test]
fn rays_agree_up_to_the_loss_of_contact() {
    let tool = CASE_A.tool().unwrap();
    let dresser = &tool.flanks.left;
    let range = CrowningRows::new(dresser, CASE_A.radius(), 0.5).range(&CrowningLimits::default()).unwrap();
    for share in [-0.999, -0.5, 0.5, 0.9, 0.98] {
        let end = if share < 0.0 { range.smallest.crowning } else { range.largest.crowning };
        let wanted = f64::abs(share) * end;
        let at = range
            .path
            .iter()
            .min_by(|a, b| (a.crowning - wanted).abs().total_cmp(&(b.crowning - wanted).abs()));
        let worst = apart(dresser, at.unwrap().dk);
        assert!(worst < 1e-9, "{share}: {worst}");
    }
}

/// Axes that were off while a motion dressed the worm are found from the rays that it left: all four from both flanks, three from the form
/// of the flanks alone.
#[test]
fn axes_that_are_off_are_found_from_rays() {
    let tool = CASE_A.tool().unwrap();
    let planned = [2e-3, -3e-3, 0.03, 0.4];
    let true_off: DressingCorrection = [2e-4, 3e-4, 0.012, -0.04];
    for by_form in [false, true] {
        let off: DressingCorrection =
            std::array::from_fn(|j| if by_form && j == 0 { 0.0 } else { true_off[j] });
        let series = planned.map(|x| {
            Chebyshev::fit(-90.0, 90.0, 5, |v: f64| Ok::<_, ()>(x * (1.0 + v / 60.0 + (v / 80.0).powi(2))))
                .unwrap()
        });
        let points = Flank::BOTH.map(|flank| {
            let dresser = &tool.flanks[flank];
            let real = std::array::from_fn(|j| series[j].raised(off[j]));
            let motion = dressing_motion(dresser.chain, &real);
            let (grid, lengths) = rays(dresser, &dresser.profile, &motion, 3.0);
            let point = |(k, f): (usize, &f64)| {
                let (w, b) = grid.ray(k);
                // The thickness is not known by the form.
                [w, b, f + if by_form { 0.017 } else { 0.0 }]
            };
            lengths.iter().enumerate().map(point).collect::<Vec<_>>()
        });
        let flanks = [(Flank::Left, &points[0]), (Flank::Right, &points[1])];
        let flanks = flanks.map(|(flank, points)| MeasuredFlank { flank, corrections: &series, points });
        let held = [by_form.then_some(0.0), None, None, None];
        let known = Recovery { noise: 1e-7, held };
        let found = recover_from_points(&tool, CASE_A.radius(), &flanks, &known, by_form).unwrap();
        for j in 0..4 {
            let allowed = 4.0 * found.standard_deviation[j] + 1e-6 * off[j].abs();
            assert!((found.deviation[j] - off[j]).abs() <= allowed, "{by_form} {j}: {found:?} {off:?}");
        }
        assert!(found.residual_rms < 1e-7, "{found:?}");
        // What is not dressed cannot be compared.
        let beyond = [[points[0][0][0], 500.0, 0.0]];
        let flank = MeasuredFlank { flank: Flank::Left, corrections: &series, points: &beyond };
        let error = recover_from_points(&tool, CASE_A.radius(), &[flank], &known, by_form).unwrap_err();
        assert_eq!(error.code(), "out-of-dresser", "{error}");
    }
}
