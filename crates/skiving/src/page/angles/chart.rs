//! The edges of a tooth over the radius, their deviations magnified.

use super::switching_angles::{EdgeAngles, SwitchingAngles, TrackAngles};
use foundation::geometry::{Flank, Sides};
use report::cells::flank_title;
use report::charts::{ChartError, LineChart, LineFrame, Panel, Series, Svg, line_chart_in};

const HEIGHT: f64 = 380.0;
const NOMINAL: &str = "nominal edges and middle";

/// The edges of a tooth with deviations as large as `factor` says.
pub(super) fn chart(angles: &SwitchingAngles, factor: f64) -> Result<Svg, ChartError> {
    let mut series = Vec::new();
    for (_, edge) in angles.edges.iter() {
        series.extend(nominal(edge));
    }
    let radii = || angles.edges.iter().flat_map(|(_, edge)| edge.stations.iter().map(|s| s.radius_mm));
    let (low, high) = radii().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), r| (a.min(r), b.max(r)));
    if low < high {
        let level = Series::level("", [low, high], 0.0);
        series.push(Series { name: NOMINAL.into(), x: level.y, y: level.x, marks: level.marks });
    }
    for (_, edge) in angles.edges.iter() {
        series.extend(magnified(edge, factor));
    }
    series.extend(centres(angles, factor));
    let numbers = angles.edges.left.tracks.iter().zip(&angles.edges.right.tracks).enumerate();
    let aside = 0.07 * angles.width();
    let texts: Vec<([f64; 2], String)> = numbers
        .map(|(k, (a, b))| ([-aside, 0.5 * (a.radius_mm + b.radius_mm)], format!("R_{}", k + 1)))
        .collect();
    if !texts.is_empty() {
        series.push(Series::texts("track numbers", texts));
    }
    series.extend(flank_names(angles));
    let chart = LineChart {
        title: format!("Angular positions of the edges of tooth {}", angles.tooth),
        x_title: "angle F about the middle of the nominal tooth [deg]".into(),
        panels: vec![Panel::linear("radius R of the track [mm]", 0.0, series)],
    };
    line_chart_in(&chart, &LineFrame { panel_height: Some(HEIGHT), beside: 0.05 * angles.width() })
}

/// Names of the flanks that the edges cut, outside of the edges' middles.
fn flank_names(angles: &SwitchingAngles) -> Option<Series> {
    let aside = 0.11 * angles.width();
    let name = |(flank, edge): (Flank, &EdgeAngles)| {
        let middle = edge.stations.get(edge.stations.len() * 3 / 4)?;
        let outside = middle.nominal_deg + aside * middle.nominal_deg.signum();
        Some(([outside, middle.radius_mm], flank_title(flank).to_owned()))
    };
    let names: Vec<([f64; 2], String)> = angles.edges.iter().filter_map(name).collect();
    (!names.is_empty()).then(|| Series::texts("names of the flanks", names))
}

/// The middle between both measured edges, track by track.
fn centres(angles: &SwitchingAngles, factor: f64) -> Option<Series> {
    let Sides { left, right } = &angles.edges;
    let middle = |(a, b): (&TrackAngles, &TrackAngles)| {
        let offset = 0.5 * (a.measured_deg - a.nominal_deg + b.measured_deg - b.nominal_deg);
        let nominal = 0.5 * (a.nominal_deg + b.nominal_deg);
        (nominal + factor * offset, 0.5 * (a.radius_mm + b.radius_mm))
    };
    let points = left.tracks.iter().zip(&right.tracks).map(middle);
    let (x, y): (Vec<f64>, Vec<f64>) = points.unzip();
    let filled = vec![true; x.len()];
    (!x.is_empty()).then(|| Series::new("measured tooth centre", x, y).marked(filled))
}

fn nominal(edge: &EdgeAngles) -> Option<Series> {
    let (x, y): (Vec<f64>, Vec<f64>) =
        edge.stations.iter().map(|station| (station.nominal_deg, station.radius_mm)).unzip();
    let level = Series::level(NOMINAL, [0.0; 2], 0.0);
    (!x.is_empty()).then_some(Series { x, y, ..level })
}

/// Curve, band and measured points with deviations as large as `factor` says.
fn magnified(edge: &EdgeAngles, factor: f64) -> Vec<Series> {
    let mut series = Vec::new();
    let (mut curve, mut band) = ((Vec::new(), Vec::new()), [Vec::new(), Vec::new()]);
    for station in &edge.stations {
        let offset = station.curve_deg;
        curve.0.push(station.nominal_deg + factor * offset);
        curve.1.push(station.radius_mm);
        let half = station.half_band_deg;
        let at = |by: f64| [station.nominal_deg + factor * (offset + by), station.radius_mm];
        band[0].push(at(half));
        band[1].push(at(-half));
    }
    if !curve.0.is_empty() {
        series.push(Series::new("compensation curve", curve.0, curve.1).bare());
    }
    for line in band.into_iter().filter(|line| !line.is_empty()) {
        let (x, y) = line.into_iter().map(|[x, y]| (x, y)).unzip();
        series.push(Series::limit("tolerance band D", x, y));
    }
    let measured =
        edge.tracks.iter().map(|track| (track.nominal_deg + factor * track.offset(), track.radius_mm));
    let (x, y): (Vec<f64>, Vec<f64>) = measured.unzip();
    if !x.is_empty() {
        series.push(Series::points("measured", x, y));
    }
    series
}
