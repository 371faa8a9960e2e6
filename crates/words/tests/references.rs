//! References of comments and pages to pages: the page exists, and so does the heading. A number of a document that is not in the
//! repository refers to nothing.

use std::collections::{BTreeMap, BTreeSet};

use crate::repository::{files, pages, read};

#[test]
fn every_page_and_heading_that_is_cited_exists() {
    let anchors: BTreeMap<String, BTreeSet<String>> =
        pages().into_iter().map(|page| (page.clone(), anchors(&read(&page)))).collect();
    let mut lost = Vec::new();
    for path in files("crates", "rs")
        .into_iter()
        .chain(files("crates", "toml"))
        .chain(files("examples", "toml"))
        .chain(pages())
    {
        // This folder speaks of references without making any.
        if path.starts_with("crates/words/") {
            continue;
        }
        let content = read(&path);
        for (line, number) in content.lines().zip(1..) {
            for (page, heading) in cited(line) {
                let known = anchors.get(page);
                if known.is_none_or(|known| heading.is_some_and(|heading| !known.contains(heading))) {
                    lost.push(format!("{path}:{number}: {page}#{}", heading.unwrap_or_default()));
                }
            }
            for (page, heading) in linked(&path, line) {
                let known = anchors.get(&page);
                if known.is_none_or(|known| heading.is_some_and(|heading| !known.contains(heading))) {
                    lost.push(format!("{path}:{number}: {page}#{}", heading.unwrap_or_default()));
                }
            }
            if cites_a_number(line) {
                lost.push(format!(
                    "{path}:{number}: name the page of docs/mathematics that holds the formula"
                ));
            }
        }
    }
    assert!(lost.is_empty(), "{} references to nothing:\n{}", lost.len(), lost.join("\n"));
}

/// A method that an example shows stands among the methods, and the page names no example that is gone.
#[test]
fn every_example_stands_among_the_methods() {
    let page = read("docs/methods.md");
    let named: BTreeSet<String> = page
        .match_indices("(../examples/")
        .filter_map(|(start, prefix)| page[start + prefix.len()..].split_once(')'))
        .map(|(path, _)| format!("examples/{path}"))
        .collect();
    let present: BTreeSet<String> = files("examples", "toml").into_iter().collect();
    assert_eq!(named, present);
}

/// Pages below `docs/` that a line names, with their headings: `docs/mathematics/dressing.md#conditions`.
fn cited(line: &str) -> impl Iterator<Item = (&str, Option<&str>)> {
    line.match_indices("docs/").filter_map(|(start, _)| {
        let rest = &line[start..];
        let end = rest.find(".md")? + 3;
        let (page, after) = rest.split_at(end);
        if !page.chars().all(|c| c.is_ascii_alphanumeric() || "/.-_".contains(c)) {
            return None;
        }
        let heading = after.strip_prefix('#').map(|heading| {
            let end = heading.find(|c: char| !(c.is_alphanumeric() || c == '-' || c == '_'));
            &heading[..end.unwrap_or(heading.len())]
        });
        Some((page, heading))
    })
}

/// Pages that a line of a page links to, by their paths in the repository, with their headings.
fn linked<'a>(path: &str, line: &'a str) -> Vec<(String, Option<&'a str>)> {
    if !path.ends_with(".md") {
        return Vec::new();
    }
    let targets = line.split("](").skip(1).filter_map(|rest| rest.split([')', ' ']).next());
    let pages = targets.filter(|target| !target.contains(':')).filter_map(|target| {
        let (page, heading) =
            target.split_once('#').map_or((target, None), |(page, heading)| (page, Some(heading)));
        let page = if page.is_empty() { path.to_owned() } else { beside(path, page) };
        page.ends_with(".md").then_some((page, heading))
    });
    pages.collect()
}

/// A relative path, seen from the file in which it stands.
fn beside(path: &str, relative: &str) -> String {
    let mut parts: Vec<&str> = path.split('/').collect();
    parts.pop();
    for part in relative.split('/') {
        match part {
            ".." => drop(parts.pop()),
            "." => {}
            part => parts.push(part),
        }
    }
    parts.join("/")
}

/// Anchors of the headings of a page, as its viewers make them.
fn anchors(page: &str) -> BTreeSet<String> {
    page.lines()
        .filter(|line| line.starts_with('#'))
        .map(|line| line.trim_start_matches('#').trim())
        .map(|heading| {
            let kept = heading.chars().filter(|c| c.is_alphanumeric() || " -_".contains(*c));
            kept.collect::<String>().to_lowercase().replace(' ', "-")
        })
        .collect()
}

/// Whether a line cites a numbered document: `spec` with two digits.
fn cites_a_number(line: &str) -> bool {
    let line = line.to_lowercase();
    ["spec ", "specs ", "specification "].iter().any(|word| {
        line.match_indices(word).any(|(start, _)| {
            let begins = line[..start].chars().next_back().is_none_or(|c| !c.is_alphanumeric() && c != '_');
            let number = &line[start + word.len()..];
            let digits = number.chars().take_while(char::is_ascii_digit).count();
            let after = number[digits..].strip_prefix('.');
            let is_version = after.is_some_and(|after| after.starts_with(|c: char| c.is_ascii_digit()));
            begins && digits == 2 && !is_version
        })
    })
}

#[test]
fn a_reference_is_a_page_with_a_heading() {
    let found: Vec<_> = cited("(`docs/mathematics/a.md#what-is-it`, see docs/b.md) docs/ of c.md").collect();
    assert_eq!(found, [("docs/mathematics/a.md", Some("what-is-it")), ("docs/b.md", None)]);
    let page = "# A page\n## Pitch, run-out\n### B";
    assert_eq!(anchors(page).into_iter().collect::<Vec<_>>(), ["a-page", "b", "pitch-run-out"]);
    let links = "[a](../b.md#c), [d](e.md), [f](#g), [h](https://i.md), [j](k.png)";
    let expected = [("docs/b.md", Some("c")), ("docs/m/e.md", None), ("docs/m/l.md", Some("g"))];
    let expected = expected.map(|(page, heading)| (page.to_owned(), heading));
    assert_eq!(linked("docs/m/l.md", links), expected);
    for cites in ["of spec 30.", "(Spec 20 section 3)", "specs 25 and 28"] {
        assert!(cites_a_number(cites), "{cites}");
    }
    for names in ["core specification 1.3", "let spec = 30;", "spec 2 of 3", "the specs"] {
        assert!(!cites_a_number(names), "{names}");
    }
}
