//! Allowances of the tooth thickness and the class of the flanks: from a job to REXS and back, and what other programs may write.

use super::super::*;
use super::gear::{author, plain};
use crate::inspection::DatumFace;
use ::job::tables::{Allowances, Gear as JobGear, OverBalls, Span};
use foundation::geometry::Sides;
use foundation::modification::NoFiles;
use serde_json::json;

/// A gear of a drawing without its thickness.
fn drawn(teeth: i32) -> JobGear {
    let [tip, root] = if teeth > 0 { [88.4, 76.0] } else { [-88.4, -100.0].map(f64::abs) };
    serde_json::from_value(json!({
        "teeth": teeth, "normal_module": 2.5, "normal_pressure_angle_deg": 20.0, "helix_angle_deg": 10.0,
        "face_width": 30.0, "tip_diameter": tip, "root_diameter": root, "cone_angle_deg": 0.0, "tolerance_class": 5,
        "allowances_um": { "lower": -90.0, "upper": -50.0 }
    }))
    .unwrap()
}

/// Two measures of its thickness without allowances.
fn measured(teeth: i32) -> [JobGear; 2] {
    let with_shift = JobGear { profile_shift: Some(0.2), allowances_um: None, ..drawn(teeth) };
    let body = with_shift.body().unwrap();
    let size = (1e3 * body.over_balls(4.5, 0.0).unwrap().size).round() * 1e-3;
    let span = body.span(4).map(|span| (1e3 * span.length).round() * 1e-3);
    let balls = JobGear { over_balls: Some(OverBalls { ball: 4.5, size }), ..drawn(teeth) };
    let span = span.map(|length| JobGear { span: Some(Span { teeth: 4, length }), ..drawn(teeth) });
    [span.unwrap_or_else(|_| balls.clone()), balls]
}

fn back(ours: &RexsGear, format: RexsFormat) -> (RexsGear, Vec<RexsWarning>) {
    let (document, _) = document_of(ours, &NoFiles, &author()).unwrap();
    let (bytes, _) = rexs_bytes(&document, format, false).unwrap();
    gear_of(&parse_rexs(&bytes).unwrap(), 1).unwrap()
}

#[test]
fn allowances_and_class_come_back_as_they_were() {
    for teeth in [31, -37] {
        for gear in measured(teeth) {
            for format in [RexsFormat::Xml, RexsFormat::Json] {
                let ours = RexsGear::of_job(&gear, &[]).unwrap();
                let (theirs, remarks) = back(&ours, format);
                assert!(remarks.is_empty(), "{teeth}: {remarks:?}");
                let (found, warnings) = theirs.job_gear().unwrap();
                assert!(warnings.is_empty(), "{warnings:?}");
                assert_eq!((found.span, found.over_balls), (gear.span, gear.over_balls));
                assert_eq!((found.tolerance_class, found.profile_shift), (Some(5), None));
                let allowances = found.allowances_um.unwrap();
                assert!((allowances.lower + 90.0).abs() < 1e-9 && (allowances.upper + 50.0).abs() < 1e-9);
                // The gear that is made is the same.
                let shift = |gear: &JobGear| gear.body().unwrap().data().profile_shift;
                assert!((shift(&found) - shift(&gear)).abs() < 1e-12);
                assert!((theirs.made_profile_shift().unwrap() - shift(&gear)).abs() < 1e-12);
                // The model's own profile shift is that of the drawing.
                assert!((ours.profile_shift - 0.2).abs() < 2e-3, "{}", ours.profile_shift);
            }
        }
    }
}

#[test]
fn allowances_of_the_thickness_itself_have_no_attribute() {
    let gear = JobGear { profile_shift: Some(0.2), ..drawn(31) };
    let ours = RexsGear::of_job(&gear, &[]).unwrap();
    assert_eq!(ours.thickness, None);
    assert!((ours.profile_shift - gear.body().unwrap().data().profile_shift).abs() < 1e-12);
    let (found, _) = back(&ours, RexsFormat::Xml).0.job_gear().unwrap();
    assert_eq!((found.allowances_um, found.tolerance_class), (None, Some(5)));
}

/// A gear with the same pressure angle on both flanks: without it there is no span.
fn symmetric() -> RexsGear {
    RexsGear { normal_pressure_angle_deg: Sides::both(20.0), ..plain(DatumFace::PlusZ) }
}

/// The span of four of its teeth.
fn span_of_four() -> f64 {
    symmetric().body().unwrap().span(4).unwrap().length
}

/// A document with that span and its allowances, changed in the text.
fn changed(replacements: &[(&str, &str)]) -> Result<(RexsGear, Vec<RexsWarning>), RexsError> {
    let gear = RexsGear {
        thickness: Some(RexsThickness {
            measure: RexsMeasure::Span(Span { teeth: 4, length: span_of_four() }),
            allowances_um: Allowances { lower: -90.0, upper: -50.0 },
        }),
        tolerance_class: Some(7),
        ..symmetric()
    };
    let (document, _) = document_of(&gear, &NoFiles, &author()).unwrap();
    let (bytes, _) = rexs_bytes(&document, RexsFormat::Xml, false).unwrap();
    let text = replacements.iter().fold(String::from_utf8(bytes).unwrap(), |text, (from, to)| {
        assert!(text.contains(from), "{from}\n{text}");
        text.replace(from, to)
    });
    gear_of(&parse_rexs(text.as_bytes()).unwrap(), 1)
}

#[test]
fn what_other_programs_write_is_taken_or_told() {
    const LOWER: &str = "lower_backlash_allowance_referenced_to_span";
    let (gear, remarks) = changed(&[]).unwrap();
    assert!(gear.thickness.is_some() && gear.tolerance_class == Some(7) && remarks.is_empty(), "{remarks:?}");
    // Without the measure itself it is that of the profile shift; in mm it is the same.
    let span = span_of_four();
    let (gear, remarks) = changed(&[("\"span_measurement\"", "\"another\"")]).unwrap();
    let told =
        |remarks: &[RexsWarning]| remarks.iter().map(ToString::to_string).collect::<Vec<_>>().join("; ");
    let measure = gear.thickness.expect("a thickness").measure;
    assert!(matches!(measure, RexsMeasure::Span(found) if (found.length - span).abs() < 1e-9), "{measure:?}");
    assert!(told(&remarks).contains("another"), "{remarks:?}");
    let as_mm = [("unit=\"mum\">-90", "unit=\"mm\">-0.09"), ("unit=\"mum\">-50", "unit=\"mm\">-0.05")];
    let (in_mm, _) = changed(&as_mm).unwrap();
    assert!((in_mm.thickness.expect("a thickness").allowances_um.lower + 90.0).abs() < 1e-9);
    // What is not complete is told and not used.
    for (from, to, why) in [
        (LOWER, "another_lower", "is missing"),
        ("number_of_teeth_for_span_measurement", "another", "is missing"),
        ("unit=\"mum\">-90", "unit=\"mum\">-10", "is above"),
    ] {
        let (gear, remarks) = changed(&[(from, to)]).unwrap();
        assert_eq!(gear.thickness, None, "{from}");
        let told = told(&remarks);
        assert!(told.contains("not taken") && told.contains(why), "{told}");
    }
    // A span that the profile shift does not make: allowances count from that of the profile shift.
    let stated = format!("{span}");
    let (gear, remarks) = changed(&[(&stated[..6], "99.999")]).unwrap();
    let measure = gear.thickness.expect("a thickness").measure;
    assert!(matches!(measure, RexsMeasure::Span(found) if (found.length - span).abs() < 1e-9), "{measure:?}");
    assert!(told(&remarks).contains("added to that of the profile shift"), "{remarks:?}");
    // Classes are those of the standard.
    for wrong in ["0", "12", "fine"] {
        let error = changed(&[(
            "global_tolerance_class_iso_1328_2013\" unit=\"none\">7",
            &format!("global_tolerance_class_iso_1328_2013\" unit=\"none\">{wrong}"),
        )])
        .unwrap_err();
        assert_eq!(error.code(), "bad-value", "{error}");
    }
}
