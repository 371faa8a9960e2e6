//! A grinding process with all its settings, ready to be run: from a plan or from the `[settings]` of a job. Both go the
//! same way to the referee and to the report.

use super::prepare::{Prepared, Remark, RunFailure, settings_reliefs};
use crate::exchange::LoadedJob;
use crate::exchange::job::{FlankSettings, Job, Settings};
use crate::geometry::{Flank, Sides};
use crate::kinematics::{DressingMotion, GeneratingMotion, MotionLaw};
use crate::metrology::Topography;
use crate::modification::ModificationSpec;
use crate::numerics::Chebyshev;
use crate::process::dressing::{DressedWorm, DresserTool, dressing_motion};
use crate::process::generating::{
    Decomposition, GrindingPlan, IdealPlan, IdealWorm, PlanningGrid, ProfilePlace, ProfilePolicy,
    dresser_of_plan, dresser_profile, dressing_interval,
};
use std::f64::consts::PI;

/// One flank of a process with what it is expected to leave.
#[derive(Clone, Debug)]
pub struct ExecutedFlank {
    /// DK over v: rad, rad, mm, mm.
    pub corrections: [Chebyshev; 4],
    /// Polynomial profile that the dresser leaves on the gear over u = w - w_m, transverse, mm.
    pub profile: Vec<f64>,
    /// Profile forms that the dresser carries beside it, as a job describes them.
    pub reliefs: Vec<ModificationSpec>,
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
    /// The dresser with its profile.
    pub tool: DresserTool,
    /// z_1 occupied on the worm, mm.
    pub occupation: [f64; 2],
    /// Stroke of the feed z_V2, overrun included, mm.
    pub feed_range: [f64; 2],
    /// Flanks that are ground.
    pub flanks: Sides<Option<ExecutedFlank>>,
    /// Remarks.
    pub warnings: Vec<Remark>,
}

impl ExecutedFlank {
    /// The motion that dresses this flank.
    pub fn dressing(&self, tool: &DresserTool) -> DressingMotion {
        dressing_motion(tool.chain, &self.corrections)
    }
}

/// Least overrun of the feed beyond the last contact, mm.
const LEAST_OVERRUN: f64 = 1.0;
/// Determinant ratio below which a warning is given.
const LOW_DETERMINANT: f64 = 0.3;

/// Feed stroke from the feeds at which the grid is really ground, with the job's overrun and one feed mark.
fn stroke(job: &Job, feeds: impl Iterator<Item = f64>) -> [f64; 2] {
    let [a, b] = feeds.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], v| [a.min(v), b.max(v)]);
    let mark = job.grinding.feed_per_revolution.unwrap_or(0.0);
    let over = job.grinding.overrun.unwrap_or(LEAST_OVERRUN).max(LEAST_OVERRUN).max(mark);
    [a - over, b + over]
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
    /// From a finished plan.
    pub fn of_plan(job: &Job, prepared: &Prepared, plan: &GrindingPlan) -> Self {
        let flanks = Sides::from_fn(|flank| {
            let f = plan.flanks[flank].as_ref()?;
            let (target, planned) =
                executed(&f.w, &f.z, &f.target, f.planned.iter().map(|p| p.f_n).collect())?;
            let profile = dresser_profile(plan.ideal.worms[flank].as_ref()?, plan.policy);
            let determinant = f.planned.iter().map(|p| p.determinant_ratio).fold(f64::INFINITY, f64::min);
            Some(ExecutedFlank {
                corrections: f.dressed.corrections.clone(),
                profile,
                reliefs: prepared.reliefs[flank].clone(),
                target,
                planned,
                determinant,
            })
        });
        let feeds =
            plan.flanks.iter().filter_map(|(_, f)| f.as_ref()).flat_map(|f| f.planned.iter().map(|p| p.feed));
        let mut warnings = Vec::new();
        determinant_warnings(&flanks, &mut warnings);
        Self {
            motion: plan.ideal.motion.clone(),
            ratio: plan.ideal.ratio,
            shift_origin: plan.ideal.shift_origin,
            tool: plan.tool.clone(),
            occupation: plan.ideal.occupation,
            feed_range: stroke(job, feeds),
            flanks,
            warnings,
        }
    }

    /// From the settings of a job: nothing is planned or corrected.
    ///
    /// # Errors
    /// [`RunFailure`]: reliefs that are impossible; contact and dressing for these settings.
    pub fn of_settings(
        loaded: &LoadedJob,
        prepared: &Prepared,
        settings: &Settings,
    ) -> Result<Self, RunFailure> {
        let job = &loaded.job;
        let setup = &prepared.setup;
        let scaled = |c: &[f64], unit: f64| MotionLaw::polynomial(0.0, c.iter().map(|c| c * unit).collect());
        let shift = vec![settings.shift_origin_mm, settings.diagonal_ratio];
        let mut motion = setup.pair.motion(MotionLaw::polynomial(0.0, shift));
        motion.delta_d = scaled(&settings.delta_d_um, 1e-3);
        motion.delta_phi_2 = scaled(&settings.delta_phi_2_urad, 1e-6);
        let given = |flank: Flank| match flank {
            Flank::Left => settings.left.as_ref(),
            Flank::Right => settings.right.as_ref(),
        };
        let relief_specs = |flank: Flank| given(flank).map_or(&[][..], |s| &s.reliefs[..]);
        let worms = Sides::try_from_fn(|flank| -> Result<_, RunFailure> {
            if prepared.targets[flank].is_none() {
                return Ok(None);
            }
            let reliefs = settings_reliefs(loaded, relief_specs(flank), flank, &setup.fields[flank])?;
            Ok(Some(IdealWorm {
                lines: setup.lines[flank],
                ratio: 0.0,
                shift_origin: settings.shift_origin_mm,
                parts: Decomposition {
                    t: 0.0,
                    t_k: setup.lines[flank].t_k,
                    constant: [0.0; 4],
                    linear: [0.0; 3],
                    profile: given(flank)
                        .map_or(Vec::new(), |s| s.profile_um.iter().map(|p| p * 1e-3).collect()),
                    kinematic: [0.0; 4],
                },
                reliefs,
            }))
        })?;
        let which: Vec<Flank> =
            prepared.targets.iter().filter(|(_, t)| t.is_some()).map(|(flank, _)| flank).collect();
        let occupied = setup.occupation(settings.diagonal_ratio, &which);
        let ideal = IdealPlan {
            ratio: settings.diagonal_ratio,
            shift_origin: settings.shift_origin_mm,
            commanded: Sides { left: None, right: None },
            worms,
            motion: motion.clone(),
            occupation: occupied.map(|z| z - settings.shift_origin_mm),
        };
        let policy = ProfilePolicy { place: ProfilePlace::Dresser, free_dresser: true };
        let tool = dresser_of_plan(setup, &ideal, policy);
        let grid = PlanningGrid::new(setup, job.grid.profile_points, job.grid.helix_points);
        let mut feeds = Vec::new();
        let flanks = Sides::try_from_fn(|flank| -> Result<_, RunFailure> {
            let Some(target) = &prepared.targets[flank] else { return Ok(None) };
            let corrections = match given(flank) {
                Some(s) => correction_series(s),
                None => {
                    let (from, to) = dressing_interval(setup, &ideal, flank, 3.0);
                    [0, 1, 2, 3].map(|_| Chebyshev::constant(from, to, 0.0))
                }
            };
            let worm = DressedWorm::new(&tool, flank, &corrections);
            let ground = grid.ground(setup, flank, &motion, &worm).map_err(|e| RunFailure::from(&e))?;
            let wanted =
                grid.target(flank, target, setup.lines[flank].cos_b2).map_err(|e| RunFailure::from(&e))?;
            feeds.extend(ground.iter().map(|g| g.feed));
            let made = executed(&grid.w[flank], &grid.z, &wanted, ground.iter().map(|g| g.f_n).collect());
            let determinant = ground.iter().map(|g| g.determinant_ratio).fold(f64::INFINITY, f64::min);
            Ok(made.map(|(target, planned)| ExecutedFlank {
                corrections,
                profile: ideal.worms[flank].as_ref().map_or(Vec::new(), |w| w.parts.profile.clone()),
                reliefs: relief_specs(flank).to_vec(),
                target,
                planned,
                determinant,
            }))
        })?;
        let mut warnings = Vec::new();
        determinant_warnings(&flanks, &mut warnings);
        Ok(Self {
            motion,
            ratio: ideal.ratio,
            shift_origin: ideal.shift_origin,
            tool,
            occupation: ideal.occupation,
            feed_range: stroke(job, feeds.into_iter()),
            flanks,
            warnings,
        })
    }

    /// The settings as a job carries them.
    pub fn settings(&self) -> Settings {
        let law = |law: &MotionLaw, unit: f64| match law {
            MotionLaw::Polynomial { coefficients, .. } => coefficients.iter().map(|c| c * unit).collect(),
            MotionLaw::Series(_) | MotionLaw::Pieces(_) => Vec::new(),
        };
        let flank = |flank: Flank| {
            let f = self.flanks[flank].as_ref()?;
            let (from, to) = f.corrections[0].interval();
            let series =
                |j: usize, unit: f64| f.corrections[j].coefficients().iter().map(|c| c * unit).collect();
            Some(FlankSettings {
                v_from_mm: from,
                v_to_mm: to,
                d_phi_s_deg: series(0, 180.0 / PI),
                d_gamma_deg: series(1, 180.0 / PI),
                d_d_mm: series(2, 1.0),
                d_v_ya_mm: series(3, 1.0),
                profile_um: f.profile.iter().map(|p| p * 1e3).collect(),
                reliefs: f.reliefs.clone(),
            })
        };
        Settings {
            diagonal_ratio: self.ratio,
            shift_origin_mm: self.shift_origin,
            delta_d_um: law(&self.motion.delta_d, 1e3),
            delta_phi_2_urad: law(&self.motion.delta_phi_2, 1e6),
            left: flank(Flank::Left),
            right: flank(Flank::Right),
        }
    }
}

fn correction_series(s: &FlankSettings) -> [Chebyshev; 4] {
    let series = |c: &[f64], unit: f64| {
        let coefficients = if c.is_empty() { vec![0.0] } else { c.iter().map(|c| c * unit).collect() };
        Chebyshev::from_coefficients(s.v_from_mm, s.v_to_mm, coefficients)
    };
    [
        series(&s.d_phi_s_deg, PI / 180.0),
        series(&s.d_gamma_deg, PI / 180.0),
        series(&s.d_d_mm, 1.0),
        series(&s.d_v_ya_mm, 1.0),
    ]
}
