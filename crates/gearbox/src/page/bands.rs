//! Bands over time: least and greatest of a quantity in each stretch, with limits that it keeps to.

use control::Extremes;
use report::charts::{ChartError, LineChart, Panel, Series, Svg, line_chart};

/// Stretches of a band that are drawn as one: more than two hundred do not fit on the page.
const JOINED: usize = 2;

/// A stretch of time about an instant in s, with least and greatest of a quantity in it.
pub(super) type Stretch = (f64, Extremes);

/// A quantity of bins, times `scale`.
pub(super) fn stretches<B>(bins: &[B], scale: f64, of: impl Fn(&B) -> Stretch) -> Vec<Stretch> {
    let scaled = |bin: &B| {
        let (time, Extremes { least, greatest }) = of(bin);
        (time, Extremes { least: scale * least, greatest: scale * greatest })
    };
    bins.iter().map(scaled).collect()
}

/// A chart of bands below each other.
pub(super) fn chart(title: &str, panels: Vec<Panel>) -> Result<Svg, ChartError> {
    line_chart(&LineChart { title: title.into(), x_title: "time [s]".into(), panels })
}

/// A band with its limits, if there are any; values beyond `cut` are drawn at it, so that smaller ones can be seen.
pub(super) fn panel(title: &str, band: &[Stretch], limits: Option<[f64; 2]>, cut: Option<[f64; 2]>) -> Panel {
    let cut = |y: f64| cut.map_or(y, |[low, high]| y.clamp(low, high));
    let time: Vec<f64> =
        band.chunks(JOINED).map(|s| s.iter().map(|(time, _)| time).sum::<f64>() / s.len() as f64).collect();
    let joined = |value: fn(&Stretch) -> f64, choose: fn(f64, f64) -> f64| -> Vec<f64> {
        let of = |s: &[Stretch]| cut(s[1..].iter().map(value).fold(value(&s[0]), choose));
        band.chunks(JOINED).map(of).collect()
    };
    let mut lines = vec![
        Series::new("greatest", time.clone(), joined(|(_, e)| e.greatest, f64::max)),
        Series::new("least", time.clone(), joined(|(_, e)| e.least, f64::min)),
    ];
    if let (Some(limits), Some(first), Some(last)) = (limits, time.first(), time.last()) {
        lines.extend(limits.map(|y| Series::level("limit", [*first, *last], y)));
    }
    Panel::linear(title, 0.0, lines)
}
