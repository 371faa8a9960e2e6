//! A flank developed into the plane.

use crate::workflow::PatternResult;
use contact::FlankPlaces;
use foundation::geometry::Surface;
use report::charts::{ChartError, Topography, region_above};

/// Places on the developed flank, root to tip, each from toe to heel: (along the tooth from the toe, up the profile from where the
/// active flank begins), mm.
pub(super) struct Developed {
    places_mm: Vec<Vec<[f64; 2]>>,
}

impl Developed {
    /// Length from the toe, and the way up the profile from the root.
    pub fn new(surface: &dyn Surface, places: &FlankPlaces) -> Self {
        let toe = places.lengths[0];
        let mut up = vec![0.0; places.lengths.len()];
        let mut places_mm = Vec::with_capacity(places.heights.len());
        for (i, height) in places.heights.iter().enumerate() {
            let mut row = Vec::with_capacity(places.lengths.len());
            for (j, length) in places.lengths.iter().enumerate() {
                if i > 0 {
                    let below = surface.point(places.heights[i - 1], *length);
                    up[j] += (surface.point(*height, *length) - below).norm();
                }
                row.push([length - toe, up[j]]);
            }
            places_mm.push(row);
        }
        Self { places_mm }
    }

    /// The lines of root and tip.
    pub fn root_and_tip(&self) -> [&[[f64; 2]]; 2] {
        [self.places_mm.first(), self.places_mm.last()].map(|row| row.map_or(&[][..], Vec::as_slice))
    }

    /// Both ends of the line half way up.
    pub fn toe_and_heel(&self) -> [[f64; 2]; 2] {
        let row = &self.places_mm[self.places_mm.len() / 2];
        [row.first(), row.last()].map(|at| at.copied().unwrap_or_default())
    }

    /// The place nearest to the centre of a pattern.
    pub fn centre(&self, pattern: &PatternResult) -> [f64; 2] {
        let nearest = |percent: f64, count: usize| {
            ((0.01 * percent * (count - 1) as f64).round() as usize).min(count - 1)
        };
        let row = &self.places_mm[nearest(pattern.centre_height_percent, self.places_mm.len())];
        row[nearest(pattern.centre_length_percent, row.len())]
    }

    /// Closed lines round the places whose gap (mm, row by row) is not wider than the marking (um).
    pub fn loops(&self, gaps: &[f64], marking_um: f64) -> Result<Vec<Vec<[f64; 2]>>, ChartError> {
        // Where the mate never comes the pattern ends at the last place that it reaches.
        let far = -1e6 * marking_um;
        let nearness = |gap: &f64| if gap.is_finite() { -(1e3 * gap) } else { far };
        let columns = self.places_mm.first().map_or(0, Vec::len);
        let rows: Vec<Vec<f64>> =
            gaps.chunks(columns.max(1)).map(|row| row.iter().map(nearness).collect()).collect();
        let numbers = |count: usize| (0..count).map(|k| k as f64).collect();
        let field = Topography::new(numbers(rows.len()), numbers(columns), rows)?;
        let loops = region_above(&field, -marking_um);
        Ok(loops.iter().map(|ring| ring.iter().map(|at| self.between(at)).collect()).collect())
    }

    /// A place between the numbers of columns and rows.
    fn between(&self, [column, row]: &[f64; 2]) -> [f64; 2] {
        let cell = |x: f64, count: usize| {
            let first = (x.floor() as usize).min(count.saturating_sub(2));
            (first, x - first as f64)
        };
        let (i, up) = cell(*row, self.places_mm.len());
        let (j, along) = cell(*column, self.places_mm[i].len());
        [0, 1].map(|k| {
            let on_row = |i: usize| {
                let row = &self.places_mm[i];
                row[j][k] + along * (row[j + 1][k] - row[j][k])
            };
            on_row(i) + up * (on_row(i + 1) - on_row(i))
        })
    }
}
