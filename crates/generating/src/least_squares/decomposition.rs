//! The functions of a decomposition together with the coordinates they depend on.

use super::super::GeneratingError;
use super::columns::ArgumentKinks;
use super::fit::fit_functions;
use super::functions::along;
use super::{Arguments, FitReport, FitSettings, FlankCoordinates, Samples, SplineGauge, WormFunctions};
use foundation::numerics::Jet2;

/// A target of one flank as functions of worm, dresser and motion (`docs/mathematics/planning.md#producibility`).
#[derive(Clone, Debug, PartialEq)]
pub struct SplineDecomposition<G> {
    /// The functions.
    pub functions: WormFunctions,
    /// Where on the flank their arguments are.
    pub coordinates: G,
    /// How well they meet the samples.
    pub report: FitReport,
    /// Which of the decompositions with the same sum this is.
    pub gauge: SplineGauge,
}

impl<G: FlankCoordinates> SplineDecomposition<G> {
    /// Fits the functions of the class to the samples, minimum norm, then the gauge `centred` where the functions allow it.
    ///
    /// # Errors
    /// `TooFewPoints`, `NoExtent`, `CoordinateNotFinite`, `InvalidSpline`, `FitNotSolved`.
    pub fn fit(samples: &Samples, coordinates: G, settings: &FitSettings) -> Result<Self, GeneratingError> {
        let arguments: Vec<Arguments> =
            samples.points().iter().map(|&[w, z]| coordinates.arguments(w, z)).collect();
        let kinks = ArgumentKinks::new(settings, &coordinates);
        let fit = fit_functions(samples, &arguments, settings, &kinks)?;
        let (functions, gauge) = fit.functions.centred(&coordinates, samples)?;
        Ok(Self { functions, coordinates, report: fit.report, gauge })
    }

    /// f_t of the decomposition at (w, z), mm.
    pub fn value(&self, w: f64, z: f64) -> f64 {
        self.functions.value(w, &self.coordinates.arguments(w, z))
    }

    /// F_C + F_L u + F_Q u^2 at (w, z).
    pub fn dressing_jet(&self, w: f64, z: f64) -> Jet2 {
        let [x, _, _] = self.coordinates.jets(w, z);
        self.functions.dressing_jet(w, x)
    }

    /// F_P at (w, z).
    pub fn profile_part(&self, w: f64, z: f64) -> Jet2 {
        let [_, profile, _] = self.coordinates.jets(w, z);
        along(self.functions.profile_jet(profile.f), profile)
    }

    /// F_K at (w, z).
    pub fn kinematic_part(&self, w: f64, z: f64) -> Jet2 {
        let [_, _, path] = self.coordinates.jets(w, z);
        along(self.functions.kinematic_jet(path.f), path)
    }

    /// The sum with its derivatives.
    pub fn jet(&self, w: f64, z: f64) -> Jet2 {
        self.dressing_jet(w, z) + self.profile_part(w, z) + self.kinematic_part(w, z)
    }
}
