//! From a commanded polynomial to worm functions and motion, the exact flank they leave, and the correction of the command
//! (spec 28 section 4, steps 2 to 5).

use super::target::ClassFit;
use super::{
    FlankTarget, GeneratingError, GrindingSetup, IdealWorm, ProfilePlace, common_motion, decompose_diagonal,
    decompose_radial,
};
use crate::contact::{ContactSolution, ExactContact, ModifiedThread, ToolSurface};
use crate::geometry::{Flank, Sides};
use crate::kinematics::{GeneratingMotion, MotionLaw};
use crate::numerics::Polynomial2;

/// Rounds of precompensation with the ideal worm (spec 28 section 4).
pub(super) const ROUNDS: usize = 4;

/// Steepest worm lines on the workpiece, |tan(rho_2)|: beyond it the shift is too small to tell them from the profile.
const STEEPEST: f64 = 1e4;

/// Who carries the profile, and whether the dresser may be made for it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProfilePolicy {
    /// Place of the u^2 part.
    pub place: ProfilePlace,
    /// The dresser is made for this job (`[dresser] modification = "target"`).
    pub free_dresser: bool,
}

/// Points on the flanks on which a plan is judged, row-major `[w][z]`.
#[derive(Clone, Debug)]
pub struct PlanningGrid {
    /// Lengths of roll per flank, mm.
    pub w: Sides<Vec<f64>>,
    /// Axial positions, mm.
    pub z: Vec<f64>,
    fits: Sides<ClassFit>,
    pure_fits: Sides<ClassFit>,
}

/// Equidistant numbers from `from` to `to`, both included.
pub(super) fn equidistant([from, to]: [f64; 2], n: usize) -> Vec<f64> {
    (0..n).map(|i| from + (to - from) * i as f64 / (n - 1) as f64).collect()
}

impl PlanningGrid {
    /// `nw` x `nz` equidistant points over the evaluation fields.
    pub fn new(setup: &GrindingSetup, nw: usize, nz: usize) -> Self {
        let w = setup.fields.map(|_, f| equidistant(f.roll(), nw));
        let z = equidistant(setup.fields.left.face(), nz);
        let points = w.map(|flank, w| {
            let field = &setup.fields[flank];
            w.iter()
                .flat_map(|&w| z.iter().map(move |&z| (w - field.roll_middle(), z - field.face_middle())))
                .collect::<Vec<_>>()
        });
        let fits = points.map(|_, p| ClassFit::new(p));
        let pure_fits = points.map(|_, p| ClassFit::without_mixed_terms(p));
        Self { w, z, fits, pure_fits }
    }

    /// Target values on one flank, normal, mm.
    ///
    /// # Errors
    /// Evaluation errors of the target.
    pub fn target(
        &self,
        flank: Flank,
        target: &FlankTarget,
        cos_b2: f64,
    ) -> Result<Vec<f64>, GeneratingError> {
        let mut values = Vec::with_capacity(self.w[flank].len() * self.z.len());
        for &w in &self.w[flank] {
            for &z in &self.z {
                values.push(target.value(w, z)? * cos_b2);
            }
        }
        Ok(values)
    }

    /// The exact flank left by a tool surface, by grid point.
    ///
    /// # Errors
    /// Those of the exact contact.
    pub fn ground<S: ToolSurface>(
        &self,
        setup: &GrindingSetup,
        flank: Flank,
        motion: &GeneratingMotion,
        surface: &S,
    ) -> Result<Vec<ContactSolution>, GeneratingError> {
        let contact = ExactContact::new(&setup.pair, flank, motion, surface);
        Ok(contact.solve_grid(&self.w[flank], &self.z)?)
    }

    /// Correction of the command that the normal errors `e` (target - ground, mm) ask for, transverse.
    pub fn correction(&self, flank: Flank, e: &[f64], cos_b2: f64, mixed: bool) -> Polynomial2 {
        let transverse: Vec<f64> = e.iter().map(|e| e / cos_b2).collect();
        let fit = if mixed { &self.fits[flank] } else { &self.pure_fits[flank] };
        fit.fit(&transverse)
    }
}

/// Worm functions and motion for one command, before any dresser is asked.
#[derive(Clone, Debug)]
pub struct IdealPlan {
    /// Diagonal ratio K (0: radial).
    pub ratio: f64,
    /// z_V01, mm.
    pub shift_origin: f64,
    /// Command per flank: polynomial in (u, y), transverse, mm.
    pub commanded: Sides<Option<Polynomial2>>,
    /// Ideal worm per flank.
    pub worms: Sides<Option<IdealWorm>>,
    /// The common motion.
    pub motion: GeneratingMotion,
    /// z_1 occupied on the worm with z_V01 applied, mm.
    pub occupation: [f64; 2],
}

/// Error of an ideal plan on the planning grid.
#[derive(Clone, Debug)]
pub struct GroundError {
    /// target - ground per grid point and flank, normal, mm.
    pub error: Sides<Option<Vec<f64>>>,
    /// Least determinant ratio of both flanks.
    pub determinant: f64,
}

impl GroundError {
    /// Compares what `ground` leaves on each flank (`None`: not ground) with its target.
    ///
    /// # Errors
    /// Those of `ground`; evaluation errors of the target.
    pub(super) fn of(
        setup: &GrindingSetup,
        targets: &Sides<Option<FlankTarget>>,
        grid: &PlanningGrid,
        ground: impl Fn(Flank) -> Option<Result<Vec<ContactSolution>, GeneratingError>>,
    ) -> Result<Self, GeneratingError> {
        let mut determinant = f64::INFINITY;
        let error = Sides::try_from_fn(|flank| -> Result<_, GeneratingError> {
            let (Some(ground), Some(target)) = (ground(flank), &targets[flank]) else { return Ok(None) };
            let ground = ground?;
            let wanted = grid.target(flank, target, setup.lines[flank].cos_b2)?;
            determinant = ground.iter().map(|g| g.determinant_ratio).fold(determinant, f64::min);
            Ok(Some(wanted.iter().zip(&ground).map(|(t, g)| t - g.f_n).collect()))
        })?;
        Ok(Self { error, determinant })
    }

    /// Largest |error| of one flank, mm.
    pub fn largest(&self, flank: Flank) -> Option<f64> {
        self.error[flank].as_ref().map(|e| e.iter().fold(0.0, |m: f64, x| m.max(x.abs())))
    }

    /// Largest |error| of all flanks, mm.
    pub fn max(&self) -> f64 {
        Flank::BOTH.into_iter().filter_map(|f| self.largest(f)).fold(0.0, f64::max)
    }
}

impl IdealPlan {
    /// Decomposes the commands at ratio K (0: class `radial`) and splits the common motion.
    ///
    /// # Errors
    /// [`GeneratingError::DegenerateDirection`], [`GeneratingError::NoFlank`].
    pub fn new(
        setup: &GrindingSetup,
        targets: &Sides<Option<FlankTarget>>,
        commanded: Sides<Option<Polynomial2>>,
        ratio: f64,
        policy: ProfilePolicy,
    ) -> Result<Self, GeneratingError> {
        let which: Vec<Flank> = targets.iter().filter(|(_, t)| t.is_some()).map(|(f, _)| f).collect();
        if which.is_empty() {
            return Err(GeneratingError::NoFlank);
        }
        let occupied = setup.occupation(ratio, &which);
        let shift_origin = 0.5 * (occupied[0] + occupied[1]);
        let parts = Sides::try_from_fn(|flank| {
            let Some(a) = &commanded[flank] else { return Ok(None) };
            let lines = &setup.lines[flank];
            if ratio == 0.0 {
                let mut parts = decompose_radial(a, lines.t_k);
                // The target's own profile terms only: compensating ones are advice, not plan (spec 28 section 6).
                for (i, p) in parts.profile.iter_mut().enumerate() {
                    *p = if i == 0 { 0.0 } else { a.coefficient(i, 0) };
                }
                if !policy.free_dresser {
                    parts.profile.clear();
                }
                return Ok(Some(parts));
            }
            let t = lines.work_direction(ratio);
            if t.is_nan() || t.abs() > STEEPEST || (t - lines.t_k).abs() < 1e-6 || lines.big_t1.abs() < 1e-9 {
                return Err(GeneratingError::DegenerateDirection { flank, ratio });
            }
            let p_2 = match policy.place {
                ProfilePlace::Diagonal => 0.0,
                ProfilePlace::Dresser | ProfilePlace::Correction => a.coefficient(2, 0),
            };
            let mut parts = decompose_diagonal(a, t, lines.t_k, p_2);
            if !policy.free_dresser {
                parts.profile.truncate(3); // no dresser is there to carry u^3 and higher
            }
            Ok(Some(parts))
        })?;
        let (delta_d, delta_phi_2) = common_motion(&setup.lines, &parts);
        let mut motion = setup.pair.motion(MotionLaw::polynomial(0.0, vec![shift_origin, ratio]));
        motion.delta_d = delta_d;
        motion.delta_phi_2 = delta_phi_2;
        let worms = parts.map(|flank, parts| {
            parts.clone().map(|parts| IdealWorm {
                lines: setup.lines[flank],
                ratio,
                shift_origin,
                parts,
                reliefs: targets[flank].as_ref().map(|t| t.reliefs.clone()).unwrap_or_default(),
            })
        });
        Ok(Self {
            ratio,
            shift_origin,
            commanded,
            worms,
            motion,
            occupation: occupied.map(|z| z - shift_origin),
        })
    }

    /// What the ideal worm leaves, against the target.
    ///
    /// # Errors
    /// Those of the exact contact.
    pub fn error(
        &self,
        setup: &GrindingSetup,
        targets: &Sides<Option<FlankTarget>>,
        grid: &PlanningGrid,
    ) -> Result<GroundError, GeneratingError> {
        GroundError::of(setup, targets, grid, |flank| {
            self.worms[flank].as_ref().map(|worm| {
                let thread = ModifiedThread::new(setup.pair.flanks[flank].worm, worm);
                grid.ground(setup, flank, &self.motion, &thread)
            })
        })
    }
}

/// The commands corrected by the fitted errors.
pub(super) fn corrected(
    setup: &GrindingSetup,
    grid: &PlanningGrid,
    commanded: &Sides<Option<Polynomial2>>,
    error: &GroundError,
    mixed: bool,
) -> Sides<Option<Polynomial2>> {
    Sides::from_fn(|flank| {
        let (Some(a), Some(e)) = (&commanded[flank], &error.error[flank]) else {
            return commanded[flank].clone();
        };
        Some(a.add(&grid.correction(flank, e, setup.lines[flank].cos_b2, mixed)))
    })
}

/// Precompensation: corrects the command by the fitted error of the exact flank, `rounds` times or until a round does not
/// reduce the largest error. Returns the best plan, its error and the largest error per flank by round, mm.
///
/// # Errors
/// Those of [`IdealPlan::new`] and [`IdealPlan::error`] in the first round; a later round that fails ends the loop.
pub fn precompensate(
    setup: &GrindingSetup,
    targets: &Sides<Option<FlankTarget>>,
    grid: &PlanningGrid,
    ratio: f64,
    policy: ProfilePolicy,
    rounds: usize,
) -> Result<(IdealPlan, GroundError, Sides<Vec<f64>>), GeneratingError> {
    let mixed = ratio != 0.0;
    let command = targets.map(|_, t| t.as_ref().map(|t| t.polynomial.clone()));
    let mut best = IdealPlan::new(setup, targets, command, ratio, policy)?;
    let mut error = best.error(setup, targets, grid)?;
    let mut record: Sides<Vec<f64>> = Sides::from_fn(|f| error.largest(f).into_iter().collect());
    for _ in 0..rounds {
        let command = corrected(setup, grid, &best.commanded, &error, mixed);
        let Ok(next) = IdealPlan::new(setup, targets, command, ratio, policy) else { break };
        let Ok(next_error) = next.error(setup, targets, grid) else { break };
        for flank in Flank::BOTH {
            record[flank].extend(next_error.largest(flank));
        }
        if next_error.max() >= error.max() {
            break;
        }
        (best, error) = (next, next_error);
    }
    Ok((best, error, record))
}
