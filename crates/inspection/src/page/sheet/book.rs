//! The pages of a sheet in the making, their lines and texts in millimetres, and the remarks that found no room.

use super::text_fit::{beginning, fitting_size};
use report::Language;
use report::charts::{Anchor, Canvas, INK, MUTED, Stroke, TextStyle, text_width};
use std::borrow::Cow;

/// Size of a page.
pub(super) const PAGE: [f64; 2] = [210.0, 297.0];
/// Room around what is drawn.
pub(super) const MARGIN: f64 = 10.0;
/// Width of what is drawn.
pub(super) const WIDTH: f64 = PAGE[0] - 2.0 * MARGIN;
/// Bottom of what is drawn.
pub(super) const BOTTOM: f64 = PAGE[1] - MARGIN;

/// Size of texts.
pub(super) const TEXT: f64 = 2.5;
/// Size of labels.
pub(super) const LABEL: f64 = 2.0;
/// Words of files are set no smaller than this.
const SMALLEST: f64 = 1.7;

/// Traces.
pub(super) const TRACE: Stroke = Stroke::solid(INK, 0.25);
/// Frames, axes, mean lines.
pub(super) const THIN: Stroke = Stroke::solid(INK, 0.13);
/// Grid.
pub(super) const GRID: Stroke = Stroke::solid(MUTED, 0.13);
/// Limits.
pub(super) const LIMIT: Stroke = Stroke::solid(INK, 0.35);
/// Limits of zones of relief.
pub(super) const DASHED_LIMIT: Stroke = Stroke { color: INK, width: 0.35, dash: "2 1.2" };
/// What an eccentricity makes of a line.
pub(super) const DASHED: Stroke = Stroke { color: INK, width: 0.18, dash: "1.2 0.8" };

/// Pages and remarks.
pub(super) struct Book {
    title: String,
    language: Language,
    pages: Vec<(String, Canvas)>,
    remarks: Vec<String>,
}

impl Book {
    /// Without a page.
    pub fn new(title: &str, language: Language) -> Self {
        Self { title: title.to_owned(), language, pages: Vec::new(), remarks: Vec::new() }
    }

    /// A text of the sheet itself in its language.
    pub fn say<'a>(&self, text: &'a str) -> Cow<'a, str> {
        self.language.say(text)
    }

    /// A text of the sheet itself.
    pub fn text(&mut self, at: [f64; 2], text: &str, style: TextStyle) {
        let said = self.say(text).into_owned();
        self.page().text(at, &said, style);
    }

    /// Begins a page.
    pub fn turn(&mut self, name: &str) {
        let title = format!("{} {}, {}", self.say("Inspection sheet"), self.title, self.say(name));
        self.pages.push((name.to_owned(), Canvas::millimetres(PAGE[0], PAGE[1], &title)));
    }

    /// The page that is being drawn.
    pub fn page(&mut self) -> &mut Canvas {
        if self.pages.is_empty() {
            self.turn("page");
        }
        let last = self.pages.len() - 1;
        &mut self.pages[last].1
    }

    /// Pages with their names.
    pub fn into_pages(self) -> Vec<(String, Canvas)> {
        self.pages
    }

    /// Keeps a text that finds no room; returns the mark that stands for it. The same text has one mark.
    pub fn remark(&mut self, text: String) -> String {
        let place = self.remarks.iter().position(|known| *known == text);
        let place = place.unwrap_or_else(|| {
            self.remarks.push(text);
            self.remarks.len() - 1
        });
        format!("[R{}]", place + 1)
    }

    /// The remarks so far.
    pub fn remarks(&self) -> &[String] {
        &self.remarks
    }

    /// A text of the sheet itself or a number: set smaller where it would be too wide, never cut.
    pub fn fitted(&mut self, at: [f64; 2], width: f64, text: &str, style: TextStyle) {
        let text = self.say(text).into_owned();
        let size = fitting_size(&text, style.size, width);
        self.page().text(at, &text, TextStyle { size, ..style });
    }

    /// Words of a file: set smaller, and where that does not do, their beginning with the mark of a remark that holds all of it.
    pub fn words(&mut self, at: [f64; 2], width: f64, [label, text]: [&str; 2], style: TextStyle) {
        let size = fitting_size(text, style.size, width);
        if size >= SMALLEST {
            self.page().text(at, text, TextStyle { size, ..style }.verbatim());
            return;
        }
        let whole = format!("{}: {text}", self.say(label));
        let mark = format!(" {}", self.remark(whole));
        let room = width - text_width(&mark, style.size);
        let short = beginning(text, style.size, room) + &mark;
        self.page().text(at, &short, style.verbatim());
    }
}

/// A text that begins at its point.
pub(super) const fn from_left(size: f64) -> TextStyle {
    TextStyle::new(size, Anchor::Start)
}

/// A text about its point.
pub(super) const fn centred(size: f64) -> TextStyle {
    TextStyle::new(size, Anchor::Middle)
}

/// A text that ends at its point.
pub(super) const fn from_right(size: f64) -> TextStyle {
    TextStyle::new(size, Anchor::End)
}
