//! The least value of a function over an interval whose parts are bounded from below: parts that cannot hold less are left alone.

/// Most parts that are divided; what is left then counts by its bound.
const MOST_PARTS: usize = 4096;

/// The least value over 0 to 1 of a function that is not negative, above it by `hidden` at most; infinite where it is not below `enough`.
///
/// `part` is given the ends of a part and the least value of interest in it. It gives the value in the middle, or any from the least of
/// interest up to it, and what no value in the part is less than. Parts are looked at from 0 upwards.
pub fn least_over(enough: f64, hidden: f64, mut part: impl FnMut([f64; 2], f64) -> [f64; 2]) -> f64 {
    let mut found = f64::INFINITY;
    let mut open = vec![[0.0, 1.0]];
    let mut divided = 0;
    while let Some([first, last]) = open.pop() {
        let [value, bound] = part([first, last], found.min(enough));
        found = found.min(value);
        if found <= 0.0 {
            return 0.0;
        }
        if bound >= found.min(enough) - hidden {
            continue;
        }
        divided += 1;
        if divided >= MOST_PARTS {
            let bounds = open.iter().map(|&left| part(left, found.min(enough))[1]);
            found = bounds.fold(found.min(bound), f64::min).max(0.0);
            break;
        }
        let middle = 0.5 * (first + last);
        open.extend([[middle, last], [first, middle]]);
    }
    if found < enough { found } else { f64::INFINITY }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// |x - 0.3| + 1 changes by no more than x does.
    fn part([first, last]: [f64; 2], _: f64) -> [f64; 2] {
        let value = (0.5 * (first + last) - 0.3).abs() + 1.0;
        [value, value - 0.5 * (last - first)]
    }

    #[test]
    fn the_least_value_is_found_as_near_as_asked() {
        for hidden in [0.1, 0.01, 1e-6] {
            let found = least_over(f64::INFINITY, hidden, part);
            assert!((1.0..=1.0 + hidden).contains(&found), "{hidden}: {found}");
        }
        assert_eq!(least_over(0.9, 0.01, part), f64::INFINITY);
    }

    #[test]
    fn what_touches_is_zero_and_what_is_never_bounded_counts_by_its_bound() {
        assert_eq!(least_over(f64::INFINITY, 0.01, |_, _| [0.0, 0.0]), 0.0);
        assert_eq!(least_over(5.0, 0.01, |_, _| [2.0, 1.0]), 1.0);
    }
}
