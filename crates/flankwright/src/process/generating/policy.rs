//! What a plan may choose from: who carries the profile, what counts as standing on the tool's lines, which of the equal
//! decompositions is made. Plain data.

use super::ProfilePlace;
use super::least_squares::FitNorm;
use crate::geometry::Sides;

/// Who carries the profile, and whether the dresser may be made for it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProfilePolicy {
    /// Place of the u^2 part.
    pub place: ProfilePlace,
    /// The dresser is made for this job (`[dresser] modification = "target"`).
    pub free_dresser: bool,
    /// Parts of the target that are no polynomials stand on the tool's lines as they are when these miss them by no more
    /// than this; else they are best-fitted. Transverse, mm.
    pub line_tolerance: f64,
    /// What a best fit makes small.
    pub norm: FitNorm,
    /// The dresser dresses both worm flanks with one motion.
    pub two_flanks: bool,
    /// Free coefficients of the decomposition per flank; `None`: gauge `centred`.
    pub gauge: Sides<Option<FreeCoefficients>>,
}

/// The free coefficients of a decomposition, in centred variables, transverse (spec 25 section 4).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FreeCoefficients {
    /// K_10, mm/mm.
    pub k_10: f64,
    /// Share of u^2 in the profile, mm/mm^2; `None`: by the place of the profile crowning.
    pub k_20: Option<f64>,
    /// K_K0, mm.
    pub k_k0: f64,
}

/// Which of the decompositions with the same flank is made (spec 25 section 4).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum PlanGauge {
    /// F_K and its slope vanish in the middle of the flank.
    #[default]
    Centred,
    /// These free coefficients on both flanks.
    Given(FreeCoefficients),
    /// The diagonal ratio and the constants at which one dresser swivels alike on both flanks.
    EqualSwivel,
}
