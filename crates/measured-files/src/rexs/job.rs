//! Between a job and a REXS gear: drawing data, evaluated field, modifications.

use serde_json::Value;

use super::error::RexsError;
use super::flank_field::FlankField;
use super::gear::RexsGear;
use super::thickness::{RexsMeasure, RexsThickness};
use super::warning::{RexsWarning, RexsWarningKind};
use crate::inspection::DatumFace;
use foundation::geometry::{Flank, Sides};
use foundation::modification::{FlankChoice, ModificationSpec};
use job::tables::{Evaluation, Gear as JobGear, OneOrSides};

/// Ends nearer than this are one, mm.
const SAME_MM: f64 = 1e-9;

impl RexsGear {
    /// The gear of a job with the modifications of its target; the face at +z is the datum face.
    ///
    /// # Errors
    /// [`RexsError::NotExpressibleInRexs`] for a conical gear; [`RexsError::NoGear`] for measures of the thickness that no gear has.
    pub fn of_job(gear: &JobGear, modifications: &[ModificationSpec]) -> Result<Self, RexsError> {
        if gear.cone_angle_deg != 0.0 {
            return Err(RexsError::NotExpressibleInRexs {
                what: format!("the cone angle of {} deg", gear.cone_angle_deg),
                reason: "a cylindrical gear has none".into(),
            });
        }
        let angles = gear.normal_pressure_angle_deg.sides();
        // Allowances that the model states are not in its profile shift.
        let thickness = RexsThickness::of_job(gear);
        let nominal =
            JobGear { allowances_um: gear.allowances_um.filter(|_| thickness.is_none()), ..gear.clone() };
        let body = nominal.body().map_err(|error| RexsError::NoGear { gear: 0, error })?;
        let range = gear.evaluation_range();
        let field = FlankField {
            start_diameter_mm: Some(range.start_diameter),
            end_diameter_mm: Some(range.end_diameter),
            z_start_mm: Some(range.z_start),
            z_end_mm: Some(range.z_end),
        };
        let of = |flank: Flank| modifications.iter().filter(|s| s.flank().includes(flank)).cloned().collect();
        Ok(Self {
            name: None,
            teeth: gear.teeth,
            normal_module_mm: gear.normal_module,
            normal_pressure_angle_deg: angles,
            helix_angle_deg: gear.helix_angle_deg,
            profile_shift: body.data().profile_shift,
            thickness,
            tolerance_class: gear.tolerance_class,
            face_width_mm: gear.face_width,
            tip_diameter_mm: Some(gear.tip_diameter),
            root_diameter_mm: Some(gear.root_diameter),
            form_diameter_mm: gear.form_diameter,
            datum_face: DatumFace::PlusZ,
            fields: Sides::both(field),
            modifications: Sides::from_fn(of),
            deviations: Vec::new(),
        })
    }

    /// The gear as a job has it, and what a job has no place for.
    ///
    /// # Errors
    /// [`RexsError::MissingAttribute`] without tip or root diameter.
    pub fn job_gear(&self) -> Result<(JobGear, Vec<RexsWarning>), RexsError> {
        let mut warnings = Vec::new();
        let needed = |value: Option<f64>, attribute| {
            value.ok_or(RexsError::MissingAttribute { component: "the gear".into(), attribute })
        };
        let Sides { left, right } = self.fields;
        let differ =
            |a: Option<f64>, b: Option<f64>| matches!((a, b), (Some(a), Some(b)) if (a - b).abs() > SAME_MM);
        if differ(left.start_diameter_mm, right.start_diameter_mm)
            || differ(left.end_diameter_mm, right.end_diameter_mm)
            || differ(left.z_start_mm, right.z_start_mm)
            || differ(left.z_end_mm, right.z_end_mm)
        {
            let message = "the flanks are evaluated on different fields; a job has one, that of the left flank is taken";
            warnings.push(RexsWarning::new(RexsWarningKind::RangesDiffer, message));
        }
        if !self.deviations.is_empty() {
            let message = format!("{} measured traces are no part of a job", self.deviations.len());
            warnings.push(RexsWarning::new(RexsWarningKind::Lost, message));
        }
        let angles = self.normal_pressure_angle_deg;
        let evaluation = Evaluation {
            start_diameter: left.start_diameter_mm.or(right.start_diameter_mm),
            end_diameter: left.end_diameter_mm.or(right.end_diameter_mm),
            z_start: left.z_start_mm.or(right.z_start_mm),
            z_end: left.z_end_mm.or(right.z_end_mm),
        };
        let (span, over_balls) = match self.thickness.map(|thickness| thickness.measure) {
            Some(RexsMeasure::Span(span)) => (Some(span), None),
            Some(RexsMeasure::OverBalls(balls)) => (None, Some(balls)),
            None => (None, None),
        };
        let gear = JobGear {
            teeth: self.teeth,
            normal_module: self.normal_module_mm,
            normal_pressure_angle_deg: if angles.left == angles.right {
                OneOrSides::Both(angles.left)
            } else {
                OneOrSides::Each { left: angles.left, right: angles.right }
            },
            helix_angle_deg: self.helix_angle_deg,
            profile_shift: self.thickness.is_none().then_some(self.profile_shift),
            normal_tooth_thickness: None,
            span,
            over_balls,
            allowances_um: self.thickness.map(|thickness| thickness.allowances_um),
            measured_over: None,
            tolerance_class: self.tolerance_class,
            face_width: self.face_width_mm,
            tip_diameter: needed(self.tip_diameter_mm, "tip_diameter")?,
            root_diameter: needed(self.root_diameter_mm, "root_diameter")?,
            form_diameter: self.form_diameter_mm,
            cone_angle_deg: 0.0,
            evaluation: (evaluation != Evaluation::default()).then_some(evaluation),
        };
        Ok((gear, warnings))
    }

    /// The modifications as a job has them: what both flanks carry alike once, the rest for each flank.
    pub fn job_modifications(&self) -> Vec<ModificationSpec> {
        let mut right: Vec<ModificationSpec> = self.modifications.right.clone();
        let mut list = Vec::new();
        for spec in &self.modifications.left {
            let both = for_flank(spec, FlankChoice::Both);
            let twin = right.iter().position(|other| alike(&for_flank(other, FlankChoice::Both), &both));
            if let Some(at) = twin {
                right.remove(at);
                list.push(both);
            } else {
                list.push(for_flank(spec, FlankChoice::Left));
            }
        }
        list.extend(right.iter().map(|spec| for_flank(spec, FlankChoice::Right)));
        list
    }
}

/// Whether two modifications say the same but for rounding: lengths of roll come from diameters.
fn alike(a: &ModificationSpec, b: &ModificationSpec) -> bool {
    fn same(a: &Value, b: &Value) -> bool {
        match (a, b) {
            (Value::Object(a), Value::Object(b)) => {
                a.len() == b.len() && a.iter().all(|(key, a)| b.get(key).is_some_and(|b| same(a, b)))
            }
            (Value::Array(a), Value::Array(b)) => {
                a.len() == b.len() && a.iter().zip(b).all(|(a, b)| same(a, b))
            }
            _ => match (a.as_f64(), b.as_f64()) {
                (Some(a), Some(b)) => (a - b).abs() <= SAME_MM,
                _ => a == b,
            },
        }
    }
    matches!((serde_json::to_value(a), serde_json::to_value(b)), (Ok(a), Ok(b)) if same(&a, &b))
}

/// The same modification for other flanks.
fn for_flank(spec: &ModificationSpec, flank: FlankChoice) -> ModificationSpec {
    let changed = || {
        let mut value = serde_json::to_value(spec).ok()?;
        let Value::Object(table) = &mut value else { return None };
        table.insert("flank".into(), serde_json::to_value(flank).ok()?);
        ModificationSpec::from_json(&value).ok()
    };
    // A description that was read or built survives its own file form; the other way is the net below that.
    changed().unwrap_or_else(|| spec.clone())
}
