//! Numbers that files write as texts, where other readers would round them.

use serde::de::{Deserialize, Deserializer, Error};
use serde_json::Value;

/// A whole number of 64 bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Whole(pub i64);

impl Whole {
    /// From a number or a text of digits.
    pub fn of(value: &Value) -> Option<Self> {
        value.as_i64().or_else(|| value.as_str()?.parse().ok()).map(Self)
    }
}

/// A number with digits after the point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Decimal(pub f64);

impl Decimal {
    /// From a number or a text of digits; of those beyond the 16th or 17th nothing is left.
    pub fn of(value: &Value) -> Option<Self> {
        value.as_f64().or_else(|| value.as_str()?.parse().ok()).filter(|x: &f64| x.is_finite()).map(Self)
    }
}

impl<'de> Deserialize<'de> for Whole {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let value = Value::deserialize(deserializer)?;
        Self::of(&value).ok_or_else(|| D::Error::custom(format!("{value} is no whole number of 64 bits")))
    }
}

impl<'de> Deserialize<'de> for Decimal {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let value = Value::deserialize(deserializer)?;
        Self::of(&value).ok_or_else(|| D::Error::custom(format!("{value} is no number")))
    }
}
