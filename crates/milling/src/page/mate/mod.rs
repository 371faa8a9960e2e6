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
        if let Some(drawing) = pattern::milled(flank, result.marking_um)? {
            let caption = "The same marking on the flank as it is milled: the crests that rows leave between them touch first. Hatched: \
                           found by rolling what is predicted of the cutter's rows and blocks against the mate.";
            let id = format!("{}-contact-pattern-milled", kebab(&flank.name()));
            blocks.push(Block::Figure(Figure::new(id, self::drawing(&drawing)?, caption)));
        }
    }
    blocks.push(Block::Figure(transmission::figure(&flanks, result.mean_pitch_radius_mm)?));
    blocks.push(Block::Table(table::patterns(&flanks)));
    blocks.push(Block::Table(Table::of_quantities("", &quantities(result))));
    Ok(blocks)
}

fn quantities(result: &MateResult) -> Vec<Quantity> {
    let mut all = vec![Quantity::count("teeth of the mate", "z_2", i64::from(result.teeth))];
    let optional = [
        ("its pitch cone angle", "δ_2", result.pitch_cone_angle_deg, "deg"),
        ("shaft angle", "Σ", result.shaft_angle_deg, "deg"),
        ("centre distance", "a", result.centre_distance_mm, "mm"),
        ("circumferential backlash", "j_t", result.backlash_um, "µm"),
    ];
    for (name, symbol, value, unit) in optional {
        all.extend(value.map(|value| Quantity::number(name, symbol, value, unit)));
    }
    let radius = if result.centre_distance_mm.is_some() {
        "its working pitch radius"
    } else {
        "its mean pitch radius"
    };
    all.push(Quantity::number(radius, "r_m2", result.mean_pitch_radius_mm, "mm"));
    all.push(Quantity::number("marking", "", result.marking_um, "µm"));
    all
}
