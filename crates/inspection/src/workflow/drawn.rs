//! The gear and the evaluated ranges of a drawing or a job, where a measurement does not tell them itself.

use foundation::geometry::{Flank, Sides};
use generating::GrindingSetup;
use job::{Diagnostic, Problem};
use measured_files::inspection::{Conditions, FlankConditions, InspectedGear, Inspection, SlopeReference};
use run::RunFailure;

/// What the drawing says of a gear that was measured.
#[derive(Clone, Debug)]
pub struct DrawnGear {
    /// Drawing data.
    pub gear: InspectedGear,
    /// Ranges, and slopes over the face width and over the range of the profile, as ISO 1328-1 has them.
    pub conditions: Conditions,
}

/// What drawing and measurement may differ by: angles of a file are rounded, degree.
const SAME_ANGLE: f64 = 1e-4;
/// Lengths, mm.
const SAME_LENGTH: f64 = 1e-4;

impl DrawnGear {
    /// With the lengths of roll and the heights that are evaluated, mm.
    pub fn new(gear: InspectedGear, profile: Sides<Option<[f64; 2]>>, helix: Sides<[f64; 2]>) -> Self {
        let flanks = Sides::from_fn(|flank: Flank| FlankConditions {
            w_1_mm: profile[flank].map(|[from, _]| from),
            w_2_mm: profile[flank].map(|[_, to]| to),
            z_1_mm: Some(helix[flank][0]),
            z_2_mm: Some(helix[flank][1]),
            ..FlankConditions::default()
        });
        let conditions = Conditions {
            flanks,
            helix_slope_reference: Some(SlopeReference::FaceWidth),
            profile_slope_reference: Some(SlopeReference::Range),
            ..Conditions::default()
        };
        Self { gear, conditions }
    }

    /// The workpiece of bodies that were set up.
    ///
    /// # Errors
    /// [`RunFailure::BadInput`] for flanks with different pressure angles, which inspections do not know.
    pub fn of_setup(setup: &GrindingSetup) -> Result<Self, RunFailure> {
        let blank = &setup.input.blank;
        let data = setup.pair.work.data();
        if data.pressure_angle.left != data.pressure_angle.right {
            let finding =
                Diagnostic::new(Problem::InvalidNumber, "the flanks have different pressure angles")
                    .field("gear.normal_pressure_angle_deg")
                    .allowed("the same angle on both flanks")
                    .way_out("measure and correct each flank with a job of its own");
            return Err(RunFailure::bad_input(finding));
        }
        let gear = InspectedGear {
            teeth: data.teeth,
            normal_module_mm: data.normal_module,
            normal_pressure_angle_deg: data.pressure_angle.left.to_degrees(),
            helix_angle_deg: data.helix_angle.to_degrees(),
            profile_shift: Some(data.profile_shift),
            face_width_mm: Some(blank.face_width),
            tip_diameter_mm: Some(blank.tip_diameter),
            root_diameter_mm: Some(blank.root_diameter),
        };
        let profile = setup.fields.map(|_, field| Some(field.roll()));
        let helix = setup.fields.map(|_, field| field.face());
        Ok(Self::new(gear, profile, helix))
    }

    /// Whether a measured gear is this one.
    ///
    /// # Errors
    /// [`RunFailure::BadInput`] naming what differs.
    pub fn is_of(&self, inspection: &Inspection) -> Result<(), RunFailure> {
        let (own, file) = (&self.gear, &inspection.gear);
        let apart = [
            ("gear.teeth", f64::from(own.teeth), f64::from(file.teeth), 0.0),
            ("gear.normal_module", own.normal_module_mm, file.normal_module_mm, SAME_LENGTH),
            (
                "gear.normal_pressure_angle_deg",
                own.normal_pressure_angle_deg,
                file.normal_pressure_angle_deg,
                SAME_ANGLE,
            ),
            ("gear.helix_angle_deg", own.helix_angle_deg, file.helix_angle_deg, SAME_ANGLE),
            (
                "gear.face_width",
                own.face_width_mm.unwrap_or(f64::NAN),
                file.face_width_mm.or(own.face_width_mm).unwrap_or(f64::NAN),
                SAME_LENGTH,
            ),
        ];
        match apart.into_iter().find(|(_, own, file, same)| (own - file).abs() > *same) {
            None => Ok(()),
            Some((field, own, file, _)) => {
                let finding = Diagnostic::with_code("other-gear", "the measurement is of another gear")
                    .field(field)
                    .value(own)
                    .allowed(format!("{file}, as the measurement has it"))
                    .way_out("give the job of the gear that was measured");
                Err(RunFailure::bad_input(finding))
            }
        }
    }
}
