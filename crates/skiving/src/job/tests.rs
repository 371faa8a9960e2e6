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
    const LEFT_OUT: [&str; 10] = [
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
        "tilt_x_deg = 46.0 #",
        "invalid-number",
        "light_barrier.tilt_x_deg",
        &["45"],
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
        ],
    );
}
