//! Numbers as these files write them: `.203`, `-.386`, `0.000`, `1e-3`. A decimal comma makes no number.

/// `[+-]?(digits[.digits] | .digits)[e[+-]digits]`, within the range of a double.
pub(super) fn number(text: &str) -> Option<f64> {
    let bytes = text.as_bytes();
    let mut at = usize::from(matches!(bytes.first(), Some(b'+' | b'-')));
    let digits = |from: usize| bytes[from..].iter().take_while(|b| b.is_ascii_digit()).count();
    let whole = digits(at);
    at += whole;
    if bytes.get(at) == Some(&b'.') {
        let behind = digits(at + 1);
        if behind == 0 {
            return None;
        }
        at += 1 + behind;
    } else if whole == 0 {
        return None;
    }
    if matches!(bytes.get(at), Some(b'e' | b'E')) {
        at += 1 + usize::from(matches!(bytes.get(at + 1), Some(b'+' | b'-')));
        let exponent = if at <= bytes.len() { digits(at) } else { 0 };
        if exponent == 0 {
            return None;
        }
        at += exponent;
    }
    if at != bytes.len() {
        return None;
    }
    text.parse().ok().filter(|v: &f64| v.is_finite())
}

/// The numbers at the beginning of a text, separated by blanks or colons; other words end them.
pub(super) fn leading_numbers(text: &str) -> Vec<f64> {
    let words = text.split(|c: char| c.is_whitespace() || c == ':').filter(|word| !word.is_empty());
    words.map_while(number).collect()
}

/// All numbers of a line that holds nothing else; `None` for any other line and for an empty one.
pub(super) fn only_numbers(line: &str) -> Option<Vec<f64>> {
    let numbers: Option<Vec<f64>> = line.split_whitespace().map(number).collect();
    numbers.filter(|list| !list.is_empty())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_decimals_are_numbers_and_commas_are_not() {
        for (text, value) in [
            (".203", 0.203),
            ("-.386", -0.386),
            ("0.000", 0.0),
            ("+12", 12.0),
            ("1.5e-3", 0.0015),
            ("2E3", 2000.0),
            ("-2147483.648", -2147483.648),
        ] {
            assert_eq!(number(text), Some(value), "{text}");
        }
        for text in
            ["", "-", ".", "1.", "1,5", "nan", "inf", "1e", "1e+", "0x1", "1.2.3", "1 2", "--1", "1e999"]
        {
            assert_eq!(number(text), None, "{text}");
        }
    }

    #[test]
    fn what_stands_behind_numbers_is_left() {
        assert_eq!(leading_numbers("  1.75::L- :R-"), [1.75]);
        assert_eq!(leading_numbers(" 50.1   50.2  "), [50.1, 50.2]);
        assert_eq!(leading_numbers(" 27   Außenverzahnung"), [27.0]);
        assert!(leading_numbers("Rr 5").is_empty());
        assert_eq!(only_numbers(" 1 .5"), Some(vec![1.0, 0.5]));
        assert_eq!(only_numbers("1 x"), None);
        assert_eq!(only_numbers("  "), None);
    }
}
