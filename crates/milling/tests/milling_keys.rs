//! Every key of a milling job counts: another value changes a figure or a text beside the echo of the job and the timings, or the job is
//! refused at the key. The schema says which keys there are; one that no job here gives is missing from the walk and fails it.

use foundation::numerics::Silent;
use job::{Source, parse_job_of, schema_of};
use milling::job::MillingJob;
use milling::workflow::run_milling;
use rayon::prelude::*;
use serde_json::{Value, json};
use std::collections::BTreeSet;

/// Keys that change nothing here, each with the reason; those below one that ends with a point as well.
const EXCEPTIONS: [(&str, &str); 27] = [
    (
        "measuring_grid.",
        "where a measuring machine touches the flanks, which no plan depends on; `inspect` has its tests",
    ),
    ("grid_gear.", "tables of points; `flanks_by_points_are_milled` has each of its keys"),
    ("mate.modifications.", "the same list as that of the target"),
    ("mate.gear.", "the table of the gear, of which the walk shows that it counts, and which has to fit it"),
    ("bevel.spiral.line", "says which keys there are"),
    ("stock.form", "says which keys there are"),
    ("machine.probe.stem_diameter", "counts where the stem touches first, which no space here lets it"),
    (
        "machine.work_offset.clocking",
        "the probe needs it; `a_clocking_angle_turns_the_workpiece_in_the_program_or_on_the_control` has it",
    ),
    ("machine.probe.length_offset", "counts where the control holds lengths"),
    ("job.", "names and comments; the process says which keys there are"),
    ("target.modifications.", "their own keys are walked once for all processes"),
    ("compensation.modifications.", "the same list as that of the target"),
    ("gear.normal_tooth_thickness", "stands for profile_shift, as in every process"),
    ("gear.span.", "stands for profile_shift, as in every process"),
    ("gear.over_balls.", "stands for profile_shift, as in every process"),
    ("gear.normal_pressure_angle_deg.", "both sides of the number that is walked"),
    ("blade.points.", "a table of points; its size must be that of the file, its side is that of ruled"),
    ("cutter.shape", "says which keys there are"),
    ("mate.teeth", "must fit the cone angles, all others are refused"),
    ("machine.spindle_diameter", "walked in `spindles_are_kept_from_the_whole_ring`"),
    ("mate.pitch_cone_angle_deg", "must be what the teeth ask for, all others are refused"),
    ("mate.shaft_angle_deg", "must be what the teeth ask for, all others are refused"),
    ("output.", "which files are written"),
    ("bottom_cutter.", "the keys of [cutter], of which the walk shows that they count"),
    ("roughing_cutter.", "the keys of [cutter], of which the walk shows that they count"),
    ("machine.pole_cap_deg", "counts near a pole only, which no job here comes to"),
    (
        "simulation.compare_orientation",
        "walked in `a_machine_without_wishes_gets_all_its_controls_and_parquet_a_warning`",
    ),
];

fn excepted(key: &str) -> bool {
    let below =
        |name: &str| key == name.trim_end_matches('.') || name.ends_with('.') && key.starts_with(name);
    EXCEPTIONS.iter().any(|(name, _)| below(name))
}

fn leaves(value: &Value, at: &str, all: &mut Vec<String>) {
    match value {
        Value::Object(table) => {
            table.iter().for_each(|(key, value)| leaves(value, &format!("{at}/{key}"), all))
        }
        Value::Array(list) => {
            list.iter().enumerate().for_each(|(k, value)| leaves(value, &format!("{at}/{k}"), all))
        }
        _ => all.push(at.to_owned()),
    }
}

/// A place without its indices, as the schema has it.
fn key(place: &str) -> String {
    place
        .split('/')
        .filter(|part| !part.is_empty() && part.parse::<usize>().is_err())
        .collect::<Vec<_>>()
        .join(".")
}

fn keys_of_schema(schema: &Value, node: &Value, at: &str, keys: &mut BTreeSet<String>) {
    if ["target", "compensation", "mate"].iter().any(|table| at == format!("{table}.modifications")) {
        keys.insert(at.to_owned());
        return;
    }
    if let Some(name) = node["$ref"].as_str() {
        let name = name.rsplit('/').next().unwrap();
        return keys_of_schema(schema, &schema["$defs"][name], at, keys);
    }
    let choices: Vec<&Value> =
        ["oneOf", "anyOf"].iter().filter_map(|list| node[*list].as_array()).flatten().collect();
    choices.iter().for_each(|choice| keys_of_schema(schema, choice, at, keys));
    if node["items"].is_object() {
        return keys_of_schema(schema, &node["items"], at, keys);
    }
    match node["properties"].as_object() {
        Some(table) => table.iter().for_each(|(name, value)| {
            let below = if at.is_empty() { name.clone() } else { format!("{at}.{name}") };
            keys_of_schema(schema, value, &below, keys);
        }),
        None if choices.is_empty() => {
            keys.insert(at.to_owned());
        }
        None => {}
    }
}

/// What a job comes to: result and texts without the echo; `Err` with the field at which it is refused.
fn outcome(job: &Value) -> Result<(Value, Vec<String>), String> {
    // Machines are looked for beside the job.
    let name = format!("{}/../../machines/job.json", env!("CARGO_MANIFEST_DIR"));
    let text = job.to_string();
    let loaded = match parse_job_of::<MillingJob>(Source::new(&*name, &text)) {
        Ok(loaded) => loaded,
        Err(error) => return Err(format!("{:?}", error.diagnostics.first().and_then(|d| d.field.clone()))),
    };
    let made = run_milling(&loaded, &Silent).map_err(|failure| format!("{failure:?}"))?;
    let mut result = serde_json::to_value(&made.result).unwrap();
    let table = result.as_object_mut().unwrap();
    table.retain(|key, _| !["job", "version", "timing_s", "tolerance_um"].contains(&key.as_str()));
    let programs = made.texts.programs.iter().flat_map(|programs| &programs.programs);
    let mut texts: Vec<String> = programs.map(|program| program.written.text.clone()).collect();
    texts.extend(made.texts.cycles.iter().map(|cycle| cycle.text.clone()));
    texts.extend(made.texts.locations.map(|locations| locations.text));
    Ok((result, texts))
}

/// Other values of a leaf.
fn others(key: &str, value: &Value) -> Vec<Value> {
    let words: &[&str] = match key.rsplit('.').next().unwrap() {
        "row_spacing" => &["parameter"],
        "direction" => &["conventional"],
        "traverse" => &["zigzag"],
        "order" => &["root-to-tip"],
        "teeth" => &["all"],
        "flanks" => &["left"],
        "rtcp" => &["on", "rows"],
        "pole" => &["mount"],
        "hand" => &["left"],
        "flank" => &["octoid"],
        "side" => &["right", "lower"],
        "sections" => &["2412"],
        "name" => &["collar"],
        "shape" => &["torus", "cone", "ball"],
        "file" => &["five-axis-bc-table.toml"],
        "coolant" => &["off"],
        "tool_length_in" => &["program"],
        "axis" => &["X"],
        _ => &[],
    };
    // Numbers that decide something.
    let near = match key.rsplit('.').next().unwrap() {
        "row_min" | "row_min_mean" => Some(6.5),
        "column_min" | "column_min_mean" => Some(5.8),
        "from" => Some(12.0),
        _ => None,
    };
    match value {
        Value::Bool(yes) => vec![json!(!yes)],
        Value::Number(number) if number.is_i64() || number.is_u64() => {
            let n = number.as_i64().unwrap();
            vec![json!(n + 1), json!(2 * n), json!(n - 1)]
        }
        Value::Number(number) => {
            let x = number.as_f64().unwrap();
            let all = [x * 1.01, x * 0.3, x * 2.0, x + 0.1, x * 30.0, x * 0.01];
            near.into_iter().chain(all).map(|x| json!(x)).collect()
        }
        _ => words.iter().map(|word| json!(word)).collect(),
    }
}

fn jobs() -> Vec<Value> {
    let info = json!({ "name": "every-key", "process": "five-axis-milling", "description": "each key once" });
    let simulation = json!({ "rays_profile": 3, "rays_length": 3, "compare_orientation": false });
    let gear = json!({ "teeth": 23, "normal_module": 6.0, "normal_pressure_angle_deg": 20.0, "helix_angle_deg": 25.0,
        "profile_shift": 0.0, "cone_angle_deg": 0.0, "face_width": 20.0, "tip_diameter": 164.266, "root_diameter": 137.266, "form_diameter": 143.0 });
    let cutter = json!({ "shape": "end-mill", "diameter": 5.0, "corner_radius": 1.0, "cutting_length": 16.0, "number": 1, "teeth": 4 });
    let milling = |more: Value| {
        let mut milling = json!({ "rows": 3, "columns": 7, "feed_mm_per_min": 1200.0, "spindle_rpm": 8000.0, "teeth": "one" });
        milling.as_object_mut().unwrap().extend(more.as_object().unwrap().clone());
        milling
    };
    let job = |kind: &str, body: &Value, tolerance: f64, cutter: &Value, milling: Value| {
        json!({ "job": info, kind: body, "target": { "tolerance_um": tolerance }, "cutter": cutter, "milling": milling,
            "simulation": simulation })
    };
    let mut whole = job(
        "gear",
        &gear,
        900.0,
        &cutter,
        milling(json!({
        "contact_height": 2.5, "root": { "bottom": 0.0, "bottom_pass": true },
        "roughing": { "allowance": 0.3, "step_down": 3.0, "step_over": 2.0, "feed_mm_per_min": 1000.0 },
        "direction": "climb", "traverse": "one-way", "order": "tip-to-root", "row_spacing": "arc", "skew_deg": 1.0,
        "overrun": 3.5, "safety_distance": 0.2, "plunge_feed_mm_per_min": 400.0, "flanks": "both", "coolant": "mist" })),
    );
    whole["gear"]["evaluation"] =
        json!({ "start_diameter": 143.0, "end_diameter": 160.0, "z_start": -9.0, "z_end": 9.0 });
    whole["gear"]["allowances_um"] = json!({ "lower": -60.0, "upper": -20.0 });
    whole["gear"]["measured_over"] = json!({ "span_teeth": 3, "ball_diameter": 10.5 });
    whole["gear"]["tolerance_class"] = json!(7);
    whole["target"]["modifications"] = json!([
        { "kind": "tip_relief", "amount_um": 10.0, "length_mm": 3.0, "exponent": 2, "flank": "both" },
        { "kind": "helix_crowning", "amount_um": 10.0, "flank": "both" }]);
    whole["bottom_cutter"] = cutter.clone();
    whole["bottom_cutter"]["number"] = json!(2);
    whole["cutter"]["tool_length"] = json!(110.0);
    whole["cutter"]["length_offset"] = json!(11);
    whole["cutter"]["spindle_rpm"] = json!(9000.0);
    whole["cutter"]["feed_mm_per_min"] = json!(1500.0);
    whole["cutter"]["plunge_feed_mm_per_min"] = json!(500.0);
    whole["cutter"]["coolant"] = json!("flood");
    whole["machine"] = json!({ "file": "five-axis-ac-table.toml",
        "mount": { "turned_over": false, "height": 40.0, "offset": [1.0, 2.0], "clocking_deg": 4.0 }, "tool_length": 100.0,
        "tool_length_in": "control", "work_offset": { "number": 2, "position": [1.0, 2.0, 40.0] }, "spindle_dwell_s": 2.0,
        "end_position": [{ "axis": "Z", "position": 390.0 }, { "axis": "A", "position": -5.0 }],
        "spindle_diameter": 100.0, "rtcp": "off", "position_tolerance_um": 0.5, "pole": "slow", "body_clearance": 1.0,
        "clamping": [{ "name": "nut", "z": [11.0, 30.0], "diameter": 60.0, "end_diameter": 50.0 }] });
    whole["stock"] = json!({ "form": "solid" });
    whole["output"] = json!({ "programs": ["siemens"] });
    let mut halves = gear.clone();
    halves["face_width"] = json!(41.0);
    halves["measured_over"] = json!({ "roll_diameter": 10.5 });
    halves["double_helical"] = json!({ "gap": 6.0, "apex": 0.5 });
    let mut held = cutter.clone();
    held["cutting_length"] = json!(9.0);
    held["shank"] = json!([{ "diameter": 30.0, "from": 17.0 }]);
    let mut clocked =
        job("gear", &gear, 900.0, &cutter, milling(json!({ "lead_through_row": 1, "contact_height": 2.5 })));
    clocked["machine"] = json!({ "file": "five-axis-ac-table.toml", "tool_length": 100.0,
        "mount": { "height": 40.0, "clocking_deg": 4.0 }, "work_offset": { "number": 2, "clocking": true },
        "probe": { "number": 90, "diameter": 2.0, "stem_diameter": 1.5, "tool_length": 140.0, "length_offset": 91, "height": 8.0,
            "search_deg": 1.0, "turn_deg_per_min": 50.0, "feed_mm_per_min": 400.0 } });
    clocked["stock"] = json!({ "form": "pre-cut", "allowance": 0.2, "clocking_error_deg": 0.02 });
    clocked["milling"]["lead_in"] = json!({ "radius": 0.3, "angle_deg": 60.0, "straight": 0.2 });
    clocked["milling"]["lead_out"] = json!({ "radius": 0.4, "angle_deg": 50.0, "straight": 0.1 });
    clocked["output"] = json!({ "programs": ["siemens"] });
    let density = json!({ "row_max": 8.0, "row_max_mean": 8.0, "row_min": 0.5, "row_min_mean": 0.5,
        "column_max": 6.2, "column_max_mean": 6.0, "column_min": 0.3, "column_min_mean": 0.3 });
    let by_limits = json!({ "density": density, "scallop_um": 800.0, "chord_um": 500.0, "feed_mm_per_min": 1200.0,
        "spindle_rpm": 8000.0, "teeth": "one", "contact_height": { "from": 1.5, "to": 2.5 },
        "root": { "straight": 1.0, "bottom_pass": false } });
    let bevel = json!({ "outer_transverse_module": 5.0, "teeth": 15, "pitch_cone_angle_deg": 23.198590513648185,
        "pressure_angle_deg": 20.0, "face_width": 25.0, "addendum_factor": 1.0, "dedendum_factor": 1.25,
        "spiral": { "mean_spiral_angle_deg": 35.0, "cutter_radius": 63.0, "hand": "right" }, "start_polar_angle_deg": 22.5,
        "tolerance_class": 7 });
    let cone = json!({ "shape": "cone", "diameter": 2.0, "corner_radius": 0.4, "half_angle_deg": 2.0, "cutting_length": 12.0 });
    let ease = json!({ "lengthwise_um": 10.0, "profile_um": 6.0, "bias_um": 2.0 });
    let mut pair = job(
        "bevel",
        &bevel,
        400.0,
        &cone,
        milling(json!({ "contact_height": [1.5, 1.7, 1.9], "columns": 5 })),
    );
    pair["mate"] = json!({ "teeth": 35, "ease_off": ease, "marking_um": 6.0, "roll_positions": 8 });
    pair["target"]["ease_off"] = ease;
    let mut rolled = job("gear", &gear, 900.0, &cutter, milling(json!({ "contact_height": 2.0 })));
    let mut wheel = gear.clone();
    wheel["helix_angle_deg"] = json!(-gear["helix_angle_deg"].as_f64().unwrap());
    rolled["mate"] = json!({ "gear": wheel, "centre_distance": 152.5, "marking_um": 6.0, "roll_positions": 8,
        "modifications": [{ "kind": "profile_crowning", "amount_um": 5.0, "flank": "both" }] });
    let hobbed = json!({ "outer_transverse_module": 5.0, "teeth": 15, "pitch_cone_angle_deg": 23.198590513648185, "face_width": 25.0,
        "spiral": { "line": "epicycloid", "mean_spiral_angle_deg": 35.0, "cutter_radius": 63.0, "blade_groups": 5, "hand": "right" } });
    let slim = json!({ "shape": "cone", "diameter": 1.6, "corner_radius": 0.3, "half_angle_deg": 2.0, "cutting_length": 12.0 });
    let arrows = json!({ "outer_transverse_module": 6.0, "teeth": 31, "pitch_cone_angle_deg": 60.0, "face_width": 26.0,
        "spiral": { "line": "skew", "mean_spiral_angle_deg": 20.0, "hand": "right" }, "double_helical": { "gap": 6.0, "middle": 0.5 } });
    let straight = json!({ "outer_transverse_module": 5.0, "teeth": 16, "pitch_cone_angle_deg": 33.7,
        "pressure_angle_deg": 20.0, "face_width": 20.0, "flank": "spherical-involute" });
    let blade = json!({ "count": 9, "hub_radius": [40.0, 55.0], "active_height": [0.3, 1.0], "thickness": [4.0, 2.0],
        "ruled": { "tip_radius": 75.0, "length": 60.0, "azimuth_deg": [0.5, 34.4], "tip_lead_deg": [2.86, 11.46], "side": "left" } });
    let naca = json!({ "count": 11, "hub_radius": [60.0, 66.0], "active_height": [0.3, 1.0],
        "naca": { "sections": ["4412", "4408"], "chord": [45.0, 42.0], "stagger_deg": [20.0, 35.0], "tip_radius": 95.0, "side": "upper",
            "edge": 0.06 } });
    let mut high = blade.clone();
    high["active_height"] = json!([0.6, 1.0]);
    let ball = json!({ "shape": "ball", "diameter": 6.0, "cutting_length": 40.0 });
    let barrel = json!({ "shape": "barrel", "diameter": 6.0, "profile_radius": 25.0, "largest_diameter_height": 3.0,
        "cutting_length": 40.0 });
    vec![
        whole,
        job(
            "gear",
            &halves,
            900.0,
            &held,
            milling(json!({ "contact_height": 2.5, "approach_radius": 0.3, "lead_angle_deg": 1.0 })),
        ),
        clocked,
        job("gear", &gear, 900.0, &cutter, by_limits),
        pair,
        rolled,
        job("bevel", &hobbed, 400.0, &cone, milling(json!({ "contact_height": 1.5, "columns": 5 }))),
        job("bevel", &arrows, 900.0, &slim, milling(json!({ "contact_height": 1.0, "columns": 5 }))),
        job("bevel", &straight, 900.0, &cone, milling(json!({ "contact_height": 1.0 }))),
        job(
            "blade",
            &blade,
            1000.0,
            &ball,
            milling(json!({ "tilt_deg": 14.0, "tilt_at_tip_deg": 18.0, "columns": 9 })),
        ),
        job("blade", &high, 1000.0, &barrel, milling(json!({ "tilt_deg": 2.0, "columns": 9 }))),
        job("blade", &naca, 1000.0, &ball, milling(json!({ "tilt_deg": 16.0, "columns": 15 }))),
    ]
}

#[test]
fn every_key_of_five_axis_milling_counts() {
    let schema = schema_of::<MillingJob>("milling");
    let mut missing = BTreeSet::new();
    keys_of_schema(&schema, &schema, "", &mut missing);
    missing.retain(|key| !excepted(key));
    let (mut ignored, mut counted) = (BTreeSet::new(), BTreeSet::new());
    for job in jobs() {
        let before = outcome(&job).unwrap_or_else(|refused| panic!("{refused}\n{job}"));
        let mut all = Vec::new();
        leaves(&job, "", &mut all);
        let todo: Vec<&String> =
            all.iter().filter(|place| !excepted(&key(place)) && !counted.contains(&key(place))).collect();
        let counts = |place: &String| {
            let value = job.pointer(place).unwrap();
            let other = |other: Value| {
                let mut job = job.clone();
                *job.pointer_mut(place).unwrap() = other;
                outcome(&job)
            };
            // A key counts if a value gives another result, or is refused for what it makes of the bodies.
            others(&key(place), value).into_iter().filter(|other| other != value).any(|value| {
                match other(value) {
                    Ok(after) => after != before,
                    Err(refused) => refused.contains("NotProducible"),
                }
            })
        };
        let found: Vec<bool> = todo.par_iter().map(|place| counts(place)).collect();
        for (place, counts) in todo.into_iter().zip(found) {
            missing.remove(&key(place));
            if counts {
                counted.insert(key(place));
            } else {
                ignored.insert(key(place));
            }
        }
    }
    ignored.retain(|key| !counted.contains(key));
    assert!(ignored.is_empty(), "ignored: {ignored:?}");
    assert!(missing.is_empty(), "in no job of the walk: {missing:?}");
}
