//! Colours and line styles. Whatever they say must also be said by dash, marker, hatching or label.

/// Dark text and axes.
pub const INK: &str = "#1c1f23";
/// Secondary text.
pub const MUTED: &str = "#565b61";
/// Grid lines and helper outlines.
pub const FAINT: &str = "#c9cdd1";
/// Grid lines inside a plot.
pub const GRID: &str = "#e3e5e8";
/// First data colour.
pub const BLUE: &str = "#1f4e79";
/// Second data colour.
pub const RUST: &str = "#b4541a";

/// How one series of a line chart looks.
pub struct SeriesStyle {
    /// Colour of the line.
    pub color: &'static str,
    /// Its dashes, as SVG has them.
    pub dash: &'static str,
    /// Mark of its points.
    pub marker: Marker,
}

/// Shape that marks points of a series.
#[derive(Clone, Copy)]
pub enum Marker {
    /// A disc.
    Disc,
    /// A square.
    Square,
    /// A triangle.
    Triangle,
    /// A square on its corner.
    Diamond,
    /// A triangle on its corner.
    TriangleDown,
    /// An upright bar.
    Bar,
}

/// The style of the k-th series. After six the colours start again with other dashes and markers: 36 differ.
pub fn series_style(k: usize) -> SeriesStyle {
    let styles = [
        (BLUE, "", Marker::Disc),
        (RUST, "6 3", Marker::Square),
        ("#3f7050", "2 2.5", Marker::Triangle),
        ("#6a4a86", "8 3 2 3", Marker::Diamond),
        ("#8a6d00", "11 3", Marker::TriangleDown),
        ("#2a7f8e", "10 3 2 3 2 3", Marker::Bar),
    ];
    let (round, place) = (k / styles.len(), k % styles.len());
    let (color, ..) = styles[place];
    let (_, dash, marker) = styles[(place + round) % styles.len()];
    SeriesStyle { color, dash, marker }
}

/// White through blue to dark for relief, white through ochre to brown for material left; sorted from light to dark.
const RELIEF: [[u8; 3]; 5] =
    [[250, 250, 248], [205, 222, 236], [146, 182, 212], [84, 135, 182], [38, 84, 136]];
const MATERIAL: [[u8; 3]; 5] =
    [[250, 250, 248], [247, 223, 190], [233, 178, 118], [203, 126, 61], [147, 78, 22]];

/// Colour of a signed value, `share` = value / largest magnitude in -1 .. 1. Lightness falls with the magnitude on
/// both sides, so that the order survives a grey copy; the sign is shown by hatching and labels.
pub fn signed_color(share: f64) -> String {
    let stops = if share < 0.0 { &RELIEF } else { &MATERIAL };
    let place = share.abs().min(1.0) * (stops.len() - 1) as f64;
    let below = (place.floor() as usize).min(stops.len() - 2);
    let part = place - below as f64;
    let mix = |c: usize| {
        let (a, b) = (f64::from(stops[below][c]), f64::from(stops[below + 1][c]));
        (a + (b - a) * part).round() as u8
    };
    format!("#{:02x}{:02x}{:02x}", mix(0), mix(1), mix(2))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn luminance(color: &str) -> f64 {
        let channel = |k: usize| f64::from(u8::from_str_radix(&color[k..k + 2], 16).unwrap());
        0.2126 * channel(1) + 0.7152 * channel(3) + 0.0722 * channel(5)
    }

    #[test]
    fn no_two_of_36_series_look_alike() {
        let looks: std::collections::BTreeSet<(&str, &str)> =
            (0..36).map(series_style).map(|style| (style.color, style.dash)).collect();
        assert_eq!(looks.len(), 36);
    }

    #[test]
    fn lightness_falls_with_the_magnitude() {
        for sign in [-1.0, 1.0] {
            let light: Vec<f64> =
                (0..=40).map(|k| luminance(&signed_color(sign * f64::from(k) / 40.0))).collect();
            assert!(light.windows(2).all(|pair| pair[1] < pair[0]), "{light:?}");
        }
    }
}
