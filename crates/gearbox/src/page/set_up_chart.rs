//! Accuracy over cost of the set-ups to choose from.

use crate::workflow::{ExploreResult, SetUpResult};
use report::charts::{ChartError, LineChart, Panel, Series, Svg, YScale, line_chart};

/// Cost and error at the flank in um of a set-up.
type Point = (f64, f64);

/// The chart; `None` where no set-up has an error.
pub(super) fn chart(explored: &ExploreResult) -> Result<Option<Svg>, ChartError> {
    let (mut fast, mut slow): (Vec<Point>, Vec<Point>) = (Vec::new(), Vec::new());
    for set_up in &explored.set_ups {
        let Some(flank_um) = set_up.flank_um else { continue };
        let kind = if is_fast(set_up) { &mut fast } else { &mut slow };
        kind.push((set_up.cost, flank_um));
    }
    if fast.is_empty() && slow.is_empty() {
        return Ok(None);
    }
    let costs = || fast.iter().chain(&slow).map(|(cost, _)| *cost);
    let (least, greatest) = (costs().fold(f64::INFINITY, f64::min), costs().fold(0.0, f64::max));
    // One cost has no range to draw a line over.
    let to = if greatest > least { greatest } else { least + 1.0 };
    let (x, y): (Vec<f64>, Vec<f64>) = frontier(&fast).into_iter().unzip();
    let filled = vec![true; x.len()];
    let mut series = vec![Series::new("frontier", x, y).marked(filled)];
    for (name, points) in [("set-up", fast), ("too slow for the feed", slow)] {
        let (x, y) = points.into_iter().unzip();
        series.push(Series::points(name, x, y));
    }
    series.retain(|series| !series.x.is_empty());
    series.push(Series::level("wanted at most", [least, to], explored.wanted_um));
    let panel = Panel {
        y_title: "error at the flank [µm]".into(),
        least_span: 0.0,
        scale: YScale::Logarithmic,
        series,
    };
    let chart = LineChart {
        title: "Accuracy and cost of set-ups".into(),
        x_title: "cost [as given]".into(),
        panels: vec![panel],
    };
    line_chart(&chart).map(Some)
}

fn is_fast(set_up: &SetUpResult) -> bool {
    set_up.refused != Some("interpolator-too-fast")
}

/// Set-ups that no cheaper one, nor one of the same cost, surpasses; by rising cost.
fn frontier(points: &[Point]) -> Vec<Point> {
    let mut points = points.to_vec();
    points.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let mut frontier: Vec<Point> = Vec::new();
    for point in points {
        if frontier.last().is_none_or(|last| point.1 < last.1) {
            frontier.push(point);
        }
    }
    frontier
}
