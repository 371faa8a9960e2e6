//! From a floating position to whole counts.

use crate::Error;

/// Greatest magnitude of a position, exclusive: 2^62 counts.
const RANGE: f64 = (1u64 << 62) as f64;

/// From here on every number is whole, and adding a half would round to the even neighbour instead of doing nothing.
const WHOLE: f64 = (1u64 << 52) as f64;

/// floor(v + 0.5), the rule of `docs/mathematics/gearbox.md#couplings`.
pub(super) fn nearest_count(name: &'static str, value: f64) -> Result<i64, Error> {
    let counts = if value.abs() < WHOLE { libm::floor(value + 0.5) } else { value };
    if counts.abs() < RANGE {
        Ok(counts as i64)
    } else {
        // Casts saturate; NaN becomes 0 and never gets here from a finite coupling.
        Err(Error::GearRange { name, value: counts as i64 })
    }
}

#[cfg(test)]
mod tests {
    use super::nearest_count;

    #[test]
    fn halves_are_rounded_up() {
        for (value, counts) in [(0.0, 0), (0.5, 1), (-0.5, 0), (1.49, 1), (-1.5, -1), (-1.51, -2)] {
            assert_eq!(nearest_count("v", value), Ok(counts));
        }
    }

    #[test]
    fn whole_numbers_beyond_the_fraction_bits_stay() {
        let odd = (1i64 << 52) + 1;
        assert_eq!(nearest_count("v", odd as f64), Ok(odd));
        assert_eq!(nearest_count("v", -odd as f64), Ok(-odd));
    }

    #[test]
    fn the_range_ends_at_2_to_the_62() {
        let limit = (1i64 << 62) as f64;
        assert_eq!(nearest_count("v", limit.next_down()), Ok((1 << 62) - 512));
        for beyond in [limit, -limit, f64::INFINITY, f64::NAN] {
            assert!(nearest_count("v", beyond).is_err());
        }
    }
}
