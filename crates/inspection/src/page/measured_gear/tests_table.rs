//! Which part of every characteristic all teeth share.

use crate::workflow::CharacteristicResult;
use foundation::geometry::Flank;
use report::cells::{fixed, fixed_or_none, flank_title};
use report::charts::ChartError;
use report::{Column, Table};

pub(super) fn table(tests: &[CharacteristicResult]) -> Result<Table, ChartError> {
    let row = |test: &CharacteristicResult| {
        let name = symbol(test.characteristic);
        let flank = Flank::BOTH.into_iter().find(|flank| flank.name() == test.flank);
        Ok(vec![
            flank.map_or(test.flank, flank_title).to_owned(),
            name.to_owned(),
            test.teeth.len().to_string(),
            fixed(name, test.common_um, 3)?,
            fixed_or_none(name, test.uncertainty_um, 3)?,
            fixed_or_none(name, test.limit_um, 3)?,
            match test.p {
                Some(p) if p < 0.001 => "< 0.001".into(),
                p => fixed_or_none(name, p, 3)?,
            },
            fixed_or_none(name, test.harmonic_um, 3)?,
            decision(test.decision).to_owned(),
        ])
    };
    Ok(Table {
        caption: "What all teeth share".into(),
        columns: vec![
            Column::name("Flank"),
            Column::symbols("Characteristic"),
            Column::number("Teeth", ""),
            Column::number("Common part", "µm"),
            Column::number("Uncertainty", "µm"),
            Column::number("Limit", "µm"),
            Column::number("p by chance", ""),
            Column::number("Once a turn", "µm"),
            Column::text("What follows"),
        ],
        rows: tests.iter().map(row).collect::<Result<_, ChartError>>()?,
        note: "Deviations from the target, normal to the flank; slopes are positive where material rises towards the tip or the upper \
               face. A characteristic is corrected where its common part is above the limit, by chance in less than the share p of all \
               cases. What goes around the gear once a turn comes from clamping, and no setting removes it."
            .into(),
    })
}

fn symbol(characteristic: &str) -> &str {
    match characteristic {
        "fHa" => "f_Hα",
        "Ca" => "C_α",
        "fHb" => "f_Hβ",
        "Cb" => "C_β",
        other => other,
    }
}

/// What follows, in words.
fn decision(decision: &str) -> &str {
    match decision {
        "correct" => "CORRECT",
        "below-dead-band" => "too small to correct",
        "not-systematic" => "not systematic",
        "first-harmonic" => "clamping, no correction",
        "not-tested" => "one tooth tells nothing",
        other => other,
    }
}
