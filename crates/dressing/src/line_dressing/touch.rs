//! Where the disc stands when its rounded tip touches the worm in a given point, and how closely it fits there
//! (`docs/mathematics/dressing.md#conditions`). Knows one point of the worm, no line.

use super::TipDisc;
use contact::SurfaceJet;
use foundation::kinematics::DressingPosition;
use nalgebra::{Matrix2, Vector2, Vector3};

/// The disc in touch with a point of the worm flank.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Touch {
    /// Dressing position: gamma and v_y as given; phi_S, d and v_zS follow.
    pub position: DressingPosition,
    /// Centre of the disc, worm coordinates, mm.
    pub centre: Vector3<f64>,
    /// Axis of the disc, worm coordinates.
    pub axis: Vector3<f64>,
    /// Radial part n_r of the disc's outward normal at the contact: 1 at the rim, 0 at the side.
    pub radial: f64,
    /// Tangent of the disc's profile at the contact, unit vector in worm coordinates.
    pub across: Vector3<f64>,
    /// Tangent of the disc's circle at the contact, unit vector in worm coordinates.
    pub around: Vector3<f64>,
}

/// Newton settles in four to six steps from the angle at which the contact faces the disc.
const ROUNDS: usize = 40;
/// Largest step, rad.
const STEP: f64 = 0.3;

impl TipDisc {
    /// The disc that touches the worm at `point` with outward unit normal `normal`, at crossing angle gamma (rad) and offset
    /// v_y (mm). `near` (rad) tells the turn of phi_S. `None` where the disc cannot stand so.
    ///
    /// The centre of the tip rounding is C = P + r_T N. With C and N turned by phi_S into the room, e the radial direction of
    /// the disc at the contact, the centre of the disc is C - R e, R = r_aA - r_T; that it lies at the offset v_y asks
    /// C_y/cos(gamma) - R e_2 + v_y = 0, the one equation for phi_S.
    pub fn touch(
        &self,
        point: &Vector3<f64>,
        normal: &Vector3<f64>,
        crossing_angle: f64,
        offset: f64,
        near: f64,
    ) -> Option<Touch> {
        let (sin_g, cos_g) = crossing_angle.sin_cos();
        let c = point + normal * self.tip_radius();
        let radius = self.centre_radius();
        let mut phi = -c.y.atan2(c.x);
        let mut settled = false;
        for _ in 0..ROUNDS {
            let (sin, cos) = phi.sin_cos();
            let (c_x, c_y) = (cos * c.x - sin * c.y, sin * c.x + cos * c.y);
            let (n_x, n_y) = (cos * normal.x - sin * normal.y, sin * normal.x + cos * normal.y);
            let q = n_y * cos_g - normal.z * sin_g;
            let radial = n_x.hypot(q);
            let (q_phi, radial_phi) = (n_x * cos_g, (-n_x * n_y + q * n_x * cos_g) / radial);
            let miss = c_y / cos_g + radius * q / radial + offset;
            let slope = c_x / cos_g + radius * (q_phi * radial - q * radial_phi) / (radial * radial);
            let step = miss / slope;
            if !step.is_finite() {
                return None;
            }
            phi -= step.clamp(-STEP, STEP);
            if settled {
                break;
            }
            // One more step after the tolerance is met brings the root to rounding.
            settled = step.abs() < 1e-10;
        }
        if !settled {
            return None;
        }
        let (sin, cos) = phi.sin_cos();
        let room = |v: &Vector3<f64>| Vector3::new(cos * v.x - sin * v.y, sin * v.x + cos * v.y, v.z);
        let worm = |v: &Vector3<f64>| Vector3::new(cos * v.x + sin * v.y, -sin * v.x + cos * v.y, v.z);
        let (c_r, n) = (room(&c), room(normal));
        let axis = Vector3::new(0.0, sin_g, cos_g);
        let inward = n - axis * n.dot(&axis);
        let radial = inward.norm();
        let e = -inward / radial;
        // The disc stands beside the worm at +x and touches it with the half that faces it.
        if e.x >= 0.0 || c_r.x <= 0.0 || radial.is_nan() || radial <= 0.0 {
            return None;
        }
        let turn = std::f64::consts::TAU;
        let position = DressingPosition {
            worm_angle: phi - turn * ((phi - near) / turn).round(),
            worm_shift: -c_r.z - c_r.y * sin_g / cos_g,
            crossing_angle,
            centre_distance: c_r.x - radius * e.x,
            offset,
        };
        let own = -n;
        let n_z = own.dot(&axis);
        Some(Touch {
            position,
            centre: worm(&(c_r - e * radius)),
            axis: worm(&axis),
            radial,
            across: worm(&(axis * radial - e * n_z)),
            around: worm(&axis.cross(&e)),
        })
    }
}

/// Gap of disc and worm to second order over the flank coordinates (dw, dz): gap = 1/2 (dw, dz) q (dw, dz)^T, 1/mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RelativeForm {
    /// The form; positive definite where the disc touches in a point and cuts nothing beside it.
    pub q: Matrix2<f64>,
    /// What worm and circle of the disc give without the rounding of the tip, and the direction in which that bends.
    rest: Matrix2<f64>,
    across: Vector2<f64>,
}

impl RelativeForm {
    /// Of a worm surface over (w, z) and the disc that touches it.
    pub fn new(jet: &SurfaceJet, disc: &TipDisc, touch: &Touch) -> Self {
        let (length, p, n) = (jet.n.norm(), [jet.p_p, jet.p_q], [jet.n_p, jet.n_q]);
        let worm = Matrix2::from_fn(|i, j| 0.5 * (n[i].dot(&p[j]) + n[j].dot(&p[i])) / length);
        let along = |v: &Vector3<f64>| Vector2::new(p[0].dot(v), p[1].dot(v));
        let (across, around) = (along(&touch.across), along(&touch.around));
        let circle = touch.radial / (disc.centre_radius() + disc.tip_radius() * touch.radial);
        let rest = worm + around * around.transpose() * circle;
        Self { q: rest + across * across.transpose() / disc.tip_radius(), rest, across }
    }

    /// Whether the disc touches in a point only.
    pub fn is_point_contact(&self) -> bool {
        self.q[(0, 0)] > 0.0 && self.q.determinant() > 0.0
    }

    /// The largest tip radius with which the disc would touch in a point only, mm; infinite where any would do, 0 where none.
    pub fn largest_tip_radius(&self) -> f64 {
        let det = self.rest.determinant();
        if det > 0.0 {
            return if self.rest[(0, 0)] > 0.0 { f64::INFINITY } else { 0.0 };
        }
        // det(rest + u u^T/r) = det(rest) + u^T adj(rest) u/r
        let adjoint =
            Matrix2::new(self.rest[(1, 1)], -self.rest[(0, 1)], -self.rest[(1, 0)], self.rest[(0, 0)]);
        let gained = self.across.dot(&(adjoint * self.across));
        if gained > 0.0 { gained / -det } else { 0.0 }
    }

    /// `[H_tt, H_tX, H_XX]` over the parameter t along lines of direction rho (rad) and the coordinate X across them.
    pub fn along_lines(&self, rho: f64) -> [f64; 3] {
        let (sin, cos) = rho.sin_cos();
        let (t, x) = (Vector2::new(cos, -sin), Vector2::new(sin, cos));
        [t.dot(&(self.q * t)), t.dot(&(self.q * x)), x.dot(&(self.q * x))]
    }

    /// Relative normal curvature across lines of direction rho (rad), per square of the spacing in X, 1/mm: lines at pitch p_X
    /// leave scallops of p_X^2/8 times this.
    pub fn curvature_across(&self, rho: f64) -> f64 {
        let [tt, tx, xx] = self.along_lines(rho);
        xx - tx * tx / tt
    }
}
