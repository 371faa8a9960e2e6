//! The lines of a direction that cover a rectangle of the worm flank. Knows no dresser.

use contact::DiagonalLine;

/// One line w sin(rho) + z cos(rho) = X, over t with w = X sin(rho) + t cos(rho), z = X cos(rho) - t sin(rho). mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DressingLine {
    /// Direction.
    pub direction: DiagonalLine,
    /// X.
    pub coordinate: f64,
    /// Where the line begins and ends on the flank, t; the way in which it is driven alternates from line to line.
    pub range: [f64; 2],
}

impl DressingLine {
    /// (w, z) at t.
    pub fn point(&self, t: f64) -> (f64, f64) {
        point(self.direction, self.coordinate, t)
    }
}

fn point(direction: DiagonalLine, x: f64, t: f64) -> (f64, f64) {
    let (sin, cos) = direction.rho.sin_cos();
    (x * sin + t * cos, x * cos - t * sin)
}

/// Range of X over a rectangle `[[w_0, w_1], [z_0, z_1]]`.
pub(super) fn coordinates(direction: DiagonalLine, [w, z]: [[f64; 2]; 2]) -> [f64; 2] {
    let corners = w.into_iter().flat_map(|w| z.map(|z| direction.coordinate(w, z)));
    foundation::numerics::extremes(corners)
}

/// t from where to where the line X lies in the rectangle; `None` beside it.
fn inside(direction: DiagonalLine, x: f64, area: [[f64; 2]; 2]) -> Option<[f64; 2]> {
    let (sin, cos) = direction.rho.sin_cos();
    let mut range = [f64::NEG_INFINITY, f64::INFINITY];
    for ([from, to], start, slope) in [(area[0], x * sin, cos), (area[1], x * cos, -sin)] {
        if slope.abs() < 1e-12 {
            if start < from || start > to {
                return None;
            }
            continue;
        }
        let ends = [(from - start) / slope, (to - start) / slope];
        range = [range[0].max(ends[0].min(ends[1])), range[1].min(ends[0].max(ends[1]))];
    }
    (range[0] <= range[1]).then_some(range)
}

/// Lines at pitch `pitch` that cover the rectangle, each as far as it finishes points up to half a pitch beside it and
/// `overrun` beyond. The outermost lines lie half a pitch inside.
pub(super) fn cover(
    direction: DiagonalLine,
    area: [[f64; 2]; 2],
    pitch: f64,
    overrun: f64,
) -> (f64, Vec<DressingLine>) {
    let [low, high] = coordinates(direction, area);
    let count = ((high - low) / pitch).ceil().max(1.0);
    let pitch = (high - low) / count;
    let lines = (0..count as usize).filter_map(|k| {
        let coordinate = low + (k as f64 + 0.5) * pitch;
        let beside = [-0.5, 0.0, 0.5].map(|share| inside(direction, coordinate + share * pitch, area));
        // Between them the ends run straight but for the corners of the rectangle.
        let corners = area[0].into_iter().flat_map(|w| area[1].map(|z| (w, z)));
        let within = |&(w, z): &(f64, f64)| {
            (direction.coordinate(w, z) - coordinate).abs() <= 0.5 * pitch * (1.0 + 1e-9)
        };
        let (sin, cos) = direction.rho.sin_cos();
        let at_corners = corners.filter(within).map(|(w, z)| [w * cos - z * sin; 2]);
        let found =
            beside.into_iter().flatten().chain(at_corners).reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])])?;
        Some(DressingLine { direction, coordinate, range: [found[0] - overrun, found[1] + overrun] })
    });
    (pitch, lines.collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_cover_every_point_of_the_rectangle() {
        let area = [[40.0, 47.0], [-12.0, 20.0]];
        for rho in [0.0, 0.3, -1.2, 1.5, std::f64::consts::FRAC_PI_2] {
            let direction = DiagonalLine { rho };
            let (pitch, lines) = cover(direction, area, 0.37, 0.0);
            assert!(pitch <= 0.37);
            for i in 0..=20 {
                for j in 0..=20 {
                    let (w, z) = (40.0 + 0.35 * f64::from(i), -12.0 + 1.6 * f64::from(j));
                    let (sin, cos) = rho.sin_cos();
                    let (x, t) = (direction.coordinate(w, z), w * cos - z * sin);
                    let reached = lines.iter().any(|line| {
                        (line.coordinate - x).abs() <= 0.5 * pitch + 1e-9
                            && t >= line.range[0] - 1e-9
                            && t <= line.range[1] + 1e-9
                    });
                    assert!(reached, "{rho} {w} {z}");
                    let line = DressingLine { direction, coordinate: x, range: [t, t] };
                    let (w_t, z_t) = line.point(t);
                    assert!((w_t - w).abs() < 1e-12 && (z_t - z).abs() < 1e-12);
                }
            }
            assert!(lines.iter().all(|line| line.range[1] >= line.range[0]));
        }
    }
}
