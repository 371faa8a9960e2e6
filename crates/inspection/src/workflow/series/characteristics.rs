//! Which characteristics of a part a series is evaluated from: each of its flanks and of the gear once.

use super::super::characteristics::{PartCharacteristic, SINGLE, characteristic_key};
use metrology::inspection::{SeriesValue, SpecificationLimits};

/// The characteristics that a series follows: of lines means of slopes, crownings and reliefs, ranges of slopes, the largest total and form
/// deviations; pitch, run-out and thickness as they stand. Single teeth and the class are left out.
pub fn series_values(part: &[PartCharacteristic]) -> Vec<SeriesValue> {
    let followed = part.iter().filter(|of| of.tooth.is_none() && is_followed(&of.name, &of.statistic));
    followed.map(series_value).collect()
}

/// Whether a characteristic of a gear or flank belongs to a series.
pub fn is_followed(name: &str, statistic: &str) -> bool {
    let largest = name.starts_with("Fa") || name.starts_with("Fb") || name.starts_with("ff");
    match statistic {
        "mean" => !largest,
        "range" => name.starts_with("fH"),
        "max" => true,
        SINGLE => name != "class",
        _ => false,
    }
}

fn series_value(of: &PartCharacteristic) -> SeriesValue {
    SeriesValue {
        key: characteristic_key(&of.name, of.flank, None, &of.statistic),
        unit: of.unit.into(),
        value: of.value,
        limits: SpecificationLimits::new(of.lower_limit, of.upper_limit).unwrap_or_default(),
    }
}
