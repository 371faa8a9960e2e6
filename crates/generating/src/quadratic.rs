//! Decomposition into worm functions of second degree in w and a grinding motion, without a profile of the dresser: class
//! {C, L, Q, K} of `docs/mathematics/generating-contact.md#decomposition-of-a-target`, in raw variables (w, z). Knows neither dresser nor
//! job.
//!
//! The plan uses the class {C, L, P, K} of [`super::Decomposition`] instead, because a disc dresser makes a profile that varies
//! along the worm only in narrow limits.
//!
//! No command reaches it: `verify` recomputes the worm functions of references with it.

use super::FlankLines;
use super::decomposition::power_jet;
use contact::ThreadFunction;
use foundation::kinematics::MotionLaw;
use foundation::numerics::{Jet2, Polynomial2};

/// f_t = F_C(X) + F_L(X) w + F_Q(X) w^2 + F_K(X_K) with X = c (t w + z), X_K = c_K (t_K w + z). Transverse, mm.
#[derive(Clone, Debug, PartialEq)]
pub struct QuadraticDecomposition {
    /// tan(rho_2).
    pub t: f64,
    /// t_K.
    pub t_k: f64,
    /// K_00 .. K_03: F_C.
    pub constant: [f64; 4],
    /// K_10 .. K_12: F_L.
    pub linear: [f64; 3],
    /// K_20, K_21: F_Q.
    pub quadratic: [f64; 2],
    /// K_K0 .. K_K3: F_K.
    pub kinematic: [f64; 4],
}

/// Which of the decompositions that give the same flank is taken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Gauge {
    /// F_K and F_K' vanish in the middle of the profile (w_m, mm) at z = 0: least axis travel.
    Centred {
        /// w_m, mm.
        w_m: f64,
        /// K_20, 1/mm.
        k_20: f64,
    },
    /// The free coefficients as given.
    Given {
        /// K_10, mm/mm.
        k_10: f64,
        /// K_20, 1/mm.
        k_20: f64,
        /// K_K0, mm.
        k_k0: f64,
    },
}

fn cosine(t: f64) -> f64 {
    1.0 / t.hypot(1.0)
}

/// p(w, z) as a polynomial in (w, X), X = c (t w + z).
fn in_line_coordinates(p: &Polynomial2, t: f64) -> Polynomial2 {
    let z = Polynomial2::linear(-t, 1.0 / cosine(t), 0.0);
    p.terms().fold(Polynomial2::constant(0.0), |sum, (i, j, a)| {
        let power = (0..j).fold(Polynomial2::from_terms([(i, 0, a)]), |product, _| product.multiply(&z));
        sum.add(&power)
    })
}

/// Class {C, L, Q, K} of the polynomial `a` in (w, z) at direction t on the workpiece, t != t_K. Exact up to third degree; terms
/// of higher degree are ignored (callers split them off before).
pub fn decompose_quadratic(a: &Polynomial2, t: f64, t_k: f64, gauge: Gauge) -> QuadraticDecomposition {
    let (c, c_k) = (cosine(t), cosine(t_k));
    let (big_a, big_b) = (c_k * (t_k - t), c_k / c);
    let q = in_line_coordinates(a, t);
    let q = |i: usize, k: usize| q.coefficient(i, k);
    let k_20 = match gauge {
        Gauge::Centred { k_20, .. } | Gauge::Given { k_20, .. } => k_20,
    };
    let k_k3 = q(3, 0) / big_a.powi(3);
    let k_k2 = (q(2, 0) - k_20) / (big_a * big_a);
    let (k_10, k_k1, k_k0) = match gauge {
        Gauge::Centred { w_m, .. } => {
            let x = c_k * t_k * w_m;
            let k_k1 = -2.0 * k_k2 * x - 3.0 * k_k3 * x * x;
            (q(1, 0) - big_a * k_k1, k_k1, -((k_k3 * x + k_k2) * x + k_k1) * x)
        }
        Gauge::Given { k_10, k_k0, .. } => (k_10, (q(1, 0) - k_10) / big_a, k_k0),
    };
    QuadraticDecomposition {
        t,
        t_k,
        constant: [
            q(0, 0) - k_k0,
            q(0, 1) - big_b * k_k1,
            q(0, 2) - big_b * big_b * k_k2,
            q(0, 3) - big_b.powi(3) * k_k3,
        ],
        linear: [k_10, q(1, 1) - 2.0 * big_a * big_b * k_k2, q(1, 2) - 3.0 * big_a * big_b * big_b * k_k3],
        quadratic: [k_20, q(2, 1) - 3.0 * big_a * big_a * big_b * k_k3],
        kinematic: [k_k0, k_k1, k_k2, k_k3],
    }
}

/// p(w, z) h(X) for a polynomial p of second degree is exact in this class: `[F_C, F_L, F_Q]` at X for the value h of the line
/// function there (waviness with variable amplitude, `docs/mathematics/generating-contact.md#decomposition-of-a-target`).
pub fn product_functions(p: &Polynomial2, t: f64, x: f64, h: f64) -> [f64; 3] {
    let q = in_line_coordinates(p, t);
    [0, 1, 2].map(|i| h * (0..=2).rev().fold(0.0, |sum, k| sum * x + q.coefficient(i, k)))
}

/// Profile crowning that a worm without F_L and F_Q leaves besides a twist-free helix crowning `amount` (mm, transverse,
/// positive = removed) on the field of `lines`, mm.
pub fn constant_only_profile_crowning(lines: &FlankLines, amount: f64, t: f64) -> f64 {
    let aspect = (lines.roll[1] - lines.roll[0]) / (lines.face[1] - lines.face[0]);
    -amount * t * lines.t_k * aspect * aspect
}

impl QuadraticDecomposition {
    /// F_C(X) + F_L(X) w + F_Q(X) w^2 with derivatives in (w, z): what the worm carries.
    pub fn worm_jet(&self, w: f64, z: f64) -> Jet2 {
        let c = cosine(self.t);
        let x = c * (self.t * w + z);
        let line = |coefficients: &[f64]| Jet2::ridge(power_jet(coefficients, x), c * self.t, c);
        let roll = Jet2 { f: w, fu: 1.0, ..Jet2::default() };
        line(&self.constant) + (line(&self.linear) + line(&self.quadratic) * roll) * roll
    }

    /// F_K(X_K) at (w, z).
    pub fn kinematic_value(&self, w: f64, z: f64) -> f64 {
        power_jet(&self.kinematic, cosine(self.t_k) * (self.t_k * w + z))[0]
    }

    /// The sum of all parts at (w, z).
    pub fn value(&self, w: f64, z: f64) -> f64 {
        self.worm_jet(w, z).f + self.kinematic_value(w, z)
    }

    /// cos b2 F_K as coefficients of powers of z_V2: the normal amounts [`super::motion_of_flanks`] asks for, mm.
    pub fn normal_motion(&self, lines: &FlankLines) -> [f64; 4] {
        // X_K = c_K (C_c2 - z_V2).
        let c_k = cosine(self.t_k);
        let of_zeta = self.kinematic.iter().enumerate().map(|(k, f)| (k, 0, f * c_k.powi(k as i32)));
        let of_feed = Polynomial2::from_terms(of_zeta).shifted(lines.c_c2, 0.0);
        std::array::from_fn(|k| {
            let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
            lines.cos_b2 * sign * of_feed.coefficient(k, 0)
        })
    }
}

/// The modification of an ideal worm for a decomposition of this class: f_n1 = -cos b2 (F_C + F_L w + F_Q w^2) at the point that
/// (w_1, z_1) grinds, mm.
#[derive(Clone, Debug, PartialEq)]
pub struct QuadraticWorm {
    /// Numbers of the flank.
    pub lines: FlankLines,
    /// Tool shift z_V1 = K z_V2 + z_V01, K != 0.
    pub shift: MotionLaw,
    /// The parts.
    pub parts: QuadraticDecomposition,
}

impl ThreadFunction for QuadraticWorm {
    fn jet(&self, w_1: f64, z_1: f64) -> Option<Jet2> {
        let [w, z] = self.lines.work_point(w_1, z_1, &self.shift);
        Some(self.parts.worm_jet(w.f, z.f).of(w, z) * -self.lines.cos_b2)
    }
}
