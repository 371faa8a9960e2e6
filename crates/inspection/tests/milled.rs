//! A measured gear for a job of five-axis milling: judged by target and class, what its teeth share taken off by the compensation, measured
//! again by the target alone; and workpieces that are not measured so.

use crate::measured_parts::MadePart;
use foundation::geometry::Sides;
use foundation::modification::ModificationSpec;
use foundation::numerics::Silent;
use inspection::workflow::{
    GearInspection, SheetOptions, Statements, inspect_for_milling, write_gear_inspection,
};
use job::{Source, parse_job_of};
use milling::job::{LoadedMillingJob, MillingJob};
use run::{JobFailure, RunFailure};
use std::path::Path;
use verdict::Status;

const JOB: &str = r#"
[job]
name = "milled"
process = "five-axis-milling"
[gear]
teeth = 23
normal_module = 2.0
normal_pressure_angle_deg = 20.0
helix_angle_deg = 0.0
profile_shift = 0.1
face_width = 20.0
tip_diameter = 49.2
root_diameter = 41.4
form_diameter = 44.6
evaluation = { start_diameter = 44.85, end_diameter = 48.76, z_start = -9.0, z_end = 9.0 }
[target]
tolerance_um = 8.0
[cutter]
shape = "end-mill"
diameter = 1.0
corner_radius = 0.3
cutting_length = 5.0
[milling]
rows = 12
columns = 9
contact_height = 1.0
feed_mm_per_min = 600.0
spindle_rpm = 20000.0
[simulation]
rays_profile = 9
rays_length = 3
"#;

fn job(text: &str) -> LoadedMillingJob {
    parse_job_of::<MillingJob>(Source::new(if text.starts_with('{') { "job.json" } else { "job.toml" }, text))
        .unwrap_or_else(|error| panic!("{error}"))
}

/// A part whose left flank rises by 25 um over the evaluated face on every tooth.
fn written(folder: &Path) -> std::path::PathBuf {
    let part = MadePart { helix_slope: Sides { left: 25.0, right: 1.0 }, ..MadePart::new("part 1", 11) };
    let file = folder.join("part.mka");
    std::fs::write(&file, part.text()).expect("a file");
    file
}

fn inspected(job: &LoadedMillingJob, file: &Path, class: Option<i32>) -> Result<GearInspection, JobFailure> {
    inspect_for_milling(job, file, &Statements::default(), class, &Silent)
}

fn told(failure: &JobFailure) -> String {
    match failure {
        JobFailure::Job(RunFailure::BadInput(finding) | RunFailure::NotProducible(finding)) => {
            format!("{} {:?}: {}", finding.code, finding.field, finding.message)
        }
        JobFailure::File(error) => error.to_string(),
    }
}

#[test]
fn what_teeth_share_is_taken_off_and_the_target_stays() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = written(folder.path());
    let loaded = job(JOB);
    let found = inspected(&loaded, &file, None).unwrap_or_else(|failure| panic!("{}", told(&failure)));
    let round = &found.rounds[0].result;
    let largest = round.flanks["left"].measured.largest_um;
    assert!((10.0..20.0).contains(&largest), "{largest}");
    assert_eq!(found.result.verdict.reason().map(|reason| reason.code), Some("tolerance-exceeded"));
    let correction = round.correction.as_ref().expect("a correction");
    let left = &correction.proof["left"];
    assert!(left.after.rms_um < 0.2 * left.before.rms_um, "{left:?}");
    // It goes the other way by what the helix rises.
    let corrected = found.rounds[0].corrected_milling.as_ref().expect("a job");
    let tables = &corrected.job.compensation.as_ref().expect("a compensation").modifications;
    assert_eq!(tables.len(), 2);
    let ModificationSpec::Grid(grid) = &tables[0] else { panic!("{tables:?}") };
    let middle = &grid.f_um[grid.w_mm.len() / 2];
    let rise = middle[grid.z_mm.len() - 1] - middle[0];
    assert!((rise + 25.0).abs() < 2.5, "{rise}");
    // Judged by the corrected job the same part is as far off, and needs no further correction of its model.
    let again = inspected(corrected, &file, None).unwrap_or_else(|failure| panic!("{}", told(&failure)));
    let same = again.rounds[0].result.flanks["left"].measured.largest_um;
    assert!((same - largest).abs() < 1e-6, "{same} {largest}");
    let out = folder.path().join("out");
    write_gear_inspection(&found, &SheetOptions::default(), &out).expect("written files");
    let text = std::fs::read_to_string(out.join("corrected-job.json")).expect("a job");
    let read = job(&text);
    assert_eq!(read.job.compensation, corrected.job.compensation);
    let page = std::fs::read_to_string(out.join("report.html")).expect("a report");
    assert!(page.contains("off the flank that its paths are planned on"), "the correction");
}

#[test]
fn a_class_is_judged_with_its_pitches() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = written(folder.path());
    for (class, kept) in [(11, true), (5, false)] {
        let found =
            inspected(&job(JOB), &file, Some(class)).unwrap_or_else(|failure| panic!("{}", told(&failure)));
        assert_eq!(found.result.tolerance_class, Some(class));
        let judged: Vec<&str> = found.result.verdict.judged().iter().map(|item| item.item.as_str()).collect();
        for wanted in ["left flank, profile", "left flank, helix", "right flank, pitch"] {
            assert!(judged.contains(&wanted), "{judged:?}");
        }
        let missed = found
            .result
            .verdict
            .judged()
            .iter()
            .any(|item| item.item == "left flank, helix" && item.status == Status::Missed);
        assert_eq!(missed, !kept);
    }
    let wrong = inspected(&job(JOB), &file, Some(30)).err().expect("no such class");
    let JobFailure::Job(RunFailure::BadInput(finding)) = wrong else { panic!("another failure") };
    assert_eq!(finding.field.as_deref(), Some("class"));
}

#[test]
fn other_gears_and_workpieces_are_refused_at_their_keys() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = written(folder.path());
    let refused = |text: &str| match inspected(&job(text), &file, None) {
        Err(JobFailure::Job(RunFailure::BadInput(finding))) => {
            (finding.code, finding.field.clone().unwrap_or_default())
        }
        _ => panic!("it is taken"),
    };
    let other = JOB.replace("teeth = 23", "teeth = 24").replace("tip_diameter = 49.2", "tip_diameter = 51.2");
    let other = other.replace("root_diameter = 41.4", "root_diameter = 43.4").replace("44.6", "46.6");
    let other = other.replace(
        "start_diameter = 44.85, end_diameter = 48.76",
        "start_diameter = 46.85, end_diameter = 50.76",
    );
    assert_eq!(refused(&other), ("other-gear", "gear.teeth".into()));
    let halves =
        JOB.replace("helix_angle_deg = 0.0", "helix_angle_deg = 20.0\ndouble_helical = { gap = 4.0 }");
    let halves = halves
        .replace("tip_diameter = 49.2", "tip_diameter = 52.0")
        .replace("root_diameter = 41.4", "root_diameter = 44.0");
    let halves = halves.replace("form_diameter = 44.6", "form_diameter = 47.5").replace(
        "evaluation = { start_diameter = 44.85, end_diameter = 48.76, z_start = -9.0, z_end = 9.0 }\n",
        "",
    );
    assert_eq!(refused(&halves), ("invalid-job", "gear.double_helical".into()));
    let asymmetric = JOB.replace(
        "normal_pressure_angle_deg = 20.0",
        "normal_pressure_angle_deg = { left = 20.0, right = 18.0 }",
    );
    assert_eq!(refused(&asymmetric), ("invalid-job", "gear.normal_pressure_angle_deg".into()));
}
