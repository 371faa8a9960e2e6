//! Channels of tangential dressing: the functions of dresser, dressing and grinding that carry the design variables. Knows
//! their names and powers, not what they do to a flank.

use std::ops::RangeInclusive;

use schemars::{Schema, json_schema};
use serde::{Deserialize, Serialize};

/// A function whose coefficients are design variables. u = s/m_n over the dresser's profile, zeta = 2 x_D/b_w over the
/// dresser's position on the worm, eta = 2 z/b_g over the feed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub enum Channel {
    /// Profile of the dresser on both sides, over u, mm.
    #[serde(rename = "Fp")]
    Profile,
    /// Profile of the side that dresses the left flank, over u, mm.
    #[serde(rename = "FpL")]
    ProfileLeft,
    /// Profile of the side that dresses the right flank, over u, mm.
    #[serde(rename = "FpR")]
    ProfileRight,
    /// Shift of the dresser along its tangent, over zeta, mm.
    #[serde(rename = "Fz")]
    TangentialShift,
    /// Axial offset of the dresser, which is a turn of the worm, over zeta, mm.
    #[serde(rename = "dX")]
    AxialOffset,
    /// Centre distance of dressing, over zeta, mm.
    #[serde(rename = "dA")]
    DressingDistance,
    /// Crossing angle of dressing, over zeta, rad.
    #[serde(rename = "gA")]
    DressingAngle,
    /// Crossing angle of grinding, over eta, mm (gamma = gamma_0 + c/(2 pi m_n)).
    #[serde(rename = "gam")]
    GrindingAngle,
    /// Centre distance of grinding, over eta, mm (d = d_0 + c/tan alpha_n).
    #[serde(rename = "dist")]
    GrindingDistance,
    /// Extra rotation of the workpiece, over eta, mm on its pitch circle.
    #[serde(rename = "FC")]
    WorkRotation,
    /// Shift of the tool beside its ratio, over eta, mm.
    #[serde(rename = "FT")]
    ToolShift,
    /// Ratio of the tool shift to the feed; one number.
    #[serde(rename = "kap")]
    ShiftRatio,
}

impl Channel {
    /// All channels in the order of their variables.
    pub const ALL: [Channel; 12] = [
        Self::Profile,
        Self::ProfileLeft,
        Self::ProfileRight,
        Self::TangentialShift,
        Self::AxialOffset,
        Self::DressingDistance,
        Self::DressingAngle,
        Self::GrindingAngle,
        Self::GrindingDistance,
        Self::WorkRotation,
        Self::ToolShift,
        Self::ShiftRatio,
    ];

    /// The word in job files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Profile => "Fp",
            Self::ProfileLeft => "FpL",
            Self::ProfileRight => "FpR",
            Self::TangentialShift => "Fz",
            Self::AxialOffset => "dX",
            Self::DressingDistance => "dA",
            Self::DressingAngle => "gA",
            Self::GrindingAngle => "gam",
            Self::GrindingDistance => "dist",
            Self::WorkRotation => "FC",
            Self::ToolShift => "FT",
            Self::ShiftRatio => "kap",
        }
    }

    /// Exponents that its variables may have; `None` for a channel that is one number. A constant of the profile would be
    /// a thickness, for which there is the centre distance.
    pub fn exponents(self) -> Option<RangeInclusive<u8>> {
        match self {
            _ if self.is_profile() => Some(1..=9),
            Self::ShiftRatio => None,
            _ => Some(0..=9),
        }
    }

    /// Whether it belongs to the profile of the dresser.
    pub fn is_profile(self) -> bool {
        matches!(self, Self::Profile | Self::ProfileLeft | Self::ProfileRight)
    }

    /// What a machine has or lacks as a whole: the sides of the dresser go with its profile.
    pub fn whole(self) -> Self {
        if self.is_profile() { Self::Profile } else { self }
    }

    /// Whether it can also be a spline; a number cannot.
    pub fn takes_spline(self) -> bool {
        self.exponents().is_some()
    }
}

/// Channels that a machine may lack, each at most once; one has to be left.
pub(super) fn lacking_schema(_: &mut schemars::SchemaGenerator) -> Schema {
    let whole = names(|channel| channel.whole() == channel);
    json_schema!({
        "type": "array",
        "items": { "type": "string", "enum": whole },
        "uniqueItems": true,
        "maxItems": whole.len() - 1
    })
}

/// A channel that can be a spline.
pub(super) fn spline_schema(_: &mut schemars::SchemaGenerator) -> Schema {
    json_schema!({ "type": "string", "enum": names(Channel::takes_spline) })
}

fn names(which: impl Fn(Channel) -> bool) -> Vec<&'static str> {
    Channel::ALL.into_iter().filter(|channel| which(*channel)).map(Channel::name).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_the_words_of_job_files() {
        for channel in Channel::ALL {
            assert_eq!(serde_json::to_value(channel).unwrap(), channel.name());
        }
    }
}
