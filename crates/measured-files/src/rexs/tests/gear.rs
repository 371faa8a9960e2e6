//! Gears for the tests: every kind of modification that REXS knows, on a helical gear of its own.

use super::super::*;
use crate::inspection::{DatumFace, Trace, TraceKind, Zero};
use foundation::geometry::{Flank, Sides};
use foundation::modification::ModificationSpec;
use serde_json::{Value as Json, json};

pub(super) fn spec(value: Json) -> ModificationSpec {
    ModificationSpec::from_json(&value).unwrap()
}

/// Modifications of one flank that REXS has kinds for.
pub(super) fn kinds(flank: Flank) -> Vec<ModificationSpec> {
    let list = json!([
        { "kind": "tip_relief", "amount_um": 20.0, "length_mm": 2.5, "exponent": 1.0, "transition_mm": 0.5 },
        { "kind": "root_relief", "amount_um": 8.0, "length_mm": 1.5, "exponent": 2.0 },
        { "kind": "profile_crowning", "amount_um": 4.0 },
        { "kind": "profile_crowning_arc", "amount_um": 3.0 },
        { "kind": "profile_crowning_two_arc", "apex_w_mm": 12.0, "amount_I_um": 5.0, "amount_II_um": 2.0 },
        { "kind": "profile_slope", "amount_um": -3.0 },
        { "kind": "helix_crowning", "amount_um": 6.0 },
        { "kind": "helix_crowning_arc", "amount_um": -2.0 },
        { "kind": "helix_crowning_two_arc", "apex_z_mm": 3.0, "amount_I_um": 5.0, "amount_II_um": 7.0 },
        { "kind": "helix_slope", "amount_um": 5.0 },
        { "kind": "end_relief_I", "amount_um": 12.0, "length_mm": 3.0 },
        { "kind": "end_relief_II", "amount_um": 9.0, "length_mm": 4.0, "exponent": 2.0, },
        { "kind": "twist", "amount_um": -7.0 },
        { "kind": "grid", "w_mm": [7.0, 10.0, 14.0, 20.0], "z_mm": [-12.0, -4.0, 0.0, 5.0, 12.5],
          "f_um": [[1.0, 2.0, 3.0, 4.0, 5.0], [0.5, 0.0, -1.0, -2.0, -3.0], [7.0, 8.0, 9.0, 1.0, 2.0],
                   [-1.0, -2.0, -3.0, -4.0, -5.0]] },
    ]);
    let list = list.as_array().unwrap().iter().map(|item| {
        let mut item = item.clone();
        item["flank"] = flank.name().into();
        spec(item)
    });
    list.collect()
}

/// A gear without modifications.
pub(super) fn plain(datum_face: DatumFace) -> RexsGear {
    let field = FlankField {
        start_diameter_mm: Some(78.0),
        end_diameter_mm: Some(87.4),
        z_start_mm: Some(-14.5),
        z_end_mm: Some(14.0),
    };
    RexsGear {
        name: Some("pinion <1> & \"co\"".into()),
        teeth: 31,
        normal_module_mm: 2.5,
        normal_pressure_angle_deg: Sides { left: 20.0, right: 22.5 },
        helix_angle_deg: 20.0,
        profile_shift: 0.125,
        thickness: None,
        tolerance_class: None,
        face_width_mm: 30.0,
        tip_diameter_mm: Some(88.4),
        root_diameter_mm: Some(76.0),
        form_diameter_mm: Some(77.5),
        datum_face,
        fields: Sides::both(field),
        modifications: Sides::default(),
        deviations: Vec::new(),
    }
}

/// A gear with every kind and with measured lines.
pub(super) fn full(datum_face: DatumFace) -> RexsGear {
    let mut gear = plain(datum_face);
    gear.modifications = Sides::from_fn(kinds);
    for (kind, flank, position_mm, from) in
        [(TraceKind::Profile, Flank::Left, 2.5, 8.0), (TraceKind::Helix, Flank::Right, 12.0, -13.0)]
    {
        let abscissa_mm: Vec<f64> = (0..30).map(|i| from + 0.3 * f64::from(i)).collect();
        let f_um = abscissa_mm.iter().map(|a| 3.0 * a.sin()).collect();
        let (tooth, tag, zero) = (17, "u".into(), Zero::Free);
        gear.deviations.push(Trace { kind, tooth, flank, tag, position_mm, abscissa_mm, f_um, zero });
    }
    gear
}

pub(super) fn author() -> Author {
    Author::flankwright("2026-02-01T12:00:00")
}

/// All numbers of two values agree within `tolerance`, everything else exactly.
pub(super) fn agree(a: &Json, b: &Json, tolerance: f64, path: &str) {
    match (a, b) {
        (Json::Object(a), Json::Object(b)) => {
            assert_eq!(a.keys().collect::<Vec<_>>(), b.keys().collect::<Vec<_>>(), "{path}");
            for (key, value) in a {
                agree(value, &b[key], tolerance, &format!("{path}.{key}"));
            }
        }
        (Json::Array(a), Json::Array(b)) => {
            assert_eq!(a.len(), b.len(), "{path}");
            for (k, (a, b)) in a.iter().zip(b).enumerate() {
                agree(a, b, tolerance, &format!("{path}[{k}]"));
            }
        }
        _ => match (a.as_f64(), b.as_f64()) {
            (Some(a), Some(b)) => assert!((a - b).abs() <= tolerance, "{path}: {a} and {b}"),
            _ => assert_eq!(a, b, "{path}"),
        },
    }
}
