//! What to change in the setting, whether the tool is worn, and when it must be reground.

use foundation::geometry::Flank;
use report::cells::{fixed, significant, significant_or_none, yes_no};
use report::charts::ChartError;
use report::data::{Block, Column, Quantity, Table};

/// Consequences of a measurement.
#[derive(Clone, Debug, PartialEq)]
pub struct CorrectionsView {
    /// Changes of the setting.
    pub changes: Vec<SettingChange>,
    /// Root mean square of the workpiece's deviations before and after the changes, um.
    pub rms_um: Option<[f64; 2]>,
    /// Wear by flank.
    pub wear: Vec<WearRow>,
    /// When to regrind, in words and figures.
    pub regrind: Vec<Quantity>,
}

/// A change of the setting.
#[derive(Clone, Debug, PartialEq)]
pub struct SettingChange {
    /// Name in words.
    pub name: String,
    /// Symbol; empty for none.
    pub symbol: String,
    /// By how much.
    pub change: f64,
    /// Its unit.
    pub unit: String,
    /// Largest change allowed, same unit.
    pub limit: Option<f64>,
    /// Whether the limit holds it.
    pub at_limit: bool,
    /// Standard deviation, same unit.
    pub deviation: Option<f64>,
}

/// Wear of a flank.
#[derive(Clone, Debug, PartialEq)]
pub struct WearRow {
    /// Flank.
    pub flank: Flank,
    /// Track with the least material, from 1.
    pub track: usize,
    /// Mean deviation of all teeth there, um; < 0 = material missing.
    pub mean_um: f64,
    /// Mean material that may be missing, um, > 0.
    pub limit_um: f64,
    /// Whether it is worn.
    pub worn: bool,
}

impl CorrectionsView {
    pub(super) fn blocks(&self) -> Result<Vec<Block>, ChartError> {
        let mut blocks = Vec::new();
        if !self.changes.is_empty() {
            blocks.push(Block::Table(self.changes_table()?));
        }
        let mut beside = Vec::new();
        if !self.wear.is_empty() {
            beside.push(self.wear_table()?);
        }
        if !self.regrind.is_empty() {
            beside.push(Table::of_quantities("Regrinding", &self.regrind));
        }
        if !beside.is_empty() {
            blocks.push(Block::Tables(beside));
        }
        Ok(blocks)
    }

    fn changes_table(&self) -> Result<Table, ChartError> {
        let row = |change: &SettingChange| {
            let name = &change.name;
            Ok(vec![
                name.clone(),
                change.symbol.clone(),
                significant(name, change.change, 5)?,
                change.unit.clone(),
                significant_or_none(name, change.deviation, 2)?,
                significant_or_none(name, change.limit, 4)?,
                yes_no(change.at_limit),
            ])
        };
        let note = match self.rms_um {
            None => String::new(),
            Some([before, after]) => format!(
                "Root mean square of the workpiece's profile deviations: {} µm before, {} µm after the changes.",
                fixed("RMS before", before, 3)?,
                fixed("RMS after", after, 3)?
            ),
        };
        Ok(Table {
            caption: "Changes of the setting".into(),
            columns: vec![
                Column::text("Quantity"),
                Column::symbols("Symbol"),
                Column::number("Change", ""),
                Column::text("Unit"),
                Column::number("Standard deviation", ""),
                Column::number("Limit ±", ""),
                Column::text("At its limit"),
            ],
            rows: self.changes.iter().map(row).collect::<Result<_, ChartError>>()?,
            note,
        })
    }

    fn wear_table(&self) -> Result<Table, ChartError> {
        let row = |wear: &WearRow| {
            let name = format!("wear of the {} flank", wear.flank);
            Ok(vec![
                wear.flank.to_string(),
                wear.track.to_string(),
                fixed(&name, wear.mean_um, 2)?,
                fixed(&name, -wear.limit_um, 2)?,
                yes_no(wear.worn),
            ])
        };
        Ok(Table {
            caption: "Wear".into(),
            columns: vec![
                Column::text("Flank"),
                Column::number("Track", ""),
                Column::number("Mean of the teeth", "µm"),
                Column::number("Limit", "µm"),
                Column::text("Worn"),
            ],
            rows: self.wear.iter().map(row).collect::<Result<_, ChartError>>()?,
            note: "The track with the least material; below zero it is missing.".into(),
        })
    }
}
