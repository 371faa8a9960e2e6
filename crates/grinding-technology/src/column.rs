//! Integrals along the face width of stock that is linear between equidistant places.

/// Mean of what lies between `low` and `high`.
pub(crate) fn mean_between(stock: &[f64], [low, high]: [f64; 2]) -> f64 {
    // Integral of the clamped value over the value itself.
    let primitive = |a: f64| {
        let inside = a.clamp(low, high) - low;
        0.5 * inside * inside + if a > high { (a - high) * (high - low) } else { 0.0 }
    };
    let cell = |pair: &[f64]| {
        let (a, b) = (pair[0], pair[1]);
        if (b - a).abs() <= 1e-9 * (high.min(1.0) - low).abs() {
            (0.5 * (a + b)).clamp(low, high) - low
        } else {
            (primitive(b) - primitive(a)) / (b - a)
        }
    };
    stock.windows(2).map(cell).sum::<f64>() / (stock.len() - 1) as f64
}

/// Integral of what lies above a level; the stock is linear between places that are so far apart.
pub(crate) fn above(stock: &[f64], lengths: &[f64], level: f64) -> f64 {
    let cell = |(pair, length): (&[f64], &f64)| {
        let (a, b) = (pair[0] - level, pair[1] - level);
        if a >= 0.0 && b >= 0.0 {
            0.5 * (a + b) * length
        } else if a <= 0.0 && b <= 0.0 {
            0.0
        } else {
            let most = a.max(b);
            0.5 * most * most / (b - a).abs() * length
        }
    };
    stock.windows(2).zip(lengths).map(cell).sum()
}

/// The squares of reaches, in slices, that lie in each slice.
pub(crate) fn in_slices(reaches: impl Iterator<Item = f64>, slices: usize) -> Vec<f64> {
    let mut amounts = vec![0.0; slices];
    let mut ending = vec![0.0; slices];
    for far in reaches.filter(|far| *far > 0.0) {
        // A slice that a reach ends in has a part of its own, those below are whole.
        let last = (far as usize).min(slices - 1);
        ending[last] += 1.0;
        amounts[last] += far * far - (last * last) as f64;
    }
    let mut beyond = 0.0;
    for n in (0..slices).rev() {
        amounts[n] += beyond * (2 * n + 1) as f64;
        beyond += ending[n];
    }
    amounts
}

/// Section that goes per feed: the integral of H D over the places with 0 < D and H D^2/2 below the depth of cut. `reach` are the distances
/// sqrt(2 a_e/H) along the face width, `ahead` is D at its first place and D at its last.
pub(crate) fn section(reach: &[f64], ahead: [f64; 2], curvature: f64) -> f64 {
    let cells = reach.len() - 1;
    let at = |k: usize| ahead[0] + (ahead[1] - ahead[0]) * k as f64 / cells as f64;
    let most = reach.iter().copied().fold(0.0, f64::max);
    // Cells in which D comes between 0 and the largest reach.
    let place = |d: f64| (d - ahead[0]) / (ahead[1] - ahead[0]) * cells as f64;
    let (a, b) = (place(0.0), place(most));
    let (from, to) = (a.min(b).floor(), a.max(b).ceil());
    if !(to > 0.0 && from < cells as f64) {
        return 0.0;
    }
    // Clamped to the column.
    let (from, to) = (from.max(0.0) as usize, to.min(cells as f64) as usize);
    let sum: f64 = (from..to).map(|k| cell((at(k), reach[k]), (at(k + 1), reach[k + 1]))).sum();
    // D runs with z, up or down: H/2 times the squares at the ends of what is cut.
    0.5 * curvature * sum
}

/// |D^2| between the ends of the part of a cell where 0 < D < reach.
fn cell((d_0, reach_0): (f64, f64), (d_1, reach_1): (f64, f64)) -> f64 {
    if reach_0 <= 0.0 && reach_1 <= 0.0 {
        return 0.0;
    }
    let (mut from, mut to) = (0.0_f64, 1.0_f64);
    for (a, b) in [(d_0, d_1), (reach_0 - d_0, reach_1 - d_1)] {
        // Where a + t (b - a) > 0.
        if a <= 0.0 && b <= 0.0 {
            return 0.0;
        }
        if a < 0.0 {
            from = from.max(a / (a - b));
        } else if b < 0.0 {
            to = to.min(a / (a - b));
        }
    }
    if to <= from {
        return 0.0;
    }
    let at = |t: f64| d_0 + t * (d_1 - d_0);
    (at(to).powi(2) - at(from).powi(2)).abs()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_lies_between_is_exact_for_lines() {
        // 0 to 4, between 1 and 2: half of what is above 1 counts whole.
        assert!((mean_between(&[0.0, 4.0], [1.0, 2.0]) - (0.25 * 0.5 + 0.5 * 1.0)).abs() < 1e-15);
        assert!((mean_between(&[4.0, 0.0], [1.0, f64::INFINITY]) - 0.25 * 3.0 * 1.5).abs() < 1e-15);
        assert_eq!(mean_between(&[0.5, 0.5, 0.5], [1.0, 2.0]), 0.0);
        assert_eq!(mean_between(&[1.5, 1.5], [1.0, 2.0]), 0.5);
    }

    #[test]
    fn what_lies_above_is_exact_for_lines() {
        // 0 to 4 over 2 mm: above 1 a triangle of 3 over 1.5 mm; then level at 4.
        let of = |level: f64| above(&[0.0, 4.0, 4.0], &[2.0, 0.5], level);
        assert!((of(1.0) - (0.5 * 3.0 * 1.5 + 3.0 * 0.5)).abs() < 1e-15);
        assert_eq!([of(5.0), above(&[-1.0, -2.0], &[1.0], 0.0)], [0.0; 2]);
        // A band is what lies above its lower end less what lies above its upper one.
        let stock = [0.0, 4.0, 2.5, 1.5];
        let of = |level: f64| above(&stock, &[0.5; 3], level);
        assert!((of(1.0) - of(2.0) - 1.5 * mean_between(&stock, [1.0, 2.0])).abs() < 1e-15);
    }

    #[test]
    fn a_section_inside_the_stock_is_the_depth_of_cut() {
        let (curvature, depth) = (0.002, 0.07);
        let reach = f64::sqrt(2.0 * depth / curvature);
        let whole = section(&[reach; 41], [20.0, -20.0], curvature);
        assert!((whole - depth).abs() < 1e-15);
        let entering = section(&[reach; 2], [3.0, -37.0], curvature);
        assert!((entering - 0.5 * curvature * 9.0).abs() < 1e-15);
        // Upwards as downwards, and nothing where the contact is not on the face.
        let upwards = section(&[reach; 41], [-20.0, 20.0], curvature);
        assert!((upwards - depth).abs() < 1e-15);
        assert_eq!(section(&[reach; 41], [90.0, 50.0], curvature), 0.0);
        assert_eq!(section(&[reach; 41], [-1.0, -41.0], curvature), 0.0);
    }
}
