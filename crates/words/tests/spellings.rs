//! Spellings that the glossary rules out, looked for in the prose of the repository.

use crate::glossary::{self, Spelling, spellings};
use crate::repository::{Text, pages, read, sources};

#[test]
fn the_repository_uses_the_terms_of_the_glossary() {
    let spellings = spellings(&read(glossary::FILE));
    let mut found = Vec::new();
    for path in pages().into_iter().chain(sources()).filter(|path| path != glossary::FILE) {
        let mut text = Text::of(&path, &read(&path));
        if path == "CHANGELOG.md" {
            text.lines = unreleased(text.lines);
        }
        found.extend(offences(&text, &spellings));
    }
    assert!(found.is_empty(), "{} spellings that are not used here:\n{}", found.len(), found.join("\n"));
}

/// The part of the changelog that may still change.
fn unreleased(lines: Vec<(usize, String)>) -> Vec<(usize, String)> {
    let mut sections = 0;
    lines
        .into_iter()
        .take_while(|(_, line)| {
            sections += usize::from(line.starts_with("## "));
            sections < 2
        })
        .collect()
}

/// `file:line: spelling: write this` for each spelling in the text.
fn offences(text: &Text, spellings: &[Spelling]) -> Vec<String> {
    let mut found = Vec::new();
    for (number, line) in &text.lines {
        let prose = without_code(line).to_lowercase();
        for spelling in spellings.iter().filter(|spelling| contains(&prose, &spelling.text)) {
            found.push(format!(
                "{}:{number}: \"{}\": write \"{}\"",
                text.path, spelling.text, spelling.instead
            ));
        }
    }
    found
}

/// A line without code, formulas and targets of links, which keep their names.
fn without_code(line: &str) -> String {
    let mut prose = String::new();
    let mut rest = line;
    while let Some(start) = rest.find(['`', '$', '(']) {
        let mark = &rest[start..=start];
        let is_link = mark == "(" && rest[..start].ends_with(']');
        prose.push_str(&rest[..start]);
        rest = &rest[start + 1..];
        prose.push_str(mark);
        if let Some(end) = rest.find(if mark == "(" { ")" } else { mark }).filter(|_| mark != "(" || is_link)
        {
            rest = &rest[end + 1..];
        }
    }
    prose + rest
}

/// Whether the words stand in a line, with or without a plural s, and not as a part of longer words.
fn contains(line: &str, words: &str) -> bool {
    let is_word = |c: char| c.is_alphanumeric() || c == '_' || c == '-';
    line.match_indices(words).any(|(start, _)| {
        let before = line[..start].chars().next_back();
        let after = &line[start + words.len()..];
        let after = after.strip_prefix('s').unwrap_or(after).chars().next();
        !before.is_some_and(is_word) && !after.is_some_and(is_word)
    })
}

#[test]
fn a_spelling_is_found_with_its_line_and_what_to_write() {
    let glossary = "| English | German | symbol | meaning | not |\n|---|---|---|---|---|\n| opposite flank | Gegenflanke | | | `counter flank` |\n\
        \n| not | write |\n|---|---|\n| `is told`, `of now` | is reported |\n";
    let spellings = spellings(glossary);
    let sample = "//! Spares Counter flanks; `counter flank` is a name.\nfn told() {} // is told\n/// What is told.\n/// A counter-flank, noise of nowhere.\n";
    let found = offences(&Text::of("sample.rs", sample), &spellings);
    assert_eq!(
        found,
        [
            "sample.rs:1: \"counter flank\": write \"opposite flank\"",
            "sample.rs:3: \"is told\": write \"is reported\"",
        ]
    );
    let found = offences(&Text::of("sample.md", "[x](of now.md) and $is told$ and (of now)\n"), &spellings);
    assert_eq!(found, ["sample.md:1: \"of now\": write \"is reported\""]);
}

#[test]
fn released_parts_of_the_changelog_stay_as_they_are() {
    let lines = ["# Changelog", "## [Unreleased]", "new", "## [0.1.0]", "old"];
    let numbered = lines.iter().zip(1..).map(|(line, number)| (number, (*line).to_owned())).collect();
    assert_eq!(unreleased(numbered).len(), 3);
}
