//! Flank lines of bevel teeth: by which angle Theta(R) a section at the distance R from the apex is turned.

use super::line_bounds::LineBounds;
use super::tangent_line::TangentLine;
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
    /// A circle or an epicycloid on the developed pitch cone.
    Circular(CircularLine),
    /// A straight line or an involute there.
    Tangent(TangentLine),
    /// Any other line, as a spline over R.
    Spline(CubicSpline),
}

/// The line that a face mill's circle leaves on the developed pitch cone, or the extended epicycloid of a cutter head with groups of
/// blades that turns on while the crown gear does. mm, rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CircularLine {
    hand: f64,
    /// r_c.
    radius: f64,
    /// E: distance of the circle's centre from the apex.
    centre_distance: f64,
    /// Turn of the crown gear for each of the cutter head against it, z_0 sin(delta)/z; 0 for a circle.
    rolling: f64,
    sin_pitch: f64,
    mean_angle: f64,
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
    /// A line through the mean distance R_m at a spiral angle, on a pitch cone of the angle delta; Theta(R_m) = 0. `rolling` is 0 for a
    /// circle. `None` where the head would turn on faster than its blades come along the tooth.
    pub(super) fn new(
        spiral: &Spiral,
        (radius, rolling): (f64, f64),
        mean_distance: f64,
        pitch_angle: f64,
    ) -> Option<Self> {
        let (r_m, r_c) = (mean_distance, radius);
        // The blade leads its radius by nu, sin(nu) = R_m cos(beta_m) z_0 sin(delta)/(z r_c).
        let leads = r_m * spiral.mean_angle.cos() * rolling / r_c;
        if leads.is_nan() || leads >= 1.0 {
            return None;
        }
        let (sin, cos) = (spiral.mean_angle - leads.asin()).sin_cos();
        // E^2 = R_m^2 + r_c^2 - 2 R_m r_c sin(beta_m), without the difference of squares.
        let centre_distance = (r_m - r_c * sin).hypot(r_c * cos);
        let mut line = Self {
            hand: spiral.hand.sign(),
            radius: r_c,
            centre_distance,
            rolling,
            sin_pitch: pitch_angle.sin(),
            mean_angle: 0.0,
        };
        line.mean_angle = line.angle_at(mean_distance);
        Some(line)
    }

    /// E: distance of the circle's centre from the apex on the developed cone, mm.
    pub fn centre_distance(&self) -> f64 {
        self.centre_distance
    }

    /// r_c^2 - E^2.
    fn power(&self) -> f64 {
        (self.radius - self.centre_distance) * (self.radius + self.centre_distance)
    }

    /// Sine of the angle between the radius and the tangent of the circle at R, without the hand; of a circle sin(beta).
    fn sine(&self, distance: f64) -> f64 {
        (distance + self.power() / distance) / (2.0 * self.radius)
    }

    /// q(R): angle at the apex between the point and the circle's centre, from its sine as well, so that it is exact near 0; and what the
    /// crown gear turns while the blade turns by its angle at the centre.
    fn angle_at(&self, distance: f64) -> f64 {
        let sine = self.sine(distance);
        let cosine = ((1.0 - sine) * (1.0 + sine)).max(0.0).sqrt();
        let at_apex = (self.radius * cosine).atan2((distance - self.power() / distance) / 2.0);
        let (r, e) = (self.radius, self.centre_distance);
        let at_centre = || (2.0 * r * distance * cosine).atan2(distance * distance - e * e - r * r);
        // A circle does not turn on.
        if self.rolling == 0.0 { at_apex } else { at_apex + self.rolling * at_centre() }
    }

    fn derivatives(&self, distance: f64) -> [f64; 4] {
        let r = distance;
        let (s, c_r2) = (self.sine(r), self.power() / (r * r));
        let (s1, s2) = ((1.0 - c_r2) / (2.0 * self.radius), c_r2 / (r * self.radius));
        let cosine = ((1.0 - s) * (1.0 + s)).max(0.0).sqrt();
        // tan(beta) = (s + R rolling/r_c) g with g = 1/cosine.
        let per_length = self.rolling / self.radius;
        let n = [s + r * per_length, s1 + per_length, s2];
        let g0 = 1.0 / cosine;
        let cube = g0 * g0 * g0;
        let g = [g0, s * s1 * cube, (s1 * s1 + s * s2) * cube + 3.0 * s * s * s1 * s1 * cube * g0 * g0];
        let t = [n[0] * g[0], n[1] * g[0] + n[0] * g[1], n[2] * g[0] + 2.0 * n[1] * g[1] + n[0] * g[2]];
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
        let cosine = |s: f64| ((1.0 - s) * (1.0 + s)).max(0.0).sqrt();
        let rolled = [from, to].map(|r| r * self.rolling / self.radius);
        let scale = 1.0 / self.sin_pitch;
        let steepest = cosine(largest(sines));
        // (s + x)/cosine(s) grows with s while s x > -1, as all lines have it that come along the tooth.
        let turn = if largest(sines) * rolled[1] < 1.0 {
            [0, 1].map(|k| scale * self.hand * (sines[k] + rolled[k]) / cosine(sines[k]))
        } else {
            let most = scale * (largest(sines) + rolled[1]) / steepest;
            [-self.hand * most, self.hand * most]
        };
        let rate = |r: f64| ((1.0 - self.power() / (r * r)) / (2.0 * self.radius)).abs();
        let cube = steepest * steepest * steepest;
        let by_sine = rate(from).max(rate(to)) * (1.0 + largest(sines) * rolled[1]) / cube;
        LineBounds {
            turn: if self.hand > 0.0 { turn } else { [turn[1], turn[0]] },
            turn_rate: scale * (by_sine + self.rolling / (self.radius * steepest)),
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
            Self::Tangent(line) => line.derivatives(distance),
            Self::Spline(spline) => spline.derivatives(distance),
        }
    }

    /// Theta at R, rad.
    #[inline]
    pub fn angle(&self, distance: f64) -> f64 {
        match self {
            Self::Straight => 0.0,
            Self::Circular(line) => -line.hand * (line.angle_at(distance) - line.mean_angle) / line.sin_pitch,
            Self::Tangent(line) => line.angle(distance),
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
            Self::Tangent(line) => line.domain(),
            Self::Spline(spline) => spline.domain(),
        }
    }

    /// The same line, turned so that Theta is 0 at a distance of its domain.
    pub(super) fn through(mut self, distance: f64) -> Self {
        match &mut self {
            Self::Straight | Self::Spline(_) => {}
            Self::Circular(line) => line.mean_angle = line.angle_at(distance),
            Self::Tangent(line) => line.turn_to(distance),
        }
        self
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
            Self::Tangent(line) => line.bounds(distances),
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

/// What a flank line is on the developed pitch cone, which is the crown gear's plane. mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LineForm {
    /// A circle: face milling, one space after the other.
    Circle {
        /// r_c: radius of the cutter head.
        radius: f64,
    },
    /// An extended epicycloid: face hobbing with a cutter head whose groups of blades follow each other through the spaces.
    Epicycloid {
        /// r_c: radius of the cutter head.
        radius: f64,
        /// z_0: groups of blades.
        groups: f64,
    },
    /// A straight line beside the apex: skew teeth.
    Straight,
    /// An involute: palloid teeth, by a conical hob.
    Involute,
}

/// A flank line with a direction in the middle of the face. mm, rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spiral {
    /// beta_m: spiral angle at the mean distance, without sign.
    pub mean_angle: f64,
    /// The line.
    pub form: LineForm,
    /// Hand of the spiral.
    pub hand: Hand,
}

impl Spiral {
    /// The same line of the other hand, as the mate has it.
    pub fn reversed(self) -> Self {
        Self { hand: if self.hand == Hand::Right { Hand::Left } else { Hand::Right }, ..self }
    }
}
