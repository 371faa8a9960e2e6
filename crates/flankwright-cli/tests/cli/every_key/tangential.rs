//! The walk of tangential dressing. Its jobs are small: a narrow gear, few points, one thread.

use super::of_files::FileWalk;
use super::title_block;
use serde_json::{Value, json};

/// Keys that change nothing.
const EXCEPTIONS: [(&str, &str); 10] = [
    ("job.name", "a name"),
    ("job.description", "a comment"),
    ("job.process", "says which keys there are"),
    ("machine.file", "the name of a file; without it the job is refused"),
    ("control.servo.disturbances.kind", "says which keys there are"),
    ("target.modifications", "their own keys are walked once for all processes"),
    ("settings.both.splines.intervals", "must fit the number of coefficients, or the job is refused"),
    ("settings.left.splines.intervals", "must fit the number of coefficients, or the job is refused"),
    ("settings.right.splines.intervals", "must fit the number of coefficients, or the job is refused"),
    (
        "output.meshes",
        "not written by this version, which a warning tells; which of them makes no difference",
    ),
];

/// Words.
fn values() -> Vec<(&'static str, Value)> {
    let mut values = title_block();
    values.extend([
        ("worm.hand", json!("right")),
        ("dresser.profile", json!("straight")),
        ("dressing.passes", json!("one")),
        ("dressing.variables", json!("Fp5")),
        ("dressing.variables", json!("source")),
        ("dressing.exclude", json!("FC")),
        ("dressing.method", json!("gauss-newton")),
        ("dressing.method", json!("damped")),
        ("dressing.method", json!("svd")),
        ("dressing.measure", json!("arc")),
        ("dressing.weights", json!("source")),
        ("dressing.splines.channel", json!("dA")),
        ("control.feed.counter_limit", json!(3)),
        ("control.feed.mode", json!("one-way")),
        ("control.feed_senses", json!("one")),
        ("control.workpiece.rate", json!("bresenham")),
        ("control.servo.disturbances.axis", json!("worm")),
        ("grinding.flanks", json!("left")),
        ("grinding.shift_ratio", json!(1.3)),
        ("output.programs", json!("siemens")),
        ("machine.clamping.name", json!("centre")),
        ("output.tables", json!("parquet")),
        ("settings.both.splines.channel", json!("dA")),
        ("settings.left.splines.channel", json!("dA")),
        ("settings.right.splines.channel", json!("dA")),
    ]);
    values
}

#[test]
fn every_key_of_tangential_dressing_counts() {
    let (ignored, missing) = FileWalk {
        definition: "TangentialJob",
        folder: "tangential",
        exceptions: &EXCEPTIONS,
        values: values(),
        echoes: &["job", "version", "timing_s", "tolerance_um"],
    }
    .run();
    assert!(ignored.is_empty(), "without effect: {ignored:?}");
    assert!(missing.is_empty(), "in no job of the walk: {missing:?}");
}
