//! Relative curvature of worm and workpiece at a contact: second-order estimates of what the envelope leaves
//! (`docs/mathematics/generating-contact.md#what-the-grinding-motion-leaves-to-first-order`,
//! `docs/mathematics/generating-contact.md#exact-contact`). Start values and step errors only; the product's forward model is `exact`.

use super::FlankPair;
use nalgebra::{Matrix2, Vector2, Vector3};

/// Steps of the place of a displaced contact: each multiplies its error by the curvature of the modification over that of the gap.
const DISPLACEMENTS: usize = 6;

/// Quadratic form of the gap of worm and workpiece over the two contact parameters (dw_2, dz_V2), at one contact point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RelativeCurvature {
    /// H of `docs/mathematics/generating-contact.md#what-the-grinding-motion-leaves-to-first-order`: parameters dw_2 (mm) and dz_V2 (mm).
    pub h: Matrix2<f64>,
    u: [Vector3<f64>; 2],
    e_r1: Vector3<f64>,
    g_1: Vector3<f64>,
    dw_1: [f64; 2],
    dz_1: [f64; 2],
    worm: [f64; 3],
}

impl FlankPair {
    /// Straight generatrices g_1 of the worm and g_2 of the workpiece at the contact, unit vectors in the room frame; with
    /// e_r1 and e_r2 they span the common tangent plane
    /// (`docs/mathematics/generating-contact.md#what-the-grinding-motion-leaves-to-first-order`).
    pub fn generatrices(&self) -> [Vector3<f64>; 2] {
        let s = self.flank().sign();
        let along = |normal: Vector3<f64>, axis: &Vector3<f64>, b: f64| {
            let e_t = (normal + axis * (s * b.sin())) / b.cos();
            e_t * (s * b.sin()) + axis * b.cos()
        };
        [
            along(self.normal, &self.a_1, self.worm.base_helix_angle),
            along(-self.normal, &self.a_2, self.work.base_helix_angle),
        ]
    }

    /// Relative curvature where worm roll `w_1` touches workpiece roll `w_2`, at local diagonal ratio `ratio`.
    pub fn relative_curvature(&self, w_1: f64, w_2: f64, ratio: f64) -> RelativeCurvature {
        let s = self.flank().sign();
        let (b_1, b_2) = (self.worm.base_helix_angle, self.work.base_helix_angle);
        let [g_1, g_2] = self.generatrices();
        let step = |dw: f64, dz: f64| {
            self.e_r2 * (w_2 / self.work.base_radius * (dw - s * b_2.tan() * dz)) + g_2 * (dz / b_2.cos())
        };
        let g_2f = self.c_zv22 + ratio * self.c_zv12;
        let u = [step(1.0, self.c_w2), step(0.0, g_2f)];
        let form = |a: &Vector3<f64>, b: &Vector3<f64>| {
            b_1.cos() / w_1 * a.dot(&self.e_r1) * b.dot(&self.e_r1)
                + b_2.cos() / w_2 * a.dot(&self.e_r2) * b.dot(&self.e_r2)
        };
        let g_1f = self.c_zv11 * ratio + self.c_zv21;
        let g_h = self.hat_zv1 * ratio + self.hat_zv2;
        let dw_1 = [-self.hat_w2 / self.hat_w1, -g_h / self.hat_w1];
        let dz_1 = [self.c_w1 * dw_1[0], self.c_w1 * dw_1[1] + g_1f];
        RelativeCurvature {
            h: Matrix2::from_fn(|i, j| form(&u[i], &u[j])),
            u,
            e_r1: self.e_r1,
            g_1,
            dw_1,
            dz_1,
            worm: [self.worm.base_radius / w_1, b_1.cos(), s * b_1.tan()],
        }
    }
}

impl RelativeCurvature {
    /// -(1/2) c^T H^-1 c: how much deeper than first order a worm modification with slopes (f_w, f_z) digs, mm (<= 0).
    pub fn second_order(&self, f_w: f64, f_z: f64) -> f64 {
        let across = self.across_worm([f_w, f_z]);
        let c = Vector2::from_fn(|i, _| f_w * self.dw_1[i] + f_z * self.dz_1[i] - across[i]);
        match self.h.try_inverse() {
            Some(inverse) => -0.5 * c.dot(&(inverse * c)),
            None => f64::NEG_INFINITY,
        }
    }

    /// How a function on the worm with slopes (f_w, f_z) changes when a place of the workpiece moves by dw_2 or dz_V2 below the worm at rest.
    fn across_worm(&self, [f_w, f_z]: [f64; 2]) -> Vector2<f64> {
        Vector2::from_fn(|i, _| {
            let [by_w, by_z] = self.worm_step(&self.u[i]);
            f_w * by_w + f_z * by_z
        })
    }

    /// (dw_1, dz_1) of a step in the common tangent plane, on the worm at rest.
    fn worm_step(&self, step: &Vector3<f64>) -> [f64; 2] {
        let [rolled, cos, tan] = self.worm;
        let along = cos * step.dot(&self.g_1);
        [rolled * step.dot(&self.e_r1) + tan * along, along]
    }

    /// Where the worm stands opposite a place of the workpiece that is held: columns (dw_1, dz_1) by dw_2 and by dz_V2 of the displacement of
    /// the contact.
    pub fn worm_moves(&self) -> Matrix2<f64> {
        let steps = [self.worm_step(&self.u[0]), self.worm_step(&self.u[1])];
        Matrix2::from_fn(|i, k| if i == 0 { self.dw_1[k] - steps[k][0] } else { self.dz_1[k] - steps[k][1] })
    }

    /// Where a place of the workpiece is really ground, as (dw_2, dz_V2) from its contact of unmodified bodies, when the flank that is left
    /// has the slopes `ground` by these parameters: H d = -(df_1/dx + grad f), from f(x) = min over d of -f_1(y(x, d)) + m(x + d) + d.H.d/2 with
    /// f_1 of the worm at the place y opposite of x (what stands on the worm is missing on the flank) and what the motion adds, m. `worm` gives (f_w, f_z) of f_1 at (dw_1, dz_1) from the contact's place
    /// on the worm. `None` where H has no inverse.
    pub fn displaced(&self, ground: [f64; 2], worm: impl Fn([f64; 2]) -> [f64; 2]) -> Option<[f64; 2]> {
        let inverse = self.h.try_inverse()?;
        let ground = Vector2::from(ground);
        let mut at = Vector2::zeros();
        for _ in 0..DISPLACEMENTS {
            let step = self.u[0] * at.x + self.u[1] * at.y;
            let [by_w, by_z] = self.worm_step(&step);
            let moved = |d: [f64; 2]| d[0] * at.x + d[1] * at.y;
            let slopes = worm([moved(self.dw_1) - by_w, moved(self.dz_1) - by_z]);
            at = -(inverse * (self.across_worm(slopes) + ground));
        }
        Some(at.into())
    }

    /// Curvature along the feed of the gap that one passage of the worm leaves, 1/mm.
    pub fn gap_along_feed(&self) -> f64 {
        self.h[(1, 1)] - self.h[(0, 1)].powi(2) / self.h[(0, 0)]
    }

    /// Height of the feed marks at feed step `f`, mm (`docs/mathematics/planning.md#the-referee`).
    pub fn feed_mark(&self, f: f64) -> f64 {
        f * f / 8.0 * self.gap_along_feed()
    }

    /// Height of the generating facets at roll step `dw_2`, mm.
    pub fn facet(&self, dw_2: f64) -> f64 {
        dw_2 * dw_2 / 8.0 * (self.h[(0, 0)] - self.h[(0, 1)].powi(2) / self.h[(1, 1)])
    }
}
