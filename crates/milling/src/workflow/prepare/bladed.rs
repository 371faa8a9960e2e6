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
    let blade = match (&given.ruled, &given.points, &given.naca) {
        (Some(ruled), ..) => ruled_side(given, ruled)?,
        (None, Some(points), _) => point_side(loaded, given, points)?,
        (None, None, Some(naca)) => naca_side(given, naca)?,
        (None, None, None) => {
            let finding = Diagnostic::new(Problem::MissingKey, "the blade has no surface")
                .field("blade")
                .way_out("give one of `ruled`, `points` and `naca`");
            return Err(RunFailure::bad_input(finding));
        }
    };
    let spaces = given.count as usize;
    let ([from, to], [start, end]) = (given.hub_radius, blade.ends);
    let back_is_unknown = blade.back.is_none();
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
    let unknown = back_is_unknown.then(|| Remark {
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
    let surface = extended(&rows, normal_side(points.side))?;
    let foot = foot(&surface)?;
    let all = rows.iter().flatten();
    Ok(BladeSide {
        back: back(given, surface.clone()),
        surface: Arc::new(surface),
        foot,
        tip: extremes(all.clone().map(|p| p.xy().norm()))[1],
        ends: extremes(all.map(|p| p.z)),
    })
}

/// How far a surface through points goes on beyond the ends of its rows, as a share of their length: column planes of twisted blades reach
/// there, and so does the overrun.
const BEYOND: f64 = 0.5;

/// A surface through rows of points, from the hub.
fn extended(rows: &[Vec<Vector3<f64>>], side: NormalSide) -> Result<GridSurface, RunFailure> {
    let surface = GridSurface::new(rows, side).and_then(|surface| surface.extended(BEYOND));
    surface.map_err(|error| RunFailure::bad_input(geometry_finding(&error, "blade")))
}

/// The line in which a surface stands on the hub.
fn foot(surface: &GridSurface) -> Result<Arc<dyn LeadCurve>, RunFailure> {
    let points: Vec<Vector3<f64>> =
        surface.lengths().iter().map(|length| surface.point(surface.heights()[0], *length)).collect();
    let curve = SplineCurve::new(surface.lengths(), &points).map_err(|error| {
        let finding = Diagnostic::new(Problem::InvalidTable, format!("the line at the hub: {error}"));
        RunFailure::bad_input(finding.field("blade").way_out("correct the points at the hub"))
    })?;
    Ok(Arc::new(FootOnHub { curve: Arc::new(curve) }))
}

/// Rows from hub to tip and points of a row, laid closer towards both edges, in which sections are taken.
const SECTIONS: [usize; 2] = [5, 25];

/// One surface of blades of four-digit sections, the other as their back.
fn naca_side(given: &drawn::Blade, naca: &drawn::NacaBlade) -> Result<BladeSide, RunFailure> {
    let sections = naca.sections.each_ref().map(|text| drawn::FourDigits::new(text));
    let [Some(hub), Some(tip)] = sections else {
        let text = "a section of the blade is none of four digits";
        let finding = Diagnostic::new(Problem::UnknownValue, text).field("blade.naca.sections");
        return Err(RunFailure::bad_input(finding.way_out("give e.g. [\"4412\", \"4408\"]")));
    };
    let mix = |[a, b]: [f64; 2], share: f64| a + (b - a) * share;
    let length = naca.chord[0] * naca.stagger_deg[0].to_radians().cos();
    let point = |height: f64, x: f64, sense: f64| {
        let [[x_hub, y_hub], [x_tip, y_tip]] = [hub.point(x, sense), tip.point(x, sense)];
        let chord = mix(naca.chord, height);
        let along = chord * (mix([x_hub, x_tip], height) - 0.5);
        let across = chord * mix([y_hub, y_tip], height);
        let (sin, cos) = mix(naca.stagger_deg, height).to_radians().sin_cos();
        let z = 0.5 * length + along * cos - across * sin;
        let hub_radius = mix(given.hub_radius, z / length);
        let radius = hub_radius + (naca.tip_radius - hub_radius) * height;
        // Around the axis as far as the section goes on its cylinder, in the middle of the hub.
        let middle = mix([mix(given.hub_radius, 0.5), naca.tip_radius], height);
        let (sin, cos) = ((along * sin + across * cos) / middle).sin_cos();
        Vector3::new(-radius * sin, radius * cos, z)
    };
    let [rows, points] = SECTIONS;
    let share = |k: usize, count: usize| k as f64 / (count - 1) as f64;
    let surface = |sense: f64, side: NormalSide| {
        let row = |i: usize| {
            let of = |j: usize| {
                let x = 0.5 - 0.5 * (std::f64::consts::PI * share(j, points)).cos();
                point(share(i, rows), naca.edge + (1.0 - 2.0 * naca.edge) * x, sense)
            };
            (0..points).map(of).collect()
        };
        extended(&(0..rows).map(row).collect::<Vec<Vec<_>>>(), side)
    };
    let (upper, lower) = (|| surface(1.0, NormalSide::Against), || surface(-1.0, NormalSide::Along));
    let (front, other) = match naca.side {
        drawn::NacaSide::Upper => (upper()?, lower()?),
        drawn::NacaSide::Lower => (lower()?, upper()?),
    };
    Ok(BladeSide {
        foot: foot(&front)?,
        surface: Arc::new(front),
        back: Some(Arc::new(other)),
        tip: naca.tip_radius,
        ends: [0.0, length],
    })
}
