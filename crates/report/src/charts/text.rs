//! Text in charts and pages: symbols with indices, and how wide a text will be (an estimate from the proportions of
//! Helvetica, enough to keep labels apart).

/// Width of a text set at `size`, in the unit of `size`.
pub fn text_width(text: &str, size: f64) -> f64 {
    size * text.chars().map(share_of_em).sum::<f64>()
}

fn share_of_em(c: char) -> f64 {
    match c {
        'i' | 'j' | 'l' | '\'' | '|' => 0.23,
        ' ' | '.' | ',' | ':' | ';' | 'I' | 'f' | 't' | '/' | '!' | '[' | ']' | '·' => 0.29,
        '(' | ')' | '-' | 'r' | '⁰'..='⁹' | '¹' | '²' | '³' | '⁻' => 0.35,
        'm' | 'w' | 'M' | 'W' | '%' => 0.86,
        'A'..='Z' => 0.69,
        '\u{1100}'..='\u{115f}' | '\u{2e80}'..='\u{a4cf}' | '\u{ac00}'..='\u{d7a3}' => 1.0,
        '\u{f900}'..='\u{faff}' | '\u{fe30}'..='\u{fe6f}' | '\u{ff00}'..='\u{ff60}' => 1.0,
        '\u{1f000}'..='\u{3ffff}' => 1.2,
        _ => 0.57,
    }
}

/// Splits a text at the indices of its symbols: pieces and whether they stand below the line. A symbol is one or two
/// letters, with an apostrophe or without (`Q'_w`), an underscore and up to four letters or digits (`C_Hα`, `z_V2`); any other underscore stays as it is, so
/// that names of files survive.
pub fn indices(text: &str) -> Vec<(String, bool)> {
    let chars: Vec<char> = text.chars().collect();
    let mut pieces: Vec<(String, bool)> = vec![(String::new(), false)];
    let mut k = 0;
    while k < chars.len() {
        let before =
            chars[..k].iter().rev().take_while(|c| c.is_alphanumeric() || "_'".contains(**c)).count();
        let after = chars[k + 1..].iter().take_while(|c| c.is_alphanumeric() || **c == '_').count();
        let index = &chars[(k + 1).min(chars.len())..k + 1 + after];
        let symbol = &chars[k - before..k];
        if chars[k] == '_'
            && (1..=2).contains(&symbol.iter().filter(|c| **c != '\'').count())
            && (1..=4).contains(&after)
            && symbol.iter().all(|c| c.is_alphanumeric() || *c == '\'')
            && index.iter().all(|c| c.is_alphanumeric())
        {
            pieces.push((index.iter().collect(), true));
            pieces.push((String::new(), false));
            k += after + 1;
            continue;
        }
        if let Some((piece, _)) = pieces.last_mut() {
            piece.push(chars[k]);
        }
        k += 1;
    }
    pieces.retain(|(piece, _)| !piece.is_empty());
    pieces
}

/// A rectangle that a label occupies; labels that would overlap an earlier one are left out or moved.
#[derive(Clone, Copy, Debug)]
pub struct Area {
    /// Left edge.
    pub x: f64,
    /// Upper edge.
    pub y: f64,
    /// Width.
    pub width: f64,
    /// Height.
    pub height: f64,
}

impl Area {
    /// The area around a centre.
    pub fn around(x: f64, y: f64, width: f64, height: f64) -> Self {
        Self { x: x - 0.5 * width, y: y - 0.5 * height, width, height }
    }

    /// Whether the areas share a place.
    pub fn overlaps(&self, other: &Area) -> bool {
        self.x < other.x + other.width
            && other.x < self.x + self.width
            && self.y < other.y + other.height
            && other.y < self.y + self.height
    }

    /// Whether the other area lies inside this one.
    pub fn contains(&self, other: &Area) -> bool {
        other.x >= self.x
            && other.y >= self.y
            && other.x + other.width <= self.x + self.width
            && other.y + other.height <= self.y + self.height
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn symbols_get_indices_and_other_names_stay() {
        let piece = |text: &str, below: bool| (text.to_owned(), below);
        assert_eq!(
            indices("shift z_V1 [mm]"),
            [piece("shift z", false), piece("V1", true), piece(" [mm]", false)]
        );
        assert_eq!(indices("Δφ_2"), [piece("Δφ", false), piece("2", true)]);
        for plain in ["result_left.csv", "a_very_long", "_", "x_", "no index", "C_toolong"] {
            assert_eq!(indices(plain), [piece(plain, false)]);
        }
    }
}
