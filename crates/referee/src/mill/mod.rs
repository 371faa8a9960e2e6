//! Five-axis milling: normal rays of the workpiece, shortened by cutters that move along blocks
//! (`docs/mathematics/milling.md#the-referee`).
//!
//! A cutter in one place covers an interval of a ray; seen from inside the material the first entry into it is what remains. The
//! length of a ray is the lowest entry over all places of all blocks. It is found with a proof that no place enters lower (see the
//! module of the search), so that no step width decides what is seen.

mod block;
mod body;
pub mod outcome;
pub mod rapids;
mod search;
mod tree;
mod unmilled;

pub use body::CutterPart;
pub use outcome::{MillStatistics, MilledRay, MilledRays};
pub use rapids::{RapidHit, Rapids, rapid_hits};
pub use unmilled::Unmilled;

use super::{RemovalError, error};
use block::Block;
use body::Part;
use foundation::geometry::Cutter;
use foundation::numerics::Progress;
use nalgebra::Vector3;
use rayon::prelude::*;
use search::{Search, Stretch, TOLERANCE};
use tree::{Tree, Waiting};

/// Where a cutter stands, in workpiece coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CutterPlace {
    /// T: the tip, mm.
    pub tip: Vector3<f64>,
    /// a: unit vector along the axis, towards the shank.
    pub axis: Vector3<f64>,
}

/// One path: straight blocks from each place to the next. One place alone is a cutter that stands there.
#[derive(Clone, Debug, PartialEq)]
pub struct MillPath {
    /// Index of the cutter that follows it.
    pub cutter: usize,
    /// Its places in the order in which they are passed.
    pub places: Vec<CutterPlace>,
}

/// A ray through the material, in workpiece coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NormalRay {
    /// P: the point of the surface that is wanted, mm.
    pub point: Vector3<f64>,
    /// n: unit normal out of the material.
    pub normal: Vector3<f64>,
}

/// What cuts, and how far the rays reach. mm.
#[derive(Clone, Copy, Debug)]
pub struct Milling<'a> {
    /// The cutters.
    pub cutters: &'a [Cutter],
    /// The paths; between the end of one and the begin of another nothing cuts.
    pub paths: &'a [MillPath],
    /// How far outside the surface material is assumed.
    pub stock: f64,
    /// How far below the surface gouges are looked for.
    pub depth: f64,
}

/// How far the length of a unit vector may be from 1: rounding in files, which give seven decimals.
const UNIT: f64 = 1e-6;
/// Rounding of a length: coordinates of some 100 mm, mm.
const ROUNDING: f64 = 1e-12;
/// Rays per parcel of work; a parcel takes about a millisecond.
const PARCEL: usize = 64;

/// Motions made ready for rays: their blocks, and a tree over them for each cutter.
pub struct Swept<'a> {
    setup: Milling<'a>,
    blocks: Vec<Block>,
    trees: Vec<Tree>,
}

impl<'a> Swept<'a> {
    /// Makes motions ready.
    ///
    /// # Errors
    /// [`RemovalError::InvalidNumber`] for stock or depth, [`RemovalError::EmptyPath`], [`RemovalError::UnknownCutter`],
    /// [`RemovalError::InvalidCutterPlace`], [`RemovalError::AxisTurnsBack`].
    pub fn new(setup: &Milling<'a>) -> Result<Self, RemovalError> {
        error::positive("milling stock", setup.stock)?;
        error::positive("depth below the flank", setup.depth)?;
        let blocks = blocks(setup)?;
        let trees = trees(setup, &blocks);
        Ok(Self { setup: *setup, blocks, trees })
    }

    /// What the motions were made from.
    pub fn setup(&self) -> &Milling<'a> {
        &self.setup
    }

    /// Shortens the rays by the cutters along all blocks.
    ///
    /// # Errors
    /// [`RemovalError::InvalidRay`]. Rays that no cutter meets are no error here; see [`MilledRays::lengths`].
    pub fn mill(&self, rays: &[NormalRay], progress: &dyn Progress) -> Result<MilledRays, RemovalError> {
        let rays =
            rays.iter().enumerate().map(|(i, ray)| checked_ray(i, ray)).collect::<Result<Vec<_>, _>>()?;
        let Self { setup, blocks, trees } = self;
        progress.start("milling", rays.len() as u64);
        let shots: Vec<(Result<MilledRay, Unmilled>, MillStatistics)> = rays
            .par_chunks(PARCEL)
            .map_init(Stores::default, |stores, parcel| {
                let shots: Vec<_> =
                    parcel.iter().map(|ray| shoot(setup, blocks, trees, ray, stores)).collect();
                progress.advance(parcel.len() as u64);
                shots
            })
            .flatten_iter()
            .collect();
        progress.finish();
        let nothing = MillStatistics { blocks: blocks.len() as u64, ..MillStatistics::default() };
        let statistics = shots.iter().fold(nothing, |sum, shot| sum + shot.1);
        Ok(MilledRays {
            rays: shots.into_iter().map(|shot| shot.0).collect(),
            error_um: (TOLERANCE + ROUNDING) * 1e3,
            statistics,
        })
    }
}

/// Shortens the rays by the cutters along all of their blocks.
///
/// # Errors
/// Those of [`Swept::new`] and [`Swept::mill`].
pub fn mill(
    setup: &Milling<'_>,
    rays: &[NormalRay],
    progress: &dyn Progress,
) -> Result<MilledRays, RemovalError> {
    Swept::new(setup)?.mill(rays, progress)
}

/// Stores that a thread uses again for every ray.
#[derive(Default)]
struct Stores {
    branches: Waiting,
    stretches: Vec<Stretch>,
}

fn shoot(
    setup: &Milling<'_>,
    blocks: &[Block],
    trees: &[Tree],
    ray: &NormalRay,
    stores: &mut Stores,
) -> (Result<MilledRay, Unmilled>, MillStatistics) {
    let lowest = -setup.depth;
    let mut search = Search { ray, lowest, best: setup.stock, found: None, unsettled: false, evaluations: 0 };
    let mut statistics = MillStatistics { rays: 1, ..MillStatistics::default() };
    for tree in trees {
        for part in &tree.parts {
            let range = [lowest, search.best];
            statistics.bounds += tree.visit(part, ray, range, &mut stores.branches, &mut |index| {
                statistics.searched += 1;
                search.block(index, &blocks[index], part, &mut stores.stretches);
                (!search.too_deep()).then_some(search.best)
            });
            if search.too_deep() {
                break;
            }
        }
        if search.too_deep() {
            break;
        }
    }
    statistics.evaluations = search.evaluations;
    let ray = match search.found {
        Some((index, part, fraction)) => {
            let Block { path, index: block, .. } = blocks[index];
            if search.too_deep() {
                Err(Unmilled::TooDeep { path, block, fraction, part })
            } else {
                Ok(MilledRay { length: search.best, path, block, fraction, part })
            }
        }
        None => Err(Unmilled::NotReached),
    };
    let doubtful = search.unsettled && !matches!(ray, Err(Unmilled::TooDeep { .. }));
    (if doubtful { Err(Unmilled::NotSettled) } else { ray }, statistics)
}

/// The first of some numbers that is not finite.
fn not_finite(vector: &Vector3<f64>) -> Option<f64> {
    vector.iter().copied().find(|x| !x.is_finite())
}

/// A vector of length 1, or its length if that is something else.
fn unit(vector: &Vector3<f64>) -> Result<Vector3<f64>, f64> {
    let length = vector.norm();
    if (length - 1.0).abs() <= UNIT { Ok(vector / length) } else { Err(length) }
}

fn checked_ray(index: usize, ray: &NormalRay) -> Result<NormalRay, RemovalError> {
    if let Some(value) = not_finite(&ray.point) {
        return Err(RemovalError::InvalidRay { index, field: "point coordinate", value });
    }
    let normal = unit(&ray.normal).map_err(|value| RemovalError::InvalidRay {
        index,
        field: "length of the normal",
        value,
    })?;
    Ok(NormalRay { point: ray.point, normal })
}

fn checked_place(path: usize, place: usize, at: &CutterPlace) -> Result<CutterPlace, RemovalError> {
    let invalid = |field, value| RemovalError::InvalidCutterPlace { path, place, field, value };
    if let Some(value) = not_finite(&at.tip) {
        return Err(invalid("tip coordinate", value));
    }
    let axis = unit(&at.axis).map_err(|value| invalid("length of the axis", value))?;
    Ok(CutterPlace { tip: at.tip, axis })
}

fn blocks(setup: &Milling<'_>) -> Result<Vec<Block>, RemovalError> {
    if setup.paths.is_empty() {
        return Err(RemovalError::EmptyPath { path: 0 });
    }
    let mut blocks = Vec::with_capacity(setup.paths.iter().map(|path| path.places.len()).sum());
    for (index, path) in setup.paths.iter().enumerate() {
        if path.cutter >= setup.cutters.len() {
            let cutters = setup.cutters.len();
            return Err(RemovalError::UnknownCutter { path: index, cutter: path.cutter, cutters });
        }
        let places = path.places.iter().enumerate();
        let mut places = places.map(|(i, at)| checked_place(index, i, at)).collect::<Result<Vec<_>, _>>()?;
        match places[..] {
            [] => return Err(RemovalError::EmptyPath { path: index }),
            [alone] => places.push(alone),
            _ => {}
        }
        for (i, ends) in places.windows(2).enumerate() {
            let block = Block::new(index, i, &ends[0], &ends[1]);
            blocks.push(block.ok_or(RemovalError::AxisTurnsBack { path: index, block: i })?);
        }
    }
    Ok(blocks)
}

/// One tree a cutter that has blocks.
fn trees(setup: &Milling<'_>, blocks: &[Block]) -> Vec<Tree> {
    let members = |cutter: usize| -> Vec<usize> {
        (0..blocks.len()).filter(|&i| setup.paths[blocks[i].path].cutter == cutter).collect()
    };
    let trees = setup.cutters.iter().enumerate();
    trees.map(|(i, cutter)| Tree::new(Part::of(cutter), blocks, members(i))).collect()
}
