//! The coordinate along traces on paper: linear, upwards or downwards, at a round magnification.

use super::traces_data::TraceRow;

/// Where places along the traces of a row lie.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Ordinate {
    middle_mm: f64,
    /// mm on paper per mm, downwards on the page.
    downwards: f64,
    /// The page's y of the middle.
    centre: f64,
}

/// Steps of a decade of magnifications.
const STEPS: [f64; 6] = [8.0, 5.0, 4.0, 2.5, 2.0, 1.0];

impl Ordinate {
    /// For all places of a row in a height about the page's y `centre`.
    pub fn of(row: &TraceRow, centre: f64, height: f64) -> Self {
        let places = row.flanks.iter().flat_map(|(_, field)| {
            let traces = field
                .traces
                .iter()
                .flat_map(|t| t.abscissa_mm.first().into_iter().chain(t.abscissa_mm.last()));
            traces.chain(field.lines.iter().map(|line| &line.at_mm))
        });
        let [lo, hi] = foundation::numerics::extremes(places.copied());
        if lo > hi {
            return Self { middle_mm: 0.0, downwards: 1.0, centre };
        }
        let magnification = largest(hi - lo, height);
        let downwards = if row.rising { -magnification } else { magnification };
        Self { middle_mm: 0.5 * (lo + hi), downwards, centre }
    }

    /// y on the page.
    pub fn y(&self, place: f64) -> f64 {
        self.centre + self.downwards * (place - self.middle_mm)
    }

    /// mm on paper per mm.
    pub fn magnification(&self) -> f64 {
        self.downwards.abs()
    }
}

/// The largest round magnification at which a length is drawn within a height.
fn largest(length: f64, height: f64) -> f64 {
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
