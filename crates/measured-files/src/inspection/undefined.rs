//! Lists in which a value may be undefined: NaN in memory, `null` in a file.

use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// Writes NaN as `null`.
pub(super) fn serialize<S: Serializer>(values: &[f64], serializer: S) -> Result<S::Ok, S::Error> {
    let list: Vec<Option<f64>> = values.iter().map(|v| Some(*v).filter(|v| v.is_finite())).collect();
    list.serialize(serializer)
}

/// Reads `null` as NaN.
pub(super) fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<f64>, D::Error> {
    let list = Vec::<Option<f64>>::deserialize(deserializer)?;
    Ok(list.into_iter().map(|v| v.unwrap_or(f64::NAN)).collect())
}

/// The same for one value.
pub(super) mod number {
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    /// Writes NaN as `null`.
    pub fn serialize<S: Serializer>(value: &f64, serializer: S) -> Result<S::Ok, S::Error> {
        Some(*value).filter(|v| v.is_finite()).serialize(serializer)
    }

    /// Reads `null` as NaN.
    pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<f64, D::Error> {
        Ok(Option::<f64>::deserialize(deserializer)?.unwrap_or(f64::NAN))
    }
}
