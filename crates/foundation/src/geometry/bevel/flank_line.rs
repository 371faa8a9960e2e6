//! Flank lines of bevel teeth: by which angle Theta(R) a section at the distance R from the apex is turned.

use crate::geometry::GeometryError;
use crate::geometry::surface::bounds::largest;
use crate::numerics::CubicSpline;

/// Hand of a spiral: right-handed if the section turns mathematically positive about z with growing distance from the apex.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Hand {
    /// +1
    Right,
    /// -1
    Left,
}

/// Theta(R), rad over mm.
#[derive(Clone, Debug, PartialEq)]
pub enum FlankLine {
    /// Theta = 0.
    Straight,
    /// A circle on the developed pitch cone.
    Circular(CircularLine),
    /// Any other line, as a spline over R.
    Spline(CubicSpline),
}

/// The line that a face mill's circle leaves on the developed pitch cone. mm, rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CircularLine {
    hand: f64,
    /// r_c.
    radius: f64,
    /// E: distance of the circle's centre from the apex.
    centre_distance: f64,
    sin_pitch: f64,
    mean_angle: f64,
}

/// What a flank line is over an interval of R: enclosing range of R Theta' and an upper bound of |d(R Theta')/dR|, 1/mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct LineBounds {
    /// Range of R Theta'.
    pub(super) turn: [f64; 2],
    /// Bound of its derivative.
    pub(super) turn_rate: f64,
}

/// Share of the circle's radius by which a domain ends before the line runs round the axis, where Theta' has no bound.
const BORDER: f64 = 1e-9;

impl Hand {
    /// +1 or -1.
    pub fn sign(self) -> f64 {
        match self {
            Self::Right => 1.0,
            Self::Left => -1.0,
        }
    }
}

impl CircularLine {
    /// A circle through the mean distance R_m at a spiral angle, on a pitch cone of the angle delta; Theta(R_m) = 0.
    pub(super) fn new(spiral: Spiral, mean_distance: f64, pitch_angle: f64) -> Self {
        let (r_m, r_c) = (mean_distance, spiral.cutter_radius);
        let (sin, cos) = spiral.mean_angle.sin_cos();
        // E^2 = R_m^2 + r_c^2 - 2 R_m r_c sin(beta_m), without the difference of squares.
        let centre_distance = (r_m - r_c * sin).hypot(r_c * cos);
        let mut line = Self {
            hand: spiral.hand.sign(),
            radius: r_c,
            centre_distance,
            sin_pitch: pitch_angle.sin(),
            mean_angle: 0.0,
        };
        line.mean_angle = line.angle_at(mean_distance);
        line
    }

    /// E: distance of the circle's centre from the apex on the developed cone, mm.
    pub fn centre_distance(&self) -> f64 {
        self.centre_distance
    }

    /// r_c^2 - E^2.
    fn power(&self) -> f64 {
        (self.radius - self.centre_distance) * (self.radius + self.centre_distance)
    }

    /// sin(beta) at R, without the hand.
    fn sine(&self, distance: f64) -> f64 {
        (distance + self.power() / distance) / (2.0 * self.radius)
    }

    /// q(R): angle at the apex between the point and the circle's centre; from its sine as well, so that it is exact near 0.
    fn angle_at(&self, distance: f64) -> f64 {
        let sine = self.sine(distance);
        let cosine = ((1.0 - sine) * (1.0 + sine)).max(0.0).sqrt();
        (self.radius * cosine).atan2((distance - self.power() / distance) / 2.0)
    }

    fn derivatives(&self, distance: f64) -> [f64; 4] {
        let r = distance;
        let (s, c_r2) = (self.sine(r), self.power() / (r * r));
        let (s1, s2) = ((1.0 - c_r2) / (2.0 * self.radius), c_r2 / (r * self.radius));
        let cosine = ((1.0 - s) * (1.0 + s)).max(0.0).sqrt();
        let cube = 1.0 / (cosine * cosine * cosine);
        let t = [s / cosine, s1 * cube, s2 * cube + 3.0 * s * s1 * s1 * cube / (cosine * cosine)];
        // U = tan(beta)/R and its derivatives.
        let u = t[0] / r;
        let u1 = (t[1] - u) / r;
        let u2 = (t[2] - 2.0 * u1) / r;
        let scale = self.hand / self.sin_pitch;
        [-scale * (self.angle_at(r) - self.mean_angle), scale * u, scale * u1, scale * u2]
    }

    fn bounds(&self, [from, to]: [f64; 2]) -> LineBounds {
        // sin(beta) is convex in R with its least value at sqrt(r_c^2 - E^2), or grows throughout.
        let ends = [self.sine(from), self.sine(to)];
        let turning = self.power().max(0.0).sqrt();
        let least = if from < turning && turning < to { self.sine(turning) } else { ends[0].min(ends[1]) };
        let sines = [least, ends[0].max(ends[1])];
        let tangent = |s: f64| s / ((1.0 - s) * (1.0 + s)).max(0.0).sqrt();
        let scale = 1.0 / self.sin_pitch;
        let turn = sines.map(|s| scale * self.hand * tangent(s));
        let steepest = largest(sines);
        let cosine = ((1.0 - steepest) * (1.0 + steepest)).max(0.0).sqrt();
        let rate = |r: f64| ((1.0 - self.power() / (r * r)) / (2.0 * self.radius)).abs();
        LineBounds {
            turn: if self.hand > 0.0 { turn } else { [turn[1], turn[0]] },
            turn_rate: scale * rate(from).max(rate(to)) / (cosine * cosine * cosine),
        }
    }
}

impl FlankLine {
    /// Theta and its first three derivatives at R.
    #[inline]
    pub fn derivatives(&self, distance: f64) -> [f64; 4] {
        match self {
            Self::Straight => [0.0; 4],
            Self::Circular(line) => line.derivatives(distance),
            Self::Spline(spline) => spline.derivatives(distance),
        }
    }

    /// Theta at R, rad.
    #[inline]
    pub fn angle(&self, distance: f64) -> f64 {
        match self {
            Self::Straight => 0.0,
            Self::Circular(line) => -line.hand * (line.angle_at(distance) - line.mean_angle) / line.sin_pitch,
            Self::Spline(spline) => spline.value(distance),
        }
    }

    /// Distances from the apex between which the line has a direction, mm.
    pub fn domain(&self) -> [f64; 2] {
        match self {
            Self::Straight => [0.0, f64::INFINITY],
            Self::Circular(line) => {
                let border = BORDER * line.radius;
                [
                    (line.radius - line.centre_distance).abs() + border,
                    line.radius + line.centre_distance - border,
                ]
            }
            Self::Spline(spline) => spline.domain(),
        }
    }

    /// Whether the line covers a face.
    ///
    /// # Errors
    /// [`GeometryError::FlankLineOutOfReach`] (`E_GEOM_BASE` of `docs/mathematics/milling.md#limits`).
    pub(super) fn check(&self, face: [f64; 2]) -> Result<(), GeometryError> {
        let [from, to] = self.domain();
        match face.into_iter().find(|&distance| !(from..=to).contains(&distance)) {
            Some(distance) => Err(GeometryError::FlankLineOutOfReach { distance, from, to }),
            None => Ok(()),
        }
    }

    /// Bounds over an interval of the domain.
    pub(super) fn bounds(&self, distances: [f64; 2]) -> LineBounds {
        match self {
            Self::Straight => LineBounds { turn: [0.0; 2], turn_rate: 0.0 },
            Self::Circular(line) => line.bounds(distances),
            Self::Spline(spline) => {
                let [_, slope, bend, _] = spline.ranges(distances);
                let [from, to] = distances;
                LineBounds {
                    turn: [(from * slope[0]).min(to * slope[0]), (from * slope[1]).max(to * slope[1])],
                    turn_rate: largest(slope) + to * largest(bend),
                }
            }
        }
    }
}

/// A flank line that is a circle on the developed pitch cone. mm, rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spiral {
    /// beta_m: spiral angle at the mean distance, without sign.
    pub mean_angle: f64,
    /// r_c: radius of the circle, that of a face mill's cutter head.
    pub cutter_radius: f64,
    /// Hand of the spiral.
    pub hand: Hand,
}
