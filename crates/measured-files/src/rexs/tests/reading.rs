//! Files of other programs: units, forms of lists, ranges, shapes; what is assumed and what is refused.

use super::super::*;
use foundation::modification::ModificationSpec;

/// A gear of 31 teeth with one component at its left flank.
fn xml(part: &str) -> String {
    let gear = r#"<attribute id="number_of_teeth" unit="none">31</attribute><attribute id="normal_module" unit="mm">2.5</attribute>
        <attribute id="helix_angle_reference_diameter" unit="deg">20</attribute><attribute id="face_width" unit="mm">30</attribute>
        <attribute id="tip_diameter" unit="mm">88.4</attribute><attribute id="root_diameter" unit="mm">77.0</attribute>
        <attribute id="datum_face_orientation" unit="none">positive</attribute>"#;
    let flank = r#"<attribute id="normal_pressure_angle" unit="deg">20</attribute>
        <attribute id="addendum_modification_coefficient" unit="none">0</attribute>"#;
    format!(
        r#"<?xml version="1.0"?><model xmlns="https://www.rexs.info" version="2.0.0" applicationId="x" applicationVersion="1" date="d">
        <relations><relation id="1" type="flank"><ref id="1" role="gear"/><ref id="2" role="left"/><ref id="3" role="right"/></relation>
        <relation id="2" type="reference"><ref id="2" role="origin"/><ref id="4" role="referenced"/></relation></relations>
        <components><component id="1" type="cylindrical_gear">{gear}</component>
        <component id="2" type="cylindrical_gear_flank">{flank}</component>
        <component id="3" type="cylindrical_gear_flank">{flank}</component>{part}</components></model>"#
    )
}

fn component(kind: &str, attributes: &[(&str, &str, &str)]) -> String {
    let list: String = attributes
        .iter()
        .map(|(id, unit, v)| format!(r#"<attribute id="{id}" unit="{unit}">{v}</attribute>"#))
        .collect();
    format!(r#"<component id="4" type="{kind}" sign="material_removed">{list}</component>"#)
}

fn gear(text: &str) -> Result<(RexsGear, Vec<RexsWarning>), RexsError> {
    gear_of(&parse_rexs(text.as_bytes())?, 1)
}

fn code(text: &str) -> &'static str {
    gear(text).unwrap_err().code()
}

const SLOPE: [(&str, &str, &str); 4] = [
    ("profile_slope", "mm", "0.004"),
    ("profile_evaluation_start", "mm", "78"),
    ("profile_evaluation_end", "mm", "87.4"),
    ("diameter_where_profile_slope_amount_is_specified", "mm", "87.4"),
];

#[test]
fn units_are_converted_or_refused() {
    let with = |unit: &'static str, value: &'static str| {
        let mut list = SLOPE;
        list[0] = ("profile_slope", unit, value);
        xml(&component("profile_slope", &list))
    };
    for (unit, value) in [("mm", "0.004"), ("mum", "4"), ("mum", "4e0")] {
        let (found, warnings) = gear(&with(unit, value)).unwrap();
        assert!(warnings.is_empty(), "{warnings:?}");
        let ModificationSpec::ProfileSlope(slope) = &found.modifications.left[0] else { panic!("a slope") };
        assert!((slope.amount_um - 4.0).abs() < 1e-12);
        assert_eq!(found.fields.left.start_diameter_mm, Some(78.0));
    }
    for unit in ["m", "inch", "deg", "none", "N / mm^2"] {
        assert_eq!(code(&with(unit, "4")), "unknown-unit", "{unit}");
    }
    assert_eq!(code(&with("mm", "x")), "bad-value");
    assert_eq!(code(&with("mm", "nan")), "bad-value");
    let plain = xml(&component("profile_slope", &SLOPE));
    let degree = plain.replace(
        r#"unit="deg">20</attribute><attribute id="face_width""#,
        r#"unit="°">20</attribute><attribute id="face_width""#,
    );
    assert_eq!(gear(&degree).unwrap().0.helix_angle_deg, 20.0);
    let radian = plain.replace(
        r#"unit="deg">20</attribute><attribute id="face_width""#,
        r#"unit="rad">0.3490658503988659</attribute><attribute id="face_width""#,
    );
    assert!((gear(&radian).unwrap().0.helix_angle_deg - 20.0).abs() < 1e-12);
}

#[test]
fn a_slope_may_be_stated_anywhere_on_its_range() {
    let mut list = SLOPE;
    // Half way along the length of roll: half the amount at the end.
    let body = gear(&xml(&component("profile_slope", &SLOPE))).unwrap().0.body().unwrap();
    let involute = body.flank(foundation::geometry::Flank::Left);
    let middle = 0.5 * (involute.length_of_roll(39.0).unwrap() + involute.length_of_roll(43.7).unwrap());
    let at = (2.0 * involute.radius(middle)).to_string();
    list[3].2 = &at;
    let (found, _) = gear(&xml(&component("profile_slope", &list))).unwrap();
    let ModificationSpec::ProfileSlope(slope) = &found.modifications.left[0] else { panic!("a slope") };
    assert!((slope.amount_um - 8.0).abs() < 1e-9, "{}", slope.amount_um);
    list[3].2 = "78";
    assert_eq!(code(&xml(&component("profile_slope", &list))), "bad-value");
    list[3].2 = "60";
    assert_eq!(code(&xml(&component("profile_slope", &list))), "bad-value");
}

#[test]
fn absent_signs_and_ranges_are_told() {
    let text = xml(&component("profile_slope", &SLOPE)).replace(r#" sign="material_removed""#, "");
    let (_, warnings) = gear(&text).unwrap();
    assert_eq!(warnings.iter().map(|w| w.kind.code()).collect::<Vec<_>>(), ["sign-assumed"]);
    let relief = component(
        "end_relief_datum_face",
        &[("end_relief_depth_datum_face", "mm", "0.01"), ("end_relief_length_datum_face", "mm", "3")],
    );
    let (found, warnings) = gear(&xml(&relief)).unwrap();
    assert!(matches!(found.modifications.left[0], ModificationSpec::EndReliefII(_)));
    assert_eq!(warnings.iter().map(|w| w.kind.code()).collect::<Vec<_>>(), ["assumed"; 3]);
    assert_eq!(found.fields.left.end_diameter_mm, Some(88.4));
    let other = component("profile_slope", &SLOPE)
        + &component(
            "profile_twist",
            &[("profile_twist", "mm", "0.004"), ("profile_twist_evaluation_start", "mm", "79")],
        )
        .replace("id=\"4\"", "id=\"5\"");
    let text = xml(&other).replace("</relations>", r#"<relation id="3" type="reference"><ref id="2" role="origin"/><ref id="5" role="referenced"/></relation></relations>"#);
    let (found, warnings) = gear(&text).unwrap();
    assert_eq!((found.modifications.left.len(), warnings[0].kind), (2, RexsWarningKind::RangesDiffer));
    let version = xml("").replace("2.0.0", "1.6").replace(r#"<relation id="2" type="reference"><ref id="2" role="origin"/><ref id="4" role="referenced"/></relation>"#, "");
    assert_eq!(gear(&version).unwrap().1[0].kind, RexsWarningKind::Version);
}

#[test]
fn crownings_of_two_arcs() {
    let with = |tip: &str, apex: &[(&'static str, &'static str, &'static str)]| {
        let mut list = vec![
            ("profile_crowning_at_root", "mm", "0.002"),
            ("profile_crowning_at_tip", "mm", tip),
            ("diameter_where_profile_crowning_root_is_specified", "mm", "78"),
            ("diameter_where_profile_crowning_tip_is_specified", "mm", "87.4"),
        ];
        list.extend(apex);
        gear(&xml(&component("profile_crowning", &list)))
    };
    let kind = |found: Result<(RexsGear, _), _>| found.map(|(gear, _)| gear.modifications.left[0].kind());
    let high = [("profile_highest_point", "mm", "82")];
    assert_eq!(kind(with("0.003", &[])).unwrap_err().code(), "two-arc-crowning");
    assert_eq!(kind(with("0.003", &high)), Ok("profile_crowning_two_arc"));
    assert_eq!(kind(with("0.002", &high)), Ok("profile_crowning_two_arc"));
    assert_eq!(kind(with("0.002", &[])), Ok("profile_crowning"));
    assert_eq!(
        kind(with("0.002", &[("shape_of_profile_crowning", "none", "circular")])),
        Ok("profile_crowning_arc")
    );
}

#[test]
fn topographies_by_points_by_axes_and_coded() {
    let array = |list: &[f64]| -> String {
        let cells: String = list.iter().map(|v| format!("<c>{v}</c>")).collect();
        format!("<array>{cells}</array>")
    };
    let with = |xi: &[f64], d: &[f64], amounts: &str| {
        let (xi, d) = (array(xi), array(d));
        xml(&component(
            "topographical_modification",
            &[
                ("coordinates_of_topographical_modification", "mm", &xi),
                ("diameters_of_topographical_modification", "mm", &d),
                ("topographical_modification_amounts", "mm", amounts),
            ],
        ))
    };
    let (xi, d) = ([5.0, 12.0, 18.0, 25.0], [79.0, 81.0, 83.0, 86.0]);
    let amounts: Vec<f64> = (0..16).map(|k| 1e-3 * f64::from(k)).collect();
    let (axes, _) = gear(&with(&xi, &d, &array(&amounts))).unwrap();
    let ModificationSpec::Grid(grid) = &axes.modifications.left[0] else { panic!("a grid") };
    // Distance 25 mm from the face at +z is z = -10; amounts removed are negative here.
    assert_eq!((grid.z_mm[0], grid.f_um[0][0], grid.f_um[3][0]), (-10.0, -12.0, -15.0));
    let points_xi: Vec<f64> = xi.iter().flat_map(|x| [*x; 4]).collect();
    let points_d = d.repeat(4);
    let (points, _) = gear(&with(&points_xi, &points_d, &array(&amounts))).unwrap();
    assert_eq!(points.modifications, axes.modifications);
    let bytes: Vec<u8> = amounts.iter().flat_map(|v| v.to_le_bytes()).collect();
    let packed = base64::Engine::encode(&base64::engine::general_purpose::STANDARD, bytes);
    let coded = format!(r#"<array code="float64">{packed}</array>"#);
    assert_eq!(gear(&with(&xi, &d, &coded)).unwrap().0.modifications, axes.modifications);
    // Few places are no spline.
    let (few, _) = gear(&with(&xi[..2], &d[..2], &array(&amounts[..4]))).unwrap();
    assert_eq!(few.modifications.left[0].kind(), "points");
    assert_eq!(code(&with(&xi, &d, &array(&amounts[..15]))), "array-length");
    assert_eq!(code(&with(&[], &[], &array(&[]))), "array-length");
    assert_eq!(code(&with(&points_xi[..15], &points_d[..15], &array(&amounts[..15]))), "grid-incomplete");
    let mut twice = points_d.clone();
    twice[3] = 79.0;
    assert_eq!(code(&with(&points_xi, &twice, &array(&amounts))), "grid-incomplete");
    assert_eq!(code(&with(&xi, &[60.0, 81.0, 83.0, 86.0], &array(&amounts))), "bad-value");
    assert_eq!(code(&with(&xi, &d, r#"<array code="float64">###</array>"#)), "bad-value");
}

#[test]
fn gears_without_flanks_or_data_are_refused() {
    let none = xml("").replace(r#"<relation id="2" type="reference"><ref id="2" role="origin"/><ref id="4" role="referenced"/></relation>"#, "");
    assert!(gear(&none).is_ok());
    assert_eq!(code(&none.replace(r#"type="flank""#, r#"type="stage""#)), "no-flank-relation");
    assert_eq!(code(&none.replace(r#"role="right""#, r#"role="other""#)), "no-flank-relation");
    assert_eq!(
        code(&none.replace(r#"id="normal_module""#, r#"id="transverse_module""#)),
        "missing-attribute"
    );
    assert_eq!(code(&none.replace(">2.5<", ">0<")), "no-gear");
    assert_eq!(code(&none.replace(">30<", ">0<")), "bad-value");
    assert_eq!(code(&none.replace(">positive<", ">up<")), "bad-value");
    assert_eq!(
        code(&none.replace(r#"id="3" type="cylindrical_gear_flank""#, r#"id="3" type="shaft""#)),
        "rexs-structure"
    );
    let document = parse_rexs(none.as_bytes()).unwrap();
    assert_eq!(gear_of(&document, 9).unwrap_err().code(), "rexs-structure");
    assert_eq!(gear_of(&document, 2).unwrap_err().code(), "rexs-structure");
}
