//! Rays on the surfaces of the whole part: flanks of all spaces, the body between them, tips and ends of the teeth. What a motion
//! does to any of them is judged, whether or not the job mills it.

use super::finding::failure;
use super::prepare::MillingBodies;
use super::referee::DEPTH;
use crate::{MilledSide, MillingPlan, RootPart, Space, SpaceFlank, WallKind, drawn_root};
use foundation::geometry::{Frustum, Surface};
use foundation::numerics::equidistant;
use nalgebra::{Rotation3, Vector3};
use referee::NormalRay;
use run::RunFailure;
use std::f64::consts::TAU;

/// Places without a ray, for scopes.
pub(super) const THIN_BACKS: &str = "backs of blades of 1 mm and less";

/// A surface of the part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum PartSurface {
    /// A flank of a space.
    Flank(MilledSide),
    /// Root cylinder, root cone or hub.
    Floor,
    /// A fillet or the bottom as the job draws it.
    Drawn(RootPart),
    /// The backs of blades.
    Back,
    /// The tops of the teeth.
    Tip,
    /// The ends of the teeth at both faces.
    End,
}

impl PartSurface {
    /// Its name, for a body with teeth or with blades.
    pub fn name(self, bodies: &MillingBodies) -> String {
        match self {
            Self::Flank(side) => format!("{side} flank"),
            Self::Floor if has_blades(bodies) => "hub".into(),
            Self::Floor => "root body".into(),
            Self::Drawn(RootPart::Fillet(side)) => format!("{side} fillet"),
            Self::Drawn(RootPart::Bottom) => "bottom of the root".into(),
            Self::Back => "backs of the blades".into(),
            Self::Tip => "tips of teeth".into(),
            Self::End => "ends of teeth".into(),
        }
    }
}

/// Whether the body has blades: one flank beside every passage.
fn has_blades(bodies: &MillingBodies) -> bool {
    bodies.parts.iter().all(|space| space.flanks.len() < 2)
}

/// A ray on the part.
#[derive(Clone, Copy, Debug)]
pub(super) struct PartRay {
    pub ray: NormalRay,
    pub surface: PartSurface,
    /// Space, from 0.
    pub space: usize,
    /// How much stock may be left there, mm; none where the job does not say.
    pub stock: Option<f64>,
}

/// How closely rays stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Closeness {
    /// A few on every surface: enough for a cutter that stands wrong beside its own flank.
    Coarse,
    /// At every row and between rows, and nowhere farther apart than a cutter is wide.
    Rows,
}

/// Rays over height and length of a flank with [`Closeness::Coarse`].
const COARSE: [usize; 2] = [5, 9];
/// Distance of rays along the teeth over the diameter of the thinnest cutter.
const SHARE: f64 = 0.7;
/// Rays along the teeth at least and at most.
const ALONG: [usize; 2] = [5, 61];
/// Rays from root to tip at most.
const MOST_HEIGHTS: usize = 41;
/// Rays across the floor between two flanks, and across a tip.
const ACROSS: [usize; 2] = [9, 3];
/// Rays over the height of a blade's back.
const BACK: usize = 9;
/// Thickness of a blade over the depth of the rays from which on its back has any.
const THINNEST: f64 = 1.05;
/// Rays on every fillet and on the bottom of a drawn root.
const DRAWN: [usize; 2] = [7, 9];
/// Share of a tip's width next to an edge that has no ray: there the flank is judged.
const EDGE: f64 = 0.1;

/// Rays of the part, space by space; on flanks that are milled no more stock than the tolerance (mm) may be left.
///
/// # Errors
/// [`RunFailure`] where the drawn root has no section.
pub(super) fn part_rays(
    bodies: &MillingBodies,
    plan: &MillingPlan,
    closeness: Closeness,
    tolerance: f64,
) -> Result<Vec<PartRay>, RunFailure> {
    let mut first = Vec::new();
    for space in &bodies.parts {
        let along = along(bodies, space, closeness);
        for flank in &space.flanks {
            first.extend(flank_rays(plan, flank, (along, tolerance), closeness)?);
        }
        first.extend(floor_rays(bodies, space, along)?);
        first.extend(back_rays(space, along));
        if closeness == Closeness::Rows && bodies.options.root.is_some() {
            first.extend(drawn_rays(bodies, plan, space, along)?);
        }
    }
    if let Some(space) = bodies.parts.first() {
        first.extend(tip_rays(space, along(bodies, space, closeness)));
        first.extend(end_rays(bodies, space));
    }
    let turned = |number: usize| {
        let turn = Rotation3::from_axis_angle(&Vector3::z_axis(), bodies.pitch * number as f64);
        let of = move |at: &PartRay| PartRay {
            ray: NormalRay { point: turn * at.ray.point, normal: turn * at.ray.normal },
            space: number,
            stock: at.stock.filter(|_| number < bodies.milled),
            ..*at
        };
        first.iter().map(of).collect::<Vec<_>>()
    };
    Ok((0..bodies.spaces).flat_map(turned).collect())
}

/// The greatest distance of two rays along the teeth, mm.
pub(super) fn spacing(bodies: &MillingBodies, plan: &MillingPlan) -> f64 {
    let of = |space: &Space| {
        let count = along(bodies, space, Closeness::Rows);
        length_of(space) / (count - 1) as f64
    };
    let between_rows = plan.flanks.iter().map(|flank| flank.lines.dense.along_columns.greatest);
    bodies.parts.iter().map(of).chain(between_rows).fold(0.0, f64::max)
}

/// Length of the teeth of a space, mm.
fn length_of(space: &Space) -> f64 {
    let Some(flank) = space.flanks.first() else { return 0.0 };
    let foot = flank.active.height_span()[0];
    let points: Vec<Vector3<f64>> =
        equidistant(flank.active.face, 17).into_iter().map(|b| flank.active.surface.point(foot, b)).collect();
    points.windows(2).map(|pair| (pair[1] - pair[0]).norm()).sum()
}

fn along(bodies: &MillingBodies, space: &Space, closeness: Closeness) -> usize {
    let options = &bodies.options;
    let others = options.bottom_cutter.iter().chain(&options.roughing_cutter);
    let thinnest = others.chain([&options.cutter]).map(|cutter| 2.0 * cutter.shape().radius());
    let wide = SHARE * thinnest.fold(f64::INFINITY, f64::min);
    match closeness {
        Closeness::Coarse => COARSE[1],
        Closeness::Rows => ((length_of(space) / wide).ceil() as usize + 1).clamp(ALONG[0], ALONG[1]),
    }
}

fn flank_rays(
    plan: &MillingPlan,
    flank: &SpaceFlank,
    (along, tolerance): (usize, f64),
    closeness: Closeness,
) -> Result<Vec<PartRay>, RunFailure> {
    let side = flank.side();
    let made = plan.flanks.iter().find(|made| made.side == side);
    let span = flank.active.height_span();
    let heights = match (closeness, made) {
        (Closeness::Rows, Some(made)) => row_heights(made, span),
        _ => equidistant(span, COARSE[0]),
    };
    let mut rays = Vec::new();
    for &height in &heights {
        for length in equidistant(flank.active.face, along) {
            let jet = flank.active.surface.jet(height, length);
            let reached = match made {
                Some(made) => made.reaches(height, length).map_err(|error| failure(&error))?,
                None => false,
            };
            let stock = reached.then_some(tolerance);
            let ray = NormalRay { point: jet.point, normal: jet.normal };
            rays.push(PartRay { ray, surface: PartSurface::Flank(side), space: 0, stock });
        }
    }
    Ok(rays)
}

/// Heights of the rows in the middle of the teeth, and between them where they are few.
fn row_heights(made: &crate::FlankPlan, span: [f64; 2]) -> Vec<f64> {
    let columns = &made.lines.path.columns;
    let middle = columns.get(columns.len() / 2);
    let [low, high] = [span[0].min(span[1]), span[0].max(span[1])];
    let mut rows: Vec<f64> = middle
        .into_iter()
        .flat_map(|column| &column.places)
        .map(|place| place.height.clamp(low, high))
        .collect();
    if rows.len() > MOST_HEIGHTS {
        return equidistant(span, MOST_HEIGHTS);
    }
    if 2 * rows.len() <= MOST_HEIGHTS {
        let between: Vec<f64> = rows.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])).collect();
        rows.extend(between);
    }
    rows.extend(span);
    rows.sort_by(f64::total_cmp);
    rows.dedup();
    rows
}

/// Azimuth about the axis as frusta count it.
fn azimuth(point: &Vector3<f64>) -> f64 {
    point.x.atan2(point.y)
}

fn near(angle: f64, to: f64) -> f64 {
    angle - TAU * ((angle - to) / TAU).round()
}

/// How far a drawn root lies below the body at most, <= 0, mm.
fn drawn_below(bodies: &MillingBodies, space: &Space, face: [f64; 2]) -> Result<f64, RunFailure> {
    let mut lowest = 0.0f64;
    for u in equidistant(face, 5) {
        for at in drawn_root(space, &bodies.options, u, DRAWN).map_err(|error| failure(&error))? {
            let jet = bodies.floor.jet(azimuth(&at.point), share_at(bodies, &at.point));
            lowest = lowest.min((at.point - jet.point).dot(&jet.normal));
        }
    }
    Ok(lowest)
}

/// Where on the body between the teeth a place lies, from one end to the other.
fn share_at(bodies: &MillingBodies, point: &Vector3<f64>) -> f64 {
    let Frustum { radii, positions, .. } = bodies.floor;
    // Along its meridian: the root cone of a crown gear is nearly a plane across the axis.
    let way = [radii[1] - radii[0], positions[1] - positions[0]];
    let from = [point.xy().norm() - radii[0], point.z - positions[0]];
    ((from[0] * way[0] + from[1] * way[1]) / (way[0] * way[0] + way[1] * way[1])).clamp(0.0, 1.0)
}

fn floor_rays(bodies: &MillingBodies, space: &Space, along: usize) -> Result<Vec<PartRay>, RunFailure> {
    let Some(flank) = space.flanks.first() else { return Ok(Vec::new()) };
    let active = &flank.active;
    let below = drawn_below(bodies, space, active.face)?;
    let mut rays = Vec::new();
    for length in equidistant(active.face, along) {
        let foot = active.surface.jet(active.height_span()[0], length);
        let share = share_at(bodies, &foot.point);
        let begin = azimuth(&foot.point);
        let end = match space.opposite(flank.side) {
            Some(other) => {
                let point = other.active.surface.point(other.active.height_span()[0], length);
                near(azimuth(&point), begin)
            }
            None => {
                // Beside a blade the passage lies where its normal points to.
                let around = Vector3::new(begin.cos(), -begin.sin(), 0.0);
                begin + bodies.pitch * around.dot(&foot.normal).signum()
            }
        };
        for at in equidistant([begin, end], ACROSS[0]) {
            let jet = bodies.floor.jet(at, share);
            let ray = NormalRay { point: jet.point + jet.normal * below, normal: jet.normal };
            rays.push(PartRay { ray, surface: PartSurface::Floor, space: 0, stock: None });
        }
    }
    Ok(rays)
}

fn drawn_rays(
    bodies: &MillingBodies,
    plan: &MillingPlan,
    space: &Space,
    along: usize,
) -> Result<Vec<PartRay>, RunFailure> {
    let Some(flank) = space.flanks.first() else { return Ok(Vec::new()) };
    let half = flank.side().half;
    let mut rays = Vec::new();
    for u in equidistant(flank.active.face, along) {
        let mut reached = true;
        for made in plan.flanks.iter().filter(|made| made.side.half == half) {
            reached &= made.reaches(made.active.height_span()[0], u).map_err(|error| failure(&error))?;
        }
        if !reached {
            continue;
        }
        for at in drawn_root(space, &bodies.options, u, DRAWN).map_err(|error| failure(&error))? {
            let ray = NormalRay { point: at.point, normal: at.normal };
            rays.push(PartRay { ray, surface: PartSurface::Drawn(at.part), space: 0, stock: None });
        }
    }
    Ok(rays)
}

/// Places on the back of the blade of a passage, each with the thickness of the blade there, mm.
fn back_places(space: &Space, along: usize) -> Vec<(NormalRay, f64)> {
    let own = space.flanks.first().map(|flank| &flank.active.surface);
    let mut places = Vec::new();
    for wall in space.walls.iter().filter(|wall| wall.kind == WallKind::Back && wall.turn == 0.0) {
        for height in equidistant(wall.heights, BACK) {
            for length in equidistant(wall.lengths, along) {
                let jet = wall.surface.jet(height, length);
                let thickness = own.map_or(0.0, |own| (own.point(height, length) - jet.point).norm());
                places.push((NormalRay { point: jet.point, normal: -jet.normal }, thickness));
            }
        }
    }
    places
}

/// Whether a ray on the back of a blade would come out on the other side, where the cutter mills.
fn is_thin(thickness: f64) -> bool {
    thickness < THINNEST * DEPTH
}

/// Whether backs of blades have places without a ray, because the blade is thinner than rays are deep.
pub(super) fn has_thin_backs(bodies: &MillingBodies) -> bool {
    let places = bodies.parts.iter().flat_map(|space| back_places(space, COARSE[1]));
    places.into_iter().any(|(_, thickness)| is_thin(thickness))
}

/// The back of the blade of a passage, from hub to tip, where it is thick enough.
fn back_rays(space: &Space, along: usize) -> Vec<PartRay> {
    let thick = back_places(space, along).into_iter().filter(|(_, thickness)| !is_thin(*thickness));
    thick.map(|(ray, _)| PartRay { ray, surface: PartSurface::Back, space: 0, stock: None }).collect()
}

/// Tops of the teeth on one side of the space: with those of all spaces they are all there are.
fn tip_rays(space: &Space, along: usize) -> Vec<PartRay> {
    let pieces: Vec<_> = space.lands.iter().step_by(2).collect();
    let each = along.div_ceil(pieces.len().max(1)).max(2);
    let mut rays = Vec::new();
    for land in pieces {
        let [low, high] = land.azimuths;
        let edge = EDGE * (high - low);
        for azimuth in equidistant([low + edge, high - edge], ACROSS[1]) {
            for share in equidistant([0.0, 1.0], each) {
                let jet = land.surface.jet(azimuth, share);
                let ray = NormalRay { point: jet.point, normal: jet.normal };
                rays.push(PartRay { ray, surface: PartSurface::Tip, space: 0, stock: None });
            }
        }
    }
    rays
}

/// Both ends of a tooth of a cylindrical gear, in the middle of the tooth.
fn end_rays(bodies: &MillingBodies, space: &Space) -> Vec<PartRay> {
    let lands: Vec<_> = space.lands.iter().step_by(2).collect();
    let mut rays = Vec::new();
    for (share, outward) in [(0.0, -1.0), (1.0, 1.0)] {
        let position = bodies.floor.positions[usize::from(outward > 0.0)];
        let at_end = |land: &&&crate::Land| {
            land.surface.positions[usize::from(outward > 0.0)] == position
                && land.surface.radii[0] == land.surface.radii[1]
        };
        let Some(land) = lands.iter().find(at_end) else { continue };
        let middle = 0.5 * (land.azimuths[0] + land.azimuths[1]);
        let tip = land.surface.point(middle, share);
        let radial = Vector3::new(tip.x, tip.y, 0.0).normalize();
        let radii = [bodies.floor.radii[0], land.surface.radii[0]];
        for part in [0.1, 0.5, 0.9] {
            let point = radial * (radii[0] + part * (radii[1] - radii[0])) + Vector3::z() * tip.z;
            let ray = NormalRay { point, normal: Vector3::z() * outward };
            rays.push(PartRay { ray, surface: PartSurface::End, space: 0, stock: None });
        }
    }
    rays
}
