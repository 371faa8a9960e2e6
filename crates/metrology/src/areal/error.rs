//! What keeps a flank from being evaluated as a surface (`docs/mathematics/inspection.md`).

use finding::Finding;
use thiserror::Error;

/// Errors of areal evaluation. Lengths mm.
#[derive(Clone, Debug, PartialEq, Error, Finding)]
pub enum ArealError {
    /// A field or range that ends where or before it begins, or is not finite.
    #[error("the {name} from {from} to {to} mm is empty")]
    #[finding(code = "empty-range")]
    #[way_out("give an end above the beginning")]
    EmptyRange {
        /// Which range.
        name: &'static str,
        /// Its beginning.
        from: f64,
        /// Its end.
        to: f64,
    },
    /// Fewer points with a value than terms.
    #[error("{points} points with a value do not determine {terms} terms")]
    #[finding(code = "too-few-points")]
    #[way_out("measure more points or ask for a lower degree")]
    TooFewPoints {
        /// Points with a value.
        points: usize,
        /// Terms asked for.
        terms: usize,
    },
    /// The points do not tell the terms apart, as on one line.
    #[error("the points do not tell the terms apart (smallest share of the triangle {share:.1e})")]
    #[finding(code = "degenerate-field")]
    #[way_out("measure at more different lengths of roll and axial positions")]
    DegenerateField {
        /// Smallest diagonal element of the triangle over the largest.
        share: f64,
    },
    /// Lists of different lengths.
    #[error("{name}: {found} values, but {wanted} are needed")]
    #[finding(code = "other-shape")]
    #[way_out("give one value for each place")]
    OtherShape {
        /// What is counted.
        name: &'static str,
        /// How many there are.
        found: usize,
        /// How many are needed.
        wanted: usize,
    },
    /// A number that is not usable.
    #[error("{name} = {value} is not usable; allowed: {allowed}")]
    #[finding(code = "invalid-number")]
    #[way_out("give a value in the allowed range")]
    InvalidNumber {
        /// Name of the quantity.
        name: &'static str,
        /// Its value.
        value: f64,
        /// Allowed range in words.
        allowed: &'static str,
    },
    /// A surface needs traces in both directions.
    #[error("a surface needs profiles and leads; there are {profiles} profiles and {leads} leads")]
    #[finding(code = "too-few-traces")]
    #[way_out("measure at least one profile and one lead of the same flank")]
    TooFewTraces {
        /// Number of profiles.
        profiles: usize,
        /// Number of leads.
        leads: usize,
    },
    /// Two traces of one direction at the same place.
    #[error("two {direction} stand at {first} and {second} mm, which is the same place")]
    #[finding(code = "duplicate-trace")]
    #[way_out("leave one of the two traces out")]
    DuplicateTrace {
        /// "profiles" or "leads".
        direction: &'static str,
        /// Place of the first.
        first: f64,
        /// Place of the second.
        second: f64,
    },
    /// A trace that does not reach a trace across it.
    #[error(
        "the {direction} at {position} mm reaches from {from} to {to} mm and does not cross {crossing} mm"
    )]
    #[finding(code = "traces-do-not-cross")]
    #[way_out("measure traces that cross each other, or leave the short one out")]
    TracesDoNotCross {
        /// "profile" or "lead".
        direction: &'static str,
        /// Place of the trace.
        position: f64,
        /// Where it begins.
        from: f64,
        /// Where it ends.
        to: f64,
        /// Place of the trace across it.
        crossing: f64,
    },
}
