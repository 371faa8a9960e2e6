//! Generating grinding: properties of the decompositions, motions and models, and every refusal with its code and message. The
//! reference numbers are checked by `verify` (`tests/verify.rs`).

use contact::{ExactContact, ModifiedThread, Unmodified};
use foundation::geometry::{Blank, Flank, Gear, GearData, Sides, WormChoice};
use foundation::kinematics::MotionLaw;
use foundation::modification::{Modification, ModificationSpec, NoFiles};
use foundation::numerics::Polynomial2;
use generating::least_squares::FitNorm;
use generating::{
    Command, Decomposition, DresserChoice, DressingLimits, DressingRows, Effort, FeedLaw, FlankTarget, Gauge,
    GeneratingError, GrindingSetup, IdealPlan, LocalEnvelope, PlanGauge, PlanTask, PlanningGrid, Prefer,
    ProfilePlace, ProfilePolicy, QuadraticWorm, SeriesRule, SetupInput, constant_only_profile_crowning,
    decompose_diagonal, decompose_quadratic, decompose_radial, kinematic_compliance, motion_of_flanks,
    natural_twist, product_functions, radial_residual,
};
use proptest::prelude::*;
use serde_json::json;

/// The gear of the twist-free crowning example with its worm and dresser.
pub fn input() -> SetupInput {
    let gear = Gear::new(GearData {
        teeth: 19,
        normal_module: 3.5,
        pressure_angle: Sides::both(17.5f64.to_radians()),
        helix_angle: -(35f64.to_radians()),
        profile_shift: 0.0,
        cone_angle: 0.0,
    })
    .unwrap();
    SetupInput {
        gear,
        blank: Blank {
            face_width: 40.0,
            tip_diameter: 88.5315,
            root_diameter: 72.4315,
            tip_form_diameter: 88.5315,
            form_diameter: 76.2065,
            rack_addendum: None,
        },
        evaluation: [76.2065, 88.5315, -20.0, 20.0],
        worm: WormChoice {
            threads: 3,
            hand: -1.0,
            pitch_diameter: None,
            tip_diameter: Some(200.0),
            pressure_angle: None,
            profile_shift: 0.0,
            cone_angle: 0.0,
        },
        worm_width: Some(100.0),
        dresser: Some(DresserChoice {
            tip_diameter: 123.0,
            pitch_diameter: Some(115.65),
            designed_for: None,
        }),
        tool_direction: None,
        root_clearance: None,
        gear_root: None,
    }
}

fn setup() -> GrindingSetup {
    GrindingSetup::new(input()).unwrap()
}

/// Helix crowning (um) twist-free with 5 um of profile crowning on both flanks.
fn targets(setup: &GrindingSetup, crowning: f64) -> Sides<Option<FlankTarget>> {
    let specs: Vec<ModificationSpec> = [
        json!({"kind": "helix_crowning", "amount_um": crowning}),
        json!({"kind": "profile_crowning", "amount_um": 5.0}),
    ]
    .iter()
    .map(|spec| ModificationSpec::from_json(spec).unwrap())
    .collect();
    Sides::from_fn(|flank| {
        let wanted = Modification::for_flank(&specs, flank, &setup.fields[flank], &NoFiles).unwrap();
        Some(FlankTarget::new(wanted).unwrap())
    })
}

fn task(setup: &GrindingSetup) -> PlanTask<'_> {
    PlanTask {
        setup,
        targets: targets(setup, 20.0),
        tolerance: 1e-3,
        tolerance_map: None,
        limits: DressingLimits::default(),
        ratio: None,
        places: vec![ProfilePlace::Dresser],
        free_dresser: true,
        law: None,
        norm: FitNorm::default(),
        gauge: PlanGauge::default(),
        dressing: DressingRows::default(),
        precompensation: true,
        grid: (5, 5),
        prefer: Prefer::Accuracy,
        least_determinant: 0.1,
        effort: Effort::Full,
    }
}

/// A polynomial of third degree of micrometres on a field of some centimetres, with pure powers of u up to the fifth.
fn targets_of_third_degree() -> impl Strategy<Value = Polynomial2> {
    let exponents = [(0, 0), (0, 1), (0, 2), (0, 3), (1, 0), (1, 1), (1, 2), (2, 0), (2, 1), (3, 0)];
    prop::collection::vec(-1.0..1.0f64, exponents.len()).prop_map(move |values| {
        let term = |(&(i, j), a): (&(usize, usize), f64)| (i, j, a * 0.02 / 10f64.powi((i + j) as i32));
        Polynomial2::from_terms(exponents.iter().zip(values).map(term))
    })
}

/// Directions on the workpiece and its contact path that differ.
fn directions() -> impl Strategy<Value = (f64, f64)> {
    (-2.5..2.5f64, -0.8..0.8f64).prop_filter("parallel", |(t, t_k)| (t - t_k).abs() > 0.2)
}

const POINTS: [(f64, f64); 5] = [(-9.0, -20.0), (9.0, 20.0), (3.0, 7.0), (-4.0, 11.0), (0.0, 0.0)];

proptest! {
    #[test]
    fn every_decomposition_adds_up_to_its_target(
        a in targets_of_third_degree(),
        (t, t_k) in directions(),
        p_2 in -1e-4..1e-4f64,
        gauge in (-1e-3..1e-3f64, -1e-5..1e-5f64, -1e-2..1e-2f64),
    ) {
        let scale = 0.3 / (t - t_k).abs().powi(3);
        let parts = decompose_diagonal(&a, t, t_k, p_2, 0.0);
        let centred = decompose_quadratic(&a, t, t_k, Gauge::Centred { w_m: 13.0, k_20: gauge.1 });
        let given = Gauge::Given { k_10: gauge.0, k_20: gauge.1, k_k0: gauge.2 };
        let given = decompose_quadratic(&a, t, t_k, given);
        for (u, y) in POINTS {
            let wanted = a.value(u, y);
            for (name, found) in
                [("p", parts.value(u, y)), ("q", centred.value(u, y)), ("given", given.value(u, y))]
            {
                prop_assert!((found - wanted).abs() < 1e-10 * scale.max(1.0), "{name} {found} {wanted}");
            }
        }
        prop_assert_eq!((given.linear[0], given.quadratic[0], given.kinematic[0]), gauge);
        // The gauge `centred`: F_K and its slope vanish in the middle of the profile.
        let k = |w: f64, z: f64| centred.kinematic_value(w, z);
        let bend = 1e-2 * (centred.kinematic[2].abs() + centred.kinematic[3].abs()) + 1e-9;
        prop_assert!(k(13.0, 0.0).abs() < 1e-10 * scale.max(1.0));
        prop_assert!((k(13.0, 1e-3) - k(13.0, -1e-3)).abs() < 1e-3 * bend);
    }

    #[test]
    fn the_radial_class_leaves_the_mixed_terms_it_names(a in targets_of_third_degree(), t_k in -0.8..0.8f64) {
        let parts = decompose_radial(&a, t_k);
        let [r_11, r_21, r_12] = radial_residual(&a, t_k);
        for (u, y) in POINTS {
            let left = r_11 * u * y + r_21 * u * u * y + r_12 * u * y * y;
            prop_assert!((a.value(u, y) - parts.value(u, y) - left).abs() < 1e-12);
        }
    }

    #[test]
    fn a_product_with_a_line_function_is_exact(a in targets_of_third_degree(), t in -2.0..2.0f64, w in -9.0..9.0f64, z in -20.0..20.0f64) {
        let p = Polynomial2::from_terms(a.terms().filter(|(i, j, _)| i + j <= 2));
        let x = (t * w + z) / t.hypot(1.0);
        let [f_c, f_l, f_q] = product_functions(&p, t, x, (0.7 * x).sin());
        prop_assert!((f_c + f_l * w + f_q * w * w - p.value(w, z) * (0.7 * x).sin()).abs() < 1e-12);
    }

    #[test]
    fn common_motions_give_each_flank_its_amount(left in prop::array::uniform4(-1e-3..1e-3f64), right in prop::array::uniform4(-1e-3..1e-3f64)) {
        let setup = setup();
        let (delta_d, delta_phi) = motion_of_flanks(&setup.lines, &left, &right);
        for v in [-20.0, 0.0, 13.0] {
            for (flank, wanted) in [(Flank::Left, &left), (Flank::Right, &right)] {
                let l = &setup.lines[flank];
                let f = delta_d.value(v) * l.sin_an - l.s * l.lever * delta_phi.value(v);
                let wanted = wanted.iter().rev().fold(0.0, |sum, c| sum * v + c);
                prop_assert!((f - wanted).abs() < 1e-12 * (1.0 + wanted.abs()));
            }
        }
    }
}

#[test]
fn the_worm_functions_land_on_the_workpiece_point_they_grind() {
    let setup = setup();
    let lines = setup.lines.right;
    let law = MotionLaw::polynomial(0.0, vec![2.0, -1.3]);
    for (w, z) in [(5.0, -18.0), (13.0, 0.0), (22.0, 19.0)] {
        let (w_1, z_1) = lines.worm_point(w, z, &law);
        let [there_w, there_z] = lines.work_point(w_1, z_1, &law);
        assert!((there_w.f - w).abs() < 1e-11 && (there_z.f - z).abs() < 1e-10);
        let [moved_w, moved_z] = lines.work_point(w_1 + 1.0, z_1, &law);
        assert!((moved_w.f - there_w.f - there_w.fu).abs() < 1e-11);
        assert!((moved_z.f - there_z.f - there_z.fu).abs() < 1e-11);
    }
}

/// The local envelope follows the exact contact to a small share of what the contact shift changes.
#[test]
fn the_local_envelope_is_close_to_the_exact_contact() {
    let setup = setup();
    let flank = Flank::Left;
    let lines = setup.lines[flank];
    let crowning = Polynomial2::from_terms([(0, 2, -0.010 / 400.0), (2, 0, -0.004 / 88.0)]);
    let raw = crowning.shifted(-lines.w_m, -lines.z_m);
    let gauge = Gauge::Centred { w_m: lines.w_m, k_20: 0.0 };
    let parts = decompose_quadratic(&raw, lines.work_direction(-1.5), lines.t_k, gauge);
    let mut motion = setup.pair.motion(MotionLaw::polynomial(0.0, vec![0.0, -1.5]));
    let normal = parts.normal_motion(&lines).map(|f| f / lines.sin_an);
    motion.delta_d = MotionLaw::polynomial(0.0, normal.to_vec());
    let worm = QuadraticWorm { lines, shift: MotionLaw::polynomial(0.0, vec![0.0, -1.5]), parts };
    let pair = &setup.pair.flanks[flank];
    let thread = ModifiedThread::new(pair.worm, &worm);
    let exact = ExactContact::new(&setup.pair, flank, &motion, &thread);
    let model = LocalEnvelope::new(pair, &motion, &worm);
    let mut largest = [0.0; 3];
    for (w, z) in [(6.0, -18.0), (13.5, 0.0), (21.0, 18.0), (21.0, -18.0), (9.0, 10.0)] {
        let ground = exact.solve(w, z).unwrap().f_n;
        let models =
            [lines.cos_b2 * raw.value(w, z), model.second_order(w, z).unwrap(), model.value(w, z).unwrap()];
        for (largest, model) in largest.iter_mut().zip(models) {
            *largest = f64::max(*largest, (ground - model).abs());
        }
    }
    let [first, second, local] = largest;
    assert!(local < 2e-5 && local < 0.2 * second && second < first, "{largest:?}");
}

#[test]
fn closed_forms_of_the_radial_crowning() {
    let setup = setup();
    let lines = setup.lines.left;
    let twist = natural_twist(&lines, 0.020);
    assert!((twist.twist + 0.0491302).abs() < 1e-7, "{}", twist.twist);
    // A worm of constants only at rho_2 = 0 asks for no profile crowning, at rho_2 = rho_K for the natural one.
    assert_eq!(constant_only_profile_crowning(&lines, 0.020, 0.0), 0.0);
    let unwanted = constant_only_profile_crowning(&lines, 0.020, lines.t_k);
    assert!((unwanted + twist.profile_crowning).abs() < 1e-15);
    assert!(kinematic_compliance(&setup.pair.flanks.left, lines.w_m).unwrap() > 0.0);
}

fn says(error: &GeneratingError, code: &str, parts: &[&str], bad_input: bool) {
    assert_eq!((error.code(), error.is_bad_input()), (code, bad_input), "{error}");
    let text = error.to_string();
    assert!(parts.iter().all(|part| text.contains(part)), "{text}");
    assert!(!error.way_out().is_empty());
}

#[test]
fn impossible_bodies_are_refused() {
    let refused = |change: &dyn Fn(&mut SetupInput)| {
        let mut changed = input();
        change(&mut changed);
        GrindingSetup::new(changed).unwrap_err()
    };
    let error = refused(&|i| i.worm.threads = 0);
    says(&error, "invalid-number", &["worm.threads"], true);
    let error = refused(&|i| i.evaluation = [88.0, 77.0, -20.0, 20.0]);
    says(&error, "invalid-modification", &["w_"], true);
    let error = refused(&|i| {
        // Worm and gear of opposite lead on parallel axes.
        i.worm.hand = 1.0;
        i.worm.pitch_diameter = Some(3.0 * 3.5 / 35f64.to_radians().cos());
        i.worm.tip_diameter = None;
    });
    says(&error, "axes-parallel", &["parallel"], true);
    let error = refused(&|i| {
        // A thick worm of many threads reaches below its own base circle before the gear's tip is ground.
        i.worm.threads = 25;
        i.worm.pitch_diameter = Some(90.0);
        i.worm.tip_diameter = None;
    });
    assert!(
        matches!(error, GeneratingError::Contact(_) | GeneratingError::Dressing(_)) && !error.is_bad_input(),
        "{error:?}"
    );
    says(&error, error.code(), &["mm"], false);
}

#[test]
fn tasks_without_flank_or_with_too_little_worm_are_refused() {
    let setup = setup();
    let nothing = PlanTask { targets: Sides { left: None, right: None }, ratio: Some(-1.2), ..task(&setup) };
    says(&nothing.plan().unwrap_err(), "no-flank", &["no flank"], true);
    let narrow = GrindingSetup::new(SetupInput { worm_width: Some(20.0), ..input() }).unwrap();
    for ratio in [None, Some(-1.2)] {
        let error = PlanTask { ratio, ..task(&narrow) }.plan_by_rules().unwrap_err().error;
        says(&error, "worm-too-short", &["20.00 mm", "diagonal ratio"], false);
    }
    // A given ratio lifts the limits of axes, not the width of the worm; else a fit takes the ratio that the width allows.
    let given = PlanTask { ratio: Some(-1.2), ..task(&narrow) };
    says(&given.plan().unwrap_err(), "worm-too-short", &["20.00 mm"], false);
    if let Ok(plan) = task(&narrow).plan() {
        let [from, to] = plan.ideal.occupation;
        assert!(to - from <= 20.0, "{}", to - from);
    }
}

#[test]
fn plans_beyond_the_limits_are_refused_with_the_limit() {
    let setup = setup();
    let tight = DressingLimits { correction: [1e-5, 1e-5, 1e-3, 1e-3], delta_d: 1e-7 };
    let error = PlanTask { limits: tight, ..task(&setup) }.plan_by_rules().unwrap_err().error;
    says(&error, "axis-limit", &["planning takes at most", "dressing would have to"], false);
    // A ratio that is not exact enough is refused as a candidate, and made all the same when none is.
    let exact = PlanTask { tolerance: 1e-9, ratio: Some(-1.2), ..task(&setup) };
    let choice = exact.choose(&PlanningGrid::new(&setup, 9, 9)).unwrap();
    let refusal = choice.candidates[0].refusal.clone().unwrap();
    says(&refusal, "model-error", &["ideal worm", "allowed: 0.000"], false);
    let policy = ProfilePolicy {
        series: SeriesRule::default(),
        place: ProfilePlace::Dresser,
        free_dresser: true,
        line_tolerance: 1e-4,
        norm: FitNorm::default(),
        dressing: DressingRows::default(),
        gauge: Sides { left: None, right: None },
    };
    let targets = targets(&setup, 20.0);
    let command = targets.map(|_, t| t.as_ref().map(Command::of));
    let error = IdealPlan::new(&setup, &targets, command, &FeedLaw::Ratio(1e9), policy).unwrap_err();
    says(&error, "degenerate-direction", &["1000000000", "left"], true);
}

#[test]
fn a_crowning_that_folds_the_envelope_is_refused() {
    let setup = setup();
    let lines = setup.lines.left;
    let pair = &setup.pair.flanks.left;
    let q = kinematic_compliance(pair, lines.w_m).unwrap();
    let twist = natural_twist(&lines, 1.0);
    let crowned = |share: f64| {
        // f_n = -k (v - v_0)^2 folds at 2 k q = 1.
        let mut motion = setup.pair.motion(MotionLaw::zero());
        let bend = -share / (2.0 * q * lines.sin_an);
        motion.delta_d = MotionLaw::polynomial(twist.apex_feed, vec![0.0, 0.0, bend]);
        LocalEnvelope::new(pair, &motion, &Unmodified).value(lines.w_m, 0.0)
    };
    assert!(crowned(0.5).unwrap().abs() < 1e-9);
    says(&crowned(1.1).unwrap_err(), "envelope-broken", &["left", "folds"], false);
    let motion = setup.pair.motion(MotionLaw::zero());
    let below = LocalEnvelope::new(pair, &motion, &Unmodified).value(-1.0, 0.0).unwrap_err();
    says(&below, "contact-below-base", &["-1 mm"], false);
    // The plan names the same refusal when every ratio folds.
    let strong = PlanTask { targets: targets(&setup, 3000.0), ratio: Some(-1.2), ..task(&setup) };
    let error = strong.plan().unwrap_err();
    assert!(
        ["envelope-broken", "undercut", "contact-not-found", "no-zero", "no-contact", "out-of-dresser"]
            .contains(&error.code()),
        "{error}"
    );
}

#[test]
fn a_grid_of_nine_by_nine_tells_the_classes_apart() {
    let setup = setup();
    let grid = PlanningGrid::new(&setup, 9, 9);
    let lines = setup.lines.left;
    let error: Vec<f64> = grid
        .w
        .left
        .iter()
        .flat_map(|w| grid.z.iter().map(|z| 1e-5 * (w - lines.w_m) * (z - lines.z_m)).collect::<Vec<_>>())
        .collect();
    let mixed = grid.correction(Flank::Left, &error, lines.cos_b2, true);
    assert!((mixed.coefficient(1, 1) * lines.cos_b2 - 1e-5).abs() < 1e-13);
    let pure = grid.correction(Flank::Left, &error, lines.cos_b2, false);
    assert_eq!(pure.coefficient(1, 1), 0.0);
}

/// The coefficients of u^i y^j that (a u + b y)^k u^i0 times a factor adds.
fn add_power(terms: &mut [[f64; 5]; 5], [a, b]: [f64; 2], k: usize, i0: usize, factor: f64) {
    let mut binomial = 1.0;
    for j in 0..=k {
        terms[k - j + i0][j] += factor * binomial * a.powi((k - j) as i32) * b.powi(j as i32);
        binomial *= (k - j) as f64 / (j + 1) as f64;
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    /// A member of {C, L, P, K}, made a polynomial and decomposed in closed form, is the same flank within 1e-9 um.
    #[test]
    fn members_of_the_polynomial_class_come_back(
        t in -2.5..2.5f64, t_k in -1.0..1.0f64,
        slope in prop::sample::select(vec![0.0, 0.0, 0.12, 0.05, -0.03, -0.15]),
        numbers in prop::collection::vec(-1.0..1.0f64, 15), other_share: bool,
    ) {
        prop_assume!((t - t_k).abs() > 0.2);
        // Every term adds up to 10 um at the edge of a field of 9 mm x 20 mm about the middle.
        let amount = |k: usize, length: f64| 0.01 * numbers[k] / length.powi((k % 4) as i32);
        let member = Decomposition {
            t,
            t_k,
            constant: std::array::from_fn(|k| amount(k, 20.0)),
            linear: std::array::from_fn(|k| amount(4 + k, 20.0) / 9.0),
            profile: (0..4).map(|k| amount(8 + k, 9.0)).collect(),
            profile_slope: slope,
            kinematic: std::array::from_fn(|k| if k < 3 { amount(12 + k, 20.0) } else { amount(7, 20.0) }),
        };
        let (c, c_k) = (1.0 / t.hypot(1.0), 1.0 / t_k.hypot(1.0));
        let mut terms = [[0.0; 5]; 5];
        for k in 0..4 {
            add_power(&mut terms, [c * t, c], k, 0, member.constant[k]);
            add_power(&mut terms, [1.0, slope], k, 0, member.profile[k]);
            add_power(&mut terms, [c_k * t_k, c_k], k, 0, member.kinematic[k]);
            if k < 3 {
                add_power(&mut terms, [c * t, c], k, 1, member.linear[k]);
            }
        }
        let all = (0..5).flat_map(|i| (0..5).map(move |j| (i, j)));
        let polynomial = Polynomial2::from_terms(all.map(|(i, j)| (i, j, terms[i][j])));
        let p_2 = if other_share { 0.0 } else { member.profile[2] };
        let parts = decompose_diagonal(&polynomial, t, t_k, p_2, slope);
        for k in 0..=80 {
            let (u, y) = (9.0 * (f64::from(k % 9) / 4.0 - 1.0), 20.0 * (f64::from(k / 9) / 4.0 - 1.0));
            let (got, want) = (parts.value(u, y), member.value(u, y));
            prop_assert!((got - want).abs() < 1e-12, "({u}, {y}): {got} {want}");
        }
        // With the member's own share of the profile its curvatures come back too.
        if !other_share {
            prop_assert!((parts.kinematic[2] - member.kinematic[2]).abs() < 1e-14);
            prop_assert!((parts.kinematic[3] - member.kinematic[3]).abs() < 1e-15);
            prop_assert!((parts.profile[3] - member.profile[3]).abs() < 1e-14);
        }
    }
}
