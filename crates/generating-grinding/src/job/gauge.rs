//! `[grinding] gauge`: which of the many equal decompositions of a target is made.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The coefficients of the decomposition that the target leaves free.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Gauge {
    /// A word.
    Rule(GaugeRule),
    /// These coefficients.
    Given(GivenGauge),
}

impl Default for Gauge {
    fn default() -> Self {
        Self::Rule(GaugeRule::default())
    }
}

impl Gauge {
    /// Whether nothing else than the default is asked for.
    pub fn is_default(&self) -> bool {
        *self == Self::default()
    }
}

/// How the free coefficients are chosen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum GaugeRule {
    /// The grinding motion corrects nothing in the middle of the flank: least travel of the axes.
    #[default]
    Centred,
    /// The dresser swivels by the same angle on both flanks.
    EqualSwivel,
}

/// Free coefficients of the decomposition, of powers of mm, transverse, positive = material left.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GivenGauge {
    /// K_10, mm/mm: constant of the worm function that is linear in w.
    #[serde(default)]
    #[schemars(extend("minimum" = -1, "maximum" = 1, "x-way-out" = "give K_10 in mm/mm (0.001 = 1 um per mm)"))]
    pub k_10: f64,
    /// K_20, mm/mm^2: constant of the worm function that is square in w.
    #[serde(default)]
    #[schemars(extend("minimum" = -1, "maximum" = 1, "x-way-out" = "give K_20 in mm/mm^2"))]
    pub k_20: f64,
    /// K_K0, mm: constant of the grinding motion.
    #[serde(default)]
    #[schemars(extend("minimum" = -10, "maximum" = 10, "x-way-out" = "give K_K0 in mm"))]
    pub k_k0: f64,
}
