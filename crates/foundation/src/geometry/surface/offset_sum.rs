//! Several offsets of a surface as one.

use super::{NormalOffset, OffsetBounds};
use crate::numerics::Jet2;
use std::sync::Arc;

/// The sum of offsets along one normal.
#[derive(Clone, Debug)]
pub struct OffsetSum(
    /// What is added up.
    pub Vec<Arc<dyn NormalOffset>>,
);

impl NormalOffset for OffsetSum {
    fn jet(&self, height: f64, length: f64) -> Jet2 {
        self.0.iter().fold(Jet2::default(), |sum, part| sum + part.jet(height, length))
    }

    fn bounds(&self, heights: [f64; 2], lengths: [f64; 2]) -> OffsetBounds {
        let none = OffsetBounds { value: 0.0, by_height: 0.0, by_length: 0.0, second: [0.0; 3] };
        self.0.iter().map(|part| part.bounds(heights, lengths)).fold(none, |sum, part| OffsetBounds {
            value: sum.value + part.value,
            by_height: sum.by_height + part.by_height,
            by_length: sum.by_length + part.by_length,
            second: [0, 1, 2].map(|k| sum.second[k] + part.second[k]),
        })
    }
}
