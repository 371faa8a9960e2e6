//! A flank through a grid of points: bicubic splines over averaged chord lengths, `docs/mathematics/milling.md#flanks-as-patches`.
//!
//! Height = 0 at the first row (root) to 1 at the last (tip), length = 0 at the first point of the rows to 1 at the last.

use super::bounds::remainder;
use super::second_order::{cross_product_bounds, jet_of_derivatives, second_order_of};
use super::{NormalSide, OffsetBase, SecondOrder, Surface, SurfaceJet};
use crate::geometry::GeometryError;
use crate::numerics::{BicubicPatch, Jet2, SplineError, TensorSpline};
use nalgebra::Vector3;

/// Lines of points that continue a surface beyond one end.
const BEYOND: usize = 4;

/// Share of |S_a| |S_b| below which their cross product tells no side.
const FLAT: f64 = 1e-9;

/// A smooth surface through points.
#[derive(Clone, Debug, PartialEq)]
pub struct GridSurface {
    coordinates: [TensorSpline; 3],
    side: NormalSide,
    heights: Vec<f64>,
    lengths: Vec<f64>,
}

/// Cumulated chord lengths averaged over several lines of points, scaled to 0..1.
fn parameters<'a>(count: usize, lines: impl Iterator<Item = Vec<&'a Vector3<f64>>>) -> Vec<f64> {
    let mut sums = vec![0.0; count];
    for line in lines {
        let mut length = 0.0;
        for i in 1..count {
            length += (line[i] - line[i - 1]).norm();
            sums[i] += length;
        }
    }
    let whole = sums[count - 1];
    sums.iter().map(|sum| sum / whole).collect()
}

fn check(rows: &[Vec<Vector3<f64>>]) -> Result<(), GeometryError> {
    let columns = rows.iter().map(Vec::len).min().unwrap_or(0);
    if rows.len() < 4 || columns < 4 {
        return Err(GeometryError::GridSize { rows: rows.len(), columns });
    }
    let expected = rows[0].len();
    if let Some(row) = rows.iter().position(|row| row.len() != expected) {
        return Err(GeometryError::GridRagged { row, expected, found: rows[row].len() });
    }
    for (i, row) in rows.iter().enumerate() {
        for (j, point) in row.iter().enumerate() {
            if point.iter().any(|x| !x.is_finite()) {
                return Err(GeometryError::GridNotFinite { row: i, column: j });
            }
            if (i > 0 && rows[i - 1][j] == *point) || (j > 0 && row[j - 1] == *point) {
                return Err(GeometryError::GridDuplicate { row: i, column: j });
            }
        }
    }
    Ok(())
}

impl GridSurface {
    /// The surface through `rows` of points, mm, from root to tip, every row along the tooth.
    ///
    /// # Errors
    /// [`GeometryError::GridSize`] (`E_GRID_SIZE` of `docs/mathematics/milling.md#limits`), [`GeometryError::GridRagged`],
    /// [`GeometryError::GridNotFinite`], [`GeometryError::GridDuplicate`], [`GeometryError::GridFolded`].
    pub fn new(rows: &[Vec<Vector3<f64>>], side: NormalSide) -> Result<Self, GeometryError> {
        check(rows)?;
        let (count, columns) = (rows.len(), rows[0].len());
        let heights =
            parameters(count, (0..columns).map(|j| rows.iter().map(|row| &row[j]).collect::<Vec<_>>()));
        let lengths = parameters(columns, rows.iter().map(|row| row.iter().collect::<Vec<_>>()));
        let along = |axis: usize| {
            let values: Vec<Vec<f64>> =
                rows.iter().map(|row| row.iter().map(|p| p[axis]).collect()).collect();
            TensorSpline::new(&heights, &lengths, &values).map_err(|error| match error {
                // Neighbours are apart, but by less than the numbers can tell from the whole.
                SplineError::NotAscending { axis: 0, index } => {
                    GeometryError::GridDuplicate { row: index, column: 0 }
                }
                SplineError::NotAscending { index, .. } => {
                    GeometryError::GridDuplicate { row: 0, column: index }
                }
                // Points are finite: what overflows are chords or coefficients.
                _ => GeometryError::GridNotFinite { row: 0, column: 0 },
            })
        };
        let coordinates = [along(0)?, along(1)?, along(2)?];
        let surface = Self { coordinates, side, heights, lengths };
        surface.check_sides()?;
        Ok(surface)
    }

    /// The same surface, going on beyond both ends of its rows by a share of their length: with the slope and the curvature that it has
    /// there, along every row. Within its points it stays what it is, as the continued lines are cubics that meet it with continuous second
    /// derivatives.
    ///
    /// # Errors
    /// [`GeometryError::InvalidNumber`] for a share that is not above 0.
    pub fn extended(&self, share: f64) -> Result<Self, GeometryError> {
        if !(share.is_finite() && share > 0.0) {
            let (field, allowed) = ("share of the extension", "> 0");
            return Err(GeometryError::InvalidNumber { field, value: share, allowed });
        }
        let steps = |k: usize| share * k as f64 / BEYOND as f64;
        let before = (1..=BEYOND).rev().map(|k| -steps(k));
        let behind = (1..=BEYOND).map(|k| 1.0 + steps(k));
        let lengths: Vec<f64> = before.chain(self.lengths.iter().copied()).chain(behind).collect();
        let beyond = |axis: usize, height: f64, length: f64| {
            let end = length.clamp(0.0, 1.0);
            let Jet2 { f, fv, fvv, .. } = self.coordinates[axis].jet(height, end);
            let by = length - end;
            f + by * (fv + 0.5 * by * fvv)
        };
        let along = |axis: usize| {
            let row = |height: &f64| lengths.iter().map(|length| beyond(axis, *height, *length)).collect();
            let values: Vec<Vec<f64>> = self.heights.iter().map(row).collect();
            TensorSpline::new(&self.heights, &lengths, &values)
                .map_err(|_| GeometryError::GridNotFinite { row: 0, column: 0 })
        };
        let coordinates = [along(0)?, along(1)?, along(2)?];
        Ok(Self { coordinates, side: self.side, heights: self.heights.clone(), lengths })
    }

    /// The height parameters of the rows.
    pub fn heights(&self) -> &[f64] {
        &self.heights
    }

    /// The length parameters of the columns.
    pub fn lengths(&self) -> &[f64] {
        &self.lengths
    }

    /// Whether the surface has a tangent plane at every point of the grid and shows the same side at neighbours.
    fn check_sides(&self) -> Result<(), GeometryError> {
        let mut before: Vec<Vector3<f64>> = Vec::new();
        for (row, &height) in self.heights.iter().enumerate() {
            for (column, &length) in self.lengths.iter().enumerate() {
                let at = self.jet(height, length);
                let across = at.by_height.cross(&at.by_length).norm();
                let clear = across > FLAT * at.by_height.norm() * at.by_length.norm();
                let left = if column > 0 { before.last() } else { None };
                let below = if row > 0 { before.get(before.len() - self.lengths.len()) } else { None };
                let agrees = [left, below].into_iter().flatten().all(|n| n.dot(&at.normal) > 0.0);
                if !(clear && agrees) {
                    return Err(GeometryError::GridFolded { row, column });
                }
                before.push(at.normal);
            }
        }
        Ok(())
    }

    fn jets(&self, height: f64, length: f64) -> [Jet2; 3] {
        [0, 1, 2].map(|axis| self.coordinates[axis].jet(height, length))
    }

    /// Bounds of derivatives of the given orders over a box, from the Bezier points of the cells in it.
    fn bounds<const N: usize>(
        &self,
        heights: [f64; 2],
        lengths: [f64; 2],
        orders: [[usize; 2]; N],
    ) -> [f64; N] {
        let mut squares = [0.0f64; N];
        let [x, y, z] = self.coordinates.each_ref().map(|spline| spline.patches(heights, lengths));
        for ((x, y), z) in x.zip(y).zip(z) {
            for (largest, orders) in squares.iter_mut().zip(orders) {
                let nets = [&x, &y, &z].map(|patch: &BicubicPatch| patch.control_net(orders));
                for k in 0..4 {
                    for l in 0..4 {
                        *largest = largest.max(nets.iter().map(|net| net[k][l] * net[k][l]).sum());
                    }
                }
            }
        }
        squares.map(f64::sqrt)
    }
}

impl Surface for GridSurface {
    fn domain(&self) -> [[f64; 2]; 2] {
        let ends = |of: &[f64]| [of[0], of[of.len() - 1]];
        [ends(&self.heights), ends(&self.lengths)]
    }

    fn point(&self, height: f64, length: f64) -> Vector3<f64> {
        Vector3::from_fn(|axis, _| self.coordinates[axis].value(height, length))
    }

    /// Where the surface has no tangent plane the normal and its derivatives are zero.
    fn jet(&self, height: f64, length: f64) -> SurfaceJet {
        let jets = self.jets(height, length);
        let part = |pick: fn(&Jet2) -> f64| Vector3::from_fn(|i, _| pick(&jets[i]));
        let (point, by_height, by_length) = (part(|j| j.f), part(|j| j.fu), part(|j| j.fv));
        let second = [part(|j| j.fuu), part(|j| j.fuv), part(|j| j.fvv)];
        let none = Vector3::zeros();
        jet_of_derivatives(point, [by_height, by_length], &second, self.side.sign()).unwrap_or(SurfaceJet {
            point,
            by_height,
            by_length,
            normal: none,
            normal_by_height: none,
            normal_by_length: none,
        })
    }

    fn speed_bounds(&self, heights: [f64; 2], lengths: [f64; 2]) -> [f64; 2] {
        self.bounds(heights, lengths, [[1, 0], [0, 1]])
    }

    fn off_tangent(&self, heights: [f64; 2], lengths: [f64; 2]) -> f64 {
        remainder(self.bounds(heights, lengths, [[2, 0], [1, 1], [0, 2]]), heights, lengths)
    }
}

impl OffsetBase for GridSurface {
    /// On a knot line the second derivatives of the normal are those of the cell above it: the spline is C2, its normal C1.
    fn second_order(&self, height: f64, length: f64) -> SecondOrder {
        let slopes = [0, 1, 2].map(|axis| self.coordinates[axis].slope_jets(height, length));
        let point = self.point(height, length);
        second_order_of(point, &slopes.map(|[a, _]| a), &slopes.map(|[_, b]| b), self.side.sign())
    }

    fn normal_speed_bounds(&self, heights: [f64; 2], lengths: [f64; 2]) -> [f64; 2] {
        let speeds = self.speed_bounds(heights, lengths);
        let second = self.bounds(heights, lengths, [[2, 0], [1, 1], [0, 2]]);
        let middle = self.jet((heights[0] + heights[1]) / 2.0, (lengths[0] + lengths[1]) / 2.0);
        cross_product_bounds(
            speeds,
            second,
            [(heights[1] - heights[0]) / 2.0, (lengths[1] - lengths[0]) / 2.0],
            middle.by_height.cross(&middle.by_length).norm(),
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A twisted surface through 6 x 7 points.
    fn twisted() -> GridSurface {
        let point = |i: usize, j: usize| {
            let (a, b) = (i as f64 / 5.0, j as f64 / 6.0);
            let angle = 0.3 * b * b + 0.2 * a * b;
            Vector3::new(30.0 * angle.sin(), 40.0 + 20.0 * a, 50.0 * b + a * a)
        };
        let rows: Vec<Vec<_>> = (0..6).map(|i| (0..7).map(|j| point(i, j)).collect()).collect();
        GridSurface::new(&rows, NormalSide::Along).unwrap()
    }

    #[test]
    fn an_extended_surface_is_the_same_within_its_points_and_goes_on_smoothly() {
        let (inner, outer) = (twisted(), twisted().extended(0.4).unwrap());
        assert_eq!(outer.domain()[1], [-0.4, 1.4]);
        for k in 0..=40 {
            for l in 0..=40 {
                let (a, b) = (k as f64 / 40.0, l as f64 / 40.0);
                assert!((inner.point(a, b) - outer.point(a, b)).norm() < 1e-10, "{a} {b}");
            }
        }
        for (end, sense) in [(0.0, -1.0), (1.0, 1.0)] {
            let at = inner.jet(0.3, end);
            let [near, far] = [1e-4, 0.2].map(|by| outer.point(0.3, end + sense * by) - at.point);
            assert!((near / (sense * 1e-4) - at.by_length).norm() < 1e-2 * at.by_length.norm());
            assert!(far.norm() > 0.15 * at.by_length.norm());
        }
        for share in [0.0, -1.0, f64::NAN] {
            assert!(inner.extended(share).is_err());
        }
    }
}
