//! From a checked job of five-axis milling to the space that is milled, what it is milled with, and how. Every finding names the
//! job's key.

use super::cylindrical::cylindrical;
use super::finding::failure;
use super::lands::lands;
use crate::exchange::milling_job::{
    self as job, BevelFlank, ContactHeight, GridChoice, MilledBody, MillingCutter, MillingJob, RootBottom,
    RowDistances, RowSequence, Spaces, Traversal, read_point_grid,
};
use crate::exchange::{Diagnostic, LoadedMillingJob, Problem};
use crate::geometry::{
    BevelData, BevelGear, BladeData, Cutter, EaseOff, EaseOffAmounts, Flank, GridSurface, Hand, Modified,
    NormalOffset, NormalSide, Octoid, OffsetBase, RuledBlade, SphericalInvolute, Spiral, SplineCurve,
    Surface,
};
use crate::numerics::{equidistant, extremes};
use crate::process::milling::{
    ActiveFlank, CurveOnCone, CutDirection, DensityLimits, DistanceLimits, FootOnHub, HeightLimits,
    HeightRule, Land, LeadCurve, Lines, MilledSide, Orientation, PlanOptions, Retraction, RootDepth,
    RowOrder, SkewPlanes, Space, SpaceFlank, SpacingLaw, Traverse, lead_range,
};
use crate::workflow::finding::{RunFailure, geometry_finding};
use nalgebra::Vector3;
use std::f64::consts::TAU;
use std::sync::Arc;

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

/// What the cutter stays away from the workpiece while it is moved from one path to another, mm.
pub(super) const CLEARANCE: f64 = 2.0;
/// What the default overrun adds to the cutter's radius, mm (spec 50 section 3).
const BESIDE: f64 = 1.0;
/// Pieces of a bevel gear's land, between which the turn of the teeth is linear.
const LAND_PIECES: usize = 8;

/// A body with its flanks.
pub(super) struct Body {
    /// The space, or its halves.
    pub parts: Vec<Space>,
    pub spaces: usize,
    pub retraction: Retraction,
    pub blank: [[f64; 2]; 4],
}

/// Bodies and options of a job.
///
/// # Errors
/// [`RunFailure`] with a finding on the key concerned.
pub fn prepare_milling(loaded: &LoadedMillingJob) -> Result<MillingBodies, RunFailure> {
    let job = &loaded.job;
    let spindle = job.machine.as_ref().map(|machine| machine.tool_length);
    let cutter = |cutter: &MillingCutter, table: &str| {
        let body = cutter.body().and_then(|body| match spindle {
            Some(tool_length) => body.in_spindle(tool_length),
            None => Ok(body),
        });
        body.map_err(|error| RunFailure::bad_input(geometry_finding(&error, table)))
    };
    let finishing = cutter(&job.cutter, "cutter")?;
    let other =
        |given: &Option<MillingCutter>, table| given.as_ref().map(|given| cutter(given, table)).transpose();
    let bottom_cutter = other(&job.bottom_cutter, "bottom_cutter")?;
    let roughing_cutter = other(&job.roughing_cutter, "roughing_cutter")?;
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
    Ok(MillingBodies {
        parts: body.parts,
        pitch: TAU / body.spaces as f64,
        options: options(job, finishing, bottom_cutter, roughing_cutter),
        retraction: body.retraction,
        spaces: body.spaces,
        milled,
        blank: body.blank,
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
        job::CutSense::Climb => CutDirection::Climb,
        job::CutSense::Conventional => CutDirection::Conventional,
    };
    let depth = |root: &job::MilledRoot| match root.depth() {
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
        bottom: milling.root.as_ref().and_then(|root| match root.depth() {
            RootBottom::Height(height) => Some(height),
            RootBottom::Straight(_) => None,
        }),
        roughing: milling.roughing.as_ref().map(|r| [r.allowance, r.step_down, r.step_over]),
        approach_radius: milling.approach_radius,
        sides: job.flanks(),
    }
}

/// A surface with or without an offset.
pub(super) fn with_offset<S: OffsetBase + 'static>(
    base: S,
    offset: Option<Arc<dyn NormalOffset>>,
) -> Arc<dyn Surface> {
    match offset {
        Some(offset) => Arc::new(Modified::new(base, offset)),
        None => Arc::new(base),
    }
}

/// A space with its column planes as the job sets them.
pub(super) fn part(
    job: &MillingJob,
    flanks: Vec<SpaceFlank>,
    lead: Arc<dyn LeadCurve>,
    spaces: usize,
    lands: Vec<Land>,
) -> Space {
    let skew = job.milling.skew_deg;
    let lead =
        if skew == 0.0 { lead } else { Arc::new(SkewPlanes { curve: lead, angle: skew.to_radians() }) };
    Space { flanks, lead, pitch: TAU / spaces as f64, lands, other_half: Vec::new() }
}

fn conical(job: &MillingJob, given: &job::BevelGear) -> Result<Body, RunFailure> {
    let on_bevel = |error: &_| RunFailure::bad_input(geometry_finding(error, "bevel"));
    let data = BevelData {
        outer_transverse_module: given.outer_transverse_module,
        teeth: given.teeth,
        pitch_angle: given.pitch_cone_angle_deg.to_radians(),
        pressure_angle: given.pressure_angle_deg.to_radians(),
        face_width: given.face_width,
        addendum_factor: given.addendum_factor,
        dedendum_factor: given.dedendum_factor,
        spiral: given.spiral.as_ref().map(|spiral| Spiral {
            mean_angle: spiral.mean_spiral_angle_deg.to_radians(),
            cutter_radius: spiral.cutter_radius,
            hand: if spiral.hand.sign() > 0.0 { Hand::Right } else { Hand::Left },
        }),
        form_angle: given.start_polar_angle_deg.map(f64::to_radians),
    };
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
    Ok(Body {
        parts: vec![part(job, flanks, lead, spaces, lands)],
        spaces,
        retraction: Retraction::OutsideCone { half_angle: gear.tip_angle(), distance: CLEARANCE },
        blank: [[inner * sin, inner * cos], [outer * sin, outer * cos], hub(outer), hub(inner)],
    })
}

/// A blade's surface with the curve at its foot.
struct BladeSide {
    surface: Arc<dyn Surface>,
    foot: Arc<dyn LeadCurve>,
    /// Largest radius, mm.
    tip: f64,
    /// Ends along the axis, mm.
    ends: [f64; 2],
}

fn bladed(loaded: &LoadedMillingJob, given: &job::Blade) -> Result<Body, RunFailure> {
    let blade = match (&given.ruled, &given.points) {
        (Some(ruled), _) => ruled_side(given, ruled)?,
        (None, Some(points)) => point_side(loaded, points)?,
        (None, None) => {
            let finding = Diagnostic::new(Problem::MissingKey, "the blade has no surface")
                .field("blade")
                .way_out("give one of `ruled` and `points`");
            return Err(RunFailure::bad_input(finding));
        }
    };
    let active = ActiveFlank {
        surface: blade.surface,
        heights: HeightLimits::Constant(given.active_height),
        face: [0.0, 1.0],
        kink: None,
    };
    let side = given.side().map_or(Flank::Left, job::BladeSide::flank);
    let ([from, to], [start, end]) = (given.hub_radius, blade.ends);
    let spaces = given.count as usize;
    let flanks = vec![SpaceFlank { side, active }];
    Ok(Body {
        parts: vec![part(&loaded.job, flanks, blade.foot, spaces, Vec::new())],
        spaces,
        retraction: Retraction::Outside(blade.tip + CLEARANCE),
        blank: [[blade.tip, start], [blade.tip, end], [0.5 * to, end], [0.5 * from, start]],
    })
}

fn normal_side(side: job::BladeSide) -> NormalSide {
    if side.sign() > 0.0 { NormalSide::Along } else { NormalSide::Against }
}

fn ruled_side(given: &job::Blade, ruled: &job::RuledBlade) -> Result<BladeSide, RunFailure> {
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
        surface: Arc::new(blade),
        tip: ruled.tip_radius,
        ends: [0.0, ruled.length],
    })
}

fn point_side(loaded: &LoadedMillingJob, points: &job::BladePoints) -> Result<BladeSide, RunFailure> {
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
        surface: Arc::new(surface),
        foot: Arc::new(FootOnHub { curve: Arc::new(foot) }),
        tip: extremes(all.clone().map(|p| p.xy().norm()))[1],
        ends: extremes(all.map(|p| p.z)),
    })
}
