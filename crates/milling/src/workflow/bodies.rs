//! From a checked job of five-axis milling to the space that is milled, what it is milled with, and how. Every finding names the
//! job's key.

use super::bladed::bladed;
use super::body::{Body, CLEARANCE, floor, part, with_offset};
use super::cylindrical::cylindrical;
use super::finding::failure;
use super::lands::lands;
use super::mate_flank::form_angles;
use super::walls::{below_root_body, root_cone};
use crate::job::{
    BevelFlank, ContactHeight, GridChoice, LoadedMillingJob, MilledBody, MillingCutter, MillingJob,
    RootBottom, RowDistances, RowSequence, Spaces, Traversal,
};
use crate::{
    ActiveFlank, Bottom, CurveOnCone, CutDirection, DensityLimits, DistanceLimits, HeightLimits, HeightRule,
    Lines, MilledSide, Orientation, PlanOptions, Retraction, RootDepth, RowOrder, Space, SpaceFlank,
    SpacingLaw, Traverse, WallKind, job as drawn, lead_range,
};
use foundation::geometry::{
    BevelGear, Cutter, EaseOff, EaseOffAmounts, Flank, Frustum, NormalOffset, Octoid, SphericalInvolute,
};
use foundation::numerics::{equidistant, extremes};
use job::{Diagnostic, Problem};
use run::{RunFailure, geometry_finding};
use std::f64::consts::TAU;
use std::sync::Arc;
use verdict::Remark;

/// A job made ready for planning.
#[derive(Clone, Debug)]
pub struct MillingBodies {
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
/// What the default overrun adds to the cutter's radius, mm (`docs/mathematics/milling.md#columns-and-rows`).
const BESIDE: f64 = 1.0;
/// Pieces of a bevel gear's land, between which the turn of the teeth is linear.
const LAND_PIECES: usize = 8;

/// Bodies and options of a job.
///
/// # Errors
/// [`RunFailure`] with a finding on the key concerned.
pub fn prepare_milling(loaded: &LoadedMillingJob) -> Result<MillingBodies, RunFailure> {
    let job = &loaded.job;
    let spindle = job.machine.as_ref().map(|machine| (machine.tool_length, machine.spindle_diameter));
    let cutter = |cutter: &MillingCutter, table: &str| {
        let body = cutter.body().and_then(|body| match spindle {
            Some((tool_length, diameter)) => body.in_spindle(tool_length, diameter),
            None => Ok(body),
        });
        body.map_err(|error| RunFailure::bad_input(geometry_finding(&error, table)))
    };
    let mut finishing = cutter(&job.cutter, "cutter")?;
    let other =
        |given: &Option<MillingCutter>, table| given.as_ref().map(|given| cutter(given, table)).transpose();
    let mut bottom_cutter = other(&job.bottom_cutter, "bottom_cutter")?;
    let mut roughing_cutter = other(&job.roughing_cutter, "roughing_cutter")?;
    let body = match job.body() {
        Some(MilledBody::Gear(gear)) => cylindrical(loaded, gear)?,
        Some(MilledBody::Bevel(bevel)) => conical(job, bevel)?,
        Some(MilledBody::Blade(blade)) => bladed(loaded, blade)?,
        None => {
            let finding = Diagnostic::new(Problem::MissingKey, "the job has no workpiece")
                .field("gear")
                .way_out("give one of the tables [gear], [bevel] and [blade]");
            return Err(RunFailure::bad_input(finding));
        }
    };
    let milled = match job.milling.teeth {
        Spaces::All => body.spaces,
        Spaces::One => 1,
    };
    let mut unknown = body.unknown;
    let all = [Some(&mut finishing), bottom_cutter.as_mut(), roughing_cutter.as_mut()];
    let free: Vec<_> = all.into_iter().flatten().filter(|cutter| !cutter.is_held()).collect();
    let in_ring = body.parts.iter().flat_map(|part| &part.walls).any(|wall| wall.kind == WallKind::Ring);
    if in_ring && !free.is_empty() {
        let bore = body.blank[0][0];
        free.into_iter().for_each(|cutter| *cutter = cutter.clone().ending_at(bore));
        unknown.push(Remark {
            code: "holder-not-judged",
            text: "neither shank nor spindle of a cutter is known, so that only its edges are kept from the other side of the ring".into(),
            way_out: "list neck, shank and holder in `shank`, or give [machine] with `tool_length` and `spindle_diameter`".into(),
        });
    }
    Ok(MillingBodies {
        parts: body.parts,
        pitch: TAU / body.spaces as f64,
        options: options(job, finishing, bottom_cutter, roughing_cutter),
        retraction: body.retraction,
        spaces: body.spaces,
        milled,
        blank: body.blank,
        floor: body.floor,
        unknown,
    })
}

fn options(
    job: &MillingJob,
    cutter: Cutter,
    bottom_cutter: Option<Cutter>,
    roughing_cutter: Option<Cutter>,
) -> PlanOptions {
    let milling = &job.milling;
    let lines = match milling.grid() {
        GridChoice::Counts { rows, columns } => Lines::Counted { rows, columns },
        GridChoice::Limits { density: d, scallop_um, chord_um } => Lines::Limited {
            limits: DensityLimits {
                row: DistanceLimits {
                    greatest: d.row_max,
                    least: d.row_min,
                    greatest_mean: d.row_max_mean,
                    least_mean: d.row_min_mean,
                },
                column: DistanceLimits {
                    greatest: d.column_max,
                    least: d.column_min,
                    greatest_mean: d.column_max_mean,
                    least_mean: d.column_min_mean,
                },
            },
            scallop: scallop_um.map(|um| 1e-3 * um),
            chord: chord_um.map(|um| 1e-3 * um),
        },
    };
    let direction = match milling.direction {
        drawn::CutSense::Climb => CutDirection::Climb,
        drawn::CutSense::Conventional => CutDirection::Conventional,
    };
    let depth = |root: &drawn::MilledRoot| match root.depth() {
        RootBottom::Height(height) => RootDepth::Bottom(height),
        RootBottom::Straight(straight) => RootDepth::Straight(straight),
    };
    PlanOptions {
        cutter,
        bottom_cutter,
        roughing_cutter,
        lines,
        spacing: match milling.row_spacing {
            RowDistances::Arc => SpacingLaw::Arc,
            RowDistances::Parameter => SpacingLaw::Parameter,
            RowDistances::Scallop => SpacingLaw::Scallop,
        },
        orientation: Orientation {
            tilt: milling.tilt_deg.to_radians(),
            lead_angle: milling.lead_angle_deg.to_radians(),
        },
        heights: match &milling.contact_height {
            Some(ContactHeight::Fixed(height)) => HeightRule::Fixed(*height),
            Some(ContactHeight::Ramp(ramp)) => HeightRule::Ramp([ramp.from, ramp.to]),
            Some(ContactHeight::Rows(heights)) => HeightRule::Free(heights.clone()),
            // Of a cutter without a straight side: its contact follows from the axis.
            None => HeightRule::Fixed(0.0),
        },
        overrun: milling.overrun.unwrap_or(0.5 * job.cutter.diameter + BESIDE),
        safety: milling.safety_distance,
        traverse: match milling.traverse {
            Traversal::OneWay => Traverse::OneWay(direction),
            Traversal::Zigzag => Traverse::Zigzag(direction),
        },
        order: match milling.order {
            RowSequence::TipToRoot => RowOrder::TipToRoot,
            RowSequence::RootToTip => RowOrder::RootToTip,
        },
        root: milling.root.as_ref().map(|root| (depth(root), root.bottom_pass)),
        bottom: milling.root.as_ref().map(|root| match root.depth() {
            RootBottom::Height(height) => Bottom::Level(height),
            RootBottom::Straight(straight) => Bottom::BelowFlank(straight),
        }),
        roughing: milling.roughing.as_ref().map(|r| [r.allowance, r.step_down, r.step_over]),
        approach_radius: milling.approach_radius,
        sides: job.flanks(),
    }
}

fn conical(job: &MillingJob, given: &drawn::BevelGear) -> Result<Body, RunFailure> {
    let on_bevel = |error: &_| RunFailure::bad_input(geometry_finding(error, "bevel"));
    let mut data = given.data();
    if let Some(angles) = form_angles(job)? {
        data.form_angle = Some(angles[0]);
    }
    let gear = BevelGear::new(data).map_err(|error| on_bevel(&error))?;
    let ease = job.target.ease_off.as_ref().map(|ease| EaseOffAmounts {
        length_crowning: 1e-3 * ease.lengthwise_um,
        profile_crowning: 1e-3 * ease.profile_um,
        bias: 1e-3 * ease.bias_um,
    });
    let mut flanks = Vec::new();
    for side in Flank::BOTH {
        let octoid = Octoid::new(&gear, side);
        let heights = match given.flank {
            BevelFlank::SphericalInvolute => gear.heights(),
            BevelFlank::Octoid => {
                let height = |angle| octoid.height_of(angle).map_err(|error| on_bevel(&error));
                [height(gear.form_angle())?, height(gear.tip_angle())?]
            }
        };
        let mut offset: Option<Arc<dyn NormalOffset>> = None;
        if let Some(amounts) = ease {
            let ease = EaseOff::new(amounts, heights, gear.face()).map_err(|error| on_bevel(&error))?;
            offset = Some(Arc::new(ease));
        }
        let surface = match given.flank {
            BevelFlank::SphericalInvolute => with_offset(SphericalInvolute::new(&gear, side), offset),
            BevelFlank::Octoid => with_offset(octoid, offset),
        };
        let active =
            ActiveFlank { surface, heights: HeightLimits::Constant(heights), face: gear.face(), kink: None };
        flanks.push(SpaceFlank { side, active });
    }
    let [inner, outer] = gear.face();
    let (sin, cos) = gear.tip_angle().sin_cos();
    let ends: Vec<f64> = equidistant([inner, outer], LAND_PIECES + 1);
    let spaces = given.teeth as usize;
    let lands = lands(&flanks, spaces, &ends, |r| [r * sin, r * cos, -gear.line().angle(r)], 1.0);
    // The blank: tip cone, and a hub a little below the root cone.
    let (root_sin, root_cos) = gear.root_angle().sin_cos();
    let hub = |r: f64| [0.5 * r * root_sin, r * root_cos];
    let lead = Arc::new(CurveOnCone { cone_angle: gear.root_angle(), line: gear.line().clone() });
    let mut space = part(job, flanks, lead, spaces, lands);
    space.walls.push(root_cone(&gear, below_root_body(job, 0.0)));
    Ok(Body {
        parts: vec![space],
        unknown: Vec::new(),
        spaces,
        retraction: Retraction::OutsideCone { half_angle: gear.tip_angle(), distance: CLEARANCE },
        blank: [[inner * sin, inner * cos], [outer * sin, outer * cos], hub(outer), hub(inner)],
        floor: floor([inner, outer].map(|r| [r * root_sin, r * root_cos]), 1.0),
    })
}
