//! Names of design variables: a channel and an exponent, such as `dX2`. Knows how they are written, not which values they
//! have.

use std::fmt;
use std::str::FromStr;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Serialize};

use super::channel::Channel;
use job::shape::nearest;

/// A design variable: the coefficient of a power in a channel, or the shift ratio `kap`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub struct Variable {
    channel: Channel,
    exponent: u8,
}

impl Variable {
    /// The variable of a power of a channel; `None` for an exponent that the channel does not have. The shift ratio has the
    /// exponent 0 here and none in its name.
    pub fn new(channel: Channel, exponent: u8) -> Option<Self> {
        channel.exponents().unwrap_or(0..=0).contains(&exponent).then_some(Self { channel, exponent })
    }

    /// The function that it belongs to.
    pub fn channel(self) -> Channel {
        self.channel
    }

    /// The power that it is the coefficient of; 0 for the shift ratio.
    pub fn exponent(self) -> u8 {
        self.exponent
    }

    /// The nine variables of the source, v1 to v9.
    pub const SOURCE: [Self; 9] = {
        use Channel as C;
        [
            Self { channel: C::Profile, exponent: 1 },
            Self { channel: C::Profile, exponent: 2 },
            Self { channel: C::Profile, exponent: 3 },
            Self { channel: C::TangentialShift, exponent: 2 },
            Self { channel: C::TangentialShift, exponent: 3 },
            Self { channel: C::GrindingAngle, exponent: 0 },
            Self { channel: C::GrindingDistance, exponent: 0 },
            Self { channel: C::WorkRotation, exponent: 2 },
            Self { channel: C::WorkRotation, exponent: 3 },
        ]
    };

    /// All variables that there are.
    pub fn all() -> impl Iterator<Item = Self> {
        Channel::ALL.into_iter().flat_map(|channel| {
            let exponents = channel.exponents().unwrap_or(0..=0);
            exponents.map(move |exponent| Self { channel, exponent })
        })
    }
}

impl fmt::Display for Variable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.channel.name())?;
        if self.channel.exponents().is_some() {
            write!(f, "{}", self.exponent)?;
        }
        Ok(())
    }
}

/// Why a text names no variable.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum VariableError {
    /// A constant part of the dresser's profile.
    ConstantProfile,
    /// No channel with such an exponent; the variable with the nearest name, if any is near.
    Unknown(Option<Variable>),
}

impl fmt::Display for VariableError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::ConstantProfile => "the profile has no constant part: the thickness of the tooth is dist0",
            Self::Unknown(_) => "there is no variable of this name",
        })
    }
}

impl std::error::Error for VariableError {}

impl FromStr for Variable {
    type Err = VariableError;

    fn from_str(name: &str) -> Result<Self, VariableError> {
        for channel in Channel::ALL {
            let Some(exponent) = name.strip_prefix(channel.name()) else { continue };
            match (exponent.as_bytes(), channel.exponents()) {
                ([], None) => return Ok(Self { channel, exponent: 0 }),
                ([digit @ b'0'..=b'9'], Some(range)) if range.contains(&(digit - b'0')) => {
                    return Ok(Self { channel, exponent: digit - b'0' });
                }
                (b"0", Some(_)) => return Err(VariableError::ConstantProfile),
                _ => {}
            }
        }
        let known: Vec<(String, Self)> =
            Self::all().map(|variable| (variable.to_string(), variable)).collect();
        let near = nearest(name, known.iter().map(|(name, _)| name.as_str()));
        let near = near.and_then(|near| known.iter().find(|(name, _)| name == near));
        Err(VariableError::Unknown(near.map(|(_, variable)| *variable)))
    }
}

impl TryFrom<String> for Variable {
    type Error = VariableError;

    fn try_from(name: String) -> Result<Self, VariableError> {
        name.parse()
    }
}

impl From<Variable> for String {
    fn from(variable: Variable) -> Self {
        variable.to_string()
    }
}

impl JsonSchema for Variable {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Variable".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "description": "A design variable: a channel with an exponent, such as dX2, or kap.",
            "type": "string",
            "pattern": pattern(|_| true)
        })
    }
}

/// A regular expression for the names of the variables of some channels.
pub(super) fn pattern(which: impl Fn(Channel) -> bool) -> String {
    let names: Vec<String> = Channel::ALL
        .into_iter()
        .filter(|channel| which(*channel))
        .map(|channel| match channel.exponents() {
            Some(range) => format!("{}[{}-{}]", channel.name(), range.start(), range.end()),
            None => channel.name().to_owned(),
        })
        .collect();
    format!("^({})$", names.join("|"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_read_back() {
        let mut count = 0;
        for variable in Variable::all() {
            assert_eq!(variable.to_string().parse(), Ok(variable));
            assert_eq!(Variable::new(variable.channel(), variable.exponent()), Some(variable));
            count += 1;
        }
        assert_eq!(count, 3 * 9 + 8 * 10 + 1);
        assert!(Variable::SOURCE.iter().all(|v| Variable::new(v.channel(), v.exponent()).is_some()));
    }

    #[test]
    fn what_is_no_name_is_told_with_the_nearest() {
        let near = |name: &str| match name.parse::<Variable>() {
            Err(VariableError::Unknown(near)) => near.map(|v| v.to_string()),
            other => panic!("{name}: {other:?}"),
        };
        assert_eq!(near("dx2").as_deref(), Some("dX2"));
        assert_eq!(near("Fp10").as_deref(), Some("Fp1"));
        assert_eq!(near("kappa").as_deref(), Some("kap"));
        assert_eq!(near("kap0").as_deref(), Some("kap"));
        assert_eq!(near("crowning"), None);
        for name in ["Fp0", "FpL0", "FpR0"] {
            assert_eq!(name.parse::<Variable>(), Err(VariableError::ConstantProfile));
        }
        assert_eq!(Variable::new(Channel::Profile, 0), None);
        assert_eq!(Variable::new(Channel::ShiftRatio, 1), None);
    }

    #[test]
    fn the_pattern_spells_every_channel() {
        let pattern = pattern(|channel| channel != Channel::ProfileLeft);
        assert!(pattern.starts_with("^(Fp[1-9]|FpR[1-9]|Fz[0-9]|"), "{pattern}");
        assert!(pattern.ends_with("|FT[0-9]|kap)$"), "{pattern}");
    }
}
