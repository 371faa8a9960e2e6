//! The text of a file of unstated encoding: UTF-8 with or without mark, else cp1252. Guesses nothing beyond these.

use serde::{Deserialize, Serialize};

use super::InspectionError;

/// The encoding in which a file was found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Encoding {
    /// UTF-8 behind a byte order mark.
    #[serde(rename = "utf-8-bom")]
    Utf8WithMark,
    /// UTF-8.
    #[serde(rename = "utf-8")]
    Utf8,
    /// Windows code page 1252, of which Latin-1 is a part.
    #[serde(rename = "cp1252")]
    Cp1252,
}

impl Encoding {
    /// The name in reports.
    pub fn name(self) -> &'static str {
        match self {
            Self::Utf8WithMark => "utf-8-bom",
            Self::Utf8 => "utf-8",
            Self::Cp1252 => "cp1252",
        }
    }
}

const MARK: &[u8] = b"\xef\xbb\xbf";

/// What code page 1252 has in 0x80 to 0x9f; the five places it leaves open are the control characters of Latin-1.
const CP1252: [char; 32] = [
    '\u{20ac}', '\u{81}', '\u{201a}', '\u{192}', '\u{201e}', '\u{2026}', '\u{2020}', '\u{2021}', '\u{2c6}',
    '\u{2030}', '\u{160}', '\u{2039}', '\u{152}', '\u{8d}', '\u{17d}', '\u{8f}', '\u{90}', '\u{2018}',
    '\u{2019}', '\u{201c}', '\u{201d}', '\u{2022}', '\u{2013}', '\u{2014}', '\u{2dc}', '\u{2122}', '\u{161}',
    '\u{203a}', '\u{153}', '\u{9d}', '\u{17e}', '\u{178}',
];

/// The text without its mark, and the encoding.
pub(super) fn decode(bytes: &[u8]) -> Result<(String, Encoding), InspectionError> {
    let refuse = |what: String| Err(InspectionError::UnsupportedEncoding { what });
    if bytes.starts_with(b"\xff\xfe") || bytes.starts_with(b"\xfe\xff") {
        return refuse("a mark of UTF-16".into());
    }
    if let Some(offset) = bytes.iter().position(|&b| b == 0) {
        return refuse(format!("a NUL byte at offset {offset}"));
    }
    if let Some(rest) = bytes.strip_prefix(MARK) {
        return match std::str::from_utf8(rest) {
            Ok(text) => Ok((text.to_owned(), Encoding::Utf8WithMark)),
            Err(error) => {
                let offset = MARK.len() + error.valid_up_to();
                refuse(format!("the mark of UTF-8, but at offset {offset} a byte that is none"))
            }
        };
    }
    if let Ok(text) = std::str::from_utf8(bytes) {
        return Ok((text.to_owned(), Encoding::Utf8));
    }
    let of = |byte: u8| match byte {
        0x80..=0x9f => CP1252[usize::from(byte) - 0x80],
        other => char::from(other),
    };
    Ok((bytes.iter().map(|&b| of(b)).collect(), Encoding::Cp1252))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_encoding_is_told() {
        let text = |bytes: &[u8]| decode(bytes).unwrap();
        assert_eq!(text(b"\xef\xbb\xbfZ\xc3\xa4hne"), ("Zähne".into(), Encoding::Utf8WithMark));
        assert_eq!(text(b"Z\xc3\xa4hne"), ("Zähne".into(), Encoding::Utf8));
        assert_eq!(text(b"Z\xe4hne 5\x80\x9f\x81"), ("Zähne 5€Ÿ\u{81}".into(), Encoding::Cp1252));
        assert_eq!(text(b""), (String::new(), Encoding::Utf8));
    }

    #[test]
    fn what_is_no_such_text_is_refused() {
        for bytes in [&b"\xff\xfeH\0"[..], b"\xfe\xff\0H", b"HEADER\0", b"\xef\xbb\xbfZ\xe4hne"] {
            let error = decode(bytes).unwrap_err();
            assert_eq!(error.code(), "unsupported-encoding", "{error}");
        }
    }
}
