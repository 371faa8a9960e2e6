//! A correction of the flank itself, as milling takes it: the measured surface as a surface of third degree, taken off by a table that the
//! paths are planned with beside the target, and what the referee proves of it.

use super::super::surface::MeasuredSurface;
use super::result::{CorrectionResult, MachineChange, ProofResult};
use super::round::{of_areal, proof_of};
use foundation::geometry::{Flank, Sides};
use foundation::modification::{GridSpec, ModificationSpec};
use foundation::numerics::equidistant;
use metrology::Topography;
use metrology::areal::{ArealDegree, ArealField, ArealFit, ArealPoint};
use milling::job::{LoadedMillingJob, MillingCompensation};
use run::RunFailure;
use std::collections::BTreeMap;

/// Places of a table in each direction.
const TABLE: usize = 9;

/// Where a flank is measured and where it is milled: lengths of roll and positions, mm.
#[derive(Clone, Copy, Debug)]
pub(super) struct CorrectedField {
    /// What is measured.
    pub measured: [[f64; 2]; 2],
    /// What is milled.
    pub milled: [[f64; 2]; 2],
    /// Normal over transverse deviations.
    pub normal_factor: f64,
}

impl CorrectedField {
    /// The field of areal fits.
    pub fn areal(&self) -> Result<ArealField, RunFailure> {
        let [rolls, ends] = self.measured;
        ArealField::new(rolls, ends).map_err(|error| of_areal(&error))
    }

    /// A table that takes off what a surface of third degree through the measured one says, held beyond its ends.
    pub fn taken_off(&self, flank: Flank, surface: &MeasuredSurface) -> Result<ModificationSpec, RunFailure> {
        let of = &surface.deviation;
        let places = of.w.iter().flat_map(|&w| of.z.iter().map(move |&z| (w, z)));
        let points: Vec<ArealPoint> = places
            .zip(&of.f)
            .filter(|(_, f)| f.is_finite())
            .map(|((w, z), &f)| ArealPoint { w, z, f, weight: 1.0 })
            .collect();
        let fit = ArealFit::of_points(&points, &self.areal()?, ArealDegree::Third)
            .map_err(|error| of_areal(&error))?;
        let [w, z] = self.milled.map(|ends| equidistant(ends, TABLE));
        let inside = |x: f64, [from, to]: [f64; 2]| x.clamp(from, to);
        let [rolls, ends] = self.measured;
        let value = |w: f64, z: f64| -1e3 * fit.value(inside(w, rolls), inside(z, ends)) / self.normal_factor;
        let f_um = w.iter().map(|&w| z.iter().map(|&z| value(w, z)).collect()).collect();
        let table = GridSpec { w_mm: w, z_mm: z, f_um, flank: flank.into(), ..GridSpec::default() };
        Ok(ModificationSpec::Grid(table))
    }
}

/// A job with tables that take off what was measured, beside those that it has.
pub(super) fn compensated(
    loaded: &LoadedMillingJob,
    surfaces: &Sides<Option<MeasuredSurface>>,
    fields: &Sides<CorrectedField>,
) -> Result<LoadedMillingJob, RunFailure> {
    let mut corrected = loaded.clone();
    let mut modifications = corrected.job.compensation.take().unwrap_or_default().modifications;
    for (flank, surface) in surfaces.iter() {
        if let Some(surface) = surface {
            modifications.push(fields[flank].taken_off(flank, surface)?);
        }
    }
    corrected.job.compensation = Some(MillingCompensation { modifications });
    Ok(corrected)
}

/// What the measured flanks leave before and after the change of the simulated flanks from `before` to `after`.
pub(super) fn proofs(
    surfaces: &Sides<Option<MeasuredSurface>>,
    [before, after]: [&Sides<Option<[Topography; 2]>>; 2],
    fields: &Sides<CorrectedField>,
    tolerance: f64,
) -> Result<BTreeMap<&'static str, ProofResult>, RunFailure> {
    let mut proof = BTreeMap::new();
    for flank in Flank::BOTH {
        let (Some(surface), Some([_, old]), Some([_, new])) =
            (&surfaces[flank], &before[flank], &after[flank])
        else {
            continue;
        };
        let field = fields[flank].areal()?;
        // The cutter is led along what is planned: there is no first order beside it.
        proof.insert(flank.name(), proof_of(surface, &new.minus(old), &field, tolerance, 0.0)?);
    }
    Ok(proof)
}

/// A correction without settings.
pub(super) fn correction_of(
    proof: BTreeMap<&'static str, ProofResult>,
    [before, after]: [f64; 2],
) -> CorrectionResult {
    CorrectionResult {
        settings: Vec::new(),
        rms_before_um: before,
        rms_predicted_um: after,
        rms_unremovable_um: after,
        rank: [0; 2],
        not_told_apart: Vec::new(),
        proof,
        machine: MachineChange::default(),
    }
}
