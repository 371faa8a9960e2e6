//! Spreading the wear along the cutter (`docs/mathematics/milling.md#cutter-location`): every row touches at a height of its own, within
//! what root and opposite flank allow; the flank stays the same.

use super::MillingError;

/// How contact heights are given to rows. mm.
#[derive(Clone, Debug, PartialEq)]
pub enum HeightRule {
    /// One height for all rows.
    Fixed(f64),
    /// From the first row to the last one, linear in the row's number.
    Ramp([f64; 2]),
    /// The caller's own, one for each row.
    Free(Vec<f64>),
}

/// Contact heights that a row allows, mm above the tip.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HeightWindow {
    /// Where the straight side begins: the corner radius.
    pub least: f64,
    /// The least of cutting length, root and opposite flank.
    pub greatest: f64,
}

impl HeightRule {
    /// What the rule asks for in a row, whatever its window; `None` where the list has no such row.
    pub fn wanted(&self, row: usize, rows: usize) -> Option<f64> {
        match self {
            Self::Fixed(height) => Some(*height),
            Self::Ramp([from, to]) => {
                Some(from + (to - from) * row as f64 / rows.saturating_sub(1).max(1) as f64)
            }
            Self::Free(heights) => heights.get(row).copied(),
        }
    }

    /// The height of every row, kept inside the rows' windows.
    ///
    /// # Errors
    /// [`MillingError::WearWindow`] for a row whose window is empty; [`MillingError::HeightCount`] for a list of another length;
    /// [`MillingError::HeightOutside`] for a height of the caller's that its row does not allow.
    pub fn heights(&self, windows: &[HeightWindow]) -> Result<Vec<f64>, MillingError> {
        let rows = windows.len();
        if let Self::Free(heights) = self
            && heights.len() != rows
        {
            return Err(MillingError::HeightCount { given: heights.len(), rows });
        }
        let height = |(row, window): (usize, &HeightWindow)| {
            let HeightWindow { least, greatest } = *window;
            if greatest < least {
                return Err(MillingError::WearWindow { row, least, greatest });
            }
            let height = self.wanted(row, rows).unwrap_or(least);
            let free = matches!(self, Self::Free(_));
            if free && !(least..=greatest).contains(&height) {
                return Err(MillingError::HeightOutside { row, height, least, greatest });
            }
            Ok(height.clamp(least, greatest))
        };
        windows.iter().enumerate().map(height).collect()
    }
}

/// Path in contact per length of the cutting edge, in bins along the edge.
#[derive(Clone, Debug, PartialEq)]
pub struct WearHistogram {
    /// Length of a bin, mm.
    pub bin: f64,
    /// Load of every bin from the tip upwards, m of path per mm of edge.
    pub load: Vec<f64>,
}

/// A row's load on the edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RowLoad {
    /// Contact height, mm.
    pub height: f64,
    /// Height of the band that the row loads: the distance of rows, mm.
    pub band: f64,
    /// Length of the path, mm.
    pub length: f64,
}

impl WearHistogram {
    /// The histogram of rows over an edge of this height: every row loads its band evenly with its length.
    pub fn new(rows: &[RowLoad], height: f64, bin: f64) -> Self {
        let bins = (height / bin).ceil().max(1.0) as usize;
        let mut load = vec![0.0; bins];
        for row in rows {
            let (from, to) = (row.height - 0.5 * row.band, row.height + 0.5 * row.band);
            for (k, load) in load.iter_mut().enumerate() {
                let (low, high) = (k as f64 * bin, (k + 1) as f64 * bin);
                let covered = (to.min(high) - from.max(low)).max(0.0);
                // A metre of path on the share of the bin that the band covers.
                *load += 1e-3 * row.length * covered / (row.band * bin);
            }
        }
        Self { bin, load }
    }

    /// The highest load, m per mm.
    pub fn peak(&self) -> f64 {
        self.load.iter().copied().fold(0.0, f64::max)
    }

    /// Length of the edge that is loaded at all, mm.
    pub fn spread(&self) -> f64 {
        self.bin * self.load.iter().filter(|load| **load > 0.0).count() as f64
    }
}
