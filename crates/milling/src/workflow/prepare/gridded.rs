//! Gears of a job whose flanks are surfaces through points as spaces to be milled: hypoid gears, and flanks that another program
//! calculated or a machine measured (`docs/mathematics/milling.md#flanks-as-patches`).

use super::body::{Body, CLEARANCE, floor, part};
use super::lands::lands;
use super::walls::{below_root_body, root_body};
use crate::job::{BodyLine, FlankPoints, GridGear, LoadedMillingJob, read_flank_points};
use crate::{ActiveFlank, FootOnHub, HeightLimits, Retraction, SpaceFlank};
use foundation::geometry::{Flank, GridSurface, NormalSide, Sides, SplineCurve, Surface};
use foundation::numerics::equidistant;
use job::{Diagnostic, Problem};
use nalgebra::Vector3;
use run::{RunFailure, geometry_finding};
use std::f64::consts::TAU;
use std::sync::Arc;

/// From the first point of the rows to the last one; the surfaces go on beyond them.
const FACE: [f64; 2] = [0.0, 1.0];
/// How far they go on, as a share of the rows' length: column planes and the overrun reach there.
const BEYOND: f64 = 0.5;
/// Pieces of a land between which the turn of the teeth is linear.
const LAND_PIECES: usize = 8;
/// By which share of a pitch the middle of the space may lie beside +y.
const BESIDE: f64 = 0.25;

/// Both flanks of a space with what lies between them.
struct GridSpace {
    flanks: Sides<GridSurface>,
    root: BodyLine,
    tip: BodyLine,
}

/// The gear of a job.
///
/// # Errors
/// [`RunFailure`] with a finding on the key concerned.
pub(super) fn gridded(loaded: &LoadedMillingJob, given: &GridGear) -> Result<Body, RunFailure> {
    let read = |side: Flank| match side {
        Flank::Left => rows(loaded, &given.left, "grid_gear.left"),
        Flank::Right => rows(loaded, &given.right, "grid_gear.right"),
    };
    let points = Sides::try_from_fn(read)?;
    let space = GridSpace::new(&points, given)?;
    let spaces = given.teeth as usize;
    let lead = space.lead()?;
    let off = azimuth(&lead.curve.derivatives(0.5)[0]);
    if off.abs() > BESIDE * TAU / spaces as f64 {
        return Err(refused(
            "grid_gear.left.file",
            format!("the middle of the space lies {:.3} degrees beside +y", off.to_degrees()),
            "turn the points of both flanks about z until their space stands about +y",
        ));
    }
    let flank = |side: Flank| SpaceFlank {
        side,
        active: ActiveFlank {
            surface: Arc::new(space.flanks[side].clone()),
            heights: HeightLimits::Constant([0.0, 1.0]),
            face: FACE,
            kink: None,
        },
    };
    let flanks: Vec<SpaceFlank> = Flank::BOTH.into_iter().map(flank).collect();
    let place = |length: f64| space.middle(1.0, length, &space.tip);
    let lands = lands(&flanks, spaces, &equidistant(FACE, LAND_PIECES + 1), place, 1.0);
    let mut made = part(loaded.job.milling.skew_deg, flanks, Arc::new(lead), spaces, lands);
    let below = below_root_body(loaded.job.milling.root.as_ref(), 0.0);
    let root = given.root.ends();
    made.walls.push(root_body(lowered(root, below)));
    let tip = given.tip.ends();
    Ok(Body {
        parts: vec![made],
        unknown: Vec::new(),
        spaces,
        retraction: retraction(tip),
        blank: [tip[0], tip[1], [0.5 * root[1][0], root[1][1]], [0.5 * root[0][0], root[0][1]]],
        floor: floor(root, 1.0),
    })
}

/// Azimuth of a point, clockwise from +y seen from +z, rad.
fn azimuth(point: &Vector3<f64>) -> f64 {
    point.x.atan2(point.y)
}

/// Where the cutter is out of the workpiece: outside of the cone through the tips, or of the cylinder around them where they do not open
/// towards +z.
fn retraction([first, last]: [[f64; 2]; 2]) -> Retraction {
    let slope = (last[0] - first[0]) / (last[1] - first[1]);
    if slope <= 0.0 {
        return Retraction::Outside(first[0].max(last[0]) + CLEARANCE);
    }
    Retraction::OutsideCone {
        half_angle: slope.atan(),
        distance: CLEARANCE,
        apex: first[1] - first[0] / slope,
    }
}

/// A body so many mm inside of the drawn one.
fn lowered(ends: [[f64; 2]; 2], below: f64) -> [[f64; 2]; 2] {
    let (radial, axial) = (ends[1][0] - ends[0][0], ends[1][1] - ends[0][1]);
    let length = radial.hypot(axial) * axial.signum();
    ends.map(|[radius, position]| [radius - below * axial / length, position + below * radial / length])
}

fn refused(field: &str, message: String, way_out: &str) -> RunFailure {
    RunFailure::bad_input(Diagnostic::new(Problem::InvalidTable, message).field(field).way_out(way_out))
}

/// Points of a flank, row by row.
fn rows(
    loaded: &LoadedMillingJob,
    given: &FlankPoints,
    table: &str,
) -> Result<Vec<Vec<Vector3<f64>>>, RunFailure> {
    let grid = read_flank_points(&loaded.beside(&given.file), given, table).map_err(|error| {
        let message = error.diagnostics.first().map_or_else(|| error.to_string(), |d| d.message.to_string());
        refused(&format!("{table}.file"), format!("{}: {message}", given.file), "correct the table of points")
    })?;
    Ok(grid.points.iter().map(|row| row.iter().map(|p| Vector3::from(*p)).collect()).collect())
}

impl GridSpace {
    /// Surfaces through the points, with their normals into the space.
    fn new(points: &Sides<Vec<Vec<Vector3<f64>>>>, given: &GridGear) -> Result<Self, RunFailure> {
        let middle = |side: Flank| {
            let rows = &points[side];
            let row = &rows[rows.len() / 2];
            row[row.len() / 2]
        };
        let way = |side: Flank| {
            let row = &points[side][0];
            row[row.len() - 1] - row[0]
        };
        if way(Flank::Left).dot(&way(Flank::Right)) <= 0.0 {
            return Err(refused(
                "grid_gear.right.file",
                "the rows of both flanks do not run the same way".into(),
                "let the rows of both tables begin at the same end of the face",
            ));
        }
        let surface = |side: Flank| {
            let table = format!("grid_gear.{}", side.name());
            let made = GridSurface::new(&points[side], NormalSide::Along)
                .map_err(|error| RunFailure::bad_input(geometry_finding(&error, &table)))?;
            // Normals point out of the material, which is into the space.
            let across = middle(side.other()) - middle(side);
            let along = made.jet(0.5, 0.5).normal.dot(&across) > 0.0;
            let normals = if along { NormalSide::Along } else { NormalSide::Against };
            GridSurface::new(&points[side], normals)
                .and_then(|surface| surface.extended(BEYOND))
                .map_err(|error| RunFailure::bad_input(geometry_finding(&error, &table)))
        };
        let space = Self { flanks: Sides::try_from_fn(surface)?, root: given.root, tip: given.tip };
        space.check(points)?;
        Ok(space)
    }

    /// Rows lie outside of the root body, ascend to the tip, and the left flank is to the left of the right one.
    fn check(&self, points: &Sides<Vec<Vec<Vector3<f64>>>>) -> Result<(), RunFailure> {
        for (side, rows) in points.iter() {
            let file = format!("grid_gear.{}.file", side.name());
            let height = |point: &Vector3<f64>| across(&self.root, point);
            let lowest = rows[0].iter().map(height).fold(f64::INFINITY, f64::min);
            if lowest < 0.0 {
                return Err(refused(
                    &file,
                    format!("a point of the first row lies {:.4} mm inside of the root body", -lowest),
                    "let the first row lie where the active flank begins, and compare it with `grid_gear.root`",
                ));
            }
            let column = rows[0].len() / 2;
            if height(&rows[rows.len() - 1][column]) <= height(&rows[0][column]) {
                return Err(refused(
                    &file,
                    "rows do not ascend from root to tip".into(),
                    "let the first row be the one at the root",
                ));
            }
        }
        // Seen from +z towards -z the left flank of a space lies at the greater clockwise azimuth.
        let at = |side: Flank| azimuth(&self.flanks[side].point(0.5, 0.5));
        if at(Flank::Left) <= at(Flank::Right) {
            return Err(refused(
                "grid_gear.left.file",
                "the left flank lies where the right one of the space should be".into(),
                "exchange both tables: seen from +z towards -z, with the space at the top, the left flank of the space is that at +x",
            ));
        }
        Ok(())
    }

    /// Radius, position and azimuth of the middle between both flanks at a height and a
    /// length, on a body.
    fn middle(&self, height: f64, length: f64, body: &BodyLine) -> [f64; 3] {
        let ends = Flank::BOTH.map(|side| self.flanks[side].point(height, length));
        let share = 0.5 * ends.iter().map(|point| along(body, point)).sum::<f64>();
        let [first, last] = body.ends();
        let turn = 0.5 * ends.iter().map(azimuth).sum::<f64>();
        [first[0] + share * (last[0] - first[0]), first[1] + share * (last[1] - first[1]), turn]
    }

    /// The middle of the bottom, on the root body.
    fn lead(&self) -> Result<FootOnHub, RunFailure> {
        let lengths = self.flanks.left.lengths();
        let point = |length: &f64| {
            let [radius, position, turn] = self.middle(0.0, *length, &self.root);
            Vector3::new(radius * turn.sin(), radius * turn.cos(), position)
        };
        let points: Vec<Vector3<f64>> = lengths.iter().map(point).collect();
        let curve = SplineCurve::new(lengths, &points).map_err(|error| {
            refused(
                "grid_gear.left.file",
                format!("the middle of the space: {error}"),
                "correct the points of the first rows",
            )
        })?;
        Ok(FootOnHub { curve: Arc::new(curve) })
    }
}

/// Share of a body's length at which a point stands above it.
fn along(body: &BodyLine, point: &Vector3<f64>) -> f64 {
    let [first, last] = body.ends();
    let (radial, axial) = (last[0] - first[0], last[1] - first[1]);
    let (radius, position) = (point.xy().norm(), point.z);
    ((radius - first[0]) * radial + (position - first[1]) * axial) / (radial * radial + axial * axial)
}

/// How far a point is outside of a body, mm.
fn across(body: &BodyLine, point: &Vector3<f64>) -> f64 {
    let [first, last] = body.ends();
    let (radial, axial) = (last[0] - first[0], last[1] - first[1]);
    let (radius, position) = (point.xy().norm(), point.z);
    axial.signum() * ((radius - first[0]) * axial - (position - first[1]) * radial) / radial.hypot(axial)
}
