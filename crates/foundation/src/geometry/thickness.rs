//! Tooth thickness and its measures: arcs, span and balls, both ways (`docs/mathematics/involute-gears.md#thickness-and-its-measures`).

use super::gear::involute_function;
use super::{Flank, Gear, GearData, GeometryError, Sides};
use crate::numerics::bisect;
use std::f64::consts::PI;

/// Span over k teeth (internal: k spaces).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span {
    /// Spanned teeth k.
    pub teeth: u32,
    /// W_k, mm.
    pub length: f64,
    /// Radius of the caliper's contact, mm.
    pub contact_radius: f64,
    /// Face width the caliper needs, mm.
    pub least_face_width: f64,
}

/// Measure over balls (internal: between balls).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OverBalls {
    /// Ball diameter D_M, mm.
    pub ball: f64,
    /// Radius of the ball's centre r_K, mm.
    pub centre_radius: f64,
    /// M_dK, mm.
    pub size: f64,
    /// Length of roll of the contact per flank, mm.
    pub contact_w: Sides<f64>,
    /// Axial position of the contact per flank, mm.
    pub contact_z: Sides<f64>,
}

/// How the tooth thickness of a gear is given (`docs/mathematics/involute-gears.md#input-and-base-quantities`); each form is turned into
/// the profile shift x.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ThicknessMeasure {
    /// x itself.
    ProfileShift(f64),
    /// Normal thickness on the pitch cylinder, mm.
    NormalThickness(f64),
    /// Span W_k over k teeth, mm.
    Span {
        /// Spanned teeth.
        teeth: u32,
        /// W_k, mm.
        length: f64,
    },
    /// Measure over balls in section z = 0.
    OverBalls {
        /// Ball diameter, mm.
        ball: f64,
        /// M_dK, mm.
        size: f64,
    },
}

impl Gear {
    /// Half space angle psi_F(r, z), rad; NaN below the base circle.
    pub fn space_half_angle(&self, flank: Flank, radius: f64, z: f64) -> f64 {
        let f = self.flank(flank);
        f.base_space_half_angle + self.external_sign() * involute_function((f.base_radius / radius).acos())
            - f.s() * z * f.twist_per_length()
    }

    /// Transverse tooth thickness s_t(r, z) as an arc, mm.
    ///
    /// # Errors
    /// [`GeometryError::RadiusBelowBaseCircle`] for a radius below either base circle.
    pub fn transverse_thickness(&self, radius: f64, z: f64) -> Result<f64, GeometryError> {
        for (_, f) in self.flanks().iter() {
            f.length_of_roll(radius)?;
        }
        let space =
            self.space_half_angle(Flank::Left, radius, z) + self.space_half_angle(Flank::Right, radius, z);
        Ok(radius * (2.0 * PI / self.tooth_count() - space))
    }

    /// Radius at which the tooth (external) becomes pointed in section z, mm; `None` if it does not up to 100 pitch radii.
    pub fn pointed_radius(&self, z: f64) -> Option<f64> {
        let thickness = |r: f64| self.transverse_thickness(r, z).unwrap_or(f64::NAN);
        let base = self.flanks().left.base_radius.max(self.flanks().right.base_radius);
        let mut lo = self.pitch_radius().max(base);
        while lo < 100.0 * self.pitch_radius() {
            let hi = lo * 1.01;
            if thickness(hi) <= 0.0 {
                return bisect(lo, hi, thickness);
            }
            lo = hi;
        }
        None
    }

    /// The gear with so much more material on its flanks, mm, normal: before a stock is taken off.
    ///
    /// # Errors
    /// Those of [`Gear::new`], among them a tooth that becomes pointed.
    pub fn with_allowance(&self, allowance: &Sides<f64>) -> Result<Self, GeometryError> {
        let (mut narrower, mut per_shift) = (0.0, 0.0);
        for (side, f) in self.flanks().iter() {
            narrower += allowance[side] / (f.base_radius * f.base_helix_angle.cos());
            // How far a shift of one module narrows the half space (`Gear::new`).
            let tangent = self.transverse_pressure_angle(side).tan();
            per_shift += 2.0 * self.data().helix_angle.cos() * tangent / self.tooth_count();
        }
        let profile_shift = self.data().profile_shift + narrower / per_shift;
        Self::new(GearData { profile_shift, ..*self.data() })
    }

    fn require_span(&self) -> Result<(), GeometryError> {
        let reason = if !self.is_cylindrical() {
            "the gear is conical"
        } else if self.data().pressure_angle.left != self.data().pressure_angle.right {
            "the gear is asymmetric"
        } else {
            return Ok(());
        };
        Err(GeometryError::SpanUndefined { reason })
    }

    /// Span W_k (cylindrical symmetric gears only).
    ///
    /// # Errors
    /// [`GeometryError::SpanUndefined`].
    pub fn span(&self, teeth: u32) -> Result<Span, GeometryError> {
        self.require_span()?;
        let f = self.flank(Flank::Left);
        let (sb, cb) = f.base_helix_angle.sin_cos();
        let z = self.tooth_count();
        let angle = if self.external_sign() > 0.0 {
            2.0 * PI * f64::from(teeth) / z - 2.0 * f.base_space_half_angle
        } else {
            2.0 * PI * (f64::from(teeth) - 1.0) / z + 2.0 * f.base_space_half_angle
        };
        let length = f.base_radius * cb * angle;
        Ok(Span {
            teeth,
            length,
            contact_radius: f.base_radius.hypot(length * cb / 2.0),
            least_face_width: length * sb.abs(),
        })
    }

    /// Measure over (between) balls whose centres lie in section z.
    ///
    /// # Errors
    /// [`GeometryError::BallTooSmall`] / [`GeometryError::BallTooLarge`].
    pub fn over_balls(&self, ball: f64, z: f64) -> Result<OverBalls, GeometryError> {
        let sg = self.external_sign();
        let too = || {
            if sg > 0.0 { GeometryError::BallTooSmall { ball } } else { GeometryError::BallTooLarge { ball } }
        };
        if !(ball > 0.0 && ball.is_finite()) {
            return Err(GeometryError::InvalidNumber { field: "ball", value: ball, allowed: "> 0 mm" });
        }
        let q: f64 = self
            .flanks()
            .iter()
            .map(|(_, f)| {
                f.base_space_half_angle
                    - ball / (2.0 * f.base_radius * f.base_helix_angle.cos())
                    - f.s() * z * f.twist_per_length()
            })
            .sum();
        let excess = |r: f64| {
            let sum: f64 = self
                .flanks()
                .iter()
                .map(|(_, f)| involute_function((f.base_radius / r).min(1.0).acos()))
                .sum();
            sum + sg * q
        };
        let base = self.flanks().left.base_radius.max(self.flanks().right.base_radius);
        if excess(base) > 0.0 {
            return Err(too());
        }
        let mut hi = base * 1.1;
        while excess(hi) < 0.0 {
            hi *= 1.5;
            if hi > base * 1e4 {
                return Err(too());
            }
        }
        let r_k = bisect(base, hi, excess).ok_or_else(too)?;
        let c = if self.data().teeth % 2 == 0 { 1.0 } else { (PI / (2.0 * self.tooth_count())).cos() };
        Ok(OverBalls {
            ball,
            centre_radius: r_k,
            size: 2.0 * r_k * c + sg * ball,
            contact_w: Sides::from_fn(|side| {
                let f = self.flank(side);
                ((r_k - f.base_radius) * (r_k + f.base_radius)).sqrt()
                    - sg * ball / 2.0 * f.base_helix_angle.cos()
            }),
            contact_z: Sides::from_fn(|side| {
                let f = self.flank(side);
                z + f.s() * ball / 2.0 * f.base_helix_angle.sin()
            }),
        })
    }
}

impl ThicknessMeasure {
    /// The profile shift x that this measure means for a body whose other data are `data` (its own x is ignored).
    ///
    /// # Errors
    /// Those of [`Gear::new`], [`Gear::span`], [`Gear::over_balls`]; [`GeometryError::InvalidNumber`] for a measure
    /// that no profile shift in -20 .. 20 reaches.
    pub fn profile_shift(&self, data: GearData) -> Result<f64, GeometryError> {
        let plain = Gear::new(GearData { profile_shift: 0.0, ..data })?;
        let tangents = |angle: &Sides<f64>| angle.left.tan() + angle.right.tan();
        match *self {
            Self::ProfileShift(x) => Ok(x),
            Self::NormalThickness(s_n) => {
                if !plain.is_cylindrical() {
                    return Err(GeometryError::CylindricalOnly);
                }
                Ok((s_n / data.normal_module - PI / 2.0) / tangents(&data.pressure_angle))
            }
            Self::Span { teeth, length } => {
                plain.require_span()?;
                let f = plain.flank(Flank::Left);
                let angle = length / (f.base_radius * f.base_helix_angle.cos());
                let (z, sg) = (plain.tooth_count(), plain.external_sign());
                let eta = if sg > 0.0 {
                    PI * f64::from(teeth) / z - angle / 2.0
                } else {
                    angle / 2.0 - PI * (f64::from(teeth) - 1.0) / z
                };
                let alpha_t = plain.transverse_pressure_angle(Flank::Left);
                Ok((PI / 2.0 - z * (eta + sg * involute_function(alpha_t)))
                    / (2.0 * data.helix_angle.cos() * alpha_t.tan()))
            }
            Self::OverBalls { ball, size } => {
                if !(ball > 0.0 && ball.is_finite()) {
                    return Err(GeometryError::InvalidNumber {
                        field: "ball",
                        value: ball,
                        allowed: "> 0 mm",
                    });
                }
                // The ball's centre follows from the size, and the sum of the half-angles eta_b is linear in x.
                let sg = plain.external_sign();
                let c = if data.teeth % 2 == 0 { 1.0 } else { (PI / (2.0 * plain.tooth_count())).cos() };
                let r_k = (size - sg * ball) / (2.0 * c);
                let mut wanted = 0.0;
                let mut slope = 0.0;
                for (side, f) in plain.flanks().iter() {
                    let w = f.length_of_roll(r_k)?;
                    wanted += -sg * involute_function((w / f.base_radius).atan())
                        + ball / (2.0 * f.base_radius * f.base_helix_angle.cos())
                        - f.base_space_half_angle;
                    slope -= 2.0 * data.helix_angle.cos() * plain.transverse_pressure_angle(side).tan()
                        / plain.tooth_count();
                }
                Ok(wanted / slope)
            }
        }
        .and_then(|x| {
            if x.abs() <= 20.0 {
                Ok(x)
            } else {
                Err(GeometryError::InvalidNumber {
                    field: "profile_shift (from the tooth thickness)",
                    value: x,
                    allowed: "-20 to 20; check the measure, the number of teeth spanned and the ball",
                })
            }
        })
    }
}
