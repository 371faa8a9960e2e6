//! Tool, holder and spindle against what clamps a milled workpiece. Expected distances follow from the radii of root and nut.

use crate::milling_example::example;
use foundation::numerics::Silent;
use job::machine::read_machine;
use milling::workflow::{MillingCheck, MillingOutcome, run_milling};
use std::path::Path;
use verdict::Status;

/// A spur gear with a root radius of 70 mm and a face of 12 mm, and a nut of this diameter beside its face.
fn changes(diameter: f64, kept: f64) -> Vec<(&'static str, String)> {
    vec![
        ("face_width = 60.0", "face_width = 12.0".into()),
        ("rays_length = 11", "rays_length = 5".into()),
        ("traverse = \"zigzag\"", "traverse = \"zigzag\"\nteeth = \"one\"".into()),
        (r#"programs = ["linuxcnc", "siemens", "fanuc"]"#, r#"programs = ["siemens"]"#.into()),
        (
            "tool_length = 100.0",
            format!(
                "tool_length = 100.0\nbody_clearance = {kept:?}\n\
                 clamping = [{{ name = \"clamping nut\", z = [7.0, 25.0], diameter = {diameter:?} }}]"
            ),
        ),
    ]
}

fn job(diameter: f64, kept: f64) -> milling::job::LoadedMillingJob {
    let changes = changes(diameter, kept);
    let changes: Vec<(&str, &str)> = changes.iter().map(|(from, to)| (*from, to.as_str())).collect();
    example("spur-on-ac-table", &changes)
}

fn run(diameter: f64, kept: f64) -> MillingOutcome {
    run_milling(&job(diameter, kept), &Silent).unwrap()
}

#[test]
fn a_thin_nut_passes_with_its_least_distance() {
    let outcome = run(120.0, 1.0);
    let verdict = &outcome.result.verdict;
    assert_eq!(verdict.status(), Status::Met, "{:?}", verdict.reason());
    let part = &outcome.texts.parts[0];
    let [nearest] = part.clamping.as_slice() else { panic!("{:?}", part.clamping) };
    // The bottom of the root is milled 70 mm from the axis, and the overrun takes the cutter above the nut. A distance is never said greater
    // than it is.
    assert!((9.97..10.001).contains(&nearest.least_mm), "{nearest:?}");
    assert!(part.statement.contains("against clamping nut"), "{}", part.statement);
    assert!(!part.not_covered.iter().any(|left| left.contains("clamping")), "{:?}", part.not_covered);
    let judged = verdict.judged().iter().any(|one| one.item.contains("against the clamping"));
    assert!(judged, "{verdict:?}");
}

#[test]
fn a_nut_in_the_way_misses_the_target_and_is_found_in_a_text() {
    let thin = run(120.0, 1.0);
    let text = &thin.texts.programs.as_ref().unwrap().programs[0];
    for (diameter, kept, words) in [(150.0, 1.0, "run into clamping nut"), (139.0, 1.0, "mm of clamping nut")]
    {
        let outcome = run(diameter, kept);
        let verdict = &outcome.result.verdict;
        assert_eq!(verdict.status(), Status::Missed);
        let reason = verdict.reason().unwrap();
        assert_eq!(reason.code, "bodies-too-close");
        assert!(reason.text.contains(words) && reason.text.contains("machine.clamping[0]"), "{reason:?}");
        // The text that was planned beside a thin nut, held against the job with this one.
        let thick = job(diameter, kept);
        let machine = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../machines/five-axis-ac-table.toml");
        let machine = read_machine(&machine).unwrap();
        let check = MillingCheck::new(&thick, &machine, &Silent).unwrap();
        let checked = check.check(text.written.text.as_bytes(), text.dialect, &Silent).unwrap();
        let remark = checked.remarks.iter().find(|remark| remark.code == "bodies-too-close").unwrap();
        assert!(remark.text.starts_with("block "), "{remark:?}");
    }
    // Half a millimetre is enough where the job says so.
    assert_eq!(run(139.0, 0.3).result.verdict.status(), Status::Met);
}
