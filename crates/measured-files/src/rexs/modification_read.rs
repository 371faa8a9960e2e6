//! Components of REXS as modifications of a flank. Amounts hold at the ends of the evaluated field, which is what the components state
//! first; where they disagree, that is reported.

mod crowning;
mod field;
mod relief;

use super::document::Component;
use super::error::RexsError;
use super::flank::FlankPlace;
use super::flank_field::FlankField;
use super::gear::RexsGear;
use super::signs::REMOVED;
use super::topography;
use super::values::{Asked, title};
use super::warning::{RexsWarning, RexsWarningKind};
use foundation::modification::{AmountSpec, EvaluationField, FlankChoice, ModificationSpec, Reference};

/// What a flank carries.
pub(super) struct Read {
    pub field: FlankField,
    pub modifications: Vec<ModificationSpec>,
}

/// Types that hold amounts of modifications.
const MODIFICATIONS: [&str; 10] = [
    "tip_relief",
    "root_relief",
    "profile_crowning",
    "profile_slope",
    "helix_crowning",
    "helix_slope",
    "end_relief_datum_face",
    "end_relief_non_datum_face",
    "profile_twist",
    "topographical_modification",
];

/// Reads what refers to a flank.
pub(super) fn flank(
    parts: &[&Component],
    place: &FlankPlace,
    gear: &RexsGear,
    warnings: &mut Vec<RexsWarning>,
) -> Result<Read, RexsError> {
    let parts: Vec<&Component> =
        parts.iter().copied().filter(|part| MODIFICATIONS.contains(&part.kind.as_str())).collect();
    let field = field::of(&parts, place, gear, warnings)?;
    let mut modifications = Vec::new();
    for part in &parts {
        if let Some(sign) = part.sign.as_ref().filter(|sign| sign.as_str() != REMOVED) {
            return Err(RexsError::BadValue {
                component: title(part),
                attribute: "sign".into(),
                value: sign.to_string(),
                allowed: REMOVED,
            });
        }
        if part.sign.is_none() {
            let message =
                format!("{} does not say what positive amounts mean; material removed is taken", title(part));
            warnings.push(RexsWarning::new(RexsWarningKind::SignAssumed, message));
        }
        if part.kind == "topographical_modification" {
            modifications.push(topography::read(part, place, place.involute.flank, warnings)?);
            continue;
        }
        // A table states its own places; every other amount holds at the ends of the field.
        let whole = place.field(&field)?;
        let mut reader = Reader { part, of: Asked(part), place, field: &whole, warnings };
        modifications.push(reader.read()?);
    }
    Ok(Read { field, modifications })
}

/// Reads one component.
struct Reader<'a> {
    part: &'a Component,
    of: Asked<'a>,
    place: &'a FlankPlace,
    field: &'a EvaluationField,
    warnings: &'a mut Vec<RexsWarning>,
}

impl Reader<'_> {
    fn read(&mut self) -> Result<ModificationSpec, RexsError> {
        match self.part.kind.as_str() {
            "profile_crowning" => self.profile_crowning(),
            "helix_crowning" => self.helix_crowning(),
            "profile_slope" => {
                let amount = self.of.number("profile_slope")? * self.profile_share()?;
                Ok(ModificationSpec::ProfileSlope(self.amount(amount)))
            }
            "helix_slope" => {
                let amount = self.of.number("helix_slope")? * self.helix_share()?;
                Ok(ModificationSpec::HelixSlope(self.amount(self.place.slope_sign() * amount)))
            }
            "profile_twist" => {
                let amount = self.of.number("profile_twist")?;
                Ok(ModificationSpec::Twist(self.amount(self.place.slope_sign() * amount)))
            }
            _ => self.relief(),
        }
    }

    fn flank(&self) -> FlankChoice {
        self.place.involute.flank.into()
    }

    /// An amount of `mm` millimetres.
    fn amount(&self, mm: f64) -> AmountSpec {
        AmountSpec { amount_um: 1e3 * mm + 0.0, flank: self.flank(), reference: Reference::Transverse }
    }

    fn assume(&mut self, what: impl std::fmt::Display) {
        let message = format!("{} {what}", title(self.part));
        self.warnings.push(RexsWarning::new(RexsWarningKind::Assumed, message));
    }

    fn roll(&self, id: &'static str) -> Result<Option<f64>, RexsError> {
        self.of.optional(id)?.map(|d| self.place.roll(self.part, id, d)).transpose()
    }

    /// The profile slope over the field, as a multiple of the stated one: it may be stated elsewhere than at the end of its range.
    fn profile_share(&self) -> Result<f64, RexsError> {
        let [w_f, w_a] = self.field.roll();
        let start = self.roll("profile_evaluation_start")?.unwrap_or(w_f);
        let end = self.roll("profile_evaluation_end")?.unwrap_or(w_a);
        let at = self.roll("diameter_where_profile_slope_amount_is_specified")?.unwrap_or(end);
        let reach = at - start;
        if reach.abs() < 1e-6 {
            return Err(RexsError::BadValue {
                component: title(self.part),
                attribute: "diameter_where_profile_slope_amount_is_specified".into(),
                value: self.place.diameter(at).to_string(),
                allowed: "a diameter other than that where the slope is zero",
            });
        }
        Ok(if at == end { 1.0 } else { (end - start) / reach })
    }

    /// The helix slope over the field, as a multiple of the stated one: over the evaluated length or over the face width.
    fn helix_share(&mut self) -> Result<f64, RexsError> {
        let word =
            self.of.word("helix_evaluation_reference")?.map(|word| word.chars().take(40).collect::<String>());
        match word.as_deref() {
            None | Some("helix_evaluation_length") => Ok(1.0),
            Some("face_width") => Ok(self.field.face_length() / self.place.face_width),
            Some(other) => {
                self.assume(format_args!("refers its slope to `{other}`; the evaluated length is taken"));
                Ok(1.0)
            }
        }
    }
}
