//! Line dressing of a planned tool: the lines that write each flank, and the referee's sample of what they leave. Knows the
//! tool as a table, not how it was planned.

use super::execution::{ExecutedFlank, Execution};
use super::prepare::{PointDresser, Prepared};
use contact::{DiagonalLine, ModifiedThread, ToolSurface};
use dressing::{DressingError, DressingLine, LineDressing, LinePlan, TipDisc};
use foundation::geometry::{Flank, InvoluteFlank, Sides};
use foundation::kinematics::{DressingPath, DressingPosition, LawError, MotionLaw, Point};
use foundation::numerics::{Progress, TensorSpline, equidistant, extremes};
use generating::{GeneratingError, MadeFlank};
use job::Diagnostic;
use motion::LineContact;
use referee::{LinePasses, RayGrid, RemovalError, Statistics, dress_lines};
use run::RunFailure;
use schemars::JsonSchema;
use serde::Serialize;

/// How one flank of the worm is written.
#[derive(Clone, Debug)]
pub struct WrittenFlank {
    /// Lines and limits.
    pub plan: LinePlan,
    /// Positions of the disc along every line, in the order in which they are driven: t and position.
    pub positions: Vec<Vec<(f64, DressingPosition)>>,
    /// Where the disc touches the worm at some places of every line, t ascending.
    pub contacts: Vec<Vec<LineContact>>,
    /// The bodies.
    pub bodies: LineBodies,
    /// The referee's rays.
    pub sample: LineSample,
    /// The same in figures.
    pub result: LineDressingResult,
    /// What the referee looked at.
    pub statistics: Statistics,
}

impl WrittenFlank {
    /// The motion along a line over ascending t: splines through its positions.
    ///
    /// # Errors
    /// Those of [`MotionLaw::spline`].
    pub fn path(&self, line: usize) -> Result<DressingPath, LawError> {
        let mut along = self.positions[line].clone();
        along.sort_by(|a, b| a.0.total_cmp(&b.0));
        let t: Vec<f64> = along.iter().map(|(t, _)| *t).collect();
        let law = |of: fn(&DressingPosition) -> f64| {
            let values: Vec<f64> = along.iter().map(|(_, at)| of(at)).collect();
            MotionLaw::spline(&t, &values)
        };
        let held = along.first().map(|(_, at)| [at.crossing_angle, at.offset]).unwrap_or_default();
        Ok(DressingPath {
            domain: self.plan.lines[line].range,
            worm_angle: law(|at| at.worm_angle)?,
            worm_shift: law(|at| at.worm_shift)?,
            centre_distance: law(|at| at.centre_distance)?,
            crossing_angle: held[0],
            offset: held[1],
        })
    }
}

/// Worm and disc of line dressing. mm.
#[derive(Clone, Debug)]
pub struct LineBodies {
    /// The flank that is written.
    pub worm: InvoluteFlank,
    /// The other flank of the thread space.
    pub counter: InvoluteFlank,
    /// Tip radius of the worm.
    pub worm_tip_radius: f64,
    /// Radius at which the threads are counted as wide as they are nominally.
    pub worm_pitch_radius: f64,
    /// Screw parameter of the flank, mm/rad.
    pub screw: f64,
    /// The disc.
    pub disc: TipDisc,
    /// f_n1 that is wanted.
    pub wanted: TensorSpline,
}

/// Rays of the referee that cross one pitch of the lines at several places, and what the lines of the run leave on them.
#[derive(Clone, Debug)]
pub struct LineSample {
    /// Where they stand.
    pub grid: RayGrid,
    /// Height over the wanted flank, mm, row-major `[w][z]`.
    pub over: Vec<f64>,
}

impl LineSample {
    /// The same rays on other lines.
    ///
    /// # Errors
    /// [`RemovalError`]; rays that no line finishes.
    pub fn over(
        grid: &RayGrid,
        bodies: &LineBodies,
        paths: &[DressingPath],
        progress: &dyn Progress,
    ) -> Result<(Vec<f64>, Statistics), RemovalError> {
        let passes = LinePasses {
            worm: &bodies.worm,
            centre_radius: bodies.disc.centre_radius(),
            tip_radius: bodies.disc.tip_radius(),
            paths,
            stock: STOCK * bodies.disc.tip_radius(),
        };
        let dressed = dress_lines(&passes, grid, progress)?;
        let over = dressed.lengths()?.into_iter().enumerate().map(|(k, f)| {
            let (w, z) = grid.ray(k);
            f - bodies.wanted.value(w, z)
        });
        Ok((over.collect(), dressed.statistics))
    }
}

/// Figures of line dressing in `result.json`.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct LineDressingResult {
    /// Direction rho_1 of the lines.
    pub line_direction_deg: f64,
    /// Lines on one thread.
    pub lines: usize,
    /// Threads that are written alike.
    pub threads: u32,
    /// Pitch p_X of the lines.
    pub pitch_mm: f64,
    /// Length of the contact path on one thread.
    pub path_length_m: f64,
    /// Height of the scallops by the relative curvature.
    pub scallop_um: f64,
    /// Greatest height over the wanted worm flank on the referee's sample of rays.
    pub simulated_scallop_um: f64,
    /// Greatest depth below the wanted worm flank on the same rays.
    pub simulated_undercut_um: f64,
    /// Least distance of the disc to the opposite flank.
    pub clearance_mm: f64,
    /// Smallest radius of the worm that the rim reaches.
    pub deepest_radius_mm: f64,
    /// Crossing angle gamma_A that is kept.
    pub crossing_angle_deg: f64,
    /// Nodes of the motion along a line.
    pub nodes_per_line: usize,
}

impl LineDressingResult {
    /// How far the worm as written is off the wanted one at most, by the referee's rays, um.
    pub fn off_um(&self) -> f64 {
        self.simulated_scallop_um.max(self.simulated_undercut_um)
    }
}

/// The table of the tool ends this far beyond what is written, in shares of its range over the profile and in mm along the worm:
/// lines run over the ends of the area.
const PROFILE_MARGIN: f64 = 0.03;
const WORM_MARGIN: f64 = 1.0;
/// Places of the referee's sample over profile and worm, and rays over one pitch at each.
const PLACES: usize = 3;
const RAYS: usize = 9;
/// Places stand off the ends of the area by this share of it.
const INSET: f64 = 0.06;
/// Stock of the referee as a share of the tip radius.
const STOCK: f64 = 0.3;
/// Places of a line at which its contact is noted; between them the contact moves evenly over the rounded tip.
const CONTACTS: usize = 5;

/// Plans the lines of all flanks that are ground and has a sample of them refereed; nothing for a worm that is dressed otherwise.
///
/// # Errors
/// [`RunFailure`]: a disc that cannot write the worm; rays that no line finishes.
pub fn line_dressing(
    prepared: &Prepared,
    execution: &Execution,
    progress: &dyn Progress,
) -> Result<Sides<Option<WrittenFlank>>, RunFailure> {
    let Some(PointDresser { tip_diameter, tip_radius, scallop }) = prepared.dressing.point else {
        return Ok(Sides { left: None, right: None });
    };
    let disc = TipDisc::new(0.5 * tip_diameter, tip_radius).map_err(|e| refused(&e, tip_radius))?;
    Sides::try_from_fn(|flank| {
        let made = execution.flanks[flank].as_ref().and_then(ExecutedFlank::made);
        made.map(|made| written(prepared, (disc, scallop), flank, made, progress)).transpose()
    })
}

fn refused(error: &DressingError, tip_radius: f64) -> RunFailure {
    let field = match error {
        DressingError::InvalidNumber { field: "scallop height", .. } => "dressing.scallop_um",
        DressingError::TipRadiusTooLarge { .. }
        | DressingError::DiscCollides { .. }
        | DressingError::DiscTouchesNot { .. } => "dresser.tip_radius",
        DressingError::SurfaceUndefined { .. } | DressingError::LineTooRough { .. } => {
            "dressing.line_direction_deg"
        }
        _ => "dresser",
    };
    let finding = Diagnostic::of(error).field(field);
    let finding = match error {
        DressingError::InvalidNumber { value, allowed, .. } => finding.value(value).allowed(*allowed),
        DressingError::TipRadiusTooLarge { tip_radius, largest, .. } => {
            finding.value(tip_radius).allowed(format!("below {largest:.4} mm"))
        }
        DressingError::DiscCollides { .. } | DressingError::DiscTouchesNot { .. } => {
            finding.value(tip_radius)
        }
        _ => finding,
    };
    if GeneratingError::Dressing(error.clone()).is_bad_input() {
        RunFailure::bad_input(finding)
    } else {
        RunFailure::not_producible(finding)
    }
}

/// The part of the tool's table that is written.
fn area(made: &MadeFlank, tip_roll: f64) -> [[f64; 2]; 2] {
    let [w, z] = made.spline.domain();
    let inset = PROFILE_MARGIN * (w[1] - w[0]);
    [[w[0] + inset, (w[1] - inset).min(tip_roll)], [z[0] + WORM_MARGIN, z[1] - WORM_MARGIN]]
}

fn written(
    prepared: &Prepared,
    (disc, scallop): (TipDisc, f64),
    flank: Flank,
    made: &MadeFlank,
    progress: &dyn Progress,
) -> Result<WrittenFlank, RunFailure> {
    let setup = &prepared.setup;
    let worm = *setup.pair.worm.flank(flank);
    let tip_roll = worm.length_of_roll(setup.worm_tip_radius).unwrap_or(f64::INFINITY);
    let task: LineDressing<'_, TensorSpline> = LineDressing {
        worm: ModifiedThread::new(worm, &made.spline),
        counter: *setup.pair.worm.flank(flank.other()),
        worm_tip_radius: setup.worm_tip_radius,
        disc,
        // The disc lies along the thread at the pitch cylinder.
        crossing_angle: -(setup.pair.worm.screw_parameter(flank) / setup.worm_pitch_radius).atan(),
        offset: 0.0,
        area: area(made, tip_roll),
        direction: DiagonalLine { rho: setup.tool_direction[flank].atan() },
        scallop,
    };
    let fault = |e: DressingError| refused(&e, disc.tip_radius());
    let plan = task.plan().map_err(fault)?;
    let mut positions = Vec::with_capacity(plan.lines.len());
    let mut paths = Vec::with_capacity(plan.lines.len());
    for (k, line) in plan.lines.iter().enumerate() {
        let mut along = task.positions(line, plan.nodes).map_err(fault)?;
        paths.push(task.path(line, plan.nodes).map_err(fault)?);
        if k % 2 == 1 {
            along.reverse();
        }
        positions.push(along);
    }
    let contacts =
        plan.lines.iter().map(|line| contacts(&task, line)).collect::<Result<_, _>>().map_err(fault)?;
    let bodies = LineBodies {
        worm,
        counter: task.counter,
        worm_tip_radius: setup.worm_tip_radius,
        worm_pitch_radius: setup.worm_pitch_radius,
        screw: setup.pair.worm.screw_parameter(flank),
        disc,
        wanted: made.spline.clone(),
    };
    let refereed = |e: RemovalError| RunFailure::of_removal(&e, "dressing");
    let grid = sample(&task, &plan).map_err(refereed)?;
    let (left, statistics) = LineSample::over(&grid, &bodies, &paths, progress).map_err(refereed)?;
    let over = extremes(left.iter().copied());
    let sample = LineSample { grid, over: left };
    let result = LineDressingResult {
        line_direction_deg: task.direction.rho.to_degrees(),
        lines: plan.lines.len(),
        threads: setup.pair.worm.data().teeth.unsigned_abs(),
        pitch_mm: plan.pitch,
        path_length_m: plan.length * 1e-3,
        scallop_um: plan.scallop * 1e3,
        simulated_scallop_um: over[1].max(0.0) * 1e3,
        simulated_undercut_um: (-over[0]).max(0.0) * 1e3,
        clearance_mm: plan.clearance,
        deepest_radius_mm: plan.deepest,
        crossing_angle_deg: task.crossing_angle.to_degrees(),
        nodes_per_line: plan.nodes,
    };
    Ok(WrittenFlank { plan, positions, contacts, bodies, sample, result, statistics })
}

/// Where the disc touches the worm at some places of a line.
fn contacts(
    task: &LineDressing<'_, TensorSpline>,
    line: &DressingLine,
) -> Result<Vec<LineContact>, DressingError> {
    let at = |t: f64| {
        let (w, z) = line.point(t);
        let pose = task.touch(w, z, 0.0)?.position.pose().inverse();
        let flank = task.worm.flank.flank;
        let jet = task.worm.jet(w, z).ok_or(DressingError::SurfaceUndefined { flank, w, z })?;
        let point = pose.point(&Point::from_vector(jet.p)).xyz;
        Ok(LineContact { t, point, normal: pose.rotation() * jet.n.normalize() })
    };
    equidistant(line.range, CONTACTS).into_iter().map(at).collect()
}

/// Rays that cross one pitch of the lines at several places.
fn sample(task: &LineDressing<'_, TensorSpline>, plan: &LinePlan) -> Result<RayGrid, RemovalError> {
    let (sin, cos) = task.direction.rho.sin_cos();
    let [w, z] = task.area.map(|[from, to]| {
        let inset = INSET * (to - from);
        equidistant([from + inset, to - inset], PLACES)
    });
    // Along the worm or over the profile, whichever crosses the lines more steeply.
    let across = |places: &[f64], share: f64, spread: bool| -> Vec<f64> {
        if !spread {
            return places.to_vec();
        }
        let half = 0.5 * plan.pitch / share.abs();
        places.iter().flat_map(|x| equidistant([x - half, x + half], RAYS)).collect()
    };
    let along_worm = cos.abs() > sin.abs();
    RayGrid::new(across(&w, sin, !along_worm), across(&z, cos, along_worm))
}
