//! Pictures of the tools: the profile of the dresser, and the topography of the worm as the referee's rays left it.

use super::heading;
use crate::TangentialFlank;
use crate::workflow::TangentialOutcome;
use contact::Measure;
use foundation::geometry::Flank;
use foundation::numerics::equidistant;
use referee::WormModification;
use report::charts::{
    ChartError, ContourMap, LineChart, MapFrame, MapValues, NamedTopography, Panel, Series, Topography,
    contour_map_in, line_chart,
};
use report::{Block, Figure};

/// Points of a curve of the profile.
const POINTS: usize = 161;
/// Points of the map over the profile and along the worm.
const MAP: [usize; 2] = [33, 65];

pub(super) fn blocks(outcome: &TangentialOutcome) -> Result<Vec<Block>, ChartError> {
    let dresser = [dresser_sides(outcome)?, dresser_profile(outcome)?];
    let worms = Flank::BOTH.into_iter().filter_map(|flank| worm(outcome, flank).transpose());
    let worms = worms.collect::<Result<Vec<_>, ChartError>>()?;
    Ok(dresser.into_iter().chain(worms).map(Block::Figure).collect())
}

/// The sides that dress flanks of the run, each with its heights and what it lacks of the conjugate profile.
fn sides(outcome: &TangentialOutcome) -> impl Iterator<Item = (Flank, TangentialFlank<'_>, Vec<f64>)> {
    let model = &outcome.prepared.model;
    Flank::BOTH.into_iter().filter_map(move |flank| {
        let run = outcome.flanks[flank].as_ref()?;
        let ground = TangentialFlank::new(model, flank, &run.pass, &run.settings, Measure::Ray);
        Some((flank, ground, equidistant(model.dresser_heights(), POINTS)))
    })
}

/// The axial section: half thickness over the height, to scale.
fn dresser_sides(outcome: &TangentialOutcome) -> Result<Figure, ChartError> {
    let series = sides(outcome).map(|(flank, ground, heights)| {
        let half = heights.iter().map(|&s| ground.half_thickness(s)[0]).collect();
        Series::new(format!("side of the {flank} flank"), heights, half)
    });
    let chart = LineChart {
        title: "Profile of the dresser".into(),
        x_title: "height above the pitch circle [mm]".into(),
        panels: vec![Panel::linear("half thickness [mm]", 0.0, series.collect())],
    };
    let caption = "Axial section from the middle plane of the disc to each side that dresses a flank.";
    Ok(Figure::new("dresser-profile", line_chart(&chart)?, caption))
}

fn dresser_profile(outcome: &TangentialOutcome) -> Result<Figure, ChartError> {
    let series = sides(outcome).map(|(flank, ground, heights)| {
        let lacking = heights.iter().map(|&s| ground.half_thickness(s)[1] * 1e3).collect();
        Series::new(format!("side of the {flank} flank"), heights, lacking)
    });
    let chart = LineChart {
        title: "Profile function of the dresser".into(),
        x_title: "height above the pitch circle [mm]".into(),
        panels: vec![Panel::linear("thinner than the nominal profile [µm]", 0.0, series.collect())],
    };
    let caption = "What the half thickness lacks of the nominal profile, along the axis of the disc.";
    Ok(Figure::new("dresser-profile-function", line_chart(&chart)?, caption))
}

/// The worm of a flank that is ground, as far as it is used; `None` for the other one.
fn worm(outcome: &TangentialOutcome, flank: Flank) -> Result<Option<Figure>, ChartError> {
    let Some(run) = &outcome.flanks[flank] else { return Ok(None) };
    let surface = &run.refereed.worm.surface;
    let area = &run.refereed.worm.area;
    let [w, z] = [equidistant(area.w, MAP[0]), equidistant(area.z, MAP[1])];
    let rows = w.iter().map(|&w| z.iter().map(|&z| surface.value(w, z) * 1e3).collect()).collect();
    let chart = ContourMap {
        title: format!("Topography of the worm, {}", heading(&[flank.name()]).to_lowercase()),
        quantity: "f_n1 [µm]".into(),
        panels: vec![NamedTopography::new(format!("{flank} flank"), Topography::new(w, z, rows)?)],
        scale: None,
    };
    let frame = MapFrame {
        titles: ["z_1 [mm]".into(), "w_1 [mm]".into()],
        marks: Vec::new(),
        values: MapValues::Deviation,
    };
    let caption = "Material left on the worm against its involute flank, normal, over the length of roll and along the worm, as the rays of \
                   the verification found it under the dresser.";
    let svg = contour_map_in(&chart, &frame)?;
    Ok(Some(Figure::new(format!("worm-topography-{}", flank.name()), svg, caption)))
}
