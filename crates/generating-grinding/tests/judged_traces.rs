//! Drawings that judge traces (`target.judged = "traces"`), and radial feed with edges.

use super::truck_gear::TRUCK_GEAR;
use foundation::numerics::Silent;
use generating_grinding::job::Job;
use generating_grinding::workflow::{JobResult, plan_job};
use job::{Source, parse_job_of};
use verdict::Status;

/// A truck gear; radial feed leaves 3.8 um of twist at the corners of its crowning of 12 um.
fn truck(judged: &str, grinding: &str) -> JobResult {
    relieved("", judged, grinding)
}

/// The same with more than the crowning.
fn relieved(relief: &str, judged: &str, grinding: &str) -> JobResult {
    planned(&format!(
        r#"
[job]
name = "traces"
process = "generating-grinding"
{TRUCK_GEAR}
[target]
tolerance_um = 2.0
modifications = [{{ kind = "helix_crowning", amount_um = 12.0 }}{relief}]
{judged}
[worm]
threads = 3
tip_diameter = 280.0
width = 160.0
[dresser]
tip_diameter = 123.0
[grinding]
feed_per_revolution = 0.4
{grinding}
[grid]
profile_points = 11
helix_points = 21
"#
    ))
}

fn planned(text: &str) -> JobResult {
    let loaded = parse_job_of::<Job>(Source::new("job.toml", text)).unwrap_or_else(|e| panic!("{e}"));
    plan_job(&loaded, &Silent).unwrap_or_else(|e| panic!("{e:?}")).result
}

const RADIAL: &str = "method = \"radial\"";

#[test]
fn a_twist_that_no_trace_shows_is_no_miss() {
    assert_eq!(truck("", RADIAL).verdict.status(), Status::Missed);
    let wide = truck("judged = \"traces\"\ntraces = { beside_um = 5.0 }", RADIAL);
    assert_eq!(wide.verdict.status(), Status::Met, "{:?}", wide.verdict.reason());
    let left = wide.verdict.judged().iter().find(|one| one.item == "left flank").unwrap();
    assert!(left.detail.contains("profile traces at z = 0 mm; 5 um beside"), "{left:?}");
    assert!(wide.flanks["left"].max_deviation_um > 2.0);
    // The band beside the traces is judged too, and so are traces where the twist shows.
    let narrow = truck("judged = \"traces\"\ntraces = { beside_um = 3.0 }", RADIAL);
    assert_eq!(narrow.verdict.status(), Status::Missed);
    let outer =
        truck("judged = \"traces\"\ntraces = { profile_z_mm = [-20.0, 20.0], beside_um = 5.0 }", RADIAL);
    assert_eq!(outer.verdict.status(), Status::Missed);
}

#[test]
fn the_least_worm_is_none_where_the_twist_is_not_judged() {
    let traces = "judged = \"traces\"\ntraces = { beside_um = 8.0 }";
    let result = truck(traces, "method = \"diagonal\"");
    assert_eq!(result.verdict.status(), Status::Met, "{:?}", result.verdict.reason());
    assert_eq!(result.settings.settings.diagonal_ratio, 0.0);
    let field = truck("", "method = \"diagonal\"");
    assert_eq!(field.verdict.status(), Status::Met);
    assert!(field.settings.settings.diagonal_ratio.abs() > 0.1);
}

#[test]
fn a_fit_keeps_to_the_traces() {
    let relief = |judged: &str| {
        let end = ", { kind = \"end_relief_I\", amount_um = 30.0, length_mm = 6.0 }";
        relieved(end, judged, "method = \"diagonal\"")
    };
    let result = relief("judged = \"traces\"\ntraces = { beside_um = 8.0 }");
    assert_eq!(result.verdict.status(), Status::Met, "{:?}", result.verdict.reason());
    let worm = |of: &JobResult| of.settings.worm_length_mm;
    assert!(worm(&result) < worm(&relief("")), "less is judged: less worm does");
}

#[test]
fn radial_feed_makes_end_reliefs_of_a_spur_gear() {
    let result = planned(
        r#"
[job]
name = "spur"
process = "generating-grinding"
[gear]
teeth = 24
normal_module = 3.0
normal_pressure_angle_deg = 20.0
helix_angle_deg = 0.0
profile_shift = 0.0
face_width = 25.0
tip_diameter = 78.0
root_diameter = 64.5
form_diameter = 68.2
[target]
tolerance_um = 2.0
modifications = [
  { kind = "helix_crowning", amount_um = 8.0 },
  { kind = "end_relief_I", amount_um = 15.0, length_mm = 6.0 },
  { kind = "end_relief_II", amount_um = 15.0, length_mm = 6.0 },
]
[worm]
threads = 2
tip_diameter = 250.0
width = 125.0
[dresser]
tip_diameter = 123.0
[grinding]
method = "radial"
feed_per_revolution = 0.3
"#,
    );
    assert_eq!(result.verdict.status(), Status::Met, "{:?}", result.verdict.reason());
    assert!(result.flanks.values().all(|f| f.max_deviation_um < 1.0 && f.model_difference_um < 0.05));
}
