//! Which settings are turned, and what the referee says that this leaves.

use super::difference::{DifferenceRow, FEATURES};
use foundation::geometry::Flank;
use report::cells::{fixed, flank_title, significant, significant_or_none};
use report::charts::ChartError;
use report::data::{Block, Column, Quantity, Table};

/// A correction and its proof.
#[derive(Clone, Debug, PartialEq)]
pub struct CorrectionView {
    /// Settings.
    pub settings: Vec<SettingRow>,
    /// Deviation of the measured lines: before, as the model predicts, and what these settings cannot remove; root mean squares.
    pub rms_um: [f64; 3],
    /// Settings that could be turned and would change by less than it is worth.
    pub left_alone: Vec<String>,
    /// Settings that the lines do not tell apart, in words.
    pub not_told_apart: Vec<String>,
    /// What the corrected job leaves.
    pub proof: Vec<ProofRow>,
    /// What changes on the machine.
    pub machine: Vec<Quantity>,
}

/// A setting.
#[derive(Clone, Debug, PartialEq)]
pub struct SettingRow {
    /// Name.
    pub name: String,
    /// Unit.
    pub unit: String,
    /// Change.
    pub change: f64,
    /// Standard deviation of it.
    pub deviation: Option<f64>,
    /// Sum of all corrections.
    pub total: f64,
    /// What is to be said of it; empty for nothing.
    pub remark: String,
}

/// The proof of a flank.
#[derive(Clone, Debug, PartialEq)]
pub struct ProofRow {
    /// Flank.
    pub flank: Flank,
    /// Measured now.
    pub before: DifferenceRow,
    /// With the change that the referee finds.
    pub after: DifferenceRow,
    /// Largest difference of first order and referee.
    pub first_order_off_um: f64,
}

impl CorrectionView {
    pub(super) fn blocks(&self) -> Result<Vec<Block>, ChartError> {
        let mut blocks = vec![Block::Table(self.settings_table()?)];
        if !self.proof.is_empty() {
            blocks.push(Block::Table(self.proof_table()?));
        }
        blocks.extend(self.not_told_apart.iter().map(|text| Block::Paragraph(text.clone())));
        if !self.machine.is_empty() {
            blocks.push(Block::Table(Table::of_quantities("Change on the machine", &self.machine)));
        }
        Ok(blocks)
    }

    fn settings_table(&self) -> Result<Table, ChartError> {
        let row = |setting: &SettingRow| {
            let name = &setting.name;
            Ok(vec![
                name.clone(),
                significant(name, setting.change, 4)?,
                significant_or_none(name, setting.deviation, 2)?,
                significant(name, setting.total, 4)?,
                setting.unit.clone(),
                setting.remark.clone(),
            ])
        };
        let [before, predicted, unremovable] = self.rms_um;
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
            rows: self.settings.iter().map(row).collect::<Result<_, ChartError>>()?,
            note: format!(
                "Measured lines, root mean square: {} µm now, {} µm expected, of which these settings cannot remove {} µm. The plan of the \
                 corrected job decides which axes make it.{}",
                fixed("rms", before, 3)?,
                fixed("rms", predicted, 3)?,
                fixed("rms", unremovable, 3)?,
                match &self.left_alone[..] {
                    [] => String::new(),
                    names => format!(" Too small to be turned: {}.", names.join(", ")),
                }
            ),
        })
    }

    fn proof_table(&self) -> Result<Table, ChartError> {
        let mut columns = vec![
            Column::name("Flank"),
            Column::text("State"),
            Column::number("rms", "µm"),
            Column::number("largest", "µm"),
        ];
        columns.extend(FEATURES.map(|symbol| Column::number(symbol, "µm")));
        columns.push(Column::number("First order off by", "µm"));
        let mut rows = Vec::new();
        for proof in &self.proof {
            for (state, of, off) in [
                ("measured", &proof.before, None),
                ("corrected, by the referee", &proof.after, Some(proof.first_order_off_um)),
            ] {
                let mut row = vec![flank_title(proof.flank).to_owned(), state.to_owned()];
                for value in [of.rms_um, of.largest_um].iter().chain(&of.features_um) {
                    row.push(fixed("proof", *value, 3)?);
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
}
