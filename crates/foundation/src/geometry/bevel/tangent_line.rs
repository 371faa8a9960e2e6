//! Flank lines that touch a circle about the apex on the developed pitch cone: the tangent itself (skew teeth) and the involute of the
//! circle (palloid teeth).
//!
//! With the radius e of the circle and q = sqrt(R^2 - e^2) the tangent has sin(beta) = e/R and the involute cos(beta) = e/R; the turn on
//! the cone is phi/sin(delta) with R phi' = tan(beta).

use super::line_bounds::LineBounds;

/// A tangent of a circle about the apex, or its involute. mm, rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TangentLine {
    /// +1 right, -1 left, over sin(delta).
    scale: f64,
    /// e.
    radius: f64,
    involute: bool,
    /// phi where the turn is 0.
    mean_angle: f64,
}

impl TangentLine {
    /// Through the mean distance at a spiral angle (without sign), turned by a scale (hand over sin(delta)).
    pub(super) fn new(involute: bool, mean_angle: f64, mean_distance: f64, scale: f64) -> Self {
        let radius = mean_distance * if involute { mean_angle.cos() } else { mean_angle.sin() };
        let mut line = Self { scale, radius, involute, mean_angle: 0.0 };
        line.mean_angle = line.developed(mean_distance);
        line
    }

    /// Lets the turn be 0 at R.
    pub(super) fn turn_to(&mut self, distance: f64) {
        self.mean_angle = self.developed(distance);
    }

    /// e, mm.
    pub fn radius(&self) -> f64 {
        self.radius
    }

    fn along(&self, distance: f64) -> f64 {
        ((distance - self.radius) * (distance + self.radius)).max(0.0).sqrt()
    }

    /// phi at R, from a point that does not matter.
    fn developed(&self, distance: f64) -> f64 {
        let q = self.along(distance);
        let angle = q.atan2(self.radius);
        if self.involute { q / self.radius - angle } else { angle }
    }

    pub(super) fn angle(&self, distance: f64) -> f64 {
        self.scale * (self.developed(distance) - self.mean_angle)
    }

    pub(super) fn derivatives(&self, distance: f64) -> [f64; 4] {
        let (r, e, q) = (distance, self.radius, self.along(distance));
        let (r2, q2) = (r * r, q * q);
        let cube = q2 * q;
        let phi = if self.involute {
            [q / (e * r), e / (q * r2), -e * (r2 + 2.0 * q2) / (cube * r2 * r)]
        } else {
            let third = 2.0 / (r2 * r * q) + 1.0 / (r * cube) + 3.0 * r / (cube * q2);
            [e / (r * q), -e * (q2 + r2) / (r2 * cube), e * third]
        };
        let [first, second, third] = phi.map(|x| self.scale * x);
        [self.angle(distance), first, second, third]
    }

    /// From the circle outwards.
    pub(super) fn domain(&self) -> [f64; 2] {
        [self.radius * (1.0 + BORDER), f64::INFINITY]
    }

    /// tan(beta) falls with R along the tangent and grows along the involute; its rate falls along both.
    pub(super) fn bounds(&self, [from, to]: [f64; 2]) -> LineBounds {
        let tangent = |r: f64| {
            let q = self.along(r);
            self.scale * if self.involute { q / self.radius } else { self.radius / q }
        };
        let ends = [tangent(from), tangent(to)];
        let (e, q) = (self.radius, self.along(from));
        let rate = if self.involute { from / (e * q) } else { e * from / (q * q * q) };
        LineBounds { turn: [ends[0].min(ends[1]), ends[0].max(ends[1])], turn_rate: self.scale.abs() * rate }
    }
}

/// Share of the circle's radius by which the domain ends before the circle, where one of both lines runs round the axis.
const BORDER: f64 = 1e-9;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_lines_have_their_direction_and_exact_derivatives() {
        for involute in [false, true] {
            let line = TangentLine::new(involute, 0.6, 80.0, -1.3);
            assert!(line.angle(80.0).abs() < 1e-15);
            // The involute begins at 66.03 mm, the tangent touches its circle at 45.17 mm.
            assert!(line.domain()[0] < 66.1);
            for r in [66.5, 75.0, 80.0, 95.0] {
                let [_, first, second, third] = line.derivatives(r);
                let by = 1e-4;
                let slope = (line.angle(r + by) - line.angle(r - by)) / (2.0 * by);
                assert!((slope - first).abs() < 1e-9, "{involute} {r}: {slope} {first}");
                for (k, exact) in [(1, second), (2, third)] {
                    let change = line.derivatives(r + by)[k] - line.derivatives(r - by)[k];
                    assert!(
                        (change / (2.0 * by) - exact).abs() < 1e-7 * (1.0 + exact.abs()),
                        "{involute} {r} {k}"
                    );
                }
                let cosine = 1.0 / (r * first / 1.3).hypot(1.0);
                let wanted = if involute {
                    80.0 * 0.6f64.cos() / r
                } else {
                    (1.0 - (80.0 * 0.6f64.sin() / r).powi(2)).sqrt()
                };
                assert!((cosine - wanted).abs() < 1e-12, "{involute} {r}");
                let bounds = line.bounds([r, r + 3.0]);
                for k in 0..=10 {
                    let at = r + 0.3 * f64::from(k);
                    let [_, first, second, _] = line.derivatives(at);
                    assert!(bounds.turn[0] - 1e-12 <= at * first && at * first <= bounds.turn[1] + 1e-12);
                    assert!((first + at * second).abs() <= bounds.turn_rate * (1.0 + 1e-12));
                }
            }
        }
    }
}
