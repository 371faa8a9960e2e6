//! The decimal comma: numbers of a text, and nothing that only looks like one (versions, names of files).

/// The text with a comma in place of the point of each decimal number.
pub(super) fn with_commas(text: &str) -> String {
    let chars: Vec<char> = text.chars().collect();
    let is_digit = |k: usize| chars.get(k).is_some_and(char::is_ascii_digit);
    let mut out = String::with_capacity(text.len());
    let mut k = 0;
    while k < chars.len() {
        let begins = is_digit(k) && (k == 0 || may_precede(&chars[..k]));
        if !begins {
            out.push(chars[k]);
            k += 1;
            continue;
        }
        let end = (k..).find(|&at| !is_digit(at)).unwrap_or(chars.len());
        let mut to = end;
        if chars.get(end) == Some(&'.') && is_digit(end + 1) {
            let last = (end + 1..).find(|&at| !is_digit(at)).unwrap_or(chars.len());
            if may_follow(&chars[last..]) {
                out.extend(&chars[k..end]);
                out.push(',');
                out.extend(&chars[end + 1..last]);
                k = last;
                continue;
            }
            // A version, a place in a file: all of it stays.
            to = (last..)
                .find(|&at| !chars.get(at).is_some_and(|c| c.is_alphanumeric() || *c == '.'))
                .unwrap_or(chars.len());
        }
        out.extend(&chars[k..to]);
        k = to;
    }
    out
}

/// Whether a number may begin behind this text.
fn may_precede(before: &[char]) -> bool {
    match before {
        [.., a, '-'] => a.is_whitespace() || *a == '(',
        ['-'] => true,
        [.., c] => !(c.is_alphanumeric() || matches!(c, '.' | '_' | ':' | '\\')),
        [] => true,
    }
}

/// Whether a number may end before this text.
fn may_follow(after: &[char]) -> bool {
    match after {
        ['.', c, ..] => !c.is_alphanumeric(),
        [c, ..] => !(c.is_alphabetic() || *c == '_'),
        [] => true,
    }
}

#[cfg(test)]
mod tests {
    use super::with_commas;

    #[test]
    fn numbers_get_a_comma() {
        for (text, wanted) in [
            ("2.5", "2,5"),
            ("−0.25 µm", "−0,25 µm"),
            ("-3.5 to 4.25.", "-3,5 to 4,25."),
            ("(1.25·10⁻³)", "(1,25·10⁻³)"),
            ("18.16°, 0.5 mm/s", "18,16°, 0,5 mm/s"),
            ("12.3 %", "12,3 %"),
            ("±0.5/1.5", "±0,5/1,5"),
        ] {
            assert_eq!(with_commas(text), wanted);
        }
    }

    #[test]
    fn what_is_no_number_stays() {
        for text in [
            "0.1.0",
            "v1.2",
            "worm-1.5.csv",
            "X1.5",
            "1.5b",
            "2026-03-31",
            "ISO 1328-1:2013",
            "a.5",
            "7.",
            "x_1.5",
        ] {
            assert_eq!(with_commas(text), text);
        }
    }
}
