//! What the dresser left of a worm flank: lengths of rays, and the smooth surface through them.

use super::worm_surface::WormModification;
use super::{RayGrid, RemovalError, Stage, Statistics, Uncut};
use foundation::numerics::TensorSpline;

/// A finished ray of the worm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DressedRay {
    /// Length left, mm: f_n1 > 0 material left standing.
    pub f: f64,
    /// Worm position v_zS at which the dresser cut it, mm.
    pub shift: f64,
}

/// The rays of one worm flank after dressing.
#[derive(Clone, Debug, PartialEq)]
pub struct DressedFlank {
    /// Where the rays stand.
    pub grid: RayGrid,
    /// The rays, row-major `[w][z]`.
    pub rays: Vec<Result<DressedRay, Uncut>>,
    /// Exact rays between those of the grid, as (w, z, ray): they measure the surface through the grid.
    pub checks: Vec<(f64, f64, Result<DressedRay, Uncut>)>,
    /// Bound of the error of a ray's length, um: residue of the minimum, profile spline, rounding.
    pub error_um: f64,
    /// What was looked at.
    pub statistics: Statistics,
}

/// The worm flank as the rays left it: a C2 spline through their lengths, with its measured error.
#[derive(Clone, Debug, PartialEq)]
pub struct DressedSurface {
    spline: TensorSpline,
    creases: Vec<f64>,
    /// Largest difference between the spline and exact rays in the middles of cells, um.
    pub interpolation_um: f64,
    /// Bound of the surface's error, um: the rays' own and the interpolation's.
    pub error_um: f64,
}

impl DressedFlank {
    /// The lengths f_n1, mm, row-major `[w][z]`.
    ///
    /// # Errors
    /// [`RemovalError::RayUncut`] when a ray has none.
    pub fn lengths(&self) -> Result<Vec<f64>, RemovalError> {
        all_finished(Stage::Dressing, &self.grid, &self.rays, |ray| ray.f)
    }

    /// The surface that grinds: the spline through the rays.
    ///
    /// # Errors
    /// [`RemovalError::RayUncut`], [`RemovalError::Surface`] for fewer than four rays in a direction.
    pub fn surface(&self) -> Result<DressedSurface, RemovalError> {
        let lengths = self.lengths()?;
        let rows: Vec<Vec<f64>> = lengths.chunks(self.grid.z().len()).map(<[f64]>::to_vec).collect();
        let spline = TensorSpline::new(self.grid.w(), self.grid.z(), &rows)?;
        let missing = self.checks.iter().filter(|check| check.2.is_err()).count();
        let mut interpolation: f64 = 0.0;
        for &(w, z, ray) in &self.checks {
            let ray = ray.map_err(|reason| RemovalError::RayUncut {
                stage: Stage::Dressing,
                w,
                z,
                reason,
                count: missing,
            })?;
            interpolation = interpolation.max((spline.value(w, z) - ray.f).abs());
        }
        let interpolation_um = interpolation * 1e3;
        // Between the check rays the spline misses by up to 1.5 times what it misses at them; 2 covers that.
        let creases = creases(self.grid.w());
        Ok(DressedSurface {
            spline,
            creases,
            interpolation_um,
            error_um: self.error_um + 2.0 * interpolation_um,
        })
    }
}

impl WormModification for DressedSurface {
    fn jet(&self, w: f64, z: f64) -> [f64; 3] {
        WormModification::jet(&self.spline, w, z)
    }

    fn value(&self, w: f64, z: f64) -> f64 {
        self.spline.value(w, z)
    }

    fn domain(&self) -> [[f64; 2]; 2] {
        self.spline.domain()
    }

    fn creases(&self) -> &[f64] {
        &self.creases
    }

    fn error_um(&self) -> f64 {
        self.error_um
    }
}

/// Cells as narrow as this stand only where a flank bends most sharply, mm.
const NARROW: f64 = 0.01;

/// Where the grid has been refined to narrow cells, once for each run of them.
fn creases(w: &[f64]) -> Vec<f64> {
    let mut found = Vec::new();
    let mut begun: Option<f64> = None;
    for pair in w.windows(2) {
        let narrow = pair[1] - pair[0] < NARROW;
        match begun {
            None if narrow => begun = Some(pair[0]),
            Some(start) if !narrow => {
                found.push(0.5 * (start + pair[0]));
                begun = None;
            }
            _ => {}
        }
    }
    found.extend(begun.zip(w.last()).map(|(start, end)| 0.5 * (start + end)));
    found
}

/// One number of every ray, or the first ray without one and how many there are.
pub(super) fn all_finished<R>(
    stage: Stage,
    grid: &RayGrid,
    rays: &[Result<R, Uncut>],
    number: impl Fn(&R) -> f64,
) -> Result<Vec<f64>, RemovalError> {
    rays.iter()
        .enumerate()
        .map(|(index, ray)| match ray {
            Ok(ray) => Ok(number(ray)),
            Err(reason) => {
                let (w, z) = grid.ray(index);
                let count = rays.iter().filter(|ray| ray.is_err()).count();
                Err(RemovalError::RayUncut { stage, w, z, reason: *reason, count })
            }
        })
        .collect()
}
