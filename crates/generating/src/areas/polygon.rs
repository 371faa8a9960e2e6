//! Convex polygons in a plane: clipping by half planes and the range of a linear function. Knows no flank.

/// A corner (w, z), mm.
pub(super) type Corner = [f64; 2];

/// The part of a convex polygon on which `inside` (linear) is not negative.
pub(super) fn clip(polygon: &[Corner], inside: impl Fn(Corner) -> f64) -> Vec<Corner> {
    let mut kept = Vec::with_capacity(polygon.len() + 1);
    for (k, &b) in polygon.iter().enumerate() {
        let a = polygon[(k + polygon.len() - 1) % polygon.len()];
        let (fa, fb) = (inside(a), inside(b));
        if (fa < 0.0) != (fb < 0.0) {
            let t = fa / (fa - fb);
            kept.push([a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])]);
        }
        if fb >= 0.0 {
            kept.push(b);
        }
    }
    kept
}

/// Least and largest value; `None` of nothing.
pub(super) fn range(values: impl Iterator<Item = f64>) -> Option<[f64; 2]> {
    values.fold(None, |range, x| {
        let [lo, hi] = range.unwrap_or([x, x]);
        Some([x.min(lo), x.max(hi)])
    })
}

/// The rectangle [w0, w1] x [z0, z1].
pub(super) fn rectangle([w0, w1]: [f64; 2], [z0, z1]: [f64; 2]) -> Vec<Corner> {
    vec![[w0, z0], [w1, z0], [w1, z1], [w0, z1]]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn area(polygon: &[Corner]) -> f64 {
        let next = |k: usize| polygon[(k + 1) % polygon.len()];
        let twice: f64 = polygon.iter().enumerate().map(|(k, p)| p[0] * next(k)[1] - next(k)[0] * p[1]).sum();
        0.5 * twice
    }

    #[test]
    fn two_clips_share_the_polygon_between_them() {
        let square = rectangle([0.0, 2.0], [-1.0, 1.0]);
        for c in [-5.0, -2.9, -0.3, 0.0, 1.0, 2.9, 5.0] {
            let line = |p: Corner| p[0] + 2.0 * p[1] - c;
            let (above, below) = (clip(&square, line), clip(&square, |p| -line(p)));
            assert!((area(&above) + area(&below) - 4.0).abs() < 1e-14, "{c}");
            assert!(above.iter().all(|&p| line(p) >= -1e-14));
        }
        assert!(clip(&square, |p| p[0] - 3.0).is_empty());
        assert_eq!(range(std::iter::empty()), None);
        assert_eq!(range([3.0, -1.0, 2.0].into_iter()), Some([-1.0, 3.0]));
    }
}
