//! Sensitivity topographies: what a unit of each variable does to the unmodified flank.

use super::heading;
use crate::workflow::SensitivityResult;
use report::charts::{ChartError, ContourMap, NamedTopography, Topography, contour_map};
use report::{Block, Figure, kebab};

/// The channel of a variable, for one chart a channel.
fn channel(of: &SensitivityResult) -> &str {
    of.variable.trim_end_matches(|c: char| c.is_ascii_digit())
}

/// Maps beside each other in one chart.
const BESIDE: usize = 3;

/// One chart a channel and flank, so that the powers of a channel share a scale.
pub(super) fn blocks(maps: &[SensitivityResult]) -> Result<Vec<Block>, ChartError> {
    let mut blocks = Vec::new();
    if !maps.is_empty() {
        blocks.push(Block::Paragraph(
            "What a unit of each variable does to the unmodified flank, exact derivatives. Positive: material is left. The powers of a \
             channel share a scale. All numbers stand in sensitivities.csv."
                .to_owned(),
        ));
    }
    let mut rest = maps;
    while let Some(first) = rest.first() {
        let count = rest
            .iter()
            .take(BESIDE)
            .take_while(|m| channel(m) == channel(first) && m.flank == first.flank)
            .count();
        let (group, others) = rest.split_at(count);
        rest = others;
        let names: Vec<&str> = group.iter().map(|m| m.variable.as_str()).collect();
        let panels = group
            .iter()
            .map(|m| {
                let map = Topography::new(m.w_mm.clone(), m.z_mm.clone(), m.values.clone())?;
                Ok(NamedTopography::new(&m.variable, map))
            })
            .collect::<Result<Vec<_>, ChartError>>()?;
        if panels.iter().all(|panel| panel.topography.range_um() == (0.0, 0.0)) {
            let text = format!(
                "{}, {}: no effect of first order.",
                names.join(", "),
                heading(&[first.flank]).to_lowercase()
            );
            blocks.push(Block::Paragraph(text));
            continue;
        }
        let map = ContourMap {
            title: format!("Sensitivity to {}, {}", names.join(", "), heading(&[first.flank]).to_lowercase()),
            quantity: if first.unit == "um/um" { "dm/dc".into() } else { first.unit.replace("um", "µm") },
            panels,
            scale: None,
        };
        let id = kebab(&format!("sensitivity to {} {}", names.join(" "), heading(&[first.flank])));
        blocks.push(Block::Figure(Figure::new(id, contour_map(&map)?, "")));
    }
    Ok(blocks)
}
