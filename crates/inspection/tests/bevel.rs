//! A bevel gear measured on its grid for the job by which it was milled: points in space and deviations, what all teeth share, pitches with
//! their classes, the corrected job; and measurements that are refused.

use foundation::geometry::Flank;
use foundation::numerics::Silent;
use inspection::workflow::{BevelInspection, inspect_bevel, write_bevel_inspection};
use job::{Source, parse_job_of};
use milling::job::{LoadedMillingJob, MillingJob};
use milling::workflow::prepare::{MeasuringPoint, prepare_milling};
use nalgebra::{Rotation3, Vector3};
use run::{JobFailure, RunFailure};
use std::f64::consts::TAU;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

const JOB: &str = r#"
[job]
name = "milled"
process = "five-axis-milling"
[bevel]
outer_transverse_module = 5.0
teeth = 16
pitch_cone_angle_deg = 33.690067525979785
face_width = 20.0
[target]
tolerance_um = 8.0
[measuring_grid]
rows = 5
columns = 7
profile_margin = 0.12
length_margin = 0.05
[cutter]
shape = "end-mill"
diameter = 2.4
corner_radius = 0.5
cutting_length = 12.0
[milling]
rows = 8
columns = 9
contact_height = 2.1
feed_mm_per_min = 600.0
spindle_rpm = 18000.0
[simulation]
rays_profile = 5
rays_length = 3
"#;

const TEETH: u32 = 16;
/// Teeth that are measured as surfaces.
const WHOLE: [u32; 4] = [1, 5, 9, 13];

fn job(text: &str) -> LoadedMillingJob {
    let name = if text.starts_with('{') { "job.json" } else { "job.toml" };
    parse_job_of::<MillingJob>(Source::new(name, text)).unwrap_or_else(|error| panic!("{error}"))
}

fn points(job: &LoadedMillingJob) -> Vec<MeasuringPoint> {
    let Ok(prepared) = prepare_milling(job) else { panic!("no bevel gear") };
    prepared.measuring_points
}

/// What the flanks are off, mm: of shares from -1 to 1 over the height and along the tooth.
fn shape(flank: Flank, u: f64, v: f64) -> f64 {
    match flank {
        Flank::Left => 0.010 * v - 0.004 * u + 0.002 * u * v,
        Flank::Right => -0.006 * v - 0.003 * u,
    }
}

/// Turn of a tooth about the axis, rad: once around the gear.
fn turn(tooth: u32) -> f64 {
    2e-4 * (TAU * f64::from(tooth) / f64::from(TEETH)).cos()
}

/// Points in space of every tooth that is measured.
fn measured(job: &LoadedMillingJob) -> String {
    let mut text = "tooth,flank,row,column,x_mm,y_mm,z_mm\n".to_owned();
    let all = points(job);
    let largest = |of: fn(&MeasuringPoint) -> f64| all.iter().map(of).fold(f64::NEG_INFINITY, f64::max);
    let least = |of: fn(&MeasuringPoint) -> f64| all.iter().map(of).fold(f64::INFINITY, f64::min);
    let (rolls, ends) =
        ([least(|p| p.roll), largest(|p| p.roll)], [least(|p| p.position), largest(|p| p.position)]);
    let share = |x: f64, [from, to]: [f64; 2]| 2.0 * (x - from) / (to - from) - 1.0;
    for tooth in 1..=TEETH {
        let pitch = TAU / f64::from(TEETH) * f64::from(tooth - 1);
        let there = Rotation3::from_axis_angle(&Vector3::z_axis(), pitch + turn(tooth));
        for at in all.iter().filter(|at| WHOLE.contains(&tooth) || (at.row, at.column) == (3, 4)) {
            let f = shape(at.flank, share(at.roll, rolls), share(at.position, ends));
            let point = there * (at.point + at.normal * f);
            writeln!(
                text,
                "{tooth},{},{},{},{},{},{}",
                at.flank, at.row, at.column, point.x, point.y, point.z
            )
            .unwrap();
        }
    }
    text
}

fn written(folder: &Path, text: &str) -> PathBuf {
    let path = folder.join("bevel.csv");
    std::fs::write(&path, text).expect("a file");
    path
}

fn told(failure: &JobFailure) -> String {
    match failure {
        JobFailure::Job(RunFailure::BadInput(finding) | RunFailure::NotProducible(finding)) => {
            format!("{} {:?}: {}", finding.code, finding.field, finding.message)
        }
        JobFailure::File(error) => error.to_string(),
    }
}

fn inspected(job: &LoadedMillingJob, file: &Path, class: Option<i32>) -> BevelInspection {
    inspect_bevel(job, file, class, &Silent).unwrap_or_else(|failure| panic!("{}", told(&failure)))
}

/// Of a straight spherical involute every generator goes through the apex, and the plane of apex and normal touches the base cone.
#[test]
fn points_of_the_grid_lie_on_the_flank_with_their_normals() {
    let all = points(&job(JOB));
    assert_eq!(all.len(), 2 * 5 * 7);
    let sin_base = 33.690067525979785f64.to_radians().sin() * 20f64.to_radians().cos();
    let outer = 5.0 * 16.0 / (2.0 * 33.690067525979785f64.to_radians().sin());
    for at in &all {
        assert!((at.normal.norm() - 1.0).abs() < 1e-12);
        assert!(at.normal.dot(&at.point).abs() < 1e-9, "the generator");
        let plane = at.point.normalize().cross(&at.normal);
        assert!((plane.z.abs() - sin_base).abs() < 1e-9, "{} {}", plane.z, sin_base);
        let wanted = outer - 10.0 + at.position;
        assert!((at.point.norm() - wanted).abs() < 1e-9, "{} {wanted}", at.point.norm());
        // Normals look into the space about +y, the left flank of which lies where it does seen from +z.
        assert!(at.normal.x * at.point.x < 0.0);
    }
    let of = |flank: Flank, row: usize, column: usize| {
        let found = all.iter().find(|at| (at.flank, at.row, at.column) == (flank, row, column));
        found.expect("a point").point
    };
    for flank in Flank::BOTH {
        assert!(of(flank, 5, 4).xy().norm() > of(flank, 1, 4).xy().norm(), "rows go to the tip");
        assert!(of(flank, 3, 7).norm() - of(flank, 3, 1).norm() > 17.9, "columns go to the heel");
    }
}

#[test]
fn what_teeth_share_is_found_and_taken_off() {
    let folder = tempfile::tempdir().expect("a folder");
    let loaded = job(JOB);
    let file = written(folder.path(), &measured(&loaded));
    let found = inspected(&loaded, &file, Some(6));
    let round = &found.result.rounds[0];
    for (name, slopes) in [("left", [-8.0, 20.0]), ("right", [-6.0, -12.0])] {
        let of = &round.flanks[name];
        assert_eq!(of.teeth, 4);
        // From end to end twice the amplitude; the twist of the left flank does not lean on them.
        assert!((of.measured.profile_slope_um - slopes[0]).abs() < 0.1, "{name}: {:?}", of.measured);
        assert!((of.measured.helix_slope_um - slopes[1]).abs() < 0.1, "{name}: {:?}", of.measured);
        assert!(of.standing_out.is_empty());
    }
    assert_eq!(found.result.verdict.reason().map(|reason| reason.code), Some("tolerance-exceeded"));
    let proof = &round.correction.as_ref().expect("a correction").proof;
    for of in proof.values() {
        assert!(of.after.rms_um < 0.2 * of.before.rms_um, "{of:?}");
    }
    // Teeth that turn by 0.2 mrad to and fro are 0.4 mrad apart on the mean pitch diameter.
    let mean = 2.0 * (5.0 * 16.0 / (2.0 * 33.690067525979785f64.to_radians().sin()) - 10.0);
    let diameter = mean * 33.690067525979785f64.to_radians().sin();
    for of in found.result.pitch.values() {
        assert!((of.total_um - 0.4 * 0.5 * diameter).abs() < 0.01, "{} {}", of.total_um, 0.2 * diameter);
    }
    // A tooth that turns as a whole moves no ball across the cone.
    assert!(found.result.run_out_um.expect("a run-out") < 0.01);
    assert_eq!(found.result.class, found.result.classes.iter().map(|of| of.class).max().flatten());
    // The answer goes into a job that plans, and the same part is as far off by it.
    let out = folder.path().join("out");
    write_bevel_inspection(&found, &out).expect("written files");
    let text = std::fs::read_to_string(out.join("corrected-job.json")).expect("a job");
    let corrected = job(&text);
    let before: Vec<f64> =
        points(&loaded).iter().flat_map(|at| [at.point.x, at.point.y, at.point.z]).collect();
    let after: Vec<f64> =
        points(&corrected).iter().flat_map(|at| [at.point.x, at.point.y, at.point.z]).collect();
    assert!(before.iter().zip(&after).all(|(a, b)| (a - b).abs() < 1e-9), "the target stays");
    let again = inspected(&corrected, &file, None);
    let largest = |found: &BevelInspection| found.result.largest_um();
    assert!((largest(&again) - largest(&found)).abs() < 1e-6);
    let page = std::fs::read_to_string(out.join("report.html")).expect("a report");
    assert!(page.contains("off the flank that its paths are planned on") && page.contains("ISO 17485"));
}

#[test]
fn classes_are_judged_and_asked_for_by_the_drawing() {
    let folder = tempfile::tempdir().expect("a folder");
    let loaded = job(JOB);
    let file = written(folder.path(), &measured(&loaded));
    let reached = inspected(&loaded, &file, None).result.class.expect("a class");
    for (class, kept) in [(reached, true), (reached - 1, false)] {
        let by_drawing =
            job(&JOB.replace("face_width = 20.0", &format!("face_width = 20.0\ntolerance_class = {class}")));
        for found in [inspected(&loaded, &file, Some(class)), inspected(&by_drawing, &file, None)] {
            assert_eq!(found.result.tolerance_class, Some(class));
            let missed = found
                .result
                .verdict
                .judged()
                .iter()
                .any(|item| item.item.contains("pitch") && item.status == verdict::Status::Missed);
            assert_eq!(missed, !kept, "{class}: {:?}", found.result.verdict.judged());
        }
    }
    // Without all teeth there is no pitch, and a class that is asked for is owed.
    let some: String = std::fs::read_to_string(&file)
        .unwrap()
        .lines()
        .filter(|line| !line.starts_with("16,left"))
        .map(|line| line.to_owned() + "\n")
        .collect();
    let found = inspected(&loaded, &written(folder.path(), &some), Some(9));
    assert!(found.result.pitch.contains_key("right") && !found.result.pitch.contains_key("left"));
    assert!(found.result.run_out_um.is_none());
    let owed: Vec<&str> = found.result.verdict.not_judged().iter().map(|item| item.item.as_str()).collect();
    assert!(owed.contains(&"left flank, single pitch") && owed.contains(&"run-out"), "{owed:?}");
}

#[test]
fn deviations_say_the_same_as_points() {
    let folder = tempfile::tempdir().expect("a folder");
    let loaded = job(JOB);
    let by_points = inspected(&loaded, &written(folder.path(), &measured(&loaded)), None);
    let mut text = "tooth,flank,row,column,f_um\n".to_owned();
    let all = points(&loaded);
    let rolls = [all[0].roll, all[all.len() / 2 - 1].roll];
    let ends = [all[0].position, all[6].position];
    let share = |x: f64, [from, to]: [f64; 2]| 2.0 * (x - from) / (to - from) - 1.0;
    for tooth in 1..=TEETH {
        for at in all.iter().filter(|at| WHOLE.contains(&tooth) || (at.row, at.column) == (3, 4)) {
            let f = shape(at.flank, share(at.roll, rolls), share(at.position, ends));
            // The turn of the tooth moves each point by the normal part of its way.
            let way = Vector3::z().cross(&at.point).dot(&at.normal) * turn(tooth);
            writeln!(text, "{tooth},{},{},{},{}", at.flank, at.row, at.column, 1e3 * (f + way)).unwrap();
        }
    }
    let by_deviations = inspected(&loaded, &written(folder.path(), &text), None);
    for (name, of) in &by_points.result.rounds[0].flanks {
        let other = &by_deviations.result.rounds[0].flanks[name];
        for (a, b) in of.measured_um.iter().flatten().zip(other.measured_um.iter().flatten()) {
            assert!((a.unwrap() - b.unwrap()).abs() < 0.02, "{name}: {a:?} {b:?}");
        }
        let (a, b) = (&by_points.result.pitch[name], &by_deviations.result.pitch[name]);
        assert!((a.total_um - b.total_um).abs() < 0.02);
    }
}

#[test]
fn other_measurements_are_refused_at_their_place() {
    let folder = tempfile::tempdir().expect("a folder");
    let loaded = job(JOB);
    let text = measured(&loaded);
    let refused = |job: &LoadedMillingJob, text: &str, class: Option<i32>| match inspect_bevel(
        job,
        &written(folder.path(), text),
        class,
        &Silent,
    ) {
        Err(failure) => told(&failure),
        Ok(_) => panic!("it is taken"),
    };
    assert!(refused(&loaded, &text, Some(1)).contains("no such class"));
    // A tooth with the number of another one lies elsewhere.
    let of_tooth = |line: &&str| line.starts_with("tooth") || line.starts_with("5,");
    let renamed = text.lines().filter(of_tooth).map(|line| line.replacen("5,", "6,", 1) + "\n");
    let message = refused(&loaded, &renamed.collect::<String>(), None);
    assert!(message.contains("mm beside its place"), "{message}");
    let sparse = "tooth,flank,row,column,f_um\n1,left,1,1,2\n1,left,2,2,1\n";
    assert!(refused(&loaded, sparse, None).contains("make no surface"));
    assert!(
        refused(&loaded, "tooth,flank,row,column,f_um\n1,left,6,1,2\n", None).contains("`row` cannot be")
    );
    assert!(refused(&loaded, "kind,tooth\n", None).contains("no column"));
    let gear = std::fs::read_to_string(
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/milling/spur-module-8.toml"),
    )
    .unwrap();
    assert!(refused(&job(&gear), &text, None).contains("bevel"));
}
