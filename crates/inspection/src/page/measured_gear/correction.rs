//! Which settings are turned, what this changes on the machine, and what the referee says that it leaves.

use super::flanks::{FEATURES, features_um};
use super::settings::{change_on_the_machine, unit, words};
use crate::workflow::{CorrectedSettingResult, CorrectionResult, ProofResult};
use foundation::geometry::Flank;
use report::cells::{fixed, flank_title, significant, significant_or_none};
use report::charts::ChartError;
use report::{Block, Column, Table};

/// What a correction of the target itself is.
const CORRECTED_TARGET: &str = "The corrected job takes the measured deviation, as a surface of third degree, off the flank that its paths are planned on.";

/// Of a correction; `half_mm` is half of the measured face.
pub(super) fn blocks(of: &CorrectionResult, half_mm: f64) -> Result<Vec<Block>, ChartError> {
    let mut blocks = if of.settings.is_empty() {
        vec![Block::Paragraph(CORRECTED_TARGET.into())]
    } else {
        vec![Block::Table(settings_table(of)?)]
    };
    let proofs: Vec<(Flank, &ProofResult)> =
        Flank::BOTH.into_iter().filter_map(|flank| Some((flank, of.proof.get(flank.name())?))).collect();
    if !proofs.is_empty() {
        blocks.push(Block::Table(proof_table(proofs)?));
    }
    blocks.extend(of.not_told_apart.iter().map(|group| {
        let named: Vec<String> = group.iter().map(|(name, _)| words(&format!("{name}_"))).collect();
        let text = format!("The measured lines do not tell these settings apart: {}.", named.join("; "));
        Block::Paragraph(text)
    }));
    let changes = change_on_the_machine(of, half_mm);
    if !changes.is_empty() {
        blocks.push(Block::Table(Table::of_quantities("Change on the machine", &changes)));
    }
    Ok(blocks)
}

fn settings_table(of: &CorrectionResult) -> Result<Table, ChartError> {
    let row = |setting: &CorrectedSettingResult| {
        let name = words(&setting.name);
        Ok(vec![
            name.clone(),
            significant(&name, setting.change, 4)?,
            significant_or_none(&name, setting.deviation, 2)?,
            significant(&name, setting.total, 4)?,
            unit(&setting.name).to_owned(),
            if setting.at_bound { "held by its bound".into() } else { String::new() },
        ])
    };
    let left_alone: Vec<String> =
        of.settings.iter().filter(|setting| setting.dropped).map(|s| words(&s.name)).collect();
    Ok(Table {
        caption: "Settings to turn".into(),
        columns: vec![
            Column::text("Setting"),
            Column::number("Change", ""),
            Column::number("Standard deviation", ""),
            Column::number("Sum of all", ""),
            Column::text("Unit"),
            Column::text("Remark"),
        ],
        rows: of
            .settings
            .iter()
            .filter(|setting| !setting.dropped)
            .map(row)
            .collect::<Result<_, ChartError>>()?,
        note: format!(
            "Measured lines, root mean square: {} µm now, {} µm expected, of which these settings cannot remove {} µm. The plan of the \
             corrected job decides which axes make it.{}",
            fixed("rms", of.rms_before_um, 3)?,
            fixed("rms", of.rms_predicted_um, 3)?,
            fixed("rms", of.rms_unremovable_um, 3)?,
            match &left_alone[..] {
                [] => String::new(),
                names => format!(" Too small to be turned: {}.", names.join(", ")),
            }
        ),
    })
}

fn proof_table(proofs: Vec<(Flank, &ProofResult)>) -> Result<Table, ChartError> {
    let mut columns = vec![
        Column::name("Flank"),
        Column::text("State"),
        Column::number("rms", "µm"),
        Column::number("largest", "µm"),
    ];
    columns.extend(FEATURES.map(|symbol| Column::number(symbol, "µm")));
    columns.push(Column::number("First order off by", "µm"));
    let mut rows = Vec::new();
    for (flank, proof) in proofs {
        for (state, of, off) in [
            ("measured", &proof.before, None),
            ("corrected, by the referee", &proof.after, Some(proof.first_order_off_um)),
        ] {
            let mut row = vec![flank_title(flank).to_owned(), state.to_owned()];
            for value in [of.rms_um, of.largest_um].into_iter().chain(features_um(of)) {
                row.push(fixed("proof", value, 3)?);
            }
            row.push(off.map_or_else(|| Ok(String::new()), |off| fixed("proof", off, 3))?);
            rows.push(row);
        }
    }
    Ok(Table {
        caption: "What the corrected job leaves".into(),
        columns,
        rows,
        note: "Deviation from the target about its mean. The corrected job was planned and simulated by the referee; the change of \
               its simulated flank is added to the measured deviation."
            .into(),
    })
}
