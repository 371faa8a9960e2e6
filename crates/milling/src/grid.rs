//! The finished part as rows and columns of points with normals (`docs/mathematics/milling.md#columns-and-rows`), and the distances of
//! neighbours in it.

use super::{ActiveFlank, ColumnPlane, LeadCurve, LeadPoint, MillingError, RowSpacing, row_heights};
use foundation::geometry::SurfaceJet;
use rayon::prelude::*;

/// A point of the grid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GridPlace {
    /// Height parameter a.
    pub height: f64,
    /// Length parameter b.
    pub length: f64,
    /// The flank there.
    pub jet: SurfaceJet,
    /// eps: angle of the flank's normal out of the column plane, rad.
    pub out_of_plane: f64,
    /// Whether the point lies beyond the ends of the face.
    pub is_virtual: bool,
}

/// One column, from root to tip.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// Its plane.
    pub lead: LeadPoint,
    /// Its points, row 0 at the root.
    pub places: Vec<GridPlace>,
}

/// Columns with the same number of points; row i is the i-th point of all columns.
#[derive(Clone, Debug, PartialEq)]
pub struct FlankGrid {
    /// The columns along the guide curve.
    pub columns: Vec<Column>,
}

/// Straight distances of neighbours along lines of a grid, mm. A mean is that of one line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NeighbourDistances {
    /// The least distance.
    pub least: f64,
    /// The greatest distance.
    pub greatest: f64,
    /// The least mean of a line.
    pub least_mean: f64,
    /// The greatest mean of a line.
    pub greatest_mean: f64,
}

impl Column {
    /// The column of a flank in the plane at `u`.
    ///
    /// # Errors
    /// Those of the guide curve, of the sections and of the spacing.
    pub fn build(
        flank: &ActiveFlank,
        lead: &dyn LeadCurve,
        u: f64,
        rows: usize,
        law: RowSpacing,
    ) -> Result<Self, MillingError> {
        let plane = ColumnPlane::new(flank, lead.at(u)?);
        let (heights, _) = row_heights(&plane, rows, law)?;
        Self::at_heights(flank, &plane, &heights)
    }

    /// The column at given heights.
    ///
    /// # Errors
    /// Those of the sections.
    pub fn at_heights(
        flank: &ActiveFlank,
        plane: &ColumnPlane,
        heights: &[f64],
    ) -> Result<Self, MillingError> {
        let mut start = plane.lead().u;
        let mut places = Vec::with_capacity(heights.len());
        for &height in heights {
            let section = plane.section(height, start)?;
            start = section.length;
            places.push(GridPlace {
                height,
                length: section.length,
                out_of_plane: section.jet.normal.dot(&plane.lead().direction).asin(),
                is_virtual: flank.is_virtual(section.length),
                jet: section.jet,
            });
        }
        Ok(Self { lead: *plane.lead(), places })
    }
}

impl FlankGrid {
    /// Columns at the given lead parameters with `rows` (>= 2) points each.
    ///
    /// # Errors
    /// Those of [`Column::build`].
    pub fn build(
        flank: &ActiveFlank,
        lead: &dyn LeadCurve,
        at: &[f64],
        rows: usize,
        law: RowSpacing,
    ) -> Result<Self, MillingError> {
        let columns = at.par_iter().map(|&u| Column::build(flank, lead, u, rows, law));
        Ok(Self { columns: columns.collect::<Result<_, _>>()? })
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.columns.first().map_or(0, |column| column.places.len())
    }

    /// Distances along rows, that is between columns.
    pub fn along_rows(&self) -> NeighbourDistances {
        let row = |row: usize| {
            self.columns.windows(2).map(move |pair| distance(&pair[0].places[row], &pair[1].places[row]))
        };
        NeighbourDistances::of((0..self.rows()).map(row))
    }

    /// Distances along columns, that is between rows.
    pub fn along_columns(&self) -> NeighbourDistances {
        let column =
            |column: &Column| column.places.windows(2).map(|pair| distance(&pair[0], &pair[1])).collect();
        NeighbourDistances::of(self.columns.iter().map::<Vec<f64>, _>(column))
    }
}

fn distance(a: &GridPlace, b: &GridPlace) -> f64 {
    (a.jet.point - b.jet.point).norm()
}

impl NeighbourDistances {
    fn of<L: IntoIterator<Item = f64>>(lines: impl Iterator<Item = L>) -> Self {
        let none =
            Self { least: f64::INFINITY, greatest: 0.0, least_mean: f64::INFINITY, greatest_mean: 0.0 };
        lines.fold(none, |all, line| {
            let (mut sum, mut count) = (0.0, 0);
            let (mut least, mut greatest) = (all.least, all.greatest);
            for distance in line {
                (sum, count) = (sum + distance, count + 1);
                (least, greatest) = (least.min(distance), greatest.max(distance));
            }
            let mean = sum / f64::from(count);
            Self {
                least,
                greatest,
                least_mean: all.least_mean.min(mean),
                greatest_mean: all.greatest_mean.max(mean),
            }
        })
    }
}
