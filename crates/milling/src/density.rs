//! How many rows and columns a flank needs (`docs/mathematics/milling.md#columns-and-rows`): the smallest grid that keeps the upper limits,
//! and which of the other limits no grid of this law can keep.

use super::grid::NeighbourDistances;
use super::size::MOST_LINES;
use super::{ActiveFlank, FlankGrid, LeadCurve, MillingError, RowSpacing};
use foundation::numerics::equidistant;

/// Limits of the distances along lines of one kind, mm; any subset.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DistanceLimits {
    /// Greatest distance.
    pub greatest: Option<f64>,
    /// Least distance.
    pub least: Option<f64>,
    /// Greatest mean of a line.
    pub greatest_mean: Option<f64>,
    /// Least mean of a line.
    pub least_mean: Option<f64>,
}

/// The eight limits: along rows, that is between columns, and along columns, that is between rows.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DensityLimits {
    /// Along rows.
    pub row: DistanceLimits,
    /// Along columns.
    pub column: DistanceLimits,
}

/// A limit that the smallest grid does not keep.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Violated {
    /// Its name: `row_max`, `column_min_mean`, ...
    pub name: &'static str,
    /// Distance measured, mm.
    pub measured: f64,
    /// The limit, mm.
    pub limit: f64,
}

/// The smallest grid that keeps the upper limits.
#[derive(Clone, Debug, PartialEq)]
pub struct DenseGrid {
    /// The grid over the lead range, without overrun.
    pub grid: FlankGrid,
    /// Figures along its rows.
    pub along_rows: NeighbourDistances,
    /// Figures along its columns.
    pub along_columns: NeighbourDistances,
    /// Limits that it does not keep; no grid of the same law keeps them together with the upper limits.
    pub violated: Vec<Violated>,
}

impl DistanceLimits {
    /// Names of the limits, those of rows or of columns.
    fn names(of_rows: bool) -> [&'static str; 4] {
        if of_rows {
            ["row_max", "row_min", "row_max_mean", "row_min_mean"]
        } else {
            ["column_max", "column_min", "column_max_mean", "column_min_mean"]
        }
    }

    fn check(&self, of_rows: bool) -> Result<(), MillingError> {
        let names = Self::names(of_rows);
        let values = [self.greatest, self.least, self.greatest_mean, self.least_mean];
        for (name, value) in names.into_iter().zip(values) {
            if let Some(value) = value.filter(|value| !(*value > 0.0 && value.is_finite())) {
                return Err(MillingError::DensityInput { name, value, allowed: "> 0 mm" });
            }
        }
        for (least, greatest, name) in
            [(self.least, self.greatest, names[1]), (self.least_mean, self.greatest_mean, names[3])]
        {
            if let (Some(value), Some(most)) = (least, greatest)
                && value > most
            {
                return Err(MillingError::DensityInput { name, value, allowed: "at most the upper limit" });
            }
        }
        Ok(())
    }

    fn upper_kept(&self, measured: &NeighbourDistances) -> bool {
        self.greatest.is_none_or(|limit| measured.greatest <= limit)
            && self.greatest_mean.is_none_or(|limit| measured.greatest_mean <= limit)
    }

    /// The tighter of the upper limits.
    fn upper(&self) -> Option<f64> {
        self.greatest.into_iter().chain(self.greatest_mean).reduce(f64::min)
    }

    fn violated(&self, of_rows: bool, measured: &NeighbourDistances) -> impl Iterator<Item = Violated> {
        let pairs = [
            (self.greatest, measured.greatest, 1.0),
            (self.least, measured.least, -1.0),
            (self.greatest_mean, measured.greatest_mean, 1.0),
            (self.least_mean, measured.least_mean, -1.0),
        ];
        Self::names(of_rows).into_iter().zip(pairs).filter_map(|(name, (limit, measured, sense))| {
            let limit = limit?;
            ((measured - limit) * sense > 0.0).then_some(Violated { name, measured, limit })
        })
    }
}

/// The smallest grid over `range` that keeps the upper limits, at least 2 x 2.
///
/// # Errors
/// [`MillingError::DensityInput`] for limits that contradict themselves, [`MillingError::DensitySize`] for more than [`MOST_LINES`]; those of
/// the grid.
pub fn dense_grid(
    flank: &ActiveFlank,
    lead: &dyn LeadCurve,
    range: [f64; 2],
    law: RowSpacing,
    limits: &DensityLimits,
) -> Result<DenseGrid, MillingError> {
    limits.row.check(true)?;
    limits.column.check(false)?;
    let build =
        |columns: usize, rows: usize| FlankGrid::build(flank, lead, &equidistant(range, columns), rows, law);
    let (mut columns, mut rows) = (2, 2);
    // The number of rows hardly moves the columns' distances and the other way round: two rounds settle it, a third sees that.
    for _ in 0..8 {
        let before = (columns, rows);
        columns = fewest(columns, &limits.row, |columns| Ok(build(columns, rows)?.along_rows()))
            .map_err(|fault| fault.named("columns"))?;
        rows = fewest(rows, &limits.column, |rows| Ok(build(columns, rows)?.along_columns()))
            .map_err(|fault| fault.named("rows"))?;
        if (columns, rows) == before {
            break;
        }
    }
    let grid = build(columns, rows)?;
    let (along_rows, along_columns) = (grid.along_rows(), grid.along_columns());
    let violated =
        limits.row.violated(true, &along_rows).chain(limits.column.violated(false, &along_columns));
    let violated = violated.collect();
    Ok(DenseGrid { grid, along_rows, along_columns, violated })
}

enum Fault {
    Size { needed: f64 },
    Grid(MillingError),
}

impl Fault {
    fn named(self, lines: &'static str) -> MillingError {
        match self {
            Self::Size { needed } => MillingError::DensitySize { lines, needed },
            Self::Grid(error) => error,
        }
    }
}

/// The least number of lines with which the distances across them keep their upper limits.
fn fewest(
    start: usize,
    limits: &DistanceLimits,
    measure: impl Fn(usize) -> Result<NeighbourDistances, MillingError>,
) -> Result<usize, Fault> {
    let Some(upper) = limits.upper() else { return Ok(start) };
    let measure = |lines| measure(lines).map_err(Fault::Grid);
    let length = |measured: &NeighbourDistances, lines: usize| measured.greatest_mean * (lines - 1) as f64;
    let guess = (length(&measure(start)?, start) / upper).ceil() + 1.0;
    // NaN becomes 0 and asks for nothing; what is too much is refused.
    if guess > MOST_LINES as f64 {
        return Err(Fault::Size { needed: guess });
    }
    let mut lines = (guess as usize).max(2);
    while !limits.upper_kept(&measure(lines)?) {
        lines += 1;
        if lines > MOST_LINES {
            return Err(Fault::Size { needed: lines as f64 });
        }
    }
    while lines > 2 && limits.upper_kept(&measure(lines - 1)?) {
        lines -= 1;
    }
    Ok(lines)
}
