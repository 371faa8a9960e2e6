//! Texts of the table with holes: `{}` stands for a number or a word, which is said in the language as well.

use super::german::TEXTS;
use std::collections::HashMap;
use std::sync::LazyLock;

/// Texts without a hole, and those with some.
struct Table {
    fixed: HashMap<&'static str, &'static str>,
    /// By decreasing length of their own words, so that the nearest one is found first.
    sentences: Vec<(Vec<&'static str>, &'static str)>,
}

const HOLE: &str = "{}";

static TABLE: LazyLock<Table> = LazyLock::new(|| {
    let mut fixed = HashMap::new();
    let mut sentences = Vec::new();
    for (english, german) in TEXTS.iter().flat_map(|texts| texts.iter().copied()) {
        if english.contains(HOLE) {
            sentences.push((english.split(HOLE).collect::<Vec<_>>(), german));
        } else {
            fixed.insert(english, german);
        }
    }
    sentences
        .sort_by_key(|(pieces, _)| std::cmp::Reverse(pieces.iter().map(|piece| piece.len()).sum::<usize>()));
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
    TABLE.sentences.iter().find_map(|(pieces, sentence)| {
        let holes = holes(text, pieces)?;
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
fn holes<'a>(text: &'a str, pieces: &[&str]) -> Option<Vec<&'a str>> {
    let (first, rest) = pieces.split_first()?;
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
        if hole.is_empty() || left.get(at..)?.strip_prefix(piece).is_none() {
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
        let of = |text, sentence: &'static str| holes(text, &sentence.split(HOLE).collect::<Vec<_>>());
        assert_eq!(of("at 3 mm, 4 mm.", "at {} mm, {} mm."), Some(vec!["3", "4"]));
        assert_eq!(of("left asked", "{} asked"), Some(vec!["left"]));
        assert_eq!(of("round 12", "round {}"), Some(vec!["12"]));
        assert_eq!(of("round ", "round {}"), None);
        assert_eq!(of("around 12", "round {}"), None);
        assert_eq!(of("at 3 mm", "at {} mm, {} mm."), None);
        assert_eq!(of("µ", "{} µµ"), None);
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
            assert_eq!(english.matches(HOLE).count(), german.matches(HOLE).count(), "{english}");
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
