//! Dressers of generating grinding as bodies, and the strokes in which they dress the worm in line contact, each with its exact
//! envelope. Knows no gear.

use super::disc::{dresser_disc, narrow_disc};
use super::dressing::{Parked, ShownDressing, WormExtent};
use crate::workflow::executed_strokes::ExecutedStroke;
use crate::workflow::execution::{ExecutedFlank, ExecutedTool};
use crate::workflow::generating_finding;
use crate::workflow::run::Outcome;
use contact::ToolSurface;
use dressing::{DressedWorm, DresserSection, DresserTool, DressingError, TipDisc};
use foundation::geometry::Flank;
use foundation::kinematics::{DressingMotion, DressingPosition};
use foundation::numerics::{Chebyshev, equidistant};
use generating::GeneratingError;
use nalgebra::Vector3;
use run::{RunFailure, unmeshed};
use scene::{Body, BodyKind, Stage};

/// Points of the line in which dresser and worm touch.
const LINE: usize = 25;
/// The line is looked for this share of the used profile beside it.
const BESIDE: f64 = 0.1;

/// A dresser as a body.
pub struct ShownDresser {
    pub body: Body,
    /// Its number among those of the job.
    number: usize,
    /// Outside radius, mm.
    tip_radius: f64,
    /// The flank in whose coordinates it is drawn.
    flank: Flank,
    /// How far it is shifted along its axis when it dresses the other flank, mm.
    across: f64,
}

/// A stroke of a dresser. mm, rad.
pub struct Stroke<'a> {
    id: String,
    title: String,
    flank: Flank,
    tool: &'a DresserTool,
    corrections: &'a [Chebyshev; 4],
    motion: &'a DressingMotion,
    driven: [f64; 2],
    /// What of the profile touches, as far as the tip radius lets it.
    profile: [f64; 2],
    tip_radius: f64,
    /// The body of the dresser.
    pub dresser: String,
    /// How far that stands along its axis from where this flank was designed.
    offset: f64,
}

impl Stroke<'_> {
    /// Worm and dresser where the stroke begins.
    pub fn begin(&self) -> DressingPosition {
        self.motion.position(self.driven[0])
    }

    /// The stage, with the bodies that stand aside.
    pub fn stage(&self, extent: &WormExtent, parked: &[Parked]) -> Stage {
        let surface = DressedWorm::new(self.tool, self.flank, self.corrections);
        let profile = &self.tool.flanks[self.flank].profile;
        let line = |v: f64| -> Vec<Vector3<f64>> {
            // Circles beyond the tip radius are not there.
            let there = |t: &f64| profile.covers(*t) && profile.at(*t).r <= self.tip_radius;
            let touched = equidistant(self.profile, LINE).into_iter().filter(there);
            touched.filter_map(|t| Some(surface.jet(t, v)?.p)).collect()
        };
        let shown = ShownDressing {
            id: self.id.clone(),
            title: self.title.clone(),
            motion: self.motion,
            driven: self.driven,
            dresser: &self.dresser,
            offset: self.offset,
            line: &line,
        };
        shown.stage(extent, parked)
    }
}

/// All dressers of a run.
///
/// # Errors
/// [`RunFailure`] for a dresser that cannot be.
pub fn dressers(outcome: &Outcome) -> Result<Vec<ShownDresser>, RunFailure> {
    let setup = &outcome.prepared.setup;
    let first = Flank::BOTH.into_iter().find(|&flank| outcome.execution.flanks[flank].is_some());
    let Some(flank) = first else { return Ok(Vec::new()) };
    if let Some(point) = &outcome.prepared.dressing.point {
        let failed = |e: DressingError| generating_finding::failure(&GeneratingError::Dressing(e));
        let form = TipDisc::new(0.5 * point.tip_diameter, point.tip_radius).map_err(failed)?;
        let mesh = narrow_disc(&form).map_err(|e| unmeshed("dresser", &e))?;
        let body = Body::new("dresser", BodyKind::Dresser, true, &mesh);
        let tip_radius = form.outside_radius();
        return Ok(vec![ShownDresser { body, number: 0, tip_radius, flank, across: 0.0 }]);
    }
    let Some(tool) = &outcome.execution.dresser else { return Ok(Vec::new()) };
    let land = dresser_land(outcome);
    match (&setup.strokes, &setup.input.dresser) {
        (Some(layout), _) => {
            let given = layout.dressers.iter().zip(&layout.tip_radii).enumerate();
            given
                .map(|(number, (tool, &tip))| {
                    let land = land.filter(|_| number == 0);
                    shown_dresser(format!("dresser-{}", number + 1), number, (tool, tip), flank, land)
                })
                .collect()
        }
        (None, Some(choice)) => {
            let tip = 0.5 * choice.tip_diameter;
            Ok(vec![shown_dresser("dresser".into(), 0, (tool, tip), flank, land)?])
        }
        (None, None) => Ok(Vec::new()),
    }
}

/// Width of the land of the dresser: that of the job, else the largest that clears the worm; `None` for a disc whose flanks dress at once.
fn dresser_land(outcome: &Outcome) -> Option<f64> {
    let dressing = &outcome.prepared.dressing;
    if dressing.two_flanks {
        return None;
    }
    let largest = outcome.result.settings.largest_tip_land_mm.as_ref();
    let least = largest.and_then(|lands| lands.left.into_iter().chain(lands.right).reduce(f64::min));
    dressing.tip_land.or(least)
}

fn shown_dresser(
    id: String,
    number: usize,
    (tool, tip_radius): (&DresserTool, f64),
    flank: Flank,
    land: Option<f64>,
) -> Result<ShownDresser, RunFailure> {
    let failed = |e: DressingError| generating_finding::failure(&GeneratingError::Dressing(e));
    let section = DresserSection::new(tool, flank, tip_radius).map_err(failed)?;
    let full = section.full_land();
    let land = land.map_or(full, |land| land.clamp(0.0, full));
    let mesh = dresser_disc(&section, land).map_err(failed)?.map_err(|e| unmeshed("dresser", &e))?;
    // The opposite flank stands in by what the land is narrower; to dress, it stands where it was designed.
    let side = tool.flanks[flank].profile.at(tool.flanks[flank].designed.middle()).n_z.signum();
    let body = Body::new(id, BodyKind::Dresser, true, &mesh);
    Ok(ShownDresser { body, number, tip_radius, flank, across: -side * (full - land) })
}

/// The strokes in which a flank is dressed by discs in line contact.
pub fn strokes_of<'a>(
    outcome: &'a Outcome,
    flank: Flank,
    executed: &'a ExecutedFlank,
    dressers: &[ShownDresser],
) -> Vec<Stroke<'a>> {
    let shown = |number: usize| dressers.iter().find(|dresser| dresser.number == number);
    let offset = |dresser: &ShownDresser| if dresser.flank == flank { 0.0 } else { dresser.across };
    match &executed.tool {
        ExecutedTool::Dressed(dressing) => {
            let (Some(tool), Some(dresser)) = (&outcome.execution.dresser, shown(0)) else {
                return Vec::new();
            };
            let designed = tool.flanks[flank].designed;
            let beside = BESIDE * designed.length();
            vec![Stroke {
                id: format!("dressing-{flank}"),
                title: format!("Dressing the {flank} flank of the worm"),
                flank,
                tool,
                corrections: &dressing.corrections,
                motion: &dressing.motion,
                driven: dressing.driven,
                profile: [designed.w_nf - beside, designed.w_na + beside],
                tip_radius: dresser.tip_radius,
                dresser: dresser.body.id.clone(),
                offset: offset(dresser),
            }]
        }
        ExecutedTool::Stroked(strokes) => {
            let Some(layout) = &outcome.prepared.setup.strokes else { return Vec::new() };
            let of_stroke = |(k, stroke): (usize, &'a ExecutedStroke)| {
                let dresser = shown(stroke.place.dresser)?;
                Some(Stroke {
                    id: format!("dressing-{flank}-{}", k + 1),
                    title: format!("Dressing the {flank} flank of the worm, stroke {}", k + 1),
                    flank,
                    tool: layout.dressers.get(stroke.place.dresser)?,
                    corrections: &stroke.corrections,
                    motion: &stroke.motion,
                    driven: stroke.driven,
                    profile: stroke.place.area.touching(),
                    tip_radius: dresser.tip_radius,
                    dresser: dresser.body.id.clone(),
                    offset: offset(dresser),
                })
            };
            strokes.strokes.iter().enumerate().filter_map(of_stroke).collect()
        }
        ExecutedTool::Made(_) => Vec::new(),
    }
}
