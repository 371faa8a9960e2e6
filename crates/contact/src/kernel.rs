//! The four contact equations of `docs/mathematics/generating-contact.md#exact-contact` and their exact Jacobian, for any tool surface and
//! motion.
//!
//! Unknowns y = (p, q, phi_1, v): two surface parameters, worm angle, feed. The tool point is carried to the workpiece;
//! two equations put it on the normal ray (or the arc) of the workpiece point, two say that both velocities are tangent.

use super::SurfaceJet;
use foundation::geometry::InvoluteFlank;
use foundation::kinematics::GeneratingMotion;
use nalgebra::{Matrix3, Matrix4, Vector3, Vector4};

/// How the deviation of the ground flank is measured at a workpiece point.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Measure {
    /// Along the nominal normal (default everywhere).
    #[default]
    Ray,
    /// On the circle through the point in its transverse section (as in the source of `docs/mathematics/tangential-dressing.md`).
    Arc,
}

/// A workpiece point with its directions.
#[derive(Clone, Copy, Debug)]
pub(super) struct Target {
    pub point: Vector3<f64>,
    pub e_r: Vector3<f64>,
    pub g: Vector3<f64>,
    pub n: Vector3<f64>,
    pub z: f64,
    pub radius: f64,
}

impl Target {
    pub fn new(flank: &InvoluteFlank, w: f64, z: f64) -> Self {
        let frame = flank.frame(w, z);
        Self {
            point: flank.point_in(&frame, w, z),
            e_r: frame.e_r,
            g: frame.g,
            n: frame.n,
            z,
            radius: flank.radius(w),
        }
    }
}

/// Motion laws at one feed.
#[derive(Clone, Copy, Debug)]
struct Laws {
    shift: [f64; 3],
    d: [f64; 3],
    phi: [f64; 3],
    gamma: [f64; 3],
}

/// Equations, Jacobian and the carried point at one y.
#[derive(Clone, Copy, Debug)]
pub(super) struct Evaluation {
    pub residual: Vector4<f64>,
    pub jacobian: Matrix4<f64>,
    /// Tool point and normal in workpiece coordinates.
    pub q_2: Vector3<f64>,
    pub n_q: Vector3<f64>,
    /// Derivatives of the tool point by y.
    pub q_x: [Vector3<f64>; 4],
    /// phi_2.
    pub work_angle: f64,
    /// gamma + Delta_gamma.
    pub gamma: f64,
    /// Lever of a change of gamma: u + v e_z in the rest frame (with brackets inserted).
    pub gamma_lever: Vector3<f64>,
}

/// A motion with the constants of its chain worked out, and the phase of one flank.
#[derive(Clone, Debug)]
pub(super) struct Kernel<'a> {
    pub motion: &'a GeneratingMotion,
    pub phase: f64,
    worm_tilt: Matrix3<f64>,
    work_tilt: Matrix3<f64>,
    /// Neither body is a cone.
    pub straight: bool,
    /// Ry(-gamma) while gamma stands still.
    back: Option<Matrix3<f64>>,
}

fn rot_x(a: f64) -> Matrix3<f64> {
    let (s, c) = a.sin_cos();
    Matrix3::new(1.0, 0.0, 0.0, 0.0, c, -s, 0.0, s, c)
}

fn rot_y(a: f64) -> Matrix3<f64> {
    let (s, c) = a.sin_cos();
    Matrix3::new(c, 0.0, s, 0.0, 1.0, 0.0, -s, 0.0, c)
}

/// Rz(angle) v.
pub(super) fn turned_z((s, c): (f64, f64), v: &Vector3<f64>) -> Vector3<f64> {
    Vector3::new(c * v.x - s * v.y, s * v.x + c * v.y, v.z)
}

/// e_z x v.
pub(super) fn about_z(v: &Vector3<f64>) -> Vector3<f64> {
    Vector3::new(-v.y, v.x, 0.0)
}

impl<'a> Kernel<'a> {
    pub fn new(motion: &'a GeneratingMotion, phase: f64) -> Self {
        let chain = &motion.chain;
        let still = motion.delta_gamma.is_constant();
        Self {
            motion,
            phase,
            back: still.then(|| rot_y(-chain.crossed_axes_angle - motion.delta_gamma.value(0.0))),
            worm_tilt: rot_x(-chain.worm_cone),
            work_tilt: rot_x(chain.work_cone),
            straight: chain.worm_cone == 0.0 && chain.work_cone == 0.0,
        }
    }

    pub fn evaluate(
        &self,
        surface: &SurfaceJet,
        phi_1: f64,
        v: f64,
        target: &Target,
        measure: Measure,
    ) -> Evaluation {
        let motion = self.motion;
        let chain = &motion.chain;
        let laws = Laws {
            shift: motion.shift.jet(v),
            d: motion.delta_d.jet(v),
            phi: motion.delta_phi_2.jet(v),
            gamma: motion.delta_gamma.jet(v),
        };
        let gamma = chain.crossed_axes_angle + laws.gamma[0];
        let back = self.back.unwrap_or_else(|| rot_y(-gamma));
        // `frame` turns from the room to the workpiece's rest frame, `carry` from the worm's rest frame.
        let (frame, carry) = if self.straight {
            (back, back)
        } else {
            (self.work_tilt * back, self.work_tilt * back * self.worm_tilt)
        };
        let (a_y, a_z) = (self.work_tilt.column(1).into_owned(), self.work_tilt.column(2).into_owned());
        let turn = phi_1.sin_cos();
        let spin = |x: &Vector3<f64>| carry * turned_z(turn, x);
        let worm_point = turned_z(turn, &surface.p);
        let mut lifted = worm_point;
        lifted.y -= chain.worm_pivot;
        let shifted = |f: f64, d: f64| Vector3::new(0.0, -d, f);
        let from_worm = carry * lifted + frame * shifted(laws.shift[0], chain.centre_distance + laws.d[0]);
        let mut u = from_worm - a_z * v;
        u.y += chain.work_pivot;
        let nu = spin(&surface.n);
        let worm_normal = turned_z(turn, &surface.n);

        let u_phi = carry * about_z(&worm_point);
        let feed = frame * shifted(laws.shift[1], laws.d[1]);
        let (g1, g2) = (laws.gamma[1], laws.gamma[2]);
        let swing = |x: &Vector3<f64>| a_y.cross(x);
        let u_v = feed - a_z - swing(&from_worm) * g1;
        let ratio = motion.threads / motion.teeth;
        let kappa =
            (motion.shift_coupling * laws.shift[1] + motion.feed_coupling) / motion.teeth + laws.phi[1];
        let kappa_v = motion.shift_coupling * laws.shift[2] / motion.teeth + laws.phi[2];
        let around = about_z(&u);
        let c_2 = nu.dot(&around);
        let f_phi = nu.dot(&u_phi) + ratio * c_2;
        let f_v = nu.dot(&u_v) - kappa * c_2;

        let u_x = [spin(&surface.p_p), spin(&surface.p_q), u_phi, u_v];
        let nu_x = [spin(&surface.n_p), spin(&surface.n_q), carry * about_z(&worm_normal), swing(&nu) * -g1];
        let curl = about_z(&about_z(&worm_point));
        let u_phi_x = [
            carry * about_z(&turned_z(turn, &surface.p_p)),
            carry * about_z(&turned_z(turn, &surface.p_q)),
            carry * curl,
            swing(&u_phi) * -g1,
        ];
        let mut u_v_x = [Vector3::zeros(); 4];
        if g1 != 0.0 || g2 != 0.0 {
            for k in 0..3 {
                u_v_x[k] = swing(&u_x[k]) * -g1;
            }
            let from_worm_v = feed - swing(&from_worm) * g1;
            u_v_x[3] = -(swing(&feed) + swing(&from_worm_v)) * g1 - swing(&from_worm) * g2;
        }
        u_v_x[3] += frame * shifted(laws.shift[2], laws.d[2]);

        let work_angle = (self.phase - motion.threads * phi_1
            + motion.shift_coupling * laws.shift[0]
            + motion.feed_coupling * v)
            / motion.teeth
            + laws.phi[0];
        let unturn = (-work_angle).sin_cos();
        let q_2 = turned_z(unturn, &u);
        let n_q = turned_z(unturn, &nu);
        let angle_x = [0.0, 0.0, -ratio, kappa];
        let q_around = about_z(&q_2);
        let q_x: [Vector3<f64>; 4] =
            std::array::from_fn(|k| turned_z(unturn, &u_x[k]) - q_around * angle_x[k]);

        let mut residual = Vector4::new(0.0, 0.0, f_phi, f_v);
        let mut jacobian = Matrix4::zeros();
        match measure {
            Measure::Ray => {
                let apart = q_2 - target.point;
                residual[0] = apart.dot(&target.e_r);
                residual[1] = apart.dot(&target.g);
                for k in 0..4 {
                    jacobian[(0, k)] = q_x[k].dot(&target.e_r);
                    jacobian[(1, k)] = q_x[k].dot(&target.g);
                }
            }
            Measure::Arc => {
                let radius = q_2.x.hypot(q_2.y);
                residual[0] = radius - target.radius;
                residual[1] = q_2.z - target.z;
                for k in 0..4 {
                    jacobian[(0, k)] = (q_2.x * q_x[k].x + q_2.y * q_x[k].y) / radius;
                    jacobian[(1, k)] = q_x[k].z;
                }
            }
        }
        for k in 0..4 {
            let c_2x = nu_x[k].dot(&around) + nu.dot(&about_z(&u_x[k]));
            jacobian[(2, k)] = nu_x[k].dot(&u_phi) + nu.dot(&u_phi_x[k]) + ratio * c_2x;
            jacobian[(3, k)] = nu_x[k].dot(&u_v) + nu.dot(&u_v_x[k]) - kappa * c_2x;
        }
        jacobian[(3, 3)] -= kappa_v * c_2;
        Evaluation { residual, jacobian, q_2, n_q, q_x, work_angle, gamma, gamma_lever: from_worm }
    }

    /// Direction from the room frame into workpiece coordinates at the given angles.
    pub fn room_to_work(&self, gamma: f64, work_angle: f64, v: &Vector3<f64>) -> Vector3<f64> {
        turned_z((-work_angle).sin_cos(), &(self.work_tilt * rot_y(-gamma) * v))
    }

    /// Direction about which the workpiece bracket turns when gamma changes, in workpiece coordinates.
    pub fn swing_axis(&self, work_angle: f64) -> Vector3<f64> {
        turned_z((-work_angle).sin_cos(), &self.work_tilt.column(1).into_owned())
    }
}
