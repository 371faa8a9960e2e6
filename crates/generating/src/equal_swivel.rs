//! One dresser for both flanks at once: the diagonal ratio at which both ask for the same swivel along the worm
//! (`docs/mathematics/generating-contact.md#decomposition-of-a-target`, F_Q = 0). Cylindrical bodies.

use super::{FlankLines, GeneratingError, GrindingSetup};
use dressing::{DressedProfile, TiltChart};
use foundation::geometry::{Flank, Sides};
use foundation::numerics::Polynomial2;

/// One flank of the question.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SwivelSide {
    /// Numbers of the flank.
    pub lines: FlankLines,
    /// A_20, A_11, A_02 of the wanted f_t in (w, z), 1/mm.
    pub second_degree: [f64; 3],
    /// g = d(swivel)/d(slope of f_t1 over w_1), signed, rad per mm/mm.
    pub gain: f64,
}

/// Diagonal ratios with equal swivel on both flanks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum EqualSwivel {
    /// Every ratio: both flanks always ask for the same.
    Every,
    /// This one.
    Ratio(f64),
}

impl SwivelSide {
    /// One flank of a setup with a dresser, for a target polynomial in (u, y) whose u^2 stays with the dresser unless
    /// `in_diagonal`. The swivel is tau of the tilt chart of dressing (`docs/mathematics/dressing.md#limits-of-a-correction`).
    ///
    /// # Errors
    /// `NotDressed`, those of the nominal contact of dresser and worm.
    pub fn of_target(
        setup: &GrindingSetup,
        flank: Flank,
        a: &Polynomial2,
        in_diagonal: bool,
    ) -> Result<Self, GeneratingError> {
        let dresser = setup.dresser()?;
        let lines = setup.lines[flank];
        let range = dresser.flanks[flank].range;
        let chain = &dresser.flanks[flank].chain;
        let direction =
            TiltChart::swivel_direction(chain.crossing_angle, chain.centre_distance, chain.screw_parameter);
        let nominal = DressedProfile::new(dresser, flank, [0.0; 4]);
        let by_swivel = |w: f64| -> Result<f64, GeneratingError> {
            let at = nominal.at_roll(w)?;
            Ok(at.df_dk.iter().zip(direction).map(|(f, k)| f * k).sum())
        };
        let slope = (by_swivel(range.w_na)? - by_swivel(range.w_nf)?) / (range.length() * lines.cos_b1);
        let of_profile = if in_diagonal { 0.0 } else { a.coefficient(2, 0) };
        let second_degree = [a.coefficient(2, 0) - of_profile, a.coefficient(1, 1), a.coefficient(0, 2)];
        Ok(Self { lines, second_degree, gain: 1.0 / slope })
    }

    /// `[constant, over K]` of d psi/dv = constant + (over K)/K, rad/mm.
    fn rate_terms(&self) -> [f64; 2] {
        let FlankLines { t_k, cos_b1, cos_b2, big_t1, .. } = self.lines;
        let [a_20, a_11, a_02] = self.second_degree;
        let b = cos_b2 / cos_b1;
        let along_path = a_20 - a_11 * t_k + a_02 * t_k * t_k;
        let g = self.gain * b * b;
        [-2.0 * g * cos_b2 * along_path / big_t1, g * (2.0 * a_02 * t_k - a_11)]
    }

    /// Swivel per mm of the dresser along the worm at diagonal ratio K, rad/mm.
    pub fn rate(&self, ratio: f64) -> f64 {
        let [constant, over] = self.rate_terms();
        constant + over / ratio
    }

    /// K_10 and K_11 of F_L = K_10 + K_11 X_2 (transverse, on the workpiece) such that the swivel is `swivel` (rad) where the
    /// dresser stands on the worm line xi_1 = X_1/cos(rho_1) (mm), at z_V1 = K z_V2 + z_V01.
    pub fn linear_part(&self, ratio: f64, shift_origin: f64, xi_1: f64, swivel: f64) -> [f64; 2] {
        let FlankLines { t_k, cos_b1, cos_b2, big_t1, c_c1, c_c2, e, .. } = self.lines;
        let [a_20, a_11, a_02] = self.second_degree;
        let t = self.lines.work_direction(ratio);
        let c = 1.0 / t.hypot(1.0);
        let k_11 = (2.0 * a_20 - a_11 * (t + t_k) + 2.0 * a_02 * t * t_k) / ((t - t_k) * c);
        let x_2 = c * (c_c2 + (shift_origin - c_c1 - big_t1 * e + xi_1) / ratio);
        let b = cos_b2 / cos_b1;
        [swivel / (self.gain * b * b) - k_11 * x_2, k_11]
    }
}

/// The diagonal ratio K = D/N at which both flanks need the same swivel per mm of dresser travel.
///
/// # Errors
/// `NoCommonSwivel` when only one of N and D is zero, `InvalidNumber` for a gain of zero or numbers that are not finite,
/// `WormDirectionDegenerate`.
pub fn equal_swivel(sides: &Sides<SwivelSide>) -> Result<EqualSwivel, GeneratingError> {
    for (_, side) in sides.iter() {
        side.lines.check_worm_direction()?;
        let good = side.gain.is_finite() && side.gain != 0.0;
        super::curve_law::number("gain", side.gain, good, "a finite number other than 0")?;
        for a in side.second_degree {
            super::curve_law::number("second_degree", a, a.is_finite(), "a finite number")?;
        }
    }
    let ([left_constant, left_over], [right_constant, right_over]) =
        (sides.left.rate_terms(), sides.right.rate_terms());
    // Rates agree when constant_l + over_l/K = constant_r + over_r/K.
    let difference = |l: f64, r: f64| {
        let apart = l - r;
        // Equal to rounding of the dozen operations behind each.
        if apart.abs() <= 1e-12 * (l.abs() + r.abs()) { 0.0 } else { apart }
    };
    let denominator = difference(right_constant, left_constant);
    let numerator = difference(left_over, right_over);
    match (numerator == 0.0, denominator == 0.0) {
        (true, true) => Ok(EqualSwivel::Every),
        (false, false) => Ok(EqualSwivel::Ratio(numerator / denominator)),
        _ => Err(GeneratingError::NoCommonSwivel { numerator, denominator }),
    }
}
