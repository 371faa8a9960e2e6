//! A gear as REXS describes it, in the terms of this program.

use serde::{Deserialize, Serialize};

use super::flank::FlankPlace;
use super::flank_field::FlankField;
use super::thickness::RexsThickness;
use crate::inspection::{DatumFace, Trace};
use foundation::geometry::{Flank, Gear, GearData, GeometryError, Sides};
use foundation::modification::ModificationSpec;

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
    /// Profile shift coefficient, without the allowances of the thickness.
    pub profile_shift: f64,
    /// The measure of its tooth thickness that the drawing limits.
    pub thickness: Option<RexsThickness>,
    /// Class of ISO 1328-1:2013 that its flanks have to reach.
    pub tolerance_class: Option<i32>,
    /// Face width, mm.
    pub face_width_mm: f64,
    /// Tip diameter, mm.
    pub tip_diameter_mm: Option<f64>,
    /// Root diameter, mm.
    pub root_diameter_mm: Option<f64>,
    /// Root form diameter, where the involute begins, mm.
    pub form_diameter_mm: Option<f64>,
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
