//! Poses that carry their frames: a worm point cannot be fed where a workpiece point belongs.
//!
//! `Pose<To, From>` maps coordinates of `From` into `To`; in the monogram of the design, X_SV is `Pose<Worm, Workpiece>`.
//! The frames are zero-sized types, so a typed pose costs what an untyped one costs.
//!
//! ```compile_fail
//! use foundation::kinematics::{Point, Pose, Worm, Workpiece};
//! let x_sv: Pose<Worm, Workpiece> = Pose::identity();
//! let worm_point: Point<Worm> = Point::new(0.0, 1.0, 2.0);
//! let wrong = x_sv.point(&worm_point); // a worm point is no workpiece point
//! ```

use crate::numerics::Scalar;
use nalgebra::{Matrix3, Rotation3, Unit, Vector3};
use std::marker::PhantomData;

/// Frame V: the workpiece.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Workpiece;
/// Frame S: the worm.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Worm;
/// Frame A: the dresser.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dresser;
/// A frame fixed in the room between two moving bodies (frame O of `docs/mathematics/generating-contact.md` and `docs/mathematics/dressing.md`).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Room;

/// A point in the coordinates of a frame, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point<Frame, T: Scalar = f64> {
    /// Coordinates.
    pub xyz: Vector3<T>,
    frame: PhantomData<Frame>,
}

/// A direction (normal, axis, velocity) in the coordinates of a frame: turned by poses, not moved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Direction<Frame, T: Scalar = f64> {
    /// Components.
    pub xyz: Vector3<T>,
    frame: PhantomData<Frame>,
}

impl<Frame, T: Scalar> Point<Frame, T> {
    /// From coordinates.
    pub fn new(x: T, y: T, z: T) -> Self {
        Self::from_vector(Vector3::new(x, y, z))
    }

    /// From a vector of coordinates.
    pub fn from_vector(xyz: Vector3<T>) -> Self {
        Self { xyz, frame: PhantomData }
    }
}

impl<Frame, T: Scalar> Direction<Frame, T> {
    /// From a vector of components.
    pub fn from_vector(xyz: Vector3<T>) -> Self {
        Self { xyz, frame: PhantomData }
    }
}

/// A rigid displacement that maps coordinates of `From` into coordinates of `To`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose<To, From, T: Scalar = f64> {
    rotation: Matrix3<T>,
    translation: Vector3<T>,
    frames: PhantomData<(To, From)>,
}

impl<To, From, T: Scalar> Pose<To, From, T> {
    /// From a rotation matrix (columns: axes of `From` in `To`) and the origin of `From` in `To`, mm. That the matrix is a
    /// rotation is the caller's word.
    pub fn rigid(rotation: Matrix3<T>, translation: Vector3<T>) -> Self {
        Self { rotation, translation, frames: PhantomData }
    }

    fn turn(angle: T, axis: usize) -> Self {
        let (sin, cos) = angle.sin_cos();
        let (zero, one) = (T::from(0.0), T::from(1.0));
        let mut r = Matrix3::from_element(zero);
        let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
        r[(axis, axis)] = one;
        r[(i, i)] = cos;
        r[(j, j)] = cos;
        r[(i, j)] = -sin;
        r[(j, i)] = sin;
        Self::rigid(r, Vector3::from_element(zero))
    }

    fn shift(offset: T, axis: usize) -> Self {
        let mut pose = Self::identity();
        pose.translation[axis] = offset;
        pose
    }

    /// The same coordinates in both frames.
    pub fn identity() -> Self {
        let (zero, one) = (T::from(0.0), T::from(1.0));
        let mut r = Matrix3::from_element(zero);
        for k in 0..3 {
            r[(k, k)] = one;
        }
        Self::rigid(r, Vector3::from_element(zero))
    }

    /// Rx(a) of `docs/mathematics/conventions.md`: rotation by +a about x.
    pub fn rx(angle: T) -> Self {
        Self::turn(angle, 0)
    }

    /// Ry(a) of `docs/mathematics/conventions.md`.
    pub fn ry(angle: T) -> Self {
        Self::turn(angle, 1)
    }

    /// Rz(a) of `docs/mathematics/conventions.md`.
    pub fn rz(angle: T) -> Self {
        Self::turn(angle, 2)
    }

    /// Tx(v) of `docs/mathematics/conventions.md`: translation by +v along x.
    pub fn tx(offset: T) -> Self {
        Self::shift(offset, 0)
    }

    /// Ty(v) of `docs/mathematics/conventions.md`.
    pub fn ty(offset: T) -> Self {
        Self::shift(offset, 1)
    }

    /// Tz(v) of `docs/mathematics/conventions.md`.
    pub fn tz(offset: T) -> Self {
        Self::shift(offset, 2)
    }

    /// Appends a motion on the right: `X_TF.then(X_FG)` is X_TG.
    pub fn then<Next>(&self, next: &Pose<From, Next, T>) -> Pose<To, Next, T> {
        Pose::rigid(self.rotation * next.rotation, self.rotation * next.translation + self.translation)
    }

    /// The pose the other way round.
    pub fn inverse(&self) -> Pose<From, To, T> {
        let transposed = self.rotation.transpose();
        Pose::rigid(transposed, -(transposed * self.translation))
    }

    /// A point of `From` in coordinates of `To`.
    pub fn point(&self, p: &Point<From, T>) -> Point<To, T> {
        Point::from_vector(self.rotation * p.xyz + self.translation)
    }

    /// A direction of `From` in coordinates of `To`.
    pub fn direction(&self, d: &Direction<From, T>) -> Direction<To, T> {
        Direction::from_vector(self.rotation * d.xyz)
    }

    /// The rotation matrix (columns: axes of `From` in `To`).
    pub fn rotation(&self) -> &Matrix3<T> {
        &self.rotation
    }

    /// Origin of `From` in coordinates of `To`, mm.
    pub fn translation(&self) -> &Vector3<T> {
        &self.translation
    }
}

impl<To, From> Pose<To, From> {
    /// Translation by `distance` (mm) along a unit vector.
    pub fn along(direction: &Vector3<f64>, distance: f64) -> Self {
        Self::rigid(Matrix3::identity(), direction * distance)
    }

    /// Rotation by `angle` (rad) about the line through `point` (mm) along a unit vector.
    pub fn about(direction: &Vector3<f64>, point: &Vector3<f64>, angle: f64) -> Self {
        let rotation = *Rotation3::from_axis_angle(&Unit::new_unchecked(*direction), angle).matrix();
        Self::rigid(rotation, point - rotation * point)
    }
}
