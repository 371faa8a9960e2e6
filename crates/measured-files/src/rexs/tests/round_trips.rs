//! What is written comes back: through XML, JSON and packages, with both datum faces.

use super::super::*;
use super::gear::{agree, author, full, plain, spec};
use crate::inspection::DatumFace;
use foundation::geometry::Flank;
use foundation::modification::{EvaluationField, Modification, ModificationSpec, NoFiles};
use serde_json::json;

const FACES: [DatumFace; 2] = [DatumFace::PlusZ, DatumFace::MinusZ];

#[test]
fn every_kind_survives_every_form_of_file() {
    for face in FACES {
        let gear = full(face);
        let (document, warnings) = document_of(&gear, &NoFiles, &author()).unwrap();
        assert!(warnings.is_empty(), "{warnings:?}");
        for (format, packed) in [
            (RexsFormat::Xml, false),
            (RexsFormat::Json, false),
            (RexsFormat::Xml, true),
            (RexsFormat::Json, true),
        ] {
            let (bytes, lost) = rexs_bytes(&document, format, packed).unwrap();
            assert!(lost.is_empty());
            assert_eq!(rexs_bytes(&document, format, packed).unwrap().0, bytes);
            let back = parse_rexs(&bytes).unwrap();
            let two = |document: &RexsDocument| serde_json::to_value(document).unwrap();
            agree(&two(&document), &two(&back), 1e-12, "");
            assert_eq!(gear_ids(&back), [1]);
            let (found, remarks) = gear_of(&back, 1).unwrap();
            assert!(remarks.is_empty(), "{remarks:?}");
            let (wanted, found) =
                (serde_json::to_value(&gear).unwrap(), serde_json::to_value(&found).unwrap());
            agree(&wanted, &found, 1e-9, &format!("{face:?}, {format:?}"));
        }
    }
}

#[test]
fn the_xml_is_well_formed_and_has_the_places_of_the_schema() {
    let (document, _) = document_of(&full(DatumFace::PlusZ), &NoFiles, &author()).unwrap();
    let (bytes, _) = rexs_bytes(&document, RexsFormat::Xml, false).unwrap();
    let text = String::from_utf8(bytes).unwrap();
    let tree = roxmltree::Document::parse(&text).unwrap();
    let names: Vec<&str> =
        tree.root_element().children().filter(|n| n.is_element()).map(|n| n.tag_name().name()).collect();
    assert_eq!(names, ["relations", "components"]);
    let signed = tree.descendants().filter(|n| n.attribute("sign") == Some("material_removed"));
    assert_eq!(signed.count(), 28);
    let units: std::collections::BTreeSet<_> =
        tree.descendants().filter_map(|n| n.attribute("unit")).collect();
    assert_eq!(units.into_iter().collect::<Vec<_>>(), ["deg", "mm", "none"]);
}

#[test]
fn signs_and_ends_follow_the_datum_face() {
    let amount = |face, value, component: &str, attribute: &str| {
        let mut gear = plain(face);
        gear.modifications.left = vec![spec(value)];
        let (document, _) = document_of(&gear, &NoFiles, &author()).unwrap();
        let part = document.components.iter().find(|c| c.kind == component).unwrap();
        match part.attribute(attribute).unwrap().value {
            Value::Number(value) => value,
            ref other => panic!("{other:?}"),
        }
    };
    let slope = json!({ "kind": "helix_slope", "amount_um": 5.0 });
    let twist = json!({ "kind": "twist", "amount_um": -7.0 });
    let end = json!({ "kind": "end_relief_I", "amount_um": 12.0, "length_mm": 3.0 });
    let (plus, minus) = (FACES[0], FACES[1]);
    assert_eq!(amount(plus, slope.clone(), "helix_slope", "helix_slope"), -0.005);
    assert_eq!(amount(minus, slope.clone(), "helix_slope", "helix_slope"), 0.005);
    assert_eq!(amount(plus, twist.clone(), "profile_twist", "profile_twist"), 0.007);
    assert_eq!(amount(minus, twist, "profile_twist", "profile_twist"), -0.007);
    let depth = |face, component, attribute| amount(face, end.clone(), component, attribute);
    assert_eq!(depth(plus, "end_relief_non_datum_face", "end_relief_depth_non_datum_face"), 0.012);
    assert_eq!(depth(minus, "end_relief_datum_face", "end_relief_depth_datum_face"), 0.012);
    // The field reaches from -14.5 to 14 mm of 30 mm.
    assert_eq!(amount(plus, slope.clone(), "helix_slope", "helix_evaluation_start"), 1.0);
    assert_eq!(amount(minus, slope, "helix_slope", "helix_evaluation_start"), 0.5);
}

#[test]
fn other_kinds_are_sampled_and_told() {
    let kinds = [
        json!({ "kind": "waviness", "rho_deg": 30.0, "wavelength_mm": 9.0, "amp_0_um": 2.0 }),
        json!({ "kind": "tip_relief", "amount_um": 20.0, "length_mm": 5.0, "exponent": 1.5 }),
        json!({ "kind": "polynomial", "terms": [[1, 1, 0.02]] }),
        json!({ "kind": "directed_crowning", "amount_um": 9.0, "rho_deg": 20.0 }),
    ];
    for face in FACES {
        for kind in &kinds {
            let mut gear = plain(face);
            gear.modifications.right = vec![spec(kind.clone())];
            let (document, warnings) = document_of(&gear, &NoFiles, &author()).unwrap();
            assert_eq!(warnings[0].kind, RexsWarningKind::Sampled, "{warnings:?}");
            let (found, _) = gear_of(&document, 1).unwrap();
            let read = &found.modifications.right[0];
            assert!(matches!(read, ModificationSpec::Grid(_)));
            let body = gear.body().unwrap();
            let involute = body.flank(Flank::Right);
            let w = [78.0, 87.4].map(|d| involute.length_of_roll(0.5 * d).unwrap());
            let field =
                EvaluationField::new(w, [-14.5, 14.0], involute.base_radius, involute.base_helix_angle)
                    .unwrap();
            let [ours, theirs] =
                [&gear.modifications.right[0], read].map(|s| Modification::build(s, &field).unwrap());
            // On the lines of the table.
            for (w, z) in [(w[0], -14.5), (w[0], 14.0), (w[1], 14.0), (0.5 * (w[0] + w[1]), -0.25)] {
                let apart = ours.value(w, z).unwrap() - theirs.value(w, z).unwrap();
                assert!(apart.abs() < 1e-9, "{kind} at {w}, {z}: {apart}");
            }
        }
    }
}

#[test]
fn amounts_normal_to_the_flank_become_transverse() {
    let mut gear = plain(DatumFace::PlusZ);
    gear.modifications.left =
        vec![spec(json!({ "kind": "helix_crowning", "amount_um": 6.0, "reference": "normal" }))];
    let (document, _) = document_of(&gear, &NoFiles, &author()).unwrap();
    let (found, _) = gear_of(&document, 1).unwrap();
    let cos = gear.body().unwrap().flank(Flank::Left).base_helix_angle.cos();
    let ModificationSpec::HelixCrowning(read) = &found.modifications.left[0] else { panic!("a crowning") };
    assert!((read.amount_um - 6.0 / cos).abs() < 1e-9);
}

#[test]
fn ring_gears_keep_their_teeth() {
    let mut gear = plain(DatumFace::PlusZ);
    (gear.teeth, gear.tip_diameter_mm, gear.root_diameter_mm) = (-60, Some(155.0), Some(166.0));
    (gear.normal_pressure_angle_deg.right, gear.fields) = (20.0, Default::default());
    let (document, _) = document_of(&gear, &NoFiles, &author()).unwrap();
    assert_eq!(document.components[0].kind, "ring_gear");
    let (found, _) = gear_of(&document, 1).unwrap();
    assert_eq!(found, gear);
}

#[test]
fn what_cannot_be_written_is_refused() {
    let written = |gear: &RexsGear| document_of(gear, &NoFiles, &author()).map(|_| ()).unwrap_err().code();
    let mut gear = plain(DatumFace::PlusZ);
    gear.normal_module_mm = 0.0;
    assert_eq!(written(&gear), "no-gear");
    let mut gear = full(DatumFace::PlusZ);
    gear.fields.left.start_diameter_mm = None;
    assert_eq!(written(&gear), "not-expressible-in-rexs");
    let mut gear = plain(DatumFace::PlusZ);
    gear.modifications.left =
        vec![spec(json!({ "kind": "tip_relief", "amount_um": 20.0, "length_mm": -2.5 }))];
    assert_eq!(written(&gear), "modification");
    gear.modifications.left = vec![spec(json!({ "kind": "grid", "file": "x.csv" }))];
    assert_eq!(written(&gear), "modification");
}

#[test]
fn undefined_samples_are_told() {
    let mut gear = full(DatumFace::PlusZ);
    gear.deviations[0].f_um[3] = f64::NAN;
    let (document, warnings) = document_of(&gear, &NoFiles, &author()).unwrap();
    assert_eq!(warnings[0].kind, RexsWarningKind::Lost, "{warnings:?}");
    assert_eq!(gear_of(&document, 1).unwrap().0.deviations[0].f_um.len(), 29);
}
