//! Where both edges of a tooth switch the beam, over the radius of the tracks: nominal, measured, compensation curve, tolerance band.

use foundation::geometry::{Flank, Sides};
use report::cells::{fixed_or_none, flank_title};
use report::charts::{
    ChartError, LineChart, LineFrame, Panel, Series, Svg, check_values, format_fixed, format_significant,
    line_chart_in, round_below,
};
use report::data::{Block, Column, Figure, Table};

/// Switching angles of a tooth, about the middle of the nominal tooth, deg.
#[derive(Clone, Debug, PartialEq)]
pub struct AngleView {
    /// Its number.
    pub tooth: usize,
    /// D: width of the tolerance band, um.
    pub band_um: Option<f64>,
    /// Its edges.
    pub edges: Sides<AngleEdge>,
}

/// Switching angles of an edge.
#[derive(Clone, Debug, PartialEq)]
pub struct AngleEdge {
    /// The nominal edge, closely, ascending in x.
    pub stations: Vec<AngleStation>,
    /// Its tracks, ascending in x.
    pub tracks: Vec<AngleTrack>,
}

/// A place of the nominal edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AngleStation {
    /// R, mm.
    pub radius_mm: f64,
    /// F of the ideal tool, deg.
    pub nominal_deg: f64,
    /// Compensation curve less the ideal tool, deg.
    pub curve_deg: Option<f64>,
    /// Angle of D/2, deg.
    pub half_band_deg: Option<f64>,
}

/// A track of the edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AngleTrack {
    /// R, mm.
    pub radius_mm: f64,
    /// F of the ideal tool, deg.
    pub nominal_deg: f64,
    /// F as measured, deg.
    pub measured_deg: Option<f64>,
}

/// Share of the tooth's width that the largest deviation takes when it is magnified.
const SHARE: f64 = 0.1;
const HEIGHT: f64 = 380.0;

impl AngleView {
    pub(super) fn blocks(&self) -> Result<Vec<Block>, ChartError> {
        let factor = self.magnification()?;
        let times = format_significant(factor, 6);
        let band = self.band_um.map_or(String::new(), |um| {
            format!(" Dashed: the band D = {} µm about the compensation curve.", format_significant(um, 4))
        });
        let caption = format!(
            "Angles at which the beam switches, about the middle of the nominal tooth; deviations from the nominal edge are drawn {times} times as \
             large.{band}"
        );
        let id = format!("angular-positions-of-the-edges-of-tooth-{}", self.tooth);
        let svg = self.chart(factor)?;
        Ok(vec![Block::Figure(Figure::new(id, svg, caption)), Block::Table(self.table()?)])
    }

    /// A round number that makes deviations visible.
    fn magnification(&self) -> Result<f64, ChartError> {
        let mut width = [f64::INFINITY, f64::NEG_INFINITY];
        let mut largest: f64 = 0.0;
        for (flank, edge) in self.edges.iter() {
            for station in &edge.stations {
                let AngleStation { radius_mm, nominal_deg, curve_deg, half_band_deg } = *station;
                let offset = curve_deg.unwrap_or(0.0).abs() + half_band_deg.unwrap_or(0.0).abs();
                check_values(&format!("{flank} edge"), &[radius_mm, nominal_deg, offset])?;
                width = [width[0].min(nominal_deg), width[1].max(nominal_deg)];
                largest = largest.max(offset);
            }
            for AngleTrack { radius_mm, nominal_deg, measured_deg } in &edge.tracks {
                let offset = measured_deg.map_or(0.0, |measured| measured - nominal_deg);
                check_values(&format!("{flank} edge, tracks"), &[*radius_mm, *nominal_deg, offset])?;
                largest = largest.max(offset.abs());
            }
        }
        let room = SHARE * (width[1] - width[0]);
        Ok(if largest > 0.0 && room > largest { round_below(room / largest) } else { 1.0 })
    }

    fn chart(&self, factor: f64) -> Result<Svg, ChartError> {
        let mut series = Vec::new();
        for (_, edge) in self.edges.iter() {
            series.extend(edge.nominal());
        }
        let radii = || self.edges.iter().flat_map(|(_, edge)| edge.stations.iter().map(|s| s.radius_mm));
        let (low, high) = radii().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), r| (a.min(r), b.max(r)));
        if low < high {
            let level = Series::level("", [low, high], 0.0);
            series.push(Series { name: NOMINAL.into(), x: level.y, y: level.x, marks: level.marks });
        }
        for (_, edge) in self.edges.iter() {
            series.extend(edge.magnified(factor));
        }
        series.extend(self.centres(factor));
        let numbers = self.edges.left.tracks.iter().zip(&self.edges.right.tracks).enumerate();
        let aside = 0.07 * self.width();
        let texts: Vec<([f64; 2], String)> = numbers
            .map(|(k, (a, b))| ([-aside, 0.5 * (a.radius_mm + b.radius_mm)], format!("R_{}", k + 1)))
            .collect();
        if !texts.is_empty() {
            series.push(Series::texts("track numbers", texts));
        }
        series.extend(self.flank_names());
        let chart = LineChart {
            title: format!("Angular positions of the edges of tooth {}", self.tooth),
            x_title: "angle F about the middle of the nominal tooth [deg]".into(),
            panels: vec![Panel::linear("radius R of the track [mm]", 0.0, series)],
        };
        line_chart_in(&chart, &LineFrame { panel_height: Some(HEIGHT), beside: 0.05 * self.width() })
    }

    fn width(&self) -> f64 {
        let angles = || self.edges.iter().flat_map(|(_, edge)| edge.stations.iter().map(|s| s.nominal_deg));
        let (lo, hi) = angles().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)));
        if lo < hi { hi - lo } else { 1.0 }
    }

    /// Names of the flanks that the edges cut, outside of the edges' middles.
    fn flank_names(&self) -> Option<Series> {
        let aside = 0.11 * self.width();
        let name = |(flank, edge): (Flank, &AngleEdge)| {
            let middle = edge.stations.get(edge.stations.len() * 3 / 4)?;
            let outside = middle.nominal_deg + aside * middle.nominal_deg.signum();
            Some(([outside, middle.radius_mm], flank_title(flank).to_owned()))
        };
        let names: Vec<([f64; 2], String)> = self.edges.iter().filter_map(name).collect();
        (!names.is_empty()).then(|| Series::texts("names of the flanks", names))
    }

    /// The middle between both measured edges, track by track.
    fn centres(&self, factor: f64) -> Option<Series> {
        let Sides { left, right } = &self.edges;
        let middle = |(a, b): (&AngleTrack, &AngleTrack)| {
            let offset = 0.5 * (a.measured_deg? - a.nominal_deg + b.measured_deg? - b.nominal_deg);
            let nominal = 0.5 * (a.nominal_deg + b.nominal_deg);
            Some((nominal + factor * offset, 0.5 * (a.radius_mm + b.radius_mm)))
        };
        let points = left.tracks.iter().zip(&right.tracks).filter_map(middle);
        let (x, y): (Vec<f64>, Vec<f64>) = points.unzip();
        let filled = vec![true; x.len()];
        (!x.is_empty()).then(|| Series::new("measured tooth centre", x, y).marked(filled))
    }

    fn table(&self) -> Result<Table, ChartError> {
        let row = |flank: Flank, k: usize, track: &AngleTrack| {
            let what = format!("{flank} edge, track {}", k + 1);
            let offset = track.measured_deg.map(|measured| 3600.0 * (measured - track.nominal_deg));
            Ok(vec![
                flank.to_string(),
                (k + 1).to_string(),
                format_fixed(track.radius_mm, 4),
                format_fixed(track.nominal_deg, 5),
                fixed_or_none(&what, track.measured_deg, 5)?,
                fixed_or_none(&what, offset, 2)?,
            ])
        };
        let rows = self.edges.iter().flat_map(|(flank, edge)| {
            edge.tracks.iter().enumerate().map(move |(k, track)| row(flank, k, track))
        });
        Ok(Table {
            caption: format!("Angles of tooth {}", self.tooth),
            columns: vec![
                Column::text("Flank"),
                Column::number("Track", ""),
                Column::number("R", "mm"),
                Column::number("Nominal F", "deg"),
                Column::number("Measured F", "deg"),
                Column::number("Difference", "arcsec"),
            ],
            rows: rows.collect::<Result<_, ChartError>>()?,
            note: String::new(),
        })
    }
}

const NOMINAL: &str = "nominal edges and middle";

impl AngleEdge {
    fn nominal(&self) -> Option<Series> {
        let (x, y): (Vec<f64>, Vec<f64>) =
            self.stations.iter().map(|station| (station.nominal_deg, station.radius_mm)).unzip();
        let level = Series::level(NOMINAL, [0.0; 2], 0.0);
        (!x.is_empty()).then_some(Series { x, y, ..level })
    }

    /// Curve, band and measured points with deviations as large as `factor` says.
    fn magnified(&self, factor: f64) -> Vec<Series> {
        let mut series = Vec::new();
        let (mut curve, mut band) = ((Vec::new(), Vec::new()), [Vec::new(), Vec::new()]);
        for station in &self.stations {
            let Some(offset) = station.curve_deg else { continue };
            curve.0.push(station.nominal_deg + factor * offset);
            curve.1.push(station.radius_mm);
            let Some(half) = station.half_band_deg else { continue };
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
        let measured = self.tracks.iter().filter_map(|track| {
            let offset = track.measured_deg? - track.nominal_deg;
            Some((track.nominal_deg + factor * offset, track.radius_mm))
        });
        let (x, y): (Vec<f64>, Vec<f64>) = measured.unzip();
        if !x.is_empty() {
            series.push(Series::points("measured", x, y));
        }
        series
    }
}
