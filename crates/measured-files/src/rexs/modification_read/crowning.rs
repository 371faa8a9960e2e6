//! Crownings: one parabola or circle, or two parabolas where the highest point lies elsewhere or the ends differ.

use super::super::error::RexsError;
use super::super::values::title;
use super::Reader;
use foundation::modification::{HelixTwoArcSpec, ModificationSpec, ProfileTwoArcSpec, Reference};

/// Apexes nearer to the middle than this stand in it, mm.
const MIDDLE_MM: f64 = 1e-6;
/// Amounts nearer than this are one, mm.
const SAME_MM: f64 = 1e-12;

/// What the attributes of a crowning make it.
enum Form {
    /// One law over the whole field, with one amount.
    One { amount: f64, circular: bool },
    /// Two parabolas that meet at an apex.
    Two { apex: f64 },
}

impl Reader<'_> {
    fn form(
        &mut self,
        ends: [f64; 2],
        apex: Option<f64>,
        middle: f64,
        shape: &'static str,
    ) -> Result<Form, RexsError> {
        let circular = match self.of.word(shape)? {
            None | Some("parabolic") => false,
            Some("circular") => true,
            Some(other) => {
                let other: String = other.chars().take(40).collect();
                self.assume(format_args!("has the shape `{other}`; a parabola is taken"));
                false
            }
        };
        let same = (ends[0] - ends[1]).abs() <= SAME_MM;
        match apex {
            None if !same => Err(RexsError::TwoArcCrowning { component: title(self.part) }),
            Some(apex) if !same || (apex - middle).abs() > MIDDLE_MM => {
                if circular {
                    self.assume("is circular with two different ends; two parabolas are taken");
                }
                Ok(Form::Two { apex })
            }
            _ => Ok(Form::One { amount: ends[0], circular }),
        }
    }

    /// A crowning along the profile.
    pub(super) fn profile_crowning(&mut self) -> Result<ModificationSpec, RexsError> {
        let ends = [self.of.number("profile_crowning_at_root")?, self.of.number("profile_crowning_at_tip")?];
        let apex = self.roll("profile_highest_point")?;
        let form = self.form(ends, apex, self.field.roll_middle(), "shape_of_profile_crowning")?;
        Ok(match form {
            Form::One { amount, circular: false } => ModificationSpec::ProfileCrowning(self.amount(amount)),
            Form::One { amount, circular: true } => ModificationSpec::ProfileCrowningArc(self.amount(amount)),
            Form::Two { apex } => ModificationSpec::ProfileCrowningTwoArc(ProfileTwoArcSpec {
                apex_w_mm: apex,
                amount_1_um: 1e3 * ends[0],
                amount_2_um: 1e3 * ends[1],
                flank: self.flank(),
                reference: Reference::Transverse,
            }),
        })
    }

    /// A crowning along the face width.
    pub(super) fn helix_crowning(&mut self) -> Result<ModificationSpec, RexsError> {
        let datum = self.of.number("helix_crowning_amount_datum_face")?;
        let other = self.of.number("helix_crowning_amount_non_datum_face")?;
        let (one, two) = self.place.faces((datum, other));
        let apex = self.of.optional("helix_highest_point")?.map(|xi| self.place.height(xi));
        let form = self.form([one, two], apex, self.field.face_middle(), "shape_of_helix_crowning")?;
        Ok(match form {
            Form::One { amount, circular: false } => ModificationSpec::HelixCrowning(self.amount(amount)),
            Form::One { amount, circular: true } => ModificationSpec::HelixCrowningArc(self.amount(amount)),
            Form::Two { apex } => ModificationSpec::HelixCrowningTwoArc(HelixTwoArcSpec {
                apex_z_mm: apex,
                amount_1_um: Some(1e3 * one),
                amount_2_um: Some(1e3 * two),
                flank: self.flank(),
                ..HelixTwoArcSpec::default()
            }),
        })
    }
}
