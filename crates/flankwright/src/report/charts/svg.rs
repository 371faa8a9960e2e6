//! A small writer of SVG: shapes with few attributes, all text escaped, numbers in fixed form.

use std::fmt::Write;

use serde::Serialize;

use super::palette::{INK, MUTED};
use super::text::indices;

/// A finished chart: one `<svg>` element that can stand alone or inline in HTML. Only the charts make one, so that a
/// page can insert it as it is.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(transparent)]
pub struct Svg(String);

impl Svg {
    /// The `<svg>` element.
    pub fn as_str(&self) -> &str {
        &self.0
    }

    /// A file's content: XML declaration and the element.
    pub fn to_document(&self) -> String {
        format!("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n{}\n", self.0)
    }
}

impl std::fmt::Display for Svg {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.0)
    }
}

/// Text for XML and HTML, in content and in quoted attributes. Control characters, which XML forbids, become blanks.
pub(crate) fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len() + 8);
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            '\n' | '\t' => out.push(c),
            c if c.is_control() || c == '\u{fffe}' || c == '\u{ffff}' => out.push(' '),
            c => out.push(c),
        }
    }
    out
}

/// A line: colour, width, dash pattern ("" = solid).
#[derive(Clone, Copy)]
pub(crate) struct Stroke<'a> {
    pub(crate) color: &'a str,
    pub(crate) width: f64,
    pub(crate) dash: &'a str,
}

impl<'a> Stroke<'a> {
    pub(crate) const fn solid(color: &'a str, width: f64) -> Self {
        Self { color, width, dash: "" }
    }

    fn attributes(&self) -> String {
        let dash =
            if self.dash.is_empty() { String::new() } else { format!(" stroke-dasharray=\"{}\"", self.dash) };
        format!(" stroke=\"{}\" stroke-width=\"{}\"{dash}", self.color, place(self.width))
    }
}

/// Where a text hangs at its point.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Anchor {
    Start,
    Middle,
    End,
}

/// How a text looks.
#[derive(Clone, Copy)]
pub(crate) struct TextStyle {
    pub(crate) size: f64,
    pub(crate) anchor: Anchor,
    pub(crate) bold: bool,
    pub(crate) color: &'static str,
    /// Degrees clockwise about the point.
    pub(crate) turn: f64,
    /// White outline for labels that lie on lines.
    pub(crate) halo: bool,
}

impl TextStyle {
    pub(crate) const fn new(size: f64, anchor: Anchor) -> Self {
        Self { size, anchor, bold: false, color: INK, turn: 0.0, halo: false }
    }

    pub(crate) const fn bold(self) -> Self {
        Self { bold: true, ..self }
    }

    pub(crate) const fn muted(self) -> Self {
        Self { color: MUTED, ..self }
    }

    pub(crate) const fn turned(self, degrees: f64) -> Self {
        Self { turn: degrees, ..self }
    }

    pub(crate) const fn halo(self) -> Self {
        Self { halo: true, ..self }
    }
}

/// A chart in the making.
pub(crate) struct Canvas {
    width: f64,
    height: f64,
    title: String,
    body: String,
}

impl Canvas {
    pub(crate) fn new(width: f64, height: f64, title: &str) -> Self {
        Self { width, height, title: title.to_owned(), body: String::new() }
    }

    pub(crate) fn line(&mut self, a: [f64; 2], b: [f64; 2], stroke: Stroke) {
        let style = stroke.attributes();
        let _ = writeln!(
            self.body,
            "<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\"{style}/>",
            place(a[0]),
            place(a[1]),
            place(b[0]),
            place(b[1])
        );
    }

    pub(crate) fn rect(&mut self, corner: [f64; 2], size: [f64; 2], fill: &str, stroke: Option<Stroke>) {
        let style = stroke.map(|s| s.attributes()).unwrap_or_default();
        let _ = writeln!(
            self.body,
            "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{fill}\"{style}/>",
            place(corner[0]),
            place(corner[1]),
            place(size[0].max(0.0)),
            place(size[1].max(0.0))
        );
    }

    /// Several open lines in one element.
    pub(crate) fn polylines(&mut self, lines: &[Vec<[f64; 2]>], stroke: Stroke) {
        self.path(lines, false, "none", Some(stroke));
    }

    /// Closed loops filled by the even-odd rule.
    pub(crate) fn loops(&mut self, loops: &[Vec<[f64; 2]>], fill: &str, stroke: Option<Stroke>) {
        self.path(loops, true, fill, stroke);
    }

    fn path(&mut self, lines: &[Vec<[f64; 2]>], close: bool, fill: &str, stroke: Option<Stroke>) {
        if lines.iter().all(Vec::is_empty) {
            return;
        }
        self.body.push_str("<path d=\"");
        for line in lines {
            for (k, p) in line.iter().enumerate() {
                let command = if k == 0 { 'M' } else { 'L' };
                let _ = write!(self.body, "{command}{} {}", place(p[0]), place(p[1]));
            }
            if close && !line.is_empty() {
                self.body.push('Z');
            }
        }
        let style = stroke.map(|s| s.attributes()).unwrap_or_default();
        let rule = if close { " fill-rule=\"evenodd\"" } else { "" };
        let _ = writeln!(self.body, "\" fill=\"{fill}\"{rule}{style} stroke-linejoin=\"round\"/>");
    }

    pub(crate) fn disc(&mut self, centre: [f64; 2], radius: f64, fill: &str, stroke: Stroke) {
        let style = stroke.attributes();
        let _ = writeln!(
            self.body,
            "<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"{fill}\"{style}/>",
            place(centre[0]),
            place(centre[1]),
            place(radius)
        );
    }

    pub(crate) fn text(&mut self, at: [f64; 2], text: &str, style: TextStyle) {
        let anchor = match style.anchor {
            Anchor::Start => "",
            Anchor::Middle => " text-anchor=\"middle\"",
            Anchor::End => " text-anchor=\"end\"",
        };
        let weight = if style.bold { " font-weight=\"600\"" } else { "" };
        let (x, y) = (place(at[0]), place(at[1]));
        let turn = if style.turn == 0.0 {
            String::new()
        } else {
            format!(" transform=\"rotate({} {x} {y})\"", place(style.turn))
        };
        let halo = if style.halo {
            " paint-order=\"stroke\" stroke=\"#ffffff\" stroke-width=\"3\" stroke-linejoin=\"round\""
        } else {
            ""
        };
        let _ = writeln!(
            self.body,
            "<text x=\"{x}\" y=\"{y}\" font-size=\"{}\" fill=\"{}\"{anchor}{weight}{turn}{halo}>{}</text>",
            place(style.size),
            style.color,
            spans(text, style.size)
        );
    }

    /// Title and subtitle in the upper left corner.
    pub(crate) fn heading(&mut self, subtitle: &str) {
        let title = self.title.clone();
        self.text([0.0, 18.0], &title, TextStyle::new(15.0, Anchor::Start).bold());
        if !subtitle.is_empty() {
            self.text([0.0, 35.0], subtitle, TextStyle::new(12.0, Anchor::Start).muted());
        }
    }

    pub(crate) fn finish(self) -> Svg {
        let (width, height) = (place(self.width), place(self.height));
        let title = escape(&self.title);
        Svg(format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" \
             height=\"{height}\" role=\"img\" aria-label=\"{title}\" \
             font-family=\"Helvetica, Arial, 'Liberation Sans', sans-serif\">\n<title>{title}</title>\n\
             <rect width=\"{width}\" height=\"{height}\" fill=\"#ffffff\"/>\n{}</svg>",
            self.body
        ))
    }
}

/// Escaped text, indices of symbols smaller and below the line.
fn spans(text: &str, size: f64) -> String {
    let drop = 0.22 * size;
    let mut out = String::new();
    let mut lowered = false;
    for (piece, below) in indices(text) {
        let piece = escape(&piece);
        match (below, lowered) {
            (true, _) => {
                let (dy, small) = (place(drop), place(0.75 * size));
                let _ = write!(out, "<tspan dy=\"{dy}\" font-size=\"{small}\">{piece}</tspan>");
            }
            (false, true) => {
                let _ = write!(out, "<tspan dy=\"{}\">{piece}</tspan>", place(-drop));
            }
            (false, false) => out.push_str(&piece),
        }
        lowered = below;
    }
    out
}

/// A coordinate with at most two decimals and no needless zeros.
fn place(value: f64) -> String {
    let text = format!("{value:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}
