//! The diagonal ratio, why it was chosen, and what was compared with it.

use crate::workflow::result::{CandidateResult, SettingsResult};
use report::charts::{format_fixed, format_significant};
use report::{Block, Column, Table};

/// Sentence and table.
pub(super) fn choice(settings: &SettingsResult) -> Vec<Block> {
    let reason = settings.diagonal_ratio_reason.as_deref().unwrap_or_default();
    let chosen = settings.settings.diagonal_ratio;
    let text = format!("Diagonal ratio K = {}. {reason}", format_significant(chosen, 7));
    let mut blocks = vec![Block::Paragraph(text)];
    if settings.candidates.is_empty() {
        return blocks;
    }
    let row = |c: &CandidateResult| {
        vec![
            format_fixed(c.diagonal_ratio, 5),
            c.profile_crowning_by.to_owned(),
            format_significant(c.score, 3),
            format_fixed(c.worm_occupation_mm, 1),
            format_significant(c.ideal_error_um, 2),
            c.refused.clone().unwrap_or_default(),
        ]
    };
    blocks.push(Block::Table(Table {
        caption: "Diagonal ratios compared".to_owned(),
        columns: vec![
            Column::number("K", ""),
            Column::text("Profile crowning by"),
            Column::number("Score", "share of limits"),
            Column::number("Occupation", "mm"),
            Column::number("Model error", "µm"),
            Column::text("Remark"),
        ],
        rows: settings.candidates.iter().map(row).collect(),
        note: "Score: largest share of a limit that dressing corrections or centre distance use; least is best, \
               above 1 is not allowed."
            .to_owned(),
    }));
    blocks
}
