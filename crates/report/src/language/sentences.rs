//! Texts of the table with holes: `{n}` stands for a number, `{}` for anything, which appears in the language as well.

use super::german::TEXTS;
use std::cell::RefCell;
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

/// A text in German, and what in it stayed English.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Said {
    pub text: String,
    pub left: Vec<String>,
}

impl Said {
    fn whole(text: impl Into<String>) -> Self {
        Self { text: text.into(), left: Vec::new() }
    }

    /// What stands in a hole: in German where the table knows it, else as it is.
    fn of_hole(text: &str) -> Self {
        known(text).unwrap_or_else(|| {
            let left = if has_words(text) { vec![text.to_owned()] } else { Vec::new() };
            Self { text: text.to_owned(), left }
        })
    }

    /// Members joined as they were parted.
    fn joined(members: Vec<Self>, by: &str) -> Self {
        let texts: Vec<&str> = members.iter().map(|member| member.text.as_str()).collect();
        let text = texts.join(by);
        Self { text, left: members.into_iter().flat_map(|member| member.left).collect() }
    }
}

/// English words of less than four letters that stand between numbers.
const SHORT: [&str; 12] = ["of", "to", "at", "by", "on", "and", "per", "or", "the", "for", "is", "in"];

/// Whether a text has words of a language: four letters in a row are no unit and no symbol. Names are none: those of files, of keys, and
/// those of passes, which programs have in capitals.
pub(super) fn has_words(text: &str) -> bool {
    let is_name = |token: &str| {
        let token = token.trim_end_matches(['.', ',', ';', ':', ')']);
        token.contains(['.', '/', '_', '`']) || !token.chars().any(char::is_lowercase)
    };
    let is_word = |word: &str| word.chars().count() >= 4 || SHORT.contains(&word);
    text.split_whitespace()
        .filter(|token| !is_name(token))
        .any(|token| token.split(|c: char| !c.is_alphabetic()).any(is_word))
}

/// A text in German; `None` for one that the table does not know. A capital at its beginning and the full stop at its end make it no other
/// text; sentences, clauses and members of a list are known where all of them are.
pub(super) fn german(text: &str) -> Option<Said> {
    known(&text.replace(" um", " µm"))
}

/// Texts that were looked up, so that parts of a text are looked up once, in whatever way it is parted.
type Seen = HashMap<String, Option<Said>>;

/// More texts than this are looked up again.
const MOST_SEEN: usize = 4096;

thread_local! {
    static SEEN: RefCell<Seen> = RefCell::new(Seen::new());
}

fn known(text: &str) -> Option<Said> {
    if let Some(said) = SEEN.with_borrow(|seen| seen.get(text).cloned()) {
        return said;
    }
    let said = looked_up(text);
    SEEN.with_borrow_mut(|seen| {
        if seen.len() >= MOST_SEEN {
            seen.clear();
        }
        seen.insert(text.to_owned(), said.clone());
    });
    said
}

/// A text of the table without holes.
fn fixed(text: &str) -> Option<Said> {
    TABLE.fixed.get(text).map(|german| Said::whole(*german))
}

fn looked_up(text: &str) -> Option<Said> {
    // What is fixed goes before what has holes, for a hole takes anything.
    begun(text, &fixed)
        .or_else(|| parted(text, [", "; 2], &fixed))
        .or_else(|| sequence(text, &whole))
        .or_else(|| begun(text, &sentence).filter(|said| said.left.is_empty()))
        .or_else(|| stopped(text, &whole))
        .or_else(|| clauses(text, &whole))
        // Names in the holes of members stay as they are.
        .or_else(|| sequence(text, &known_or_wordless))
        .or_else(|| stopped(text, &known_or_wordless))
        .or_else(|| clauses(text, &known_or_wordless))
        .or_else(|| begun(text, &sentence))
}

/// What says a text or a member of one.
type Member<'a> = &'a dyn Fn(&str) -> Option<Said>;

/// A text as it is, or with a small letter where a capital stands because it is the beginning of a sentence.
fn begun(text: &str, table: Member<'_>) -> Option<Said> {
    if let Some(said) = table(text) {
        return Some(said);
    }
    let mut letters = text.chars();
    let first = letters.next().filter(|c| c.is_uppercase())?;
    let small: String = first.to_lowercase().chain(letters).collect();
    let said = table(&small)?;
    let mut letters = said.text.chars();
    let first = letters.next()?;
    Some(Said { text: first.to_uppercase().chain(letters).collect(), left: said.left })
}

/// A text of several members whose every one a table knows, with what parts them in English and in German.
fn parted(text: &str, [english, german]: [&str; 2], table: Member<'_>) -> Option<Said> {
    let members: Vec<&str> = text.split(english).collect();
    if members.len() < 2 {
        return None;
    }
    let said: Option<Vec<Said>> = members.into_iter().map(table).collect();
    said.map(|said| Said::joined(said, german))
}

/// Several sentences.
fn sequence(text: &str, member: Member<'_>) -> Option<Said> {
    let mut members = Vec::new();
    let mut rest = text;
    while let Some(at) = rest.match_indices(". ").map(|(at, _)| at).find(|at| {
        let next = rest[at + 2..].chars().next();
        next.is_some_and(|c| c.is_uppercase() || c.is_ascii_digit())
    }) {
        members.push(&rest[..=at]);
        rest = &rest[at + 2..];
    }
    members.push(rest);
    if members.len() < 2 {
        return None;
    }
    let said: Option<Vec<Said>> = members.into_iter().map(member).collect();
    said.map(|said| Said::joined(said, " "))
}

/// A text without the full stop at its end.
fn stopped(text: &str, member: Member<'_>) -> Option<Said> {
    let said = member(text.strip_suffix('.')?)?;
    Some(Said { text: said.text + ".", ..said })
}

/// Clauses and lists, and what stands before and behind a colon.
fn clauses(text: &str, member: Member<'_>) -> Option<Said> {
    let at_colon = || {
        let (before, after) = text.split_once(": ")?;
        Some(Said::joined(vec![member(before)?, member(after)?], ": "))
    };
    let with_unit = || {
        let (before, unit) = text.strip_suffix(']')?.rsplit_once(" [")?;
        let said = member(before)?;
        Some(Said { text: format!("{} [{unit}]", said.text), left: said.left })
    };
    parted(text, ["; "; 2], member)
        .or_else(|| list(text))
        .or_else(at_colon)
        .or_else(with_unit)
        .or_else(|| parted(text, [" and ", " und "], member))
}

/// A list whose members may have commas themselves: from its beginning on, the shortest members that the table knows.
fn list(text: &str) -> Option<Said> {
    let commas: Vec<usize> = text.match_indices(", ").map(|(at, _)| at).collect();
    let member = |text: &str| {
        let known =
            || begun(text, &fixed).or_else(|| begun(text, &sentence)).filter(|said| said.left.is_empty());
        let at_colon = || {
            let (before, after) = text.split_once(": ")?;
            Some(Said::joined(vec![whole(before)?, begun(after, &fixed)?], ": "))
        };
        known().or_else(at_colon).or_else(|| (!has_words(text)).then(|| Said::whole(text)))
    };
    // What the rest of the list from a place on is, by the place.
    let mut from_place: Vec<Option<Said>> = vec![None; commas.len() + 2];
    from_place[commas.len() + 1] = Some(Said::default());
    let starts: Vec<usize> = std::iter::once(0).chain(commas.iter().map(|at| at + 2)).collect();
    for k in (0..starts.len()).rev() {
        from_place[k] = (k..starts.len()).find_map(|last| {
            let rest = from_place[last + 1].clone()?;
            if k == 0 && last + 1 == starts.len() {
                // The whole text is no list.
                return None;
            }
            let end = commas.get(last).copied().unwrap_or(text.len());
            let said = member(&text[starts[k]..end])?;
            let members = if last + 1 == starts.len() { vec![said] } else { vec![said, rest] };
            Some(Said::joined(members, ", "))
        });
    }
    from_place.swap_remove(0)
}

/// A member whose names stay as they are.
fn known_or_wordless(text: &str) -> Option<Said> {
    known(text).or_else(|| (!has_words(text)).then(|| Said::whole(text)))
}

/// A member of which nothing stays English.
fn whole(text: &str) -> Option<Said> {
    known_or_wordless(text).filter(|said| said.left.is_empty())
}

/// A text with holes, what stands in them in German too: the longest sentence that leaves nothing English, else the longest one.
fn sentence(text: &str) -> Option<Said> {
    let mut first = None;
    for (pattern, sentence) in &TABLE.sentences {
        let Some(holes) = holes(text, pattern) else { continue };
        let mut said = holes.iter().map(|hole| Said::of_hole(hole));
        let mut found = Said::default();
        for (k, piece) in sentence.split(HOLE).enumerate() {
            if k > 0
                && let Some(hole) = said.next()
            {
                found.text += &hole.text;
                found.left.extend(hole.left);
            }
            found.text += piece;
        }
        if found.left.is_empty() {
            return Some(found);
        }
        first.get_or_insert(found);
    }
    first
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
        let said = |text| german(text).map(|said| said.text);
        assert_eq!(said("Left flank").as_deref(), Some("Linke Flanke"));
        assert_eq!(said("left flank, right flank").as_deref(), Some("linke Flanke, rechte Flanke"));
        assert_eq!(
            said("Judged: left flank. Not judged: root.").as_deref(),
            Some("Beurteilt: linke Flanke. Nicht beurteilt: Fuß.")
        );
        assert_eq!(
            said("Left flank. Left flank: right flank.").as_deref(),
            Some("Linke Flanke. Linke Flanke: rechte Flanke.")
        );
        assert_eq!(said("Left flank. Nothing that a table has."), None);
        let items =
            "left flank, retraction and rapids against clamping and parts of the machine, right flank";
        assert_eq!(
            said(items).as_deref(),
            Some("linke Flanke, Rückzug und Eilgang gegen Spannmittel und Teile der Maschine, rechte Flanke")
        );
        assert_eq!(said("left flank, something that no table has, right flank"), None);
        assert_eq!(said("no text of the table, left flank"), None);
    }

    #[test]
    fn what_stays_english_is_named() {
        let left = |text| german(text).map(|said| said.left);
        assert_eq!(left("Judged: left flank."), Some(vec![]));
        assert_eq!(left("Judged: the moon."), Some(vec!["the moon".into()]));
        assert_eq!(left("Judged: left flank. Not judged: the moon."), Some(vec!["the moon".into()]));
        assert_eq!(left("the moon"), None);
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
