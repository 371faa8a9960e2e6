//! A small writer of SVG: shapes with few attributes, all text escaped, numbers in fixed form.

use std::fmt::Write;
use std::ops::Range;

use serde::Serialize;

use super::palette::{INK, MUTED};
use super::text::indices;
use crate::typeset::unit;

/// A finished chart: one `<svg>` element that can stand alone or inline in HTML. Only the charts make one, so that a
/// page can insert it as it is.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(transparent)]
pub struct Svg {
    element: String,
    #[serde(skip)]
    title: String,
    /// Where texts stand in the element, in their order.
    #[serde(skip)]
    texts: Vec<PlacedText>,
}

/// A text in a picture.
#[derive(Clone, Debug, PartialEq, Eq)]
struct PlacedText {
    /// Its bytes in the element.
    place: Range<usize>,
    /// The text itself.
    text: String,
    /// How its indices are set, by the size of its letters; `None` for the title, which has none.
    set: Option<Spans>,
}

impl Svg {
    /// The `<svg>` element.
    pub fn as_str(&self) -> &str {
        &self.element
    }

    /// What the chart shows.
    pub fn title(&self) -> &str {
        &self.title
    }

    /// The texts in it, without its title and those that stand as a file or a job has them.
    pub fn texts(&self) -> impl Iterator<Item = &str> {
        self.texts.iter().filter(|text| text.set.is_some()).map(|text| text.text.as_str())
    }

    /// The same picture with other texts: each as `say` says it.
    pub(crate) fn said(&self, say: impl Fn(&str) -> String) -> Self {
        let mut element = String::with_capacity(self.element.len() + 256);
        let mut texts = Vec::with_capacity(self.texts.len());
        let mut at = 0;
        for PlacedText { place, text, set } in &self.texts {
            element += &self.element[at..place.start];
            let start = element.len();
            let text = say(text);
            element += &set.map_or_else(|| escape(&text), |set| set.of(&text));
            texts.push(PlacedText { place: start..element.len(), text, set: *set });
            at = place.end;
        }
        element += &self.element[at..];
        Self { element, title: say(&self.title), texts }
    }

    /// A file's content: XML declaration and the element.
    pub fn to_document(&self) -> String {
        format!("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n{}\n", self.element)
    }
}

impl std::fmt::Display for Svg {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.element)
    }
}

/// Text for XML and HTML, in content and in quoted attributes. Control characters, which XML forbids, become blanks.
pub fn escape(text: &str) -> String {
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
pub struct Stroke<'a> {
    /// Colour.
    pub color: &'a str,
    /// Width in units of the picture.
    pub width: f64,
    /// Dashes as SVG has them; empty for a solid line.
    pub dash: &'a str,
}

impl<'a> Stroke<'a> {
    /// A line without dashes.
    pub const fn solid(color: &'a str, width: f64) -> Self {
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
pub enum Anchor {
    /// The text begins at its place.
    Start,
    /// The text is centred on its place.
    Middle,
    /// The text ends at its place.
    End,
}

/// How a text looks.
#[derive(Clone, Copy)]
pub struct TextStyle {
    /// Height of the letters in units of the picture.
    pub size: f64,
    /// Which part of the text stands at its place.
    pub anchor: Anchor,
    /// Whether it is bold.
    pub bold: bool,
    /// Colour.
    pub color: &'static str,
    /// Degrees clockwise about the point.
    pub turn: f64,
    /// White outline for labels that lie on lines.
    pub halo: bool,
    /// Underscores stay what they are: texts of files, not symbols with indices.
    pub verbatim: bool,
}

impl TextStyle {
    /// Plain text of this size.
    pub const fn new(size: f64, anchor: Anchor) -> Self {
        Self { size, anchor, bold: false, color: INK, turn: 0.0, halo: false, verbatim: false }
    }

    /// The same, bold.
    pub const fn bold(self) -> Self {
        Self { bold: true, ..self }
    }

    /// The same in a fainter colour.
    pub const fn muted(self) -> Self {
        Self { color: MUTED, ..self }
    }

    /// The same, turned about its place.
    pub const fn turned(self, degrees: f64) -> Self {
        Self { turn: degrees, ..self }
    }

    /// The same on a rim of the background.
    pub const fn halo(self) -> Self {
        Self { halo: true, ..self }
    }

    /// The same without indices: `_` stays as it is.
    pub const fn verbatim(self) -> Self {
        Self { verbatim: true, ..self }
    }
}

/// A chart in the making.
pub struct Canvas {
    width: f64,
    height: f64,
    /// Unit of the size of the whole; empty for points.
    unit: &'static str,
    title: String,
    body: String,
    /// Texts with their places in the body.
    texts: Vec<PlacedText>,
}

impl Canvas {
    /// An empty picture of this size; the title is its name for screen readers.
    pub fn new(width: f64, height: f64, title: &str) -> Self {
        Self { width, height, unit: "", title: title.to_owned(), body: String::new(), texts: Vec::new() }
    }

    /// A page whose unit is the millimetre.
    pub fn millimetres(width: f64, height: f64, title: &str) -> Self {
        Self { unit: "mm", body: String::with_capacity(1 << 16), ..Self::new(width, height, title) }
    }

    /// Draws a line.
    pub fn line(&mut self, a: [f64; 2], b: [f64; 2], stroke: Stroke) {
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

    /// Draws a rectangle.
    pub fn rect(&mut self, corner: [f64; 2], size: [f64; 2], fill: &str, stroke: Option<Stroke>) {
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
    pub fn polylines(&mut self, lines: &[Vec<[f64; 2]>], stroke: Stroke) {
        self.path(lines, false, "none", Some(stroke));
    }

    /// Closed loops filled by the even-odd rule.
    pub fn loops(&mut self, loops: &[Vec<[f64; 2]>], fill: &str, stroke: Option<Stroke>) {
        self.path(loops, true, fill, stroke);
    }

    fn path(&mut self, lines: &[Vec<[f64; 2]>], close: bool, fill: &str, stroke: Option<Stroke>) {
        if lines.iter().all(Vec::is_empty) {
            return;
        }
        self.body.push_str("<path d=\"");
        for line in lines {
            for (k, p) in line.iter().enumerate() {
                self.body.push(if k == 0 { 'M' } else { 'L' });
                push_place(&mut self.body, p[0]);
                self.body.push(' ');
                push_place(&mut self.body, p[1]);
            }
            if close && !line.is_empty() {
                self.body.push('Z');
            }
        }
        let style = stroke.map(|s| s.attributes()).unwrap_or_default();
        let rule = if close { " fill-rule=\"evenodd\"" } else { "" };
        let _ = writeln!(self.body, "\" fill=\"{fill}\"{rule}{style} stroke-linejoin=\"round\"/>");
    }

    /// Draws a disc.
    pub fn disc(&mut self, centre: [f64; 2], radius: f64, fill: &str, stroke: Stroke) {
        let style = stroke.attributes();
        let _ = writeln!(
            self.body,
            "<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"{fill}\"{style}/>",
            place(centre[0]),
            place(centre[1]),
            place(radius)
        );
    }

    /// Writes a text.
    pub fn text(&mut self, at: [f64; 2], text: &str, style: TextStyle) {
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
        let _ = write!(
            self.body,
            "<text x=\"{x}\" y=\"{y}\" font-size=\"{}\" fill=\"{}\"{anchor}{weight}{turn}{halo}>",
            place(style.size),
            style.color,
        );
        let start = self.body.len();
        if style.verbatim {
            self.body += &escape(text);
        } else {
            let set = Spans::of_size(style.size);
            let text = &with_printed_units(text);
            self.body += &set.of(text);
            self.texts.push(PlacedText {
                place: start..self.body.len(),
                text: text.to_owned(),
                set: Some(set),
            });
        }
        self.body += "</text>\n";
    }

    /// Title and subtitle in the upper left corner.
    pub fn heading(&mut self, subtitle: &str) {
        let title = self.title.clone();
        self.text([0.0, 18.0], &title, TextStyle::new(15.0, Anchor::Start).bold());
        if !subtitle.is_empty() {
            self.text([0.0, 35.0], subtitle, TextStyle::new(12.0, Anchor::Start).muted());
        }
    }

    /// The finished picture.
    pub fn finish(self) -> Svg {
        let (width, height, unit) = (place(self.width), place(self.height), self.unit);
        let title = escape(&self.title);
        let mut element = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" \
             width=\"{width}{unit}\" height=\"{height}{unit}\" role=\"img\" aria-label=\""
        );
        let mut texts = Vec::with_capacity(self.texts.len() + 2);
        let mut write_title = |element: &mut String| {
            let start = element.len();
            *element += &title;
            texts.push(PlacedText { place: start..element.len(), text: self.title.clone(), set: None });
        };
        write_title(&mut element);
        element += "\" font-family=\"Helvetica, Arial, 'Liberation Sans', sans-serif\">\n<title>";
        write_title(&mut element);
        let _ = writeln!(element, "</title>\n<rect width=\"{width}\" height=\"{height}\" fill=\"#ffffff\"/>");
        let shift = element.len();
        texts.extend(
            self.texts
                .into_iter()
                .map(|text| PlacedText { place: text.place.start + shift..text.place.end + shift, ..text }),
        );
        element += &self.body;
        element += "</svg>";
        Svg { element, title: self.title, texts }
    }
}

/// Titles of axes with their units as they are printed.
fn with_printed_units(text: &str) -> String {
    let Some((before, rest)) = text.rsplit_once('[') else { return text.to_owned() };
    let Some((inside, after)) = rest.split_once(']') else { return text.to_owned() };
    format!("{before}[{}]{after}", unit(inside))
}

/// How indices of a text are set: smaller and below the line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Spans {
    /// Size of the letters, hundredths.
    size: i64,
}

impl Spans {
    fn of_size(size: f64) -> Self {
        Self { size: (size * 100.0).round() as i64 }
    }

    /// Escaped text with its indices.
    fn of(self, text: &str) -> String {
        if !text.contains('_') {
            return escape(text);
        }
        let size = self.size as f64 / 100.0;
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
}

/// A coordinate with at most two decimals and no needless zeros.
fn place(value: f64) -> String {
    let mut text = String::with_capacity(8);
    push_place(&mut text, value);
    text
}

/// Appends a coordinate. Long lines are mostly coordinates, hence not by the general formatter where that can be avoided.
fn push_place(out: &mut String, value: f64) {
    let hundredths = value * 100.0;
    let whole = hundredths.round();
    // Near a tie the product may be rounded to the wrong side, and beyond some size it has no such digits.
    let certain = whole.abs() < 1e9 && (hundredths - whole).abs() < 0.499_999;
    if !certain {
        let text = format!("{value:.2}");
        let text = text.trim_end_matches('0').trim_end_matches('.');
        out.push_str(if text == "-0" { "0" } else { text });
        return;
    }
    let number = whole as i64;
    if number < 0 {
        out.push('-');
    }
    let (units, rest) = (number.unsigned_abs() / 100, number.unsigned_abs() % 100);
    let mut digits = [0_u8; 20];
    let mut from = digits.len();
    let mut left = units;
    loop {
        from -= 1;
        digits[from] = b'0' + (left % 10) as u8;
        left /= 10;
        if left == 0 {
            break;
        }
    }
    out.extend(digits[from..].iter().map(|digit| char::from(*digit)));
    if rest > 0 {
        out.push('.');
        out.push(char::from(b'0' + (rest / 10) as u8));
        if rest % 10 > 0 {
            out.push(char::from(b'0' + (rest % 10) as u8));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::place;

    #[test]
    fn coordinates_are_those_of_the_general_formatter() {
        let general = |value: f64| {
            let text = format!("{value:.2}");
            let text = text.trim_end_matches('0').trim_end_matches('.');
            if text == "-0" { "0".to_owned() } else { text.to_owned() }
        };
        let ties = [0.125, -0.125, 0.005, 1.005, -2.675, 0.375, 1e7 + 0.125, 0.115, 0.145];
        let sizes =
            [0.0, -0.0, -0.001, 0.1, -0.05, 100.0, 1e9, -1e12, 1e22, 9_999_999.994_999, 0.004_999_999];
        let spread = (0..4000).map(|k| (f64::from(k) * 0.37).sin() * 10f64.powi(k % 9 - 3));
        for value in ties.into_iter().chain(sizes).chain(spread) {
            assert_eq!(place(value), general(value), "{value}");
        }
    }
}
