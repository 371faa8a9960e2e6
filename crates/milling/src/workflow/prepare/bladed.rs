//! Blades of a job as passages to be milled: one side of them, the hub that they stand on, and the blades beside it with their backs.

use super::body::{Body, CLEARANCE, floor, part};
use super::walls::hub;
use crate::job::{LoadedMillingJob, read_point_grid};
use crate::{
    ActiveFlank, FootOnHub, HeightLimits, LeadCurve, Retraction, SpaceFlank, Wall, WallKind, job as drawn,
};
use foundation::geometry::{
    BladeData, Flank, GridSurface, Modified, NormalOffset, NormalSide, OffsetBase, OffsetBounds, RuledBlade,
    SplineCurve, Surface,
};
use foundation::numerics::{Jet2, extremes};
use job::{Diagnostic, Problem};
use nalgebra::Vector3;
use run::{RunFailure, geometry_finding};
use std::f64::consts::TAU;
use std::sync::Arc;
use verdict::Remark;

/// A blade's length parameters from end to end; its surface goes on beyond them.
const FACE: [f64; 2] = [0.0, 1.0];

/// The back of a blade as seen from the side that is milled: against its normal by a thickness that is linear over the height. mm.
#[derive(Clone, Copy, Debug)]
struct Back {
    /// At the hub and at the tip.
    thickness: [f64; 2],
}

impl NormalOffset for Back {
    fn jet(&self, height: f64, _: f64) -> Jet2 {
        let [hub, tip] = self.thickness;
        Jet2 { f: -(hub + (tip - hub) * height), fu: hub - tip, ..Jet2::default() }
    }

    fn bounds(&self, heights: [f64; 2], _: [f64; 2]) -> OffsetBounds {
        let [hub, tip] = self.thickness;
        let value = heights.map(|height| (hub + (tip - hub) * height).abs());
        OffsetBounds {
            value: value[0].max(value[1]),
            by_height: (tip - hub).abs(),
            by_length: 0.0,
            second: [0.0; 3],
        }
    }
}

/// The back of a side, where the job says how thick the blade is.
fn back<S: OffsetBase + 'static>(given: &drawn::Blade, side: S) -> Option<Arc<dyn Surface>> {
    let thickness = given.thickness?;
    Some(Arc::new(Modified::new(side, Arc::new(Back { thickness }))))
}

/// A blade's surface with the curve at its foot.
struct BladeSide {
    surface: Arc<dyn Surface>,
    /// The back, where the job says how thick the blade is.
    back: Option<Arc<dyn Surface>>,
    foot: Arc<dyn LeadCurve>,
    /// Largest radius, mm.
    tip: f64,
    /// Ends along the axis, mm.
    ends: [f64; 2],
}

pub(super) fn bladed(loaded: &LoadedMillingJob, given: &drawn::Blade) -> Result<Body, RunFailure> {
    let blade = match (&given.ruled, &given.points) {
        (Some(ruled), _) => ruled_side(given, ruled)?,
        (None, Some(points)) => point_side(loaded, given, points)?,
        (None, None) => {
            let finding = Diagnostic::new(Problem::MissingKey, "the blade has no surface")
                .field("blade")
                .way_out("give one of `ruled` and `points`");
            return Err(RunFailure::bad_input(finding));
        }
    };
    let spaces = given.count as usize;
    let ([from, to], [start, end]) = (given.hub_radius, blade.ends);
    let mut walls = vec![hub(given.hub_radius, blade.ends)];
    walls.extend(beside(&blade, spaces));
    let active = ActiveFlank {
        surface: blade.surface,
        heights: HeightLimits::Constant(given.active_height),
        face: FACE,
        kink: None,
    };
    let side = given.side().map_or(Flank::Left, drawn::BladeSide::flank);
    let flanks = vec![SpaceFlank { side, active }];
    let mut space = part(loaded.job.milling.skew_deg, flanks, blade.foot, spaces, Vec::new());
    space.walls = walls;
    let unknown = given.thickness.is_none().then(|| Remark {
        code: "blade-back-not-judged",
        text: "nothing is known of the backs of the blades, so that nothing keeps the cutter from that of the blade across the passage"
            .into(),
        way_out: "give `blade.thickness` at hub and tip".into(),
    });
    Ok(Body {
        parts: vec![space],
        unknown: unknown.into_iter().collect(),
        spaces,
        retraction: Retraction::Outside(blade.tip + CLEARANCE),
        blank: [[blade.tip, start], [blade.tip, end], [0.5 * to, end], [0.5 * from, start]],
        floor: floor([[from, start], [to, end]], 1.0),
    })
}

/// The blades on both sides of the one that is milled, from hub to tip, and all backs that are known.
fn beside(blade: &BladeSide, count: usize) -> Vec<Wall> {
    let pitch = TAU / count as f64;
    let wall = |(name, kind), surface: &Arc<dyn Surface>, turn| Wall {
        name,
        kind,
        surface: surface.clone(),
        heights: [0.0, 1.0],
        lengths: FACE,
        turn,
    };
    let turns: &[f64] = if count > 1 { &[pitch, -pitch] } else { &[] };
    let mut walls: Vec<Wall> = turns
        .iter()
        .map(|turn| wall(("neighbouring blade", WallKind::Blade), &blade.surface, *turn))
        .collect();
    if let Some(back) = &blade.back {
        walls.push(wall(("back of the blade", WallKind::Back), back, 0.0));
        let beside = ("back of the neighbouring blade", WallKind::Back);
        walls.extend(turns.iter().map(|turn| wall(beside, back, *turn)));
    }
    walls
}

fn normal_side(side: drawn::BladeSide) -> NormalSide {
    if side.sign() > 0.0 { NormalSide::Along } else { NormalSide::Against }
}

fn ruled_side(given: &drawn::Blade, ruled: &drawn::RuledBlade) -> Result<BladeSide, RunFailure> {
    let data = BladeData {
        hub_radius: given.hub_radius,
        tip_radius: ruled.tip_radius,
        length: ruled.length,
        hub_azimuth: ruled.azimuth_deg.map(f64::to_radians),
        tip_lead: ruled.tip_lead_deg.map(f64::to_radians),
        side: normal_side(ruled.side),
    };
    let blade = RuledBlade::of_data(&data)
        .map_err(|error| RunFailure::bad_input(geometry_finding(&error, "blade")))?;
    Ok(BladeSide {
        foot: Arc::new(FootOnHub { curve: blade.hub().clone() }),
        back: back(given, blade.clone()),
        surface: Arc::new(blade),
        tip: ruled.tip_radius,
        ends: [0.0, ruled.length],
    })
}

fn point_side(
    loaded: &LoadedMillingJob,
    given: &drawn::Blade,
    points: &drawn::BladePoints,
) -> Result<BladeSide, RunFailure> {
    let refused = |message: String| {
        let finding = Diagnostic::new(Problem::InvalidTable, format!("{}: {message}", points.file));
        RunFailure::bad_input(finding.field("blade.points.file").way_out("correct the table of points"))
    };
    let grid = read_point_grid(&loaded.beside(&points.file), points).map_err(|error| {
        refused(error.diagnostics.first().map_or_else(|| error.to_string(), |d| d.message.to_string()))
    })?;
    let rows: Vec<Vec<Vector3<f64>>> =
        grid.points.iter().map(|row| row.iter().map(|p| Vector3::from(*p)).collect()).collect();
    let surface = GridSurface::new(&rows, normal_side(points.side))
        .map_err(|error| RunFailure::bad_input(geometry_finding(&error, "blade")))?;
    let foot = SplineCurve::new(surface.lengths(), &rows[0]).map_err(|error| refused(error.to_string()))?;
    let all = rows.iter().flatten();
    Ok(BladeSide {
        back: back(given, surface.clone()),
        surface: Arc::new(surface),
        foot: Arc::new(FootOnHub { curve: Arc::new(foot) }),
        tip: extremes(all.clone().map(|p| p.xy().norm()))[1],
        ends: extremes(all.map(|p| p.z)),
    })
}
