//! Light and dark stretches of a turn: a band that is wrapped on several lines, so that every stretch can be read.

use super::axes::TICK_SIZE;
use super::error::{ChartError, check_ascending, check_count, check_values};
use super::hatch::{Lean, hatch_lines};
use super::numbers::format_fixed;
use super::palette::{INK, MUTED};
use super::svg::{Anchor, Canvas, Stroke, Svg, TextStyle};
use super::text::text_width;

/// A strip of light and dark over one turn that is divided into cells of equal width.
#[derive(Clone, Debug, PartialEq)]
pub struct SignalStrip {
    /// Heading.
    pub title: String,
    /// Line below it.
    pub subtitle: String,
    /// Cells by ascending place.
    pub cells: Vec<StripCell>,
    /// What the k-th sign means.
    pub signs: Vec<String>,
}

/// A cell: a pitch of the turn.
#[derive(Clone, Debug, PartialEq)]
pub struct StripCell {
    /// Name below the strip.
    pub name: String,
    /// Middle, deg.
    pub middle_deg: f64,
    /// Dark stretch, ascending, deg; without one the cell is light.
    pub dark_deg: Option<[f64; 2]>,
    /// Which sign stands below it; its dark stretch is hatched instead of filled.
    pub sign: Option<usize>,
}

const WIDTH: f64 = 880.0;
/// Cells in a line at most.
const IN_LINE: usize = 15;
const TOP: f64 = 66.0;
const BAND: f64 = 26.0;
const LINE: f64 = 86.0;
const SMALL: f64 = 10.5;
const DARK: &str = "#4a5057";

/// Draws the strip.
///
/// # Errors
/// [`ChartError`] without cells, for middles or dark stretches that do not ascend, and for values that are not finite.
pub fn signal_strip(strip: &SignalStrip) -> Result<Svg, ChartError> {
    check(strip)?;
    let count = strip.cells.len();
    let lines = count.div_ceil(IN_LINE);
    let in_line = count.div_ceil(lines);
    let pitch_deg = 360.0 / count as f64;
    let width = WIDTH / in_line as f64;
    let mut canvas = Canvas::new(WIDTH, TOP + lines as f64 * LINE, &strip.title);
    canvas.heading(&strip.subtitle);
    draw_legend(&mut canvas, strip);
    for (number, cells) in strip.cells.chunks(in_line).enumerate() {
        let top = TOP + 18.0 + number as f64 * LINE;
        let Some(first) = cells.first() else { continue };
        let begin = first.middle_deg - 0.5 * pitch_deg;
        let right = width * cells.len() as f64;
        let line = LineOfCells { top, begin, scale: width / pitch_deg, right };
        canvas.rect([0.5, top], [right - 1.0, BAND], "#ffffff", Some(Stroke::solid(INK, 1.0)));
        for (k, cell) in cells.iter().enumerate() {
            line.draw(&mut canvas, cell, k as f64 * width, width);
        }
        let end = begin + cells.len() as f64 * pitch_deg;
        let angle = |degrees: f64| format!("{}°", format_fixed(degrees, 1));
        canvas.text([0.0, top - 5.0], &angle(begin), TextStyle::new(SMALL, Anchor::Start).muted());
        canvas.text([right, top - 5.0], &angle(end), TextStyle::new(SMALL, Anchor::End).muted());
    }
    Ok(canvas.finish())
}

fn check(strip: &SignalStrip) -> Result<(), ChartError> {
    check_count(&strip.title, strip.cells.len(), 1)?;
    let middles: Vec<f64> = strip.cells.iter().map(|cell| cell.middle_deg).collect();
    check_values("middles of the cells", &middles)?;
    check_ascending("middles of the cells", &middles)?;
    for cell in &strip.cells {
        if let Some(dark) = &cell.dark_deg {
            let quantity = format!("dark stretch {}", cell.name);
            check_values(&quantity, dark)?;
            check_ascending(&quantity, dark)?;
        }
    }
    Ok(())
}

/// A line of the wrapped strip.
struct LineOfCells {
    top: f64,
    begin: f64,
    /// Points per deg.
    scale: f64,
    right: f64,
}

impl LineOfCells {
    fn draw(&self, canvas: &mut Canvas, cell: &StripCell, left: f64, width: f64) {
        let foot = self.top + BAND;
        let middle = left + 0.5 * width;
        if let Some(dark) = cell.dark_deg {
            let [from, to] = dark.map(|at| ((at - self.begin) * self.scale).clamp(0.0, self.right));
            draw_dark(canvas, [from, self.top], [to - from, BAND], cell.sign.is_some());
        }
        canvas.line([middle, foot], [middle, foot + 4.0], Stroke::solid(INK, 0.9));
        let style = TextStyle::new(TICK_SIZE, Anchor::Middle);
        let style = if cell.sign.is_some() { style.bold() } else { style };
        canvas.text([middle, foot + 16.5], &cell.name, style);
        if let Some(sign) = cell.sign {
            draw_sign(canvas, sign, [middle, foot + 28.0]);
        }
    }
}

fn draw_dark(canvas: &mut Canvas, corner: [f64; 2], size: [f64; 2], hatched: bool) {
    let [x, y] = corner;
    let [right, bottom] = [x + size[0], y + size[1]];
    if hatched {
        let ring = vec![corner, [right, y], [right, bottom], [x, bottom], corner];
        canvas.polylines(&hatch_lines(&[ring], 5.0, Lean::Forward), Stroke::solid(INK, 1.1));
        canvas.rect(corner, size, "none", Some(Stroke::solid(INK, 1.2)));
    } else {
        canvas.rect(corner, size, DARK, None);
    }
}

/// A triangle, a cross, a square, and again.
fn draw_sign(canvas: &mut Canvas, sign: usize, [x, y]: [f64; 2]) {
    let r = 5.0;
    let stroke = Stroke::solid(INK, 1.5);
    match sign % 3 {
        0 => canvas.loops(&[vec![[x, y - r], [x + r, y + 0.8 * r], [x - r, y + 0.8 * r]]], INK, None),
        1 => {
            canvas.line([x - r, y - r], [x + r, y + r], stroke);
            canvas.line([x - r, y + r], [x + r, y - r], stroke);
        }
        _ => canvas.rect([x - 0.8 * r, y - 0.8 * r], [1.6 * r, 1.6 * r], "none", Some(stroke)),
    }
}

fn draw_legend(canvas: &mut Canvas, strip: &SignalStrip) {
    let mut x = 0.0;
    let y = 54.0;
    let mut name = |canvas: &mut Canvas, symbol: f64, text: &str| {
        canvas.text([x + symbol, y + 4.2], text, TextStyle::new(TICK_SIZE, Anchor::Start));
        x += symbol + text_width(text, TICK_SIZE) + 22.0;
        x
    };
    draw_dark(canvas, [0.0, y - 7.0], [26.0, 14.0], false);
    let mut at = name(canvas, 33.0, "dark: 0 signal");
    canvas.rect([at, y - 7.0], [26.0, 14.0], "#ffffff", Some(Stroke::solid(MUTED, 0.9)));
    at = name(canvas, 33.0, "light: L signal");
    for (k, text) in strip.signs.iter().enumerate() {
        draw_sign(canvas, k, [at + 6.0, y]);
        at = name(canvas, 17.0, text);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn strip(teeth: usize) -> SignalStrip {
        let pitch = 360.0 / teeth as f64;
        let cell = |k: usize| {
            let middle_deg = k as f64 * pitch;
            let dark = [middle_deg - 0.26 * pitch, middle_deg + 0.26 * pitch];
            let sign = if k == 7 { Some(1) } else { (k == 3).then_some(0) };
            StripCell { name: k.to_string(), middle_deg, dark_deg: (k != 7).then_some(dark), sign }
        };
        SignalStrip {
            title: "Signal".into(),
            subtitle: "middle track".into(),
            cells: (0..teeth).map(cell).collect(),
            signs: vec!["out of the band".into(), "broken".into()],
        }
    }

    #[test]
    fn every_tooth_has_its_number_and_its_dark_stretch() {
        let text = signal_strip(&strip(75)).unwrap().to_string();
        for k in 0..75 {
            assert!(text.contains(&format!(">{k}</text>")), "{k}");
        }
        let filled = text.matches(&format!("height=\"26\" fill=\"{DARK}\"")).count();
        assert_eq!(filled, 73, "all but the marked one and the broken one");
        // Five lines of fifteen.
        assert_eq!(text.matches("fill=\"#ffffff\" stroke=\"#1c1f23\"").count(), 5);
    }

    #[test]
    fn refuses_stretches_that_run_backwards_and_what_is_no_number() {
        let mut wrong = strip(10);
        wrong.cells[2].dark_deg = Some([3.0, 1.0]);
        assert_eq!(signal_strip(&wrong).unwrap_err().code(), "not-ascending");
        wrong.cells[2].dark_deg = Some([f64::NAN, 1.0]);
        assert_eq!(signal_strip(&wrong).unwrap_err().code(), "invalid-number");
        wrong.cells.clear();
        assert_eq!(signal_strip(&wrong).unwrap_err().code(), "too-few-values");
    }
}
