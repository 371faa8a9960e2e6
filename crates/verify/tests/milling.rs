//! The check of the milling file against manipulated files: every number moved, every place damaged, quantities that nobody knows.

use verify::{VerifyOptions, verify_value};

use crate::reference_files::{check, content, moved};
use serde_json::{Value, json};

/// What a case is made of.
const INPUT: [&str; 3] = ["input", "tool", "contact_height_mm"];

/// The file with only what the check of a place needs: its block, and of the cases their input; of the place's own case also the
/// block of the place, of an input the blocks that tell it.
fn part(root: &Value, place: &str) -> Value {
    let at: Vec<&str> = place.split('/').skip(1).collect();
    let own = at.first().copied().unwrap_or_default();
    let mut part = root.clone();
    let top = part.as_object_mut().unwrap();
    // A file of cases alone is not recognised.
    top.retain(|key, _| {
        ["topic", "cases", "linear_axes", own].contains(&key.as_str()) || key == "feed" && of_feed(own)
    });
    let cases = top["cases"].as_object_mut().unwrap();
    let of_case = (own == "cases").then(|| at.get(1).copied()).flatten();
    cases.retain(|name, _| of_case.is_none_or(|of_case| name == of_case));
    let block = of_case.and(at.get(2).copied()).unwrap_or_default();
    // Tolerances of what follows from the drawing stand beside the points.
    let wanted: &[&str] = match block {
        "" => &[],
        _ if INPUT.contains(&block) => &["flank_points", "derived", "lead_range", "columns", "residual"],
        _ => &["flank_points"],
    };
    for case in cases.values_mut() {
        let keep = |key: &str| INPUT.contains(&key) || wanted.contains(&key) || key == block;
        case.as_object_mut().unwrap().retain(|key, _| keep(key));
    }
    part
}

/// Blocks that speak of the row of block `feed`.
fn of_feed(block: &str) -> bool {
    ["output", "screw_row"].contains(&block)
}

/// All places of a value, as JSON pointers.
fn places(value: &Value, pointer: String, found: &mut Vec<String>) {
    match value {
        Value::Object(map) => map.iter().for_each(|(k, v)| places(v, format!("{pointer}/{k}"), found)),
        Value::Array(list) => {
            list.iter().enumerate().for_each(|(k, v)| places(v, format!("{pointer}/{k}"), found));
        }
        _ => {}
    }
    found.push(pointer);
}

/// Of so many numbers or places of a block one is looked at, because a check of the block takes long.
fn stride(place: &str) -> usize {
    match block_of(place) {
        "wear" => 16,
        "full_flank" | "equal_scallop" => 4,
        "density" | "root" => 2,
        _ => 1,
    }
}

fn block_of(place: &str) -> &str {
    place.split('/').nth(1).unwrap_or_default()
}

/// Inputs of a block on which nothing in this file depends if they are changed a little: limits that nothing reaches, heights and
/// corners of straight cutters, starts of searches.
const WITHOUT_WEIGHT: &[(&str, &[&str])] = &[
    ("cases", &["/contact_height_mm", "/rc_mm", "/residual/tilt_mu_rad"]),
    ("density", &["/thresholds/"]),
    ("feed", &["_limit_", "/q1_mm", "/q2_mm"]),
    ("full_flank", &["/contact_height_mm", "/overrun_u_mm"]),
    ("grid_surface", &["/samples/", "/u_from_mm", "/u_to_mm"]),
    ("herringbone", &["/h_mm", "/row_w_mm"]),
    ("internal_cylinder", &["/R_mm", "/h_mm", "/rc_mm"]),
    ("inverse_kinematics", &["/axis/"]),
    ("linear_axes", &["/pivot_to_tip_mm", "/q1_mm", "/q2_mm"]),
    ("shift_invariance", &["/contact_height_", "/u_mm", "/rays/", "/tool/"]),
    ("tool_too_big", &["/rc_mm", "/u", "/value_mm"]),
];

fn has_weight(place: &str) -> bool {
    let own = block_of(place);
    let parts = WITHOUT_WEIGHT.iter().filter(|(block, _)| *block == own).flat_map(|(_, parts)| *parts);
    !place.contains("tolerance") && !parts.into_iter().any(|part| place.contains(part))
}

/// The file's places that are looked at.
fn chosen(root: &Value, wanted: impl Fn(&str) -> bool) -> Vec<String> {
    let mut found = Vec::new();
    places(root, String::new(), &mut found);
    let wanted = found.into_iter().filter(|place| wanted(place)).enumerate();
    wanted.filter(|(k, place)| k % stride(place) == 0).map(|(_, place)| place).collect()
}

#[test]
fn every_changed_number_is_noticed() {
    let root = content("50-milling.json");
    let numbers = chosen(&root, |place| root.pointer(place).unwrap().is_number() && has_weight(place));
    assert!(numbers.len() > 2500, "{}", numbers.len());
    for place in numbers {
        let mut changed = part(&root, &place);
        let value = changed.pointer_mut(&place).unwrap();
        let old = value.as_f64().unwrap();
        // Micrometres have the coarser tolerances.
        let step = if place.contains("_um") { 0.3 } else { 0.03 };
        *value = json!(old + step + 0.01 * old.abs());
        assert!(check(&changed).failed > 0, "a change of {place} went unnoticed");
    }
}

/// A number moved by little more than its tolerance.
#[test]
fn a_small_change_is_noticed_once() {
    let root = content("50-milling.json");
    for (place, step) in [
        ("/cases/spur/derived/rb", 1e-8),
        ("/cases/helical/lead_range/u_min", 1e-7),
        ("/cases/spiral_bevel/flank_points/P_mm/2/1", 1e-8),
        ("/cases/blade/columns/columns/1/tip_mm/3/0", 1e-6),
        ("/cases/straight_bevel/grid_13x9_arc/density/column/max_mm", 1e-5),
        ("/cases/internal/residual/result/1/measured_max_um", 0.05),
        ("/cases/blade/residual/result/2/row_distance_mm", 2e-5),
        ("/spur_exact_stock/stock_um/10", 1e-5),
        ("/helical_zero_eps_lead_radius/r0_mm", 1e-7),
        ("/tool_too_big/clearance_opposite_mm", 1e-4),
        ("/root/items/6/swept_fillet_max_dev_um", 0.2),
        ("/root/items/0/clearance_opposite_lower_bound_mm", 0.01),
        ("/wear/h_limit_opposite_mm/11", 1e-3),
        ("/wear/hist_ramp_m_per_mm/5", 1e-8),
        ("/inverse_kinematics/items/3/solutions_deg/1/0", 1e-7),
        ("/linear_axes/items/2/XYZ_mm/1", 1e-8),
        ("/orientation_comparison/items/3/result/column/lean_min_max_deg/1", 2e-6),
        ("/orientation_comparison/items/4/result/cad/max_acc_deg_per_mm2/0", 1e-6),
        ("/orientation_comparison/items/0/result/iso/travel_deg/0", 2e-6),
        ("/orientation_comparison/items/2/result/cad/reversals", 1.0),
        ("/pole/near_pole/CA_deg/5/0", 1e-5),
        ("/density/items/0/columns", 1.0),
        ("/screw_row/max_tip_deviation_single_block_rtcp_off_mm", 2e-9),
        ("/feed/CA_deg/3/0", 2e-7),
        ("/feed/tip_feed_mm_per_min/2", 2e-4),
        ("/feed/tip_error_without_rtcp_mid_block_mm/1/1", 2e-7),
        ("/octoid/items/0/normal_difference_um", 0.05),
        ("/herringbone/items/0/z_limit_mm", 0.021),
        ("/herringbone/items/1/z_limit_mm", -0.021),
        ("/full_flank/items/1/result/rms_um", 0.05),
        ("/shift_invariance/items/1/largest_change_um", 0.05),
        ("/equal_scallop/stock_max_um/3", 0.02),
        ("/grid_surface/items/2/max_normal_error_um", 0.02),
        ("/internal_cylinder/min_stock_um", 0.1),
        ("/blade_limits/items/4/R_ball_max_mm", 0.01),
        ("/shear_scan/items/2/travel_deg/1", 2e-6),
    ] {
        assert_eq!(check(&moved(&part(&root, place), place, step)).failed, 1, "{place}");
    }
}

#[test]
fn changed_words_and_unknown_quantities_are_noticed() {
    let root = content("50-milling.json");
    for (place, word) in [
        ("/tool_too_big/expected_error", "E_TOOL_SHORT"),
        ("/feed/limited_by/4", "C"),
        ("/output/cl/2", "GOTO/2.96055,73.25635,-4.83138,0.4103984,0.8976019,0.1608851"),
        ("/output/nc_traori/0", "N10 G1 X5.2022 Y73.1313 Z-9.8314 A3=0.437690 B3=0.884615 C3=0.160884"),
        ("/output/nc_rtcp_off/1", "N20 G93 G1 X-27.7686 Y-31.1961 Z23.8348 C25.44799 A80.74173 F434.176"),
        ("/output/of", "another row"),
        ("/screw_row/of", "another row"),
        ("/herringbone/case", "helical"),
        ("/orientation_comparison/items/0/mount", "upside down"),
        ("/orientation_comparison/items/0/chain", "XYZ"),
        ("/shear_scan/case", "nothing"),
    ] {
        let mut changed = part(&root, place);
        *changed.pointer_mut(place).unwrap() = json!(word);
        assert!(check(&changed).failed > 0, "{place}");
    }
    for place in [
        "/cases/spur",
        "/cases/blade/residual/result/0",
        "/root/items/1",
        "/wear",
        "/density/items/2/measured",
        "/orientation_comparison/items/1/result/iso",
        "/herringbone/items/1",
        "/feed",
        "/screw_row",
        "/output",
        "/shear_scan/items/0",
    ] {
        let mut changed = part(&root, place);
        changed.pointer_mut(place).unwrap()["colour"] = json!(1.0);
        let report = check(&changed);
        assert_eq!(report.failed, 1, "{place}");
        assert!(report.failures[0].quantity.contains("unknown quantity"), "{:?}", report.failures[0]);
    }
    let mut changed = part(&root, "/cases/helical/input");
    changed["cases"]["helical"]["input"]["beta_deg"] = json!(25.01);
    assert!(check(&changed).failed > 100);
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
    let root = content("50-milling.json");
    // Of lists the first two: the others are what these are.
    let early = |place: &str| {
        place.split('/').all(|key| key.parse::<usize>().is_err() || key.len() == 1 && key < "2")
    };
    let chosen = chosen(&root, early);
    assert!(chosen.len() > 1000, "{}", chosen.len());
    for (k, place) in chosen.iter().enumerate() {
        let damage = &damages[k % damages.len()];
        let mut damaged = part(&root, place);
        let value = damaged.pointer_mut(place).unwrap();
        let number = value.is_number();
        *value = damage.clone();
        match verify_value("damaged", &damaged, &VerifyOptions::default()) {
            Ok(report) => {
                let expected = number && !damage.is_number();
                assert!(!expected || report.failed > 0, "{place} -> {damage} went unnoticed");
            }
            Err(error) => assert_eq!(error.code(), "unknown-schema"),
        }
    }
}
