//! Text of results as a page prints it: units and the symbols of ISO 1328 that command and files spell in plain letters.

use super::charts::{escape, format_significant, indices};
use super::language::Language;
use std::borrow::Cow;

/// Symbols in plain letters, and printed.
const SYMBOLS: [(&str, &str); 16] = [
    ("fHa", "f<sub>Hα</sub>"),
    ("fHb", "f<sub>Hβ</sub>"),
    ("ffa", "f<sub>fα</sub>"),
    ("ffb", "f<sub>fβ</sub>"),
    ("Fa", "F<sub>α</sub>"),
    ("Fb", "F<sub>β</sub>"),
    ("Ca", "C<sub>α</sub>"),
    ("Cb", "C<sub>β</sub>"),
    ("fKo", "f<sub>Ko</sub>"),
    ("fKu", "f<sub>Ku</sub>"),
    ("fp", "f<sub>p</sub>"),
    ("Fp", "F<sub>p</sub>"),
    ("Fpk", "F<sub>pk</sub>"),
    ("Fr", "F<sub>r</sub>"),
    ("fu", "f<sub>u</sub>"),
    ("Rp", "R<sub>p</sub>"),
];

/// Sets texts of a page in its language.
#[derive(Clone, Copy)]
pub(super) struct Setter(pub(super) Language);

impl Setter {
    /// Running text and cells.
    pub(super) fn running(self, text: &str) -> String {
        typeset(&self.0.say(&rounded(text)))
    }

    /// Headings and attributes: nothing but the language.
    pub(super) fn label(self, text: &str) -> String {
        escape(&self.0.say(text))
    }

    /// Text with symbols, whose indices stand below the line.
    pub(super) fn symbols(self, text: &str) -> String {
        let said = self.0.say(text);
        let set = |(piece, below): (String, bool)| match below {
            true => format!("<sub>{}</sub>", escape(&piece)),
            false => {
                let word = |word: &str| {
                    let bare = word.trim_end_matches(' ');
                    symbols(bare) + &word[bare.len()..]
                };
                piece.split_inclusive(' ').map(word).collect()
            }
        };
        indices(&said).into_iter().map(set).collect()
    }

    /// A unit that stands alone.
    pub(super) fn unit(self, text: &str) -> String {
        escape(&self.0.say(&unit(text)))
    }
}

/// A unit as pages print it: files and keys spell it in plain letters.
pub fn unit(text: &str) -> Cow<'_, str> {
    let plain = |word: &str| match word {
        "um" => "µm".to_owned(),
        "deg" => "°".to_owned(),
        "urad" => "µrad".to_owned(),
        other => other.to_owned(),
    };
    match text {
        "" | "mm" => Cow::Borrowed(text),
        _ => {
            let words: Vec<String> = text
                .split('/')
                .map(|part| part.split(' ').map(plain).collect::<Vec<_>>().join(" "))
                .collect();
            Cow::Owned(words.join("/"))
        }
    }
}

/// Escaped text: a number's `um` and `deg` as µm and °, symbols with their indices. What stands in quotes of any kind, in keys and in names
/// of files stays as it is.
pub(super) fn typeset(text: &str) -> String {
    if let "um" | "deg" | "urad" = text {
        return unit(text).into_owned();
    }
    let mut page = String::with_capacity(text.len() + 16);
    let mut before: Option<&str> = None;
    // Spaces stay with the word that they follow, so that all of them are kept.
    for piece in text.split_inclusive(' ') {
        let word = piece.trim_end_matches(' ');
        let space = &piece[word.len()..];
        let follows_number = before.is_some_and(ends_a_number);
        let end = word.find(|c: char| !c.is_ascii_alphanumeric()).unwrap_or(word.len());
        let (start, rest) = word.split_at(end);
        match start {
            "um" if follows_number && is_mark(rest) => {
                page += "µm";
                page += &escape(rest);
            }
            "deg" if follows_number && is_mark(rest) => {
                // No space before the sign of degrees.
                page.truncate(page.trim_end_matches(' ').len());
                page += "°";
                page += &escape(rest);
            }
            _ => page += &symbols(word),
        }
        page += space;
        if !word.is_empty() {
            before = Some(word);
        }
    }
    page
}

/// Digits that a number of a page has at most, but for whole numbers and thousandths.
const DIGITS: usize = 6;

/// Text whose numbers have no needless digits: `3.0000000000000004` is 3.
fn rounded(text: &str) -> Cow<'_, str> {
    let is_number = |c: char| c.is_ascii_digit() || c == '.';
    let long = |word: &str| {
        let (whole, decimals) = word.split_once('.')?;
        let plain = !whole.is_empty() && decimals.bytes().all(|b| b.is_ascii_digit());
        let digits = word.trim_start_matches(['0', '.']).bytes().filter(u8::is_ascii_digit).count();
        (plain && decimals.len() > 3 && digits > DIGITS).then(|| word.parse::<f64>().ok())?
    };
    if !text.split(|c| !is_number(c)).any(|word| long(word).is_some()) {
        return Cow::Borrowed(text);
    }
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(start) = rest.find(is_number) {
        let (before, number) = rest.split_at(start);
        let end = number.find(|c| !is_number(c)).unwrap_or(number.len());
        out += before;
        match long(&number[..end]) {
            Some(value) => out += &format_significant(value, DIGITS),
            None => out += &number[..end],
        }
        rest = &number[end..];
    }
    Cow::Owned(out + rest)
}

/// Whether a word ends with a digit, so that a unit may follow.
fn ends_a_number(word: &str) -> bool {
    word.ends_with(|c: char| c.is_ascii_digit() || "⁰¹²³⁴⁵⁶⁷⁸⁹".contains(c))
}

/// What may follow a unit: nothing, a mark of a sentence, or a further unit below the line.
fn is_mark(rest: &str) -> bool {
    rest.is_empty() || rest.starts_with([',', ';', '.', ':', ')', '/', '|'])
}

/// A word, with its index if it is a symbol.
fn symbols(word: &str) -> String {
    let is_letter = |c: char| c.is_ascii_alphanumeric();
    let start = word.find(is_letter).unwrap_or(word.len());
    let (before, rest) = word.split_at(start);
    let end = rest.find(|c| !is_letter(c)).unwrap_or(rest.len());
    let (name, after) = rest.split_at(end);
    let plain = before.chars().all(|c| c == '(') && after.chars().all(|c| ",;.:)".contains(c));
    match SYMBOLS.iter().find(|(symbol, _)| *symbol == name) {
        Some((_, printed)) if plain => format!("{}{printed}{}", escape(before), escape(after)),
        _ => with_index(word).unwrap_or_else(|| escape(word)),
    }
}

/// A symbol with its index, `F_α` or `Δv_yA`: one or two letters before the underscore. Columns of files, such as `w_mm`, are none.
fn with_index(word: &str) -> Option<String> {
    const UNITS: [&str; 3] = ["mm", "um", "deg"];
    let (start, rest) = word.split_once('_')?;
    let letters = start.trim_start_matches(['(', '|', '±', 'Δ']).trim_end_matches('\'');
    let end = rest.find(|c: char| !c.is_alphanumeric()).unwrap_or(rest.len());
    let (index, after) = rest.split_at(end);
    let symbol = (1..=2).contains(&letters.chars().count()) && letters.chars().all(char::is_alphabetic);
    let short = (1..=4).contains(&index.chars().count()) && !UNITS.contains(&index);
    let ends = after.chars().all(|c| "|,;.:)".contains(c));
    (symbol && short && ends)
        .then(|| format!("{}<sub>{}</sub>{}", escape(start), escape(index), escape(after)))
}

#[cfg(test)]
mod tests {
    use super::{Language, Setter, rounded, typeset, unit};

    #[test]
    fn units_alone_are_printed() {
        for (plain, printed) in [
            ("um", "µm"),
            ("deg", "°"),
            ("deg/s", "°/s"),
            ("um per m", "µm per m"),
            ("mm", "mm"),
            ("", ""),
            ("µm/Nm", "µm/Nm"),
        ] {
            assert_eq!(unit(plain), printed);
        }
    }

    #[test]
    fn units_of_numbers_are_printed() {
        assert_eq!(typeset("at most 1.5 um, 3 um."), "at most 1.5 µm, 3 µm.");
        assert_eq!(typeset("turns 18.16 deg along, 90 deg/s (0.5 deg)"), "turns 18.16° along, 90°/s (0.5°)");
        assert_eq!(typeset("5.2 of 4.5 um, 1.5·10⁻¹¹ um"), "5.2 of 4.5 µm, 1.5·10⁻¹¹ µm");
        assert_eq!(typeset("deg"), "°");
        assert_eq!(typeset("2  um  wide "), "2  µm  wide ");
    }

    #[test]
    fn needless_decimals_are_rounded() {
        assert_eq!(rounded("3.0000000000000004 deg, 19.252409926977002 mm"), "3 deg, 19.2524 mm");
        assert_eq!(rounded("-1.0783992795489268 mm, 0.123456789"), "-1.0784 mm, 0.123457");
        for text in
            ["0.25 mm", "version 0.1.0", "1.5.2", "0.00123456", "20743.685", "…", "12.", "name.0123456789a"]
        {
            assert_eq!(rounded(text), text);
        }
        let german = Setter(Language::German);
        assert_eq!(german.running("3.0000000000000004 mm, 19.252409926977002 mm"), "3 mm, 19,2524 mm");
    }

    #[test]
    fn what_is_no_unit_of_a_number_stays() {
        for text in [
            "raise chord_tolerance_um of the control",
            "largest change um: 3",
            "3 umbrellas, 4 degrees",
            "axis 3 um_limit",
            "`tolerance_um = 3`",
            "ü 3\u{a0}um",
        ] {
            assert_eq!(typeset(text), text);
        }
        assert_eq!(typeset("a < b & 3 um"), "a &lt; b &amp; 3 µm");
    }

    #[test]
    fn symbols_get_their_indices() {
        assert_eq!(
            typeset("fHa 5.2 of 4.5 um, Fb (fHb)"),
            "f<sub>Hα</sub> 5.2 of 4.5 µm, F<sub>β</sub> (f<sub>Hβ</sub>)"
        );
        assert_eq!(typeset("fHa, left"), "f<sub>Hα</sub>, left");
        assert_eq!(
            typeset("F_α and |Δv_yA|, Q'_w"),
            "F<sub>α</sub> and |Δv<sub>yA</sub>|, Q&#39;<sub>w</sub>"
        );
        for text in ["w_mm", "tip_relief", "`F_α`", "d_v_yA", "technology.limits.Q_w"] {
            assert_eq!(typeset(text), text);
        }
        for text in ["fHa.left.mean", "fHalpha", "Fa-1", "programs/Fa.nc"] {
            assert_eq!(typeset(text), text);
        }
    }
}
