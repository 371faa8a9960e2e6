//! Fewer points for the same picture. Knows places on the page only.

/// A line on the page with fewer points: in every column of the page the first, the lowest, the highest and the last point stay,
/// and of those only what a straight line misses by more than `tolerance`. Peaks keep their height to that tolerance. Points go
/// from left to right; `column` and `tolerance` are lengths on the page.
pub fn thinned(points: &[[f64; 2]], column: f64, tolerance: f64) -> Vec<[f64; 2]> {
    straightened(&by_columns(points, column), tolerance)
}

/// At most four points a column.
fn by_columns(points: &[[f64; 2]], column: f64) -> Vec<[f64; 2]> {
    let number = |p: &[f64; 2]| (p[0] / column).floor();
    let mut kept = Vec::new();
    for group in points.chunk_by(|a, b| number(a) == number(b)) {
        let extreme = |sign: f64| {
            (0..group.len()).max_by(|&a, &b| (sign * group[a][1]).total_cmp(&(sign * group[b][1])))
        };
        let mut places: Vec<usize> = [Some(0), extreme(1.0), extreme(-1.0), group.len().checked_sub(1)]
            .into_iter()
            .flatten()
            .collect();
        places.sort_unstable();
        places.dedup();
        kept.extend(places.into_iter().map(|k| group[k]));
    }
    kept
}

/// Without the points that lie on the line between those that stay (Ramer, Douglas and Peucker).
fn straightened(points: &[[f64; 2]], tolerance: f64) -> Vec<[f64; 2]> {
    let Some(last) = points.len().checked_sub(1) else { return Vec::new() };
    let mut stays = vec![false; points.len()];
    stays[0] = true;
    stays[last] = true;
    let mut stretches = vec![(0, last)];
    while let Some((from, to)) = stretches.pop() {
        let distance = |k: usize| distance(points[k], points[from], points[to]);
        let farthest = (from + 1..to).max_by(|&a, &b| distance(a).total_cmp(&distance(b)));
        let Some(middle) = farthest.filter(|&k| distance(k) > tolerance) else { continue };
        stays[middle] = true;
        stretches.extend([(from, middle), (middle, to)]);
    }
    points.iter().zip(stays).filter(|(_, stays)| *stays).map(|(p, _)| *p).collect()
}

/// Distance of a point from the line between two others.
fn distance(p: [f64; 2], a: [f64; 2], b: [f64; 2]) -> f64 {
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    let square = dx * dx + dy * dy;
    let share =
        if square > 0.0 { (((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / square).clamp(0.0, 1.0) } else { 0.0 };
    (p[0] - a[0] - share * dx).hypot(p[1] - a[1] - share * dy)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_trace_becomes_short_and_keeps_its_peaks() {
        let count = 20_000;
        let points: Vec<[f64; 2]> = (0..count)
            .map(|k| {
                let x = 300.0 * f64::from(k) / f64::from(count);
                let peak = match k {
                    7_777 => 40.0,
                    12_345 => -30.0,
                    _ => 0.0,
                };
                [x, 20.0 * (x / 40.0).sin() + peak]
            })
            .collect();
        let short = thinned(&points, 1.0, 0.05);
        assert!(short.len() < 400, "{}", short.len());
        for k in [0, 7_777, 12_345, points.len() - 1] {
            assert!(short.contains(&points[k]), "{k}");
        }
        assert!(short.windows(2).all(|pair| pair[0][0] <= pair[1][0]));
        // No point of the long trace lies off the short one by more than a column and the tolerance.
        for p in &points {
            let off =
                short.windows(2).map(|pair| distance(*p, pair[0], pair[1])).fold(f64::INFINITY, f64::min);
            assert!(off < 1.05, "{p:?}: {off}");
        }
    }

    #[test]
    fn straight_lines_need_their_ends_only() {
        let line: Vec<[f64; 2]> = (0..1000).map(|k| [0.3 * f64::from(k), 5.0]).collect();
        assert_eq!(thinned(&line, 1.0, 0.05), [line[0], line[999]]);
        assert_eq!(thinned(&[], 1.0, 0.05), Vec::<[f64; 2]>::new());
        assert_eq!(thinned(&[[2.0, 3.0]], 1.0, 0.05), [[2.0, 3.0]]);
        assert_eq!(thinned(&[[2.0, 3.0]; 5], 1.0, 0.05), [[2.0, 3.0]; 2]);
    }
}
