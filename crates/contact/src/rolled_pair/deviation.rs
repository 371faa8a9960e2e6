//! What a made flank has beside the wanted one, on a grid.

/// Material beyond a flank, along its normal, on a grid over height and length; between the places it is bilinear. mm.
#[derive(Clone, Debug, PartialEq)]
pub struct FlankDeviation {
    heights: [f64; 2],
    lengths: [f64; 2],
    counts: [usize; 2],
    /// Row-major [height][length]; NaN where nothing is known.
    values: Vec<f64>,
    range: [f64; 2],
}

impl FlankDeviation {
    /// Values on even steps from root to tip and over the lengths, row-major [height][length], > 0 material; `None` where nothing is
    /// known. `None` unless there are two rows and columns of them and one value is known.
    pub fn new(
        heights: [f64; 2],
        lengths: [f64; 2],
        counts: [usize; 2],
        values: &[Option<f64>],
    ) -> Option<Self> {
        let known = values.iter().flatten().copied().filter(|value| value.is_finite());
        let range = foundation::numerics::extremes(known);
        if counts.iter().any(|count| *count < 2)
            || values.len() != counts[0] * counts[1]
            || range[0] > range[1]
        {
            return None;
        }
        let values = values.iter().map(|value| value.unwrap_or(f64::NAN)).collect();
        Some(Self { heights, lengths, counts, values, range })
    }

    /// Least and greatest value.
    pub fn range(&self) -> [f64; 2] {
        self.range
    }

    /// Rows and columns.
    pub fn counts(&self) -> [usize; 2] {
        self.counts
    }

    /// The deviation at a place; `None` where a value beside it is not known. Beyond an end it stays what it is there.
    pub fn at(&self, [height, length]: [f64; 2]) -> Option<f64> {
        let cell = |[from, to]: [f64; 2], x: f64, count: usize| {
            let position = ((x - from) / (to - from)).clamp(0.0, 1.0) * (count - 1) as f64;
            let first = (position as usize).min(count - 2);
            (first, position - first as f64)
        };
        let (i, up) = cell(self.heights, height, self.counts[0]);
        let (j, along) = cell(self.lengths, length, self.counts[1]);
        let row = |i: usize| {
            let at = i * self.counts[1] + j;
            let [a, b] = [self.values[at], self.values[at + 1]];
            // A place on the grid does not need what is beside it.
            if along == 0.0 {
                a
            } else if along == 1.0 {
                b
            } else {
                a + along * (b - a)
            }
        };
        let value = match up {
            0.0 => row(i),
            1.0 => row(i + 1),
            _ => row(i) + up * (row(i + 1) - row(i)),
        };
        value.is_finite().then_some(value)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_plane_is_itself_between_places_and_unknown_values_stay_unknown() {
        let plane = |a: f64, b: f64| 3.0 * a - 2.0 * b;
        let mut values = Vec::new();
        for i in 0..3 {
            for j in 0..4 {
                values.push(Some(plane(1.0 + 0.5 * f64::from(i), f64::from(j))));
            }
        }
        values[11] = None;
        let field = FlankDeviation::new([1.0, 2.0], [0.0, 3.0], [3, 4], &values).unwrap();
        assert!((field.at([1.3, 1.7]).unwrap() - plane(1.3, 1.7)).abs() < 1e-12);
        assert_eq!(field.at([2.0, 2.0]), Some(plane(2.0, 2.0)));
        assert_eq!(field.at([1.9, 2.5]), None);
        assert_eq!(field.at([1.5, 3.0]), Some(plane(1.5, 3.0)));
        assert!(FlankDeviation::new([1.0, 2.0], [0.0, 3.0], [1, 4], &values).is_none());
        assert!(FlankDeviation::new([1.0, 2.0], [0.0, 3.0], [3, 4], &[None; 12]).is_none());
    }
}
