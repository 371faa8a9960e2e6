//! Jobs of measuring a skiving tool as they are read: defaults, alternatives, and the message for each that is wrong.

use super::{MachineSetting, MeasuringPoses, Senses, SkivingJob, ToolEvaluation, ToolMeasuring};
use job::testing::{Case, assert_found};
use job::{ProcessJob, Source, parse_job_of};

fn template() -> &'static str {
    SkivingJob::TEMPLATE
}

fn sound(text: &str) -> SkivingJob {
    parse_job_of(Source::new("job.toml", text))
        .unwrap_or_else(|error| {
            panic!(
                "{error}
{text}"
            )
        })
        .job
}

/// The lines that stand behind a mark taken in, but for those that contradict others.
fn with_everything() -> String {
    const LEFT_OUT: [&str; 12] = [
        "rake = {",
        "direction",
        "machine_name",
        "normal_tooth_thickness",
        "span",
        "over_balls",
        "cone_angle_deg",
        "modifications",
        "switching_radius",
        "[readings]",
        "file = \"readings.csv\"",
        "pitch_um",
    ];
    let line = |line: &str| {
        let entry = line.strip_prefix("# ").filter(|rest| {
            let begins = rest.starts_with('[') || rest.contains(" = ");
            let sentence = rest.contains(". ") && !rest.contains('=');
            begins && !sentence && !LEFT_OUT.iter().any(|key| rest.starts_with(key))
        });
        entry.unwrap_or(line).to_owned() + "\n"
    };
    template().lines().map(line).collect()
}

#[test]
fn what_stands_behind_a_mark_is_valid_as_well() {
    let job = sound(&with_everything());
    assert!(job.calibration.is_some() && job.stylus.is_some() && job.monte_carlo.is_some());
    assert!(job.history.is_some() && job.machine.is_some());
    assert_eq!(job.skiving.crossed_axes_angle_deg, Some(20.0));
    assert_eq!(job.measuring.travel.ends().count(), 4);
    assert_eq!(job.tool_errors.unwrap().teeth[0].tooth, 17);
}

#[test]
fn what_is_left_out_is_usual() {
    let text = template();
    let [from, to] = ["\n[measuring]", "\n[tool_errors]"].map(|table| text.find(table).unwrap());
    let job = sound(&(text[..from].to_owned() + &text[to..]));
    assert_eq!(job.measuring, ToolMeasuring::default());
    assert_eq!(job.evaluation, ToolEvaluation::default());
    assert_eq!((job.measuring.senses, job.measuring.poses), (Senses::Both, MeasuringPoses::Tangent));
    assert_eq!(job.measuring.tracks, [-0.8, -0.4, 0.0, 0.4, 0.8]);
    assert_eq!(job.evaluation.settings.last(), Some(&MachineSetting::ToolAngle));
    // What the template writes out are the same values.
    assert_eq!(sound(text).measuring, job.measuring);
    assert_eq!(sound(text).evaluation.limits, job.evaluation.limits);
}

const CASES: &[Case] = &[
    ("teeth = 41", "teeth = 2", "invalid-number", "skiving_tool.teeth", &["3 or more"]),
    ("teeth = -85", "teeth = -2", "invalid-geometry", "gear.teeth", &["3 or more"]),
    ("# cone_angle_deg = 0.0", "cone_angle_deg = 2.0", "not-yet-supported", "gear.cone_angle_deg", &["0"]),
    (
        "helix_angle_deg = 0.0 ",
        "helix_angle_deg = 61.0 ",
        "invalid-number",
        "skiving_tool.helix_angle_deg",
        &["60"],
    ),
    (
        "# kinematics = \"skiving\"              #",
        "kinematics = \"shaping\" #",
        "invalid-job",
        "evaluation.settings[1]",
        &["settings = [\"centre-distance\", \"tool-angle\"]"],
    ),
    (
        "# kinematics = \"skiving\"              #",
        "crossed_axes_angle_deg = 20.0\nkinematics = \"shaping\" #",
        "invalid-job",
        "skiving.crossed_axes_angle_deg",
        &["20", "no key"],
    ),
    (
        "# kinematics = \"skiving\"              #",
        "kinematics = \"shapping\" #",
        "unknown-value",
        "skiving.kinematics",
        &["did you mean \"shaping\""],
    ),
    ("edge_radius = 0.03", "edge_radius = nan", "invalid-number", "skiving_tool.edge_radius", &["NaN"]),
    (
        "form = \"plane\"",
        "form = \"plain\"",
        "unknown-value",
        "skiving_tool.rake.form",
        &["did you mean \"plane\""],
    ),
    (
        "form = \"plane\", angle_deg = 5.0, step_angle_deg = 0.0",
        "form = \"cone\", angle_deg = 5.0, step_angle_deg = 1.0",
        "invalid-job",
        "skiving_tool.rake.step_angle_deg",
        &["planes"],
    ),
    (
        "step_angle_deg = 0.0 }",
        "hollow_deg_per_mm = 1.0 }",
        "invalid-job",
        "skiving_tool.rake.hollow_deg_per_mm",
        &["form = \"variable\""],
    ),
    (
        "form = \"plane\"",
        "form = \"variable\"",
        "invalid-job",
        "skiving_tool.rake.form",
        &["is a plane", "twist_deg_per_mm"],
    ),
    (
        "step_angle_deg = 0.0 }",
        "height_deg_per_mm = 20.1 }",
        "invalid-number",
        "skiving_tool.rake.height_deg_per_mm",
        &["20", "per mm of height"],
    ),
    (
        "step_angle_deg = 0.0 }",
        "height_deg_per_mm2 = -10.1 }",
        "invalid-number",
        "skiving_tool.rake.height_deg_per_mm2",
        &["-10", "square millimetre"],
    ),
    (
        "step_angle_deg = 0.0 }",
        "twist_deg_per_mm = nan }",
        "invalid-number",
        "skiving_tool.rake.twist_deg_per_mm",
        &["20", "per mm of height"],
    ),
    (
        "form = \"plane\", angle_deg = 5.0",
        "form = \"sphere\", angle_deg = -5.0",
        "invalid-job",
        "skiving_tool.rake.angle_deg",
        &["above 0"],
    ),
    (
        "radius = 0.05                         #",
        "radius = 0.0                         #",
        "invalid-number",
        "light_barrier.radius",
        &["> 0"],
    ),
    (
        "# tilt_x_deg = 0.0                    #",
        "tilt_x_deg = 90.0 #",
        "invalid-number",
        "light_barrier.tilt_x_deg",
        &["< 90", "direction"],
    ),
    (
        "# direction = [0.0, 0.9, 0.4]         #",
        "direction = [0.0, 0.0, 0.0] #",
        "invalid-job",
        "light_barrier.direction",
        &["not 0", "[0, 0, 0]"],
    ),
    (
        "# direction = [0.0, 0.9, 0.4]         #",
        "direction = [0.0, 1001.0, 0.4] #",
        "invalid-number",
        "light_barrier.direction[1]",
        &["1000", "vector along the beam"],
    ),
    (
        "# direction = [0.0, 0.9, 0.4]         #",
        "direction = [0.0, 0.9] #",
        "invalid-list",
        "light_barrier.direction",
        &["3"],
    ),
    (
        "# direction = [0.0, 0.9, 0.4]         #",
        "tilt_y_deg = 3.0\ndirection = [0.0, 0.9, 0.4] #",
        "invalid-job",
        "light_barrier.tilt_y_deg",
        &["twice", "leave the tilt"],
    ),
    ("-0.8, -0.4, 0.0", "-0.8, -0.4, -0.4", "invalid-job", "measuring.tracks[2]", &["ascend", "> -0.4"]),
    ("-0.8, -0.4, 0.0", "-1.8, -0.4, 0.0", "invalid-number", "measuring.tracks[0]", &["-1"]),
    (
        "# travel = { a_deg = [-30.0, 30.0], x = [0.0, 500.0]",
        "travel = { a_deg = [-30.0, 30.0], x = [500.0, 0.0]",
        "invalid-job",
        "measuring.travel.x",
        &["no length"],
    ),
    (
        "# switching_radius = 0.0495           #",
        "switching_radius = 0.0495 #",
        "invalid-job",
        "evaluation.switching_radius",
        &["both senses"],
    ),
    (
        "\"tool-angle\"]",
        "\"tool-angel\"]",
        "unknown-value",
        "evaluation.settings[2]",
        &["did you mean \"tool-angle\""],
    ),
    (
        "# pitch_um = []                       #",
        "pitch_um = [1.0, 2.0] #",
        "invalid-job",
        "tool_errors.pitch_um",
        &["41 entries"],
    ),
    (
        "# teeth = [ { tooth = 17",
        "teeth = [ { tooth = 41",
        "invalid-job",
        "tool_errors.teeth[0].tooth",
        &["0 to 40"],
    ),
    (
        "# teeth = [ { tooth = 17",
        "teeth = [ { tooth = 3 }, { tooth = 3",
        "invalid-job",
        "tool_errors.teeth[1].tooth",
        &["twice"],
    ),
    (
        "# [readings]                          # a real measurement instead of [tool_errors]\n# file",
        "[readings]\nfile",
        "invalid-job",
        "readings.file",
        &["[tool_errors]"],
    ),
    ("programs = []", "programs = [\"fanuc\"]", "invalid-job", "output.programs", &["[machine]"]),
    ("revolutions = 4", "revolutions = 0", "invalid-number", "measuring.revolutions", &["e.g. 4"]),
    ("speed_rpm = 120.0", "speed_rpmm = 120.0", "unknown-key", "measuring.speed_rpmm", &["speed_rpm"]),
];

#[test]
fn every_case_is_found() {
    assert_found::<SkivingJob>(template(), CASES);
}

#[test]
fn tables_that_need_something_else_say_so() {
    let all = with_everything();
    assert_found::<SkivingJob>(
        &all,
        &[
            (
                "heights = [140.0, 240.0]",
                "heights = [140.0, 140.0]",
                "invalid-job",
                "calibration.heights",
                &["tilt"],
            ),
            (
                "switches = []",
                "switches = [ { along = \"X\", place = [1.0, 2.0, 3.0] } ]",
                "invalid-job",
                "calibration.switches",
                &["five unknowns"],
            ),
            (
                "edge_radius = 0.03",
                "edge_radius = 0.0",
                "invalid-job",
                "skiving_tool.edge_radius",
                &["chamfers"],
            ),
            ("teeth = [0, 14, 28]", "teeth = [0, 14, 50]", "invalid-job", "stylus.teeth[2]", &["0 to 40"]),
            ("teeth = [0, 14, 28]", "teeth = [0, 14]", "invalid-list", "stylus.teeth", &["3"]),
        ],
    );
    assert_found::<SkivingJob>(
        &all,
        &[
            ("2026-03-01T09:30:00Z", "yesterday", "invalid-job", "history.time", &["RFC 3339"]),
            ("radius = 10.0", "radius = -10.0", "invalid-number", "calibration.radius", &["> 0"]),
            (
                "orders = 1 ",
                "orders = 11 ",
                "invalid-job",
                "runout.orders",
                &["1 to 10", "a quarter of the teeth"],
            ),
            ("orders = 1 ", "orders = 0 ", "invalid-number", "runout.orders", &["1", "eccentric"]),
            ("law = \"both\"", "law = \"booth\"", "unknown-value", "runout.law", &["did you mean \"both\""]),
            (
                "tool_speed_rpm = 600.0",
                "tool_speed_rpm = 0.0",
                "invalid-number",
                "runout.stroke.tool_speed_rpm",
                &["> 0", "1/min"],
            ),
            (
                "feed = 0.2,",
                "feed = 10.5,",
                "invalid-number",
                "runout.stroke.feed",
                &["10", "per turn of the workpiece"],
            ),
            (
                "overrun = 2.0",
                "overrun = -1.0",
                "invalid-number",
                "runout.stroke.overrun",
                &["0", "2 is the default"],
            ),
            (
                "blocks_per_turn = 24",
                "blocks_per_turn = 7",
                "invalid-number",
                "runout.stroke.blocks_per_turn",
                &["8", "24 is the default"],
            ),
            (
                "work_height = 0.0",
                "work_height = 5001.0",
                "invalid-number",
                "runout.stroke.work_height",
                &["5000", "middle of the face"],
            ),
            (
                "measuring_deg = 90.0",
                "measuring_deg = 361.0",
                "invalid-number",
                "machine.carrier.measuring_deg",
                &["360", "degrees"],
            ),
            (
                "parked_deg = 0.0",
                "parked_deg = nan",
                "invalid-number",
                "machine.carrier.parked_deg",
                &["360", "degrees"],
            ),
            (
                "parked_deg = 0.0",
                "parked = 0.0",
                "invalid-job",
                "machine.carrier",
                &["2 places", "measuring_deg and parked_deg"],
            ),
            ("axis = \"V\"", "axis = \"\"", "unknown-value", "machine.carrier.axis", &["1"]),
            (
                "measuring_deg = 90.0, parked_deg = 0.0",
                "measuring = 1e6, parked = 0.0",
                "invalid-number",
                "machine.carrier.measuring",
                &["100000", "mm"],
            ),
            (
                "measuring_deg = 90.0, parked_deg = 0.0",
                "measuring = 0.0, parked = -1e6",
                "invalid-number",
                "machine.carrier.parked",
                &["100000", "mm"],
            ),
            (
                "ball_radius = 0.75",
                "ball_radius = 0.0",
                "invalid-number",
                "workpiece_probe.ball_radius",
                &["> 0", "tooth space"],
            ),
            (
                "length = 150.0",
                "length = 2001.0",
                "invalid-number",
                "workpiece_probe.length",
                &["2000", "centre"],
            ),
            (
                "reach = 0.0 ",
                "reach = 501.0 ",
                "invalid-number",
                "workpiece_probe.reach",
                &["500", "straight probe"],
            ),
            (
                "swivel_deg = 0.0 ",
                "swivel_deg = 181.0 ",
                "invalid-number",
                "workpiece_probe.swivel_deg",
                &["180"],
            ),
            (
                "spindle_deg = 0.0",
                "spindle_deg = nan",
                "invalid-number",
                "workpiece_probe.spindle_deg",
                &["360"],
            ),
            ("gaps = [0, 28, 57]", "gaps = [0, 28]", "invalid-list", "workpiece_probe.gaps", &["3"]),
            (
                "gaps = [0, 28, 57]",
                "gaps = [0, 28, 85]",
                "invalid-job",
                "workpiece_probe.gaps[2]",
                &["0 to 84", "count from 0"],
            ),
            (
                "places = 21",
                "places = 4",
                "invalid-number",
                "workpiece_probe.places",
                &["5", "21 is the default"],
            ),
            (
                "height = 0.0                        #",
                "height = 15.5                        #",
                "invalid-job",
                "workpiece_probe.height",
                &["15", "within the face"],
            ),
            (
                "work_height = 0.0                   #",
                "work_height = -5001.0                   #",
                "invalid-number",
                "workpiece_probe.work_height",
                &["5000"],
            ),
            (
                "clearance = 2.0",
                "clearance = 0.0",
                "invalid-number",
                "workpiece_probe.clearance",
                &["> 0", "2 is the default"],
            ),
            (
                "centre_distance_um = 6.0",
                "centre_distance_um = 1001.0",
                "invalid-number",
                "workpiece_probe.setting_errors.centre_distance_um",
                &["1000"],
            ),
            (
                "crossed_axes_angle_deg = 0.0, tool",
                "crossed_axes_angle_deg = 1.1, tool",
                "invalid-number",
                "workpiece_probe.setting_errors.crossed_axes_angle_deg",
                &["1"],
            ),
            (
                "tool_shift_um = 0.0",
                "tool_shift_um = 5001.0",
                "invalid-number",
                "workpiece_probe.setting_errors.tool_shift_um",
                &["5000"],
            ),
            (
                "tool_angle_deg = 0.002",
                "tool_angle_deg = -1.1",
                "invalid-number",
                "workpiece_probe.setting_errors.tool_angle_deg",
                &["-1"],
            ),
            (
                "clearance = 2.0",
                "clearance = 2.0\nreadings = \"w.csv\"",
                "invalid-job",
                "workpiece_probe.readings",
                &["`readings` or `setting_errors`"],
            ),
            (
                "mandrel_length = 120.0",
                "mandrel_length = 2001.0",
                "invalid-number",
                "calibration.mandrel_length",
                &["2000", "lower face"],
            ),
            (
                "spindle_positions = 2",
                "spindle_positions = 0",
                "invalid-number",
                "calibration.spindle_positions",
                &["1", "average the run-out"],
            ),
            (
                "speed_mm_per_min = 60.0",
                "speed_mm_per_min = 0.0",
                "invalid-number",
                "calibration.speed_mm_per_min",
                &["> 0", "60 is the default"],
            ),
            (
                "reach = 3.0",
                "reach = 0.05",
                "invalid-number",
                "calibration.reach",
                &["0.1", "3 is the default"],
            ),
            ("reach = 3.0", "reach = 11.0", "invalid-job", "calibration.reach", &["10", "thicker mandrel"]),
            (
                "tilt_x_deg = 0.0                    # tilt in",
                "tilt_x_deg = 61.0 #",
                "invalid-job",
                "light_barrier.tilt_x_deg",
                &["60", "lies down"],
            ),
        ],
    );
}
