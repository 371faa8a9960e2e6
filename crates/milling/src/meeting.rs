//! Where a line meets the cutting part of a cutter: by its own profile of side, arc and end face, turned about the axis.

use foundation::geometry::CutterShape;
use nalgebra::{Matrix3, Vector3};
use std::f64::consts::FRAC_PI_2;

/// The profile of a cutting part: an arc, a straight side above it or none, an end face inside of it. mm, rad.
#[derive(Clone, Copy, Debug)]
pub(super) struct Profile {
    /// Radius and height of the arc's centre.
    centre: [f64; 2],
    /// Radius of the arc.
    arc: f64,
    /// Half angle of the side.
    side: Option<f64>,
}

/// A part of the profile. Its parameter: height of the side, angle of the arc's outward normal against the radial direction, radius
/// on the end face.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Part {
    Side,
    Arc,
    End,
}

/// A line: a point and a unit direction out of the material.
#[derive(Clone, Copy, Debug)]
pub(super) struct Line {
    pub point: Vector3<f64>,
    pub direction: Vector3<f64>,
}

/// Newton's steps and the step that ends them, mm and rad.
const STEPS: usize = 30;
const SMALLEST_STEP: f64 = 1e-13;
/// A parameter may be this far beyond the end of its part, mm or rad: the parts go on there tangentially.
const EDGE: f64 = 1e-9;
/// Changes of the part before a line counts as missing the cutter; a convex profile of three parts needs two.
const CHANGES: usize = 4;

impl Profile {
    /// The profile of a cutting part; the side is taken to go on upwards.
    pub fn new(shape: &CutterShape) -> Self {
        match *shape {
            CutterShape::Conical { radius, half_angle, corner_radius } => {
                let circle = radius + (half_angle.sin() - 1.0) * corner_radius / half_angle.cos();
                Self { centre: [circle, corner_radius], arc: corner_radius, side: Some(half_angle) }
            }
            CutterShape::Barrel { radius, height, profile_radius } => {
                Self { centre: [radius - profile_radius, height], arc: profile_radius, side: None }
            }
        }
    }

    /// Distance from a line's point along its direction to where the line enters the cutter with its tip and axis, mm.
    pub fn meeting(&self, tip: &Vector3<f64>, axis: &Vector3<f64>, line: &Line) -> Option<f64> {
        let from_tip = line.point - tip;
        let z = from_tip.dot(axis);
        let across = from_tip - axis * z;
        let radial = across.try_normalize(0.0).unwrap_or_else(|| perpendicular(axis));
        let (mut part, mut parameter) = self.nearest(across.norm(), z);
        for _ in 0..CHANGES {
            let (found, length) = match part {
                Part::End => self.on_end(tip, axis, line)?,
                _ => self.on_turned(part, parameter, [tip, axis, &radial], line)?,
            };
            match self.beyond(part, found) {
                None => return Some(length),
                Some(next) => (part, parameter) = next,
            }
        }
        None
    }

    /// Where the side begins: angle of the arc and height.
    fn side_from(&self) -> Option<[f64; 2]> {
        self.side.map(|half_angle| [-half_angle, self.centre[1] - self.arc * half_angle.sin()])
    }

    /// The part that is nearest to a place, and its parameter there.
    fn nearest(&self, rho: f64, z: f64) -> (Part, f64) {
        let [circle, height] = self.centre;
        match self.side_from() {
            Some([_, from]) if z >= from => (Part::Side, z),
            _ if (rho <= circle && z < height) || self.arc == 0.0 => (Part::End, rho),
            _ => (Part::Arc, (z - height).atan2(rho - circle).clamp(-FRAC_PI_2, self.arc_to())),
        }
    }

    fn arc_to(&self) -> f64 {
        self.side_from().map_or(FRAC_PI_2, |[angle, _]| angle)
    }

    /// The part to go on with where a parameter has left its own, and the parameter there.
    fn beyond(&self, part: Part, at: f64) -> Option<(Part, f64)> {
        let side = self.side_from().map(|[_, from]| (Part::Side, from));
        match part {
            Part::Side if side.is_some_and(|(_, from)| at < from - EDGE) => {
                Some(if self.arc > 0.0 { (Part::Arc, self.arc_to()) } else { (Part::End, self.centre[0]) })
            }
            Part::Arc if at > self.arc_to() + EDGE => side,
            Part::Arc if at < -FRAC_PI_2 - EDGE => Some((Part::End, self.centre[0])),
            Part::End if at > self.centre[0] + EDGE => {
                if self.arc > 0.0 {
                    Some((Part::Arc, -FRAC_PI_2))
                } else {
                    side
                }
            }
            _ => None,
        }
    }

    /// Radius on the end face and distance.
    fn on_end(&self, tip: &Vector3<f64>, axis: &Vector3<f64>, line: &Line) -> Option<(f64, f64)> {
        let steep = line.direction.dot(axis);
        let middle = tip + axis * (self.centre[1] - self.arc);
        let length = (middle - line.point).dot(axis) / steep;
        let radius = (line.point + line.direction * length - middle).norm();
        // From outside through the face, not out of it.
        (steep > 0.0 && radius.is_finite()).then_some((radius, length))
    }

    /// Parameter and distance on the surface that a part of the profile makes: parameter, angle about the axis, distance by Newton's
    /// method.
    fn on_turned(
        &self,
        part: Part,
        start: f64,
        [tip, axis, first]: [&Vector3<f64>; 3],
        line: &Line,
    ) -> Option<(f64, f64)> {
        let second = axis.cross(first);
        let mut at = Vector3::new(start, 0.0, 0.0);
        for _ in 0..STEPS {
            let [rho, z, rho_t, z_t] = self.place(part, at.x);
            let (sin, cos) = at.y.sin_cos();
            let (radial, around) = (first * cos + second * sin, second * cos - first * sin);
            let off = tip + axis * z + radial * rho - line.point - line.direction * at.z;
            let slopes = Matrix3::from_columns(&[axis * z_t + radial * rho_t, around * rho, -line.direction]);
            let step = slopes.lu().solve(&off)?;
            at -= step;
            if !at.iter().all(|x| x.is_finite()) {
                return None;
            }
            if step.amax() < SMALLEST_STEP * at.amax().max(1.0) {
                let outward = radial * z_t - axis * rho_t;
                return (outward.dot(&line.direction) < 0.0).then_some((at.x, at.z));
            }
        }
        None
    }

    /// Radius and height with their slopes.
    fn place(&self, part: Part, t: f64) -> [f64; 4] {
        let [circle, height] = self.centre;
        match (part, self.side) {
            (Part::Side, Some(half_angle)) => {
                let (sin, cos) = half_angle.sin_cos();
                let tan = sin / cos;
                let from = height - self.arc * sin;
                [circle + self.arc * cos + (t - from) * tan, t, tan, 1.0]
            }
            _ => {
                let (sin, cos) = t.sin_cos();
                [circle + self.arc * cos, height + self.arc * sin, -self.arc * sin, self.arc * cos]
            }
        }
    }
}

/// A unit vector at right angles to another.
fn perpendicular(axis: &Vector3<f64>) -> Vector3<f64> {
    let least = if axis.x.abs() < 0.5 { Vector3::x() } else { Vector3::y() };
    (least - axis * axis.dot(&least)).normalize()
}

#[cfg(test)]
mod tests {
    use super::*;
    use foundation::geometry::{Cutter, in_tool};

    /// What every part finds lies on the body as the distance function has it, and the line comes from outside.
    #[test]
    fn lines_end_on_the_body() {
        let shapes = [
            CutterShape::end_mill(3.0, 1.5),
            CutterShape::end_mill(3.0, 0.0),
            CutterShape::ball(2.0),
            CutterShape::Conical { radius: 1.0, half_angle: 0.1, corner_radius: 0.4 },
            CutterShape::Barrel { radius: 3.0, height: 9.0, profile_radius: 40.0 },
        ];
        let axis = Vector3::new(0.2, -0.3, 0.9).normalize();
        let tip = Vector3::new(1.0, 2.0, 3.0);
        for shape in &shapes {
            let cutter = Cutter::new(*shape, 20.0, vec![]).unwrap();
            let profile = Profile::new(shape);
            let mut met = 0;
            for k in 0..200 {
                let (height, turn) = (-0.5 + 0.05 * f64::from(k % 100), 0.7 * f64::from(k));
                let around = perpendicular(&axis);
                let out = around * turn.cos() + axis.cross(&around) * turn.sin();
                let direction = -(out + axis * (-0.2 - 0.5 * f64::from(k % 3))).normalize();
                let point = tip + axis * height + out * (0.3 + 0.02 * f64::from(k)) - direction;
                let line = Line { point, direction };
                let Some(length) = profile.meeting(&tip, &axis, &line) else { continue };
                met += 1;
                let distance = |length: f64| {
                    let [rho, z] = in_tool(&(point + direction * length), &tip, &axis);
                    cutter.distance(rho, z)
                };
                assert!(distance(length).abs() < 1e-8, "{shape:?} {k}: {}", distance(length));
                assert!(distance(length - 1e-4) > 0.0, "{shape:?} {k}: not from outside");
            }
            assert!(met > 60, "{shape:?}: only {met} lines met it");
        }
    }
}
