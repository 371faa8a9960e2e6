//! A gear as a document: gear, two flanks, their modifications and deviations, and the relations between them.

use super::deviations;
use super::document::{Component, ComponentRef, Content, Relation, RexsDocument};
use super::draft::Draft;
use super::error::RexsError;
use super::gear::RexsGear;
use super::modification_write::Writer;
use super::signs::{MATERIAL, REMOVED};
use super::thickness::write_class;
use super::warning::RexsWarning;
use crate::inspection::DatumFace;
use foundation::geometry::Flank;
use foundation::modification::ModificationFiles;

/// Who writes a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Author {
    /// The program.
    pub application: String,
    /// Its version.
    pub version: String,
    /// The time of writing, ISO 8601; the caller's, so that the same job can give the same bytes.
    pub date: String,
}

impl Author {
    /// This program at a time.
    pub fn flankwright(date: impl Into<String>) -> Self {
        let version = env!("CARGO_PKG_VERSION").into();
        Self { application: "flankwright".into(), version, date: date.into() }
    }
}

/// The document of one gear, and what is sampled or lost in it. `files` finds tables that modifications lie in.
///
/// # Errors
/// [`RexsError::NoGear`], [`RexsError::Modification`], [`RexsError::NoValue`]; [`RexsError::NotExpressibleInRexs`] where the
/// field of a modified flank is not known.
pub fn document_of(
    gear: &RexsGear,
    files: &dyn ModificationFiles,
    author: &Author,
) -> Result<(RexsDocument, Vec<RexsWarning>), RexsError> {
    let body = gear.body().map_err(|error| RexsError::NoGear { gear: 0, error })?;
    let mut warnings = Vec::new();
    let mut made = Made { components: Vec::new(), relations: Vec::new() };
    let gear_id = made.add(of_gear(gear), gear.name.clone(), None);
    let flanks = Flank::BOTH.map(|flank| {
        let draft = Draft::new("cylindrical_gear_flank")
            .number("normal_pressure_angle", gear.normal_pressure_angle_deg[flank])
            .number("addendum_modification_coefficient", gear.profile_shift);
        made.add(draft, Some(format!("{flank} flank")), None)
    });
    let [left, right] = flanks;
    made.relate("flank", &[("gear", gear_id), ("left", left), ("right", right)]);
    for (flank, id) in Flank::BOTH.into_iter().zip(flanks) {
        let place = gear.place(&body, flank);
        if !gear.modifications[flank].is_empty() {
            let mut field = gear.fields[flank];
            field.end_diameter_mm = field.end_diameter_mm.or(gear.tip_diameter_mm);
            let field = place.field(&field)?;
            for spec in &gear.modifications[flank] {
                let mut writer = Writer { place: &place, field: &field, files, warnings: &mut warnings };
                let part = made.add(writer.write(spec)?, None, Some(REMOVED));
                made.relate("reference", &[("origin", id), ("referenced", part)]);
            }
        }
        for trace in gear.deviations.iter().filter(|trace| trace.flank == flank) {
            let draft = deviations::write(trace, &place, &mut warnings);
            let part = made.add(draft, Some(deviations::name(trace)), Some(MATERIAL));
            made.relate("reference", &[("origin", id), ("referenced", part)]);
        }
    }
    let document = RexsDocument {
        version: "2.0.0".into(),
        application_id: author.application.clone(),
        application_version: author.version.clone(),
        date: author.date.clone(),
        language: Some("en".into()),
        relations: made.relations,
        components: made.components,
        load_spectra: Vec::new(),
    };
    Ok((document, warnings))
}

fn of_gear(gear: &RexsGear) -> Draft {
    let orientation = match gear.datum_face {
        DatumFace::PlusZ => "positive",
        DatumFace::MinusZ => "negative",
    };
    let draft = Draft::new(if gear.teeth < 0 { "ring_gear" } else { "cylindrical_gear" })
        .integer("number_of_teeth", gear.teeth)
        .number("normal_module", gear.normal_module_mm)
        .number("helix_angle_reference_diameter", gear.helix_angle_deg)
        .number("face_width", gear.face_width_mm)
        .optional("tip_diameter", gear.tip_diameter_mm)
        .optional("root_diameter", gear.root_diameter_mm)
        .optional("root_form_diameter", gear.form_diameter_mm)
        .word("datum_face_orientation", orientation);
    let draft = match &gear.thickness {
        Some(thickness) => thickness.write(draft),
        None => draft,
    };
    write_class(draft, gear.tolerance_class)
}

struct Made {
    components: Vec<Component>,
    relations: Vec<Relation>,
}

impl Made {
    /// Numbers count from 1 in the order of making.
    fn add(&mut self, draft: Draft, name: Option<String>, sign: Option<&str>) -> i32 {
        let id = i32::try_from(self.components.len() + 1).unwrap_or(i32::MAX);
        self.components.push(Component {
            id,
            kind: draft.kind.into(),
            name,
            sign: sign.map(str::to_owned),
            content: Content::Attributes(draft.attributes),
        });
        id
    }

    fn relate(&mut self, kind: &str, ends: &[(&str, i32)]) {
        let id = i32::try_from(self.relations.len() + 1).unwrap_or(i32::MAX);
        let hint = |id: i32| self.components.iter().find(|c| c.id == id).map(|c| c.kind.clone());
        let refs = ends.iter().map(|&(role, id)| ComponentRef { id, role: role.into(), hint: hint(id) });
        let refs = refs.collect();
        self.relations.push(Relation { id, kind: kind.into(), order: None, refs });
    }
}
