//! How a gear is found in a document.

use super::document::{Component, Content, Relation, RexsDocument, Value};
use super::error::RexsError;
use super::gear::RexsGear;
use super::thickness::{RexsThickness, read_class};
use super::values::{Asked, title};
use super::warning::{RexsWarning, RexsWarningKind};
use super::{deviations, modification_read};
use crate::inspection::DatumFace;
use foundation::geometry::{Flank, Sides};

const GEARS: [&str; 2] = ["cylindrical_gear", "ring_gear"];

const FLANK: &str = "cylindrical_gear_flank";

/// Numbers of the gears in a document, in its order.
pub fn gear_ids(document: &RexsDocument) -> Vec<i32> {
    let gears = document.components.iter().filter(|component| GEARS.contains(&component.kind.as_str()));
    gears.map(|component| component.id).collect()
}

/// A gear of a document with everything its flanks refer to, and what was assumed or not used.
///
/// # Errors
/// [`RexsError::NoFlankRelation`], [`RexsError::MissingAttribute`], [`RexsError::UnknownUnit`], [`RexsError::BadValue`],
/// [`RexsError::ArrayLength`], [`RexsError::GridIncomplete`], [`RexsError::TwoArcCrowning`], [`RexsError::NoGear`];
/// [`RexsError::Structure`] where components are of other types than their roles.
pub fn gear_of(document: &RexsDocument, id: i32) -> Result<(RexsGear, Vec<RexsWarning>), RexsError> {
    let mut warnings = Vec::new();
    if !document.version.starts_with("2.") {
        let message = format!("the file is of REXS {}; it is read as 2.0", document.version);
        warnings.push(RexsWarning::new(RexsWarningKind::Version, message));
    }
    let component = of_type(document, id, &GEARS)?;
    let flanks = flanks(document, id)?;
    let mut gear = drawing(component, flanks, &mut warnings)?;
    not_used(component, &mut warnings);
    let body = gear.body().map_err(|error| RexsError::NoGear { gear: id, error })?;
    gear.thickness = RexsThickness::read(component, &body, &mut warnings)?;
    for flank in Flank::BOTH {
        not_used(flanks[flank], &mut warnings);
        let place = gear.place(&body, flank);
        let parts = parts(document, flanks[flank].id)?;
        for part in &parts {
            not_used(part, &mut warnings);
        }
        let read = modification_read::flank(&parts, &place, &gear, &mut warnings)?;
        gear.fields[flank] = read.field;
        gear.modifications[flank] = read.modifications;
        for part in parts {
            gear.deviations.extend(deviations::read(part, &place, &mut warnings)?);
        }
    }
    Ok((gear, warnings))
}

/// Drawing data, nothing on the flanks yet.
fn drawing(
    component: &Component,
    flanks: Sides<&Component>,
    warnings: &mut Vec<RexsWarning>,
) -> Result<RexsGear, RexsError> {
    let of = Asked(component);
    let bad = |attribute: &str, value: String, allowed| {
        Err(RexsError::BadValue { component: title(component), attribute: attribute.into(), value, allowed })
    };
    let teeth = of.integer("number_of_teeth")?;
    let face_width_mm = of.number("face_width")?;
    if face_width_mm.is_nan() || face_width_mm <= 0.0 {
        return bad("face_width", face_width_mm.to_string(), "more than 0");
    }
    let datum_face = match of.word("datum_face_orientation")? {
        Some("positive") => DatumFace::PlusZ,
        Some("negative") => DatumFace::MinusZ,
        Some(other) => {
            return bad("datum_face_orientation", other.chars().take(60).collect(), "positive or negative");
        }
        None => {
            let message = format!(
                "{} does not say which face is the datum face; that at +z is taken",
                title(component)
            );
            warnings.push(RexsWarning::new(RexsWarningKind::Assumed, message));
            DatumFace::PlusZ
        }
    };
    let shifts = Sides::try_from_fn(|flank| {
        let shift = Asked(flanks[flank]).optional("addendum_modification_coefficient")?;
        if shift.is_none() {
            let message = format!("{} states no profile shift; 0 is taken", title(flanks[flank]));
            warnings.push(RexsWarning::new(RexsWarningKind::Assumed, message));
        }
        Ok(shift.unwrap_or(0.0))
    })?;
    // One rack makes both flanks of a space.
    if (shifts.left - shifts.right).abs() > 1e-9 {
        let values = format!("{} on the left and {} on the right flank", shifts.left, shifts.right);
        return bad("addendum_modification_coefficient", values, "the same on both flanks");
    }
    Ok(RexsGear {
        name: component.name.clone(),
        teeth: if component.kind == "ring_gear" { -teeth.saturating_abs() } else { teeth },
        normal_module_mm: of.number("normal_module")?,
        normal_pressure_angle_deg: Sides::try_from_fn(|f| Asked(flanks[f]).number("normal_pressure_angle"))?,
        helix_angle_deg: of.number("helix_angle_reference_diameter")?,
        profile_shift: shifts.left,
        thickness: None,
        tolerance_class: read_class(component)?,
        face_width_mm,
        tip_diameter_mm: of.optional("tip_diameter")?,
        root_diameter_mm: of.optional("root_diameter")?,
        form_diameter_mm: of.optional("root_form_diameter")?,
        datum_face,
        fields: Sides::default(),
        modifications: Sides::default(),
        deviations: Vec::new(),
    })
}

/// The flanks that the relation `flank` names.
fn flanks(document: &RexsDocument, gear: i32) -> Result<Sides<&Component>, RexsError> {
    let is_it = |relation: &&Relation| relation.kind == "flank" && relation.role("gear") == Some(gear);
    let relation = document.relations.iter().find(is_it).ok_or(RexsError::NoFlankRelation { gear })?;
    Sides::try_from_fn(|flank| {
        let id = relation.role(flank.name()).ok_or(RexsError::NoFlankRelation { gear })?;
        of_type(document, id, &[FLANK])
    })
}

fn of_type<'a>(document: &'a RexsDocument, id: i32, kinds: &[&str]) -> Result<&'a Component, RexsError> {
    let place = format!("component {id}");
    let Some(component) = document.component(id) else {
        return Err(RexsError::Structure { place, what: "it is not there".into() });
    };
    if kinds.contains(&component.kind.as_str()) {
        return Ok(component);
    }
    let found: String = component.kind.chars().take(60).collect();
    Err(RexsError::Structure { place, what: format!("its type is `{found}`, not {}", kinds.join(" or ")) })
}

/// What refers to a flank, in the order of the file.
fn parts(document: &RexsDocument, flank: i32) -> Result<Vec<&Component>, RexsError> {
    let relations = document.relations.iter();
    let to_flank = relations.filter(|r| r.kind == "reference" && r.role("origin") == Some(flank));
    let referenced = to_flank.filter_map(|relation| document.component(relation.role("referenced")?));
    Ok(referenced.collect())
}

/// One remark for all attributes of a component that are only kept.
fn not_used(component: &Component, warnings: &mut Vec<RexsWarning>) {
    let what = match &component.content {
        Content::Opaque(_) => "is of a type that is not read".to_owned(),
        Content::Attributes(list) => {
            let kept = list.iter().filter(|a| matches!(a.value, Value::Opaque(_)));
            let names: Vec<String> = kept.map(|a| a.id.chars().take(80).collect()).collect();
            if names.is_empty() {
                return;
            }
            format!("has attributes that are not read: {}", names.join(", "))
        }
    };
    warnings.push(RexsWarning::new(RexsWarningKind::NotUsed, format!("{} {what}", title(component))));
}
