//! The section on a worm that is wanted: what its flanks are to be and what the dresser makes of them.

use crate::workflow::wanted_worm::WormFlankResult;
use report::charts::{
    ChartError, ContourMap, MapFrame, MapValues, NamedTopography, Topography, contour_map_in, format_fixed,
};
use report::{Block, Column, Figure, Section, Table};
use std::collections::BTreeMap;

/// The section; nothing for a job whose target is a gear.
///
/// # Errors
/// [`ChartError`] for values that are not finite.
pub(super) fn section(worm: &BTreeMap<&'static str, WormFlankResult>) -> Result<Vec<Section>, ChartError> {
    if worm.is_empty() {
        return Ok(Vec::new());
    }
    let mut blocks = vec![Block::Table(table(worm))];
    for (name, flank) in worm {
        blocks.push(Block::Figure(figure(name, flank)?));
    }
    Ok(vec![Section::new("worm-as-wanted", "The worm as wanted and as dressed", blocks)])
}

fn table(worm: &BTreeMap<&'static str, WormFlankResult>) -> Table {
    let row = |(name, flank): (&&str, &WormFlankResult)| {
        vec![
            (*name).to_owned(),
            format_fixed(flank.max_deviation_um, 3),
            format_fixed(flank.mean_deviation_um, 3),
        ]
    };
    Table {
        caption: String::new(),
        columns: vec![
            Column::text("Flank"),
            Column::number("Largest deviation", "µm"),
            Column::number("Everywhere", "µm"),
        ],
        rows: worm.iter().map(row).collect(),
        note: "Simulated worm against the wanted one, normal, over the part that grinds; what is the same everywhere is thickness and place of the thread and not counted."
            .into(),
    }
}

fn figure(name: &str, flank: &WormFlankResult) -> Result<Figure, ChartError> {
    let map = |title: &str, rows: Vec<Vec<f64>>| {
        Ok(NamedTopography::new(title, Topography::new(flank.w_mm.clone(), flank.z_mm.clone(), rows)?))
    };
    let off = flank.simulated_um.iter().zip(&flank.wanted_um).map(|(simulated, wanted)| {
        simulated.iter().zip(wanted).map(|(s, w)| s - w - flank.mean_deviation_um).collect()
    });
    let chart = ContourMap {
        title: format!("Worm, {name} flank"),
        quantity: "f_n1 [µm]".into(),
        panels: vec![
            map("wanted", flank.wanted_um.clone())?,
            map("as dressed", flank.simulated_um.clone())?,
            map("difference", off.collect())?,
        ],
        scale: None,
    };
    let frame = MapFrame {
        titles: ["z_1 [mm]".into(), "w_1 [mm]".into()],
        marks: Vec::new(),
        values: MapValues::Deviation,
    };
    let caption = "Material left on the worm against its involute flank, normal, over the length of roll and along the worm: wanted, as the rays of \
                   the verification found it under the dresser, and the difference.";
    Ok(Figure::new(format!("worm-as-wanted-{name}"), contour_map_in(&chart, &frame)?, caption))
}
