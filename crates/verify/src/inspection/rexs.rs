//! Block `rexs`: a gear with modifications written for both datum faces, attribute by attribute, and read back from every form of file.

use super::super::expected::Expected;
use super::super::given::{Checked, check_object, text};
use super::super::ledger::Ledger;
use super::super::reference::{Reference, Tolerances};
use foundation::geometry::{Flank, Sides};
use foundation::modification::{ModificationSpec, NoFiles};
use measured_files::inspection::DatumFace;
use measured_files::rexs::{
    Author, Component, Content, FlankField, RexsDocument, RexsFormat, RexsGear, Value as RexsValue,
    document_of, gear_ids, gear_of, parse_rexs, rexs_bytes,
};
use serde::Deserialize;
use serde_json::Value;

/// The gear of a case.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Body {
    z: i32,
    m_n: f64,
    beta_deg: f64,
    b: f64,
    d_a: f64,
    datum_face: DatumFace,
    x: f64,
    alpha_left_deg: f64,
    alpha_right_deg: f64,
    r_b_left: f64,
    r_b_right: f64,
    geo: Sides<Field>,
}

/// The evaluated field of a flank.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
#[expect(non_snake_case, reason = "the file's own names")]
struct Field {
    w_f: f64,
    w_a: f64,
    z_I: f64,
    z_II: f64,
}

/// Block `rexs`.
pub(crate) fn rexs(_: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    let Some(list) = block.as_array().filter(|list| !list.is_empty()) else {
        return ledger.fail("rexs", "", block.clone(), "a list of cases is needed here".into());
    };
    for item in list {
        let case = item["name"].as_str().unwrap_or("rexs");
        let expected = Expected::new(case, "", item, ledger);
        check_object(expected, ledger, check);
    }
}

fn check(item: &mut Expected<'_>, ledger: &mut Ledger) -> Checked {
    item.informative(&["name"]);
    let tolerance = Tolerances::table(item.take("tolerance").unwrap_or(&Value::Null));
    let (mm, um) = (tolerance.get("mm"), tolerance.get("um"));
    let input = item.take("input").ok_or("input is missing")?;
    let body = Body::deserialize(&input["gear"])?;
    let gear = gear(&body, &input["modifications"])?;
    let made = gear.body()?;
    for (flank, given) in [(Flank::Left, body.r_b_left), (Flank::Right, body.r_b_right)] {
        let name = format!("input.gear.r_b_{flank}");
        ledger.number(item.case(), &name, given, made.flank(flank).base_radius, mm);
    }
    let (document, warnings) = document_of(&gear, &NoFiles, &Author::flankwright("2026-01-01"))?;
    if let Some(warning) = warnings.first() {
        return Err(format!("written with a loss: {warning}").into());
    }
    let mut worst: f64 = 0.0;
    for format in [RexsFormat::Xml, RexsFormat::Json] {
        for packed in [false, true] {
            let (bytes, _) = rexs_bytes(&document, format, packed)?;
            let back = parse_rexs(&bytes)?;
            let id = gear_ids(&back).first().copied().ok_or("no gear in the file")?;
            let (read, _) = gear_of(&back, id)?;
            worst = worst.max(apart(&gear.modifications, &read.modifications)?);
            if let Some(mut of_file) =
                item.peek("expected").map(|value| Expected::new(item.case(), "expected", value, ledger))
            {
                check_document(&back, &read, &mut of_file, mm, ledger)?;
                of_file.finish(ledger);
            }
        }
    }
    item.take("expected").ok_or("expected is missing")?;
    item.at_most("round_trip_worst", worst, um, ledger);
    Ok(())
}

fn gear(body: &Body, modifications: &Value) -> Checked<RexsGear> {
    let specs = |flank: Flank| -> Checked<Vec<ModificationSpec>> {
        let list = modifications[flank.name()]
            .as_array()
            .ok_or("input.modifications: a list is needed for each flank")?;
        let one = |value: &Value| {
            let mut value = value.clone();
            value["flank"] = flank.name().into();
            Ok(ModificationSpec::from_json(&value)?)
        };
        list.iter().map(one).collect()
    };
    let mut gear = RexsGear {
        name: None,
        teeth: body.z,
        normal_module_mm: body.m_n,
        normal_pressure_angle_deg: Sides { left: body.alpha_left_deg, right: body.alpha_right_deg },
        helix_angle_deg: body.beta_deg,
        profile_shift: body.x,
        thickness: None,
        tolerance_class: None,
        face_width_mm: body.b,
        tip_diameter_mm: Some(body.d_a),
        root_diameter_mm: None,
        form_diameter_mm: None,
        datum_face: body.datum_face,
        fields: Sides::default(),
        modifications: Sides::try_from_fn(specs)?,
        deviations: Vec::new(),
    };
    let made = gear.body()?;
    gear.fields = body.geo.map(|flank, geo| {
        let diameter = |w| Some(2.0 * made.flank(flank).radius(w));
        FlankField {
            start_diameter_mm: diameter(geo.w_f),
            end_diameter_mm: diameter(geo.w_a),
            z_start_mm: Some(geo.z_I),
            z_end_mm: Some(geo.z_II),
        }
    });
    Ok(gear)
}

/// Largest difference of two descriptions, um and mm alike; what differs in kind is an error.
fn apart(ours: &Sides<Vec<ModificationSpec>>, theirs: &Sides<Vec<ModificationSpec>>) -> Checked<f64> {
    fn walk(a: &Value, b: &Value, worst: &mut f64) -> bool {
        match (a, b) {
            (Value::Object(a), Value::Object(b)) => {
                a.len() == b.len() && a.iter().all(|(k, a)| b.get(k).is_some_and(|b| walk(a, b, worst)))
            }
            (Value::Array(a), Value::Array(b)) => {
                a.len() == b.len() && a.iter().zip(b).all(|(a, b)| walk(a, b, worst))
            }
            _ => match (a.as_f64(), b.as_f64()) {
                (Some(a), Some(b)) => {
                    *worst = worst.max((a - b).abs());
                    true
                }
                _ => a == b,
            },
        }
    }
    let mut worst = 0.0;
    if walk(&serde_json::to_value(ours)?, &serde_json::to_value(theirs)?, &mut worst) {
        return Ok(worst);
    }
    Err("the modifications that were read are others than those written".into())
}

fn check_document(
    document: &RexsDocument,
    read: &RexsGear,
    expected: &mut Expected<'_>,
    mm: f64,
    ledger: &mut Ledger,
) -> Checked {
    if let Some(mut gear) = expected.object("gear", ledger) {
        gear.whole("z", read.teeth.into(), ledger);
        gear.numbers(
            &[("m_n", read.normal_module_mm), ("beta_deg", read.helix_angle_deg), ("b", read.face_width_mm)],
            mm,
            ledger,
        );
        let face = serde_json::to_value(read.datum_face)?;
        gear.text("datum_face", face.as_str().unwrap_or_default(), ledger);
        gear.finish(ledger);
    }
    let relation = document.relations.iter().find(|r| r.kind == "flank").ok_or("no relation `flank`")?;
    let roles: Vec<&str> =
        relation.refs.iter().map(|end| end.role.as_str()).filter(|role| *role != "gear").collect();
    super::super::given::compare_texts(expected, "flank_order", &roles, ledger);
    let is_part = |c: &&Component| {
        !["cylindrical_gear", "ring_gear", "cylindrical_gear_flank"].contains(&c.kind.as_str())
    };
    let parts: Vec<&Component> = document.components.iter().filter(is_part).collect();
    let wanted = expected.objects("components", ledger);
    ledger.equal(expected.case(), "expected.components, number", wanted.len().into(), parts.len().into());
    for (mut wanted, part) in wanted.into_iter().zip(parts) {
        let kind = text(&mut wanted, "type", ledger)?;
        ledger.equal(wanted.case(), &wanted.name("type"), kind.into(), part.kind.as_str().into());
        if let Some(mut attributes) = wanted.object("attributes", ledger) {
            check_attributes(part, &mut attributes, mm, ledger);
            attributes.finish(ledger);
        }
        wanted.finish(ledger);
    }
    Ok(())
}

/// Every attribute that was written is expected, and the other way about.
fn check_attributes(part: &Component, expected: &mut Expected<'_>, mm: f64, ledger: &mut Ledger) {
    let Content::Attributes(list) = &part.content else { return };
    for attribute in list {
        if expected.peek(&attribute.id).is_none() {
            ledger.fail(
                expected.case(),
                &expected.name(&attribute.id),
                Value::Null,
                "written, not expected".into(),
            );
        }
        match &attribute.value {
            RexsValue::Number(value) => expected.number(&attribute.id, *value, mm, ledger),
            RexsValue::Integer(value) => expected.whole(&attribute.id, *value, ledger),
            RexsValue::Boolean(value) => expected.text(&attribute.id, &value.to_string(), ledger),
            RexsValue::Word(word) => expected.text(&attribute.id, word, ledger),
            RexsValue::Numbers(values) => expected.list(&attribute.id, values, mm, ledger),
            RexsValue::Opaque(_) => {}
        }
    }
}
