//! What a plan may choose from: who carries the profile, what counts as standing on the tool's lines, which of the equal
//! decompositions is made. Plain data.

use super::ProfilePlace;
use super::least_squares::FitNorm;
use dressing::{RowAlong, RowSet};
use foundation::geometry::Sides;

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
    /// What the dressing motion has to meet.
    pub dressing: DressingRows,
    /// Free coefficients of the decomposition per flank; `None`: gauge `centred`.
    pub gauge: Sides<Option<FreeCoefficients>>,
    /// How fine the dressing motion is resolved.
    pub series: SeriesRule,
}

/// How fine DK(v) is resolved by Chebyshev series.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SeriesRule {
    /// Nodes to begin with; they are doubled while the series is not settled.
    pub nodes: usize,
    /// Share of the modification, mm, that the last quarter of a settled series may hold.
    pub tolerance: f64,
}

impl Default for SeriesRule {
    fn default() -> Self {
        Self { nodes: 17, tolerance: 2e-7 }
    }
}

/// What the dressing motion has to meet at every position of the worm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DressingRows {
    /// Each flank with a motion of its own; rows that name no flank stand on it.
    Alone(RowSet),
    /// Both flanks with one motion; the rows name their flanks.
    BothFlanks(RowSet),
}

impl Default for DressingRows {
    fn default() -> Self {
        Self::Alone(RowSet::exact(RowAlong::three_points_with_map()))
    }
}

impl DressingRows {
    /// The rows with their weights.
    pub fn set(&self) -> &RowSet {
        match self {
            Self::Alone(rows) | Self::BothFlanks(rows) => rows,
        }
    }

    /// The rows.
    pub fn rows(&self) -> &[RowAlong] {
        self.set().rows()
    }

    /// Whether one motion serves both flanks.
    pub fn of_both_flanks(&self) -> bool {
        matches!(self, Self::BothFlanks(_))
    }
}

/// The free coefficients of a decomposition, in centred variables, transverse
/// (`docs/mathematics/generating-contact.md#decomposition-of-a-target`).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FreeCoefficients {
    /// K_10, mm/mm.
    pub k_10: f64,
    /// Share of u^2 in the profile, mm/mm^2; `None`: by the place of the profile crowning.
    pub k_20: Option<f64>,
    /// K_K0, mm.
    pub k_k0: f64,
}

/// Which of the decompositions with the same flank is made (`docs/mathematics/generating-contact.md#decomposition-of-a-target`).
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
