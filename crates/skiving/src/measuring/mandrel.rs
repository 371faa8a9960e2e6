//! A mandrel in the spindle and the tilted beam: when it is dark (`docs/mathematics/skiving.md#light-barrier`). The height of the mandrel
//! enters, because an endless one would meet every tilted beam.

use foundation::numerics::brent;
use nalgebra::{Vector2, Vector3};

/// A cylinder about the spindle's axis, upright. mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mandrel {
    /// R.
    pub radius: f64,
    /// h.
    pub height: f64,
}

/// What a calibration finds: the beam by its point at height 0, its slopes and its effective radius. mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BeamLine {
    /// x_0, y_0.
    pub point: Vector2<f64>,
    /// tau = (tan delta, tan eps).
    pub slope: Vector2<f64>,
    /// r.
    pub radius: f64,
}

/// The gap between beam and mandrel with its derivatives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gap {
    /// G, mm: > 0 is light.
    pub value: f64,
    /// By x_0, y_0, tan delta, tan eps, r.
    pub by_line: [f64; 5],
}

/// Newton's steps for the direction, and the last of them, rad.
const STEPS: usize = 30;
const LAST: f64 = 1e-15;

impl BeamLine {
    /// Where the beam is at a height.
    pub fn at(&self, z: f64) -> Vector2<f64> {
        self.point + self.slope * z
    }

    /// As numbers: x_0, y_0, tan delta, tan eps, r.
    pub fn numbers(&self) -> [f64; 5] {
        [self.point.x, self.point.y, self.slope.x, self.slope.y, self.radius]
    }

    /// From those numbers.
    pub fn from_numbers([x, y, delta, eps, radius]: [f64; 5]) -> Self {
        Self { point: Vector2::new(x, y), slope: Vector2::new(delta, eps), radius }
    }
}

impl Mandrel {
    /// The gap with the mandrel's axis at X, Y and its lower face at Z: the greatest over all directions in which a plane may part the two
    /// bodies.
    pub fn gap(&self, line: &BeamLine, place: &Vector3<f64>) -> Gap {
        let middle = place.z + 0.5 * self.height;
        let off = place.xy() - line.at(middle);
        let tau = line.slope;
        if tau.norm() == 0.0 {
            // With both axes in one line every direction parts them alike.
            let u = if off.norm() > 0.0 { off.normalize() } else { Vector2::x() };
            return self.parted(line, &off, middle, &u, 0.0);
        }
        let mut best: Option<Gap> = None;
        let mut take = |gap: Gap| {
            if best.is_none_or(|known| gap.value > known.value) {
                best = Some(gap);
            }
        };
        for sense in [1.0, -1.0] {
            if let Some(u) = self.smooth_direction(line, &off, sense) {
                take(self.parted(line, &off, middle, &u, sense));
            }
        }
        let across = Vector2::new(-tau.y, tau.x) / tau.norm();
        for u in [across, -across] {
            // At the kink the direction turns with the slope.
            let mut gap = self.parted(line, &off, middle, &u, 0.0);
            let turning = if u == across { -1.0 } else { 1.0 } * tau.dot(&off) / tau.norm().powi(3);
            gap.by_line[2] += -turning * tau.y;
            gap.by_line[3] += turning * tau.x;
            take(gap);
        }
        best.unwrap_or_else(|| self.parted(line, &off, middle, &across, 0.0))
    }

    /// Where the mandrel, moved along a unit direction from a place, switches the beam: between two ways, of which the second ends in the
    /// dark.
    pub fn switch(
        &self,
        line: &BeamLine,
        from: &Vector3<f64>,
        direction: &Vector3<f64>,
        [light, dark]: [f64; 2],
    ) -> Option<Vector3<f64>> {
        let gap = |way: f64| self.gap(line, &(from + direction * way)).value;
        let way = brent([light, dark], [gap(light), gap(dark)], 0.0, |way| Some(gap(way)))?;
        Some(from + direction * way)
    }

    /// The direction of greatest parting on the half circle where sense u.tau > 0.
    fn smooth_direction(&self, line: &BeamLine, off: &Vector2<f64>, sense: f64) -> Option<Vector2<f64>> {
        let tau = line.slope;
        let pulled = off - tau * (0.5 * self.height * sense);
        let mut angle = pulled.y.atan2(pulled.x);
        for _ in 0..STEPS {
            let (sin, cos) = angle.sin_cos();
            let (u, v) = (Vector2::new(cos, sin), Vector2::new(-sin, cos));
            let (a, b) = (u.dot(&tau), v.dot(&tau));
            let root = (1.0 + a * a).sqrt();
            let slope = v.dot(&pulled) - line.radius * a * b / root;
            let bend = -u.dot(&pulled)
                - line.radius * ((b * b - a * a) / root - a * a * b * b / (root * root * root));
            let step = slope / bend;
            angle -= step;
            if step.abs() < LAST * 4.0 {
                break;
            }
        }
        let u = Vector2::new(angle.cos(), angle.sin());
        (sense * u.dot(&tau) > 0.0).then_some(u)
    }

    /// What a plane across u leaves between the bodies; at the greatest the direction's own change does not matter.
    fn parted(&self, line: &BeamLine, off: &Vector2<f64>, middle: f64, u: &Vector2<f64>, sense: f64) -> Gap {
        let a = u.dot(&line.slope);
        let root = (1.0 + a * a).sqrt();
        let value = u.dot(off) - self.radius - 0.5 * self.height * sense * a - line.radius * root;
        let by_a = -0.5 * self.height * sense - line.radius * a / root;
        let by_slope = |k: usize| -middle * u[k] + by_a * u[k];
        Gap { value, by_line: [-u.x, -u.y, by_slope(0), by_slope(1), -root] }
    }
}
