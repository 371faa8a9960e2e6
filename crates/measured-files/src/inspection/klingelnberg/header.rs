//! The header: a code, its label, its value; from code 80 on also a key and fields. Values stay text until they are asked for.

use serde::{Deserialize, Serialize};

use super::number::leading_numbers;

/// A line before the first code.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct PreambleEntry {
    /// Its key, e.g. `UNDEFINED`.
    pub key: String,
    /// Its value without comment.
    pub value: String,
}

/// A line of the header.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct HeaderEntry {
    /// What stands between code and value.
    pub label: String,
    /// Key of a keyed line.
    pub key: Option<String>,
    /// Everything behind the label, or behind the key of a keyed line.
    pub value: String,
    /// Line of the file, from 1.
    pub line: usize,
}

/// First code of keyed lines.
const KEYED: u16 = 80;

impl HeaderEntry {
    /// The value split at colons.
    pub fn fields(&self) -> Vec<&str> {
        self.value.split(':').map(str::trim).collect()
    }

    /// The first number of the value.
    pub fn number(&self) -> Option<f64> {
        leading_numbers(&self.value).first().copied()
    }

    /// Left and right number; one number stands for both.
    pub fn two_sided(&self) -> Option<[f64; 2]> {
        let numbers = leading_numbers(&self.value);
        let left = *numbers.first()?;
        Some([left, numbers.get(1).copied().unwrap_or(left)])
    }

    /// The value as a text, if there is one.
    pub fn text(&self) -> Option<String> {
        Some(self.value.trim()).filter(|text| !text.is_empty()).map(str::to_owned)
    }
}

/// A line `code : label : value`: one to three digits, the first colon, a label without colon, the value with or without colons.
pub(super) fn coded(line: &str, number: usize) -> Option<(u16, HeaderEntry)> {
    let (code, rest) = line.split_once(':')?;
    let code = code.trim();
    if code.is_empty() || code.len() > 3 || !code.bytes().all(|b| b.is_ascii_digit()) {
        return None;
    }
    let code: u16 = code.parse().ok()?;
    let (label, value) = rest.split_once(':').unwrap_or((rest, ""));
    let entry = |key: Option<&str>, value: &str| HeaderEntry {
        label: label.trim().to_owned(),
        key: key.map(str::to_owned),
        value: value.trim().to_owned(),
        line: number,
    };
    if code >= KEYED {
        // The key is the first word of its kind that stands between two colons: `1-DIN  :LVORZ: 1: DIN` has the key LVORZ.
        let mut tail = value;
        while let Some((word, behind)) = tail.split_once(':') {
            if is_key(word.trim()) {
                return Some((code, entry(Some(word.trim()), behind)));
            }
            tail = behind;
        }
    }
    Some((code, entry(None, value)))
}

/// 3 to 6 of A-Z, 0-9 and _; a number alone is a value.
fn is_key(word: &str) -> bool {
    (3..=6).contains(&word.len())
        && word.bytes().all(|b| b.is_ascii_uppercase() || b.is_ascii_digit() || b == b'_')
        && word.bytes().any(|b| b.is_ascii_uppercase())
}

/// A line of the preamble: `KEY value ! comment`, also `FILTER LEAD: text`.
pub(super) fn preamble(line: &str) -> Option<PreambleEntry> {
    let line = line.split('!').next().unwrap_or(line).trim();
    if let Some(rest) = line.strip_prefix("FILTER ") {
        let (what, value) = rest.split_once(':')?;
        return Some(PreambleEntry {
            key: format!("FILTER {}", what.trim()),
            value: value.trim().to_owned(),
        });
    }
    let (key, value) = line.split_once(char::is_whitespace).unwrap_or((line, ""));
    let good = key.len() >= 2
        && key.bytes().all(|b| b.is_ascii_uppercase() || b.is_ascii_digit() || b == b'_')
        && key.bytes().any(|b| b.is_ascii_uppercase());
    good.then(|| PreambleEntry { key: key.to_owned(), value: value.trim().to_owned() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_follow_a_colon() {
        let of = |line| {
            let (code, entry) = coded(line, 1).unwrap();
            (code, entry.key.clone(), entry.fields().iter().map(|f| (*f).to_owned()).collect::<Vec<_>>())
        };
        let (code, key, fields) = of("178 :Vorzeichen Flankenlinie 0-VDI,1-DIN  :LVORZ: 1: DIN ");
        assert_eq!((code, key.as_deref(), fields.join("|")), (178, Some("LVORZ"), "1|DIN".into()));
        let (_, key, fields) = of("165 :Reference fHb: 0-VDI / 1-DIN / 2- +-+ :R_FHB: 1 : L: + : R: -");
        assert_eq!((key.as_deref(), fields.join("|")), (Some("R_FHB"), "1|L|+|R|-".into()));
        let (_, key, fields) = of("210 :fp  links             : 100 : 6   ");
        assert_eq!((key, fields.join("|")), (None, "100|6".into()));
        let (_, key, fields) = of("90  :Winkelabw. rechts:        FHBR:8 : -8 : 0:   17");
        assert_eq!((key.as_deref(), fields.join("|")), (Some("FHBR"), "8|-8|0|17".into()));
    }

    #[test]
    fn values_begin_at_the_first_colon_behind_the_label() {
        let (code, entry) = coded("3   :Zeit..............: 08:21:31   /   08:34:28  ", 5).unwrap();
        assert_eq!((code, entry.text().unwrap().as_str()), (3, "08:21:31   /   08:34:28"));
        assert_eq!(entry.line, 5);
        let (_, title) = coded("  20  :Zahnrad-Daten             links  rechts ", 1).unwrap();
        assert_eq!((title.text(), title.number()), (None, None));
        let (_, one) = coded("47  :Teilungsmesskreis =50.88 (Kugel =1.5) [mm]...:  50.88  ", 1).unwrap();
        assert_eq!(one.two_sided(), Some([50.88, 50.88]));
        for line in ["x :y: 1", "1234 :y: 1", " :y: 1", "12 y 1", "-1 :y: 1"] {
            assert_eq!(coded(line, 1), None, "{line}");
        }
    }

    #[test]
    fn preamble_lines_have_a_key_in_capitals() {
        let of = |line| preamble(line).map(|e| (e.key, e.value));
        assert_eq!(of("UNDEFINED -9.5   ! Undefined"), Some(("UNDEFINED".into(), "-9.5".into())));
        assert_eq!(of("FILTER LEAD:    F:S 2"), Some(("FILTER LEAD".into(), "F:S 2".into())));
        assert_eq!(of("Sonderzeile ohne Bedeutung"), None);
        assert_eq!(of("12 13"), None);
    }
}
