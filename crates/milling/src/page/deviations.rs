//! Deviations of the flanks as maps, and sections through their worst places.

use super::FlankView;
use report::charts::{
    ChartError, ContourMap, LevelScale, LineChart, MapFrame, MapMark, NamedTopography, Panel, Series, Svg,
    Topography, contour_map_in, format_significant, line_chart,
};
use report::data::{Block, Figure};
use report::kebab;

/// Places marked in a map.
const MARKED: usize = 3;
/// How far apart they are at least, as a share of the flank's size.
const APART: f64 = 0.12;

/// A ray with its deviation.
#[derive(Clone, Copy)]
struct Worst {
    row: usize,
    column: usize,
    um: f64,
}

impl FlankView {
    fn columns(&self) -> usize {
        self.length.len()
    }

    /// Places of the largest deviations, the worst first, apart from each other.
    fn worst(&self) -> Vec<Worst> {
        let mut all: Vec<Worst> = self
            .simulated_um
            .iter()
            .enumerate()
            .filter_map(|(k, um)| {
                Some(Worst { row: k / self.columns(), column: k % self.columns(), um: (*um)? })
            })
            .collect();
        all.sort_by(|a, b| b.um.abs().total_cmp(&a.um.abs()));
        let share = |a: usize, b: usize, of: &[f64]| a.abs_diff(b) as f64 / of.len().max(2) as f64;
        let mut kept: Vec<Worst> = Vec::new();
        for place in all {
            let far = |other: &Worst| {
                share(place.row, other.row, &self.height).hypot(share(
                    place.column,
                    other.column,
                    &self.length,
                )) >= APART
            };
            if kept.iter().all(far) {
                kept.push(place);
            }
            if kept.len() == MARKED {
                break;
            }
        }
        kept
    }

    /// Values as a topography with ascending coordinates; holes count as 0 and are distinguished by marks.
    fn topography(&self, values: &[Option<f64>]) -> Result<Topography, ChartError> {
        let mut rows: Vec<Vec<f64>> = values
            .chunks(self.columns().max(1))
            .map(|row| row.iter().map(|um| um.unwrap_or(0.0)).collect())
            .collect();
        let mut height = self.height.clone();
        if self.descends() {
            height.reverse();
            rows.reverse();
        }
        Topography::new(height, self.length.clone(), rows)
    }

    /// Whether heights fall from root to tip, as on internal gears.
    fn descends(&self) -> bool {
        self.height.first() > self.height.last()
    }

    fn holes(&self, values: &[Option<f64>]) -> Vec<MapMark> {
        let hole = |(k, um): (usize, &Option<f64>)| {
            let at = [self.length[k % self.columns()], self.height[k / self.columns()]];
            um.is_none().then(|| MapMark { at, text: String::new() })
        };
        values.iter().enumerate().filter_map(hole).collect()
    }

    fn maps(&self) -> Result<Svg, ChartError> {
        let planned = self.topography(&self.planned_um)?;
        let simulated = self.topography(&self.simulated_um)?;
        let scale = LevelScale::covering([&planned, &simulated]);
        let mut found = self.holes(&self.simulated_um);
        found.extend(self.worst().iter().map(|place| MapMark {
            at: [self.length[place.column], self.height[place.row]],
            text: format_significant(place.um, 3),
        }));
        let map = ContourMap {
            title: format!("{}: deviation from the wanted flank", self.name),
            quantity: "f_n [µm]".into(),
            panels: vec![
                NamedTopography::new("Simulated by rays", simulated),
                NamedTopography::new("Planned: scallops and blocks", planned),
            ],
            scale: Some(scale),
        };
        let frame = MapFrame {
            titles: [self.length_title.clone(), self.height_title.clone()],
            marks: vec![found, self.holes(&self.planned_um)],
            grounds_only: true,
        };
        contour_map_in(&map, &frame)
    }

    /// Planned and simulated over one coordinate through the worst place.
    fn section(&self, along_height: bool, at: Worst) -> Panel {
        let columns = self.columns();
        let (coordinates, places): (&[f64], Vec<usize>) = if along_height {
            (&self.height, (0..self.height.len()).map(|row| row * columns + at.column).collect())
        } else {
            (&self.length, (0..columns).map(|column| at.row * columns + column).collect())
        };
        let line = |name: &str, values: &[Option<f64>]| {
            let points = coordinates.iter().zip(&places).filter_map(|(x, k)| Some((*x, values[*k]?)));
            let (x, y): (Vec<f64>, Vec<f64>) = points.unzip();
            (!x.is_empty()).then(|| Series::new(name, x, y))
        };
        let mut series: Vec<Series> =
            [line("simulated", &self.simulated_um), line("planned", &self.planned_um)]
                .into_iter()
                .flatten()
                .collect();
        if let [first, .., last] = coordinates {
            series.push(Series::level("target", [first.min(*last), first.max(*last)], 0.0));
        }
        let (title, value) = if along_height {
            (&self.length_title, self.length[at.column])
        } else {
            (&self.height_title, self.height[at.row])
        };
        let place = format!("{} at {title} = {}", self.name, format_significant(value, 4));
        Panel::linear(format!("{place}: f_n [µm]"), 0.0, series)
    }
}

/// Maps of all flanks and sections through the worst place of each.
pub(super) fn blocks(flanks: &[FlankView]) -> Result<Vec<Block>, ChartError> {
    let mut blocks = Vec::new();
    for flank in flanks {
        let caption = "Circles: the largest deviations, apart from each other. A cross: no cutter comes by, or nothing is predicted \
                       there. Root below unless the height falls towards the tip.";
        let id = format!("{}-deviation-from-the-wanted-flank", kebab(&flank.name));
        blocks.push(Block::Figure(Figure::new(id, flank.maps()?, caption)));
    }
    for along_height in [true, false] {
        let panels: Vec<Panel> = flanks
            .iter()
            .filter_map(|flank| Some(flank.section(along_height, *flank.worst().first()?)))
            .collect();
        let Some(flank) = flanks.first().filter(|_| !panels.is_empty()) else { continue };
        let (id, title, x_title) = if along_height {
            (
                "sections-from-root-to-tip-through-the-worst-places",
                "Sections from root to tip through the worst places",
                &flank.height_title,
            )
        } else {
            (
                "sections-along-the-tooth-through-the-worst-places",
                "Sections along the tooth through the worst places",
                &flank.length_title,
            )
        };
        let svg = line_chart(&LineChart { title: title.into(), x_title: x_title.clone(), panels })?;
        blocks.push(Block::Figure(Figure::new(id, svg, "")));
    }
    Ok(blocks)
}
