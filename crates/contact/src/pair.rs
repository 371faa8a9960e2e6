//! Unmodified worm and workpiece in contact: common normal, coefficients of R6 and R7, rotations and coupling
//! (`docs/mathematics/generating-contact.md#affine-relations`, vector form; every combination of cylinder and cone).

use super::ContactError;
use foundation::geometry::{Flank, Gear, InvoluteFlank, Sides, involute_function};
use foundation::kinematics::{GeneratingChain, GeneratingMotion, MotionLaw};
use nalgebra::Vector3;

/// Contact relations of one flank. 1 = worm, 2 = workpiece; names as in `docs/mathematics/generating-contact.md#affine-relations` (without
/// the flank index).
#[derive(Clone, Debug, PartialEq)]
pub struct FlankPair {
    /// The worm's flank.
    pub worm: InvoluteFlank,
    /// The workpiece's flank.
    pub work: InvoluteFlank,
    /// Common normal, out of the worm, in the room frame.
    pub normal: Vector3<f64>,
    /// Radial direction of the tangent point at the worm's base cylinder (room frame).
    pub e_r1: Vector3<f64>,
    /// The same at the workpiece.
    pub e_r2: Vector3<f64>,
    /// Worm axis in the room frame.
    pub a_1: Vector3<f64>,
    /// Workpiece axis in the room frame.
    pub a_2: Vector3<f64>,
    /// Operating normal profile angle, rad.
    pub operating_alpha_n: f64,
    /// Operating helix angle of the worm on the common rack, rad.
    pub operating_beta_w1: f64,
    /// Operating helix angle of the workpiece, rad.
    pub operating_beta_w2: f64,
    /// Operating normal module, mm.
    pub operating_module: f64,
    /// z_1 = c_w1 w_1 + c_zv11 z_V1 + c_zv21 z_V2 + c_c1.
    pub c_w1: f64,
    /// See `c_w1`.
    pub c_zv11: f64,
    /// See `c_w1`.
    pub c_zv21: f64,
    /// See `c_w1`, mm.
    pub c_c1: f64,
    /// z_2 = c_w2 w_2 + c_zv12 z_V1 + c_zv22 z_V2 + c_c2.
    pub c_w2: f64,
    /// See `c_w2`.
    pub c_zv12: f64,
    /// See `c_w2`.
    pub c_zv22: f64,
    /// See `c_w2`, mm.
    pub c_c2: f64,
    /// hat_w1 w_1 + hat_w2 w_2 + hat_zv1 z_V1 + hat_zv2 z_V2 + hat_c = 0.
    pub hat_w1: f64,
    /// See `hat_w1`.
    pub hat_w2: f64,
    /// See `hat_w1`.
    pub hat_zv1: f64,
    /// See `hat_w1`.
    pub hat_zv2: f64,
    /// See `hat_w1`, mm.
    pub hat_c: f64,
    /// Polar angle of e_r1 in the worm's rest frame, from +y towards +x, rad.
    worm_polar: f64,
    /// Polar angle of e_r2 in the workpiece's rest frame, rad.
    work_polar: f64,
    /// k_V1 = 2 sin(beta_w1)/m_n, rad/mm.
    pub shift_coupling: f64,
    /// k_V2 = 2 sin(beta_w2)/m_n, rad/mm.
    pub feed_coupling: f64,
    /// k_0F, rad (not reduced).
    pub phase: f64,
}

/// Worm and workpiece in a chain: both flanks.
#[derive(Clone, Debug, PartialEq)]
pub struct Pair {
    /// The worm.
    pub worm: Gear,
    /// The workpiece.
    pub work: Gear,
    /// The chain they stand in.
    pub chain: GeneratingChain,
    /// Relations per flank.
    pub flanks: Sides<FlankPair>,
}

fn rotated_x(angle: f64, v: &Vector3<f64>) -> Vector3<f64> {
    let (s, c) = angle.sin_cos();
    Vector3::new(v.x, c * v.y - s * v.z, s * v.y + c * v.z)
}

fn rotated_y(angle: f64, v: &Vector3<f64>) -> Vector3<f64> {
    let (s, c) = angle.sin_cos();
    Vector3::new(c * v.x + s * v.z, v.y, -s * v.x + c * v.z)
}

impl FlankPair {
    fn new(worm: &Gear, work: &Gear, chain: &GeneratingChain, flank: Flank) -> Result<Self, ContactError> {
        let s = flank.sign();
        let (f1, f2) = (*worm.flank(flank), *work.flank(flank));
        let (sb1, cb1) = f1.base_helix_angle.sin_cos();
        let (sb2, cb2) = f2.base_helix_angle.sin_cos();
        let gamma = chain.crossed_axes_angle;
        let e_y = Vector3::y();
        let e_z = Vector3::z();
        let a_1 = rotated_x(-chain.worm_cone, &e_z);
        let a_2 = rotated_y(gamma, &rotated_x(-chain.work_cone, &e_z));
        let across = a_1.cross(&a_2);
        let square = across.norm_squared();
        if square < 1e-12 {
            return Err(ContactError::AxesParallel { angle_deg: gamma.to_degrees() });
        }
        let c = a_1.dot(&a_2);
        let (p_1, p_2) = (-s * sb1, s * sb2);
        let (u, v) = ((p_1 - c * p_2) / square, (p_2 - c * p_1) / square);
        let rest = 1.0 - (u * p_1 + v * p_2);
        if rest.is_nan() || rest <= 1e-14 {
            return Err(ContactError::NoCommonNormal { flank, angle_deg: gamma.to_degrees() });
        }
        let side = if across.y >= 0.0 { 1.0 } else { -1.0 };
        let normal = a_1 * u + a_2 * v + across * (side * (rest / square).sqrt());
        let e_r1 = normal.cross(&a_1) * (s / cb1);
        let e_r2 = normal.cross(&a_2) * (-s / cb2);
        let kk = e_r1.dot(&e_r2);
        let (r_b1, r_b2) = (f1.base_radius, f2.base_radius);
        let g = Vector3::new(gamma.sin(), 0.0, gamma.cos());
        let apart = chain.centre_distance + chain.worm_pivot * chain.worm_cone.cos()
            - chain.work_pivot * chain.work_cone.cos();
        let offset = e_y * apart + g * (chain.work_pivot * chain.work_cone.sin())
            - e_z * (chain.worm_pivot * chain.worm_cone.sin());
        let lever_1 = a_1.dot(&e_r2);
        let lever_2 = a_2.dot(&e_r1);
        let zeta_1 = |d: &Vector3<f64>, r: f64| (r + d.dot(&e_r2)) / lever_1;
        let zeta_2 = |d: &Vector3<f64>, r: f64| (r - d.dot(&e_r1)) / lever_2;
        let zero = Vector3::zeros();
        let (k_1, k_2) = (r_b2 - r_b1 * kk, r_b1 - r_b2 * kk);
        let (c_c1, c_c2) = (zeta_1(&offset, k_1), zeta_2(&offset, k_2));
        let (c_zv11, c_zv21) = (zeta_1(&-e_z, 0.0), zeta_1(&g, 0.0));
        let (c_zv12, c_zv22) = (zeta_2(&-e_z, 0.0), zeta_2(&g, 0.0));
        let gap = |d: &Vector3<f64>, base: &Vector3<f64>, z1: f64, z2: f64| {
            (d + base - a_1 * z1 + a_2 * z2).dot(&normal)
        };
        let base = e_r2 * r_b2 - e_r1 * r_b1;
        let operating_alpha_n = normal.y.clamp(-1.0, 1.0).asin();
        let operating_beta_w1 = (-s * normal.z).atan2(-s * normal.x);
        let operating_beta_w2 = {
            let raw = -gamma - operating_beta_w1;
            raw - 2.0 * std::f64::consts::PI * (raw / (2.0 * std::f64::consts::PI)).round()
        };
        let operating_module = 2.0 * r_b2 * cb2 / (work.tooth_count() * operating_alpha_n.cos());
        let polar = |v: &Vector3<f64>| v.x.atan2(v.y);
        let mut pair = Self {
            worm: f1,
            work: f2,
            normal,
            e_r1,
            e_r2,
            a_1,
            a_2,
            operating_alpha_n,
            operating_beta_w1,
            operating_beta_w2,
            operating_module,
            c_w1: -s * f1.base_helix_angle.tan(),
            c_zv11,
            c_zv21,
            c_c1,
            c_w2: -s * f2.base_helix_angle.tan(),
            c_zv12,
            c_zv22,
            c_c2,
            hat_w1: 1.0 / cb1,
            hat_w2: 1.0 / cb2,
            hat_zv1: -gap(&-e_z, &zero, c_zv11, c_zv12),
            hat_zv2: -gap(&g, &zero, c_zv21, c_zv22),
            hat_c: -gap(&offset, &base, c_c1, c_c2),
            worm_polar: polar(&rotated_x(chain.worm_cone, &e_r1)),
            work_polar: polar(&rotated_x(chain.work_cone, &rotated_y(-gamma, &e_r2))),
            shift_coupling: 2.0 * operating_beta_w1.sin() / operating_module,
            feed_coupling: 2.0 * operating_beta_w2.sin() / operating_module,
            phase: 0.0,
        };
        // k_0F from any contact: it is the constant of R4.
        let w_2 = work.pitch_radius() * work.transverse_pressure_angle(flank).sin();
        let (w_1, z_1, z_2) =
            (pair.worm_roll(w_2, 0.0, 0.0), pair.worm_z(0.0, 0.0, 0.0), pair.work_z(w_2, 0.0, 0.0));
        let z_1 = z_1 + pair.c_w1 * w_1;
        pair.phase =
            worm.tooth_count() * pair.worm_angle(w_1, z_1) + work.tooth_count() * pair.work_angle(w_2, z_2);
        Ok(pair)
    }

    /// The flank.
    pub fn flank(&self) -> Flank {
        self.worm.flank
    }

    /// w_1 that touches w_2 (R7), mm.
    pub fn worm_roll(&self, w_2: f64, shift: f64, feed: f64) -> f64 {
        -(self.hat_w2 * w_2 + self.hat_zv1 * shift + self.hat_zv2 * feed + self.hat_c) / self.hat_w1
    }

    /// w_2 that touches w_1 (R7), mm.
    pub fn work_roll(&self, w_1: f64, shift: f64, feed: f64) -> f64 {
        -(self.hat_w1 * w_1 + self.hat_zv1 * shift + self.hat_zv2 * feed + self.hat_c) / self.hat_w2
    }

    /// z_1 of the contact at w_1 (R6), mm.
    pub fn worm_z(&self, w_1: f64, shift: f64, feed: f64) -> f64 {
        self.c_w1 * w_1 + self.c_zv11 * shift + self.c_zv21 * feed + self.c_c1
    }

    /// z_2 of the contact at w_2 (R6), mm.
    pub fn work_z(&self, w_2: f64, shift: f64, feed: f64) -> f64 {
        self.c_w2 * w_2 + self.c_zv12 * shift + self.c_zv22 * feed + self.c_c2
    }

    /// phi_1 at which (w_1, z_1) is in contact (R5), rad.
    pub fn worm_angle(&self, w_1: f64, z_1: f64) -> f64 {
        self.worm.phi(w_1, z_1) - self.worm_polar
    }

    /// phi_2 at which (w_2, z_2) is in contact (R5), rad.
    pub fn work_angle(&self, w_2: f64, z_2: f64) -> f64 {
        self.work.phi(w_2, z_2) - self.work_polar
    }

    /// Operating transverse profile angle of the worm, rad: angle of e_r1 against the common perpendicular.
    pub fn operating_alpha_t1(&self) -> f64 {
        self.worm_polar.abs()
    }

    /// Operating transverse profile angle of the workpiece, rad.
    pub fn operating_alpha_t2(&self) -> f64 {
        std::f64::consts::PI - self.work_polar.abs()
    }
}

impl Pair {
    /// Worm and workpiece in a given chain.
    ///
    /// # Errors
    /// `InternalUnsupported`, `NotMating` (as geometry error), `AxesParallel`, `NoCommonNormal`, `InvalidNumber` for d <= 0 and for
    /// numbers that are not finite.
    pub fn new(worm: Gear, work: Gear, chain: GeneratingChain) -> Result<Self, ContactError> {
        for body in [&worm, &work] {
            if body.data().teeth < 0 {
                return Err(ContactError::InternalUnsupported { teeth: body.data().teeth });
            }
        }
        let number = |field, value: f64, good: bool, allowed| {
            if good { Ok(()) } else { Err(ContactError::InvalidNumber { field, value, allowed }) }
        };
        let d = chain.centre_distance;
        number("centre_distance", d, d.is_finite() && d > 0.0, "> 0 mm")?;
        for (field, value) in [
            ("crossed_axes_angle", chain.crossed_axes_angle),
            ("worm_cone", chain.worm_cone),
            ("work_cone", chain.work_cone),
            ("worm_pivot", chain.worm_pivot),
            ("work_pivot", chain.work_pivot),
        ] {
            number(field, value, value.is_finite(), "a finite number")?;
        }
        foundation::geometry::check_mating(&worm, &work)?;
        let flanks = Sides::try_from_fn(|flank| FlankPair::new(&worm, &work, &chain, flank))?;
        Ok(Self { worm, work, chain, flanks })
    }

    /// Worm and workpiece in the chain without backlash on both flanks
    /// (`docs/mathematics/generating-contact.md#coupling-of-the-rotations`): d follows from the bodies.
    ///
    /// # Errors
    /// As [`Pair::new`], and `RacksNotCongruent` when the two flanks have no common rack.
    pub fn without_backlash(worm: Gear, work: Gear, crossed_axes_angle: f64) -> Result<Self, ContactError> {
        let pivots = |cone: f64, radius: f64| if cone == 0.0 { 0.0 } else { radius };
        let mut chain = GeneratingChain {
            centre_distance: worm.pitch_radius() + work.pitch_radius(),
            crossed_axes_angle,
            worm_cone: worm.data().cone_angle,
            work_cone: -work.data().cone_angle,
            worm_pivot: pivots(worm.data().cone_angle, worm.pitch_radius()),
            work_pivot: 0.0,
        };
        let trial = Self::new(worm, work, chain)?;
        trial.require_common_rack()?;
        let (r_w1, r_w2) = trial.rack_radii();
        chain.work_pivot = pivots(chain.work_cone, r_w2);
        chain.worm_pivot = pivots(chain.worm_cone, r_w1);
        let delta_y = trial.backlash_free_gap(r_w1, r_w2);
        chain.centre_distance = Self::centre_distance_of_gap(&chain, r_w1, r_w2, delta_y);
        Self::new(worm, work, chain)
    }

    /// Pitch radii (r_w1, r_w2) on the common rack, mm (that of the left flank where the racks differ).
    pub fn rack_radii(&self) -> (f64, f64) {
        let rack = &self.flanks.left;
        let radius = |teeth: f64, beta: f64| teeth * rack.operating_module / (2.0 * beta.cos());
        (
            radius(self.worm.tooth_count(), rack.operating_beta_w1),
            radius(self.work.tooth_count(), rack.operating_beta_w2),
        )
    }

    /// d for a gap delta_y between the pitch planes (`docs/mathematics/generating-contact.md`).
    fn centre_distance_of_gap(chain: &GeneratingChain, r_w1: f64, r_w2: f64, delta_y: f64) -> f64 {
        let worm = if chain.worm_cone == 0.0 { r_w1 } else { 0.0 };
        let work = if chain.work_cone == 0.0 { r_w2 } else { 2.0 * r_w2 * chain.work_cone.cos() };
        worm + work + delta_y
    }

    /// delta_y at which both flanks mesh without backlash (`docs/mathematics/generating-contact.md#coupling-of-the-rotations`), mm. r_wi:
    /// pitch radii on the common rack.
    pub fn backlash_free_gap(&self, r_w1: f64, r_w2: f64) -> f64 {
        let mut space = 0.0;
        let mut tangents = 0.0;
        for (_, f) in self.flanks.iter() {
            let psi = |flank: &InvoluteFlank, r: f64| {
                flank.base_space_half_angle + involute_function((flank.base_radius / r).acos())
            };
            space +=
                self.worm.tooth_count() * psi(&f.worm, r_w1) + self.work.tooth_count() * psi(&f.work, r_w2);
            tangents += f.operating_alpha_n.tan();
        }
        self.flanks.left.operating_module * (2.0 * std::f64::consts::PI - space) / (2.0 * tangents)
    }

    fn require_common_rack(&self) -> Result<(), ContactError> {
        let (l, r) = (&self.flanks.left, &self.flanks.right);
        let apart = (l.operating_beta_w1 - r.operating_beta_w1).abs()
            + (l.operating_module - r.operating_module).abs() / l.operating_module;
        if apart > 1e-9 {
            return Err(ContactError::RacksNotCongruent {
                left_deg: l.operating_beta_w1.to_degrees(),
                right_deg: r.operating_beta_w1.to_degrees(),
            });
        }
        Ok(())
    }

    /// The motion of this pair with tool shift z_V1 = F(v) and no corrections.
    pub fn motion(&self, shift: MotionLaw) -> GeneratingMotion {
        GeneratingMotion {
            chain: self.chain,
            threads: self.worm.tooth_count(),
            teeth: self.work.tooth_count(),
            shift_coupling: self.flanks.left.shift_coupling,
            feed_coupling: self.flanks.left.feed_coupling,
            phase: self.flanks.map(|_, f| f.phase),
            shift,
            delta_d: MotionLaw::zero(),
            delta_phi_2: MotionLaw::zero(),
            delta_gamma: MotionLaw::zero(),
        }
    }
}
