//! Stock as a table: amounts on a grid of lengths of roll and axial places, for all spaces alike or for each.

use super::TechnologyError;
use super::error::in_range;

/// Amounts on a grid, bilinear between its places, beyond its rim as on it. mm.
#[derive(Clone, Debug, PartialEq)]
pub struct StockMap {
    w: Vec<f64>,
    z: Vec<f64>,
    /// [space][w][z]; one space where all are alike.
    spaces: Vec<Vec<f64>>,
}

/// The places of the grid around a point, and their shares in it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Around {
    places: [usize; 4],
    shares: [f64; 4],
}

impl Around {
    /// The amount of a space.
    pub fn of(&self, space: &[f64]) -> f64 {
        self.places.iter().zip(self.shares).map(|(&place, share)| share * space[place]).sum()
    }
}

impl StockMap {
    /// Amounts `[space][w][z]` at lengths of roll and axial places, each rising; one space for all alike.
    ///
    /// # Errors
    /// `OutOfRange` for places that do not rise, amounts that are not finite or not one for each place of the grid.
    pub fn new(w: Vec<f64>, z: Vec<f64>, spaces: Vec<Vec<f64>>) -> Result<Self, TechnologyError> {
        for (field, places) in [("stock.map.w_mm", &w), ("stock.map.z_mm", &z)] {
            in_range(field, places.len() as f64, !places.is_empty(), "at least one place")?;
            for pair in places.windows(2) {
                in_range(field, pair[1], pair[1] > pair[0], &format!("> {}", pair[0]))?;
            }
            for &place in places {
                in_range(field, place, place.is_finite(), "a finite number")?;
            }
        }
        in_range("stock.map.space", spaces.len() as f64, !spaces.is_empty(), "at least one space")?;
        let count = w.len() * z.len();
        for space in &spaces {
            let allowed = format!("{count} amounts, one for each place of the grid");
            in_range("stock.map.um", space.len() as f64, space.len() == count, &allowed)?;
            for &amount in space {
                in_range("stock.map.um", 1e3 * amount, amount.is_finite(), "a finite number")?;
            }
        }
        Ok(Self { w, z, spaces })
    }

    /// Spaces that differ: 1 where all are alike.
    pub fn spaces(&self) -> usize {
        self.spaces.len()
    }

    /// Lengths of roll of the grid, between which the slope jumps, mm.
    pub(crate) fn rolls(&self) -> &[f64] {
        &self.w
    }

    /// Axial places of the grid, between which the slope jumps, mm.
    pub(crate) fn faces(&self) -> &[f64] {
        &self.z
    }

    pub(crate) fn of_space(&self, k: usize) -> &[f64] {
        &self.spaces[k.min(self.spaces.len() - 1)]
    }

    pub(crate) fn around(&self, w: f64, z: f64) -> Around {
        let (i, s) = between(&self.w, w);
        let (j, t) = between(&self.z, z);
        let columns = self.z.len();
        let next = |k: usize, count: usize| (k + 1).min(count - 1);
        let (i_1, j_1) = (next(i, self.w.len()), next(j, columns));
        Around {
            places: [i * columns + j, i * columns + j_1, i_1 * columns + j, i_1 * columns + j_1],
            shares: [(1.0 - s) * (1.0 - t), (1.0 - s) * t, s * (1.0 - t), s * t],
        }
    }
}

/// The place at or below `x` and how far `x` is on to the next, 0 to 1; held at both ends.
fn between(places: &[f64], x: f64) -> (usize, f64) {
    let above = places.partition_point(|place| *place <= x);
    match above.checked_sub(1) {
        None => (0, 0.0),
        Some(below) if above == places.len() => (below, 0.0),
        Some(below) => (below, (x - places[below]) / (places[above] - places[below])),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn amounts_are_bilinear_and_held_beyond_the_rim() {
        let map = StockMap::new(
            vec![1.0, 3.0],
            vec![-5.0, 0.0, 5.0],
            vec![vec![0.1, 0.2, 0.3, 0.5, 0.6, 0.7], vec![1.0; 6]],
        )
        .unwrap();
        let at = |w: f64, z: f64, k: usize| map.around(w, z).of(map.of_space(k));
        for (w, z, want) in [
            (1.0, -5.0, 0.1),
            (2.0, 0.0, 0.4),
            (2.0, 2.5, 0.45),
            (3.0, 5.0, 0.7),
            (0.0, -9.0, 0.1),
            (9.0, 9.0, 0.7),
            (9.0, 2.5, 0.65),
        ] {
            assert!((at(w, z, 0) - want).abs() < 1e-15, "{w} {z}: {}", at(w, z, 0));
            assert!((at(w, z, 1) - 1.0).abs() < 1e-15);
        }
        for (w, z, spaces) in [
            (vec![1.0, 1.0], vec![0.0], vec![vec![0.1, 0.1]]),
            (vec![1.0], vec![0.0], vec![vec![0.1, 0.1]]),
            (vec![1.0], vec![0.0], vec![vec![f64::NAN]]),
            (vec![1.0], vec![], vec![vec![]]),
            (vec![1.0], vec![0.0], vec![]),
        ] {
            assert!(matches!(StockMap::new(w, z, spaces), Err(TechnologyError::OutOfRange { .. })));
        }
    }
}
