//! Dressing: derivatives, symmetries and charts on random worms, and every refusal with its code and message. The reference
//! numbers are checked by `verify` (`tests/verify.rs`).

use dressing::{
    Condition, ConditionSolver, ContactLine, DressedProfile, DressedWorm, DresserTool, DressingError,
    GeometricRange, TiltChart, dressing_motion, full_tip_land, nominal_contact, quasi_static_modification,
    solve_conditions_at, stretch,
};
use foundation::geometry::{Flank, Gear, GearData, GeometryError, Sides};
use foundation::kinematics::{DressingChain, DressingCorrection, DressingMotion};
use foundation::numerics::Chebyshev;
use proptest::prelude::*;

const MODULE: f64 = 3.5;

/// A worm with its nominal dresser: threads, reference diameter, profile angle (deg), hand, dresser diameter.
#[derive(Clone, Copy, Debug)]
struct Choice {
    threads: i32,
    diameter: f64,
    angle: f64,
    hand: f64,
    dresser: f64,
}

const CASE_A: Choice = Choice { threads: 5, diameter: 100.0, angle: 17.5, hand: 1.0, dresser: 123.0 };

impl Choice {
    fn worm(&self) -> Gear {
        Gear::new(GearData {
            teeth: self.threads,
            normal_module: MODULE,
            pressure_angle: Sides::both(self.angle.to_radians()),
            helix_angle: self.hand * (f64::from(self.threads) * MODULE / self.diameter).acos(),
            profile_shift: 0.0,
            cone_angle: 0.0,
        })
        .unwrap()
    }

    fn chain(&self) -> DressingChain {
        let p = self.worm().screw_parameter(Flank::Left);
        DressingChain {
            worm_angle: -std::f64::consts::FRAC_PI_2,
            crossing_angle: -(2.0 * p / self.diameter).atan(),
            centre_distance: 0.5 * (self.dresser + self.diameter) - 1.25 * MODULE,
            offset: 0.0,
            screw_parameter: p,
        }
    }

    fn range(&self) -> GeometricRange {
        let flank = *self.worm().flank(Flank::Left);
        let roll = |height: f64| flank.length_of_roll(0.5 * self.diameter + height * MODULE).unwrap();
        GeometricRange { w_nf: roll(-0.9), w_na: roll(0.9) }
    }

    fn tool(&self) -> DresserTool {
        DresserTool::conjugate(&self.worm(), Sides::both(self.chain()), Sides::both(self.range())).unwrap()
    }
}

fn choices() -> impl Strategy<Value = Choice> {
    (1..8i32, 90.0..240.0f64, 15.0..23.0f64, any::<bool>(), 80.0..200.0f64).prop_map(
        |(threads, diameter, angle, right, dresser)| Choice {
            threads,
            diameter,
            angle,
            hand: if right { 1.0 } else { -1.0 },
            dresser,
        },
    )
}

/// Corrections of the size that profile crownings of a few micrometres ask for.
fn corrections() -> impl Strategy<Value = DressingCorrection> {
    (-0.003..0.003f64, -0.006..0.006f64, -0.06..0.06f64, -1.0..1.0f64).prop_map(|(a, b, c, d)| [a, b, c, d])
}

fn flanks() -> impl Strategy<Value = Flank> {
    any::<bool>().prop_map(|left| if left { Flank::Left } else { Flank::Right })
}

/// Rates of change of a dressing motion that stay within what a grinding worm sees.
fn series(lin: [f64; 4], half: f64) -> [Chebyshev; 4] {
    lin.map(|slope| Chebyshev::from_coefficients(-half, half, vec![0.0, slope * half]))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn the_nominal_dresser_makes_the_involute(choice in choices(), flank in flanks(), share in 0.0..1.0f64) {
        let tool = choice.tool();
        let range = tool.flanks[flank].range;
        let w = range.w_nf + share * range.length();
        let at = DressedProfile::new(&tool, flank, [0.0; 4]).at_roll(w).unwrap();
        prop_assert!(at.f.abs() < 1e-11 && (at.t - w).abs() < 1e-8, "{at:?}");
        let nominal = nominal_contact(choice.worm().flank(flank), &tool.flanks.left.chain, w).unwrap();
        prop_assert!((at.b - nominal.b).abs() < 1e-8 && (at.r_a - nominal.r).abs() < 1e-9);
        prop_assert!(stretch(&tool, flank, [0.0; 4]).unwrap().abs() < 1e-8);
        // The slope of the contact line against its own points.
        let h = 1e-4;
        let b = |w: f64| nominal_contact(choice.worm().flank(flank), &tool.flanks.left.chain, w).unwrap().b;
        prop_assert!((nominal.slope - (b(w + h) - b(w - h)) / (2.0 * h)).abs() < 1e-6);
    }

    #[test]
    fn derivatives_are_those_of_central_differences(
        choice in choices(),
        flank in flanks(),
        dk in corrections(),
        share in 0.1..0.9f64,
    ) {
        let tool = choice.tool();
        let range = tool.flanks[flank].range;
        let w = range.w_nf + share * range.length();
        let profile = |dk: DressingCorrection| DressedProfile::new(&tool, flank, dk);
        let at = profile(dk).at_roll(w).unwrap();
        let (_, map) = profile(dk).map_gradient(w).unwrap();
        let steps = [2e-6, 2e-6, 1e-4, 1e-3];
        for j in 0..4 {
            let moved = |sign: f64| {
                let mut dk = dk;
                dk[j] += sign * steps[j];
                profile(dk)
            };
            let (up, down) = (moved(1.0), moved(-1.0));
            let f = (up.at_roll(w).unwrap().f - down.at_roll(w).unwrap().f) / (2.0 * steps[j]);
            let scale = [choice.diameter, 10.0, 1.0, 0.1][j];
            prop_assert!((at.df_dk[j] - f).abs() < 2e-6 * scale, "f by {j}: {} {f}", at.df_dk[j]);
            let w_t = (up.at_parameter(w).unwrap().w - down.at_parameter(w).unwrap().w) / (2.0 * steps[j]);
            prop_assert!((map[j] - w_t).abs() < 1e-4 * (1.0 + map[j].abs()), "w by {j}: {} {w_t}", map[j]);
        }
    }

    /// The plane through the worm axis and the middle of the dresser mirrors a right-handed worm onto a left-handed one.
    #[test]
    fn hands_mirror(choice in choices(), flank in flanks(), dk in corrections(), share in 0.0..1.0f64) {
        let mirror = Choice { hand: -choice.hand, ..choice };
        let (tool, other) = (choice.tool(), mirror.tool());
        let range = tool.flanks[flank].range;
        let w = range.w_nf + share * range.length();
        let here = DressedProfile::new(&tool, flank, dk).at_roll(w).unwrap();
        let mirrored = [-dk[0], -dk[1], dk[2], -dk[3]];
        let there = DressedProfile::new(&other, flank.other(), mirrored).at_roll(w).unwrap();
        prop_assert!((here.f - there.f).abs() < 1e-10 && (here.t - there.t).abs() < 1e-7);
        prop_assert!((here.b - there.b).abs() < 1e-7, "{} {}", here.b, there.b);
    }

    /// Half a turn about the common perpendicular maps a symmetric worm onto itself with left and right changed.
    #[test]
    fn flanks_turn_into_each_other(choice in choices(), dk in corrections(), share in 0.0..1.0f64) {
        let tool = choice.tool();
        let w = tool.flanks.left.range.w_nf + share * tool.flanks.left.range.length();
        let left = DressedProfile::new(&tool, Flank::Left, dk).at_roll(w).unwrap();
        let turned = [-dk[0], dk[1], dk[2], -dk[3]];
        let right = DressedProfile::new(&tool, Flank::Right, turned).at_roll(w).unwrap();
        prop_assert!((left.f - right.f).abs() < 1e-10 && (left.b + right.b).abs() < 1e-7);
    }

    #[test]
    fn both_charts_describe_the_same_pose(
        gamma in -0.3..0.3f64,
        v_y in -20.0..20.0f64,
        d in 80.0..160.0f64,
        phi in -2.0..-1.0f64,
        p in 4.0..12.0f64,
    ) {
        prop_assume!(gamma.abs() > 1e-3);
        let k = [phi, gamma, d, v_y];
        let back = TiltChart::from_kinematics(k, p).to_kinematics(p, d, phi).unwrap();
        for j in 0..4 {
            prop_assert!((back[j] - k[j]).abs() < 1e-9 * (1.0 + k[j].abs()), "{j}: {} {}", back[j], k[j]);
        }
    }

    #[test]
    fn conditions_are_met(choice in choices(), flank in flanks(), f in (-0.02..0.02f64, -0.02..0.02f64)) {
        let tool = choice.tool();
        let range = tool.flanks[flank].range;
        let rows = [
            Condition::Point { flank, w: range.w_nf, f: f.0 },
            Condition::Point { flank, w: range.w_na, f: f.1 },
            Condition::Fixed { j: 2, x: 0.0 },
            Condition::Fixed { j: 3, x: 0.0 },
        ];
        let solver = ConditionSolver::new(&tool, 0.5 * choice.diameter);
        // Without offset and distance the profile angle is reachable only in part; what is found must fulfil the rows.
        if let Ok(dk) = solver.solve(&rows, &[0.0; 4]) {
            let profile = DressedProfile::new(&tool, flank, dk);
            prop_assert!((profile.at_roll(range.w_nf).unwrap().f - f.0).abs() < 1e-10);
            prop_assert!((profile.at_roll(range.w_na).unwrap().f - f.1).abs() < 1e-10);
            prop_assert!(dk[2].abs() < 1e-12 && dk[3].abs() < 1e-12);
        }
    }

    /// The envelope of a slow motion is the profile that stands still, up to the second order in the rates.
    #[test]
    fn the_exact_envelope_approaches_the_first_order(
        choice in choices(),
        flank in flanks(),
        rates in (-1e-5..1e-5f64, -2e-5..2e-5f64, -1e-4..1e-4f64, -1e-3..1e-3f64),
        share in 0.1..0.9f64,
        b in -10.0..10.0f64,
    ) {
        let tool = choice.tool();
        let range = tool.flanks[flank].range;
        let w = range.w_nf + share * range.length();
        let differ = |factor: f64| {
            let lin = [rates.0, rates.1, rates.2, rates.3].map(|r| r * factor);
            let series = series(lin, 80.0);
            let motion: DressingMotion = dressing_motion(tool.flanks.left.chain, &series);
            let (exact, ..) = DressedWorm::new(&tool, flank, &series).modification(w, b).unwrap();
            let (first, _) = quasi_static_modification(&tool, flank, &motion, w, b).unwrap();
            exact - first
        };
        let (whole, half) = (differ(1.0), differ(0.5));
        prop_assert!(whole.abs() < 1e-5, "{whole}");
        prop_assert!((whole - 4.0 * half).abs() < 0.2 * whole.abs() + 1e-10, "{whole} {half}");
    }
}

#[test]
fn tip_lands_and_lines_of_both_flanks_agree() {
    let tool = CASE_A.tool();
    let land = full_tip_land(&tool, 0.5 * CASE_A.dresser).unwrap();
    let deeper = full_tip_land(&tool, 0.5 * CASE_A.dresser - 0.1).unwrap();
    // The land grows inwards by both flank angles.
    let grown = 2.0 * 0.1 * CASE_A.angle.to_radians().tan();
    assert!(land > 0.0 && (deeper - land - grown).abs() < 0.01, "{land} {deeper}");
    let [left, right] = Flank::BOTH.map(|flank| ContactLine::fit(&tool, flank, [0.0; 4]).unwrap());
    assert!((left.rho + right.rho).abs() < 1e-12 && (left.straightness - right.straightness).abs() < 1e-10);
    let refused = full_tip_land(&tool, -500.0).unwrap_err();
    assert_eq!(refused.code(), "no-conjugate");
}

fn three_points(range: GeometricRange, middle: f64) -> [Condition; 4] {
    let point = |w, f| Condition::Point { flank: Flank::Left, w, f };
    let map = Condition::Map { flank: Flank::Left, t: range.w_na, w: range.w_na };
    [point(range.w_nf, 0.0), point(range.middle(), middle), point(range.w_na, 0.0), map]
}

fn says(error: &DressingError, code: &str, parts: &[&str]) {
    assert_eq!(error.code(), code);
    let text = error.to_string();
    assert!(parts.iter().all(|part| text.contains(part)), "{text}");
    assert!(!error.way_out().is_empty());
}

#[test]
fn impossible_dressers_are_refused() {
    let empty = GeometricRange { w_nf: 47.0, w_na: 40.0 };
    let error =
        DresserTool::conjugate(&CASE_A.worm(), Sides::both(CASE_A.chain()), Sides::both(empty)).unwrap_err();
    says(&error, "invalid-number", &["w_NfS", "47", "0 < w_NfS < w_NaS"]);
    // The design range reaches down to the base circle.
    let low = GeometricRange { w_nf: 2.0, w_na: 8.0 };
    let error =
        DresserTool::conjugate(&CASE_A.worm(), Sides::both(CASE_A.chain()), Sides::both(low)).unwrap_err();
    says(&error, "no-conjugate", &["left", "-1."]);
    let error = CASE_A.tool().with_head(f64::NAN, 1.5).unwrap_err();
    says(&error, "invalid-number", &["worm head radius"]);
    let error = DressingError::from(GeometryError::CylindricalOnly);
    says(&error, GeometryError::CylindricalOnly.code(), &[]);
}

#[test]
fn contact_is_refused_where_there_is_none() {
    let tool = CASE_A.tool();
    let range = tool.flanks.left.range;
    let error = DressedProfile::new(&tool, Flank::Left, [0.0; 4]).at_roll(3.0 * range.w_na).unwrap_err();
    says(&error, "out-of-dresser", &["left", "outside"]);
    // With its axis along the worm's tangent and far off, the disc meets the thread nowhere.
    let error = DressedProfile::new(&tool, Flank::Right, [0.0, 1.5, -80.0, 0.0])
        .at_parameter(range.w_nf)
        .unwrap_err();
    says(&error, "no-contact", &["right", "profile parameter"]);
}

#[test]
fn conditions_that_determine_nothing_are_refused() {
    let tool = CASE_A.tool();
    let solver = ConditionSolver::new(&tool, 50.0);
    let rows = three_points(tool.flanks.left.range, 0.0);
    says(
        &solver.solve(&rows[..3], &[0.0; 4]).unwrap_err(),
        "condition-count",
        &["3 conditions", "exactly 4"],
    );
    let twice = [rows[0], rows[1], rows[2], rows[0]];
    says(&solver.solve(&twice, &[0.0; 4]).unwrap_err(), "condition-count", &["exactly 4 different"]);
    let fixed = [rows[0], rows[1], Condition::Fixed { j: 2, x: 0.0 }, Condition::Fixed { j: 2, x: 0.1 }];
    says(&solver.solve(&fixed, &[0.0; 4]).unwrap_err(), "singular", &["do not determine"]);
    let head = [rows[0], rows[1], rows[2], Condition::Head { t: 0.0, r: 53.0 }];
    says(&solver.solve(&head, &[0.0; 4]).unwrap_err(), "invalid-number", &["head condition"]);
}

#[test]
fn a_target_beyond_the_fold_names_flank_position_and_share() {
    let tool = CASE_A.tool();
    let range = tool.flanks.left.range;
    let solver = ConditionSolver::new(&tool, 50.0);
    let error = solver.solve(&three_points(range, 0.060), &[0.0; 4]).unwrap_err();
    says(&error, "no-zero", &["left", "percent"]);
    let DressingError::NoZero { fraction, .. } = error else { panic!("{error}") };
    assert!(fraction > 0.0 && fraction < 1.0);
    let rows = |_: f64, _: &[f64; 4]| three_points(range, 0.060);
    let error = solve_conditions_at(&solver, 7.5, &[0.0; 4], &rows).unwrap_err();
    says(&error, "no-zero", &["v_zS = 7.500 mm"]);
}

#[test]
fn the_pole_of_the_chart_is_named() {
    let pole = TiltChart { phi: 0.0, gamma: 0.0, d: 100.0, tau: 0.0 };
    says(&pole.to_kinematics(8.9, 100.0, 0.0).unwrap_err(), "pole-of-chart", &["crossing angle 0"]);
}
