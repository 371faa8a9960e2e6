//! The numbers of one bound, their product, and the scaling of slacks and multipliers of Nesterov and Todd.

/// The numbers of a bound: one, two or three, the others 0.
pub(super) type Part = [f64; 3];
/// The unit of their product.
pub(super) const UNIT: Part = [1.0, 0.0, 0.0];

pub(super) fn dot(a: &Part, b: &Part) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// |b| of a vector (a, b).
pub(super) fn length(v: &Part) -> f64 {
    (v[1] * v[1] + v[2] * v[2]).sqrt()
}

/// a^2 - |b|^2 of a vector (a, b).
fn determinant(v: &Part) -> f64 {
    let length = length(v);
    (v[0] - length) * (v[0] + length)
}

pub(super) fn plus(a: &Part, by: f64, b: &Part) -> Part {
    [a[0] + by * b[0], a[1] + by * b[1], a[2] + by * b[2]]
}

/// The Jordan product; of numbers, their product.
pub(super) fn product(a: &Part, b: &Part) -> Part {
    [dot(a, b), a[0] * b[1] + b[0] * a[1], a[0] * b[2] + b[0] * a[2]]
}

/// q with l o q = d.
pub(super) fn quotient(l: &Part, d: &Part) -> Part {
    let first = (l[0] * d[0] - l[1] * d[1] - l[2] * d[2]) / determinant(l);
    [first, (d[1] - first * l[1]) / l[0], (d[2] - first * l[2]) / l[0]]
}

/// The largest step with v + step d inside the cone.
pub(super) fn longest(v: &Part, d: &Part) -> f64 {
    let (a, b, c) = (determinant(d), v[0] * d[0] - v[1] * d[1] - v[2] * d[2], determinant(v));
    let root = (b * b - a * c).max(0.0).sqrt();
    // A step that is longer than wide leaves the cone if it goes back, for b is negative then.
    if a < 0.0 || b < 0.0 { c.max(0.0) / (root - b) } else { f64::INFINITY }
}

/// The scaling W = size [a, b; b, 1 + b b^T/(1 + a)] of one bound: W z = W^-1 s.
pub(super) struct Scaling {
    size: f64,
    direction: Part,
}

impl Scaling {
    /// That changes nothing.
    pub(super) const NONE: Self = Self { size: 1.0, direction: UNIT };

    pub(super) fn new(s: &Part, z: &Part) -> Self {
        let (of_s, of_z) = (determinant(s).max(f64::MIN_POSITIVE), determinant(z).max(f64::MIN_POSITIVE));
        let (s, z) = (s.map(|x| x / of_s.sqrt()), z.map(|x| x / of_z.sqrt()));
        let middle = (0.5 * (1.0 + dot(&s, &z))).sqrt();
        let direction = [s[0] + z[0], s[1] - z[1], s[2] - z[2]].map(|x| 0.5 * x / middle);
        Self { size: (of_s / of_z).sqrt().sqrt(), direction }
    }

    /// W v, or W^-1 v for a sign of -1.
    pub(super) fn apply(&self, sign: f64, v: &Part) -> Part {
        let [a, b, c] = [self.direction[0], sign * self.direction[1], sign * self.direction[2]];
        let along = b * v[1] + c * v[2];
        let more = v[0] + along / (1.0 + a);
        let by = if sign > 0.0 { self.size } else { self.size.recip() };
        [by * (a * v[0] + along), by * (v[1] + b * more), by * (v[2] + c * more)]
    }

    /// W^-2, symmetric.
    pub(super) fn inverse_square(&self) -> [Part; 3] {
        let [a, b, c] = self.direction;
        let by = (self.size * self.size).recip();
        let (first, second, mixed) = (-2.0 * a * b * by, -2.0 * a * c * by, 2.0 * b * c * by);
        [
            [(a * a + b * b + c * c) * by, first, second],
            [first, (1.0 + 2.0 * b * b) * by, mixed],
            [second, mixed, (1.0 + 2.0 * c * c) * by],
        ]
    }
}
