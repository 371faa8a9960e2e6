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
    sound(&with_cylindrical_mate());
    assert_found::<MillingJob>(&with_cylindrical_mate(), CYLINDRICAL_MATE_CASES);
    assert_found::<MillingJob>(&ruled(), BLADE_CASES);
    assert_found::<MillingJob>(&naca_blade(), NACA_CASES);
    sound(&with_body("grid_gear"));
    assert_found::<MillingJob>(&with_body("grid_gear"), GRID_CASES);
}

/// What a cylindrical gear can have and a conical one cannot, in both.
#[test]
fn a_conical_gear_has_neither_a_mate_nor_a_row_for_its_guide_curve() {
    let cone =
        |text: &str| text.replacen("helix_angle_deg = 0.0", "helix_angle_deg = 0.0\ncone_angle_deg = 3.0", 1);
    sound(&cone(&template()));
    let through = cone(&template()).replace("rows = 14", "rows = 14\nlead_through_row = 3");
    for (text, code, field) in [
        (cone(&with_cylindrical_mate()), "not-yet-supported", "gear.cone_angle_deg"),
        (through, "invalid-job", "milling.lead_through_row"),
    ] {
        let error = read(&text).expect_err(field);
        let finding = &error.diagnostics[0];
        assert_eq!((finding.code, finding.field.as_deref()), (code, Some(field)), "{error}");
        assert!(finding.value.is_some() && finding.allowed.is_some() && finding.way_out.is_some());
    }
}

/// A bevel gear with its mate.
fn with_mate() -> String {
    let bevel: String = with_body("bevel")
        .lines()
        .filter(|line| !line.starts_with("double_helical"))
        .map(|line| line.to_owned() + "\n")
        .collect();
    let mate = with_body("mate");
    let (from, to) = (mate.find("[mate]").unwrap(), mate.find("[target]").unwrap());
    let of_bevel = |line: &&str| !line.starts_with("gear") && !line.starts_with("centre_distance");
    let mate: String = mate[from..to].lines().filter(of_bevel).map(|line| line.to_owned() + "\n").collect();
    bevel.replace("[target]", &format!("{mate}[target]"))
}

/// A spur gear with its mate.
fn with_cylindrical_mate() -> String {
    let mate = with_body("mate");
    let (from, to) = (mate.find("[mate]").unwrap(), mate.find("[target]").unwrap());
    let bevels = ["teeth", "shaft_angle_deg", "ease_off"];
    let of_gear = |line: &&str| !bevels.iter().any(|key| line.starts_with(key));
    let mate: String = mate[from..to].lines().filter(of_gear).map(|line| line.to_owned() + "\n").collect();
    template().replace("[target]", &format!("{mate}[target]"))
}

#[test]
fn a_mate_has_usual_defaults_and_blades_have_none() {
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
    let blade = ruled().replace("[target]", "[mate]\nteeth = 35\n[target]");
    let error = read(&blade).expect_err("a mate of a blade");
    let finding = &error.diagnostics[0];
    assert_eq!((finding.code, finding.field.as_deref()), ("invalid-job", Some("mate")), "{error}");
}

/// Why the root of an internal gear is not milled: no cutter that finishes its flank draws it.
#[test]
fn the_root_of_an_internal_gear_is_refused_with_its_reason() {
    let path = format!("{}/../../examples/milling/internal-ring.toml", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).unwrap();
    sound(&text);
    let with_root = text.replace("[simulation]", "[milling.root]\nbottom = 0.0\n[simulation]");
    let error = read(&with_root).expect_err("the root of an internal gear");
    let finding = &error.diagnostics[0];
    assert_eq!((finding.code, finding.field.as_deref()), ("invalid-job", Some("milling.root")), "{error}");
    assert!(finding.message.contains("hollow flank") && finding.way_out.is_some(), "{error}");
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

/// Its tip ends where the involute does, on the other side of the pitch plane.
#[test]
fn a_crown_gear_has_a_tip_as_far_as_its_flank_goes() {
    let crown = with_body("bevel")
        .replace("= 23.1986", "= 90.0")
        .replace("start_polar_angle_deg = 20.5", "start_polar_angle_deg = 86.0");
    sound(&crown);
    let error = read(&crown.replace("addendum_factor = 1.0", "addendum_factor = 5.0")).unwrap_err();
    let finding = &error.diagnostics[0];
    let told = (finding.code, finding.field.as_deref(), finding.value.as_deref());
    assert_eq!(told, ("invalid-geometry", Some("bevel.addendum_factor"), Some("5")), "{error}");
    let allowed = finding.allowed.as_deref().unwrap_or_default();
    assert!(allowed.contains("109.99") && finding.span.is_some() && finding.way_out.is_some(), "{error}");
}

/// Pinion and crown gear know each other, whichever is milled.
#[test]
fn the_mate_of_a_pinion_is_a_crown_gear_where_its_teeth_ask_for_it() {
    // 15 teeth on 30 degrees beside 30 teeth.
    let mate = with_mate();
    let own_start = |line: &&str| !line.starts_with("start_polar_angle_deg");
    let pinion: String = mate.lines().filter(own_start).map(|line| line.to_owned() + "\n").collect();
    let pinion = pinion.replace("= 23.1986", "= 30.0");
    let pinion = pinion
        .replace("teeth = 35", "teeth = 30")
        .replace("shaft_angle_deg = 90.0", "shaft_angle_deg = 120.0");
    let job = sound(&pinion);
    assert_eq!(job.mate.unwrap().conjugate_angle_deg(&job.bevel.unwrap()), Some(90.0));
    let crown = pinion.replace("= 30.0  ", "= 90.0  ").replace("teeth = 30", "teeth = 7");
    let job = sound(&crown.replace("teeth = 15", "teeth = 14"));
    let angle = job.mate.unwrap().conjugate_angle_deg(&job.bevel.unwrap()).unwrap();
    assert!((angle - 30.0).abs() < 1e-12, "{angle}");
    let error = read(&pinion.replace("teeth = 30\n", "teeth = 31\n")).unwrap_err();
    assert_eq!(error.diagnostics[0].field.as_deref(), Some("mate.teeth"), "{error}");
}

const GEAR_CASES: &[Case] = &[
    (
        "[cutter]",
        "[measuring_grid]\nrows = 5\n[cutter]",
        "invalid-job",
        "measuring_grid",
        &["[bevel]", "bevel gears are measured"],
    ),
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
        "helix_angle_deg = 0.0",
        "helix_angle_deg = 20.0\ncone_angle_deg = 2.0\ndouble_helical = { gap = 4.0 }",
        "invalid-job",
        "gear.cone_angle_deg",
        &["2", "double_helical"],
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
    ("rows = 14", "rows = 14\ntilt_at_tip_deg = 90", "invalid-number", "milling.tilt_at_tip_deg", &["< 90"]),
    (
        "rows = 14",
        "rows = 14\ntilt_at_tip_deg = 20",
        "invalid-job",
        "milling.tilt_at_tip_deg",
        &["> 0", "lean differently"],
    ),
    (
        "rows = 14",
        "rows = 14\ntilt_deg = 20\ntilt_at_tip_deg = -3",
        "invalid-job",
        "milling.tilt_at_tip_deg",
        &["towards the flank"],
    ),
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
    (
        "tool_length = 120.0",
        "tool_length = 120.0\nprobe = { number = 90, diameter = 4.0, tool_length = 140.0 }",
        "invalid-job",
        "machine.probe",
        &["clocking = true"],
    ),
    (
        "tool_length = 120.0",
        "tool_length = 120.0\nwork_offset = { number = 1, clocking = true }\nprobe = { number = 1, diameter = 4.0, tool_length = 140.0 }",
        "invalid-job",
        "machine.probe.number",
        &["1", "no cutter"],
    ),
    (
        "tool_length = 120.0",
        "tool_length = 120.0\nwork_offset = { number = 1, clocking = true }\nprobe = { number = 90, diameter = 4.0, tool_length = 140.0, stem_diameter = 4.0 }",
        "invalid-job",
        "machine.probe.stem_diameter",
        &["4", "< 4"],
    ),
    (
        "tool_length = 120.0",
        "tool_length = 120.0\nprobe = { number = 0, diameter = 4.0, tool_length = 140.0 }",
        "invalid-number",
        "machine.probe.number",
        &[">= 1"],
    ),
    (
        "tool_length = 120.0",
        "tool_length = 120.0\nprobe = { number = 90, diameter = 0, tool_length = 140.0 }",
        "invalid-number",
        "machine.probe.diameter",
        &["> 0", "smaller than the space"],
    ),
    (
        "tool_length = 120.0",
        "tool_length = 120.0\nprobe = { number = 90, diameter = 4.0, tool_length = 0 }",
        "invalid-number",
        "machine.probe.tool_length",
        &["> 0"],
    ),
    (
        "tool_length = 120.0",
        "tool_length = 120.0\nprobe = { number = 90, diameter = 4.0, tool_length = 140.0, length_offset = 1000 }",
        "invalid-number",
        "machine.probe.length_offset",
        &["1000", "<= 999"],
    ),
    (
        "tool_length = 120.0",
        "tool_length = 120.0\nprobe = { number = 90, diameter = 4.0, tool_length = 140.0, height = -1.0 }",
        "invalid-number",
        "machine.probe.height",
        &["-1", "> 0"],
    ),
    (
        "tool_length = 120.0",
        "tool_length = 120.0\nprobe = { number = 90, diameter = 4.0, tool_length = 140.0, search_deg = 21.0 }",
        "invalid-number",
        "machine.probe.search_deg",
        &["21", "<= 20"],
    ),
    (
        "tool_length = 120.0",
        "tool_length = 120.0\nprobe = { number = 90, diameter = 4.0, tool_length = 140.0, turn_deg_per_min = 0 }",
        "invalid-number",
        "machine.probe.turn_deg_per_min",
        &["> 0"],
    ),
    (
        "tool_length = 120.0",
        "tool_length = 120.0\nprobe = { number = 90, diameter = 4.0, tool_length = 140.0, feed_mm_per_min = 0 }",
        "invalid-number",
        "machine.probe.feed_mm_per_min",
        &["> 0"],
    ),
    ("[cutter]", "[compensation]\n[cutter]", "missing-key", "compensation.modifications", &[]),
    (
        "[simulation]",
        "[stock]\nform = \"solid\"\n[simulation]",
        "invalid-job",
        "stock.form",
        &["solid", "pre-cut", "[milling.roughing]"],
    ),
    (
        "[simulation]",
        "[stock]\nform = \"cast\"\n[simulation]",
        "unknown-value",
        "stock.form",
        &["cast", "\"pre-cut\""],
    ),
    (
        "[simulation]",
        "[stock]\nform = \"pre-cut\"\n[simulation]",
        "missing-key",
        "stock.allowance",
        &["normal to the flanks"],
    ),
    (
        "[simulation]",
        "[stock]\nform = \"pre-cut\"\nallowance = -0.1\n[simulation]",
        "invalid-number",
        "stock.allowance",
        &["-0.1", ">= 0"],
    ),
    (
        "[simulation]",
        "[stock]\nform = \"pre-cut\"\nallowance = 0.2\nclocking_error_deg = 11.0\n[simulation]",
        "invalid-number",
        "stock.clocking_error_deg",
        &["11", "<= 10"],
    ),
    (
        "[simulation]",
        "[milling.roughing]\nallowance = 0.3\nstep_down = 2\nstep_over = 2\n[stock]\nform = \"pre-cut\"\nallowance = 0.2\n[simulation]",
        "invalid-job",
        "stock.form",
        &["cleared again", "\"solid\""],
    ),
    (
        "[simulation]",
        "[milling.roughing]\nallowance = 0.3\nstep_down = 2\nstep_over = 2\n[stock]\nform = \"solid\"\nallowance = 0.2\n[simulation]",
        "invalid-job",
        "stock.allowance",
        &["0.2", "pre-cut"],
    ),
    (
        "spindle_rpm = 8000.0",
        "spindle_rpm = 8000.0\nlead_in = { radius = 0 }",
        "invalid-number",
        "milling.lead_in.radius",
        &["> 0"],
    ),
    (
        "spindle_rpm = 8000.0",
        "spindle_rpm = 8000.0\nlead_in = { radius = 1.0, angle_deg = 91.0 }",
        "invalid-number",
        "milling.lead_in.angle_deg",
        &["91", "<= 90"],
    ),
    (
        "spindle_rpm = 8000.0",
        "spindle_rpm = 8000.0\nlead_out = { radius = 1.0, straight = -1.0 }",
        "invalid-number",
        "milling.lead_out.straight",
        &["-1", ">= 0"],
    ),
    (
        "spindle_rpm = 8000.0",
        "spindle_rpm = 8000.0\napproach_radius = 0.5\nlead_out = { radius = 1.0 }",
        "invalid-job",
        "milling.approach_radius",
        &["0.5", "lead_out"],
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
    (
        "tool_length = 120.0",
        "tool_length = 120.0\nmount = { clocking_deg = 361.0 }",
        "invalid-number",
        "machine.mount.clocking_deg",
        &["361", "<= 360", "clocking program"],
    ),
    (
        "tool_length = 120.0",
        "tool_length = 120.0\ntool_length_in = \"spindle\"",
        "unknown-value",
        "machine.tool_length_in",
        &["spindle", "\"program\", \"control\""],
    ),
    (
        "programs = [\"linuxcnc\", \"siemens\", \"fanuc\"]\n",
        "programs = [\"siemens\"]\n[machine.work_offset]\nnumber = 1\nc = 3.0\n",
        "unknown-key",
        "machine.work_offset.c",
        &["number"],
    ),
    (
        "tool_length = 120.0",
        "tool_length = 120.0\nwork_offset = { number = 0 }",
        "invalid-number",
        "machine.work_offset.number",
        &["0", ">= 1", "G54"],
    ),
    (
        "tool_length = 120.0",
        "tool_length = 120.0\nwork_offset = { number = 307 }",
        "invalid-number",
        "machine.work_offset.number",
        &["307", "<= 306"],
    ),
    (
        "tool_length = 120.0",
        "tool_length = 120.0\nwork_offset = { number = 1, position = [0.0, 0.0] }",
        "invalid-list",
        "machine.work_offset.position",
        &["3 to 3"],
    ),
    (
        "tool_length = 120.0",
        "tool_length = 120.0\nwork_offset = { number = 1, position = [0.0, 0.0, 20000.0] }",
        "invalid-number",
        "machine.work_offset.position[2]",
        &["20000", "<= 10000"],
    ),
    (
        "tool_length = 120.0",
        "tool_length = 120.0\nmount = { offset = [1.0, 0.0] }\nwork_offset = { number = 1, clocking = true }",
        "invalid-job",
        "machine.work_offset.clocking",
        &["machine.mount.offset = [0, 0]"],
    ),
    (
        "tool_length = 120.0",
        "tool_length = 120.0\nend_position = [{ axis = \"Z\" }]",
        "missing-key",
        "machine.end_position[0].position",
        &["number"],
    ),
    (
        "tool_length = 120.0",
        "tool_length = 120.0\nend_position = [{ axis = \"Z\", position = 200000.0 }]",
        "invalid-number",
        "machine.end_position[0].position",
        &["200000", "100000"],
    ),
    (
        "tool_length = 120.0",
        "tool_length = 120.0\nspindle_dwell_s = -1.0",
        "invalid-number",
        "machine.spindle_dwell_s",
        &["-1", ">= 0"],
    ),
    (
        "cutting_length = 22.0",
        "cutting_length = 22.0\ntool_length = 0",
        "invalid-number",
        "cutter.tool_length",
        &["> 0", "spindle nose"],
    ),
    (
        "cutting_length = 22.0",
        "cutting_length = 22.0\nlength_offset = 1000",
        "invalid-number",
        "cutter.length_offset",
        &["1000", "<= 999"],
    ),
    (
        "cutting_length = 22.0",
        "cutting_length = 22.0\nspindle_rpm = 0",
        "invalid-number",
        "cutter.spindle_rpm",
        &["> 0"],
    ),
    (
        "cutting_length = 22.0",
        "cutting_length = 22.0\nfeed_mm_per_min = inf",
        "invalid-number",
        "cutter.feed_mm_per_min",
        &["inf"],
    ),
    (
        "cutting_length = 22.0",
        "cutting_length = 22.0\nplunge_feed_mm_per_min = -5",
        "invalid-number",
        "cutter.plunge_feed_mm_per_min",
        &["-5", "> 0"],
    ),
    (
        "cutting_length = 22.0",
        "cutting_length = 22.0\ncoolant = \"oil\"",
        "unknown-value",
        "cutter.coolant",
        &["oil", "\"flood\""],
    ),
    (
        "spindle_rpm = 8000.0",
        "spindle_rpm = 8000.0\ncoolant = \"air\"",
        "unknown-value",
        "milling.coolant",
        &["air", "\"flood-and-mist\""],
    ),
    (
        "[milling]",
        "[bottom_cutter]\nshape = \"end-mill\"\ndiameter = 5.0\ncutting_length = 15.0\nlength_offset = 1\n[milling]",
        "invalid-job",
        "bottom_cutter.length_offset",
        &["1", "another number"],
    ),
    (
        "[simulation]",
        "[milling.roughing]\nallowance = 0.3\nstep_down = 2\nstep_over = 2\nfeed_mm_per_min = 900.0\n[roughing_cutter]\nshape = \"end-mill\"\ndiameter = 5.0\ncutting_length = 15.0\nfeed_mm_per_min = 800.0\n[simulation]",
        "invalid-job",
        "roughing_cutter.feed_mm_per_min",
        &["800", "at most one"],
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
    (
        "[cutter]",
        "[measuring_grid]\nrows = 2\n[cutter]",
        "invalid-number",
        "measuring_grid.rows",
        &["2", "3"],
    ),
    (
        "[cutter]",
        "[measuring_grid]\ncolumns = 102\n[cutter]",
        "invalid-number",
        "measuring_grid.columns",
        &["102", "101"],
    ),
    (
        "[cutter]",
        "[measuring_grid]\nprofile_margin = 0.5\n[cutter]",
        "invalid-number",
        "measuring_grid.profile_margin",
        &["0.5", "0.4"],
    ),
    (
        "[cutter]",
        "[measuring_grid]\nlength_margin = -0.1\n[cutter]",
        "invalid-number",
        "measuring_grid.length_margin",
        &["-0.1", "0"],
    ),
    ("tolerance_class = 7", "tolerance_class = 12", "invalid-number", "bevel.tolerance_class", &["12", "11"]),
    ("teeth = 15", "teeth = 0", "invalid-number", "bevel.teeth", &[">= 3"]),
    (
        "pitch_cone_angle_deg = 23.1986",
        "pitch_cone_angle_deg = 90.5",
        "invalid-number",
        "bevel.pitch_cone_angle_deg",
        &["90.5", "<= 90"],
    ),
    ("gap = 3.0", "gap = 25.0", "invalid-geometry", "bevel.double_helical.gap", &["25", "< face_width"]),
    ("gap = 3.0", "gap = -1.0", "invalid-number", "bevel.double_helical.gap", &[">= 0"]),
    (
        "middle = 0.0",
        "middle = -11.0",
        "invalid-geometry",
        "bevel.double_helical.middle",
        &["-11", "between -11 and 11"],
    ),
    (
        "mean_spiral_angle_deg = 35.0",
        "mean_spiral_angle_deg = 0.0",
        "invalid-job",
        "bevel.double_helical",
        &["opposite hands", "spiral"],
    ),
    ("[cutter]", "[measuring_grid]\n[cutter]", "invalid-job", "measuring_grid", &["bevel.double_helical"]),
    ("[target]", "[mate]\nteeth = 35\n[target]", "invalid-job", "mate", &["bevel.double_helical"]),
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
    ("cutter_radius = 63.0, ", "", "missing-key", "bevel.spiral.cutter_radius", &["cutter head"]),
    (
        "cutter_radius = 63.0",
        "line = \"skew\", cutter_radius = 63.0",
        "invalid-job",
        "bevel.spiral.cutter_radius",
        &["\"skew\""],
    ),
    (
        "cutter_radius = 63.0",
        "blade_groups = 5, cutter_radius = 63.0",
        "invalid-job",
        "bevel.spiral.blade_groups",
        &["epicycloid"],
    ),
    (
        "cutter_radius = 63.0",
        "line = \"epicycloid\", cutter_radius = 63.0",
        "missing-key",
        "bevel.spiral.blade_groups",
        &["blade groups"],
    ),
    (
        "cutter_radius = 63.0",
        "line = \"epicycloid\", blade_groups = 0, cutter_radius = 63.0",
        "invalid-number",
        "bevel.spiral.blade_groups",
        &[">= 1"],
    ),
    (
        "cutter_radius = 63.0",
        "line = \"spiral\"",
        "unknown-value",
        "bevel.spiral.line",
        &["\"circle\", \"epicycloid\""],
    ),
    ("rows = 14", "rows = 14\nlead_through_row = 2", "invalid-job", "milling.lead_through_row", &["[gear]"]),
];

const GRID_CASES: &[Case] = &[
    ("teeth = 41", "teeth = 2", "invalid-number", "grid_gear.teeth", &[">= 3"]),
    ("rows = 7", "rows = 3", "invalid-number", "grid_gear.left.rows", &[">= 4"]),
    ("columns = 13 } # rows", "columns = 2 } # rows", "invalid-number", "grid_gear.right.columns", &[">= 4"]),
    ("radii = [66.58, 92.81]", "radii = [0, 92.81]", "invalid-number", "grid_gear.root.radii[0]", &["radii"]),
    (
        "positions = [26.39, 36.20]",
        "positions = [26.39, 26.39]",
        "invalid-geometry",
        "grid_gear.root.positions[1]",
        &["flatter", "85"],
    ),
    (
        "positions = [20.50, 28.52]",
        "positions = [26.50, 38.52]",
        "invalid-geometry",
        "grid_gear.tip.radii[1]",
        &["95.68", "outside of the root body"],
    ),
    ("left = {", "# left = {", "missing-key", "grid_gear.left", &[]),
    ("tolerance_um = 10.0", "modifications = []", "invalid-job", "target.modifications", &["[bevel]"]),
    ("[target]", "[mate]\nteeth = 20\n[target]", "invalid-job", "mate", &["[bevel]"]),
];

const MATE_CASES: &[Case] = &[
    ("teeth = 35", "teeth = 2", "invalid-number", "mate.teeth", &[">= 3"]),
    ("teeth = 35", "teeth = 39", "invalid-job", "mate.teeth", &["39", "<= 38.0"]),
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
    ("teeth = 35\n", "# teeth\n", "missing-key", "mate.teeth", &["number of teeth"]),
    (
        "teeth = 35",
        "teeth = 35\ncentre_distance = 100.0",
        "invalid-job",
        "mate.centre_distance",
        &["bevel gear"],
    ),
    (
        "kind = \"profile_crowning\", amount_um = 6.0",
        "kind = \"profile_crowning\", amount_um = inf",
        "invalid-number",
        "mate.modifications[0].amount_um",
        &["inf"],
    ),
];

const CYLINDRICAL_MATE_CASES: &[Case] = &[
    (
        "centre_distance = 201.2",
        "# centre_distance = 201.2",
        "missing-key",
        "mate.centre_distance",
        &["centre distance"],
    ),
    ("centre_distance = 201.2", "centre_distance = -1", "invalid-number", "mate.centre_distance", &["> 0"]),
    (
        "centre_distance = 201.2",
        "centre_distance = 201.2\nteeth = 30",
        "invalid-job",
        "mate.teeth",
        &["cylindrical gear"],
    ),
    (
        "centre_distance = 201.2",
        "centre_distance = 201.2\nease_off = { profile_um = 2 }",
        "invalid-job",
        "mate.ease_off",
        &["cylindrical gear"],
    ),
    (
        "teeth = 30, normal_module = 8.0, normal_pressure_angle_deg = 20.0, helix_angle_deg = 0.0",
        "teeth = 30, normal_module = 8.0, normal_pressure_angle_deg = 20.0, helix_angle_deg = 12.0",
        "invalid-job",
        "mate.gear.helix_angle_deg",
        &["12", "helix"],
    ),
    (
        "teeth = 30, normal_module = 8.0",
        "teeth = 30, normal_module = 7.5",
        "invalid-job",
        "mate.gear.normal_module",
        &["8"],
    ),
    ("tip_diameter = 256.0", "tip_diameter = 210.0", "invalid-geometry", "mate.gear.tip_diameter", &["210"]),
];

/// A blade of four-digit sections in place of the ruled one.
fn naca_blade() -> String {
    let text = ruled();
    let lines = text.lines().filter(|line| !line.starts_with("ruled") && !line.starts_with("thickness"));
    let lines = lines.map(|line| match line.starts_with("active_height") {
        true => format!("{line}\n{NACA}\n"),
        false => line.to_owned() + "\n",
    });
    lines.collect()
}

const NACA: &str = "naca = { sections = [\"4412\", \"4408\"], chord = [50.0, 45.0], stagger_deg = [25.0, 40.0], tip_radius = 90.0, side = \"upper\" }";

const NACA_CASES: &[Case] = &[
    ("\"4412\"", "\"4012\"", "unknown-value", "blade.naca.sections[0]", &["4012", "four digits"]),
    ("\"4408\"", "\"44a8\"", "unknown-value", "blade.naca.sections[1]", &["44a8", "\"0012\""]),
    ("[50.0, 45.0]", "[50.0, 0]", "invalid-number", "blade.naca.chord[1]", &["chords"]),
    ("[25.0, 40.0]", "[25.0, 81.0]", "invalid-number", "blade.naca.stagger_deg[1]", &["81", "<= 80"]),
    ("tip_radius = 90.0", "tip_radius = 50.0", "invalid-geometry", "blade.naca.tip_radius", &["50", "> 55"]),
    (
        "side = \"upper\"",
        "side = \"left\"",
        "unknown-value",
        "blade.naca.side",
        &["left", "\"upper\", \"lower\""],
    ),
    (
        "side = \"upper\"",
        "side = \"upper\", edge = 0.4",
        "invalid-number",
        "blade.naca.edge",
        &["0.4", "<= 0.3"],
    ),
    ("count = 9", "count = 9\nthickness = [4.0, 2.0]", "invalid-job", "blade.thickness", &["[4, 2]", "naca"]),
];

const BLADE_CASES: &[Case] = &[
    (
        "[cutter]",
        "[compensation]\nmodifications = []\n[cutter]",
        "invalid-job",
        "compensation",
        &["[gear]", "[bevel]"],
    ),
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
    ("ruled = {", "# ruled = {", "missing-key", "blade.ruled", &["ruled, points, naca"]),
    (
        "ruled = {",
        "points = { file = \"b.csv\", rows = 9, columns = 9, side = \"left\" }\nruled = {",
        "invalid-job",
        "blade.points",
        &["exactly one of ruled, points, naca"],
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
