//! The space of a job that is milled, what it is milled with, and how.

use super::bevel_pair::BevelPair;
use super::bladed::bladed;
use super::conical::conical;
use super::cutters::Cutters;
use super::cylindrical::cylindrical;
use super::gridded::gridded;
use super::mate::MatePair;
use super::options::options;
use super::workpiece_kind::WorkpieceKind;
use crate::job::{LoadedMillingJob, MilledBody, Spaces};
use crate::workflow::finding::failure;
use crate::{MilledSide, PlanOptions, Retraction, Space, SpaceFlank, WallKind, lead_range};
use foundation::geometry::Frustum;
use foundation::numerics::extremes;
use job::{Diagnostic, Problem};
use run::RunFailure;
use std::f64::consts::TAU;
use verdict::Remark;

/// What is milled, with what, and how.
#[derive(Clone, Debug)]
pub struct MillingBodies {
    /// What kind of workpiece it is.
    pub kind: WorkpieceKind,
    /// The space about +y; of a double-helical gear its halves, that towards +z first.
    pub parts: Vec<Space>,
    /// Turn from one space to the next, rad.
    pub pitch: f64,
    /// What it is milled with and how.
    pub options: PlanOptions,
    /// Where the cutter is out of the workpiece.
    pub retraction: Retraction,
    /// Number of spaces of the workpiece.
    pub spaces: usize,
    /// How many of them are milled.
    pub milled: usize,
    /// Section of the body before milling as (radius, position), mm: tip at both ends, bore or rim at the last and the first end.
    pub blank: [[f64; 2]; 4],
    /// The body between the teeth, whether or not it is milled: root cylinder or cone, hub of a blade.
    pub floor: Frustum,
    /// Bodies that the job does not tell of, so that nothing keeps cutters away from them: what is not judged.
    pub unknown: Vec<Remark>,
}

/// Where a flank lies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlankRange {
    /// Which.
    pub side: MilledSide,
    /// Height parameters at root and tip.
    pub heights: [f64; 2],
    /// Least and greatest radius, mm.
    pub radii: [f64; 2],
    /// Lead parameters between which column planes meet it.
    pub lead: [f64; 2],
}

impl MillingBodies {
    /// Where the flanks that are milled lie.
    ///
    /// # Errors
    /// [`RunFailure`] where no column plane holds an end of the face.
    pub fn ranges(&self) -> Result<Vec<FlankRange>, RunFailure> {
        let of_flank = |(part, flank): (&Space, &SpaceFlank)| {
            let active = &flank.active;
            let heights = active.height_span();
            let corners = heights.into_iter().flat_map(|a| active.face.map(|b| (a, b)));
            Ok(FlankRange {
                side: flank.side(),
                heights,
                radii: extremes(corners.map(|(a, b)| active.surface.point(a, b).xy().norm())),
                lead: lead_range(active, &*part.lead).map_err(|error| failure(&error))?,
            })
        };
        let all = self.parts.iter().flat_map(|part| part.flanks.iter().map(move |flank| (part, flank)));
        all.filter(|(_, flank)| self.options.sides.contains(&flank.side)).map(of_flank).collect()
    }

    /// All flanks of the space.
    pub fn flanks(&self) -> impl Iterator<Item = &SpaceFlank> {
        self.parts.iter().flat_map(|part| &part.flanks)
    }
}

/// Bodies and options of a job, and the gear with its mate if there is one.
///
/// # Errors
/// [`RunFailure`] with a finding on the key concerned.
pub(super) fn bodies_of_job(
    loaded: &LoadedMillingJob,
) -> Result<(MillingBodies, Option<MatePair>), RunFailure> {
    let job = &loaded.job;
    let mut cutters = Cutters::of_job(job)?;
    let Some(given) = job.body() else {
        let finding = Diagnostic::new(Problem::MissingKey, "the job has no workpiece")
            .field("gear")
            .way_out("give one of the tables [gear], [bevel], [blade] and [grid_gear]");
        return Err(RunFailure::bad_input(finding));
    };
    let (body, mate) = match given {
        MilledBody::Gear(gear) => (cylindrical(loaded, gear)?, MatePair::cylindrical(loaded, gear)?),
        MilledBody::Bevel(bevel) => {
            let pair = BevelPair::of_job(job, bevel)?;
            let mate = match &pair {
                Some(pair) => MatePair::conical(loaded, pair)?,
                None => None,
            };
            (conical(loaded, bevel, pair.as_ref())?, mate)
        }
        MilledBody::Blade(blade) => (bladed(loaded, blade)?, None),
        MilledBody::Grid(gear) => (gridded(loaded, gear)?, None),
    };
    let milled = match job.milling.teeth {
        Spaces::All => body.spaces,
        Spaces::One => 1,
    };
    let mut unknown = body.unknown;
    if body.parts.iter().flat_map(|part| &part.walls).any(|wall| wall.kind == WallKind::Ring) {
        unknown.extend(cutters.in_bore(body.blank[0][0]));
    }
    let bodies = MillingBodies {
        kind: WorkpieceKind::of_body(&given),
        parts: body.parts,
        pitch: TAU / body.spaces as f64,
        options: options(job, cutters),
        retraction: body.retraction,
        spaces: body.spaces,
        milled,
        blank: body.blank,
        floor: body.floor,
        unknown,
    };
    Ok((bodies, mate))
}
