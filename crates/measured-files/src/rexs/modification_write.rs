//! Modifications as components of REXS. Kinds that it does not know are sampled into a topography and reported.

use super::draft::Draft;
use super::error::RexsError;
use super::flank::FlankPlace;
use super::topography;
use super::warning::{RexsWarning, RexsWarningKind};
use foundation::modification::{
    EvaluationField, GridSpec, Modification, ModificationFiles, ModificationSpec, Reference, ReliefSpec,
};

/// Lines of a sampled modification along length of roll and face width.
const SAMPLED: [usize; 2] = [25, 31];

/// Writes modifications of one flank.
pub(super) struct Writer<'a> {
    pub place: &'a FlankPlace,
    pub field: &'a EvaluationField,
    pub files: &'a dyn ModificationFiles,
    pub warnings: &'a mut Vec<RexsWarning>,
}

impl Writer<'_> {
    /// The component of a modification that is right by itself.
    pub fn write(&mut self, spec: &ModificationSpec) -> Result<Draft, RexsError> {
        use foundation::modification::ModificationSpec as M;
        // A table need not cover the field: REXS states its own places.
        if let M::Grid(table) = spec
            && table.file.is_none()
        {
            return self.table(table);
        }
        self.check(spec)?;
        let mm = |amount_um: f64, reference: Reference| self.removed(amount_um, reference);
        match spec {
            M::ProfileCrowning(s) => {
                let amount = mm(s.amount_um, s.reference);
                Ok(self.profile_crowning([amount; 2], self.field.roll_middle(), "parabolic"))
            }
            M::ProfileCrowningArc(s) => {
                let amount = mm(s.amount_um, s.reference);
                Ok(self.profile_crowning([amount; 2], self.field.roll_middle(), "circular"))
            }
            M::ProfileCrowningTwoArc(s) => {
                let ends = [s.amount_1_um, s.amount_2_um].map(|amount| mm(amount, s.reference));
                Ok(self.profile_crowning(ends, s.apex_w_mm, "parabolic"))
            }
            M::ProfileSlope(s) => {
                let [start, end] = self.field.roll().map(|w| self.place.diameter(w));
                Ok(Draft::new("profile_slope")
                    .number("profile_slope", mm(s.amount_um, s.reference))
                    .number("profile_evaluation_start", start)
                    .number("profile_evaluation_end", end)
                    .number("diameter_where_profile_slope_amount_is_specified", end))
            }
            M::HelixCrowning(s) => {
                let amount = mm(s.amount_um, s.reference);
                Ok(self.helix_crowning([amount; 2], self.field.face_middle(), "parabolic"))
            }
            M::HelixCrowningArc(s) => {
                let amount = mm(s.amount_um, s.reference);
                Ok(self.helix_crowning([amount; 2], self.field.face_middle(), "circular"))
            }
            M::HelixCrowningTwoArc(s) => {
                let ends = s.amounts_um().unwrap_or_default().map(|amount| mm(amount, s.reference));
                Ok(self.helix_crowning(ends, s.apex_z_mm, "parabolic"))
            }
            M::HelixSlope(s) => {
                let (start, end) = self.coordinates();
                Ok(Draft::new("helix_slope")
                    .number("helix_slope", self.place.slope_sign() * mm(s.amount_um, s.reference))
                    .number("helix_evaluation_start", start)
                    .number("helix_evaluation_end", end)
                    .word("helix_evaluation_reference", "helix_evaluation_length"))
            }
            M::Twist(s) => {
                let [start, end] = self.field.roll().map(|w| self.place.diameter(w));
                let (datum, other) = self.coordinates();
                Ok(Draft::new("profile_twist")
                    .number("profile_twist", self.place.slope_sign() * mm(s.amount_um, s.reference))
                    .number("profile_twist_evaluation_start", start)
                    .number("profile_twist_evaluation_end", end)
                    .number("position_of_profile_twist_datum_face", datum)
                    .number("position_of_profile_twist_non_datum_face", other))
            }
            M::TipRelief(s)
            | M::RootRelief(s)
            | M::EndReliefI(s)
            | M::EndReliefII(s)
            | M::EndReliefDatumFace(s)
            | M::EndReliefNonDatumFace(s) => self.relief(spec, s),
            _ => self.sampled(spec),
        }
    }

    /// A table that stands in the job.
    fn table(&self, s: &GridSpec) -> Result<Draft, RexsError> {
        let ascending = |list: &[f64]| list.iter().all(|v| v.is_finite()) && list.is_sorted_by(|a, b| a < b);
        let fits = s.f_um.len() == s.w_mm.len()
            && s.f_um.iter().all(|row| row.len() == s.z_mm.len() && row.iter().all(|v| v.is_finite()));
        if fits && ascending(&s.w_mm) && ascending(&s.z_mm) {
            return Ok(topography::write(self.place, &s.w_mm, &s.z_mm, |i, j| s.f_um[i][j]));
        }
        Err(RexsError::NotExpressibleInRexs {
            what: format!("a grid of the {} flank", self.place.involute.flank),
            reason: "its places do not ascend, or its rows are not of their number".into(),
        })
    }

    /// An amount in mm, transverse.
    fn removed(&self, amount_um: f64, reference: Reference) -> f64 {
        match reference {
            Reference::Transverse => 1e-3 * amount_um,
            Reference::Normal => 1e-3 * amount_um / self.field.normal_factor(),
        }
    }

    /// Distances of the field's ends from the datum face: the one near it, the other.
    fn coordinates(&self) -> (f64, f64) {
        let [one, two] = self.field.face().map(|z| self.place.distance(z));
        self.place.faces((one, two))
    }

    fn profile_crowning(&self, [root, tip]: [f64; 2], apex_w: f64, shape: &str) -> Draft {
        let [start, end] = self.field.roll().map(|w| self.place.diameter(w));
        Draft::new("profile_crowning")
            .number("profile_crowning_at_root", root)
            .number("profile_crowning_at_tip", tip)
            .number("diameter_where_profile_crowning_root_is_specified", start)
            .number("diameter_where_profile_crowning_tip_is_specified", end)
            .word("shape_of_profile_crowning", shape)
            .number("profile_highest_point", self.place.diameter(apex_w))
    }

    fn helix_crowning(&self, [one, two]: [f64; 2], apex_z: f64, shape: &str) -> Draft {
        let (datum, other) = self.place.faces((one, two));
        let (near, far) = self.coordinates();
        Draft::new("helix_crowning")
            .number("helix_crowning_amount_datum_face", datum)
            .number("helix_crowning_amount_non_datum_face", other)
            .number("helix_highest_point", self.place.distance(apex_z))
            .number("coordinate_where_helix_crowning_is_specified_datum_face", near)
            .number("coordinate_where_helix_crowning_is_specified_non_datum_face", far)
            .word("shape_of_helix_crowning", shape)
    }

    fn relief(&mut self, spec: &ModificationSpec, s: &ReliefSpec) -> Result<Draft, RexsError> {
        let shape = match s.exponent {
            1.0 => "linear",
            2.0 => "parabolic",
            _ => return self.sampled(spec),
        };
        let depth = self.removed(s.amount_um, s.reference);
        let [w_f, w_a] = self.field.roll();
        let diameter = |w: f64| self.place.diameter(w);
        let (draft, transition) = match spec {
            ModificationSpec::TipRelief(_) => (
                Draft::new("tip_relief")
                    .number("tip_relief_depth", depth)
                    .number("tip_relief_datum_diameter", diameter(w_a - s.length_mm))
                    .number("tip_relief_evaluation_reference", diameter(w_a)),
                "tip_relief_length_of_tangential_transition",
            ),
            ModificationSpec::RootRelief(_) => (
                Draft::new("root_relief")
                    .number("root_relief_depth", depth)
                    .number("root_relief_datum_diameter", diameter(w_f + s.length_mm))
                    .number("root_relief_evaluation_reference", diameter(w_f)),
                "root_relief_length_of_tangential_transition",
            ),
            _ => {
                let at_one = matches!(
                    spec,
                    ModificationSpec::EndReliefI(_) | ModificationSpec::EndReliefNonDatumFace(_)
                );
                if self.place.faces((at_one, !at_one)).0 {
                    let draft = Draft::new("end_relief_datum_face")
                        .number("end_relief_depth_datum_face", depth)
                        .number("end_relief_length_datum_face", s.length_mm);
                    (draft, "end_relief_datum_face_length_of_tangential_transition")
                } else {
                    let draft = Draft::new("end_relief_non_datum_face")
                        .number("end_relief_depth_non_datum_face", depth)
                        .number("end_relief_length_non_datum_face", s.length_mm);
                    (draft, "end_relief_non_datum_face_length_of_tangential_transition")
                }
            }
        };
        let draft = draft.word("shape_of_relief", shape);
        // The rounding reaches as far to both sides of the start; both ends count as the length of the relief does.
        if s.transition_mm > 0.0 && s.exponent == 1.0 {
            return Ok(draft
                .number(&format!("{transition}_start"), s.length_mm + s.transition_mm)
                .number(&format!("{transition}_end"), s.length_mm - s.transition_mm));
        }
        Ok(draft)
    }

    /// A modification that is wrong by itself is not written.
    fn check(&self, spec: &ModificationSpec) -> Result<Modification, RexsError> {
        Modification::build_with_files(spec, self.field, self.files)
            .map_err(|error| RexsError::Modification { flank: self.place.involute.flank, error })
    }

    fn sampled(&mut self, spec: &ModificationSpec) -> Result<Draft, RexsError> {
        let flank = self.place.involute.flank;
        let made = self.check(spec)?;
        let along = |[from, to]: [f64; 2], n: usize| -> Vec<f64> {
            (0..n).map(|k| from + (to - from) * k as f64 / (n - 1) as f64).collect()
        };
        let (w, z) = (along(self.field.roll(), SAMPLED[0]), along(self.field.face(), SAMPLED[1]));
        let mut f_um = Vec::with_capacity(w.len() * z.len());
        for w in &w {
            for z in &z {
                f_um.push(1e3 * made.value(*w, *z).map_err(|error| RexsError::NoValue { flank, error })?);
            }
        }
        let message = format!(
            "{} of the {flank} flank is no kind of REXS and is sampled on {} x {} points",
            spec.kind(),
            w.len(),
            z.len()
        );
        self.warnings.push(RexsWarning::new(RexsWarningKind::Sampled, message));
        Ok(topography::write(self.place, &w, &z, |i, j| f_um[i * z.len() + j]))
    }
}
