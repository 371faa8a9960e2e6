//! The walk of measuring a skiving tool.

use super::of_files::FileWalk;
use super::title_block;
use serde_json::{Value, json};

/// Keys that change nothing.
const EXCEPTIONS: [(&str, &str); 13] = [
    (
        "machine.carrier.axis",
        "names the axis that carries the barrier; any other is refused, as it moves the other body",
    ),
    (
        "machine.carrier.measuring",
        "no shipped machine has a carrier that slides; walked in the programs of skiving tools",
    ),
    (
        "machine.carrier.parked",
        "no shipped machine has a carrier that slides; walked in the programs of skiving tools",
    ),
    (
        "gear.measured_over.roll_diameter",
        "no straight roll lies in the spaces of a helical ring; walked in generating grinding",
    ),
    ("job.name", "a name"),
    ("job.description", "a comment"),
    ("job.process", "says which keys there are"),
    ("machine.file", "the name of a file; without it the job is refused"),
    ("history.file", "the name of a file; without it the job is refused"),
    ("history.time", "orders the lines of the history; another one at the same time is refused"),
    ("workpiece_probe.readings", "the name of a file; without it the measurement is simulated"),
    ("readings.file", "the name of a file; without it the job is refused"),
    ("target.modifications", "their own keys are walked once for all processes"),
];

/// Words, and limits near what the jobs need.
fn values() -> Vec<(&'static str, Value)> {
    let mut values = title_block();
    values.extend([
        ("measuring.poses", json!("along-flank")),
        ("measuring.senses", json!("positive")),
        ("measuring.senses", json!("negative")),
        ("measuring.travel.a_deg", json!(29.0)),
        ("measuring.travel.x", json!(499.0)),
        ("measuring.travel.y", json!(199.0)),
        ("measuring.travel.z", json!(399.0)),
        ("evaluation.settings", json!("tool-shift")),
        ("evaluation.settings", json!("crossed-axes-angle")),
        ("evaluation.limits.tool_angle_deg", json!(1e-7)),
        ("skiving_tool.rake.form", json!("cone")),
        ("skiving.kinematics", json!("skiving")),
        ("runout.law", json!("coupling")),
        ("machine.carrier.measuring_deg", json!(80.0)),
        ("machine.carrier.parked_deg", json!(10.0)),
        ("stylus.axes", json!("without-y")),
        ("calibration.switches.along", json!("X")),
        ("calibration.switches.along", json!("Y")),
        ("output.programs", json!("siemens")),
        ("output.tables", json!("parquet")),
        ("history.tool", json!("other")),
    ]);
    values
}

#[test]
fn every_key_of_measuring_a_skiving_tool_counts() {
    let (ignored, missing) = FileWalk {
        definition: "SkivingJob",
        folder: "skiving",
        exceptions: &EXCEPTIONS,
        values: values(),
        echoes: &["job", "version", "timing_s", "time_s", "tolerance_um"],
    }
    .run();
    assert!(ignored.is_empty(), "without effect: {ignored:?}");
    assert!(missing.is_empty(), "in no job of the walk: {missing:?}");
}
