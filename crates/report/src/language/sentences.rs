//! Texts of the table with holes: `{n}` stands for a number, `{}` for anything, which appears in the language as well.

use super::german::TEXTS;
use std::collections::HashMap;
use std::sync::LazyLock;

/// Texts without a hole, and those with some.
struct Table {
    fixed: HashMap<&'static str, &'static str>,
    /// By decreasing length of their own words, so that the nearest one is found first.
    sentences: Vec<(Pattern, &'static str)>,
}

/// A text with holes.
struct Pattern {
    /// What stands before, between and behind the holes.
    pieces: Vec<&'static str>,
    /// Which of the holes take numbers only.
    numbers: Vec<bool>,
}

const HOLE: &str = "{}";
const NUMBER: &str = "{n}";

impl Pattern {
    fn of(text: &'static str) -> Self {
        let (mut pieces, mut numbers) = (Vec::new(), Vec::new());
        let mut rest = text;
        while let Some(at) = rest.find(HOLE).into_iter().chain(rest.find(NUMBER)).min() {
            let is_number = rest[at..].starts_with(NUMBER);
            pieces.push(&rest[..at]);
            numbers.push(is_number);
            rest = &rest[at + if is_number { NUMBER } else { HOLE }.len()..];
        }
        pieces.push(rest);
        Self { pieces, numbers }
    }
}

/// Whether a text is a number as pages print it.
fn is_number(text: &str) -> bool {
    let is_digit = |c: char| c.is_ascii_digit() || "⁰¹²³⁴⁵⁶⁷⁸⁹".contains(c);
    text.contains(is_digit) && text.chars().all(|c| is_digit(c) || ".,−-+·–⁻".contains(c))
}

static TABLE: LazyLock<Table> = LazyLock::new(|| {
    let mut fixed = HashMap::new();
    let mut sentences = Vec::new();
    for (english, german) in TEXTS.iter().flat_map(|texts| texts.iter().copied()) {
        if english.contains(HOLE) || english.contains(NUMBER) {
            sentences.push((Pattern::of(english), german));
        } else {
            fixed.insert(english, german);
        }
    }
    let own = |(pattern, _): &(Pattern, &str)| pattern.pieces.iter().map(|piece| piece.len()).sum::<usize>();
    sentences.sort_by_key(|entry| std::cmp::Reverse(own(entry)));
    Table { fixed, sentences }
});

/// A text in German; `None` for one that the table does not know. A capital at its beginning makes it no other text, and a list is known
/// where all of its members are.
pub(super) fn german(text: &str) -> Option<String> {
    let fixed = |text: &str| TABLE.fixed.get(text).map(|german| (*german).to_owned());
    let by = |table: &dyn Fn(&str) -> Option<String>| table(text).or_else(|| small_letter(text, table));
    // What is fixed goes before what has holes, for a hole takes anything.
    by(&fixed)
        .or_else(|| list(text, &fixed))
        .or_else(|| by(&sentence))
        .or_else(|| list(text, &|member: &str| fixed(member).or_else(|| sentence(member))))
}

/// A text that begins with a capital because it stands at the beginning.
fn small_letter(text: &str, table: &dyn Fn(&str) -> Option<String>) -> Option<String> {
    let mut letters = text.chars();
    let first = letters.next().filter(|c| c.is_uppercase())?;
    let small: String = first.to_lowercase().chain(letters).collect();
    let german = table(&small)?;
    let mut letters = german.chars();
    let first = letters.next()?;
    Some(first.to_uppercase().chain(letters).collect())
}

/// A list with commas whose members a table knows.
fn list(text: &str, table: &dyn Fn(&str) -> Option<String>) -> Option<String> {
    let members: Vec<&str> = text.split(", ").collect();
    if members.len() < 2 {
        return None;
    }
    let german: Option<Vec<String>> = members.into_iter().map(table).collect();
    german.map(|members| members.join(", "))
}

/// A text with holes, what stands in them in German too.
fn sentence(text: &str) -> Option<String> {
    TABLE.sentences.iter().find_map(|(pattern, sentence)| {
        let holes = holes(text, pattern)?;
        let mut said = holes.iter().map(|hole| german(hole).unwrap_or_else(|| (*hole).to_owned()));
        Some(sentence.split(HOLE).enumerate().fold(String::new(), |mut out, (k, piece)| {
            if k > 0 {
                out += &said.next().unwrap_or_default();
            }
            out + piece
        }))
    })
}

/// What stands in the holes between the pieces, none of it empty; `None` for a text of another form.
fn holes<'a>(text: &'a str, pattern: &Pattern) -> Option<Vec<&'a str>> {
    let (first, rest) = pattern.pieces.split_first()?;
    let mut left = text.strip_prefix(first)?;
    let mut found = Vec::new();
    for (k, piece) in rest.iter().enumerate() {
        let at = match (k + 1 == rest.len(), piece.is_empty()) {
            (true, true) => left.len(),
            // The last piece ends the text.
            (true, false) => left.len() - piece.len().min(left.len()),
            (false, _) => left.find(piece)?,
        };
        let hole = left.get(..at)?;
        if hole.is_empty()
            || (pattern.numbers[k] && !is_number(hole))
            || left.get(at..)?.strip_prefix(piece).is_none()
        {
            return None;
        }
        found.push(hole);
        left = &left[at + piece.len()..];
    }
    left.is_empty().then_some(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holes_are_what_stands_between_the_pieces() {
        let of = |text, sentence: &'static str| holes(text, &Pattern::of(sentence));
        assert_eq!(of("at 3 mm, 4 mm.", "at {} mm, {} mm."), Some(vec!["3", "4"]));
        assert_eq!(of("left asked", "{} asked"), Some(vec!["left"]));
        assert_eq!(of("round 12", "round {}"), Some(vec!["12"]));
        assert_eq!(of("round ", "round {}"), None);
        assert_eq!(of("around 12", "round {}"), None);
        assert_eq!(of("at 3 mm", "at {} mm, {} mm."), None);
        assert_eq!(of("µ", "{} µµ"), None);
        assert_eq!(of("−2.5 to 3·10⁻⁴", "{n} to {n}"), Some(vec!["−2.5", "3·10⁻⁴"]));
        assert_eq!(of("short to reach", "{n} to {n}"), None);
    }

    #[test]
    fn texts_are_known_at_the_beginning_of_a_sentence_and_in_lists() {
        assert_eq!(german("Left flank").as_deref(), Some("Linke Flanke"));
        assert_eq!(german("left flank, right flank").as_deref(), Some("linke Flanke, rechte Flanke"));
        assert_eq!(
            german("Judged: left flank. Not judged: root.").as_deref(),
            Some("Beurteilt: linke Flanke. Nicht beurteilt: Fuß.")
        );
        assert_eq!(german("no text of the table, left flank"), None);
    }

    #[test]
    fn every_sentence_keeps_its_holes() {
        for (english, german) in TEXTS.iter().flat_map(|texts| texts.iter()) {
            let holes = english.matches(HOLE).count() + english.matches(NUMBER).count();
            assert_eq!(holes, german.matches(HOLE).count(), "{english}");
            assert!(
                !german.is_empty() && english.trim() == *english && german.trim() == *german,
                "{english}"
            );
        }
    }

    #[test]
    fn no_text_stands_twice() {
        let mut seen = std::collections::HashSet::new();
        for (english, _) in TEXTS.iter().flat_map(|texts| texts.iter()) {
            assert!(seen.insert(english), "{english}");
        }
    }
}
