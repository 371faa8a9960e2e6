//! A measurement for a job of five-axis milling: target, simulated and measured flank on one grid, what all teeth share, and the job whose
//! paths have the measured deviation taken off (`docs/inspection.md#milled-gears`). The cutter is led along the flank itself, so that the
//! correction is one of the flank that it is led along; the referee mills both.

use super::super::drawn::DrawnGear;
use super::super::evaluate::evaluate_inspection;
use super::super::files::read_measurement;
use super::super::files_content::MeasuredFiles;
use super::super::statements::Statements;
use super::super::surface::{MeasuredSurface, field_points, measured_surface};
use super::characteristics::tested;
use super::flank_correction::{CorrectedField, compensated, correction_of, proofs};
use super::result::RoundResult;
use super::round::{
    Round, characteristic, flank_result, not_confirmed, of_areal, of_header, of_inspection, reason, rms_of,
};
use super::{check_teeth, fill};
use foundation::geometry::{Flank, Gear, Sides};
use foundation::numerics::{Progress, equidistant};
use job::{Diagnostic, Problem};
use measured_files::inspection::{InspectedGear, Inspection};
use metrology::Topography;
use metrology::areal::{ArealDegree, Comparison};
use milling::job::{LoadedMillingJob, MillingGear};
use milling::workflow::prepare::{PreparedMilling, WantedFlank, prepare_milling, wanted_flanks};
use milling::workflow::{deviations_at, planning_failure};
use milling::{MilledSide, MillingPlan, plan_all};
use run::{JobFailure, RunFailure, gear_of_job};
use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::path::Path;

/// Places of the grid: over the profile, along the face.
const GRID: [usize; 2] = [15, 11];

/// A gear of a job that was planned.
struct Milled {
    loaded: LoadedMillingJob,
    wanted: Sides<WantedFlank>,
    prepared: PreparedMilling,
    plan: MillingPlan,
    gear: Gear,
}

/// Judges a measured file against a job of five-axis milling.
///
/// # Errors
/// [`JobFailure`]: what is wrong with file and job, a workpiece that is no cylindrical gear with one helix, a measurement of another gear.
pub(in super::super) fn of_milled_file(
    loaded: &LoadedMillingJob,
    (path, statements): (&Path, &Statements),
    progress: &dyn Progress,
) -> Result<(Round, MeasuredFiles), JobFailure> {
    let given = cylindrical_gear(loaded)?;
    let made = Milled::of(loaded.clone(), given, progress)?;
    let drawn = made.drawn(given);
    let mut files = read_measurement(path, Some(&drawn), statements)?;
    check_teeth(&files)?;
    fill(&mut files, &drawn);
    drawn.is_of(&files.inspection)?;
    let round = made.judge(given, files.inspection.clone(), progress)?;
    Ok((round, files))
}

/// The gear that measuring machines measure.
fn cylindrical_gear(loaded: &LoadedMillingJob) -> Result<&MillingGear, RunFailure> {
    let refused = |field: &str, text: &str| {
        let finding = Diagnostic::new(Problem::InvalidJob, text).field(field);
        let finding = finding.allowed("a [gear] with one helix and the same pressure angle on both flanks");
        RunFailure::bad_input(finding.way_out("give the job of a cylindrical gear"))
    };
    let Some(gear) = &loaded.job.gear else {
        let field = if loaded.job.bevel.is_some() { "bevel" } else { "blade" };
        return Err(refused(field, "profiles and helix traces are those of cylindrical gears"));
    };
    if gear.double_helical.is_some() {
        return Err(refused(
            "gear.double_helical",
            "a double-helical gear has two helices, which no file tells apart",
        ));
    }
    if gear.drawing.cone_angle_deg != 0.0 {
        return Err(refused("gear.cone_angle_deg", "the flanks of a conical gear have helices of their own"));
    }
    let angle = gear_of_job(&gear.drawing).map_err(RunFailure::bad_input)?.data().pressure_angle;
    if angle.left != angle.right {
        return Err(refused("gear.normal_pressure_angle_deg", "the flanks have different pressure angles"));
    }
    Ok(gear)
}

impl Milled {
    fn of(
        loaded: LoadedMillingJob,
        given: &MillingGear,
        progress: &dyn Progress,
    ) -> Result<Self, RunFailure> {
        let wanted = wanted_flanks(&loaded, given)?;
        let prepared = prepare_milling(&loaded)?;
        progress.start("plan", 1);
        let plan = plan_all(&prepared.bodies.parts, &prepared.bodies.options)
            .map_err(|error| planning_failure(&error))?;
        progress.finish();
        let gear = gear_of_job(&given.drawing).map_err(RunFailure::bad_input)?;
        Ok(Self { loaded, wanted, prepared, plan, gear })
    }

    fn drawn(&self, given: &MillingGear) -> DrawnGear {
        let (data, drawing) = (self.gear.data(), &given.drawing);
        let gear = InspectedGear {
            teeth: data.teeth,
            normal_module_mm: data.normal_module,
            normal_pressure_angle_deg: data.pressure_angle.left.to_degrees(),
            helix_angle_deg: data.helix_angle.to_degrees(),
            profile_shift: Some(data.profile_shift),
            face_width_mm: Some(drawing.face_width),
            tip_diameter_mm: Some(drawing.tip_diameter),
            root_diameter_mm: Some(drawing.root_diameter),
        };
        let profile = Sides::from_fn(|flank| Some(self.wanted[flank].rolls));
        DrawnGear::new(gear, profile, Sides::from_fn(|flank| self.wanted[flank].ends))
    }

    /// Wanted deviation from the involute, transverse, > 0 material left, mm.
    fn design(&self, flank: Flank, w: f64, z: f64) -> f64 {
        self.wanted[flank].modification.as_ref().map_or(0.0, |of| of.value(w, z).unwrap_or(f64::NAN))
    }

    fn places(&self, flank: Flank) -> [Vec<f64>; 2] {
        let WantedFlank { rolls, ends, .. } = &self.wanted[flank];
        [equidistant(*rolls, GRID[0]), equidistant(*ends, GRID[1])]
    }

    /// The same with what the paths are planned with beside it.
    fn planned(&self, flank: Flank, w: f64, z: f64) -> f64 {
        self.wanted[flank].planned.as_ref().map_or(0.0, |of| of.value(w, z).unwrap_or(f64::NAN))
    }

    /// Target and simulated flank on the grid, normal, mm.
    fn topographies(&self, progress: &dyn Progress) -> Result<Sides<Option<[Topography; 2]>>, RunFailure> {
        let places = |side: MilledSide| self.places(side.flank);
        let found = deviations_at(&self.prepared.bodies, &self.plan, places, progress)?;
        let mut made: Sides<Option<[Topography; 2]>> = Sides::default();
        for (side, deviations) in found {
            let [w, z] = self.places(side.flank);
            let cos = self.gear.flank(side.flank).base_helix_angle.cos();
            let places = || w.iter().flat_map(|&w| z.iter().map(move |&z| (w, z)));
            let target: Vec<f64> = places().map(|(w, z)| cos * self.design(side.flank, w, z)).collect();
            // The rays stand on the flank that is planned.
            let simulated: Vec<f64> = places()
                .zip(&deviations)
                .map(|((w, z), d)| cos * self.planned(side.flank, w, z) + d.unwrap_or(f64::NAN))
                .collect();
            if simulated.iter().any(|value| value.is_nan()) {
                let text = format!("the cutter does not reach all of the evaluated {} flank", side.flank);
                let finding = Diagnostic::with_code("flank-not-milled", text).field("gear.evaluation");
                return Err(RunFailure::not_producible(
                    finding.way_out("plan the job first, and make it meet its target"),
                ));
            }
            let of = |f: Vec<f64>| Topography::new(w.clone(), z.clone(), f);
            made[side.flank] = of(target).zip(of(simulated)).map(|(target, simulated)| [target, simulated]);
        }
        Ok(made)
    }

    fn judge(
        &self,
        given: &MillingGear,
        inspection: Inspection,
        progress: &dyn Progress,
    ) -> Result<Round, RunFailure> {
        let tolerance = 1e-3 * self.loaded.job.target.tolerance_um;
        let design = |flank: Flank, w: f64, z: f64| self.design(flank, w, z);
        let gear = evaluate_inspection(&inspection, Some(&design)).map_err(|error| of_header(&error))?;
        let pitch = TAU / f64::from(inspection.gear.teeth.unsigned_abs());
        let made = self.topographies(progress)?;
        let corrected = self.fields();
        let mut surfaces: Sides<Option<MeasuredSurface>> = Sides::default();
        let mut flanks = BTreeMap::new();
        for flank in Flank::BOTH {
            let Some([target, simulated]) = &made[flank] else { continue };
            let places = [&target.w[..], &target.z[..]];
            let surface = measured_surface(&inspection, &gear.gear, flank, places, &design);
            let Some(surface) = surface.map_err(|error| of_inspection(&error))? else { continue };
            let measured = Topography {
                f: target.f.iter().zip(&surface.deviation.f).map(|(t, d)| t + d).collect(),
                ..target.clone()
            };
            let field = corrected[flank].areal()?;
            let compared =
                Comparison::new([target, simulated, &measured], &field, ArealDegree::Second, tolerance)
                    .map_err(|error| of_areal(&error))?;
            let result = flank_result(
                [target, simulated, simulated, &measured],
                &surface,
                &compared,
                (pitch, tolerance),
            );
            flanks.insert(flank.name(), result);
            surfaces[flank] = Some(surface);
        }
        let fields = corrected.map(|_, field| field.measured);
        let points = |field: &measured_files::inspection::Topography| {
            field_points(&inspection, &gear.gear, field, &design).unwrap_or_default()
        };
        let tests = tested(&inspection, &gear, &fields, &Default::default(), tolerance, points);
        let systematic =
            tests.iter().any(|of| of.test.as_ref().is_ok_and(|test| test.decision.name() == "correct"));
        let mut round = Round {
            result: RoundResult {
                round: 1,
                flanks,
                characteristics: tests.iter().map(characteristic).collect(),
                correction: None,
                no_correction: None,
                axes: Vec::new(),
                axes_together: None,
                axes_not_asked: BTreeMap::new(),
            },
            gear,
            inspection,
            corrected: None,
            corrected_milling: None,
            next: None,
        };
        if !systematic {
            round.result.no_correction = Some(reason(&tests));
            return Ok(round);
        }
        if surfaces.iter().all(|(_, surface)| surface.is_none()) {
            let why = "without a measured surface nothing would be proven: measure a profile and a helix trace of the same tooth";
            round.result.no_correction = Some(why.into());
            return Ok(round);
        }
        self.correct(given, &surfaces, &made, &mut round, progress)?;
        Ok(round)
    }

    fn fields(&self) -> Sides<CorrectedField> {
        let half = 0.5 * self.loaded.job.gear.as_ref().map_or(0.0, |gear| gear.drawing.face_width);
        self.wanted.map(|flank, WantedFlank { rolls, ends, active, .. }| CorrectedField {
            measured: [*rolls, *ends],
            milled: [*active, [-half, half]],
            normal_factor: self.gear.flank(flank).base_helix_angle.cos(),
        })
    }

    /// The job whose compensation takes the measured surfaces off, as surfaces of third degree, and what the referee says of it.
    fn correct(
        &self,
        given: &MillingGear,
        surfaces: &Sides<Option<MeasuredSurface>>,
        before: &Sides<Option<[Topography; 2]>>,
        round: &mut Round,
        progress: &dyn Progress,
    ) -> Result<(), RunFailure> {
        let fields = self.fields();
        let corrected = compensated(&self.loaded, surfaces, &fields)?;
        let next = Self::of(corrected, given, progress)?;
        let after = next.topographies(progress)?;
        let tolerance = 1e-3 * self.loaded.job.target.tolerance_um;
        let proof = proofs(surfaces, [before, &after], &fields, tolerance)?;
        let rms = rms_of(&proof);
        if rms[1] >= rms[0] {
            round.result.no_correction = Some(not_confirmed(rms));
            return Ok(());
        }
        round.result.correction = Some(correction_of(proof, rms));
        round.corrected_milling = Some(next.loaded);
        Ok(())
    }
}
