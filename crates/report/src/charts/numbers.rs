//! Numbers as text: true minus sign, sensible digits, powers of ten where decimals would be unreadable.

/// Fixed decimals with a true minus sign; a rounded zero has no sign, a value that is not finite prints as a dash.
pub fn format_fixed(value: f64, decimals: usize) -> String {
    if !value.is_finite() {
        return "–".to_owned();
    }
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        None => text,
        Some(digits) if digits.chars().all(|c| c == '0' || c == '.') => digits.to_owned(),
        Some(digits) => format!("−{digits}"),
    }
}

/// At most `digits` significant digits, trailing zeros removed; beyond 1e-4 .. 1e7 as a power of ten.
///
/// ```
/// use report::charts::format_significant;
/// assert_eq!(format_significant(-1.916051, 4), "−1.916");
/// assert_eq!(format_significant(2.4e-11, 2), "2.4·10⁻¹¹");
/// ```
pub fn format_significant(value: f64, digits: usize) -> String {
    if !value.is_finite() {
        return "–".to_owned();
    }
    if value == 0.0 {
        return "0".to_owned();
    }
    let exponent = decimal_exponent(value);
    if (-4..7).contains(&exponent) {
        let decimals = (digits as i32 - 1 - exponent).max(0) as usize;
        return trim_zeros(format_fixed(value, decimals));
    }
    let mantissa = trim_zeros(format_fixed(value / 10f64.powi(exponent), digits.saturating_sub(1)));
    format!("{mantissa}·{}", power_of_ten(exponent))
}

/// "10⁻³" for -3.
pub fn power_of_ten(exponent: i32) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let mut text = String::from("10");
    if exponent < 0 {
        text.push('⁻');
    }
    text.extend(exponent.unsigned_abs().to_string().bytes().map(|b| DIGITS[usize::from(b - b'0')]));
    text
}

/// Floor of the decimal logarithm of a value other than 0.
pub fn decimal_exponent(value: f64) -> i32 {
    // The relative margin keeps 0.001 = 10^-3 from falling to -4 by rounding.
    (value.abs().log10() + 1e-12).floor() as i32
}

fn trim_zeros(text: String) -> String {
    if !text.contains('.') {
        return text;
    }
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}
