//! How wide a text will be: an estimate from the proportions of Helvetica, enough to keep labels apart.

/// Width of a text set at `size`, in the unit of `size`.
pub(crate) fn text_width(text: &str, size: f64) -> f64 {
    size * text.chars().map(share_of_em).sum::<f64>()
}

fn share_of_em(c: char) -> f64 {
    match c {
        'i' | 'j' | 'l' | '\'' | '|' => 0.23,
        ' ' | '.' | ',' | ':' | ';' | 'I' | 'f' | 't' | '/' | '!' | '[' | ']' | '·' => 0.29,
        '(' | ')' | '-' | 'r' | '⁰'..='⁹' | '¹' | '²' | '³' | '⁻' => 0.35,
        'm' | 'w' | 'M' | 'W' | '%' => 0.86,
        'A'..='Z' => 0.69,
        _ => 0.57,
    }
}

/// A rectangle that a label occupies; labels that would overlap an earlier one are left out or moved.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Area {
    pub(crate) x: f64,
    pub(crate) y: f64,
    pub(crate) width: f64,
    pub(crate) height: f64,
}

impl Area {
    /// The area around a centre.
    pub(crate) fn around(x: f64, y: f64, width: f64, height: f64) -> Self {
        Self { x: x - 0.5 * width, y: y - 0.5 * height, width, height }
    }

    pub(crate) fn overlaps(&self, other: &Area) -> bool {
        self.x < other.x + other.width
            && other.x < self.x + self.width
            && self.y < other.y + other.height
            && other.y < self.y + self.height
    }

    pub(crate) fn contains(&self, other: &Area) -> bool {
        other.x >= self.x
            && other.y >= self.y
            && other.x + other.width <= self.x + self.width
            && other.y + other.height <= self.y + self.height
    }
}
