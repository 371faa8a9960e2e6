//! Nominal contact of dresser and involute worm flank: the conjugate meridian (`docs/mathematics/dressing.md#the-conjugate-profile`).

use super::DressingError;
use foundation::geometry::InvoluteFlank;
use foundation::kinematics::DressingChain;

/// Where a flank point of roll w touches the disc in the nominal kinematics at v_zS = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NominalContact {
    /// Worm z of the point, mm.
    pub b: f64,
    /// db/dw along the contact line.
    pub slope: f64,
    /// Dresser meridian: radius, axial position (mm), outward unit normal.
    pub r: f64,
    /// See `r`.
    pub z: f64,
    /// See `r`.
    pub n_r: f64,
    /// See `r`.
    pub n_z: f64,
}

/// The nominal contact at length of roll `w`.
///
/// # Errors
/// [`DressingError::NoConjugate`] when the contact equation has no root near the nominal one or w <= 0.
pub fn nominal_contact(
    flank: &InvoluteFlank,
    chain: &DressingChain,
    w: f64,
) -> Result<NominalContact, DressingError> {
    let none = || DressingError::NoConjugate { flank: flank.flank, w };
    if w.is_nan() || w <= 0.0 {
        return Err(none());
    }
    let (s, r_b, eta) = (flank.s(), flank.base_radius, flank.base_space_half_angle);
    let (sb, cb) = flank.base_helix_angle.sin_cos();
    let p = chain.screw_parameter;
    let (sin_g, cos_g) = chain.crossing_angle.sin_cos();
    let (d, v_y) = (chain.centre_distance, chain.offset);
    let off = chain.worm_angle + std::f64::consts::FRAC_PI_2;
    let mut phi = s * (w / r_b).atan();
    let (mut g_w, mut g_phi) = (0.0, 0.0);
    let mut converged = false;
    for _ in 0..60 {
        let (sin, cos) = phi.sin_cos();
        let z0 = p * (s * eta - phi - off);
        let g = sin_g * (s * sin * w / sb + (z0 - v_y * sin_g) * cb * sin + sb * (r_b * cos - d))
            + cos_g * (cb * (r_b - d * cos) - v_y * cos_g * cb * sin);
        g_w = sin_g * s * sin / sb;
        g_phi = sin_g * (s * cos * w / sb - p * cb * sin + (z0 - v_y * sin_g) * cb * cos - sb * r_b * sin)
            + cos_g * (cb * d * sin - v_y * cos_g * cb * cos);
        let step = g / g_phi;
        if !step.is_finite() {
            return Err(none());
        }
        phi -= step;
        if converged {
            break;
        }
        // One more step after the tolerance is met brings the root to rounding.
        converged = step.abs() < 1e-12;
    }
    if !converged {
        return Err(none());
    }
    let (sin, cos) = phi.sin_cos();
    let b = p * (s * (w / r_b + eta) - phi - off);
    let point = [r_b * cos + s * w * sin, -r_b * sin + s * w * cos, b];
    let normal = [s * cb * sin, s * cb * cos, -s * sb];
    let arm = [point[0] - d, point[1] + v_y * cos_g, point[2] - v_y * sin_g];
    let across = |v: &[f64; 3]| v[1] * cos_g - v[2] * sin_g;
    let along = |v: &[f64; 3]| v[1] * sin_g + v[2] * cos_g;
    let r = arm[0].hypot(across(&arm));
    if r.is_nan() || r <= 0.0 {
        return Err(none());
    }
    Ok(NominalContact {
        b,
        slope: p * (s / r_b + g_w / g_phi),
        r,
        z: along(&arm),
        n_r: -(normal[0] * arm[0] + across(&normal) * across(&arm)) / r,
        n_z: -along(&normal),
    })
}
