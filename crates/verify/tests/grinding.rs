//! The reference files against the library, and the check itself against manipulated files.

use crate::reference_files::{check, content, moved, path};
use serde_json::{Value, json};
use verify::{FileReport, Schema, VerifyError, VerifyOptions, VerifySummary, verify_file, verify_value};

/// Passes without failure and with at least `floor` comparisons, so that an empty check cannot pass.
fn passes(name: &str, floor: usize) -> FileReport {
    let report = verify_file(&path(name), &VerifyOptions::default()).unwrap();
    let failures: Vec<String> = report.failures.iter().take(20).map(|f| format!("{f:?}")).collect();
    assert!(failures.is_empty(), "{name}: {} failures\n{}", report.failed, failures.join("\n"));
    assert!(report.checks >= floor, "{name}: only {} checks", report.checks);
    report
}

#[test]
fn gears_pass_whole() {
    let report = passes("10-gears.json", 1100);
    assert_eq!(report.schema, Schema::Gears);
    assert!(report.worst.as_ref().unwrap().share_of_tolerance < 1.0);
    assert_eq!(VerifySummary::new(vec![report]).exit_code(), 0);
}

#[test]
fn contact_passes() {
    let report = passes("20-generating-contact.json", 5000);
    assert_eq!(report.schema, Schema::Contact);
}

#[test]
fn modifications_pass() {
    let report = passes("25-modifications.json", 4100);
    assert_eq!(report.schema, Schema::Modifications);
}

#[test]
fn planning_passes_whole() {
    let report = passes("28-planning.json", 1150);
    assert_eq!(report.schema, Schema::Planning);
}

#[test]
fn dressing_passes_whole() {
    let report = passes("30-dressing.json", 1400);
    assert_eq!(report.schema, Schema::Dressing);
}

#[test]
fn tangential_dressing_passes_whole() {
    let report = passes("40-tdm.json", 3700);
    assert_eq!(report.schema, Schema::TangentialDressing);
}

#[test]
fn grinding_technology_passes_whole() {
    let report = passes("45-grinding-technology.json", 14900);
    assert_eq!(report.schema, Schema::GrindingTechnology);
}

#[test]
fn gearbox_passes_whole() {
    let report = passes("70-gearbox.json", 3200);
    assert_eq!(report.schema, Schema::Gearbox);
}

#[test]
fn milling_passes_whole() {
    let report = passes("50-milling.json", 2900);
    assert_eq!(report.schema, Schema::Milling);
}

#[test]
fn inspection_passes_whole() {
    let report = passes("85-inspection.json", 3800);
    assert_eq!(report.schema, Schema::Inspection);
}

#[test]
fn files_are_recognised_by_any_of_their_blocks() {
    let shapes = [
        (json!({"errors": content("10-gears.json")["errors"]}), Schema::Gears),
        (json!({"gears": []}), Schema::Contact),
        (json!({"ground_flank": {"cases": []}}), Schema::Contact),
        (json!({"gears": {}}), Schema::Modifications),
        (json!({"machines": {}, "inverse": []}), Schema::MachineChains),
        (json!({"dresser_profile": {}, "left": {}, "right": {}}), Schema::TangentialDressing),
        (json!({"calibration": [], "examples": {}}), Schema::Skiving),
        (json!({"pulse_trains": [], "servo": {}}), Schema::Gearbox),
        (json!({"reader": [], "traces": []}), Schema::Inspection),
    ];
    for (root, schema) in shapes {
        let report = check(&root);
        assert_eq!((report.schema, report.failed), (schema, 0));
        assert_eq!(VerifySummary::new(vec![report]).exit_code(), 0);
    }
}

#[test]
fn absent_data_files_are_not_run_and_no_failure() {
    let report = check(&json!({"reader": [], "real_parts": [{"name": "pinion", "file": "no_such.mka"}]}));
    assert_eq!((report.failed, report.not_run.len()), (0, 1));
    assert!(report.not_run[0].reason.contains("no_such.mka"));
}

/// Every number under `pointer`'s expected object, moved by more than its tolerance, must be noticed.
/// `immaterial` names inputs among them on which nothing depends in this case.
fn notices_every_number(root: &Value, pointer: &str, immaterial: &[&str]) {
    let base = check(root).failed;
    let mut paths = Vec::new();
    numbers_below(root.pointer(pointer).unwrap(), pointer, &mut paths);
    assert!(paths.len() > 10);
    for path in paths {
        if path.contains("/tolerance/") || immaterial.iter().any(|end| path.ends_with(end)) {
            continue;
        }
        let mut changed = root.clone();
        let value = changed.pointer_mut(&path).unwrap();
        let old = value.as_f64().unwrap();
        *value = json!(old + 0.013 + 0.01 * old.abs());
        let report = check(&changed);
        assert!(report.failed > base, "a change of {path} went unnoticed");
    }
}

fn numbers_below(value: &Value, pointer: &str, paths: &mut Vec<String>) {
    match value {
        Value::Object(map) => {
            map.iter().for_each(|(k, v)| numbers_below(v, &format!("{pointer}/{k}"), paths))
        }
        Value::Array(list) => {
            list.iter().enumerate().for_each(|(k, v)| numbers_below(v, &format!("{pointer}/{k}"), paths));
        }
        Value::Number(_) => paths.push(pointer.into()),
        _ => {}
    }
}

#[test]
fn every_changed_number_of_a_gear_is_noticed() {
    let mut root = content("10-gears.json");
    root["cases"].as_array_mut().unwrap().truncate(1);
    // Rack heights and thicknesses of a cylindrical gear are the same in every section.
    notices_every_number(&root, "/cases/0/expected", &["/z_mm"]);
}

#[test]
fn every_changed_number_of_a_contact_case_is_noticed() {
    let mut root = content("20-generating-contact.json");
    root["cases"].as_array_mut().unwrap().truncate(1);
    root["ground_flank"]["cases"] = json!([]);
    for flank in ["left", "right"] {
        let step = &mut root["cases"][0]["expected"][flank]["step_error"];
        step.as_object_mut().unwrap().retain(|key, _| !key.ends_with("simulated_um"));
        // The line functions are inputs whose curvature shifts the second order by less than its tolerance.
        root["cases"][0]["expected"][flank].as_object_mut().unwrap().remove("modification");
    }
    // The ratio does not enter the curvature of a cylindrical pair.
    notices_every_number(&root, "/cases/0/expected", &["step_error/K_ZV1"]);
    notices_every_number(&root, "/cases/0/input", &[]);
}

#[test]
fn every_changed_number_of_equal_ratios_is_noticed() {
    let root = content("20-generating-contact.json");
    let equal = json!({"equal_diagonal_ratio": root["equal_diagonal_ratio"], "tolerance": root["tolerance"]});
    assert_eq!(check(&equal).failed, 0);
    notices_every_number(&equal, "/equal_diagonal_ratio/0/expected", &[]);
    // The limit of the search may be any that holds the root; of the hand only the sign counts, and ratios do not
    // feel the profile shift.
    notices_every_number(
        &equal,
        "/equal_diagonal_ratio/3/input",
        &["/search_limit_deg", "/z_1", "/hand", "/work/x"],
    );
    // A case without a root must not expect a ratio.
    let mut changed = equal.clone();
    changed["equal_diagonal_ratio"][5]["expected"]["K_ZV1"] = json!(1.0);
    assert_eq!(check(&changed).failed, 1);
    changed = equal.clone();
    changed["equal_diagonal_ratio"][5]["expected"]["theta_1_deg"] = json!([1.0]);
    assert_eq!(check(&changed).failed, 1);
    changed = equal;
    changed["equal_diagonal_ratio"][0]["input"]["search_limit_deg"] = json!(3.0);
    assert!(check(&changed).failed > 0);
}

#[test]
fn every_changed_number_of_a_decomposition_by_least_squares_is_noticed() {
    let root = content("25-modifications.json");
    // The smallest case, in the norm of the largest residual.
    let case = json!({"gears": root["gears"], "least_squares": [root["least_squares"][4]]});
    notices_every_number(&case, "/least_squares/0", &[]);
    // The two ratios between which the best one lies.
    let mut flanks = json!({"gears": root["gears"], "two_flanks": root["two_flanks"]});
    for key in ["K_scan", "scan"] {
        let list = flanks["two_flanks"][key].as_array_mut().unwrap();
        *list = list[6..8].to_vec();
    }
    notices_every_number(&flanks, "/two_flanks", &[]);
}

#[test]
fn a_changed_ground_flank_is_noticed() {
    let root = content("20-generating-contact.json");
    for quantity in
        ["f_n2_ray_um", "f_n2_arc_um", "w_1_mm", "z_V2_mm", "determinant_ratio", "d_f_d_gamma_mm_per_rad"]
    {
        let mut changed = json!({"ground_flank": root["ground_flank"]});
        let value = &mut changed["ground_flank"]["cases"][1]["expected"]["right"][quantity][7];
        *value = json!(value.as_f64().unwrap() + 1e-4);
        assert_eq!(check(&changed).failed, 1, "{quantity}");
    }
    let mut changed = json!({"ground_flank": root["ground_flank"]});
    changed["ground_flank"]["cases"][0]["input"]["left"]["Delta_d"]["coefficients"][2] = json!(-0.14);
    let report = check(&changed);
    assert!(report.failed > 50 && report.failures.iter().all(|f| f.case == "ground_flank radial_crowning"));
}

/// The first dressing case with one of its blocks alone.
fn with_block(root: &Value, block: &str) -> Value {
    let mut one = root.clone();
    let case = one["cases"][0].as_object_mut().unwrap();
    case.retain(|key, _| ["input", "worm", block].contains(&key.as_str()));
    one
}

#[test]
fn every_changed_number_of_a_dressing_case_is_noticed() {
    let mut root = content("30-dressing.json");
    root["cases"].as_array_mut().unwrap().truncate(1);
    for key in ["profile", "three_point"] {
        root["cases"][0][key].as_array_mut().unwrap().truncate(2);
    }
    // The blocks that follow paths have a test of their own.
    for key in ["limits", "compensation"] {
        root["cases"][0].as_object_mut().unwrap().remove(key);
    }
    // Clearances hardly feel some hundredths of a micrometre of crowning: a larger change is below.
    let later = ["/check_simulation_max_diff_um", "/undermining/c_alpha_V_um"];
    for block in ["worm", "dresser", "profile", "three_point", "topological", "undermining"] {
        notices_every_number(&with_block(&root, block), &format!("/cases/0/{block}"), &later);
    }
    for (pointer, step) in [
        ("/cases/0/nominal_kinematics/gamma_A_deg", 1e-6),
        ("/cases/0/nominal_kinematics/d_mm", 1e-6),
        ("/cases/0/conditions/0/DK/d_gamma_deg", 1e-5),
        ("/cases/0/conditions/4/f_right_um/3", 1e-4),
        ("/cases/0/conditions/5/head_radius_mm", 1e-6),
        ("/cases/0/conditions/6/reached_fraction", 0.02),
        ("/cases/0/conditioning/sigma_four_point/2", 1e-6),
        ("/cases/0/parallel_axes/rho_deg", 1e-4),
        ("/cases/0/left_out_threads/max_tip_width_mm/0", 0.004),
        ("/cases/0/left_out_threads/max_tip_width_mm/1", 0.004),
        ("/cases/0/left_out_threads/c_alpha_V_um", 0.5),
        ("/cases/0/multi_stroke/strokes/0/DK/d_phi_S_deg", 1e-5),
        ("/cases/0/multi_stroke/strokes/2/DK/d_v_yA_mm", 2e-5),
        ("/cases/0/multi_stroke/w_mm/3", 1e-4),
        ("/cases/0/multi_stroke/f_um/24", 2e-5),
        ("/cases/0/multi_stroke/max_deviation_um", 3e-5),
        ("/cases/0/axis_deviation/f_left_um/0", 2e-6),
        ("/cases/0/axis_deviation/f_right_um/14", 2e-6),
        ("/cases/0/axis_deviation/recovered/d_gamma_deg", 1e-7),
        ("/cases/0/axis_deviation/sigma_for_noise_0p1um/d_d_mm", 1e-7),
    ] {
        assert_eq!(check(&moved(&root, pointer, step)).failed, 1, "{pointer}");
    }
    // All planes of one flank feel the crowning.
    let mut changed = root.clone();
    changed["cases"][0]["undermining"]["c_alpha_V_um"] = json!(1.5);
    assert!(check(&changed).failed >= 3);
    let mut changed = root.clone();
    let crowning = &mut changed["cases"][0]["undermining"]["c_alpha_V_um"];
    *crowning = json!(crowning.as_f64().unwrap() + 0.5);
    let report = check(&changed);
    assert!(report.failed > 0 && report.failures.iter().all(|f| f.quantity.contains("undermining")));
    let mut changed = root.clone();
    changed["cases"][0]["conditions"][6]["error"] = json!("Singular");
    assert_eq!(check(&changed).failed, 1);
    let mut changed = root.clone();
    changed["cases"][0]["multi_stroke"]["strokes"][1]["error"] = json!("NoZero");
    assert!(check(&changed).failed >= 1);
    let mut changed = root;
    changed["cases"][0]["profile"][0]["noise_um"] = json!(1.0);
    assert_eq!(check(&changed).failed, 1);
}

#[test]
fn changed_ranges_and_compensations_are_noticed() {
    let mut root = content("30-dressing.json");
    root["cases"].as_array_mut().unwrap().truncate(1);
    notices_every_number(&with_block(&root, "compensation"), "/cases/0/compensation", &[]);
    let limits = with_block(&root, "limits");
    assert_eq!(check(&limits).failed, 0);
    for (quantity, step) in [
        ("min/c_alpha_V_um", 0.02),
        ("max/c_alpha_V_um", 0.1),
        ("min/with_tip_land_1mm_c_um", 0.04),
        ("max/with_tip_land_1mm_c_um", 0.05),
    ] {
        assert_eq!(
            check(&moved(&limits, &format!("/cases/0/limits/{quantity}"), step)).failed,
            1,
            "{quantity}"
        );
    }
    let mut changed = limits;
    for (end, key) in [("min", "reason"), ("max", "reason"), ("max", "with_tip_reason")] {
        changed["cases"][0]["limits"][end][key] = json!("axis_limit");
    }
    assert_eq!(check(&changed).failed, 3);
}

#[test]
fn every_changed_number_of_other_worms_is_noticed() {
    let whole = content("30-dressing.json");
    let case = &whole["cases"][0];
    let small = json!({"topic": whole["topic"], "spec": whole["spec"], "cases": [
        {"input": case["input"], "other_diameter": case["other_diameter"], "search": case["search"]}
    ]});
    notices_every_number(&small, "/cases/0/other_diameter", &[]);
    // These limits are never the nearest one, nor met.
    let immaterial = ["/limits/d_d_mm", "/limits/tip_land_min_mm"];
    notices_every_number(&small, "/cases/0/search", &immaterial);
    for (pointer, value) in [
        ("/cases/0/search/ranking/5/tip_width", json!(1.0)),
        ("/cases/0/search/ranking/4/ok", json!(true)),
        ("/cases/0/search/ranking/0/worm", json!(0)),
        ("/cases/0/search/limits/tip_land_min_mm", json!(2.6)),
        ("/cases/0/other_diameter/0/alpha_nS_for_P0_deg", json!(null)),
    ] {
        let mut changed = small.clone();
        *changed.pointer_mut(pointer).unwrap() = value;
        assert!(check(&changed).failed > 0, "{pointer}");
    }
}

/// The tangential file with some of its blocks, shortened so that a check is quick.
fn tangential(blocks: &[&str]) -> Value {
    let mut root = content("40-tdm.json");
    let common = ["topic", "units", "input", "tolerance", "grid"];
    root.as_object_mut()
        .unwrap()
        .retain(|key, _| common.contains(&key.as_str()) || blocks.contains(&key.as_str()));
    let retain = |value: &mut Value, keys: &[&str]| {
        value.as_object_mut().unwrap().retain(|key, _| keys.contains(&key.as_str()));
    };
    for side in blocks.iter().filter(|block| ["left", "right"].contains(*block)) {
        let side = &mut root[*side];
        retain(&mut side["sensitivity_per_mm_or_rad"], &["gA0", "gam0", "FC2"]);
        retain(&mut side["table3_linear_um"], &["v5_Fz3"]);
        retain(&mut side["table3_finite_um"], &["v9_FC3"]);
        side["forward"].as_array_mut().unwrap().remove(0);
    }
    if blocks.contains(&"two_flank_same_motions") {
        retain(&mut root["two_flank_same_motions"], &["C10_radial_pair"]);
        let target = root["examples"]["ex1_C10"]["target_mm"].clone();
        root["examples"] = json!({"ex1_C10": {"flank": -1, "target_mm": target}});
    } else if blocks.contains(&"examples") {
        retain(&mut root["examples"], &["ex1_C100"]);
        retain(&mut root["examples"]["ex1_C100"], &["flank", "target_mm", "paper9", "small_set_kappa0"]);
    }
    assert_eq!(check(&root).failed, 0);
    root
}

#[test]
fn every_changed_number_of_tangential_dressing_is_noticed() {
    // How two sources agreed and how long the file's fit took; the other flank's side of the dresser.
    let immaterial = ["/brute_minus_kernel_max_um", "/iterations", "/left/forward/0/variables/FpR1"];
    notices_every_number(&tangential(&["machine", "left"]), "/input", &[]);
    for block in ["machine", "grid", "dresser_profile", "left", "right", "twist_conventional", "examples"] {
        notices_every_number(&tangential(&[block]), &format!("/{block}"), &immaterial);
    }
    let shared = tangential(&["examples", "two_flank_same_motions"]);
    notices_every_number(&shared, "/two_flank_same_motions", &[]);
}

#[test]
fn changed_words_and_gaps_of_tangential_dressing_are_noticed() {
    let fails = |blocks: &[&str], pointer: &str, value: Value| {
        let mut changed = tangential(blocks);
        *changed.pointer_mut(pointer).unwrap() = value;
        assert!(check(&changed).failed > 0, "{pointer}");
    };
    fails(&["machine"], "/input/hand1", json!("right"));
    fails(&["grid"], "/grid/order", json!("[iZ][iR]"));
    // Undercut where there is none, and none where there is.
    fails(&["right"], "/right/table3_finite_um/v9_FC3/2/2", json!(null));
    fails(&["right"], "/right/table3_finite_um/v9_FC3/0/0", json!(-94.0));
    fails(&["undercut"], "/undercut/0/error", json!("OutsideTool"));
    fails(&["undercut"], "/undercut/0/variables/Fp3", json!(-0.005));
    fails(&["undercut"], "/undercut/1/Z", json!(0.0));
    fails(&["undercut"], "/undercut/1/flank", json!("left"));
    let first = "/twist_conventional/cases/2/error";
    fails(&["twist_conventional"], first, json!("Undercut: undercut or no contact: 2 of 25 points"));
    fails(&["examples"], "/examples/ex1_C100/paper9/variables", json!({"Fq1": 0.0}));
    fails(&["examples"], "/examples/ex1_C100/paper9/rank_first", json!(9));
    fails(&["examples"], "/examples/ex1_C100/target_mm", json!({"r2": 0.005, "z2": 0.1, "z9": 0.0}));
    for (blocks, place) in [
        (&["left"][..], "/left"),
        (&["left"], "/left/forward/0"),
        (&["machine"], "/machine"),
        (&["grid"], "/grid"),
        (&["undercut"], "/undercut/0"),
        (&["twist_conventional"], "/twist_conventional/cases/0"),
        (&["examples"], "/examples/ex1_C100/paper9"),
        (&["examples", "two_flank_same_motions"], "/two_flank_same_motions/C10_radial_pair"),
    ] {
        let mut changed = tangential(blocks);
        changed.pointer_mut(place).unwrap()["roughness_um"] = json!(0.1);
        assert_eq!(check(&changed).failed, 1, "{place}");
    }
    // Residuals that no fit reaches.
    for (key, value) in [("max_41x41_um", 0.05), ("rms_41x41_um", 0.01)] {
        let mut changed = tangential(&["examples", "two_flank_same_motions"]);
        changed["two_flank_same_motions"]["C10_radial_pair"][key] = json!(value);
        let report = check(&changed);
        assert!(report.failures.iter().any(|f| f.quantity == format!("{key} of a fit")), "{report:?}");
    }
}

#[test]
fn a_changed_plan_is_noticed() {
    let mut root = content("28-planning.json");
    root["cases"].as_array_mut().unwrap().truncate(1);
    let expected = "/cases/0/expected";
    for (pointer, step) in [
        ("/K_star_right", 1e-6),
        ("/K_rho_2_zero_left", 1e-6),
        ("/z_V01_mm", 0.1),
        ("/worm_length_mm", 0.1),
        ("/candidates/0/worm_length_mm", 0.1),
        ("/candidates/0/dressing_share", 0.01),
        ("/Delta_d_um/4", 0.2),
        ("/Delta_phi_2_urad/4", 5.0),
        ("/left/tan_rho_1", 1e-6),
        ("/left/f_n1_um/20", 0.1),
        ("/right/DK_phi_S_deg/3", 0.02),
        ("/right/DK_v_y_mm/3", 0.1),
        ("/right/target_f_n_um/17", 1e-6),
        ("/left/simulated_f_n_um/17", 0.1),
        ("/left/max_error_um", -0.1),
        ("/left/rms_error_um", -0.1),
        ("/left/dressed_worm_minus_plan_um", -0.1),
        ("/left/ideal_worm_error_by_round_um/2", -0.1),
        ("/left/least_determinant_ratio", 0.1),
        ("/left/w_1_mm/0", 0.5),
        ("/right/z_1_mm/8", 0.5),
        ("/right/v_zS_mm/0", 0.5),
        ("/z_V2_mm/0", 0.5),
    ] {
        assert!(check(&moved(&root, &format!("{expected}{pointer}"), step)).failed > 0, "{pointer}");
    }
    for (key, value) in [("d_mm", json!(136.3)), ("gamma_deg", json!(121.9)), ("d_A0_mm", json!(153.0))] {
        let mut changed = root.clone();
        changed["cases"][0]["input"][key] = value;
        assert_eq!(check(&changed).failed, 1, "{key}");
    }
    root["cases"][0]["expected"]["left"]["roughness_um"] = json!(0.1);
    assert_eq!(check(&root).failed, 1);
}

/// Another ratio than the listed one is no failure where the rule leaves freedom: it must then be as good.
#[test]
fn a_plan_is_judged_by_its_score_and_error() {
    let mut root = content("28-planning.json");
    root["cases"].as_array_mut().unwrap().remove(0);
    let mut narrow = root.clone();
    narrow["tolerance"]["K_star_relative"] = json!(0.0);
    let failed = |root: &Value| check(root).failures.into_iter().map(|f| f.quantity).collect::<Vec<_>>();
    assert!(!failed(&narrow).iter().any(|q| q == "K_ZV1"));
    // A listed score that the rule cannot reach.
    root["cases"][0]["expected"]["K_ZV1"] = root["cases"][0]["expected"]["candidates"][0]["K_ZV1"].clone();
    root["cases"][0]["expected"]["candidates"][0]["score"] = json!(0.1);
    assert!(failed(&root).iter().any(|q| q == "score of the K_ZV1 found"), "{:?}", failed(&root));
}

#[test]
fn a_changed_decomposition_is_noticed() {
    let root = content("25-modifications.json");
    for (pointer, step) in [
        ("/decomposition_clpk/3/expected/um_per_mm_power/K12", 1e-7),
        ("/radial_class/1/expected/residual_corner_twist_S_um", 1e-6),
        ("/radial_class/1/expected/residual_um_per_mm_power/u2y1", 1e-8),
        ("/polynomial/5/expected/K_um_per_mm_power/K21", 1e-8),
        ("/polynomial/7/expected/rho_F2_deg", 1e-6),
        ("/polynomial/2/input/K_KF0_um", 1e-6),
        ("/polynomial/7/ground/second_order_f_n_um/11", 1e-3),
        ("/polynomial/7/ground/max_error_local_envelope_um", 1e-3),
        ("/precompensation/1/commanded_um_per_mm_power/w1z1", 1e-3),
        ("/precompensation/2/ground_error_um_by_iteration/1", 0.1),
        ("/natural_twist/1/expected/q_at_w_m_mm", 1e-5),
        ("/natural_twist/3/expected/ground_twist_um", 1e-3),
        ("/two_flank_motion/1/Delta_phi_2_urad/2", 1e-6),
        ("/two_flank_motion/1/phase_difference_pitches", 1e-6),
        ("/waviness/F_FtQ_um_per_mm2/3", 1e-6),
        ("/figure_29_31/worm_part_f_t_um/40", 1e-6),
        ("/figure_29_31/X_F2_start_of_relief_mm", 1e-6),
    ] {
        assert_eq!(check(&moved(&root, pointer, step)).failed, 1, "{pointer}");
    }
}

#[test]
fn a_changed_area_figure_or_stroke_is_noticed() {
    let root = content("25-modifications.json");
    for (pointer, step, failures) in [
        ("/equal_swivel/K_ZV1", 1e-7, 1),
        ("/equal_swivel/rate_right", 1e-10, 1),
        ("/figure_25/expected/z_V1_mm/3", 1e-5, 1),
        ("/figure_25/expected/diagonal_ratio/7", 1e-3, 1),
        ("/figure_25/expected/curves/2/z_mm/4", 1e-5, 1),
        ("/figure_25/expected/ground_f_n_um/30", 0.01, 1),
        ("/figure_25/input/sigma", 2.0, 1),
        ("/figure_26_28/expected/curves/1/shift_z_mm", 1e-5, 1),
        ("/figure_26_28/expected/diagonal_ratio_closed_form_at_w_m", 1e-3, 1),
        ("/figure_26_28/expected/X_F1_mm/17", 1e-5, 1),
        ("/figure_26_28/expected/f_t2_first_order_um/6", 1e-5, 1),
        ("/figure_26_28/expected/ground_f_n_um/6", 0.01, 1),
        ("/figure_26_28/expected/worm_functions/2/F_Ft1C_um", 1e-5, 1),
        ("/figure_26_28/measured/err_first_order_um", 0.01, 1),
        ("/areas/0/expected/intervals/1/K_ZV1", 1e-6, 1),
        ("/areas/1/expected/z_V1_nodes_mm/2", 1e-6, 1),
        ("/areas/1/expected/segments/1/K_ZV1", 1e-6, 1),
        ("/areas/2/expected/worm_z1_range_mm/right/0", 1e-6, 1),
        ("/areas/2/expected/pitch_of_areas_mm", 1e-6, 1),
        ("/areas/2/expected/number_of_areas", 1.0, 1),
        ("/areas/3/expected/conflict/0/1", 1.0, 1),
        ("/areas/4/expected/exclusivity_violations/2/overlap_mm", 1e-6, 1),
        ("/left_out_threads/3/expected/strokes_per_pass", 1.0, 1),
        ("/left_out_threads/7/expected/index_pitches/1", 1.0, 1),
        ("/left_out_threads/5/expected/feed_factor", 1e-9, 1),
    ] {
        assert_eq!(check(&moved(&root, pointer, step)).failed, failures, "{pointer}");
    }
    // A refusal that did not happen, one that did and is not expected, an area too few.
    let mut changed = root.clone();
    changed["areas"][0]["expected"]["error"] = json!("AreasOverlap");
    assert_eq!(check(&changed).failed, 1);
    let mut changed = root.clone();
    changed["areas"][4]["expected"].as_object_mut().unwrap().remove("error");
    assert_eq!(check(&changed).failed, 1);
    let mut changed = root;
    changed["areas"][0]["expected"]["intervals"].as_array_mut().unwrap().pop();
    assert_eq!(check(&changed).failed, 1);
}

#[test]
fn unknown_quantities_keys_and_blocks_fail() {
    let root = content("10-gears.json");
    let fails_with = |root: &Value, text: &str| {
        let report = check(root);
        assert_eq!(report.failed, 1, "{text}");
        assert!(report.failures[0].quantity.contains(text), "{:?}", report.failures[0]);
    };
    let mut changed = root.clone();
    changed["cases"][2]["expected"]["left"]["tooth_colour"] = json!(3.0);
    fails_with(&changed, "unknown quantity left.tooth_colour");
    let mut changed = root.clone();
    changed["cases"][2]["expected"]["points"][1]["torsion"] = json!(3.0);
    fails_with(&changed, "unknown quantity points[1].torsion");
    let mut changed = root.clone();
    changed["cases"][2]["more"] = json!({});
    fails_with(&changed, "unknown quantity more");
    let mut changed = root.clone();
    changed["gear_pairs"] = json!([]);
    fails_with(&changed, "unknown block gear_pairs");
    let mut changed = root.clone();
    changed["cases"][2]["input"]["backlash"] = json!(0.1);
    assert!(check(&changed).failed >= 1);
    let mut changed = content("20-generating-contact.json");
    changed["ground_flank"]["cases"][0]["expected"]["left"]["roughness"] = json!([1.0]);
    fails_with(&changed, "unknown quantity left.roughness");
}

#[test]
fn missing_tolerances_and_null_values_fail() {
    let mut root = content("10-gears.json");
    root["tolerance"].as_object_mut().unwrap().remove("f_n_um");
    let report = check(&root);
    assert_eq!(report.failed, 48); // six deviations in each of eight cases
    let mut root = content("10-gears.json");
    root["cases"][0]["expected"]["r_w_mm"] = Value::Null;
    assert_eq!(check(&root).failed, 1);
}

#[test]
fn an_accepted_impossible_body_fails() {
    let mut root = content("10-gears.json");
    root["errors"][1]["input"]["m_n_mm"] = json!(2.0);
    let report = check(&root);
    assert_eq!((report.failed, &report.failures[0].actual), (1, &Value::Null));
    root["cases"][0]["input"]["m_n_mm"] = json!(-1.0);
    let report = check(&root);
    assert!(report.failures.iter().any(|f| f.actual.as_str().is_some_and(|t| t.contains("normal_module"))));
}

#[test]
fn optional_gears_of_a_contact_file_are_checked() {
    let gears = content("10-gears.json");
    let mut root = content("20-generating-contact.json");
    root["gears"] = gears["cases"].clone();
    root["gears_tolerance"] = gears["tolerance"].clone();
    let without = check(&content("20-generating-contact.json"));
    let with = check(&root);
    assert_eq!(with.failed, 0);
    assert!(with.checks > without.checks + 1000);
}

#[test]
fn unknown_content_is_a_clear_error() {
    let options = VerifyOptions::default();
    for root in [json!({}), json!([1, 2]), json!({"job": {"name": "x"}}), json!({"cases": []})] {
        let error = verify_value("x.json", &root, &options).unwrap_err();
        assert_eq!(error.code(), "unknown-schema");
        assert!(error.to_string().contains("x.json") && !error.way_out().is_empty());
    }
    let error = verify_file(&path("absent.json"), &options).unwrap_err();
    assert!(matches!(&error, VerifyError::Unreadable { file, .. } if file.ends_with("absent.json")));
    let broken = std::env::temp_dir().join(format!("flankwright-verify-{}.json", std::process::id()));
    std::fs::write(&broken, "{\n \"cases\": [,]}").unwrap();
    let error = verify_file(&broken, &options).unwrap_err();
    std::fs::remove_file(&broken).unwrap();
    assert!(matches!(error, VerifyError::NotJson { line: 2, .. }), "{error}");
}

#[test]
fn the_json_has_the_fields_of_the_contract() {
    let summary = VerifySummary::new(vec![passes("10-gears.json", 1)]);
    let json = serde_json::to_value(&summary).unwrap();
    let file = &json["files"][0];
    for key in ["file", "schema", "checks", "failed", "failures", "not_run", "worst"] {
        assert!(file.get(key).is_some(), "{key}");
    }
    assert_eq!((&file["schema"], &json["failed"]), (&json!("10-gears"), &json!(0)));
    assert!(file["worst"]["share_of_tolerance"].as_f64().is_some());
    let mut root = content("10-gears.json");
    root["cases"][0]["expected"]["r_w_mm"] = json!(1.0);
    let failure = serde_json::to_value(check(&root)).unwrap()["failures"][0].clone();
    for key in ["case", "quantity", "expected", "actual", "difference", "tolerance"] {
        assert!(!failure[key].is_null(), "{key}");
    }
}

/// All places of a value, as JSON pointers.
fn places(value: &Value, pointer: String, found: &mut Vec<String>) {
    match value {
        Value::Object(map) => map.iter().for_each(|(k, v)| places(v, format!("{pointer}/{k}"), found)),
        Value::Array(list) => {
            list.iter().enumerate().for_each(|(k, v)| places(v, format!("{pointer}/{k}"), found))
        }
        _ => {}
    }
    found.push(pointer);
}

/// The tangential file with the block of a place, or with what is quick where the place concerns all of them.
fn with_tangential_block(whole: &Value, place: &str) -> Value {
    let own = place.split('/').nth(1).unwrap_or_default();
    let common = ["topic", "units", "input", "tolerance", "grid"];
    let quick = ["machine", "dresser_profile", "undercut"];
    let mut root = whole.clone();
    root.as_object_mut().unwrap().retain(|key, _| {
        let key = key.as_str();
        key == own
            || common.contains(&key)
            || (common.contains(&own) || own.is_empty()) && quick.contains(&key)
    });
    root
}

/// One case of every block, so that a check is quick.
fn shortened(name: &str) -> Value {
    let mut root = content(name);
    let first = |list: &mut Value, n: usize| list.as_array_mut().unwrap().truncate(n);
    match name {
        "10-gears.json" => first(&mut root["cases"], 1),
        "20-generating-contact.json" => {
            first(&mut root["cases"], 1);
            first(&mut root["ground_flank"]["cases"], 2);
            first(&mut root["equal_diagonal_ratio"], 1);
        }
        "30-dressing.json" => {
            first(&mut root["cases"], 1);
            for key in ["profile", "three_point", "conditions"] {
                first(&mut root["cases"][0][key], 2);
            }
        }
        "40-tdm.json" => {
            let blocks = ["machine", "dresser_profile", "left", "undercut", "twist_conventional", "examples"];
            root = tangential(&blocks);
            first(&mut root["twist_conventional"]["cases"], 3);
            root["examples"]["ex1_C100"].as_object_mut().unwrap().remove("small_set_kappa0");
        }
        _ => {
            let one_each = [
                "mapping",
                "constant_ratio_lengths",
                "decomposition_clpk",
                "radial_class",
                "polynomial",
                "precompensation",
                "natural_twist",
                "two_flank_motion",
            ];
            root.as_object_mut().unwrap().retain(|key, _| {
                ["gears", "elementary", "waviness"].contains(&key.as_str())
                    || one_each.contains(&key.as_str())
            });
            for key in one_each {
                first(&mut root[key], 1);
            }
            first(&mut root["elementary"]["items"], 3);
        }
    }
    root
}

#[test]
fn damaged_files_end_in_a_report_or_an_error() {
    let damages = [
        json!(null),
        json!("x"),
        json!(-1),
        json!(0),
        json!(1e300),
        json!(-1e-300),
        json!([]),
        json!({}),
        json!([[1e9]]),
    ];
    for name in [
        "10-gears.json",
        "20-generating-contact.json",
        "25-modifications.json",
        "30-dressing.json",
        "40-tdm.json",
    ] {
        let whole = shortened(name);
        assert_eq!(check(&whole).failed, 0);
        let mut found = Vec::new();
        places(&whole, String::new(), &mut found);
        for (k, place) in found.iter().enumerate() {
            // The blocks of a dressing case do not see each other.
            let block = place.strip_prefix("/cases/0/").and_then(|rest| rest.split('/').next());
            let root = match block {
                Some("input") if name == "30-dressing.json" => with_block(&whole, "profile"),
                Some(block) if name == "30-dressing.json" => with_block(&whole, block),
                _ if name == "40-tdm.json" => with_tangential_block(&whole, place),
                _ => whole.clone(),
            };
            for damage in [&damages[k % damages.len()], &damages[(k + 4) % damages.len()]] {
                let mut damaged = root.clone();
                *damaged.pointer_mut(place).unwrap() = damage.clone();
                match verify_value("damaged", &damaged, &VerifyOptions::default()) {
                    Ok(report) => {
                        let number = root.pointer(place).unwrap().is_number();
                        let exempt = place.contains("step_error") && place.ends_with("simulated_um")
                            || place.ends_with("brute_minus_kernel_um")
                            || place.ends_with("brute_minus_kernel_max_um")
                            || place.ends_with("/iterations");
                        let figure = place.contains("/expected/")
                            || name == "40-tdm.json" && !place.starts_with("/tolerance");
                        let expected = figure && number && !damage.is_number() && !exempt;
                        assert!(!expected || report.failed > 0, "{name}{place} -> {damage} went unnoticed");
                    }
                    Err(error) => assert_eq!(error.code(), "unknown-schema"),
                }
            }
        }
    }
}
