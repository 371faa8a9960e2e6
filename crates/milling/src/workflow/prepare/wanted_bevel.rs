//! What is wanted of the flanks of a bevel gear, for those who measure it: the target as a surface over length of roll and position along the
//! tooth, and what its paths are planned with beside it.

use super::bevel_offset::{RollMap, Wanted, heights};
use super::bevel_pair::BevelPair;
use super::conical::{flank_surface, own_gear};
use crate::job::{BevelGear as Drawing, LoadedMillingJob, MeasuringGrid};
use foundation::geometry::{BevelGear, Flank, NormalOffset, Sides, Surface, SurfaceJet};
use foundation::numerics::equidistant;
use nalgebra::{Matrix2, Vector2, Vector3};
use run::{RunFailure, geometry_finding};
use std::sync::Arc;

/// A wanted flank in the space about +y. Lengths of roll are those in the middle of the face, positions count from there along the pitch
/// cone, the heel at the upper end; mm.
#[derive(Clone, Debug)]
pub struct WantedBevel {
    surface: Arc<dyn Surface>,
    /// What the target has beside the nominal flank.
    offset: Option<Arc<dyn NormalOffset>>,
    /// What paths are planned with beside the target.
    beside: Option<Arc<dyn NormalOffset>>,
    map: RollMap,
    /// Lengths of roll of the active flank.
    pub rolls: [f64; 2],
    /// Positions of toe and heel.
    pub ends: [f64; 2],
    /// Cosine of the base helix angle in the middle of the face: normal over transverse deviations.
    pub normal_factor: f64,
}

/// Steps to the foot of a point: each leaves of the way the share that the distance is of the radius of curvature.
const STEPS: usize = 60;
/// A step that moves the foot by less is the last, mm.
const FOOT: f64 = 1e-9;

impl WantedBevel {
    /// Height and length parameters of a place.
    pub fn parameters(&self, roll: f64, position: f64) -> [f64; 2] {
        [self.map.height(roll), self.map.middle() + position]
    }

    /// Point and normal of the target.
    pub fn target(&self, roll: f64, position: f64) -> SurfaceJet {
        let [height, length] = self.parameters(roll, position);
        self.surface.jet(height, length)
    }

    /// What the target has beside the nominal flank, normal to it, > 0 material left, mm.
    pub fn modification(&self, roll: f64, position: f64) -> f64 {
        self.value(self.offset.as_ref(), roll, position)
    }

    /// What paths are planned with beside the target, normal to the flank, > 0 material left, mm.
    pub fn beside(&self, roll: f64, position: f64) -> f64 {
        self.value(self.beside.as_ref(), roll, position)
    }

    fn value(&self, of: Option<&Arc<dyn NormalOffset>>, roll: f64, position: f64) -> f64 {
        let [height, length] = self.parameters(roll, position);
        of.map_or(0.0, |of| of.jet(height, length).f)
    }

    /// Distance of a point from the target, > 0 out of the material, mm, found from a place near its foot; `None` if it has none there.
    pub fn distance(&self, point: &Vector3<f64>, roll: f64, position: f64) -> Option<f64> {
        let [mut height, mut length] = self.parameters(roll, position);
        for _ in 0..STEPS {
            let at = self.surface.jet(height, length);
            let off = point - at.point;
            let (a, b) = (at.by_height, at.by_length);
            let metric = Matrix2::new(a.dot(&a), a.dot(&b), a.dot(&b), b.dot(&b));
            let step = metric.try_inverse()? * Vector2::new(a.dot(&off), b.dot(&off));
            height += step.x;
            length += step.y;
            let moved = (a * step.x + b * step.y).norm();
            if !moved.is_finite() {
                return None;
            }
            if moved < FOOT {
                let at = self.surface.jet(height, length);
                return Some((point - at.point).dot(&at.normal));
            }
        }
        None
    }

    /// Lengths of roll of the rows and positions of the columns of a grid.
    pub fn places(&self, grid: &MeasuringGrid) -> [Vec<f64>; 2] {
        let inside = |[from, to]: [f64; 2], margin: f64, count: usize| {
            let off = margin * (to - from);
            equidistant([from + off, to - off], count)
        };
        [
            inside(self.rolls, grid.profile_margin, grid.rows),
            inside(self.ends, grid.length_margin, grid.columns),
        ]
    }
}

/// The gear of a drawing with its wanted flanks.
///
/// # Errors
/// [`RunFailure`] with a finding on the key concerned.
pub fn wanted_bevel(
    loaded: &LoadedMillingJob,
    given: &Drawing,
) -> Result<(BevelGear, Sides<WantedBevel>), RunFailure> {
    let job = &loaded.job;
    let pair = BevelPair::of_job(job, given)?;
    let gear = own_gear(given, pair.as_ref())?;
    let (map, form) = (RollMap::of(&gear, given.flank), given.flank);
    let half = 0.5 * given.face_width;
    let target = Wanted::of_job(job);
    let alone = Wanted { ease_off: None, modifications: &[], ..target.compensated(job) };
    let of = |side: Flank| {
        let heights = heights(&gear, form, side)
            .map_err(|error| RunFailure::bad_input(geometry_finding(&error, "bevel")))?;
        let [root, tip] = heights.map(|height| map.roll(height));
        let offset = target.offset(loaded, &gear, form, side)?;
        Ok::<_, RunFailure>(WantedBevel {
            surface: flank_surface(&gear, form, side, offset.clone()),
            offset,
            beside: alone.offset(loaded, &gear, form, side)?,
            map,
            rolls: [root.min(tip), root.max(tip)],
            ends: [-half, half],
            normal_factor: map.base_helix(&gear).cos(),
        })
    };
    let flanks = Sides::try_from_fn(of)?;
    Ok((gear, flanks))
}
