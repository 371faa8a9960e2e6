//! A measured grid of a milled bevel gear for its job: target, simulated and measured flank, what all teeth share, and the job whose paths
//! have the measured deviation taken off (`docs/inspection.md#bevel-gears`). Places are lengths of roll in the middle of the face and
//! positions along the pitch cone from there.

use super::super::surface::{MeasuredSurface, mean};
use super::characteristics::{OfTooth, of_field, tested_teeth};
use super::flank_correction::{CorrectedField, compensated, correction_of, proofs};
use super::result::RoundResult;
use super::round::{characteristic, flank_result, not_confirmed, of_areal, reason, rms_of};
use foundation::geometry::{BevelGear, Flank, Sides};
use foundation::numerics::Progress;
use job::{Diagnostic, Problem};
use metrology::Topography;
use metrology::areal::{ArealDegree, Comparison};
use milling::job::{LoadedMillingJob, MeasuringGrid};
use milling::workflow::prepare::{PreparedMilling, WantedBevel, prepare_milling, wanted_bevel};
use milling::workflow::{deviations_at, planning_failure};
use milling::{MillingPlan, plan_all};
use run::RunFailure;
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// Readings of the teeth of a flank on its grid, deviations from the target, normal, mm; NaN where nothing was measured.
pub type GridTeeth = BTreeMap<u32, Vec<Topography>>;

/// A bevel gear of a job that was planned.
pub struct MilledBevel {
    loaded: LoadedMillingJob,
    /// Its drawing.
    pub gear: BevelGear,
    /// Its flanks.
    pub wanted: Sides<WantedBevel>,
    /// Where they are measured.
    pub grid: MeasuringGrid,
    prepared: PreparedMilling,
    plan: MillingPlan,
}

/// What a measurement says for the job.
pub struct BevelRound {
    /// Comparison, tests, correction and proof.
    pub result: RoundResult,
    /// The job with the compensation that answers it.
    pub corrected: Option<LoadedMillingJob>,
}

/// Target and simulated flank, mm.
type Made = Sides<Option<[Topography; 2]>>;

impl MilledBevel {
    /// Plans the job of a bevel gear.
    ///
    /// # Errors
    /// [`RunFailure`]: what is wrong with the job, another workpiece.
    pub fn of(loaded: LoadedMillingJob, progress: &dyn Progress) -> Result<Self, RunFailure> {
        let Some(given) = &loaded.job.bevel else {
            let text = "a grid of points is how bevel gears are measured";
            let finding = Diagnostic::new(Problem::MissingKey, text).field("bevel");
            return Err(RunFailure::bad_input(finding.way_out("give the job of a bevel gear")));
        };
        if given.double_helical.is_some() {
            let text = "a double-helical gear has two flank lines, which no file tells apart";
            let finding = Diagnostic::new(Problem::InvalidJob, text).field("bevel.double_helical");
            return Err(RunFailure::bad_input(
                finding
                    .allowed("a [bevel] whose flanks reach from toe to heel")
                    .way_out("give the job of such a gear"),
            ));
        }
        let (gear, wanted) = wanted_bevel(&loaded, given)?;
        let prepared = prepare_milling(&loaded)?;
        progress.start("plan", 1);
        let plan = plan_all(&prepared.bodies.parts, &prepared.bodies.options)
            .map_err(|error| planning_failure(&error))?;
        progress.finish();
        let grid = loaded.job.measuring_grid.unwrap_or_default();
        Ok(Self { loaded, gear, wanted, grid, prepared, plan })
    }

    /// Tolerance of the job, mm.
    fn tolerance(&self) -> f64 {
        1e-3 * self.loaded.job.target.tolerance_um
    }

    /// Lengths of roll and positions of the grid of a flank.
    pub fn places(&self, flank: Flank) -> [Vec<f64>; 2] {
        self.wanted[flank].places(&self.grid)
    }

    /// A function over the grid of a flank.
    fn over(&self, flank: Flank, f: impl Fn(f64, f64) -> f64) -> Vec<f64> {
        let [w, z] = self.places(flank);
        w.iter().flat_map(|&w| z.iter().map(move |&z| (w, z))).map(|(w, z)| f(w, z)).collect()
    }

    /// Target and simulated flank on the grid, normal to the nominal flank.
    fn topographies(&self, progress: &dyn Progress) -> Result<Made, RunFailure> {
        let parameters = |flank: Flank| -> [Vec<f64>; 2] {
            let wanted = &self.wanted[flank];
            let [w, z] = self.places(flank);
            let heights = w.iter().map(|w| wanted.parameters(*w, 0.0)[0]);
            let lengths = z.iter().map(|z| wanted.parameters(wanted.rolls[0], *z)[1]);
            [heights.collect(), lengths.collect()]
        };
        let found =
            deviations_at(&self.prepared.bodies, &self.plan, |side| parameters(side.flank), progress)?;
        let mut made = Made::default();
        for (side, deviations) in found {
            let flank = side.flank;
            let wanted = &self.wanted[flank];
            let target = self.over(flank, |w, z| wanted.modification(w, z));
            let beside = self.over(flank, |w, z| wanted.beside(w, z));
            // The rays stand on the flank that is planned.
            let simulated: Vec<f64> = target
                .iter()
                .zip(&beside)
                .zip(&deviations)
                .map(|((target, beside), d)| target + beside + d.unwrap_or(f64::NAN))
                .collect();
            if simulated.iter().any(|value| value.is_nan()) {
                let text = format!("the cutter does not reach all of the measured {flank} flank");
                let finding = Diagnostic::with_code("flank-not-milled", text).field("measuring_grid");
                return Err(RunFailure::not_producible(finding.way_out(
                    "plan the job first, and make it meet its target; or measure with larger margins",
                )));
            }
            let [w, z] = self.places(flank);
            let of = |f: Vec<f64>| Topography::new(w.clone(), z.clone(), f);
            made[flank] = of(target).zip(of(simulated)).map(|(target, simulated)| [target, simulated]);
        }
        Ok(made)
    }

    fn fields(&self) -> Sides<CorrectedField> {
        let ends = |list: &[f64]| [list[0], list[list.len() - 1]];
        self.wanted.map(|flank, wanted| {
            let [w, z] = self.places(flank);
            CorrectedField {
                measured: [ends(&w), ends(&z)],
                milled: [wanted.rolls, wanted.ends],
                normal_factor: wanted.normal_factor,
            }
        })
    }

    /// Judges what was measured, and corrects the job.
    ///
    /// # Errors
    /// [`RunFailure`]: grids that are too sparse, and those of planning and referee.
    pub fn judge(&self, teeth: &Sides<GridTeeth>, progress: &dyn Progress) -> Result<BevelRound, RunFailure> {
        let (tolerance, fields) = (self.tolerance(), self.fields());
        let pitch = TAU / f64::from(self.gear.data().teeth);
        let made = self.topographies(progress)?;
        let mut surfaces: Sides<Option<MeasuredSurface>> = Sides::default();
        let (mut flanks, mut tests) = (BTreeMap::new(), Vec::new());
        for flank in Flank::BOTH {
            let Some([target, simulated]) = &made[flank] else { continue };
            let Some(surface) = surface(&teeth[flank]) else { continue };
            let measured = target.plus(&surface.deviation);
            let compared = Comparison::new(
                [target, simulated, &measured],
                &fields[flank].areal()?,
                ArealDegree::Second,
                tolerance,
            )
            .map_err(|error| of_areal(&error))?;
            let planned = Topography { f: self.planned(flank), ..target.clone() };
            let stages = [target, &planned, simulated, &measured];
            flanks.insert(flank.name(), flank_result(stages, &surface, &compared, (pitch, tolerance)));
            let features = |one: &Topography| of_field(&points(one), fields[flank].measured);
            let of_teeth: BTreeMap<u32, Vec<OfTooth>> = teeth[flank]
                .iter()
                .map(|(tooth, readings)| (*tooth, readings.iter().map(features).collect()))
                .collect();
            tests.extend(tested_teeth(flank, &of_teeth, pitch, &Default::default(), tolerance));
            surfaces[flank] = Some(surface);
        }
        let systematic =
            tests.iter().any(|of| of.test.as_ref().is_ok_and(|test| test.decision.name() == "correct"));
        let mut round = BevelRound {
            result: RoundResult {
                round: 1,
                flanks,
                characteristics: tests.iter().map(characteristic).collect(),
                correction: None,
                no_correction: (!systematic).then(|| reason(&tests)),
                axes: Vec::new(),
                axes_together: None,
                axes_not_asked: BTreeMap::new(),
            },
            corrected: None,
        };
        if systematic {
            self.correct(&surfaces, &made, &mut round, progress)?;
        }
        Ok(round)
    }

    /// Target with what paths are planned with beside it.
    fn planned(&self, flank: Flank) -> Vec<f64> {
        let wanted = &self.wanted[flank];
        self.over(flank, |w, z| wanted.modification(w, z) + wanted.beside(w, z))
    }

    fn correct(
        &self,
        surfaces: &Sides<Option<MeasuredSurface>>,
        before: &Made,
        round: &mut BevelRound,
        progress: &dyn Progress,
    ) -> Result<(), RunFailure> {
        let fields = self.fields();
        let corrected = compensated(&self.loaded, surfaces, &fields)?;
        let next = Self::of(corrected, progress)?;
        let after = next.topographies(progress)?;
        let proof = proofs(surfaces, [before, &after], &fields, self.tolerance())?;
        let rms = rms_of(&proof);
        if rms[1] >= rms[0] {
            round.result.no_correction = Some(not_confirmed(rms));
            return Ok(());
        }
        round.result.correction = Some(correction_of(proof, rms));
        round.corrected = Some(next.loaded);
        Ok(())
    }
}

/// The surface of a flank, mean over its teeth about their means; `None` where none was measured.
fn surface(teeth: &GridTeeth) -> Option<MeasuredSurface> {
    let of_teeth: Vec<(u32, Topography)> =
        teeth.iter().filter_map(|(tooth, readings)| Some((*tooth, mean(readings)?))).collect();
    let deviation = mean(of_teeth.iter().map(|(_, of)| of))?;
    let how = format!("{} x {} points of a grid a tooth", deviation.w.len(), deviation.z.len());
    Some(MeasuredSurface {
        deviation,
        teeth: of_teeth,
        how,
        mismatch: None,
        outside: Vec::new(),
        sees_twist: true,
    })
}

/// Places with what was measured there.
fn points(of: &Topography) -> Vec<(f64, f64, f64)> {
    let places = of.w.iter().flat_map(|&w| of.z.iter().map(move |&z| (w, z)));
    places.zip(&of.f).filter(|(_, f)| f.is_finite()).map(|((w, z), f)| (w, z, *f)).collect()
}
