//! Evaluation of measured gears to ISO 1328-1:2013 (`docs/mathematics/inspection.md`): traces, K-bands, twist, pitch, run-out,
//! thickness, eccentricity, tolerances and classes, series of parts. Knows neither files nor processes.
//!
//! Lengths and deviations are mm, angles rad. A deviation is positive where material stands, on both flanks; what a sheet prints with
//! another sign carries that sign with it ([`Slope`]).

mod bevel_pitch;
mod bevel_tolerances;
mod classes;
mod eccentricity;
mod error;
mod harmonic;
mod k_band;
mod line;
mod pitch;
mod probe_positions;
mod range;
mod rounding;
mod run_out;
mod samples;
mod section;
mod series;
mod signs;
mod teeth;
mod thickness;
mod tolerances;
mod trace_evaluation;
mod twist;
mod warning;

pub use bevel_pitch::{PitchPoint, bevel_pitch, bevel_run_out};
pub use bevel_tolerances::{BEVEL_CLASSES, BevelQuantity, BevelToleranceGear, BevelTolerances};
pub use classes::{ReachedClasses, reached_class, reached_classes};
pub use eccentricity::{Eccentricity, FlankAngles, eccentricity};
pub use error::InspectionError;
pub use harmonic::Harmonic;
pub use k_band::{BandFit, BandVerdict, KBand};
pub use line::Line;
pub use pitch::{PitchDeviations, PitchEvaluation, default_sector, thickness_variation};
pub use probe_positions::{ProbePosition, pitch_from_positions};
pub use range::{EvaluationRange, roll_at_diameter};
pub use rounding::round_to;
pub use run_out::{BallContact, RunOut, run_out_from_pitch};
pub use samples::TraceSamples;
pub use section::MeasuredSection;
pub use series::{
    Capability, CharacteristicSeries, ControlLimits, RuleFinding, RunRule, SeriesEvaluation, SeriesPart,
    SeriesValue, SpecificationLimits, Trend, evaluate_parts, evaluate_series, ordered,
};
pub use signs::{Sign, Slope, SlopeReference, SlopeRule, SlopeSign};
pub use teeth::TeethSummary;
pub use thickness::{MeasuredThickness, ThicknessSizes, measured_thickness};
pub use tolerances::{CLASSES, ToleranceGear, ToleranceQuantity, Tolerances};
pub use trace_evaluation::{Relief, TraceCrowning, TraceEvaluation, evaluate_trace};
pub use twist::{PlacedSlope, TraceTwist, trace_twist, twist_by_leads, twist_by_profiles};
pub use warning::InspectionWarning;
