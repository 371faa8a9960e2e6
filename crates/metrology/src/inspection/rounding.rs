//! Rounding of values and tolerances as sheets and the standard print them (`docs/mathematics/inspection.md`).

/// The multiple of `quantum` nearest to a value; halves go away from zero, also those that arithmetic has missed by a little.
pub fn round_to(value: f64, quantum: f64) -> f64 {
    (quantum * (value.abs() / quantum + 0.5 + 1e-9).floor()).copysign(value)
}

/// A tolerance of ISO 1328-1 in um as the standard states it: above 10 whole, from 5 to 10 half, below 5 tenths of a micrometre.
pub(super) fn round_tolerance(um: f64) -> f64 {
    let quantum = if um > 10.0 {
        1.0
    } else if um >= 5.0 {
        0.5
    } else {
        0.1
    };
    round_to(um, quantum)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn halves_go_away_from_zero() {
        for (value, quantum, want) in [
            (2.5, 1.0, 3.0),
            (-2.5, 1.0, -3.0),
            (2.49, 1.0, 2.0),
            (0.15, 0.1, 0.2),
            (-0.85, 0.1, -0.9),
            (0.0, 0.1, 0.0),
        ] {
            assert!((round_to(value, quantum) - want).abs() < 1e-12, "{value}");
        }
    }

    #[test]
    fn tolerances_are_rounded_by_their_size() {
        for (um, want) in [
            (10.49, 10.0),
            (10.5, 11.0),
            (10.0, 10.0),
            (9.76, 10.0),
            (5.0, 5.0),
            (6.3, 6.5),
            (4.96, 5.0),
            (4.94, 4.9),
        ] {
            assert!((round_tolerance(um) - want).abs() < 1e-12, "{um}");
        }
    }
}
