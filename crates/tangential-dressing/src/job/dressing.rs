//! `[dressing]` of tangential dressing: passes, the variables that meet the target, and how their values are found.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::channel::{Channel, lacking_schema};
use super::spline::SplineChoice;
use super::variable::Variable;

/// How the worm is dressed, and by which variables the target is met.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct TangentialDressing {
    /// Motions of each flank, or one motion for both.
    pub passes: Passes,
    /// Which variables the fit may use.
    pub variables: Variables,
    /// Splines beside the powers.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[schemars(length(max = 12))]
    pub splines: Vec<SplineChoice>,
    /// Channels that the machine lacks.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[schemars(schema_with = "lacking_schema")]
    pub exclude: Vec<Channel>,
    /// Largest number of variables that `variables = "auto"` takes.
    #[schemars(extend("minimum" = 1, "maximum" = 60, "x-way-out" = "16 variables are the default"))]
    pub most_variables: usize,
    /// How the values are found.
    pub method: FitMethod,
    /// Parts in which a conical target is stepped up.
    #[schemars(extend("minimum" = 1, "maximum" = 64, "x-way-out" = "8 steps are the default; 1 goes straight to the target"))]
    pub steps: usize,
    /// Along what deviations are measured.
    pub measure: DeviationMeasure,
    /// Weights of the points of the fit.
    pub weights: FitWeights,
    /// Points of the fit along the profile and along the face width each.
    #[schemars(extend("minimum" = 5, "maximum" = 41, "x-way-out" = "9 points are the default"))]
    pub fit_points: usize,
    /// Whether the methods of the fit are compared.
    pub compare_methods: bool,
    /// Whether the flank is compared with crowning by radial feed.
    pub compare_radial: bool,
}

impl Default for TangentialDressing {
    fn default() -> Self {
        Self {
            passes: Passes::default(),
            variables: Variables::default(),
            splines: Vec::new(),
            exclude: Vec::new(),
            most_variables: 16,
            method: FitMethod::default(),
            steps: 8,
            measure: DeviationMeasure::default(),
            weights: FitWeights::default(),
            fit_points: 9,
            compare_methods: false,
            compare_radial: true,
        }
    }
}

/// How many passes dress the worm.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Passes {
    /// Both flanks share the motions.
    One,
    /// Every flank gets its own motions in a pass of its own.
    #[default]
    Each,
}

/// Variables of the fit.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Variables {
    /// A word.
    Rule(VariableRule),
    /// These.
    List(#[schemars(extend("minItems" = 1, "maxItems" = 60, "uniqueItems" = true))] Vec<Variable>),
}

impl Variables {
    /// The variables by name; `None` if the plan chooses them.
    pub fn named(&self) -> Option<&[Variable]> {
        match self {
            Self::Rule(VariableRule::Auto) => None,
            Self::Rule(VariableRule::Source) => Some(&Variable::SOURCE),
            Self::List(list) => Some(list),
        }
    }
}

impl Default for Variables {
    fn default() -> Self {
        Self::Rule(VariableRule::default())
    }
}

/// How the variables are chosen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum VariableRule {
    /// The plan chooses few that meet the tolerance.
    #[default]
    Auto,
    /// The nine of the source.
    Source,
}

/// How the values of the variables are found.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum FitMethod {
    /// The plan chooses.
    #[default]
    Auto,
    /// Linear steps; small singular values are dropped.
    Svd,
    /// Linear steps; small singular values are damped.
    Damped,
    /// Gauss-Newton with exact derivatives and steps that are halved where the residual grows.
    GaussNewton,
}

/// Along what the deviation of a flank is measured.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum DeviationMeasure {
    /// The nominal normal.
    #[default]
    Ray,
    /// The circle in the transverse section, as the source has it.
    Arc,
}

/// Weights of the points of the fit, and how they stand.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum FitWeights {
    /// All alike.
    #[default]
    Uniform,
    /// 0.1 + xi^2 + eta^2 at equidistant radii, as the source has it with 5 points; all others stand graded in the length of roll.
    Source,
}
