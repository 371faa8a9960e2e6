//! A measured blank as stock: shape from its traces, level from its thickness, every tooth where its pitch says.

use crate::measured_parts::MadePart;
use foundation::geometry::{Flank, Sides};
use generating_grinding::job::{Job, LoadedJob};
use inspection::workflow::{BlankStock, Statements, blank_of_file};
use job::{JobError, Source, parse_job_of};
use nalgebra::{Rotation3, Vector3};
use std::path::Path;

const JOB: &str = r#"
[job]
name = "finished"
process = "generating-grinding"
[gear]
teeth = 23
normal_module = 2.0
normal_pressure_angle_deg = 20.0
helix_angle_deg = 0.0
profile_shift = 0.0
face_width = 20.0
tip_diameter = 49.2
root_diameter = 41.4
form_diameter = 44.6
[target]
tolerance_um = 2.0
modifications = []
[worm]
threads = 1
tip_diameter = 240.0
[dresser]
tip_diameter = 140.0
[grinding]
method = "diagonal"
"#;

fn job(more: &str) -> Result<LoadedJob, JobError> {
    parse_job_of::<Job>(Source::new("job.toml", &(JOB.to_owned() + more)))
}

fn blank(file: &Path, more: &str) -> Result<BlankStock, run::JobFailure> {
    blank_of_file(&job(more).expect("a job"), file, &Statements::default())
}

/// A part with level flanks, so that only its pitches are left.
fn level() -> MadePart {
    let none = Sides::both(0.0);
    MadePart { profile_slope: none, helix_slope: none, crowning: 0.0, wave: 0.0, ..MadePart::new("B-1", 5) }
}

fn written(part: &MadePart, span: &str) -> (tempfile::TempDir, std::path::PathBuf) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("blank.mka");
    std::fs::write(&path, part.text() + span).expect("a file");
    (folder, path)
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

#[test]
fn every_tooth_stands_where_its_pitch_says() {
    let part = level();
    let (_folder, path) = written(&part, "");
    let found = blank(&path, "[stock]\nallowance_um = { left = 110.0, right = 90.0 }\n").expect("a blank");
    assert_eq!((found.result.level_from, found.result.with_pitch), ("stock.allowance_um", true));
    let gear = job("").expect("a job").job.gear.body().expect("a gear");
    for flank in Flank::BOTH {
        let spaces = &found.flanks[flank].as_ref().expect("a flank").spaces;
        // The table adds to the allowance.
        let allowance = if flank == Flank::Left { 110.0 } else { 90.0 };
        let means: Vec<f64> = spaces.iter().map(|(_, space)| allowance + mean(space)).collect();
        assert_eq!(spaces.len(), 23);
        assert!((mean(&means) - allowance).abs() < 0.3, "{flank}: {}", mean(&means));
        // A flank that stands further on about the axis: is it material for its space? By the involute itself.
        let f = gear.flank(flank);
        let w = f.length_of_roll(gear.pitch_radius()).unwrap();
        let turn = 1e-3 / gear.pitch_radius();
        let point = Rotation3::from_axis_angle(&Vector3::z_axis(), turn) * f.point(w, 0.0);
        let per_um = 1e3 * f.deviation(&point).f_n;
        let mut cumulative = Vec::new();
        part.single_pitches(flank).iter().fold(0.0, |sum, fp| {
            cumulative.push(sum + fp);
            sum + fp
        });
        let level = mean(&cumulative);
        for (space, stock) in means.iter().enumerate() {
            // A space follows the left flank of its tooth and precedes the right flank of the next.
            let tooth = if flank == Flank::Left { space } else { (space + 1) % 23 };
            let want = allowance + per_um * (cumulative[tooth] - level);
            assert!((stock - want).abs() < 0.3, "{flank} flank, space {space}: {stock} for {want}");
        }
    }
}

#[test]
fn shapes_are_those_of_the_traces() {
    let part = MadePart { eccentricity: 0.0, wave: 0.0, ..MadePart::new("B-2", 3) };
    let (_folder, path) = written(&part, "");
    let found = blank(&path, "[stock]\nallowance_um = 100.0\n").expect("a blank");
    assert_eq!(found.result.teeth_with_traces, Sides::both(3));
    for flank in Flank::BOTH {
        let of = found.flanks[flank].as_ref().expect("a flank");
        let columns = of.z.len();
        let at = |i: usize, j: usize| {
            mean(&of.spaces.iter().map(|(_, space)| space[i * columns + j]).collect::<Vec<f64>>())
        };
        // Helix: slope over 18 mm of the face, crowning over the same; ends of the face at +-10 mm.
        let (middle, last) = (of.w.len() / 2, columns - 1);
        let slope = (at(middle, last) - at(middle, 0)) / 20.0 * 18.0;
        assert!((slope - part.helix_slope[flank]).abs() < 0.2, "{flank}: {slope}");
        let crowning = at(middle, columns / 2) - 0.5 * (at(middle, 0) + at(middle, last));
        assert!((crowning - part.crowning * (10.0f64 / 9.0).powi(2)).abs() < 0.3, "{flank}: {crowning}");
    }
}

/// One tooth has a profile, another a helix trace: the shape is that of both together, and a remark says so.
#[test]
fn lines_of_different_teeth_make_one_shape() {
    let part =
        MadePart { traced: vec![1, 8], wave: 0.0, pitch: false, positions: false, ..MadePart::new("B-3", 4) };
    let text = part.text();
    let (header, blocks) = text.split_once("Flankenlinie:").expect("lines");
    let blocks = format!("Flankenlinie:{blocks}").replace("Profil:", "\u{1}Profil:");
    let blocks = blocks.replace("Flankenlinie:", "\u{1}Flankenlinie:");
    let is_kept = |block: &&str| {
        let (helix, first) = (block.starts_with("Flankenlinie"), block.contains("Zahn-Nr.: 1 "));
        helix == first
    };
    let kept: String = blocks.split('\u{1}').filter(is_kept).collect();
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("blank.mka");
    std::fs::write(&path, header.to_owned() + &kept).expect("a file");
    let found = blank(&path, "[stock]\nallowance_um = 100.0\n").expect("a blank");
    let codes: Vec<&str> = found.result.remarks.iter().map(|remark| remark.code).collect();
    assert_eq!(codes.iter().filter(|code| **code == "blank-of-single-lines").count(), 2, "{codes:?}");
    assert_eq!(found.result.teeth_with_traces, Sides::both(0));
    for flank in Flank::BOTH {
        let of = found.flanks[flank].as_ref().expect("a flank");
        assert_eq!(of.spaces.iter().map(|(space, _)| *space).collect::<Vec<usize>>(), [0]);
        let (amounts, columns) = (&of.spaces[0].1, of.z.len());
        let row = of.w.len() / 2 * columns;
        let slope = (amounts[row + columns - 1] - amounts[row]) / 20.0 * 18.0;
        assert!((slope - part.helix_slope[flank]).abs() < 0.2, "{flank}: {slope}");
    }
}

#[test]
fn a_blank_without_level_is_refused_and_one_of_another_gear_too() {
    let (_folder, path) = written(&level(), "");
    let refused = |more: &str, from: &str, to: &str| {
        let text = JOB.replacen(from, to, 1) + more;
        let job = parse_job_of::<Job>(Source::new("job.toml", &text)).expect("a job");
        match blank_of_file(&job, &path, &Statements::default()) {
            Err(run::JobFailure::Job(run::RunFailure::BadInput(finding))) => {
                finding.field.as_deref().unwrap_or_default().to_owned()
            }
            other => panic!("{other:?}"),
        }
    };
    assert_eq!(refused("", "", ""), "stock.allowance_um");
    assert_eq!(
        refused("[stock]\nallowance_um = 90.0\n", "face_width = 20.0", "face_width = 21.0"),
        "gear.face_width"
    );
}
