//! From a checked job of five-axis milling to the space that is milled, what it is milled with, and how. Every finding names the
//! job's key.

use super::finding::failure;
use super::offset::ModifiedFlank;
use crate::exchange::milling_job::{
    self as job, BevelFlank, ContactHeight, GridChoice, MilledBody, MillingCutter, MillingJob, RootBottom,
    RowDistances, RowSequence, Spaces, Traversal, read_point_grid,
};
use crate::exchange::{Diagnostic, LoadedMillingJob, Problem};
use crate::geometry::{
    BevelData, BevelGear, BladeData, Cutter, EaseOff, EaseOffAmounts, Flank, Frustum, GridSurface, Hand,
    Helicoid, Modified, NormalOffset, NormalSide, Octoid, OffsetBase, RuledBlade, SphericalInvolute, Spiral,
    SplineCurve, Surface,
};
use crate::modification::EvaluationField;
use crate::numerics::{equidistant, extremes};
use crate::process::milling::{
    ActiveFlank, CurveOnCone, CutDirection, DensityLimits, DistanceLimits, FootOnHub, HeightLimits,
    HeightRule, HelixOnCylinder, Land, LeadCurve, Lines, Orientation, PlanOptions, Retraction, RootDepth,
    RowOrder, SkewPlanes, Space, SpaceFlank, SpacingLaw, Traverse, lead_range, lead_through_row,
};
use crate::workflow::finding::{RunFailure, geometry_finding, modification_finding};
use crate::workflow::prepare::{blank_of_job, gear_of_job, specs_of_flank};
use nalgebra::Vector3;
use std::f64::consts::TAU;
use std::sync::Arc;

/// A job made ready for planning.
#[derive(Clone, Debug)]
pub struct MillingBodies {
    /// The space about +y.
    pub space: Space,
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
    pub side: Flank,
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
        let milled = self.space.flanks.iter().filter(|flank| self.options.sides.contains(&flank.side));
        let of_flank = |flank: &SpaceFlank| {
            let active = &flank.active;
            let heights = active.height_span();
            let corners = heights.into_iter().flat_map(|a| active.face.map(|b| (a, b)));
            Ok(FlankRange {
                side: flank.side,
                heights,
                radii: extremes(corners.map(|(a, b)| active.surface.point(a, b).xy().norm())),
                lead: lead_range(active, &*self.space.lead).map_err(|error| failure(&error))?,
            })
        };
        milled.map(of_flank).collect()
    }
}

/// What the cutter stays away from the workpiece while it is moved from one path to another, mm.
const CLEARANCE: f64 = 2.0;
/// What the default overrun adds to the cutter's radius, mm (spec 50 section 3).
const BESIDE: f64 = 1.0;
/// Pieces of a bevel gear's land, between which the turn of the teeth is linear.
const LAND_PIECES: usize = 8;

/// A body with its flanks.
struct Body {
    flanks: Vec<SpaceFlank>,
    lead: Arc<dyn LeadCurve>,
    spaces: usize,
    lands: Vec<Land>,
    retraction: Retraction,
    blank: [[f64; 2]; 4],
}

/// Bodies and options of a job.
///
/// # Errors
/// [`RunFailure`] with a finding on the key concerned.
pub fn prepare_milling(loaded: &LoadedMillingJob) -> Result<MillingBodies, RunFailure> {
    let job = &loaded.job;
    if let Some(radius) = job.milling.approach_radius {
        let finding = Diagnostic::with_code("not-available", "rows are not approached on arcs")
            .field("milling.approach_radius")
            .value(radius.to_string())
            .way_out("leave it out: the cutter comes in over the overrun, beside the face");
        return Err(RunFailure::bad_input(finding));
    }
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
    let mut lead = body.lead;
    let skew = job.milling.skew_deg;
    if skew != 0.0 {
        lead = Arc::new(SkewPlanes { curve: lead, angle: skew.to_radians() });
    }
    let milled = match job.milling.teeth {
        Spaces::All => body.spaces,
        Spaces::One => 1,
    };
    Ok(MillingBodies {
        space: Space {
            flanks: body.flanks,
            lead,
            pitch: TAU / body.spaces as f64,
            lands: body.lands,
            other_half: Vec::new(),
        },
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
        sides: job.flanks(),
    }
}

/// A surface with or without an offset.
fn with_offset<S: OffsetBase + 'static>(base: S, offset: Option<Arc<dyn NormalOffset>>) -> Arc<dyn Surface> {
    match offset {
        Some(offset) => Arc::new(Modified::new(base, offset)),
        None => Arc::new(base),
    }
}

fn cylindrical(loaded: &LoadedMillingJob, given: &job::MillingGear) -> Result<Body, RunFailure> {
    let job = &loaded.job;
    if given.double_helical.is_some() {
        let finding =
            Diagnostic::with_code("not-available", "double-helical gears are not planned as a whole")
                .field("gear.double_helical")
                .way_out(
                    "give each half as a gear of its own, with an overrun that ends before the other half",
                );
        return Err(RunFailure::bad_input(finding));
    }
    let drawing = &given.drawing;
    let gear = gear_of_job(drawing).map_err(RunFailure::bad_input)?;
    let on_gear = |error: &_| RunFailure::bad_input(geometry_finding(error, "gear"));
    let blank = blank_of_job(drawing);
    blank.check(&gear).map_err(|error| on_gear(&error))?;
    let half = 0.5 * drawing.face_width;
    let [tip, root] = [drawing.tip_diameter, drawing.root_diameter].map(|diameter| 0.5 * diameter);
    let range = drawing.evaluation_range();
    let mut flanks = Vec::new();
    for side in Flank::BOTH {
        let base = Helicoid::new(&gear, side);
        base.check_tip(tip).map_err(|error| on_gear(&error))?;
        let heights = [
            base.length_of_roll(0.5 * drawing.root_form_diameter()).map_err(|error| on_gear(&error))?,
            base.length_of_roll(tip).map_err(|error| on_gear(&error))?,
        ];
        let offset = match &job.target.modifications {
            Some(specs) if !specs.is_empty() => {
                let rolls = [range.start_diameter, range.end_diameter]
                    .map(|diameter| base.length_of_roll(0.5 * diameter));
                let [start, end] = rolls;
                let rolls = [start.map_err(|e| on_gear(&e))?, end.map_err(|e| on_gear(&e))?];
                let rolls = [rolls[0].min(rolls[1]), rolls[0].max(rolls[1])];
                let field = EvaluationField::new(
                    rolls,
                    [range.z_start, range.z_end],
                    base.base_radius(),
                    base.base_helix_angle(),
                )
                .map_err(|error| RunFailure::bad_input(modification_finding(&error, "gear")))?;
                let modification =
                    specs_of_flank(loaded, specs, side, &field).map_err(RunFailure::bad_input)?;
                let offset: Arc<dyn NormalOffset> = Arc::new(ModifiedFlank::new(modification));
                Some(offset)
            }
            _ => None,
        };
        let active = ActiveFlank {
            surface: with_offset(base, offset),
            heights: HeightLimits::Constant(heights),
            face: [-half, half],
            kink: None,
        };
        flanks.push(SpaceFlank { side, active });
    }
    let base = Helicoid::new(&gear, Flank::Left);
    let (sign, twist) = (base.external_sign(), base.twist());
    let spaces = drawing.teeth.unsigned_abs() as usize;
    let mut radius = root;
    if let Some(row) = job.milling.lead_through_row {
        let rows = job.milling.rows.unwrap_or(row + 1);
        let on_root = HelixOnCylinder { radius: root, turn_per_length: twist, external_sign: sign };
        radius = lead_through_row(&flanks[0].active, &on_root, row, rows).map_err(|error| failure(&error))?;
    }
    let lands = lands(&flanks, spaces, &[-half, half], |z| [tip, z, -twist * z], sign);
    let retraction =
        if sign > 0.0 { Retraction::Outside(tip + CLEARANCE) } else { Retraction::Inside(tip - CLEARANCE) };
    let other = if sign > 0.0 { 0.3 * root } else { root + 4.0 * drawing.normal_module };
    Ok(Body {
        flanks,
        lead: Arc::new(HelixOnCylinder { radius, turn_per_length: twist, external_sign: sign }),
        spaces,
        lands,
        retraction,
        blank: [[tip, -half], [tip, half], [other, half], [other, -half]],
    })
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
    let lands =
        lands(&flanks, given.teeth as usize, &ends, |r| [r * sin, r * cos, -gear.line().angle(r)], 1.0);
    // The blank: tip cone, and a hub a little below the root cone.
    let (root_sin, root_cos) = gear.root_angle().sin_cos();
    let hub = |r: f64| [0.5 * r * root_sin, r * root_cos];
    Ok(Body {
        flanks,
        lead: Arc::new(CurveOnCone { cone_angle: gear.root_angle(), line: gear.line().clone() }),
        spaces: given.teeth as usize,
        lands,
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
    Ok(Body {
        flanks: vec![SpaceFlank { side, active }],
        lead: blade.foot,
        spaces: given.count as usize,
        lands: Vec::new(),
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

/// The lands of both teeth beside the space: frusta between the ends of pieces of the face, from the tip edge of one flank to that
/// of the other flank of the next space. `place` gives radius, position and turn of the teeth at a length.
fn lands(
    flanks: &[SpaceFlank],
    spaces: usize,
    ends: &[f64],
    place: impl Fn(f64) -> [f64; 3],
    outward: f64,
) -> Vec<Land> {
    let azimuth = |flank: &SpaceFlank, length: f64| {
        let [_, tip] = flank.active.height_span();
        let point = flank.active.surface.point(tip, length);
        point.x.atan2(point.y) - place(length)[2]
    };
    let mut lands = Vec::new();
    for pair in ends.windows(2) {
        let at = [place(pair[0]), place(pair[1])];
        let of = |k: usize| [at[0][k], at[1][k]];
        let surface = Frustum { radii: of(0), positions: of(1), turns: of(2), outward };
        let middle = 0.5 * (pair[0] + pair[1]);
        let within = |angle: f64| angle - TAU * (angle / TAU).round();
        let edges = [&flanks[0], &flanks[1]].map(|flank| within(azimuth(flank, middle)));
        let [low, high] = extremes(edges);
        let pitch = TAU / spaces as f64;
        let [above, below] = if edges[0] > edges[1] { [0, 1] } else { [1, 0] };
        lands.push(Land { surface, azimuths: [high, low + pitch], side: flanks[above].side });
        lands.push(Land { surface, azimuths: [high - pitch, low], side: flanks[below].side });
    }
    lands
}
