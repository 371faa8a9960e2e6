//! Contact with the mate: the pattern on the developed flank, the transmission error over the roll, and the mate itself.

mod developed;
mod pattern;
mod shown;
mod table;
mod transmission;

use crate::workflow::{MateOutcome, MateResult};
use report::charts::{ChartError, drawing, format_fixed, format_significant};
use report::{Block, Figure, Quantity, Table, kebab};
use shown::ShownContact;

/// Patterns, transmission error and figures; nothing without a mate.
pub(super) fn blocks(mate: Option<&MateOutcome>) -> Result<Vec<Block>, ChartError> {
    let Some(mate) = mate else { return Ok(Vec::new()) };
    let result = &mate.result;
    let flanks = ShownContact::of_mate(mate);
    let mut blocks = Vec::new();
    for flank in &flanks {
        let caption = format!(
            "Places where the gap to the mate is {} µm or less at some roll position, without load, neighbouring pairs of teeth \
             included. Hatched: found by rolling both wanted flanks. Dashed: what both ease-offs say. {} % are common. \
             Beyond an edge of the mate a narrow band is marked that no contact line reaches.",
            format_significant(result.marking_um, 3),
            format_fixed(flank.result.overlap_percent, 1)
        );
        let svg = drawing(&pattern::drawn(flank, result.marking_um)?)?;
        blocks.push(Block::Figure(Figure::new(
            format!("{}-contact-pattern", kebab(&flank.name())),
            svg,
            caption,
        )));
    }
    blocks.push(Block::Figure(transmission::figure(&flanks, result.mean_pitch_radius_mm)?));
    blocks.push(Block::Table(table::patterns(&flanks)));
    blocks.push(Block::Table(Table::of_quantities("", &quantities(result))));
    Ok(blocks)
}

fn quantities(result: &MateResult) -> [Quantity; 5] {
    [
        Quantity::count("teeth of the mate", "z_2", i64::from(result.teeth)),
        Quantity::number("its pitch cone angle", "δ_2", result.pitch_cone_angle_deg, "deg"),
        Quantity::number("shaft angle", "Σ", result.shaft_angle_deg, "deg"),
        Quantity::number("its mean pitch radius", "r_m2", result.mean_pitch_radius_mm, "mm"),
        Quantity::number("marking", "", result.marking_um, "µm"),
    ]
}
