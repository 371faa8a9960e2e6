//! Decomposition of a target polynomial into worm functions, profile and grinding motion
//! (`docs/mathematics/generating-contact.md#decomposition-of-a-target`): class {C, L, P, K} for dressed worms and class `radial` = {P, K}.
//!
//! All polynomials are in u = w - w_m, y = z - z_m, transverse, mm.

use foundation::numerics::{Jet2, Polynomial2};
use nalgebra::{Matrix4, Vector4};

/// f_t = F_C(X) + F_L(X) u + F_P(u + m y) + F_K(X_K) with X = c (t u + y), X_K = c_K (t_K u + y); gauge `centred`.
#[derive(Clone, Debug, PartialEq)]
pub struct Decomposition {
    /// tan(rho_2); 0 with `constant` and `linear` empty for the class `radial`.
    pub t: f64,
    /// t_K.
    pub t_k: f64,
    /// K_00 .. K_03: F_C.
    pub constant: [f64; 4],
    /// K_10 .. K_12: F_L.
    pub linear: [f64; 3],
    /// p_0, p_1, p_2, ...: F_P.
    pub profile: Vec<f64>,
    /// m of the profile lines u + m y = const: 0 on a cylindrical workpiece.
    pub profile_slope: f64,
    /// K_K0 .. K_K3: F_K.
    pub kinematic: [f64; 4],
}

fn cosine(t: f64) -> f64 {
    1.0 / t.hypot(1.0)
}

/// Value and two derivatives of sum c_k x^k.
pub(super) fn power_jet(coefficients: &[f64], x: f64) -> [f64; 3] {
    coefficients.iter().rev().fold([0.0; 3], |[f, f1, f2], &c| [f * x + c, f1 * x + f, f2 * x + 2.0 * f1])
}

/// Class {C, L, P, K} at direction t on the workpiece; `p_2` is the share of (u + m y)^2 that the profile carries, m
/// = `profile_slope`.
///
/// Exact for every polynomial of third degree plus, for m = 0, any pure powers of u; other terms are outside the class and
/// ignored here (callers split them off before).
pub fn decompose_diagonal(a: &Polynomial2, t: f64, t_k: f64, p_2: f64, profile_slope: f64) -> Decomposition {
    let (c, c_k, m) = (cosine(t), cosine(t_k), profile_slope);
    let at = |i: usize, j: usize| a.coefficient(i, j);
    let (a_20, a_11, a_02) = (at(2, 0) - p_2, at(1, 1) - 2.0 * m * p_2, at(0, 2) - m * m * p_2);
    let (big_a, big_b) = (c_k * (t_k - t), c_k / c);
    let q_20 = a_20 - t * a_11 + t * t * a_02;
    let q_11 = (a_11 - 2.0 * t * a_02) / c;
    let q_02 = a_02 / (c * c);
    let k_k2 = q_20 / (big_a * big_a);
    let [k_03, k_12, p_3, k_k3] = third_degree([at(3, 0), at(2, 1), at(1, 2), at(0, 3)], t, t_k, m);
    let mut profile = vec![0.0, 0.0, p_2, p_3];
    let highest = a.terms().filter(|term| term.1 == 0).map(|term| term.0).max().unwrap_or(0);
    profile.extend((4..=highest).map(|i| at(i, 0)));
    Decomposition {
        t,
        t_k,
        constant: [at(0, 0), at(0, 1) / c, q_02 - big_b * big_b * k_k2, k_03],
        linear: [at(1, 0) - t * at(0, 1), q_11 - 2.0 * big_a * big_b * k_k2, k_12],
        profile,
        profile_slope: m,
        kinematic: [0.0, 0.0, k_k2, k_k3],
    }
}

/// K_03, K_12, p_3, K_K3 from the terms u^3, u^2 y, u y^2, y^3: in closed form for m = 0, else from the four equations.
fn third_degree([a_30, a_21, a_12, a_03]: [f64; 4], t: f64, t_k: f64, m: f64) -> [f64; 4] {
    let (c, c_k) = (cosine(t), cosine(t_k));
    if m == 0.0 {
        let (big_a, big_b) = (c_k * (t_k - t), c_k / c);
        let q_30 = a_30 - t * a_21 + t * t * a_12 - t.powi(3) * a_03;
        let q_21 = (a_21 - 2.0 * t * a_12 + 3.0 * t * t * a_03) / c;
        let k_k3 = q_21 / (3.0 * big_a * big_a * big_b);
        return [
            a_03 / c.powi(3) - big_b.powi(3) * k_k3,
            (a_12 - 3.0 * t * a_03) / (c * c) - 3.0 * big_a * big_b * big_b * k_k3,
            q_30 - big_a.powi(3) * k_k3,
            k_k3,
        ];
    }
    if [a_30, a_21, a_12, a_03] == [0.0; 4] {
        return [0.0; 4];
    }
    let cube = |t: f64, c: f64| Vector4::new(t.powi(3), 3.0 * t * t, 3.0 * t, 1.0) * c.powi(3);
    let matrix = Matrix4::from_columns(&[
        cube(t, c),
        Vector4::new(t * t, 2.0 * t, 1.0, 0.0) * (c * c),
        Vector4::new(1.0, 3.0 * m, 3.0 * m * m, m.powi(3)),
        cube(t_k, c_k),
    ]);
    // Singular only where two of the four directions coincide, which callers exclude.
    let solved = matrix.lu().solve(&Vector4::new(a_30, a_21, a_12, a_03));
    solved.map_or([f64::NAN; 4], |x| [x[0], x[1], x[2], x[3]])
}

/// Class `radial` (K = 0): {P, K} with every F_K that the terms pure in y ask for and the profile that completes the terms
/// pure in u.
pub fn decompose_radial(a: &Polynomial2, t_k: f64) -> Decomposition {
    let c_k = cosine(t_k);
    let at = |i: usize, j: usize| a.coefficient(i, j);
    let kinematic: [f64; 4] = std::array::from_fn(|k| at(0, k) / c_k.powi(k as i32));
    let highest = a.terms().filter(|term| term.1 == 0).map(|term| term.0).max().unwrap_or(0).max(3);
    let profile = (0..=highest)
        .map(|i| match i {
            0 => 0.0,
            1..=3 => at(i, 0) - kinematic[i] * (c_k * t_k).powi(i as i32),
            _ => at(i, 0),
        })
        .collect();
    Decomposition { profile, kinematic, ..Decomposition::nothing(t_k) }
}

/// Mixed terms that the class `radial` cannot make: `[r_11, r_21, r_12]`.
pub fn radial_residual(a: &Polynomial2, t_k: f64) -> [f64; 3] {
    let at = |i: usize, j: usize| a.coefficient(i, j);
    [at(1, 1) - 2.0 * t_k * at(0, 2), at(2, 1) - 3.0 * t_k * t_k * at(0, 3), at(1, 2) - 3.0 * t_k * at(0, 3)]
}

impl Decomposition {
    /// All parts zero.
    pub fn nothing(t_k: f64) -> Self {
        Self {
            t: 0.0,
            t_k,
            constant: [0.0; 4],
            linear: [0.0; 3],
            profile: Vec::new(),
            profile_slope: 0.0,
            kinematic: [0.0; 4],
        }
    }

    /// The same sum with K_10 and K_K0 as given, in the centred variables (gauge `given` of
    /// `docs/mathematics/generating-contact.md#decomposition-of-a-target`): a linear part of the motion takes what F_L and F_C give up.
    pub fn with_gauge(mut self, k_10: f64, k_k0: f64) -> Self {
        let (c, c_k) = (cosine(self.t), cosine(self.t_k));
        let (big_a, big_b) = (c_k * (self.t_k - self.t), c_k / c);
        let k_k1 = (self.linear[0] - k_10) / big_a;
        self.linear[0] = k_10;
        self.constant[1] -= big_b * k_k1;
        self.constant[0] -= k_k0;
        self.kinematic[0] += k_k0;
        self.kinematic[1] += k_k1;
        self
    }

    /// F_C(X) + F_L(X) u with derivatives in (u, y): what the dressing motion carries.
    pub fn dressing_jet(&self, u: f64, y: f64) -> Jet2 {
        let c = cosine(self.t);
        let x = c * (self.t * u + y);
        let constant = Jet2::ridge(power_jet(&self.constant, x), c * self.t, c);
        let linear = Jet2::ridge(power_jet(&self.linear, x), c * self.t, c);
        constant + linear * Jet2 { f: u, fu: 1.0, ..Jet2::default() }
    }

    /// F_P with two derivatives by its argument u + m y.
    pub fn profile_jet(&self, u: f64) -> [f64; 3] {
        power_jet(&self.profile, u)
    }

    /// F_K(X_K).
    pub fn kinematic_value(&self, x_k: f64) -> f64 {
        power_jet(&self.kinematic, x_k)[0]
    }

    /// X_K at (u, y).
    pub fn path_coordinate(&self, u: f64, y: f64) -> f64 {
        cosine(self.t_k) * (self.t_k * u + y)
    }

    /// The sum of all parts at (u, y).
    pub fn value(&self, u: f64, y: f64) -> f64 {
        self.dressing_jet(u, y).f
            + self.profile_jet(u + self.profile_slope * y)[0]
            + self.kinematic_value(self.path_coordinate(u, y))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sample() -> Polynomial2 {
        Polynomial2::from_terms([
            (0, 0, 0.4),
            (0, 1, -0.05),
            (0, 2, -0.044),
            (0, 3, -3e-4),
            (1, 0, 0.2),
            (1, 1, 9e-3),
            (1, 2, 8e-4),
            (2, 0, -0.098),
            (2, 1, -1.5e-3),
            (3, 0, 2e-3),
            (4, 0, 1e-4),
            (5, 0, -2e-6),
        ])
    }

    #[test]
    fn the_parts_add_up_to_the_target() {
        let a = sample();
        for p_2 in [a.coefficient(2, 0), 0.0] {
            let d = decompose_diagonal(&a, 1.3, -0.65, p_2, 0.0);
            for (u, y) in [(-9.0, -20.0), (3.0, 7.0), (9.0, 20.0), (0.0, 0.0)] {
                assert!((d.value(u, y) - a.value(u, y)).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn another_gauge_leaves_the_sum() {
        let a = sample();
        let d = decompose_diagonal(&a, 1.3, -0.65, 0.0, 0.0).with_gauge(0.3, -0.2);
        assert!((d.linear[0] - 0.3).abs() < 1e-15 && (d.kinematic[0] + 0.2).abs() < 1e-15);
        for (u, y) in [(-9.0, -20.0), (3.0, 7.0), (0.0, 0.0)] {
            assert!((d.value(u, y) - a.value(u, y)).abs() < 1e-12);
        }
    }

    #[test]
    fn lines_of_equal_rack_height_carry_the_profile_of_a_cone() {
        let a = Polynomial2::from_terms(sample().terms().filter(|&(i, j, _)| i + j <= 3));
        for p_2 in [a.coefficient(2, 0), 0.0] {
            let d = decompose_diagonal(&a, 1.3, -0.65, p_2, 0.09);
            for (u, y) in [(-9.0, -20.0), (3.0, 7.0), (9.0, 20.0), (0.0, 0.0)] {
                assert!((d.value(u, y) - a.value(u, y)).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn radial_leaves_exactly_the_mixed_residual() {
        let a = sample();
        let t_k = 0.34;
        let d = decompose_radial(&a, t_k);
        let [r11, r21, r12] = radial_residual(&a, t_k);
        for (u, y) in [(-6.0, 12.0), (5.0, -3.0)] {
            let left = a.value(u, y) - d.value(u, y);
            assert!((left - (r11 * u * y + r21 * u * u * y + r12 * u * y * y)).abs() < 1e-12);
        }
    }
}
