//! Racks: the height of the generating rack on the flank, and other racks that generate the same cylindrical gear
//! (`docs/mathematics/involute-gears.md#height-of-the-rack`).

use super::{Flank, Gear, GeometryError, Sides};

/// A rack that generates a given cylindrical gear: pitch radius, helix and profile angles on it. mm, rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rack {
    /// Pitch radius r_w of the gear on this rack, mm.
    pub pitch_radius: f64,
    /// Normal module, mm.
    pub normal_module: f64,
    /// Helix angle on the pitch cylinder, rad.
    pub helix_angle: f64,
    /// Normal profile angle per flank, rad.
    pub pressure_angle: Sides<f64>,
}

impl Gear {
    /// Length of roll finished by rack height h (radial at z = 0, > 0 outside the pitch cylinder), mm.
    pub fn roll_of_rack_height(&self, flank: Flank, h: f64, z: f64) -> f64 {
        let sin = self.transverse_pressure_angle(flank).sin();
        self.pitch_radius() * sin + (h - z * self.data().cone_angle.tan()) / sin
    }

    /// Rack height that finishes (w, z), mm: inverse of [`Gear::roll_of_rack_height`].
    pub fn rack_height_of_roll(&self, flank: Flank, w: f64, z: f64) -> f64 {
        let sin = self.transverse_pressure_angle(flank).sin();
        (w - self.pitch_radius() * sin) * sin + z * self.data().cone_angle.tan()
    }

    /// The gear's own rack.
    pub fn own_rack(&self) -> Rack {
        Rack {
            pitch_radius: self.pitch_radius(),
            normal_module: self.data().normal_module,
            helix_angle: self.data().helix_angle,
            pressure_angle: self.data().pressure_angle,
        }
    }

    /// The rack on another pitch radius.
    ///
    /// # Errors
    /// [`GeometryError::NoRack`] below a base radius, [`GeometryError::CylindricalOnly`].
    pub fn rack_at_pitch_radius(&self, pitch_radius: f64) -> Result<Rack, GeometryError> {
        if !self.is_cylindrical() {
            return Err(GeometryError::CylindricalOnly);
        }
        let base = self.flanks().left.base_radius.max(self.flanks().right.base_radius);
        if !(pitch_radius >= base && pitch_radius.is_finite()) {
            return Err(GeometryError::NoRack { field: "pitch radius", value: pitch_radius });
        }
        let helix_angle = (pitch_radius * self.flanks().left.twist_per_length()).atan();
        let pressure_angle = self.flanks().map(|_, f| {
            let sin_at = ((1.0 - f.base_radius / pitch_radius) * (1.0 + f.base_radius / pitch_radius)).sqrt();
            (sin_at * f.base_helix_angle.cos()).asin()
        });
        let normal_module = 2.0 * pitch_radius * helix_angle.cos() / self.tooth_count();
        Ok(Rack { pitch_radius, normal_module, helix_angle, pressure_angle })
    }

    /// The rack with another normal module.
    ///
    /// # Errors
    /// [`GeometryError::NoRack`], [`GeometryError::CylindricalOnly`].
    pub fn rack_with_module(&self, normal_module: f64) -> Result<Rack, GeometryError> {
        let k = (normal_module * self.tooth_count() / 2.0).powi(2);
        let h = self.flanks().left.twist_per_length();
        let rest = 1.0 - k * h * h;
        if rest.is_nan() || rest <= 0.0 || normal_module <= 0.0 {
            return Err(GeometryError::NoRack { field: "normal module", value: normal_module });
        }
        self.rack_at_pitch_radius((k / rest).sqrt())
    }

    /// The rack with another normal profile angle (rad) on one flank.
    ///
    /// # Errors
    /// [`GeometryError::NoRack`], [`GeometryError::CylindricalOnly`].
    pub fn rack_with_pressure_angle(&self, flank: Flank, angle: f64) -> Result<Rack, GeometryError> {
        if !(angle > 0.0 && angle < std::f64::consts::PI / 2.0) {
            return Err(GeometryError::NoRack {
                field: "normal pressure angle (deg)",
                value: angle.to_degrees(),
            });
        }
        let m = self.base_module(flank) * self.flank(flank).base_helix_angle.cos() / angle.cos();
        self.rack_with_module(m).map_err(|e| match e {
            GeometryError::NoRack { .. } => {
                GeometryError::NoRack { field: "normal pressure angle (deg)", value: angle.to_degrees() }
            }
            other => other,
        })
    }
}
