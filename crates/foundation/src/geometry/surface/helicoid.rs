//! The involute helicoid of spur and helical gears, external and internal: `docs/mathematics/milling.md#flanks-as-patches`.
//!
//! Height = length of roll w, length = axial position z, both mm. The space stays centred on +y, also of an internal gear.

use super::bounds::{largest, remainder};
use super::{OffsetBase, SecondOrder, Surface, SurfaceJet};
use crate::geometry::{Flank, Gear, GeometryError, InvoluteFlank, involute_function};
use nalgebra::Vector3;
use std::f64::consts::PI;

/// One flank of a tooth space as a helicoid. mm, rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Helicoid {
    flank: InvoluteFlank,
    pitch_radius: f64,
    normal_module: f64,
    profile_shift: f64,
    /// k = tan(beta_b)/r_b.
    twist: f64,
    sin_base_helix: f64,
    cos_base_helix: f64,
}

/// Directions at a place: e_r and u of `docs/mathematics/milling.md` at phi.
struct Directions {
    e_r: Vector3<f64>,
    u: Vector3<f64>,
}

/// ez x v.
#[inline]
pub(crate) fn turned(v: &Vector3<f64>) -> Vector3<f64> {
    Vector3::new(-v.y, v.x, 0.0)
}

impl Helicoid {
    /// A flank of a gear without thinning.
    pub fn new(gear: &Gear, flank: Flank) -> Self {
        let involute = *gear.flank(flank);
        let (sin_base_helix, cos_base_helix) = involute.base_helix_angle.sin_cos();
        Self {
            flank: involute,
            pitch_radius: gear.pitch_radius(),
            normal_module: gear.data().normal_module,
            profile_shift: gear.data().profile_shift,
            twist: involute.twist_per_length(),
            sin_base_helix,
            cos_base_helix,
        }
    }

    /// A flank whose spaces are wider by the circumferential backlash j_t at the pitch circle, mm: eta += j_t/(2r).
    ///
    /// # Errors
    /// [`GeometryError::InvalidNumber`] when it is not finite (`E_GEOM_INPUT` of `docs/mathematics/milling.md#limits`).
    pub fn thinned(gear: &Gear, flank: Flank, backlash: f64) -> Result<Self, GeometryError> {
        if !backlash.is_finite() {
            let (field, allowed) = ("circumferential_backlash", "a finite length");
            return Err(GeometryError::InvalidNumber { field, value: backlash, allowed });
        }
        let mut helicoid = Self::new(gear, flank);
        helicoid.flank.base_space_half_angle += backlash / (2.0 * gear.pitch_radius());
        Ok(helicoid)
    }

    /// The flank with its base data.
    pub fn flank(&self) -> &InvoluteFlank {
        &self.flank
    }

    /// Pitch radius r, mm.
    pub fn pitch_radius(&self) -> f64 {
        self.pitch_radius
    }

    /// Base radius r_b, mm.
    pub fn base_radius(&self) -> f64 {
        self.flank.base_radius
    }

    /// Half angle of the space on the base circle eta_b, thinning included, rad.
    pub fn base_space_half_angle(&self) -> f64 {
        self.flank.base_space_half_angle
    }

    /// Base helix angle beta_b, rad, > 0 right-handed.
    pub fn base_helix_angle(&self) -> f64 {
        self.flank.base_helix_angle
    }

    /// k = tan(beta_b)/r_b, rad/mm.
    pub fn twist(&self) -> f64 {
        self.twist
    }

    /// sig: +1 external, -1 internal.
    pub fn external_sign(&self) -> f64 {
        self.flank.external_sign
    }

    /// Tip radius r + sig m_n (h_aP + x), mm, for an addendum factor h_aP (1 on most drawings).
    pub fn tip_radius(&self, addendum_factor: f64) -> f64 {
        self.pitch_radius + self.external_sign() * self.normal_module * (addendum_factor + self.profile_shift)
    }

    /// Root radius r - sig m_n (h_fP - x), mm, for a dedendum factor h_fP (1.25 on most drawings).
    pub fn root_radius(&self, dedendum_factor: f64) -> f64 {
        self.pitch_radius - self.external_sign() * self.normal_module * (dedendum_factor - self.profile_shift)
    }

    /// Height parameter w of a radius, mm.
    ///
    /// # Errors
    /// [`GeometryError::RadiusBelowBaseCircle`] (`E_GEOM_BASE` of `docs/mathematics/milling.md#limits`).
    pub fn length_of_roll(&self, radius: f64) -> Result<f64, GeometryError> {
        self.flank.length_of_roll(radius)
    }

    /// Whether something is left of the tooth at its tip, with the flank mirrored on its other side.
    ///
    /// # Errors
    /// [`GeometryError::RadiusBelowBaseCircle`], [`GeometryError::ToothPointed`] (`E_GEOM_POINTED` of
    /// `docs/mathematics/milling.md#limits`).
    pub fn check_tip(&self, tip_radius: f64) -> Result<(), GeometryError> {
        let w = self.length_of_roll(tip_radius)?;
        let angle = (w / self.base_radius()).atan();
        let half = PI / self.flank.teeth
            - self.base_space_half_angle()
            - self.external_sign() * involute_function(angle);
        if half > 0.0 {
            return Ok(());
        }
        Err(GeometryError::ToothPointed { radius: tip_radius, z: 0.0, thickness: 2.0 * tip_radius * half })
    }

    #[inline]
    fn directions(&self, w: f64, z: f64) -> Directions {
        let flank = &self.flank;
        let roll = flank.external_sign * w / flank.base_radius + flank.base_space_half_angle;
        let (sin, cos) = (flank.s() * roll - self.twist * z).sin_cos();
        Directions { e_r: Vector3::new(sin, cos, 0.0), u: Vector3::new(cos, -sin, 0.0) }
    }
}

impl Surface for Helicoid {
    fn domain(&self) -> [[f64; 2]; 2] {
        [[0.0, f64::INFINITY], [f64::NEG_INFINITY, f64::INFINITY]]
    }

    #[inline]
    fn point(&self, w: f64, z: f64) -> Vector3<f64> {
        let at = self.directions(w, z);
        let across = self.external_sign() * self.flank.s() * w;
        let plane = at.e_r * self.base_radius() - at.u * across;
        Vector3::new(plane.x, plane.y, z)
    }

    #[inline]
    fn jet(&self, w: f64, z: f64) -> SurfaceJet {
        let (s, sig, r_b) = (self.flank.s(), self.external_sign(), self.base_radius());
        let at = self.directions(w, z);
        let mut point = at.e_r * r_b - at.u * (sig * s * w);
        point.z = z;
        let mut by_length = turned(&point) * self.twist;
        by_length.z = 1.0;
        let mut normal = at.u * (-s * self.cos_base_helix);
        normal.z = -s * self.sin_base_helix;
        SurfaceJet {
            point,
            by_height: at.e_r * (w / r_b),
            by_length,
            normal,
            normal_by_height: at.e_r * (sig * self.cos_base_helix / r_b),
            normal_by_length: turned(&normal) * self.twist,
        }
    }

    /// Exact: both speeds grow with w alone.
    fn speed_bounds(&self, heights: [f64; 2], _: [f64; 2]) -> [f64; 2] {
        let w = largest(heights);
        let r_b = self.base_radius();
        [w / r_b, (self.twist * r_b.hypot(w)).hypot(1.0)]
    }

    /// |S_ww| = hypot(1, w/r_b)/r_b, |S_wz| = k w/r_b, |S_zz| = k^2 r: all grow with w alone.
    fn off_tangent(&self, heights: [f64; 2], lengths: [f64; 2]) -> f64 {
        let (r_b, k) = (self.base_radius(), self.twist.abs());
        let roll = largest(heights) / r_b;
        let radius = r_b * roll.hypot(1.0);
        remainder([roll.hypot(1.0) / r_b, k * roll, k * k * radius], heights, lengths)
    }
}

impl OffsetBase for Helicoid {
    #[inline]
    fn second_order(&self, w: f64, z: f64) -> SecondOrder {
        let (s, sig, r_b) = (self.flank.s(), self.external_sign(), self.base_radius());
        let jet = self.jet(w, z);
        // e_r turns into u with phi, and phi by w goes with s sig/r_b; u turns into -e_r.
        let e_r = jet.normal_by_height * (r_b / (sig * self.cos_base_helix));
        let u = Vector3::new(e_r.y, -e_r.x, 0.0);
        let by_roll = u * (s * sig / r_b);
        SecondOrder {
            jet,
            point: [
                e_r / r_b + by_roll * (w / r_b),
                turned(&jet.by_height) * self.twist,
                turned(&jet.by_length) * self.twist,
            ],
            normal: [
                by_roll * (sig * self.cos_base_helix / r_b),
                turned(&jet.normal_by_height) * self.twist,
                turned(&jet.normal_by_length) * self.twist,
            ],
        }
    }

    /// Exact: both are the same everywhere.
    fn normal_speed_bounds(&self, _: [f64; 2], _: [f64; 2]) -> [f64; 2] {
        [self.cos_base_helix / self.base_radius(), self.twist.abs() * self.cos_base_helix]
    }

    /// The normal turns with u: its second derivatives are as long everywhere.
    fn normal_off_tangent(&self, heights: [f64; 2], lengths: [f64; 2]) -> f64 {
        let (by_roll, by_length) = (1.0 / self.base_radius(), self.twist.abs());
        let second = [by_roll * by_roll, by_roll * by_length, by_length * by_length];
        self.cos_base_helix * remainder(second, heights, lengths)
    }
}
