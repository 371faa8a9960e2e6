//! Hatching as lines, because a pattern would need an identifier that is unique on the page.

/// Which way hatching lines lean, seen on the page.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lean {
    /// Like a slash: rising to the right.
    Forward,
    /// Like a backslash.
    Backward,
}

/// Lines at 45 degrees, `pitch` apart (along the page's axes), clipped to closed loops by the even-odd rule.
pub fn hatch_lines(loops: &[Vec<[f64; 2]>], pitch: f64, lean: Lean) -> Vec<Vec<[f64; 2]>> {
    // A backslash is a slash in the mirrored page.
    let side = if lean == Lean::Forward { 1.0 } else { -1.0 };
    let sums = loops.iter().flatten().map(|p| side * p[0] + p[1]);
    let (lo, hi) = sums.fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), s| (lo.min(s), hi.max(s)));
    if hi <= lo {
        return Vec::new();
    }
    let mut lines = Vec::new();
    for k in (lo / pitch).ceil() as i64..=(hi / pitch).floor() as i64 {
        let sum = k as f64 * pitch;
        let mut cuts: Vec<f64> = Vec::new();
        for pair in loops.iter().flat_map(|line| line.windows(2)) {
            let (x, y) = ([side * pair[0][0], side * pair[1][0]], [pair[0][1], pair[1][1]]);
            let (a, b) = (x[0] + y[0] - sum, x[1] + y[1] - sum);
            if (a < 0.0) != (b < 0.0) {
                cuts.push(x[0] + a / (a - b) * (x[1] - x[0]));
            }
        }
        cuts.sort_by(f64::total_cmp);
        for ends in cuts.chunks_exact(2) {
            if ends[1] - ends[0] > 0.8 {
                lines.push(ends.iter().map(|&x| [side * x, sum - x]).collect());
            }
        }
    }
    lines
}
