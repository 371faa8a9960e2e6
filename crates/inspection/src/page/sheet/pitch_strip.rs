//! A strip over the teeth of a revolution: bars, lines with gaps, a marked sector.

use super::book::{Book, GRID, LABEL, LIMIT, THIN, centred};
use report::charts::magnification::drawn;
use report::charts::{FAINT, MUTED, Stroke};

/// Most teeth that get bars.
const BARS: usize = 150;

/// Where a strip lies on the page.
#[derive(Clone, Copy, Debug)]
pub(super) struct Strip {
    /// Left border.
    pub left: f64,
    /// Top.
    pub top: f64,
    /// Width.
    pub width: f64,
    /// Height.
    pub height: f64,
    /// Teeth of the revolution.
    pub teeth: usize,
}

impl Strip {
    /// y of zero.
    pub fn middle(&self) -> f64 {
        self.top + 0.5 * self.height
    }

    /// x of a tooth.
    pub fn x(&self, tooth: f64) -> f64 {
        self.left + self.width * (tooth - 0.5) / self.teeth.max(1) as f64
    }

    /// Its border.
    pub fn frame(&self, book: &mut Book) {
        book.page().rect([self.left, self.top], [self.width, self.height], "none", Some(GRID));
    }

    /// The line of zero.
    pub fn zero(&self, book: &mut Book) {
        let y = self.middle();
        book.page().line([self.left, y], [self.left + self.width, y], THIN);
    }

    fn y(&self, um: f64, magnification: f64) -> f64 {
        self.middle() - drawn(um, magnification)
    }
}

/// Bars from zero, tooth 1 first; a thin line for too many of them.
pub(super) fn draw_bars(book: &mut Book, strip: &Strip, values: &[f64], magnification: f64) {
    if values.len() > BARS {
        draw_line(book, strip, values, magnification, Stroke::solid(MUTED, 0.13));
        return;
    }
    let half = 0.35 * strip.width / strip.teeth.max(1) as f64;
    let zero = strip.middle();
    let measured = values.iter().enumerate().filter(|(_, v)| v.is_finite());
    let bars: Vec<Vec<[f64; 2]>> = measured
        .map(|(k, &value)| {
            let (x, y) = (strip.x((k + 1) as f64), strip.y(value, magnification));
            vec![[x - half, zero], [x - half, y], [x + half, y], [x + half, zero]]
        })
        .collect();
    book.page().loops(&bars, FAINT, Some(THIN));
}

/// A line over the teeth, tooth 1 first, with gaps where there is no value.
pub(super) fn draw_line(book: &mut Book, strip: &Strip, values: &[f64], magnification: f64, stroke: Stroke) {
    let mut lines: Vec<Vec<[f64; 2]>> = vec![Vec::new()];
    for (k, &value) in values.iter().enumerate() {
        if value.is_finite() {
            let at = [strip.x((k + 1) as f64), strip.y(value, magnification)];
            if let Some(line) = lines.last_mut() {
                line.push(at);
            }
        } else {
            lines.push(Vec::new());
        }
    }
    book.page().polylines(&lines, stroke);
}

/// The worst sector: a bracket at the lower border, in two parts where it passes the last tooth.
pub(super) fn draw_sector(book: &mut Book, strip: &Strip, [pitches, behind]: [usize; 2]) {
    let y = strip.top + strip.height - 0.5;
    let end = behind + pitches;
    let parts = if end <= strip.teeth {
        vec![[behind, end]]
    } else {
        vec![[behind, strip.teeth], [0, end - strip.teeth]]
    };
    // Deviations at the ends of the sector are those of the teeth there; tooth 0 is the last one.
    for [from, to] in parts {
        let [a, b] = [from, to].map(|tooth| strip.x(tooth as f64).max(strip.left));
        book.page().line([a, y], [b, y], LIMIT);
        for (tooth, x) in [(from, a), (to, b)] {
            if tooth == behind || tooth + strip.teeth == end || tooth == end {
                book.page().line([x, y], [x, strip.top], Stroke { dash: "0.6 0.9", ..GRID });
                book.page().line([x, y], [x, y - 1.4], LIMIT);
            }
        }
    }
    let wide = if end <= strip.teeth || strip.teeth - behind >= pitches / 2 {
        0.5 * (strip.x(behind as f64).max(strip.left) + strip.x(end.min(strip.teeth) as f64))
    } else {
        0.5 * (strip.left + strip.x((end - strip.teeth) as f64))
    };
    let middle = wide.clamp(strip.left + 4.0, strip.left + strip.width - 4.0);
    book.text([middle, y - 0.6], &format!("k = {pitches}"), centred(0.9 * LABEL));
}

/// Teeth whose numbers are printed: the first, round ones, the last.
pub(super) fn tooth_steps(teeth: usize) -> Vec<usize> {
    let step =
        [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000].into_iter().find(|step| teeth <= 25 * step);
    let step = step.unwrap_or(10_000);
    let round = (1..).map(|k| k * step).take_while(|tooth| tooth + step / 2 < teeth && *tooth < teeth);
    let mut steps: Vec<usize> = [1].into_iter().chain(round.filter(|tooth| *tooth > 1)).collect();
    if teeth > 1 {
        steps.push(teeth);
    }
    steps
}

#[cfg(test)]
mod tests {
    use super::tooth_steps;

    #[test]
    fn first_and_last_tooth_are_always_told() {
        assert_eq!(tooth_steps(1), [1]);
        assert_eq!(tooth_steps(5), [1, 2, 3, 4, 5]);
        assert_eq!(tooth_steps(27), [1, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 27]);
        for teeth in 1..3000 {
            let steps = tooth_steps(teeth);
            assert!(steps[0] == 1 && steps.last() == Some(&teeth) && steps.len() <= 27, "{teeth}: {steps:?}");
            assert!(steps.windows(2).all(|pair| pair[0] < pair[1]), "{teeth}: {steps:?}");
        }
    }
}
