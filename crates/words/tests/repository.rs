//! The texts of the repository as lines of prose: pages, documentation comments and messages of the sources, comments in the templates of
//! jobs.

use std::fs;
use std::path::{Path, PathBuf};

/// Lines of one file that are prose, each with its number from 1.
pub struct Text {
    /// Path in the repository.
    pub path: String,
    /// Numbers from 1, and what stands there.
    pub lines: Vec<(usize, String)>,
}

impl Text {
    /// The prose of a file by the ending of its name.
    pub fn of(path: &str, content: &str) -> Self {
        let lines = match Path::new(path).extension().and_then(|ending| ending.to_str()) {
            Some("md") => page(content),
            Some("toml") => comments(content),
            _ => source(content),
        };
        Self { path: path.to_owned(), lines }
    }
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// A file of the repository.
pub fn read(path: &str) -> String {
    fs::read_to_string(root().join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// All files below a folder with an ending, by their paths in the repository.
pub fn files(folder: &str, ending: &str) -> Vec<String> {
    let mut found = Vec::new();
    let mut folders = vec![root().join(folder)];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display())) {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|of_file| of_file == ending) {
                let path = path.strip_prefix(root()).expect("below the root").to_path_buf();
                found.push(path.to_string_lossy().replace('\\', "/"));
            }
        }
    }
    found.sort();
    found
}

/// Paths of all pages.
pub fn pages() -> Vec<String> {
    let mut pages: Vec<String> = [
        "README.md",
        "ARCHITECTURE.md",
        "CONTRIBUTING.md",
        "CHANGELOG.md",
        "web/README.md",
        "crates/electronic-gearbox/README.md",
        "crates/flankwright-py/README.md",
    ]
    .map(String::from)
    .into();
    pages.extend(files("docs", "md"));
    pages
}

/// Paths of all sources and templates of the crates, without their tests.
pub fn sources() -> Vec<String> {
    let in_source = |path: &String| path.split('/').nth(2) == Some("src");
    files("crates", "rs").into_iter().chain(files("crates", "toml")).filter(in_source).collect()
}

/// A page without blocks of code.
fn page(content: &str) -> Vec<(usize, String)> {
    let mut in_code = false;
    numbered(content)
        .filter(|(_, line)| {
            let is_fence = line.trim_start().starts_with("```");
            in_code ^= is_fence;
            !(in_code || is_fence || line.starts_with("    "))
        })
        .map(|(number, line)| (number, line.to_owned()))
        .collect()
}

/// Documentation comments without their examples, and what stands between quotation marks.
fn source(content: &str) -> Vec<(usize, String)> {
    let mut in_code = false;
    let mut lines = Vec::new();
    for (number, line) in numbered(content) {
        let line = line.trim_start();
        let Some(prose) = line.strip_prefix("///").or_else(|| line.strip_prefix("//!")) else {
            in_code = false;
            if !line.starts_with("//") {
                let text = line.replace("\\\"", "");
                lines.extend(text.split('"').skip(1).step_by(2).map(|message| (number, message.to_owned())));
            }
            continue;
        };
        let is_fence = prose.trim_start().starts_with("```");
        in_code ^= is_fence;
        if !(in_code || is_fence) {
            lines.push((number, prose.to_owned()));
        }
    }
    lines
}

/// What stands behind `#`.
fn comments(content: &str) -> Vec<(usize, String)> {
    numbered(content)
        .filter_map(|(number, line)| Some((number, line.split_once('#')?.1.to_owned())))
        .collect()
}

fn numbered(content: &str) -> impl Iterator<Item = (usize, &str)> {
    content.lines().zip(1..).map(|(line, number)| (number, line))
}

#[test]
fn prose_is_what_stands_outside_of_code() {
    let page = Text::of("a.md", "one\n```\ntwo\n```\n    three\nfour\n");
    assert_eq!(page.lines, [(1, "one".to_owned()), (6, "four".to_owned())]);
    let source = Text::of(
        "a.rs",
        "//! one\nlet two = \"2\"; // three\n    /// ```\n    /// four\n    /// ```\n/// five\n",
    );
    assert_eq!(source.lines, [(1, " one".to_owned()), (2, "2".to_owned()), (6, " five".to_owned())]);
    assert_eq!(Text::of("a.toml", "key = 1 # one\nkey = 2\n").lines, [(1, " one".to_owned())]);
}
