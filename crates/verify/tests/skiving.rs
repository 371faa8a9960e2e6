//! The check of the skiving file, whole and manipulated.

use crate::reference_files::{check, content, moved};
use serde_json::{Value, json};

/// The file with one block besides the examples; a file of examples alone is not recognised.
fn part(root: &Value, place: &str) -> Value {
    let own = place.split('/').nth(1).unwrap();
    let kept = ["examples", "calibration", "tolerance", own];
    let mut part = root.clone();
    part.as_object_mut().unwrap().retain(|key, _| kept.contains(&key.as_str()));
    part
}

#[test]
fn the_file_passes_whole() {
    let report = check(&content("60-skiving.json"));
    let failures: Vec<String> = report.failures.iter().take(20).map(|f| format!("{f:?}")).collect();
    assert!(failures.is_empty(), "{} failures\n{}", report.failed, failures.join("\n"));
    assert!(report.checks > 5000, "{}", report.checks);
}

#[test]
fn every_kind_of_quantity_is_compared() {
    let root = content("60-skiving.json");
    for (place, step) in [
        ("/random/first_uniform/1", 1e-15),
        ("/random/first_normal/3", 1e-13),
        ("/examples/int85_tool41/derived/eta_b2_deg", 1e-7),
        ("/examples/ext47_tool75/derived/cutting_sense_omega1", -2.0),
        ("/examples/ext47_tool75/edges/left/3/m/1", 1e-8),
        ("/examples/ext50_tool75_unstepped/edges/right/0/n_m/2", 1e-9),
        ("/examples/ext50_tool75_unstepped/edges/right/4/theta_hi_deg", 1e-6),
        ("/examples/int85_tool41/edges/right/2/sharp_edge_point/0", 1e-8),
        ("/examples/int85_tool41/poses/left/1/tangent/A_deg", 1e-7),
        ("/examples/ext47_tool75/poses/right/2/best/1/Y", 1e-8),
        ("/examples/int85_tool41/poses/left/4/nearest_other_flank_gap_mm", 0.06),
        ("/examples/int85_tool41/sensitivity/left/0/3", 1e-7),
        ("/measurement/0/trigger_angle_rad/left/2/7", 1e-9),
        ("/measurement/1/deviation_f_um/right/4/74", 1e-4),
        ("/measurement/0/first_order_truth_um/left/0/0", 1e-4),
        ("/measurement/0/evaluation/ecc_um/1", 1e-4),
        ("/measurement/1/evaluation/rigid_fit_std_per_unit_noise/2", 1e-5),
        ("/measurement/1/evaluation/teeth_excluded_from_rigid_fit/0", 1.0),
        ("/measurement/0/evaluation/cumulative_pitch_um/40", 1e-4),
        ("/measurement/0/evaluation/compensation_curve_coeff_um/left/2", 1e-4),
        ("/measurement/1/corrections/delta_gamma_deg", 1e-7),
        ("/measurement/0/corrections/singular_values/1", 1e-7),
        ("/measurement/1/noise/first_record_left_track0_sense_plus_rad/12", 1e-8),
        ("/measurement/0/noise/max_error_um", 1e-3),
        ("/measurement/0/noise/mean_difference_minus_plus_um/9", 1e-3),
        ("/measurement/1/band/opposite_flank_B_rad", 1e-9),
        ("/measurement/0/band/opposite_touch_theta_deg", 1e-6),
        ("/mounting_only/1/tilt_found_rad/0", 1e-9),
        ("/mounting_only/0/largest_rest_um", 1e-4),
        ("/conventional_axis_parallel_beam/ext47_tool75/1/growth10um_reported_um", 0.01),
        ("/conventional_axis_parallel_beam/ext47_tool75/7/silhouette_theta_deg", 1e-6),
        ("/calibration/0/found/2", 1e-7),
        ("/calibration/0/std_per_unit_sigma/y_at_Z1mid", 1e-3),
        ("/calibration/0/midpoint_error_Y_um_at_X_offset_0p3mm", 1e-4),
        ("/scan_fixed_Y_vertical_stylus/0/curve/right/rows/4/B_deg", 1e-7),
        ("/scan_fixed_Y_vertical_stylus/0/curve/left/Y", 1e-8),
    ] {
        assert!(check(&moved(&part(&root, place), place, step)).failed > 0, "{place}");
    }
}

#[test]
fn changed_words_and_unknown_quantities_are_noticed() {
    let root = content("60-skiving.json");
    for (place, value) in [
        ("/random/first_u64_hex/0", json!("0635ef3cd5c35878")),
        ("/measurement/0/evaluation/worn/left", json!(true)),
        ("/measurement/0/evaluation/teeth_out_of_band", json!([["left", 1]])),
        ("/conventional_axis_parallel_beam/int85_tool41/0/touch_on_rounding", json!(false)),
        ("/measurement/0/example", json!("nothing")),
        ("/measurement/0/corrections/parameters", json!("d alone")),
        ("/examples/int85_tool41/poses/left/0/nearest_other_flank", json!("same")),
    ] {
        let mut changed = part(&root, place);
        *changed.pointer_mut(place).unwrap() = value;
        assert!(check(&changed).failed > 0, "{place}");
    }
    for place in [
        "/examples/int85_tool41",
        "/examples/int85_tool41/edges/left/0",
        "/measurement/0",
        "/measurement/0/noise",
        "/mounting_only/0",
        "/calibration/1",
        "/scan_fixed_Y_vertical_stylus/0/curve/left",
    ] {
        let mut changed = part(&root, place);
        changed.pointer_mut(place).unwrap()["roughness_um"] = json!(0.1);
        assert!(check(&changed).failed > 0, "{place}");
    }
}
