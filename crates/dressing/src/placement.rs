//! Where the dresser stands against the worm axis, in either chart of the dressing kinematics, and the contact of one of its
//! circles there, exactly and in closed form (`docs/mathematics/dressing.md`). Knows no profile and no worm flank.

use foundation::geometry::MeridianPoint;
use foundation::numerics::{Scalar, value_of};
use nalgebra::Vector3;

/// Frame of the dresser in the room: the worm axis is z, the worm at v_zS = 0.
#[derive(Clone, Copy, Debug)]
pub struct DresserAxes<T: Scalar> {
    /// Centre of the dresser.
    pub centre: Vector3<T>,
    /// Its axis.
    pub axis: Vector3<T>,
    /// Across it; e1 x e2 = axis.
    pub e1: Vector3<T>,
    /// Second unit vector across the axis.
    pub e2: Vector3<T>,
}

impl<T: Scalar> DresserAxes<T> {
    /// From crossing angle, centre distance and offset.
    pub fn kinematic(gamma: T, d: T, v_y: T) -> Self {
        let (sin, cos) = gamma.sin_cos();
        let (zero, one) = (T::from(0.0), T::from(1.0));
        Self {
            centre: Vector3::new(d, -v_y * cos, v_y * sin),
            axis: Vector3::new(zero, sin, cos),
            e1: Vector3::new(one, zero, zero),
            e2: Vector3::new(zero, cos, -sin),
        }
    }

    /// From the tilt chart (`docs/mathematics/dressing.md#limits-of-a-correction`).
    pub fn tilted(gamma: T, d: T, tau: T) -> Self {
        let (sin, cos) = gamma.sin_cos();
        let (sin_t, cos_t) = tau.sin_cos();
        let zero = T::from(0.0);
        Self {
            centre: Vector3::new(d, zero, zero),
            axis: Vector3::new(sin_t, cos_t * sin, cos_t * cos),
            e1: Vector3::new(cos_t, -sin_t * sin, -sin_t * cos),
            e2: Vector3::new(zero, cos, -sin),
        }
    }
}

/// Motion of the worm against the dresser, per radian of worm rotation.
#[derive(Clone, Copy, Debug)]
pub struct WormScrew<T: Scalar> {
    /// Rotation.
    pub spin: Vector3<T>,
    /// Velocity of the origin.
    pub drift: Vector3<T>,
}

impl<T: Scalar> WormScrew<T> {
    /// The screw of the worm alone.
    pub fn steady(p: f64) -> Self {
        let (zero, one) = (T::from(0.0), T::from(1.0));
        Self { spin: Vector3::new(zero, zero, one), drift: Vector3::new(zero, zero, T::from(p)) }
    }
}

/// Contact point and dresser normal in the room frame.
#[derive(Clone, Copy, Debug)]
pub struct RoomContact<T: Scalar> {
    /// The place, mm.
    pub q: Vector3<T>,
    /// The unit normal there.
    pub n: Vector3<T>,
}

impl<T: Scalar> RoomContact<T> {
    /// Point and dresser normal in worm coordinates, where the worm has turned by `angle` (rad) and its z = 0 stands at `-axial` (mm).
    pub fn on_worm(&self, angle: T, axial: T) -> (Vector3<T>, Vector3<T>) {
        let (sin, cos) = (-angle).sin_cos();
        let turned = |x: &Vector3<T>| Vector3::new(cos * x.x - sin * x.y, sin * x.x + cos * x.y, x.z);
        let mut point = turned(&self.q);
        point.z += axial;
        (point, turned(&self.n))
    }
}

/// The contact condition A cos(psi) + B sin(psi) + D = 0 of a circle.
struct Balance<T> {
    a: T,
    b: T,
    d: T,
    /// Q = A^2 + B^2.
    q: T,
    /// Q - D^2.
    rest: T,
}

impl<T: Scalar> Balance<T> {
    fn of(m: &MeridianPoint<T>, dresser: &DresserAxes<T>, worm: &WormScrew<T>) -> Self {
        let kap = m.n_z / m.n_r;
        let apex = dresser.centre + dresser.axis * (m.z - kap * m.r);
        let torque = |e: &Vector3<T>| worm.spin.dot(&apex.cross(e)) + worm.drift.dot(e);
        let (a, b, d) = (torque(&dresser.e1), torque(&dresser.e2), kap * torque(&dresser.axis));
        let q = a * a + b * b;
        Self { a, b, d, q, rest: q - d * d }
    }
}

/// The contact of a dresser circle; `None` where the circle touches nothing.
pub fn touch<T: Scalar>(
    m: &MeridianPoint<T>,
    dresser: &DresserAxes<T>,
    worm: &WormScrew<T>,
) -> Option<RoomContact<T>> {
    let Balance { a, b, d, q, rest } = Balance::of(m, dresser, worm);
    if value_of(rest).is_nan() || value_of(rest) <= 0.0 {
        return None;
    }
    let r = rest.sqrt();
    let cos_psi = -(d * a + b * r) / q;
    let sin_psi = (a * r - d * b) / q;
    let radial = dresser.e1 * cos_psi + dresser.e2 * sin_psi;
    Some(RoomContact {
        q: dresser.centre + radial * m.r + dresser.axis * m.z,
        n: radial * m.n_r + dresser.axis * m.n_z,
    })
}

/// How far a circle is from losing contact: (Q - D^2)/Q; at 0 it touches in one last point, below nowhere.
pub(super) fn slack(m: &MeridianPoint<f64>, dresser: &DresserAxes<f64>, worm: &WormScrew<f64>) -> f64 {
    let balance = Balance::of(m, dresser, worm);
    balance.rest / balance.q
}
