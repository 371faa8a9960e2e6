//! Base data of a toothed body (gear, worm, beveloid) from its drawing data:
//! `docs/mathematics/involute-gears.md#input-and-base-quantities`.

use super::{Flank, GeometryError, InvoluteFlank, Sides};
use std::f64::consts::PI;

/// Drawing data of a body: the rack that generates it and how it stands to the axis. mm, rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GearData {
    /// Number of teeth (threads of a worm), < 0 internal.
    pub teeth: i32,
    /// Normal module m_n, mm.
    pub normal_module: f64,
    /// Normal profile angles of the rack per flank of the gear, rad.
    pub pressure_angle: Sides<f64>,
    /// Helix angle at the pitch cylinder, rad, > 0 right-handed.
    pub helix_angle: f64,
    /// Profile shift coefficient x at z = 0, radial, > 0 thickens the tooth.
    pub profile_shift: f64,
    /// Cone angle theta, rad, > 0: thinner towards +z; 0 = cylindrical.
    pub cone_angle: f64,
}

/// A validated toothed body with the base data of both flanks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gear {
    data: GearData,
    pitch_radius: f64,
    transverse_module: f64,
    transverse_pressure_angle: Sides<f64>,
    flanks: Sides<InvoluteFlank>,
}

/// inv(a) = tan(a) - a.
pub fn involute_function(angle: f64) -> f64 {
    angle.tan() - angle
}

impl GearData {
    fn check(&self) -> Result<(), GeometryError> {
        let number = |field, value: f64, good: bool, allowed| {
            if good { Ok(()) } else { Err(GeometryError::InvalidNumber { field, value, allowed }) }
        };
        number("teeth", f64::from(self.teeth), self.teeth != 0, "an integer other than 0")?;
        let m = self.normal_module;
        number("normal_module", m, m.is_finite() && m > 0.0, "> 0 mm")?;
        for (_, &a) in self.pressure_angle.iter() {
            let good = a > 0.0 && a < PI / 2.0;
            number("normal_pressure_angle_deg", a.to_degrees(), good, "between 0 and 90 deg, both excluded")?;
        }
        let beta = self.helix_angle;
        number(
            "helix_angle_deg",
            beta.to_degrees(),
            beta.abs() < PI / 2.0,
            "between -90 and 90 deg, both excluded",
        )?;
        let theta = self.cone_angle;
        number(
            "cone_angle_deg",
            theta.to_degrees(),
            theta.abs() < PI / 2.0,
            "between -90 and 90 deg, both excluded",
        )?;
        number("profile_shift", self.profile_shift, self.profile_shift.is_finite(), "a finite number")?;
        if self.teeth < 0 && theta != 0.0 {
            return Err(GeometryError::InternalConicalUnsupported {
                teeth: self.teeth,
                cone_angle_deg: theta.to_degrees(),
            });
        }
        Ok(())
    }
}

impl Gear {
    /// Base data by `docs/mathematics/involute-gears.md#input-and-base-quantities`.
    ///
    /// # Errors
    /// [`GeometryError::InvalidNumber`], [`GeometryError::InternalConicalUnsupported`],
    /// [`GeometryError::PressureAngleNotPositive`], [`GeometryError::InvalidGeometry`] when a number overflows.
    pub fn new(data: GearData) -> Result<Self, GeometryError> {
        data.check()?;
        let z = f64::from(data.teeth.abs());
        let sg = f64::from(data.teeth.signum());
        let (sin_beta, cos_beta) = data.helix_angle.sin_cos();
        let (sin_theta, cos_theta) = data.cone_angle.sin_cos();
        let m_t = data.normal_module / cos_beta;
        let r_w = z * m_t / 2.0;
        let tangent = Sides::try_from_fn(|flank| {
            let s = flank.sign();
            let tangent =
                (data.pressure_angle[flank].tan() * cos_theta + s * sin_beta * sin_theta) / cos_beta;
            if tangent > 0.0 {
                Ok(tangent)
            } else {
                Err(GeometryError::PressureAngleNotPositive { flank, tangent })
            }
        })?;
        let flanks = Sides::from_fn(|flank| {
            let s = flank.sign();
            let (sin_an, cos_an) = data.pressure_angle[flank].sin_cos();
            let alpha_t = tangent[flank].atan();
            InvoluteFlank {
                flank,
                teeth: z,
                external_sign: sg,
                base_radius: r_w * alpha_t.cos(),
                base_helix_angle: (cos_an * sin_beta * cos_theta - s * sin_an * sin_theta).asin(),
                base_space_half_angle: (PI / 2.0 - 2.0 * data.profile_shift * cos_beta * tangent[flank]) / z
                    - sg * involute_function(alpha_t),
            }
        });
        let gear = Self {
            data,
            pitch_radius: r_w,
            transverse_module: m_t,
            transverse_pressure_angle: tangent.map(|_, t| t.atan()),
            flanks,
        };
        for (_, f) in gear.flanks.iter() {
            let sound =
                f.base_radius.is_finite() && f.base_radius > 0.0 && f.base_space_half_angle.is_finite();
            if !sound || !f.base_helix_angle.is_finite() {
                return Err(GeometryError::InvalidGeometry {
                    what: "base radius".into(),
                    value: f.base_radius,
                    allowed: "a positive finite length".into(),
                });
            }
        }
        Ok(gear)
    }

    /// The drawing data this body was made from.
    pub fn data(&self) -> &GearData {
        &self.data
    }

    /// Pitch radius r_w = |z| m_t/2, mm: the rack's datum direction rolls there.
    pub fn pitch_radius(&self) -> f64 {
        self.pitch_radius
    }

    /// Transverse module m_t, mm.
    pub fn transverse_module(&self) -> f64 {
        self.transverse_module
    }

    /// Transverse profile angle alpha_tF at the pitch radius, rad.
    pub fn transverse_pressure_angle(&self, flank: Flank) -> f64 {
        self.transverse_pressure_angle[flank]
    }

    /// The involute flank.
    pub fn flank(&self, flank: Flank) -> &InvoluteFlank {
        &self.flanks[flank]
    }

    /// Both flanks.
    pub fn flanks(&self) -> &Sides<InvoluteFlank> {
        &self.flanks
    }

    /// Number of teeth without sign.
    pub fn tooth_count(&self) -> f64 {
        f64::from(self.data.teeth.abs())
    }

    /// +1 external, -1 internal.
    pub fn external_sign(&self) -> f64 {
        f64::from(self.data.teeth.signum())
    }

    /// Whether the cone angle is zero.
    pub fn is_cylindrical(&self) -> bool {
        self.data.cone_angle == 0.0
    }

    /// Base module m_bF = 2 r_bF/|z|, mm.
    pub fn base_module(&self, flank: Flank) -> f64 {
        2.0 * self.flanks[flank].base_radius / self.tooth_count()
    }

    /// Normal base pitch p_bnF, mm.
    pub fn normal_base_pitch(&self, flank: Flank) -> f64 {
        PI * self.base_module(flank) * self.flanks[flank].base_helix_angle.cos()
    }

    /// m_FF: lines of constant rack height are w + m_F z = const; 0 for cylinders.
    pub fn rack_height_slope(&self, flank: Flank) -> f64 {
        self.data.cone_angle.tan() / self.transverse_pressure_angle[flank].sin()
    }

    /// Screw parameter p = r_b/tan(beta_b), mm/rad, signed (lead/2 pi); infinite for spur gears.
    pub fn screw_parameter(&self, flank: Flank) -> f64 {
        let f = &self.flanks[flank];
        f.base_radius / f.base_helix_angle.tan()
    }

    /// psi_F = eta_bF + sg inv(alpha_tF): half space angle on the pitch cylinder at z = 0, rad.
    pub fn pitch_space_half_angle(&self, flank: Flank) -> f64 {
        self.flanks[flank].base_space_half_angle
            + self.external_sign() * involute_function(self.transverse_pressure_angle[flank])
    }
}
