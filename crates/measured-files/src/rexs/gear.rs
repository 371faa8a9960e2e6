//! A gear as REXS describes it, in the terms of this program; and how it is found in a document.

use serde::{Deserialize, Serialize};

use super::document::{Component, Content, Relation, RexsDocument, Value};
use super::error::RexsError;
use super::flank::FlankPlace;
use super::values::{Asked, title};
use super::warning::{RexsWarning, RexsWarningKind};
use super::{deviations, modification_read};
use crate::inspection::{DatumFace, Trace};
use foundation::geometry::{Flank, Gear, GearData, GeometryError, Sides};
use foundation::modification::ModificationSpec;

/// The field on which a flank is evaluated; what is not stated is absent. Lengths in mm.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct FlankField {
    /// Diameter at the root end of the evaluated profile.
    pub start_diameter_mm: Option<f64>,
    /// Diameter at its tip end.
    pub end_diameter_mm: Option<f64>,
    /// Lower end along the face width, from its middle; absent: the face.
    pub z_start_mm: Option<f64>,
    /// Upper end along the face width; absent: the face.
    pub z_end_mm: Option<f64>,
}

/// A cylindrical gear with modifications and measured deviations.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RexsGear {
    /// Its name.
    pub name: Option<String>,
    /// Number of teeth, < 0 internal.
    pub teeth: i32,
    /// Normal module, mm.
    pub normal_module_mm: f64,
    /// Normal pressure angle, degree.
    pub normal_pressure_angle_deg: Sides<f64>,
    /// Helix angle, degree, > 0 right-handed.
    pub helix_angle_deg: f64,
    /// Profile shift coefficient.
    pub profile_shift: f64,
    /// Face width, mm.
    pub face_width_mm: f64,
    /// Tip diameter, mm.
    pub tip_diameter_mm: Option<f64>,
    /// Root diameter, mm.
    pub root_diameter_mm: Option<f64>,
    /// The face that coordinates in the file count from.
    pub datum_face: DatumFace,
    /// Evaluated fields.
    pub fields: Sides<FlankField>,
    /// Modifications of each flank.
    pub modifications: Sides<Vec<ModificationSpec>>,
    /// Measured profiles and helix traces, f > 0 material.
    pub deviations: Vec<Trace>,
}

impl RexsGear {
    /// The body.
    ///
    /// # Errors
    /// Those of [`Gear::new`].
    pub fn body(&self) -> Result<Gear, GeometryError> {
        Gear::new(GearData {
            teeth: self.teeth,
            normal_module: self.normal_module_mm,
            pressure_angle: self.normal_pressure_angle_deg.map(|_, angle| angle.to_radians()),
            helix_angle: self.helix_angle_deg.to_radians(),
            profile_shift: self.profile_shift,
            cone_angle: 0.0,
        })
    }

    /// A flank with the coordinates of its file.
    pub(super) fn place(&self, body: &Gear, flank: Flank) -> FlankPlace {
        let involute = *body.flank(flank);
        FlankPlace { involute, face_width: self.face_width_mm, datum_face: self.datum_face }
    }
}

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
        face_width_mm,
        tip_diameter_mm: of.optional("tip_diameter")?,
        root_diameter_mm: of.optional("root_diameter")?,
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
