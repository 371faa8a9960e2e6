//! A grinding process with all its settings, ready to be run: from a plan or from the `[settings]` of a job. Both go the
//! same way to the referee and to the report.

use super::correction_series::{correction_coefficients, correction_series};
use super::executed_strokes::{ExecutedStrokes, strokes_of_settings};
use super::prepare::{GivenSettings, Prepared};
use crate::job::{FlankSettings, Pieces, Settings, StrokeTables, ToolTable, ToolTables};
use crate::workflow::generating_finding;
use dressing::{DressedWorm, DresserTool, dressing_motion};
use foundation::geometry::{Flank, Sides};
use foundation::kinematics::{
    DressingChain, DressingCorrection, DressingMotion, GeneratingMotion, MotionLaw, PiecewisePolynomial,
};
use foundation::modification::ModificationSpec;
use foundation::numerics::{Chebyshev, extremes};
use generating::least_squares::FitNorm;
use generating::{
    Carried, Decomposition, DressingRows, GrindingPlan, IdealPlan, IdealWorm, MadeFlank, PlannedTool,
    PlanningGrid, ProfilePlace, ProfilePolicy, SeriesRule, Tool, dresser_of_plan, dresser_profile,
    dressing_interval,
};
use job::{Diagnostic, Problem};
use metrology::Topography;
use run::RunFailure;
use std::f64::consts::TAU;
use verdict::Remark;

/// Phases of two flanks closer than this (rad) are one motion.
const SAME_PHASE: f64 = 1e-9;

/// How one flank of the tool is dressed.
#[derive(Clone, Debug)]
pub struct ExecutedDressing {
    /// DK over v: rad, rad, mm, mm.
    pub corrections: [Chebyshev; 4],
    /// Polynomial profile that the dresser leaves on the gear over u = w - w_m, transverse, mm.
    pub profile: Vec<f64>,
    /// A further part of that profile over w, transverse, mm.
    pub spline: Option<PiecewisePolynomial>,
    /// Profile forms that the dresser carries beside it, as a job describes them.
    pub reliefs: Vec<ModificationSpec>,
    /// The motion that these corrections make.
    pub motion: DressingMotion,
    /// Worm positions v_zS that are driven, mm.
    pub driven: [f64; 2],
}

/// Where one flank of the tool comes from.
#[derive(Clone, Debug)]
pub enum ExecutedTool {
    /// From the dresser.
    Dressed(Box<ExecutedDressing>),
    /// From the dressers, stroke by stroke.
    Stroked(Box<ExecutedStrokes>),
    /// It is a table.
    Made(Box<MadeFlank>),
}

/// One flank of a process with what it is expected to leave.
#[derive(Clone, Debug)]
pub struct ExecutedFlank {
    /// The tool.
    pub tool: ExecutedTool,
    /// Target, normal, mm.
    pub target: Topography,
    /// Exact contact with the worm as dressed, normal, mm.
    pub planned: Topography,
    /// Least determinant ratio.
    pub determinant: f64,
}

/// Bodies, motions and expected flanks.
#[derive(Clone, Debug)]
pub struct Execution {
    /// Grinding motion.
    pub motion: GeneratingMotion,
    /// Diagonal ratio.
    pub ratio: f64,
    /// z_V01, mm.
    pub shift_origin: f64,
    /// The dresser with its profile, the first of several; `None` for a tool that is not dressed.
    pub dresser: Option<DresserTool>,
    /// z_1 occupied on the worm, mm.
    pub occupation: [f64; 2],
    /// Stroke of the feed z_V2, overrun included, mm.
    pub feed_range: [f64; 2],
    /// Flanks that are ground.
    pub flanks: Sides<Option<ExecutedFlank>>,
    /// Remarks.
    pub warnings: Vec<Remark>,
}

impl ExecutedDressing {
    fn new(
        chain: DressingChain,
        corrections: [Chebyshev; 4],
        (profile, spline): (Vec<f64>, Option<PiecewisePolynomial>),
        reliefs: Vec<ModificationSpec>,
    ) -> Self {
        let motion = dressing_motion(chain, &corrections);
        let (from, to) = corrections[0].interval();
        Self { corrections, profile, spline, reliefs, motion, driven: [from, to] }
    }
}

/// Corrections of a settled dresser counted from the nominal kinematics, as tables and settings have them.
fn from_nominal(corrections: &[Chebyshev; 4], settled: &DressingCorrection) -> [Chebyshev; 4] {
    std::array::from_fn(|j| corrections[j].raised(settled[j]))
}

impl ExecutedFlank {
    /// How the tool is dressed, if it is.
    pub fn dressing(&self) -> Option<&ExecutedDressing> {
        match &self.tool {
            ExecutedTool::Dressed(dressing) => Some(dressing),
            ExecutedTool::Stroked(_) | ExecutedTool::Made(_) => None,
        }
    }

    /// The strokes in which the tool is dressed, if it is so.
    pub fn strokes(&self) -> Option<&ExecutedStrokes> {
        match &self.tool {
            ExecutedTool::Stroked(strokes) => Some(strokes),
            ExecutedTool::Dressed(_) | ExecutedTool::Made(_) => None,
        }
    }

    /// The flank of the tool as a table, if it is one.
    pub fn made(&self) -> Option<&MadeFlank> {
        match &self.tool {
            ExecutedTool::Dressed(_) | ExecutedTool::Stroked(_) => None,
            ExecutedTool::Made(made) => Some(made),
        }
    }
}

/// Length of an unmodified tool beyond its used width, mm: room for the contact shift.
const BEYOND_OCCUPATION: f64 = 12.0;
/// Determinant ratio below which a warning is given.
const LOW_DETERMINANT: f64 = 0.3;

/// Feed stroke from the feeds at which the grid is really ground, with the overrun at both ends.
fn stroke(overrun: f64, feeds: impl Iterator<Item = f64>) -> [f64; 2] {
    let [a, b] = extremes(feeds);
    [a - overrun, b + overrun]
}

fn determinant_warnings(flanks: &Sides<Option<ExecutedFlank>>, warnings: &mut Vec<Remark>) {
    for (flank, executed) in flanks.iter() {
        let Some(executed) = executed else { continue };
        if executed.determinant < LOW_DETERMINANT {
            warnings.push(Remark {
                code: "low-determinant-ratio",
                text: format!(
                    "the envelope of the {flank} flank comes near a fold (ratio {:.3})",
                    executed.determinant
                ),
                way_out: "reduce the amount or choose another diagonal ratio".into(),
            });
        }
    }
}

fn executed(w: &[f64], z: &[f64], target: &[f64], planned: Vec<f64>) -> Option<(Topography, Topography)> {
    let topography = |f: Vec<f64>| Topography::new(w.to_vec(), z.to_vec(), f);
    Some((topography(target.to_vec())?, topography(planned)?))
}

impl Execution {
    /// Whether one motion grinds the flanks: their phases differ by full turns.
    pub fn grinds_both_at_once(&self) -> bool {
        let apart = self.motion.phase.left - self.motion.phase.right;
        (apart - TAU * (apart / TAU).round()).abs() < SAME_PHASE
    }

    /// Lets the dressing axes be off by d_phi_S, d_gamma (rad), d_d, d_v_yA (mm) all along the worm, in every stroke; false, and nothing
    /// done, for a tool that no disc dresses in line contact.
    pub fn shift_dressing(&mut self, by: [f64; 4]) -> bool {
        let moved =
            |corrections: &[Chebyshev; 4]| std::array::from_fn(|axis| corrections[axis].raised(by[axis]));
        let made = |(_, executed): (Flank, &Option<ExecutedFlank>)| {
            executed.as_ref().is_some_and(|executed| executed.made().is_some())
        };
        if self.flanks.iter().any(made) {
            return false;
        }
        for flank in Flank::BOTH {
            match self.flanks[flank].as_mut().map(|executed| &mut executed.tool) {
                Some(ExecutedTool::Dressed(dressing)) => {
                    dressing.corrections = moved(&dressing.corrections);
                    dressing.motion = dressing_motion(dressing.motion.chain, &dressing.corrections);
                }
                Some(ExecutedTool::Stroked(stroked)) => {
                    for stroke in &mut stroked.strokes {
                        stroke.corrections = moved(&stroke.corrections);
                        stroke.motion = dressing_motion(stroke.motion.chain, &stroke.corrections);
                    }
                }
                Some(ExecutedTool::Made(_)) | None => {}
            }
        }
        true
    }

    /// The same worm and flank with other corrections of a flank's dressing and another motion of grinding, for rays that stand up to `stock`
    /// above the target, mm; `None` for a flank that is not ground by a worm dressed in one stroke.
    pub fn roughed(
        &self,
        flank: Flank,
        change: impl Fn(&[Chebyshev; 4]) -> Option<[Chebyshev; 4]>,
        (motion, feed_range): (GeneratingMotion, [f64; 2]),
        stock: f64,
    ) -> Option<Self> {
        let (executed, dresser) = (self.flanks[flank].as_ref()?, self.dresser.as_ref()?);
        let ExecutedTool::Dressed(dressing) = &executed.tool else { return None };
        let of = (dressing.profile.clone(), dressing.spline.clone());
        let chain = dresser.flanks[flank].chain;
        let changed =
            ExecutedDressing::new(chain, change(&dressing.corrections)?, of, dressing.reliefs.clone());
        let f = executed.target.f.iter().map(|f| f + stock).collect();
        let only = ExecutedFlank {
            tool: ExecutedTool::Dressed(Box::new(changed)),
            target: Topography { f, ..executed.target.clone() },
            ..executed.clone()
        };
        let mut flanks = Sides { left: None, right: None };
        flanks[flank] = Some(only);
        Some(Self { motion, feed_range, flanks, ..self.clone() })
    }

    /// From a finished plan.
    pub fn of_plan(prepared: &Prepared, plan: &GrindingPlan) -> Self {
        let dresser = plan.dresser.as_ref().map(DresserTool::unsettled);
        let flanks = Sides::from_fn(|flank| {
            let f = plan.flanks[flank].as_ref()?;
            let (target, planned) =
                executed(&f.w, &f.z, &f.target, f.planned.iter().map(|p| p.f_n).collect())?;
            let determinant = f.planned.iter().map(|p| p.determinant_ratio).fold(f64::INFINITY, f64::min);
            let tool = match (&f.tool, &plan.dresser) {
                (PlannedTool::Dressed(dressed), Some(settled)) => {
                    let worm = plan.ideal.worms[flank].as_ref()?;
                    let profile = (dresser_profile(worm, plan.policy), worm.spline.clone());
                    // A fitted profile holds the reliefs of the target.
                    let fitted = worm.reliefs.is_empty();
                    let reliefs = if fitted { Vec::new() } else { prepared.reliefs[flank].clone() };
                    let corrections = from_nominal(&dressed.corrections, &settled.flanks[flank].settled);
                    let chain = dresser.as_ref()?.flanks[flank].chain;
                    let dressing = ExecutedDressing::new(chain, corrections, profile, reliefs);
                    ExecutedTool::Dressed(Box::new(dressing))
                }
                (PlannedTool::Dressed(_), None) => return None,
                (PlannedTool::Stroked(stroked), _) => {
                    let layout = prepared.setup.strokes.as_deref()?;
                    ExecutedTool::Stroked(Box::new(ExecutedStrokes::of_flank(layout, flank, stroked)?))
                }
                (PlannedTool::Made(made), _) => ExecutedTool::Made(Box::new(made.clone())),
            };
            Some(ExecutedFlank { tool, target, planned, determinant })
        });
        let feeds =
            plan.flanks.iter().filter_map(|(_, f)| f.as_ref()).flat_map(|f| f.planned.iter().map(|p| p.feed));
        let mut warnings = Vec::new();
        determinant_warnings(&flanks, &mut warnings);
        Self {
            motion: plan.ideal.motion.clone(),
            ratio: plan.choice.ratio,
            shift_origin: plan.ideal.motion.shift.value(0.0),
            dresser,
            occupation: plan.ideal.occupation,
            feed_range: stroke(prepared.cycle.overrun, feeds),
            flanks,
            warnings,
        }
    }

    /// From the settings of a job: nothing is planned or corrected.
    ///
    /// # Errors
    /// [`RunFailure`]: reliefs that are impossible; contact and dressing for these settings.
    pub fn of_settings(prepared: &Prepared, given: &GivenSettings) -> Result<Self, RunFailure> {
        let setup = &prepared.setup;
        let settings = &given.settings;
        let scaled = |c: &[f64], unit: f64| MotionLaw::polynomial(0.0, c.iter().map(|c| c * unit).collect());
        let shift = shift_of_settings(settings)?;
        let mut motion = setup.pair.motion(shift.clone());
        motion.delta_d = match &settings.delta_d_pieces {
            Some(pieces) => law_of_pieces(pieces, "settings.delta_d_pieces")?.scaled(1e-3),
            None => scaled(&settings.delta_d_um, 1e-3),
        };
        motion.delta_phi_2 = match &settings.delta_phi_2_pieces {
            Some(pieces) => law_of_pieces(pieces, "settings.delta_phi_2_pieces")?.scaled(1e-6),
            None => scaled(&settings.delta_phi_2_urad, 1e-6),
        };
        let which = prepared.ground_flanks();
        let worms = Sides::try_from_fn(|flank| -> Result<_, RunFailure> {
            if prepared.targets[flank].is_none() {
                return Ok(None);
            }
            let lines = setup.lines[flank];
            let profile =
                given.flank(flank).map_or(Vec::new(), |s| s.profile_um.iter().map(|p| p * 1e-3).collect());
            let pieces = given.flank(flank).and_then(|s| s.profile_pieces.as_ref());
            let spline = pieces.map(|pieces| {
                let pieces = piecewise(pieces, &format!("settings.{flank}.profile_pieces"))?;
                Ok::<_, RunFailure>(pieces.scaled(1e-3))
            });
            Ok(Some(IdealWorm {
                moved: None,
                spline: spline.transpose()?,
                lines,
                shift: shift.clone(),
                parts: Decomposition { profile, ..Decomposition::nothing(lines.t_k) },
                carried: Carried::default(),
                reliefs: given.reliefs[flank].clone(),
                given: match &setup.tool {
                    Tool::Given(modifications) => Some(modifications[flank].clone()),
                    Tool::Dressed(_) | Tool::Made => None,
                },
            }))
        })?;
        let ideal = IdealPlan::of_settings(worms, motion.clone(), setup.occupation(&shift, &which));
        // The dresser carries what the settings say, whatever the plan's policy was.
        let policy = ProfilePolicy {
            series: SeriesRule::default(),
            place: ProfilePlace::Dresser,
            free_dresser: true,
            line_tolerance: 0.0,
            norm: FitNorm::default(),
            dressing: DressingRows::default(),
            gauge: Sides { left: None, right: None },
        };
        let first = setup.strokes.as_ref().and_then(|layout| layout.dressers.first());
        let dresser = match (&setup.tool, first) {
            (Tool::Dressed(_), Some(first)) => Some((first.clone(), first.clone())),
            (Tool::Dressed(_), None) => {
                let settled =
                    dresser_of_plan(setup, &ideal, policy).map_err(|e| generating_finding::failure(&e))?;
                Some((settled.unsettled(), settled))
            }
            (Tool::Made | Tool::Given(_), _) => None,
        };
        let (profile_points, helix_points) = prepared.rules.grid();
        let grid = PlanningGrid::new(setup, profile_points, helix_points);
        let mut feeds = Vec::new();
        let flanks = Sides::try_from_fn(|flank| -> Result<_, RunFailure> {
            let Some(target) = &prepared.targets[flank] else { return Ok(None) };
            let (tool, ground) = match (&dresser, &setup.strokes) {
                (Some(_), Some(layout)) => {
                    let stroked = strokes_of_settings(settings, layout, flank)?;
                    let ground = stroked.ground(setup, flank, &grid, &motion);
                    let Some(strokes) = ExecutedStrokes::of_flank(layout, flank, &stroked) else {
                        return Ok(None);
                    };
                    (ExecutedTool::Stroked(Box::new(strokes)), ground)
                }
                (Some((dresser, settled)), None) => {
                    let corrections = match given.flank(flank) {
                        Some(s) => correction_series(
                            [s.v_from_mm, s.v_to_mm],
                            [&s.d_phi_s_deg, &s.d_gamma_deg, &s.d_d_mm, &s.d_v_ya_mm],
                        ),
                        None => {
                            let (from, to) = dressing_interval(setup, settled, &shift, flank, 3.0);
                            settled.flanks[flank].settled.map(|x| Chebyshev::constant(from, to, x))
                        }
                    };
                    let worm = DressedWorm::new(dresser, flank, &corrections);
                    let profile = ideal.worms[flank]
                        .as_ref()
                        .map_or((Vec::new(), None), |w| (w.parts.profile.clone(), w.spline.clone()));
                    let reliefs = given.flank(flank).map_or(Vec::new(), |s| s.reliefs.clone());
                    let dressing =
                        ExecutedDressing::new(dresser.flanks[flank].chain, corrections, profile, reliefs);
                    let ground = grid.ground(setup, flank, &motion, &worm);
                    (ExecutedTool::Dressed(Box::new(dressing)), ground)
                }
                (None, _) => {
                    let made = made_of_settings(settings, prepared, &ideal, flank)?;
                    let ground = grid.ground(setup, flank, &motion, &made.surface(setup, flank));
                    (ExecutedTool::Made(Box::new(made)), ground)
                }
            };
            let ground = ground.map_err(|e| generating_finding::failure(&e))?;
            let wanted = grid
                .target(flank, target, setup.lines[flank].cos_b2)
                .map_err(|e| generating_finding::failure(&e))?;
            feeds.extend(ground.iter().map(|g| g.feed));
            let made = executed(&grid.w[flank], &grid.z, &wanted, ground.iter().map(|g| g.f_n).collect());
            let determinant = ground.iter().map(|g| g.determinant_ratio).fold(f64::INFINITY, f64::min);
            Ok(made.map(|(target, planned)| ExecutedFlank { tool, target, planned, determinant }))
        })?;
        let mut warnings = Vec::new();
        determinant_warnings(&flanks, &mut warnings);
        Ok(Self {
            motion,
            ratio: settings.diagonal_ratio,
            shift_origin: shift.value(0.0),
            dresser: dresser.map(|(dresser, _)| dresser),
            occupation: ideal.occupation,
            feed_range: stroke(prepared.cycle.overrun, feeds.into_iter()),
            flanks,
            warnings,
        })
    }

    /// The settings as a job carries them.
    pub fn settings(&self) -> Settings {
        let law = |law: &MotionLaw, unit: f64| match law {
            MotionLaw::Polynomial { coefficients, .. } => coefficients.iter().map(|c| c * unit).collect(),
            _ => Vec::new(),
        };
        let table = |flank: Flank| {
            let made = self.flanks[flank].as_ref()?.made()?;
            Some(ToolTable {
                w_mm: made.w.clone(),
                z_mm: made.z.clone(),
                f_um: made.f.iter().map(|row| row.iter().map(|f| f * 1e3).collect()).collect(),
            })
        };
        let flank = |flank: Flank| {
            let f = self.flanks[flank].as_ref()?.dressing()?;
            let (from, to) = f.corrections[0].interval();
            let [d_phi_s_deg, d_gamma_deg, d_d_mm, d_v_ya_mm] = correction_coefficients(&f.corrections);
            Some(FlankSettings {
                v_from_mm: from,
                v_to_mm: to,
                d_phi_s_deg,
                d_gamma_deg,
                d_d_mm,
                d_v_ya_mm,
                profile_um: f.profile.iter().map(|p| p * 1e3).collect(),
                profile_pieces: f.spline.as_ref().map(|spline| pieces(spline, 1e3)),
                reliefs: f.reliefs.clone(),
            })
        };
        let strokes = |flank: Flank| {
            let strokes = self.flanks[flank].as_ref().and_then(ExecutedFlank::strokes);
            strokes.map_or(Vec::new(), ExecutedStrokes::settings)
        };
        Settings {
            diagonal_ratio: self.ratio,
            shift_origin_mm: self.shift_origin,
            shift: pieces_of_law(&self.motion.shift, 1.0),
            delta_d_pieces: pieces_of_law(&self.motion.delta_d, 1e3),
            delta_phi_2_pieces: pieces_of_law(&self.motion.delta_phi_2, 1e6),
            tool: ToolTables { left: table(Flank::Left), right: table(Flank::Right) },
            delta_d_um: law(&self.motion.delta_d, 1e3),
            delta_phi_2_urad: law(&self.motion.delta_phi_2, 1e6),
            strokes: StrokeTables { left: strokes(Flank::Left), right: strokes(Flank::Right) },
            left: flank(Flank::Left),
            right: flank(Flank::Right),
        }
    }
}

/// z_V1 over z_V2 as the settings have it.
fn shift_of_settings(settings: &Settings) -> Result<MotionLaw, RunFailure> {
    let Some(pieces) = &settings.shift else {
        let line = vec![settings.shift_origin_mm, settings.diagonal_ratio];
        return Ok(MotionLaw::polynomial(0.0, line));
    };
    law_of_pieces(pieces, "settings.shift")
}

fn law_of_pieces(pieces: &Pieces, field: &str) -> Result<MotionLaw, RunFailure> {
    piecewise(pieces, field).map(MotionLaw::Pieces)
}

fn piecewise(pieces: &Pieces, field: &str) -> Result<PiecewisePolynomial, RunFailure> {
    PiecewisePolynomial::new(pieces.breaks_mm.clone(), pieces.coefficients.clone())
        .map_err(|e| RunFailure::of_law(&e, field))
}

/// A law in pieces as settings carry it, times a factor.
fn pieces_of_law(law: &MotionLaw, unit: f64) -> Option<Pieces> {
    match law {
        MotionLaw::Pieces(law) => Some(pieces(law, unit)),
        _ => None,
    }
}

fn pieces(law: &PiecewisePolynomial, unit: f64) -> Pieces {
    let coefficients = law.pieces().iter().map(|piece| piece.map(|c| c * unit)).collect();
    Pieces { breaks_mm: law.breaks().to_vec(), coefficients }
}

/// The flank of a tool that is not dressed: the table of the settings, else what it carries without one.
fn made_of_settings(
    settings: &Settings,
    prepared: &Prepared,
    ideal: &IdealPlan,
    flank: Flank,
) -> Result<MadeFlank, RunFailure> {
    let table = match flank {
        Flank::Left => &settings.tool.left,
        Flank::Right => &settings.tool.right,
    };
    let Some(table) = table else {
        return MadeFlank::of_plan(&prepared.setup, ideal, flank, BEYOND_OCCUPATION)
            .map_err(|e| generating_finding::failure(&e));
    };
    let f = table.f_um.iter().map(|row| row.iter().map(|f| f * 1e-3).collect()).collect();
    MadeFlank::from_table(table.w_mm.clone(), table.z_mm.clone(), f).map_err(|e| {
        let finding = Diagnostic::new(Problem::InvalidJob, e.to_string())
            .field(format!("settings.tool.{flank}"))
            .way_out("give ascending w_mm and z_mm and one row of f_um for each w_mm");
        RunFailure::bad_input(finding)
    })
}
