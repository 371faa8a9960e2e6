//! What is wrong with a job is reported with its key, value, allowed range, way out and place.

use super::MillingJob;
use super::tests::{read, ruled, sound, template, with_body};
use job::testing::{Case, assert_found};

#[test]
fn every_case_is_found() {
    assert_found::<MillingJob>(&template(), GEAR_CASES);
    let limits = template().replace(
        "rows = 14\ncolumns = 21\n",
        "scallop_um = 5.0\ndensity = { column_max = 1.0, row_max_mean = 2.0 }\n",
    );
    assert_found::<MillingJob>(&limits, LIMIT_CASES);
    assert_found::<MillingJob>(&with_body("bevel"), BEVEL_CASES);
    assert_found::<MillingJob>(&with_mate(), MATE_CASES);
    assert_found::<MillingJob>(&ruled(), BLADE_CASES);
}

/// A bevel gear with its mate.
fn with_mate() -> String {
    let bevel = with_body("bevel");
    let mate = with_body("mate");
    let (from, to) = (mate.find("[mate]").unwrap(), mate.find("[target]").unwrap());
    bevel.replace("[target]", &format!("{}[target]", &mate[from..to]))
}

#[test]
fn a_mate_belongs_to_a_bevel_gear_and_has_usual_defaults() {
    let job = sound(&with_mate());
    let mate = job.mate.unwrap();
    let text = with_mate();
    for line in ["shaft_angle_deg", "marking_um", "roll_positions"] {
        let line = text.lines().find(|given| given.starts_with(line)).unwrap();
        let other = sound(&text.replace(line, "")).mate.unwrap();
        assert_eq!(
            (other.marking_um, other.roll_positions),
            (mate.marking_um, mate.roll_positions),
            "{line}"
        );
    }
    let angle = mate.conjugate_angle_deg(&job.bevel.unwrap()).unwrap();
    assert!((angle - 66.8014).abs() < 1e-3, "{angle}");
    let spur = template().replace("[target]", "[mate]\nteeth = 35\n[target]");
    let error = read(&spur).expect_err("a mate of a spur gear");
    let finding = &error.diagnostics[0];
    assert_eq!((finding.code, finding.field.as_deref()), ("invalid-job", Some("mate")), "{error}");
}

#[test]
fn a_root_cone_stays_open() {
    let flat = with_body("bevel").replace("teeth = 15", "teeth = 9").replace("= 23.1986", "= 10.0");
    let job = flat
        .replace("start_polar_angle_deg = 20.5", "start_polar_angle_deg = 10.0")
        .replace("= 1.25", "= 1.5");
    sound(&job);
    let error = read(&job.replace("dedendum_factor = 1.5", "dedendum_factor = 5.0")).unwrap_err();
    let finding = &error.diagnostics[0];
    let told = (finding.code, finding.field.as_deref(), finding.value.as_deref());
    assert_eq!(told, ("invalid-geometry", Some("bevel.dedendum_factor"), Some("5")), "{error}");
    assert!(finding.span.is_some() && finding.allowed.is_some() && finding.way_out.is_some(), "{error}");
}

const GEAR_CASES: &[Case] = &[
    ("teeth = 20", "teeht = 20", "unknown-key", "gear.teeht", &["did you mean `teeth`", "double_helical"]),
    ("teeth = 20\n", "", "missing-key", "gear.teeth", &["whole number"]),
    ("normal_module = 8.0", "normal_module = nan", "invalid-number", "gear.normal_module", &["NaN", "> 0"]),
    (
        "form_diameter = 152.0",
        "form_diameter = 130.0",
        "invalid-geometry",
        "gear.form_diameter",
        &["130", "140"],
    ),
    (
        "form_diameter",
        "cone_angle_deg = 2.0\nform_diameter",
        "not-yet-supported",
        "gear.cone_angle_deg",
        &["2", "[bevel]"],
    ),
    (
        "face_width = 60.0",
        "face_width = 60.0\ndouble_helical = { gap = 4.0 }",
        "invalid-job",
        "gear.double_helical",
        &["spur"],
    ),
    (
        "helix_angle_deg = 0.0",
        "helix_angle_deg = 30.0\ndouble_helical = { gap = 60.0 }",
        "invalid-geometry",
        "gear.double_helical.gap",
        &["60", "< face_width"],
    ),
    (
        "helix_angle_deg = 0.0",
        "helix_angle_deg = 30.0\ndouble_helical = { gap = -1 }",
        "invalid-number",
        "gear.double_helical.gap",
        &[">= 0"],
    ),
    (
        "helix_angle_deg = 0.0",
        "helix_angle_deg = 30.0\ndouble_helical = { gap = 4.0, apex = 28.0 }",
        "invalid-geometry",
        "gear.double_helical.apex",
        &["28", "between -28 and 28"],
    ),
    (
        "helix_angle_deg = 0.0",
        "helix_angle_deg = 30.0\ndouble_helical = { gap = 0.0, apex = -31.5 }",
        "invalid-geometry",
        "gear.double_helical.apex",
        &["-31.5", "between -30 and 30"],
    ),
    ("tolerance_um = 10.0", "tolerance_um = inf", "invalid-number", "target.tolerance_um", &["inf", "> 0"]),
    (
        "tolerance_um = 10.0",
        "ease_off = { profile_um = 5.0 }",
        "invalid-job",
        "target.ease_off",
        &["[bevel]"],
    ),
    (
        "shape = \"end-mill\"",
        "shape = \"endmill\"",
        "unknown-value",
        "cutter.shape",
        &["did you mean \"end-mill\"", "\"torus\""],
    ),
    ("shape = \"end-mill\"\n", "", "missing-key", "cutter.shape", &["\"ball\""]),
    ("diameter = 6.0", "diameter = -6.0", "invalid-number", "cutter.diameter", &["-6", "> 0"]),
    ("diameter = 6.0", "diameter = 2.0", "invalid-geometry", "cutter.corner_radius", &["1.5", "0 to 1"]),
    (
        "corner_radius = 1.5",
        "corner_radius = 1.5\nprofile_radius = 40.0",
        "invalid-job",
        "cutter.profile_radius",
        &["40", "\"barrel\""],
    ),
    (
        "shape = \"end-mill\"",
        "shape = \"ball\"",
        "invalid-job",
        "cutter.corner_radius",
        &["1.5", "\"end-mill\""],
    ),
    ("shape = \"end-mill\"", "shape = \"cone\"", "missing-key", "cutter.half_angle_deg", &["cone"]),
    ("shape = \"end-mill\"", "shape = \"barrel\"", "missing-key", "cutter.profile_radius", &["barrel"]),
    (
        "shape = \"end-mill\"",
        "shape = \"drum\"\nprofile_radius = 40\nlargest_diameter_height = 30",
        "invalid-geometry",
        "cutter.largest_diameter_height",
        &["30", "22"],
    ),
    (
        "shape = \"end-mill\"\ndiameter = 6.0\ncorner_radius = 1.5",
        "shape = \"torus\"\ndiameter = 6.0",
        "missing-key",
        "cutter.corner_radius",
        &["torus"],
    ),
    (
        "shape = \"end-mill\"\ndiameter = 6.0\ncorner_radius = 1.5",
        "shape = \"torus\"\ndiameter = 6.0\ncorner_radius = 0",
        "invalid-geometry",
        "cutter.corner_radius",
        &["> 0"],
    ),
    (
        "cutting_length = 22.0",
        "cutting_length = 1.0",
        "invalid-geometry",
        "cutter.cutting_length",
        &[">= 1.5"],
    ),
    (
        "cutting_length = 22.0",
        "cutting_length = 22.0\nshank = [{ diameter = 6, from = 20 }]",
        "invalid-geometry",
        "cutter.shank[0].from",
        &["20", ">= 22"],
    ),
    (
        "cutting_length = 22.0",
        "cutting_length = 22.0\nshank = [{ diameter = 6, from = 30 }, { diameter = 20, from = 30 }]",
        "invalid-geometry",
        "cutter.shank[1].from",
        &["30"],
    ),
    (
        "cutting_length = 22.0",
        "cutting_length = 22.0\nshank = [{ diameter = nan, from = 30 }]",
        "invalid-number",
        "cutter.shank[0].diameter",
        &["NaN"],
    ),
    (
        "[milling]",
        "[roughing_cutter]\nshape = \"ball\"\ndiameter = 6\ncutting_length = 9\n[milling]",
        "invalid-job",
        "roughing_cutter",
        &["[milling.roughing]"],
    ),
    (
        "[milling]",
        "[bottom_cutter]\nshape = \"end-mill\"\ndiameter = 5\ncorner_radius = 1.0\ncutting_length = 9\n[milling]",
        "invalid-job",
        "bottom_cutter.corner_radius",
        &["1.5"],
    ),
    (
        "[milling]",
        "[bottom_cutter]\nshape = \"end-mill\"\ndiameter = 5\nnumber = 1\ncorner_radius = 1.5\ncutting_length = 9\n[milling]",
        "invalid-job",
        "bottom_cutter.number",
        &["1"],
    ),
    (
        "cutting_length = 22.0\n[milling]",
        "cutting_length = 22.0\nnumber = 2\n[bottom_cutter]\nshape = \"end-mill\"\ndiameter = 5\ncorner_radius = 1.5\ncutting_length = 9\n[milling]",
        "invalid-job",
        "cutter.number",
        &["2"],
    ),
    ("rows = 14", "rows = 1", "invalid-number", "milling.rows", &[">= 2"]),
    ("rows = 14", "rows = 14.5", "wrong-type", "milling.rows", &["whole number"]),
    ("columns = 21\n", "", "missing-key", "milling.columns", &["rows and columns"]),
    ("rows = 14\ncolumns = 21\n", "", "missing-key", "milling.rows", &["scallop_um"]),
    (
        "columns = 21",
        "columns = 21\ndensity = { row_max = 1.0 }",
        "invalid-job",
        "milling.density",
        &["keep the numbers or the limits"],
    ),
    ("columns = 21", "columns = 21\nscallop_um = 5.0", "invalid-job", "milling.scallop_um", &["5"]),
    (
        "rows = 14\ncolumns = 21",
        "rows = 20000\ncolumns = 20000",
        "invalid-job",
        "milling.columns",
        &["1000000"],
    ),
    (
        "columns = 21",
        "columns = 21\nlead_through_row = 14",
        "invalid-job",
        "milling.lead_through_row",
        &["14", "0 to 13"],
    ),
    ("columns = 21", "columns = 21\ntilt_deg = -3.0", "invalid-job", "milling.tilt_deg", &["-3", ">= 0"]),
    ("columns = 21", "columns = 21\ntilt_deg = 90", "invalid-number", "milling.tilt_deg", &["< 90"]),
    (
        "columns = 21",
        "columns = 21\nsafety_distance = -inf",
        "invalid-number",
        "milling.safety_distance",
        &[">= 0"],
    ),
    (
        "columns = 21",
        "columns = 21\ntraverse = \"zig-zag\"",
        "unknown-value",
        "milling.traverse",
        &["did you mean \"zigzag\""],
    ),
    ("columns = 21", "columns = 21\norder = \"tip\"", "unknown-value", "milling.order", &["tip-to-root"]),
    ("contact_height = 6.16\n", "", "missing-key", "milling.contact_height", &["from 1.5 to 22"]),
    (
        "contact_height = 6.16",
        "contact_height = 1.2",
        "invalid-job",
        "milling.contact_height",
        &["1.2", "from 1.5 to 22", "corner"],
    ),
    (
        "contact_height = 6.16",
        "contact_height = { from = 5.0, to = 23.0 }",
        "invalid-job",
        "milling.contact_height.to",
        &["23", "from 1.5 to 22"],
    ),
    (
        "contact_height = 6.16",
        "contact_height = { from = 5.0 }",
        "missing-key",
        "milling.contact_height.to",
        &["number"],
    ),
    (
        "contact_height = 6.16",
        "contact_height = [5.0, 6.0, 1.0]",
        "invalid-job",
        "milling.contact_height[2]",
        &["1"],
    ),
    (
        "contact_height = 6.16",
        "contact_height = [5.0, 6.0]",
        "invalid-list",
        "milling.contact_height",
        &["14"],
    ),
    (
        "contact_height = 6.16",
        "contact_height = \"low\"",
        "wrong-type",
        "milling.contact_height",
        &["a number"],
    ),
    (
        "contact_height = 6.16",
        "contact_height = 6.16\ntilt_deg = 5.0",
        "invalid-job",
        "milling.contact_height",
        &["6.16"],
    ),
    ("feed_mm_per_min = 1200.0\n", "", "missing-key", "milling.feed_mm_per_min", &["feed"]),
    (
        "feed_mm_per_min = 1200.0",
        "feed_mm_per_min = 0",
        "invalid-number",
        "milling.feed_mm_per_min",
        &["> 0"],
    ),
    ("spindle_rpm = 8000.0", "spindle_rpm = 1e9", "invalid-number", "milling.spindle_rpm", &["<= 200000"]),
    (
        "bottom = 0.0",
        "bottom = 0.0\nstraight = 4.0",
        "invalid-job",
        "milling.root.straight",
        &["exactly one of bottom, straight"],
    ),
    (
        "bottom = 0.0",
        "bottom_pass = true",
        "missing-key",
        "milling.root.bottom",
        &["exactly one of bottom, straight"],
    ),
    (
        "[simulation]",
        "[milling.roughing]\nallowance = 0.3\nstep_down = 2\nstep_over = 7\n[simulation]",
        "invalid-job",
        "milling.roughing.step_over",
        &["7", "<= 6"],
    ),
    (
        "[simulation]",
        "[milling.roughing]\nallowance = 0.3\nstep_down = 0\nstep_over = 2\n[simulation]",
        "invalid-number",
        "milling.roughing.step_down",
        &["> 0"],
    ),
    (
        "rays_profile = 81\nrays_length = 61",
        "rays_profile = 2001\nrays_length = 2001",
        "invalid-job",
        "simulation.rays_profile",
        &["250000"],
    ),
    ("tool_length = 120.0\n", "", "missing-key", "machine.tool_length", &["spindle nose"]),
    (
        "tool_length = 120.0\n",
        "tool_length = 120.0\npole = \"around\"\n",
        "unknown-value",
        "machine.pole",
        &["around", "mount"],
    ),
    (
        "tool_length = 120.0\n",
        "tool_length = 120.0\npole = \"hold\"\n",
        "invalid-job",
        "machine.pole",
        &["ball"],
    ),
    (
        "tool_length = 120.0\n",
        "tool_length = 120.0\npole_cap_deg = 21.0\n",
        "invalid-number",
        "machine.pole_cap_deg",
        &["2 is the default"],
    ),
    (
        "tool_length = 120.0",
        "tool_length = 120.0\nrtcp = \"auto\"",
        "unknown-value",
        "machine.rtcp",
        &["\"rows\""],
    ),
    (
        "tool_length = 120.0",
        "tool_length = 120.0\nmount = { offset = [0.0] }",
        "invalid-list",
        "machine.mount.offset",
        &["2 to 2"],
    ),
    (
        "tool_length = 120.0",
        "tool_length = 120.0\nmount = { offset = [0.0, inf] }",
        "invalid-number",
        "machine.mount.offset[1]",
        &["inf"],
    ),
    ("\"fanuc\"]", "\"heidenhain\"]", "unknown-value", "output.programs[2]", &["\"linuxcnc\""]),
    (
        "[machine]\nfile = \"machines/five-axis-ac-table.toml\"\ntool_length = 120.0\n",
        "",
        "invalid-job",
        "output.programs",
        &["[machine]"],
    ),
    ("[output]", "[grid]\nprofile_points = 41\n[output]", "unknown-key", "grid", &["simulation"]),
];

const LIMIT_CASES: &[Case] = &[
    (
        "column_max = 1.0",
        "column_max = 1.0, column_min = 1.2",
        "invalid-job",
        "milling.density.column_min",
        &["1.2", "<= column_max = 1"],
    ),
    (
        "row_max_mean = 2.0",
        "row_max_mean = 2.0, row_min = 3.0",
        "invalid-job",
        "milling.density.row_min",
        &["3", "<= row_max_mean = 2"],
    ),
    (
        "row_max_mean = 2.0",
        "row_max_mean = 2.0, row_max = 1.0, row_min_mean = 1.5",
        "invalid-job",
        "milling.density.row_min_mean",
        &["<= row_max = 1"],
    ),
    ("column_max = 1.0", "column_max = 0", "invalid-number", "milling.density.column_max", &["> 0"]),
    ("column_max = 1.0, row_max_mean = 2.0", "", "missing-key", "milling.density.column_max", &["row_max"]),
    ("scallop_um = 5.0", "scallop_um = nan", "invalid-number", "milling.scallop_um", &["NaN"]),
    (
        "contact_height = 6.16",
        "contact_height = [6.0, 6.0]",
        "invalid-list",
        "milling.contact_height",
        &["{ from, to }"],
    ),
];

const BEVEL_CASES: &[Case] = &[
    ("teeth = 15", "teeth = 0", "invalid-number", "bevel.teeth", &[">= 3"]),
    (
        "pitch_cone_angle_deg = 23.1986",
        "pitch_cone_angle_deg = 90",
        "invalid-number",
        "bevel.pitch_cone_angle_deg",
        &["< 90"],
    ),
    ("face_width = 25.0", "face_width = 96.0", "invalid-geometry", "bevel.face_width", &["96", "apex"]),
    ("flank = \"spherical-involute\"", "flank = \"octoid\"", "invalid-job", "bevel.spiral", &["octoid"]),
    ("hand = \"right\"", "hand = \"r\"", "unknown-value", "bevel.spiral.hand", &["\"left\", \"right\""]),
    (
        "cutter_radius = 63.0",
        "cutter_radius = -63.0",
        "invalid-number",
        "bevel.spiral.cutter_radius",
        &["> 0"],
    ),
    (
        "start_polar_angle_deg = 20.5",
        "start_polar_angle_deg = 30.0",
        "invalid-geometry",
        "bevel.start_polar_angle_deg",
        &["30", "tip cone"],
    ),
    (
        "outer_transverse_module = 5.0",
        "outer_transverse_module = 1.0",
        "invalid-geometry",
        "bevel.face_width",
        &["25", "apex"],
    ),
    ("tolerance_um = 10.0", "modifications = []", "invalid-job", "target.modifications", &["ease_off"]),
    ("rows = 14", "rows = 14\nlead_through_row = 2", "invalid-job", "milling.lead_through_row", &["[gear]"]),
];

const MATE_CASES: &[Case] = &[
    ("teeth = 35", "teeth = 2", "invalid-number", "mate.teeth", &[">= 3"]),
    ("teeth = 35", "teeth = 39", "invalid-job", "mate.teeth", &["39", "< 38.0"]),
    ("teeth = 35\nshaft_angle_deg = 90.0", "teeth = 34", "invalid-job", "mate.teeth", &["90", "86.4"]),
    (
        "shaft_angle_deg = 90.0",
        "shaft_angle_deg = 89.0",
        "invalid-job",
        "mate.shaft_angle_deg",
        &["89", "90.0"],
    ),
    (
        "shaft_angle_deg = 90.0",
        "pitch_cone_angle_deg = 60.0",
        "invalid-job",
        "mate.pitch_cone_angle_deg",
        &["60", "66.80"],
    ),
    (
        "shaft_angle_deg = 90.0",
        "shaft_angle_deg = 90.0\npitch_cone_angle_deg = 66.8014",
        "invalid-job",
        "mate.shaft_angle_deg",
        &["at most one"],
    ),
    ("marking_um = 6.0", "marking_um = 0", "invalid-number", "mate.marking_um", &["> 0"]),
    ("roll_positions = 24", "roll_positions = 4", "invalid-number", "mate.roll_positions", &[">= 8"]),
];

const BLADE_CASES: &[Case] = &[
    ("count = 9", "count = 0", "invalid-number", "blade.count", &[">= 1"]),
    (
        "hub_radius = [40.0, 55.0]",
        "hub_radius = [40.0, 80.0]",
        "invalid-geometry",
        "blade.ruled.tip_radius",
        &["75", "> 80"],
    ),
    ("hub_radius = [40.0, 55.0]", "hub_radius = [40.0]", "invalid-list", "blade.hub_radius", &["2 to 2"]),
    (
        "active_height = [0.05, 1.0]",
        "active_height = [1.0, 0.05]",
        "invalid-job",
        "blade.active_height",
        &["[1, 0.05]"],
    ),
    ("ruled = {", "# ruled = {", "missing-key", "blade.ruled", &["ruled, points"]),
    (
        "ruled = {",
        "points = { file = \"b.csv\", rows = 9, columns = 9, side = \"left\" }\nruled = {",
        "invalid-job",
        "blade.points",
        &["exactly one of ruled, points"],
    ),
    (
        "ruled = {",
        "points = { file = \"b.csv\", rows = 3, columns = 9, side = \"left\" }\nruled = {",
        "invalid-number",
        "blade.points.rows",
        &[">= 4"],
    ),
    ("side = \"left\"", "side = \"both\"", "unknown-value", "blade.ruled.side", &["\"left\", \"right\""]),
    ("rows = 14", "rows = 14\nflanks = \"both\"", "invalid-job", "milling.flanks", &["\"both\"", "[blade]"]),
    ("tolerance_um = 10.0", "ease_off = {}", "invalid-job", "target.ease_off", &["[bevel]"]),
];
