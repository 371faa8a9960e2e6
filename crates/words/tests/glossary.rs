//! The glossary as data: spellings that are not used, each with what to write.

use crate::repository::read;

/// Where the glossary is.
pub const FILE: &str = "docs/glossary.md";

/// A spelling that is not used.
pub struct Spelling {
    pub text: String,
    /// What to write.
    pub instead: String,
}

/// All spellings that the glossary rules out: the last of five columns of its terms, the first of two of its phrases.
pub fn spellings(page: &str) -> Vec<Spelling> {
    rows(page)
        .flat_map(|cells| {
            let (texts, instead) = match cells.as_slice() {
                [term, _, _, _, not] => (*not, *term),
                [not, write] => (*not, *write),
                _ => panic!("{FILE}: a row of {} cells: {cells:?}", cells.len()),
            };
            quoted(texts)
                .map(|text| Spelling { text: text.to_lowercase(), instead: instead.to_owned() })
                .collect::<Vec<_>>()
        })
        .collect()
}

/// Cells of all rows of the tables, without heads.
fn rows(page: &str) -> impl Iterator<Item = Vec<&str>> {
    let lines = page.lines().filter_map(|line| line.strip_prefix('|')?.trim_end().strip_suffix('|'));
    lines.map(|line| line.split('|').map(str::trim).collect()).filter(|cells: &Vec<&str>| {
        !matches!(cells.as_slice(), ["English" | "not", ..])
            && !cells.iter().all(|cell| cell.starts_with("---"))
    })
}

/// What stands between backquotes.
fn quoted(cell: &str) -> impl Iterator<Item = &str> {
    cell.split('`').skip(1).step_by(2)
}

#[test]
fn every_term_has_a_german_one_and_stands_once() {
    let page = read(FILE);
    let terms: Vec<_> = rows(&page).filter(|cells| cells.len() == 5).collect();
    assert!(terms.len() > 150, "{} terms", terms.len());
    let mut names = std::collections::BTreeSet::new();
    for cells in &terms {
        assert!(!cells[0].is_empty() && !cells[1].is_empty(), "{FILE}: {cells:?}");
        assert!(names.insert(cells[0].to_lowercase()), "{FILE}: {} stands twice", cells[0]);
    }
    for spelling in spellings(&page) {
        assert!(!names.contains(&spelling.text), "{FILE}: {} is a term and ruled out", spelling.text);
    }
}
