//! Skiving tools as bodies: teeth on a cylinder, a rake face, an edge that is rounded with chamfers beside it
//! (`docs/mathematics/skiving.md`). What their edges look like follows from the workpiece and is found elsewhere.

mod rake;
mod variable_rake;

pub use rake::{ConeRake, PlaneRake, RakeFace, SphericalRake};
pub use variable_rake::{RakeChange, VariableRake};

use super::GeometryError;
use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

/// The rounding between rake face and clearance face. mm, rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EdgeRounding {
    /// rho_e: radius; 0 is a sharp edge.
    pub radius: f64,
    /// alpha_c: clearance angle.
    pub clearance_angle: f64,
    /// b_r: width of the chamfer on the rake face; 0 without.
    pub rake_chamfer_width: f64,
    /// kappa_r: angle of that chamfer against the rake face.
    pub rake_chamfer_angle: f64,
    /// kappa_c: angle of the chamfer on the clearance face against it.
    pub clearance_chamfer_angle: f64,
}

/// A skiving tool. Tooth 0 stands centred on +y of its own frame, rake face towards +z. mm, rad.
#[derive(Clone, Debug)]
pub struct SkivingTool {
    teeth: u32,
    helix_angle: f64,
    pitch_radius: f64,
    rake: Arc<dyn RakeFace>,
    rounding: EdgeRounding,
}

impl EdgeRounding {
    /// h_c: how deep the centres of the rounding lie below the rake face, mm.
    pub fn depth(&self) -> f64 {
        let (sin, cos) = self.rake_chamfer_angle.sin_cos();
        self.radius * cos + self.rake_chamfer_width * sin
    }

    fn check(&self) -> Result<(), GeometryError> {
        let number = |field, value: f64, good: bool, allowed| {
            if good { Ok(()) } else { Err(GeometryError::InvalidNumber { field, value, allowed }) }
        };
        let length = |x: f64| x.is_finite() && x >= 0.0;
        let angle = |x: f64| (0.0..FRAC_PI_2).contains(&x);
        let degrees = "from 0 to below 90 deg";
        number("rounding_radius", self.radius, length(self.radius), ">= 0 mm")?;
        let width = self.rake_chamfer_width;
        number("rake_chamfer_width", width, length(width), ">= 0 mm")?;
        for (field, value) in [
            ("clearance_angle_deg", self.clearance_angle),
            ("rake_chamfer_angle_deg", self.rake_chamfer_angle),
            ("clearance_chamfer_angle_deg", self.clearance_chamfer_angle),
        ] {
            number(field, value.to_degrees(), angle(value), degrees)?;
        }
        Ok(())
    }
}

impl SkivingTool {
    /// A tool of the workpiece's normal module, mm.
    ///
    /// # Errors
    /// [`GeometryError::InvalidNumber`] for fewer than three teeth, a helix angle of 60 deg or more, a module or rounding out of range.
    pub fn new(
        teeth: u32,
        helix_angle: f64,
        normal_module: f64,
        rake: impl FnOnce(f64) -> Arc<dyn RakeFace>,
        rounding: EdgeRounding,
    ) -> Result<Self, GeometryError> {
        let number = |field, value: f64, good: bool, allowed| {
            if good { Ok(()) } else { Err(GeometryError::InvalidNumber { field, value, allowed }) }
        };
        number("tool.teeth", f64::from(teeth), teeth >= 3, "at least 3")?;
        let degrees = helix_angle.to_degrees();
        number("tool.helix_angle_deg", degrees, degrees.abs() < 60.0, "between -60 and 60 deg")?;
        let module = normal_module.is_finite() && normal_module > 0.0;
        number("normal_module", normal_module, module, "> 0 mm")?;
        rounding.check()?;
        let pitch_radius = f64::from(teeth) * normal_module / (2.0 * helix_angle.cos());
        Ok(Self { teeth, helix_angle, pitch_radius, rake: rake(pitch_radius), rounding })
    }

    /// z1.
    pub fn teeth(&self) -> u32 {
        self.teeth
    }

    /// beta_1, rad, > 0 right-handed.
    pub fn helix_angle(&self) -> f64 {
        self.helix_angle
    }

    /// r_1, mm.
    pub fn pitch_radius(&self) -> f64 {
        self.pitch_radius
    }

    /// p1 = tan(beta_1)/r_1: turn of the teeth per mm along the axis, rad/mm.
    pub fn twist(&self) -> f64 {
        self.helix_angle.tan() / self.pitch_radius
    }

    /// The rake face of tooth 0.
    pub fn rake(&self) -> &dyn RakeFace {
        self.rake.as_ref()
    }

    /// The rounding of the edges.
    pub fn rounding(&self) -> &EdgeRounding {
        &self.rounding
    }

    /// The same tool with another rounding: a sharp one, a worn one.
    ///
    /// # Errors
    /// [`GeometryError::InvalidNumber`] for a rounding out of range.
    pub fn with_rounding(&self, rounding: EdgeRounding) -> Result<Self, GeometryError> {
        rounding.check()?;
        Ok(Self { rounding, ..self.clone() })
    }
}
