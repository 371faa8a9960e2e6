//! Magnifications of charts on paper, as gear measuring machines print them, and the round lengths that bars stand for.

use super::numbers::format_significant;

/// What gear measuring machines print, the largest first.
const USUAL: [f64; 3] = [2000.0, 1000.0, 500.0];

/// The largest usual magnification at which a deviation (um) is drawn within a room (mm); a smaller round one where even 500:1 does not
/// do.
pub fn of_traces(um: f64, room: f64) -> f64 {
    let fits = |magnification: &f64| drawn(um, *magnification) <= room;
    USUAL.into_iter().find(|m| fits(m)).unwrap_or_else(|| from_500(um, room))
}

/// 500:1, or a smaller round magnification at which a deviation (um) is drawn within a room (mm).
pub fn from_500(um: f64, room: f64) -> f64 {
    let mut decade = 100.0;
    loop {
        for step in [5.0, 2.0, 1.0] {
            // Sums of a decade's powers of ten would drift: one product each.
            let magnification = step * decade;
            if drawn(um, magnification) <= room {
                return magnification;
            }
        }
        decade /= 10.0;
    }
}

/// Length of a deviation (um) on paper, mm.
pub fn drawn(um: f64, magnification: f64) -> f64 {
    1e-3 * um * magnification
}

/// `500:1`, or `1:20` for what is made smaller.
pub fn words(magnification: f64) -> String {
    if magnification >= 1.0 {
        format!("{}:1", format_significant(magnification, 3))
    } else {
        format!("1:{}", format_significant(1.0 / magnification, 3))
    }
}

/// A round length for a bar: `usual` or that times a power of ten, so that it is between `least` and ten times that on paper; with its
/// length there. `per_unit` is the length of a unit on paper, mm.
pub fn bar(usual: f64, per_unit: f64, least: f64) -> (f64, f64) {
    let mut decades = 0;
    while usual * 10f64.powi(decades) * per_unit < least {
        decades += 1;
    }
    while usual * 10f64.powi(decades) * per_unit >= 10.0 * least {
        decades -= 1;
    }
    let length = usual * 10f64.powi(decades);
    (length, length * per_unit)
}

/// Steps of a decade of magnifications.
const STEPS: [f64; 6] = [8.0, 5.0, 4.0, 2.5, 2.0, 1.0];

/// The largest round magnification at which a length is drawn within a height.
pub fn largest(length: f64, height: f64) -> f64 {
    let decades = if length > 0.0 { (height / length).log10().floor() } else { 0.0 };
    // Rounding may have put the decade one too high or too low.
    let tried = [1.0, 0.0, -1.0].into_iter().flat_map(|k| STEPS.map(|step| step * 10f64.powf(decades + k)));
    let fits = |magnification: &f64| length * magnification <= height * (1.0 + 1e-12);
    tried.into_iter().find(fits).unwrap_or(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_largest_magnification_that_fits_is_taken() {
        for (um, want) in
            [(0.0, 2000.0), (3.0, 2000.0), (3.1, 1000.0), (6.0, 1000.0), (6.1, 500.0), (12.0, 500.0)]
        {
            assert_eq!(of_traces(um, 6.0), want, "{um}");
        }
        for (um, want) in [(12.1, 200.0), (31.0, 100.0), (61.0, 50.0), (1e4, 0.5), (1e12, 5e-9)] {
            assert!((of_traces(um, 6.0) / want - 1.0).abs() < 1e-12, "{um}");
        }
        assert_eq!((words(500.0), words(0.05)), ("500:1".into(), "1:20".into()));
    }

    #[test]
    fn bars_are_round_and_of_a_length_that_is_seen() {
        for (per_unit, want) in
            [(0.5, 10.0), (2.0, 10.0), (0.1, 100.0), (25.0, 0.1), (24.0, 1.0), (1e-9, 1e10)]
        {
            let (length, drawn) = bar(10.0, per_unit, 2.5);
            assert!((length / want - 1.0).abs() < 1e-12 && (2.5..25.0).contains(&drawn), "{per_unit}");
        }
    }

    #[test]
    fn the_coordinate_fills_its_height_at_a_round_magnification() {
        for (length, want) in
            [(4.3, 10.0), (4.4, 8.0), (17.0, 2.5), (43.0, 1.0), (300.0, 0.1), (0.043, 1000.0)]
        {
            assert!(
                (largest(length, 43.0) / want - 1.0).abs() < 1e-12,
                "{length}: {}",
                largest(length, 43.0)
            );
        }
        assert!(largest(1e-12, 43.0).is_finite() && largest(1e12, 43.0) > 0.0 && largest(0.0, 43.0) > 0.0);
    }
}
