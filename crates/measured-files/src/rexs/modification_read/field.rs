//! The evaluated field of a flank, from the ranges that its components state.

use super::super::document::Component;
use super::super::error::RexsError;
use super::super::flank::FlankPlace;
use super::super::flank_field::FlankField;
use super::super::gear::RexsGear;
use super::super::values::{Asked, title};
use super::super::warning::{RexsWarning, RexsWarningKind};
use crate::inspection::DatumFace;

/// Ends nearer than this are one, mm.
const SAME_MM: f64 = 1e-6;

/// Where components state the diameter of the root end and of the tip end, the most direct first.
const DIAMETERS: [(&str, [&str; 2]); 5] = [
    ("profile_slope", ["profile_evaluation_start", "profile_evaluation_end"]),
    ("profile_twist", ["profile_twist_evaluation_start", "profile_twist_evaluation_end"]),
    (
        "profile_crowning",
        [
            "diameter_where_profile_crowning_root_is_specified",
            "diameter_where_profile_crowning_tip_is_specified",
        ],
    ),
    ("root_relief", ["root_relief_evaluation_reference", ""]),
    ("tip_relief", ["", "tip_relief_evaluation_reference"]),
];

/// Where they state the distances of the two ends from the datum face, the near one first.
const COORDINATES: [(&str, [&str; 2]); 3] = [
    ("helix_slope", ["helix_evaluation_start", "helix_evaluation_end"]),
    ("profile_twist", ["position_of_profile_twist_datum_face", "position_of_profile_twist_non_datum_face"]),
    (
        "helix_crowning",
        [
            "coordinate_where_helix_crowning_is_specified_datum_face",
            "coordinate_where_helix_crowning_is_specified_non_datum_face",
        ],
    ),
];

/// The field of a flank.
pub(super) fn of(
    parts: &[&Component],
    place: &FlankPlace,
    gear: &RexsGear,
    warnings: &mut Vec<RexsWarning>,
) -> Result<FlankField, RexsError> {
    let mut end = |table: &[(&str, [&'static str; 2])], which: usize| {
        let mut first: Option<(f64, &Component)> = None;
        for (kind, ids) in table {
            for part in parts.iter().filter(|part| part.kind == *kind) {
                let Some(value) = Asked(part).optional(ids[which])? else { continue };
                match first {
                    None => first = Some((value, *part)),
                    Some((known, stated_by)) if (known - value).abs() > SAME_MM => {
                        let message = format!(
                            "{} ends its range at {value} mm, {} at {known} mm; the amounts are taken for the latter",
                            title(part),
                            title(stated_by)
                        );
                        warnings.push(RexsWarning::new(RexsWarningKind::RangesDiffer, message));
                    }
                    Some(_) => {}
                }
            }
        }
        Ok::<_, RexsError>(first.map(|(value, _)| value))
    };
    let diameters = [end(&DIAMETERS, 0)?, end(&DIAMETERS, 1)?];
    let (near, far) = (end(&COORDINATES, 0)?, end(&COORDINATES, 1)?);
    let [near, far] = [near, far].map(|xi| xi.map(|xi| place.height(xi)));
    let (z_start_mm, z_end_mm) = match place.datum_face {
        DatumFace::PlusZ => (far, near),
        DatumFace::MinusZ => (near, far),
    };
    let needed = parts.iter().any(|part| part.kind != "topographical_modification");
    let mut assumed = |stated: Option<f64>, stand_in: Option<f64>, what: &str| {
        if stated.is_none() && needed {
            let flank = place.involute.flank;
            let words = match stand_in {
                Some(value) => format!("{what} of the {flank} flank is not stated; {value} mm is taken"),
                None => format!("{what} of the {flank} flank is not stated"),
            };
            warnings.push(RexsWarning::new(RexsWarningKind::Assumed, words));
        }
        stated.or(stand_in.filter(|_| needed))
    };
    // Below the base circle there is no profile to begin.
    let base = 2.0 * place.involute.base_radius;
    let root = if gear.teeth < 0 { gear.tip_diameter_mm } else { gear.root_diameter_mm };
    let tip = if gear.teeth < 0 { gear.root_diameter_mm } else { gear.tip_diameter_mm };
    Ok(FlankField {
        start_diameter_mm: assumed(diameters[0], root.map(|d| d.max(base)), "the start of the profile"),
        end_diameter_mm: assumed(diameters[1], tip, "the end of the profile"),
        z_start_mm,
        z_end_mm,
    })
}
