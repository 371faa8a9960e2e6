//! What the user states about a measurement: the end it was taken from, signs and lengths of slopes, the datum face.

use crate::measured_parts::{MadePart, WIDTH};
use foundation::geometry::{Flank, Sides};
use inspection::workflow::{
    GearInspection, SheetOptions, Statements, SummaryResult, evaluate_inspection, inspect_gear,
    inspection_sheet,
};
use measured_files::inspection::{CountingDirection, DatumFace, Inspection, Size, SlopeReference};

fn inspected(text: &str, statements: &Statements) -> GearInspection {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("part.mka");
    std::fs::write(&path, text).expect("a file");
    inspect_gear(&path, statements, None).expect("an inspection")
}

fn other_end() -> Statements {
    Statements { other_end: true, ..Statements::default() }
}

/// Slopes of the material over the whole face or range, um, mean of the teeth: of profiles and of helix traces.
fn slopes(found: &GearInspection, flank: Flank) -> [f64; 2] {
    ["profile", "helix"].map(|kind| {
        let traces = found.result.traces.iter().filter(|t| t.kind == kind && t.flank == flank.name());
        let values: Vec<f64> = traces.map(|t| t.slope_material_um).collect();
        assert_eq!(values.len(), 3);
        values.iter().sum::<f64>() / 3.0
    })
}

#[test]
fn a_gear_seen_from_the_other_end_is_the_same_gear() {
    let quiet = |part: MadePart| MadePart { wave: 0.0, ..part };
    let part = quiet(MadePart::new("P-1", 7));
    // The same gear as a machine sees it that has it upside down: the flanks have changed sides, helices rise the other way.
    let from_below = quiet(MadePart {
        profile_slope: Sides { left: part.profile_slope.right, right: part.profile_slope.left },
        helix_slope: Sides { left: -part.helix_slope.right, right: -part.helix_slope.left },
        ..MadePart::new("P-1", 7)
    });
    let above = inspected(&part.text(), &Statements::default());
    let turned = inspected(&from_below.text(), &other_end());
    for flank in Flank::BOTH {
        let (a, b) = (slopes(&above, flank), slopes(&turned, flank));
        // The roughness of 480 samples moves a slope by some 0.02 um.
        assert!((a[0] - b[0]).abs() < 0.05 && (a[1] - b[1]).abs() < 0.05, "{flank}: {a:?} {b:?}");
        assert!((a[1] - part.helix_slope[flank] * WIDTH / 18.0).abs() < 0.1, "{flank}: {a:?}");
    }
    assert_eq!(turned.result.stated.len(), 1);
}

#[test]
fn turning_changes_sides_and_not_what_was_printed() {
    let text = MadePart::new("P-1", 7).text();
    let plain = inspected(&text, &Statements::default());
    let turned = inspected(&text, &other_end());
    for flank in Flank::BOTH {
        let printed = |found: &GearInspection, flank: Flank| -> Vec<f64> {
            let own = found.result.traces.iter().filter(|t| t.flank == flank.name());
            own.map(|t| t.slope_um).collect()
        };
        for (a, b) in printed(&plain, flank).iter().zip(printed(&turned, flank.other())) {
            assert!((a - b).abs() < 1e-9, "{a} {b}");
        }
        let pitch = |found: &GearInspection, flank: Flank| found.result.pitch[flank.name()].clone();
        assert_eq!(pitch(&plain, flank), pitch(&turned, flank.other()));
    }
    // Run-out and eccentricity pair flanks of neighbouring teeth: they are those of the machine, seen from the other side.
    let mut sized = plain.inspection.clone();
    sized.thickness.span_teeth = Some(3);
    sized.thickness.span = Some(Size { mean_mm: Some(15.44), least_mm: None, largest_mm: None });
    sized.thickness.ball_diameter_mm = Some(3.5);
    let pitches = |of: &Inspection| evaluate_inspection(of, None).expect("evaluated").pitch.expect("pitches");
    let (a, b) = (pitches(&sized), pitches(&sized.clone().turned()));
    assert_eq!(a.run_out.as_ref().expect("run-out").of_space, b.run_out.as_ref().expect("run-out").of_space);
    let (e, f) =
        (a.eccentricity.as_ref().expect("eccentricity"), b.eccentricity.as_ref().expect("eccentricity"));
    assert_eq!([e.x, e.y], [f.x, -f.y]);
    assert_eq!(e.cumulative_without.left, f.cumulative_without.right);
    let (p, q) =
        (a.from_positions.as_ref().expect("positions"), b.from_positions.as_ref().expect("positions"));
    assert_eq!((&p.left, &p.right), (&q.right, &q.left));
    assert_eq!(turned.inspection.pitch.as_ref().expect("pitch").counting, Some(CountingDirection::Clockwise));
    // Twice turned it is as it was.
    assert_eq!(turned.inspection.clone().turned(), plain.inspection);
    let sheet = inspection_sheet(&turned, &SheetOptions::default()).expect("a sheet");
    assert!(sheet.contains("clockwise, seen from +z"));
}

#[test]
fn signs_and_lengths_of_slopes_are_those_that_are_stated() {
    let text = MadePart::new("P-1", 7).text();
    let plain = inspected(&text, &Statements::default());
    let stated = Statements {
        slope_signs: Some(Sides { left: 1.0, right: 1.0 }),
        helix_slope_over: Some(SlopeReference::Range),
        datum_face: Some(DatumFace::MinusZ),
        ..Statements::default()
    };
    let found = inspected(&text, &stated);
    for (a, b) in plain.result.traces.iter().zip(&found.result.traces) {
        if a.kind == "helix" {
            let share = 18.0 / WIDTH;
            assert!((b.slope_material_um - share * a.slope_material_um).abs() < 1e-9);
            assert!((b.slope_um - b.slope_material_um).abs() < 1e-12);
        } else {
            assert_eq!(a, b);
        }
    }
    assert_eq!(found.result.stated.len(), 3);
    let sheet = inspection_sheet(&found, &SheetOptions::default()).expect("a sheet");
    assert!(sheet.contains("−z, lower face (face I)") && sheet.contains("material rising to +z"));
}

#[test]
fn a_length_that_the_file_does_not_tell_can_be_stated() {
    let text = MadePart::new("P-1", 7).text();
    let silent: String = text
        .lines()
        .filter(|line| !line.contains(":BZGFL:"))
        .fold(String::new(), |text, line| text + line + "\r\n");
    let found = inspected(&silent, &Statements::default());
    assert!(found.result.traces.iter().all(|trace| trace.kind == "profile"));
    let told = found.result.warnings.iter().find(|warning| warning.code == "not-stated").expect("a warning");
    assert!(told.way_out.contains("--helix-slope-over"), "{told:?}");
    let over = Statements { helix_slope_over: Some(SlopeReference::FaceWidth), ..Statements::default() };
    let whole = inspected(&text, &Statements::default());
    assert_eq!(inspected(&silent, &over).result.traces, whole.result.traces);
}

#[test]
fn lines_that_cross_show_the_flank_as_a_surface() {
    let found = inspected(&MadePart::new("P-1", 7).text(), &Statements::default());
    for flank in Flank::BOTH {
        let areal = &found.result.areal[flank.name()];
        // As the lines say by themselves: a spur gear, slopes over the field instead of the face width.
        let crownings = ["profile", "helix"].map(|kind| {
            let mean =
                |row: &&SummaryResult| (row.kind, row.flank, row.characteristic) == (kind, flank.name(), "C");
            found.result.summary.iter().find(mean).expect("a crowning").mean_um
        });
        let [profile, helix] = slopes(&found, flank);
        for (areal, line) in [
            (areal.profile_slope_um, profile),
            (areal.helix_slope_um, helix * 18.0 / WIDTH),
            (areal.profile_crowning_um, crownings[0]),
            (areal.helix_crowning_um, crownings[1]),
        ] {
            assert!((areal - line).abs() < 0.05, "{flank}: {areal} {line}");
        }
        assert!(areal.twist_um.is_none() && areal.teeth == 3, "{areal:?}");
    }
    assert!(found.result.twist.is_empty());
}

#[test]
fn numbers_that_no_measurement_gives_are_told_and_hurt_nothing_else() {
    let text = MadePart::new("P-1", 7).text();
    let whole = inspected(&text, &Statements::default());
    assert!(!whole.result.class_is_partial, "{:?}", whole.result.warnings);
    let line = text.lines().position(|line| line.starts_with("Flankenlinie")).expect("a helix trace") + 4;
    let absurd: Vec<String> = text
        .lines()
        .enumerate()
        .map(|(k, row)| {
            let first = row.split_whitespace().next().unwrap_or_default();
            if k == line { row.replacen(first, "1e14", 1) } else { row.to_owned() }
        })
        .collect();
    let found = inspected(&(absurd.join("\r\n") + "\r\n"), &Statements::default());
    let told = found.result.warnings.iter().find(|warning| warning.code == "implausible").expect("a warning");
    assert!(told.text.contains("the trace: 1 of the values"), "{told:?}");
    assert!(found.result.class_is_partial);
    assert_eq!(found.result.traces.len(), whole.result.traces.len());
    assert!(found.result.traces.iter().all(|trace| trace.total_um < 50.0));
    // A length that no gear has is refused by its name.
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("part.mka");
    let far: Vec<String> = text
        .lines()
        .map(|row| {
            if row.trim_start().starts_with("44 ") {
                "  44  :Ende:  1e308 1e308".into()
            } else {
                row.to_owned()
            }
        })
        .collect();
    std::fs::write(&path, far.join("\r\n") + "\r\n").expect("a file");
    let Err(error) = inspect_gear(&path, &Statements::default(), None) else { panic!("not refused") };
    let told = format!("{error:?}");
    assert!(told.contains("diameter of the header") && told.contains("100000 mm"), "{told}");
}
