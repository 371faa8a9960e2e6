//! From a job to REXS and back: every supported value is kept.

use super::super::*;
use super::gear::{agree, author, kinds, plain, spec};
use crate::inspection::DatumFace;
use ::job::tables::Gear as JobGear;
use foundation::geometry::Flank;
use foundation::modification::NoFiles;
use serde_json::json;

fn job_gear() -> serde_json::Value {
    json!({
        "teeth": 31, "normal_module": 2.5, "normal_pressure_angle_deg": { "left": 20.0, "right": 22.5 }, "helix_angle_deg": -20.0,
        "profile_shift": 0.125, "face_width": 30.0, "tip_diameter": 88.4, "root_diameter": 76.0, "form_diameter": 77.5, "cone_angle_deg": 0.0,
        "evaluation": { "start_diameter": 78.0, "end_diameter": 87.4, "z_start": -14.5, "z_end": 14.5 }
    })
}

#[test]
fn a_job_comes_back_as_it_was() {
    let gear: JobGear = serde_json::from_value(job_gear()).unwrap();
    // Both flanks alike but for one kind each.
    let mut list: Vec<_> = kinds(Flank::Left)
        .iter()
        .map(|s| {
            let mut value = serde_json::to_value(s).unwrap();
            value["flank"] = "both".into();
            spec(value)
        })
        .filter(|s| !["grid", "profile_crowning_two_arc"].contains(&s.kind()))
        .collect();
    list.push(spec(json!({ "kind": "twist", "amount_um": 3.0, "flank": "left" })));
    list.push(spec(json!({ "kind": "helix_slope", "amount_um": 4.0, "flank": "right" })));
    for format in [RexsFormat::Xml, RexsFormat::Json] {
        let ours = RexsGear::of_job(&gear, &list).unwrap();
        let (document, _) = document_of(&ours, &NoFiles, &author()).unwrap();
        let (bytes, _) = rexs_bytes(&document, format, true).unwrap();
        let (theirs, remarks) = gear_of(&parse_rexs(&bytes).unwrap(), 1).unwrap();
        assert!(remarks.is_empty(), "{remarks:?}");
        let (back, warnings) = theirs.job_gear().unwrap();
        assert!(warnings.is_empty(), "{warnings:?}");
        agree(&job_gear(), &serde_json::to_value(&back).unwrap(), 1e-9, "gear");
        let value = |list: &[_]| serde_json::to_value(list).unwrap();
        agree(&value(&list), &value(&theirs.job_modifications()), 1e-9, "modifications");
    }
}

#[test]
fn what_a_job_cannot_hold_is_told() {
    let mut gear = plain(DatumFace::PlusZ);
    gear.fields.right.end_diameter_mm = Some(87.0);
    assert_eq!(gear.job_gear().unwrap().1[0].kind, RexsWarningKind::RangesDiffer);
    gear.root_diameter_mm = None;
    assert_eq!(gear.job_gear().unwrap_err().code(), "missing-attribute");
    let mut conical: JobGear = serde_json::from_value(job_gear()).unwrap();
    conical.cone_angle_deg = 2.0;
    assert_eq!(RexsGear::of_job(&conical, &[]).unwrap_err().code(), "not-expressible-in-rexs");
}

#[test]
fn thickness_becomes_profile_shift() {
    let mut gear: JobGear = serde_json::from_value(job_gear()).unwrap();
    let body = RexsGear::of_job(&gear, &[]).unwrap().body().unwrap();
    let balls = body.over_balls(4.5, 0.0).unwrap();
    gear.profile_shift = None;
    gear.over_balls = Some(::job::tables::OverBalls { ball: 4.5, size: balls.size });
    let found = RexsGear::of_job(&gear, &[]).unwrap();
    assert!((found.profile_shift - 0.125).abs() < 1e-9);
}
