//! A characteristic of a series as the page names and prints it.

use crate::workflow::characteristic_in_words;
use crate::workflow::series::{SeriesCharacteristic, SeriesFinding};
use report::charts::format_fixed;

/// What it is.
pub(super) fn name(of: &SeriesCharacteristic) -> String {
    characteristic_in_words(&of.key)
}

fn is_length(of: &SeriesCharacteristic) -> bool {
    of.unit == "um"
}

/// Its unit as it is printed; empty for none.
pub(super) fn unit(of: &SeriesCharacteristic) -> &'static str {
    if is_length(of) { "µm" } else { "" }
}

/// Decimals of its values.
pub(super) fn decimals(of: &SeriesCharacteristic) -> usize {
    if is_length(of) { 2 } else { 4 }
}

/// A value as it is printed.
pub(super) fn fixed(of: &SeriesCharacteristic, value: f64) -> String {
    format_fixed(value, decimals(of))
}

/// Lower and upper limit.
pub(super) fn limits(of: &SeriesCharacteristic) -> [Option<f64>; 2] {
    [of.lower_limit, of.upper_limit]
}

/// A rule for special causes in a few letters.
pub(super) fn mark(of: &SeriesFinding) -> &'static str {
    match of.rule {
        "beyond-three-sigma" => "3σ",
        "two-of-three-beyond-two-sigma" => "2 of 3",
        "one-side" => "run of 9",
        _ => "steady 6",
    }
}
