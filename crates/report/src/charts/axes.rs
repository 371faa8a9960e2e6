//! A plot rectangle with its axes: frame, grid lines, tick labels without overlap, titles with units.

use super::palette::{FAINT, GRID, INK};
use super::scale::Axis;
use super::svg::{Anchor, Canvas, Stroke, TextStyle};
use super::text::text_width;

/// Size of tick labels.
pub const TICK_SIZE: f64 = 12.0;

/// The rectangle that data are drawn in.
#[derive(Clone, Copy, Debug)]
pub struct Frame {
    pub left: f64,
    pub top: f64,
    pub width: f64,
    pub height: f64,
}

impl Frame {
    pub fn right(&self) -> f64 {
        self.left + self.width
    }

    pub fn bottom(&self) -> f64 {
        self.top + self.height
    }

    /// The place of a point given by its shares of both axes.
    pub fn at(&self, x_share: f64, y_share: f64) -> [f64; 2] {
        [self.left + x_share * self.width, self.bottom() - y_share * self.height]
    }

    pub fn outline(&self, canvas: &mut Canvas) {
        let stroke = Stroke::solid(INK, 0.9);
        canvas.rect([self.left, self.top], [self.width, self.height], "none", Some(stroke));
    }

    /// Light lines at the ticks, drawn before the data.
    pub fn grid(&self, canvas: &mut Canvas, x: &Axis, y: &Axis) {
        let stroke = Stroke::solid(GRID, 0.8);
        for (share, _) in x.ticks() {
            canvas.line(self.at(share, 0.0), self.at(share, 1.0), stroke);
        }
        for (share, _) in y.ticks() {
            canvas.line(self.at(0.0, share), self.at(1.0, share), stroke);
        }
    }

    /// A line at zero, if zero is on the ordinate.
    pub fn zero_line(&self, canvas: &mut Canvas, y: &Axis) {
        let share = y.share(0.0);
        if share > 1e-9 && share < 1.0 - 1e-9 {
            canvas.line(self.at(0.0, share), self.at(1.0, share), Stroke::solid(FAINT, 1.3));
        }
    }

    /// Ticks and labels of the abscissa below the frame, with its title unless that is empty.
    pub fn abscissa(&self, canvas: &mut Canvas, axis: &Axis, title: &str) {
        let style = TextStyle::new(TICK_SIZE, Anchor::Middle);
        let mut free_from = f64::NEG_INFINITY;
        for (share, label) in axis.ticks() {
            let [x, y] = self.at(share, 0.0);
            canvas.line([x, y], [x, y + 4.0], Stroke::solid(INK, 0.9));
            let half = 0.5 * text_width(&label, TICK_SIZE);
            if x - half >= free_from {
                canvas.text([x, y + 16.5], &label, style);
                free_from = x + half + 6.0;
            }
        }
        if !title.is_empty() {
            let title = with_factor(title, axis);
            let style = TextStyle::new(TICK_SIZE, Anchor::Middle);
            canvas.text([self.left + 0.5 * self.width, self.bottom() + 33.0], &title, style);
        }
    }

    /// Ticks and labels of the ordinate on the left.
    pub fn ordinate(&self, canvas: &mut Canvas, axis: &Axis) {
        let mut free_below = f64::INFINITY;
        for (share, label) in axis.ticks() {
            let [x, y] = self.at(0.0, share);
            canvas.line([x - 4.0, y], [x, y], Stroke::solid(INK, 0.9));
            if y + 0.5 * TICK_SIZE <= free_below {
                canvas.text([x - 7.0, y + 4.2], &label, TextStyle::new(TICK_SIZE, Anchor::End));
                free_below = y - 0.5 * TICK_SIZE - 2.0;
            }
        }
    }

    /// Title of the ordinate, upright beside it, `distance` left of the frame.
    pub fn ordinate_title(&self, canvas: &mut Canvas, axis: &Axis, title: &str, distance: f64) {
        let at = [self.left - distance, self.top + 0.5 * self.height];
        canvas.text(at, &with_factor(title, axis), TextStyle::new(TICK_SIZE, Anchor::Middle).turned(-90.0));
    }
}

/// The axis title with the power of ten that was taken out of its labels.
pub fn with_factor(title: &str, axis: &Axis) -> String {
    match axis.factor() {
        None => title.to_owned(),
        Some(factor) => format!("{title} {factor}"),
    }
}

/// A vertical bar that stands for a length, with its label to the right (or left).
pub fn vertical_bar(canvas: &mut Canvas, x: f64, top: f64, length: f64, label: &str) {
    let stroke = Stroke::solid(INK, 1.4);
    canvas.line([x, top], [x, top + length], stroke);
    for y in [top, top + length] {
        canvas.line([x - 4.0, y], [x + 4.0, y], stroke);
    }
    canvas.text([x + 8.0, top + 0.5 * length + 4.2], label, TextStyle::new(TICK_SIZE, Anchor::Start));
}

/// A horizontal bar that stands for a length, with its label to the right.
pub fn horizontal_bar(canvas: &mut Canvas, left: f64, y: f64, length: f64, label: &str) {
    let stroke = Stroke::solid(INK, 1.4);
    canvas.line([left, y], [left + length, y], stroke);
    for x in [left, left + length] {
        canvas.line([x, y - 4.0], [x, y + 4.0], stroke);
    }
    canvas.text([left + length + 8.0, y + 4.2], label, TextStyle::new(TICK_SIZE, Anchor::Start));
}
