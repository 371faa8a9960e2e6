//! The text of an input and its name. Knows no format.

use std::path::{Component, Path, PathBuf};
use std::sync::Arc;

/// Name and text of an input. Cheap to clone.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Source {
    name: Arc<str>,
    text: Arc<str>,
    shelf: Option<Arc<Path>>,
}

impl Source {
    /// A text that is already in memory; `name` is what messages call it. A byte order mark is dropped.
    pub fn new(name: impl Into<Arc<str>>, text: &str) -> Self {
        Self { name: name.into(), text: text.strip_prefix('\u{feff}').unwrap_or(text).into(), shelf: None }
    }

    /// The same of somebody who must not name files of this machine: whatever it names is looked for in the folder `shelf` alone.
    pub fn confined_to(self, shelf: &Path) -> Self {
        Self { shelf: Some(shelf.into()), ..self }
    }

    /// The folder to which the input is confined, if it is.
    pub fn shelf(&self) -> Option<&Path> {
        self.shelf.as_deref()
    }

    /// The path of a file that the input names: beside the input unless absolute. On a shelf, steps out of it lead nowhere: `/a/b` and
    /// `../a/b` are `a/b` of the shelf.
    pub fn beside(&self, file: &str) -> PathBuf {
        match &self.shelf {
            Some(shelf) => {
                let inner = Path::new(file).components().filter(|step| matches!(step, Component::Normal(_)));
                shelf.join(inner.collect::<PathBuf>())
            }
            None => Path::new(&*self.name)
                .parent()
                .map_or_else(|| PathBuf::from(file), |folder| folder.join(file)),
        }
    }

    /// What messages call the input: the path as given.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The whole text, without byte order mark.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Line and column (in characters), both from 1, of a byte offset.
    pub fn line_column(&self, offset: usize) -> (usize, usize) {
        let mut offset = offset.min(self.text.len());
        while !self.text.is_char_boundary(offset) {
            offset -= 1;
        }
        let before = &self.text[..offset];
        let line_start = before.rfind('\n').map_or(0, |i| i + 1);
        (1 + before.bytes().filter(|&b| b == b'\n').count(), 1 + before[line_start..].chars().count())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_that_is_named_on_a_shelf_lies_outside_of_it() {
        let confined = Source::new("job.toml", "").confined_to(Path::new("/shelf"));
        let inside = [
            ("grid.csv", "/shelf/grid.csv"),
            ("machines/mill.toml", "/shelf/machines/mill.toml"),
            ("../../machines/mill.toml", "/shelf/machines/mill.toml"),
            ("/etc/passwd", "/shelf/etc/passwd"),
            ("a/../../b", "/shelf/a/b"),
            ("..", "/shelf"),
            ("", "/shelf"),
        ];
        for (named, found) in inside {
            assert_eq!(confined.beside(named), Path::new(found), "{named}");
        }
        let free = Source::new("jobs/job.toml", "");
        assert_eq!(free.beside("../grid.csv"), Path::new("jobs/../grid.csv"));
        assert_eq!(free.beside("/grid.csv"), Path::new("/grid.csv"));
    }

    #[test]
    fn lines_and_columns_count_characters() {
        let source = Source::new("x", "a = 1\nµm = 2\n");
        assert_eq!(source.line_column(0), (1, 1));
        assert_eq!(source.line_column(6), (2, 1));
        assert_eq!(source.line_column(8), (2, 2));
        assert_eq!(source.line_column(usize::MAX), (3, 1));
    }
}
