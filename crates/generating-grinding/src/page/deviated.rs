//! The section on axes that are off: what the planned settings leave then.

use crate::workflow::{DeviatedFlank, DeviatedResult, FlankResult};
use foundation::geometry::Flank;
use report::cells::flank_title;
use report::charts::{ChartError, NamedTopography, Topography, TopographyNet, format_fixed, topography_net};
use report::{Block, Column, Figure, Table};
use run::CharacteristicsUm;
use std::collections::BTreeMap;

/// A figure of a flank with its name.
type Value = (&'static str, fn(&CharacteristicsUm) -> f64);

const VALUES: [Value; 5] = [
    ("helix crowning", |c| c.helix_crowning_um),
    ("profile crowning", |c| c.profile_crowning_um),
    ("helix slope", |c| c.helix_slope_um),
    ("profile slope", |c| c.profile_slope_um),
    ("twist", |c| c.twist_fit_um),
];

/// Table and picture; `planned` are the flanks without deviations.
///
/// # Errors
/// [`ChartError`] for values that are not finite.
pub(super) fn deviated(
    of: &DeviatedResult,
    planned: &BTreeMap<&'static str, FlankResult>,
) -> Result<Vec<Block>, ChartError> {
    let both = |flank: Flank| Some((flank, of.flanks.get(flank.name())?, planned.get(flank.name())?));
    let flanks: Vec<(Flank, &DeviatedFlank, &FlankResult)> =
        Flank::BOTH.into_iter().filter_map(both).collect();
    let panels = flanks
        .iter()
        .map(|(flank, off, good)| {
            let change = Topography::new(good.w_mm.clone(), good.z_mm.clone(), off.change_um.clone())?;
            Ok(NamedTopography::new(format!("{flank} flank"), change))
        })
        .collect::<Result<Vec<_>, ChartError>>()?;
    let net = topography_net(&TopographyNet {
        title: "Change of the flank by axes that are off".to_owned(),
        panels,
        range_um: None,
    })?;
    Ok(vec![
        Block::Table(deviations(&flanks)),
        Block::Table(characteristics(&flanks)),
        Block::Figure(Figure::new(
            "change-of-the-flank-by-axes-that-are-off",
            net,
            "Simulated with the planned settings, against the flank without deviations; what is the same everywhere is tooth thickness and left out.",
        )),
    ])
}

fn deviations(flanks: &[(Flank, &DeviatedFlank, &FlankResult)]) -> Table {
    let row = |(flank, off, good): &(Flank, &DeviatedFlank, &FlankResult)| {
        vec![
            flank_title(*flank).to_owned(),
            format_fixed(good.max_deviation_um, 3),
            format_fixed(off.max_deviation_um, 3),
            format_fixed(100.0 * off.tolerance_share, 1),
            format_fixed(off.largest_change_um, 3),
            format_fixed(off.stock_um, 3),
        ]
    };
    Table {
        caption: "Deviation from the target with axes that are off".to_owned(),
        columns: vec![
            Column::text("Flank"),
            Column::number("As planned", "µm"),
            Column::number("With deviations", "µm"),
            Column::number("Share of the tolerance", "%"),
            Column::number("Change of the form", "µm"),
            Column::number("Material left everywhere", "µm"),
        ],
        rows: flanks.iter().map(row).collect(),
        note: "The verdict is that of the plan: it does not count deviations of the machine.".into(),
    }
}

fn characteristics(flanks: &[(Flank, &DeviatedFlank, &FlankResult)]) -> Table {
    let rows = flanks.iter().flat_map(|(flank, off, good)| {
        VALUES.iter().map(move |(name, value)| {
            let (planned, with) = (value(&good.simulated_characteristics), value(&off.characteristics));
            vec![
                flank_title(*flank).to_owned(),
                (*name).to_owned(),
                format_fixed(planned, 3),
                format_fixed(with, 3),
                format_fixed(with - planned, 3),
            ]
        })
    });
    Table {
        caption: "Characteristics with axes that are off, fitted over the whole field".to_owned(),
        columns: vec![
            Column::text("Flank"),
            Column::text("Value"),
            Column::number("As planned", "µm"),
            Column::number("With deviations", "µm"),
            Column::number("Change", "µm"),
        ],
        rows: rows.collect(),
        note: String::new(),
    }
}
