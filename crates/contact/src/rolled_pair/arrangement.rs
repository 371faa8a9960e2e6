//! How two gears stand to each other: axes that cross in both apexes, or parallel ones.
//!
//! The frame is that of the first gear, whose axis is z; the pitch line lies in the plane of y and z on the side of +y.

use crate::ContactError;
use nalgebra::Vector3;

/// Axes of two gears that roll together. rad, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Arrangement {
    /// Both axes cross at this angle, the apexes of both gears in the point where they do.
    Crossing {
        /// Angle between both axes.
        shaft_angle: f64,
    },
    /// External teeth of both gears on parallel axes.
    Outside {
        /// Centre distance.
        centre_distance: f64,
    },
    /// One gear inside of the other on parallel axes.
    Inside {
        /// Centre distance.
        centre_distance: f64,
        /// Whether the first gear is the one with internal teeth.
        first_is_ring: bool,
    },
}

impl Arrangement {
    pub(super) fn check(&self) -> Result<(), ContactError> {
        let number = |field, value: f64, good: bool, allowed| {
            if good { Ok(()) } else { Err(ContactError::InvalidNumber { field, value, allowed }) }
        };
        match *self {
            Self::Crossing { shaft_angle } => {
                let angle = shaft_angle.to_degrees();
                number("shaft_angle_deg", angle, angle > 0.0 && angle < 180.0, "between 0 and 180 deg")
            }
            Self::Outside { centre_distance } | Self::Inside { centre_distance, .. } => {
                let good = centre_distance > 0.0 && centre_distance.is_finite();
                number("centre_distance", centre_distance, good, "> 0 mm")
            }
        }
    }

    /// sin and cos of the angle between both axes.
    pub(super) fn shaft(&self) -> [f64; 2] {
        match *self {
            Self::Crossing { shaft_angle } => [shaft_angle.sin(), shaft_angle.cos()],
            Self::Outside { .. } | Self::Inside { .. } => [0.0, 1.0],
        }
    }

    /// Where the second axis stands on y, mm.
    pub(super) fn centre(&self) -> f64 {
        match *self {
            Self::Crossing { .. } => 0.0,
            Self::Outside { centre_distance } => centre_distance,
            Self::Inside { centre_distance, first_is_ring } => {
                if first_is_ring {
                    centre_distance
                } else {
                    -centre_distance
                }
            }
        }
    }

    /// +1 if the second gear turns against the first, -1 if with it.
    pub(super) fn against(&self) -> f64 {
        if matches!(self, Self::Inside { .. }) { -1.0 } else { 1.0 }
    }

    /// A vector in the frame of the second gear's bed: z its axis, +y towards the pitch line.
    pub(super) fn turned(&self, v: &Vector3<f64>) -> Vector3<f64> {
        match self {
            Self::Inside { .. } => *v,
            _ => {
                let [s, c] = self.shaft();
                Vector3::new(-v.x, s * v.z - c * v.y, s * v.y + c * v.z)
            }
        }
    }

    /// A point in that frame.
    pub(super) fn seen(&self, point: &Vector3<f64>) -> Vector3<f64> {
        self.turned(&Vector3::new(point.x, point.y - self.centre(), point.z))
    }

    /// The two coordinates of a circle about the second axis, each of which belongs to one parameter of a flank nearly alone, with how
    /// they change along two directions, and the length that their misses are compared with.
    pub(super) fn circle(&self, p: &Vector3<f64>, along: [&Vector3<f64>; 2]) -> Circle {
        let radius = p.x.hypot(p.y);
        let outwards = |v: &Vector3<f64>| (p.x * v.x + p.y * v.y) / radius;
        if let Self::Crossing { .. } = self {
            let distance = p.norm();
            let rates = along
                .map(|v| [p.dot(v) / distance, (p.z * outwards(v) - radius * v.z) / (distance * distance)]);
            return Circle { place: [distance, radius.atan2(p.z)], rates, scales: [1.0, distance] };
        }
        Circle { place: [p.z, radius], rates: along.map(|v| [v.z, outwards(v)]), scales: [1.0, 1.0] }
    }
}

/// A circle about the second axis.
pub(super) struct Circle {
    /// Distance from the apex and polar angle, or position and radius.
    pub place: [f64; 2],
    /// How both change along two directions.
    pub rates: [[f64; 2]; 2],
    /// What makes lengths of both, mm.
    pub scales: [f64; 2],
}
