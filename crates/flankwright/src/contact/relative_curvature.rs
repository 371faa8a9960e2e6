//! Relative curvature of worm and workpiece at a contact: second-order estimates of what the envelope leaves
//! (spec 20 section 7, spec 25 section 6). Start values and step errors only; the product's forward model is `exact`.

use super::FlankPair;
use nalgebra::{Matrix2, Vector2, Vector3};

/// Quadratic form of the gap of worm and workpiece over the two contact parameters (dw_2, dz_V2), at one contact point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RelativeCurvature {
    /// H of spec 20 section 7: parameters dw_2 (mm) and dz_V2 (mm).
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
    /// e_r1 and e_r2 they span the common tangent plane (spec 20 section 7).
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
        let [rolled, cos, tan] = self.worm;
        let slope = self.e_r1 * (rolled * f_w) + self.g_1 * (cos * (f_z + tan * f_w));
        let c = Vector2::from_fn(|i, _| f_w * self.dw_1[i] + f_z * self.dz_1[i] - slope.dot(&self.u[i]));
        match self.h.try_inverse() {
            Some(inverse) => -0.5 * c.dot(&(inverse * c)),
            None => f64::NEG_INFINITY,
        }
    }

    /// Height of the feed marks at feed step `f`, mm (spec 20 section 9).
    pub fn feed_mark(&self, f: f64) -> f64 {
        f * f / 8.0 * (self.h[(1, 1)] - self.h[(0, 1)].powi(2) / self.h[(0, 0)])
    }

    /// Height of the generating facets at roll step `dw_2`, mm.
    pub fn facet(&self, dw_2: f64) -> f64 {
        dw_2 * dw_2 / 8.0 * (self.h[(0, 0)] - self.h[(0, 1)].powi(2) / self.h[(1, 1)])
    }
}
