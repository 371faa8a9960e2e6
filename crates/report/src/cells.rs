//! Cells of tables that refuse what is no number.

use crate::charts::{ChartError, check_values, format_fixed, format_significant};
use foundation::geometry::Flank;

/// What stands where there is no number.
pub const NONE: &str = "–";

/// A number with fixed decimals; the error names `what`.
pub fn fixed(what: &str, value: f64, decimals: usize) -> Result<String, ChartError> {
    check_values(what, &[value])?;
    Ok(format_fixed(value, decimals))
}

/// A number with significant digits.
pub fn significant(what: &str, value: f64, digits: usize) -> Result<String, ChartError> {
    check_values(what, &[value])?;
    Ok(format_significant(value, digits))
}

/// As [`fixed`], a dash where there is no number.
pub fn fixed_or_none(what: &str, value: Option<f64>, decimals: usize) -> Result<String, ChartError> {
    value.map_or_else(|| Ok(NONE.to_owned()), |value| fixed(what, value, decimals))
}

/// As [`significant`], a dash where there is no number.
pub fn significant_or_none(what: &str, value: Option<f64>, digits: usize) -> Result<String, ChartError> {
    value.map_or_else(|| Ok(NONE.to_owned()), |value| significant(what, value, digits))
}

/// A word that stands out in black and white.
pub fn yes_no(yes: bool) -> String {
    if yes { "YES" } else { "no" }.to_owned()
}

/// "Left flank", "Right flank".
pub fn flank_title(flank: Flank) -> &'static str {
    match flank {
        Flank::Left => "Left flank",
        Flank::Right => "Right flank",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cell_is_a_number_or_an_error_with_its_name() {
        assert_eq!(fixed("x", -1.25, 1).unwrap(), "−1.2");
        assert_eq!(fixed_or_none("x", None, 1).unwrap(), NONE);
        let error = significant("lever of track 2", f64::INFINITY, 3).unwrap_err();
        assert!(error.to_string().contains("lever of track 2"), "{error}");
    }
}
