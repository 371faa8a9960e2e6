//! The twist of a flank from slopes of profiles at two heights and of leads at two lengths of roll
//! (`docs/mathematics/inspection.md#one-trace`).

use super::{InspectionError, Slope};

/// Traces nearer than this lie at one place, mm.
const SAME_PLACE: f64 = 1e-6;

/// The slope of a trace and where the trace lies (z of a profile, w of a lead), mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlacedSlope {
    /// Position, mm.
    pub position: f64,
    /// Slope.
    pub slope: Slope,
}

/// Twist S of one flank, mm, by both kinds of traces; asked by `verify` alone, commands take each kind where it was measured. A bilinear twist gives the same number twice.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TraceTwist {
    /// S_alpha: by the profiles.
    pub by_profiles: f64,
    /// S_beta: by the leads.
    pub by_leads: f64,
}

impl TraceTwist {
    /// S_alpha - S_beta, mm: what is no bilinear twist.
    pub fn difference(&self) -> f64 {
        self.by_profiles - self.by_leads
    }
}

/// Twist by two profiles of one flank over a field of `profile_length` (L_a) and `helix_length` (L_b), mm.
///
/// # Errors
/// [`InspectionError::DuplicateTrace`].
pub fn twist_by_profiles(
    profiles: [PlacedSlope; 2],
    [profile_length, helix_length]: [f64; 2],
) -> Result<f64, InspectionError> {
    by_pair(profiles, profile_length, helix_length)
}

/// Twist by two leads of one flank over a field of `profile_length` (L_a) and `helix_length` (L_b), mm.
///
/// # Errors
/// [`InspectionError::DuplicateTrace`].
pub fn twist_by_leads(
    leads: [PlacedSlope; 2],
    [profile_length, helix_length]: [f64; 2],
) -> Result<f64, InspectionError> {
    by_pair(leads, helix_length, profile_length)
}

/// Twist by two profiles and two leads of one flank.
///
/// # Errors
/// [`InspectionError::DuplicateTrace`].
pub fn trace_twist(
    profiles: [PlacedSlope; 2],
    leads: [PlacedSlope; 2],
    field: [f64; 2],
) -> Result<TraceTwist, InspectionError> {
    Ok(TraceTwist {
        by_profiles: twist_by_profiles(profiles, field)?,
        by_leads: twist_by_leads(leads, field)?,
    })
}

/// S = -(change of the slope over its own length) per position, times the length across.
fn by_pair([a, b]: [PlacedSlope; 2], along: f64, across: f64) -> Result<f64, InspectionError> {
    let apart = b.position - a.position;
    if apart.abs() <= SAME_PLACE {
        return Err(InspectionError::DuplicateTrace { position: a.position });
    }
    Ok(-(b.slope.over(along) - a.slope.over(along)) * across / apart)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::inspection::{SlopeReference, SlopeRule, SlopeSign};
    use foundation::geometry::Flank;

    /// A slope counted over any length and with any sign has the same gradient.
    fn at(position: f64, gradient: f64) -> PlacedSlope {
        let rule = SlopeRule {
            flank: Flank::Right,
            sign: SlopeSign::Din,
            reference: SlopeReference::FaceWidth(33.0),
        };
        PlacedSlope { position, slope: rule.slope(gradient, 1.0) }
    }

    #[test]
    fn a_bilinear_twist_is_found_by_both_kinds_of_traces() {
        // f = -S u v/4 on a field of 6 mm of roll and 20 mm of face.
        let (s, field) = (0.012, [6.0, 20.0]);
        let profile = |z: f64| at(z, -s / 4.0 * (2.0 / 6.0) * (2.0 * z / 20.0));
        let lead = |w: f64| at(w, -s / 4.0 * (2.0 / 20.0) * (2.0 * (w - 10.0) / 6.0));
        let twist = trace_twist([profile(-7.0), profile(8.0)], [lead(12.0), lead(8.5)], field).unwrap();
        assert!((twist.by_profiles - s).abs() < 1e-15 && (twist.by_leads - s).abs() < 1e-15);
        assert!(twist.difference().abs() < 1e-15);
    }

    #[test]
    fn traces_at_one_place_are_refused() {
        let error = twist_by_profiles([at(3.0, 0.1), at(3.0 + 1e-7, 0.2)], [6.0, 20.0]).unwrap_err();
        assert_eq!(error.code(), "duplicate-trace");
    }
}
