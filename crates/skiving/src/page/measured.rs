//! Deviations of all teeth on all tracks, the band about the compensation curve, and the teeth that leave it.

use foundation::geometry::{Flank, Sides};
use report::cells::{NONE, fixed_or_none, flank_title};
use report::charts::{
    ChartError, LineChart, LineFrame, Panel, Series, Svg, check_length, format_significant, line_chart_in,
};
use report::data::{Block, Column, Figure, Table};

/// What was measured. Deviations normal to the flank at the virtual contact points, > 0 = material beyond the nominal edge.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasuredView {
    /// Deviations of both flanks.
    pub flanks: Sides<FlankDeviations>,
    /// D: width of the band about the compensation curve, um.
    pub band_um: Option<f64>,
    /// Teeth to look at, the worst first.
    pub worst: Vec<WorstTooth>,
}

/// Deviations of a flank.
#[derive(Clone, Debug, PartialEq)]
pub struct FlankDeviations {
    /// Its tracks, ascending in x.
    pub tracks: Vec<TrackDeviations>,
}

/// Deviations of a track.
#[derive(Clone, Debug, PartialEq)]
pub struct TrackDeviations {
    /// x = -1..1 along the edge.
    pub place: f64,
    /// Compensation curve there, um.
    pub curve_um: f64,
    /// Deviation of each tooth without the clocking of the tool, um.
    pub measured_um: Vec<f64>,
    /// What remains without eccentricity and wobble, um.
    pub remaining_um: Vec<f64>,
}

/// A tooth to look at.
#[derive(Clone, Debug, PartialEq)]
pub struct WorstTooth {
    /// Its number.
    pub tooth: usize,
    /// Flank; none for a whole tooth.
    pub flank: Option<Flank>,
    /// Track of the largest deviation, from 1.
    pub track: Option<usize>,
    /// Largest distance from the compensation curve, um.
    pub from_curve_um: Option<f64>,
    /// What is the matter.
    pub why: String,
}

/// Height of a panel with one line for every track.
const TALL: f64 = 170.0;
/// Smallest span of an ordinate, um.
const LEAST_UM: f64 = 1.0;

impl MeasuredView {
    pub(super) fn blocks(&self) -> Result<Vec<Block>, ChartError> {
        self.check()?;
        let figure = |id: &str, svg: Svg, caption: &str| Block::Figure(Figure::new(id, svg, caption));
        let mut blocks = vec![
            figure(
                "deviation-as-measured",
                self.over_teeth("Deviation as measured", |track, tooth| track.measured_um[tooth], false)?,
                "Normal to the flank at the virtual contact points, without the clocking of the tool; positive is material beyond the nominal edge. \
                 The wave over one turn is the mounting.",
            ),
            figure(
                "without-eccentricity-and-wobble-distance-from-the-compensation-curve",
                self.over_teeth(
                    "Without eccentricity and wobble: distance from the compensation curve",
                    |track, tooth| track.remaining_um[tooth] - track.curve_um,
                    true,
                )?,
                "What the teeth themselves are. Dashed: the band of ± D/2 about the compensation curve. A ring marks a tooth that the table names.",
            ),
            figure(
                "shape-of-the-edge",
                self.over_edge()?,
                "The same over the edge, from the smaller to the larger length of roll of the workpiece: mean, least and greatest of all teeth at every track.",
            ),
        ];
        if !self.worst.is_empty() {
            blocks.push(Block::Table(self.worst_table()?));
        }
        Ok(blocks)
    }

    fn check(&self) -> Result<(), ChartError> {
        for (flank, of) in self.flanks.iter() {
            let teeth = of.tracks.first().map_or(0, |track| track.measured_um.len());
            for (number, track) in of.tracks.iter().enumerate() {
                let name = format!("{flank} flank, track {}", number + 1);
                check_length(&name, teeth, track.measured_um.len())?;
                check_length(&format!("{name}, remaining"), teeth, track.remaining_um.len())?;
            }
        }
        Ok(())
    }

    /// All tracks over the tooth number, both flanks below each other.
    fn over_teeth(
        &self,
        title: &str,
        value: impl Fn(&TrackDeviations, usize) -> f64,
        with_band: bool,
    ) -> Result<Svg, ChartError> {
        let panel = |flank: Flank| {
            let tracks = &self.flanks[flank].tracks;
            let mut series: Vec<Series> = tracks
                .iter()
                .enumerate()
                .map(|(number, track)| {
                    let teeth = 0..track.measured_um.len();
                    let x = teeth.clone().map(|tooth| tooth as f64).collect();
                    Series::new(track_name(number), x, teeth.map(|tooth| value(track, tooth)).collect())
                })
                .collect();
            let last = tracks.first().map_or(0, |track| track.measured_um.len().saturating_sub(1));
            if let (true, Some(band)) = (with_band, self.band_um) {
                let limit = |y: f64| Series::limit("± D/2", vec![0.0, last as f64], vec![y; 2]);
                series.extend([limit(0.5 * band), limit(-0.5 * band)]);
            }
            let rings = if with_band { self.rings(flank, &value) } else { Vec::new() };
            if !rings.is_empty() {
                series.push(Series::rings("tooth to look at", rings));
            }
            Panel::linear(format!("{}: deviation [µm]", flank_title(flank)), LEAST_UM, series)
        };
        let chart = LineChart {
            title: title.into(),
            x_title: "tooth".into(),
            panels: Flank::BOTH.map(panel).into_iter().collect(),
        };
        line_chart_in(&chart, &LineFrame { panel_height: Some(TALL), beside: 0.6 })
    }

    fn rings(&self, flank: Flank, value: impl Fn(&TrackDeviations, usize) -> f64) -> Vec<([f64; 2], String)> {
        let place = |worst: &WorstTooth| {
            let track = self.flanks[flank].tracks.get(worst.track?.checked_sub(1)?)?;
            let here = worst.flank == Some(flank) && worst.tooth < track.measured_um.len();
            here.then(|| ([worst.tooth as f64, value(track, worst.tooth)], format!("tooth {}", worst.tooth)))
        };
        self.worst.iter().filter_map(place).collect()
    }

    /// Mean and range of the teeth over the edge, with the curve and its band.
    fn over_edge(&self) -> Result<Svg, ChartError> {
        let panel = |flank: Flank| {
            let tracks = &self.flanks[flank].tracks;
            let x: Vec<f64> = tracks.iter().map(|track| track.place).collect();
            let line = |of: &dyn Fn(&TrackDeviations) -> f64| tracks.iter().map(of).collect::<Vec<f64>>();
            let mean = |track: &TrackDeviations| {
                track.remaining_um.iter().sum::<f64>() / track.remaining_um.len() as f64
            };
            let extreme = |sign: f64| {
                move |track: &TrackDeviations| {
                    sign * track.remaining_um.iter().map(|um| sign * um).fold(f64::NEG_INFINITY, f64::max)
                }
            };
            let all = vec![true; x.len()];
            let mut series = vec![
                Series::new("mean of all teeth", x.clone(), line(&mean)).marked(all),
                Series::new("compensation curve", x.clone(), line(&|track| track.curve_um)),
                Series::new("greatest", x.clone(), line(&extreme(1.0))),
                Series::new("least", x.clone(), line(&extreme(-1.0))),
            ];
            if let Some(band) = self.band_um {
                let limit =
                    |by: f64| Series::limit("± D/2", x.clone(), line(&|track| track.curve_um + by * band));
                series.extend([limit(0.5), limit(-0.5)]);
            }
            Panel::linear(format!("{}: deviation [µm]", flank_title(flank)), LEAST_UM, series)
        };
        let chart = LineChart {
            title: "Shape of the edge".into(),
            x_title: "place x along the edge".into(),
            panels: Flank::BOTH.map(panel).into_iter().collect(),
        };
        line_chart_in(&chart, &LineFrame { panel_height: None, beside: 0.05 })
    }

    fn worst_table(&self) -> Result<Table, ChartError> {
        let row = |worst: &WorstTooth| {
            Ok(vec![
                worst.tooth.to_string(),
                worst.flank.map_or("both".into(), |flank| flank.to_string()),
                worst.track.map_or(NONE.into(), |track| track.to_string()),
                fixed_or_none("distance from the compensation curve", worst.from_curve_um, 2)?,
                worst.why.clone(),
            ])
        };
        let note = self.band_um.map_or(String::new(), |um| {
            format!("Tolerance band D = {} µm about the compensation curve.", format_significant(um, 4))
        });
        Ok(Table {
            caption: "Teeth to look at".into(),
            columns: vec![
                Column::number("Tooth", ""),
                Column::text("Flank"),
                Column::number("Track", ""),
                Column::number("From the curve", "µm"),
                Column::text("Why"),
            ],
            rows: self.worst.iter().map(row).collect::<Result<_, ChartError>>()?,
            note,
        })
    }
}

/// "track 1" for the first.
fn track_name(number: usize) -> String {
    format!("track {}", number + 1)
}
