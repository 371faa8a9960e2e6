//! Which dialect a text is written in, from the text alone.

use crate::Dialect;

/// How much of a text is looked at.
const BYTES: usize = 64 << 10;

/// The dialect of a text by what only that dialect has; none for a text without any word of a program. Plain blocks of X, Y and Z
/// are the same in all of them and count as LinuxCNC.
pub fn detect_dialect(text: &[u8]) -> Option<Dialect> {
    let text = &text[..text.len().min(BYTES)];
    let mut words = false;
    for line in text.split(|byte| *byte == b'\n').map(<[u8]>::trim_ascii) {
        let code = line.split(|byte| *byte == b';').next().unwrap_or_default().to_ascii_uppercase();
        let siemens = [
            "EGDEF(", "EGDEL(", "EGON(", "EGONSYN(", "CTABDEF(", "G710", "G500", "BSPLINE", "POLY", "PO[",
            "TRAORI", "TRAFOOF",
        ];
        let holds = |pattern: &str| code.windows(pattern.len()).any(|window| window == pattern.as_bytes());
        if code.starts_with(b"#") {
            return Some(Dialect::Fanuc);
        }
        if !code.starts_with(b"(") && (siemens.iter().any(|pattern| holds(pattern)) || code.contains(&b'=')) {
            return Some(Dialect::Siemens);
        }
        let number = code.strip_prefix(b"O").unwrap_or_default();
        let tip_control = !code.starts_with(b"(") && ["G43.4", "G43.5"].iter().any(|pattern| holds(pattern));
        if number.first().is_some_and(u8::is_ascii_digit) || tip_control {
            return Some(Dialect::Fanuc);
        }
        let starts_word =
            |pair: &[u8]| pair[0].is_ascii_uppercase() && (pair[1].is_ascii_digit() || pair[1] == b'-');
        words |= !code.starts_with(b"(") && code.windows(2).any(starts_word);
    }
    words.then_some(Dialect::LinuxCnc)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_dialect_is_known_by_what_only_it_has() {
        let cases: [(&[u8], Option<Dialect>); 12] = [
            (b"G53\n#1101=1\nG1 X1. F1.\n", Some(Dialect::Fanuc)),
            (b"WHEN TRUE DO $A_OUT[1]=1\n", Some(Dialect::Siemens)),
            (b"N10 TRAORI\nG1 X1 Y2 Z3 F100\n", Some(Dialect::Siemens)),
            (b"G21 G90\nG43.5 H1\n", Some(Dialect::Fanuc)),
            (b"(G43.4 AND TRAORI)\nG21 G90\nM2\n", Some(Dialect::LinuxCnc)),
            (b"; A\nG710 G90 G17 G40 G500 G64\nG93\n", Some(Dialect::Siemens)),
            (b"G1 B1=30.5 F1.\n", Some(Dialect::Siemens)),
            (b"%\nO0001 (A)\nG21\n%\n", Some(Dialect::Fanuc)),
            (b"(A = B)\nG21 G90\nM2\n", Some(Dialect::LinuxCnc)),
            (b"n10 g1 x-1.5\n", Some(Dialect::LinuxCnc)),
            (b"", None),
            (b"\x00\xff\xfe", None),
        ];
        for (text, dialect) in cases {
            assert_eq!(detect_dialect(text), dialect, "{}", text.escape_ascii());
        }
    }
}
