//! Deviations of the flanks as maps, and sections through their worst places.

use super::shown_flank::ShownFlank;
use crate::workflow::FlankResult;
use report::charts::{
    ChartError, ContourMap, LevelScale, LineChart, MapFrame, MapMark, MapValues, NamedTopography, Panel,
    Series, Svg, Topography, contour_map_in, format_significant, line_chart,
};
use report::{Block, Figure, kebab};

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

/// Places of the largest deviations, the worst first, apart from each other.
fn worst(flank: &FlankResult) -> Vec<Worst> {
    let columns = flank.length.len();
    let place =
        |(k, um): (usize, &Option<f64>)| Some(Worst { row: k / columns, column: k % columns, um: (*um)? });
    let mut all: Vec<Worst> = flank.simulated_um.iter().enumerate().filter_map(place).collect();
    all.sort_by(|a, b| b.um.abs().total_cmp(&a.um.abs()));
    let share = |a: usize, b: usize, of: &[f64]| a.abs_diff(b) as f64 / of.len().max(2) as f64;
    let mut kept: Vec<Worst> = Vec::new();
    for place in all {
        let far = |other: &Worst| {
            let [up, along] = [
                share(place.row, other.row, &flank.height),
                share(place.column, other.column, &flank.length),
            ];
            up.hypot(along) >= APART
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
fn topography(flank: &FlankResult, values: &[Option<f64>]) -> Result<Topography, ChartError> {
    let mut rows: Vec<Vec<f64>> = values
        .chunks(flank.length.len().max(1))
        .map(|row| row.iter().map(|um| um.unwrap_or(0.0)).collect())
        .collect();
    let mut height = flank.height.clone();
    // On internal gears heights fall from root to tip.
    if height.first() > height.last() {
        height.reverse();
        rows.reverse();
    }
    Topography::new(height, flank.length.clone(), rows)
}

fn holes(flank: &FlankResult, values: &[Option<f64>]) -> Vec<MapMark> {
    let columns = flank.length.len();
    let hole = |(k, um): (usize, &Option<f64>)| {
        let at = [flank.length[k % columns], flank.height[k / columns]];
        um.is_none().then(|| MapMark { at, text: String::new() })
    };
    values.iter().enumerate().filter_map(hole).collect()
}

fn maps(shown: &ShownFlank<'_>) -> Result<Svg, ChartError> {
    let flank = shown.result;
    let planned = topography(flank, &flank.planned_um)?;
    let simulated = topography(flank, &flank.simulated_um)?;
    let scale = LevelScale::covering([&planned, &simulated]);
    let mut found = holes(flank, &flank.simulated_um);
    found.extend(worst(flank).iter().map(|place| MapMark {
        at: [flank.length[place.column], flank.height[place.row]],
        text: format_significant(place.um, 3),
    }));
    let map = ContourMap {
        title: format!("{}: deviation from the wanted flank", shown.name()),
        quantity: "f_n [µm]".into(),
        panels: vec![
            NamedTopography::new("Simulated by rays", simulated),
            NamedTopography::new("Planned: scallops and blocks", planned),
        ],
        scale: Some(scale),
    };
    let [height, length] = shown.titles().map(String::from);
    let frame = MapFrame {
        titles: [length, height],
        marks: vec![found, holes(flank, &flank.planned_um)],
        values: MapValues::Waves,
    };
    contour_map_in(&map, &frame)
}

/// Planned and simulated over one coordinate through the worst place.
fn section(shown: &ShownFlank<'_>, along_height: bool, at: Worst) -> Panel {
    let flank = shown.result;
    let columns = flank.length.len();
    let (coordinates, places): (&[f64], Vec<usize>) = if along_height {
        (&flank.height, (0..flank.height.len()).map(|row| row * columns + at.column).collect())
    } else {
        (&flank.length, (0..columns).map(|column| at.row * columns + column).collect())
    };
    let line = |name: &str, values: &[Option<f64>]| {
        let points = coordinates.iter().zip(&places).filter_map(|(x, k)| Some((*x, values[*k]?)));
        let (x, y): (Vec<f64>, Vec<f64>) = points.unzip();
        (!x.is_empty()).then(|| Series::new(name, x, y))
    };
    let mut series: Vec<Series> =
        [line("simulated", &flank.simulated_um), line("planned", &flank.planned_um)]
            .into_iter()
            .flatten()
            .collect();
    if let [first, .., last] = coordinates {
        series.push(Series::level("target", [first.min(*last), first.max(*last)], 0.0));
    }
    let [height_title, length_title] = shown.titles();
    let (title, value) = if along_height {
        (length_title, flank.length[at.column])
    } else {
        (height_title, flank.height[at.row])
    };
    let place = format!("{} at {title} = {}", shown.name(), format_significant(value, 4));
    Panel::linear(format!("{place}: f_n [µm]"), 0.0, series)
}

/// Maps of all flanks and sections through the worst place of each.
pub(super) fn blocks(flanks: &[ShownFlank<'_>]) -> Result<Vec<Block>, ChartError> {
    let mut blocks = Vec::new();
    for flank in flanks {
        let caption = "Circles: the largest deviations, apart from each other. A cross: no cutter comes by, or nothing is predicted \
                       there. Root below unless the height falls towards the tip.";
        let id = format!("{}-deviation-from-the-wanted-flank", kebab(&flank.name()));
        blocks.push(Block::Figure(Figure::new(id, maps(flank)?, caption)));
    }
    for along_height in [true, false] {
        let panels: Vec<Panel> = flanks
            .iter()
            .filter_map(|flank| Some(section(flank, along_height, *worst(flank.result).first()?)))
            .collect();
        let Some(flank) = flanks.first().filter(|_| !panels.is_empty()) else { continue };
        let [height_title, length_title] = flank.titles();
        let (id, title, x_title) = if along_height {
            (
                "sections-from-root-to-tip-through-the-worst-places",
                "Sections from root to tip through the worst places",
                height_title,
            )
        } else {
            (
                "sections-along-the-tooth-through-the-worst-places",
                "Sections along the tooth through the worst places",
                length_title,
            )
        };
        let svg = line_chart(&LineChart { title: title.into(), x_title: x_title.into(), panels })?;
        blocks.push(Block::Figure(Figure::new(id, svg, "")));
    }
    Ok(blocks)
}
