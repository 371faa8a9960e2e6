//! Which part of every characteristic all teeth share.

use foundation::geometry::Flank;
use report::cells::{fixed, fixed_or_none, flank_title};
use report::charts::ChartError;
use report::data::{Column, Table};

/// The test of a characteristic.
#[derive(Clone, Debug, PartialEq)]
pub struct TestRow {
    /// Flank.
    pub flank: Flank,
    /// Its symbol, for example `f_Hα`.
    pub symbol: String,
    /// Teeth.
    pub teeth: usize,
    /// What they share.
    pub common_um: f64,
    /// Standard uncertainty of that.
    pub uncertainty_um: Option<f64>,
    /// Above this it is corrected.
    pub limit_um: Option<f64>,
    /// Probability by chance.
    pub p: Option<f64>,
    /// Amplitude around the gear.
    pub harmonic_um: Option<f64>,
    /// What follows, in words.
    pub decision: String,
}

pub(super) fn table(rows: &[TestRow]) -> Result<Table, ChartError> {
    let row = |test: &TestRow| {
        let name = &test.symbol;
        Ok(vec![
            flank_title(test.flank).to_owned(),
            name.clone(),
            test.teeth.to_string(),
            fixed(name, test.common_um, 3)?,
            fixed_or_none(name, test.uncertainty_um, 3)?,
            fixed_or_none(name, test.limit_um, 3)?,
            match test.p {
                Some(p) if p < 0.001 => "< 0.001".into(),
                p => fixed_or_none(name, p, 3)?,
            },
            fixed_or_none(name, test.harmonic_um, 3)?,
            test.decision.clone(),
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
        rows: rows.iter().map(row).collect::<Result<_, ChartError>>()?,
        note: "Deviations from the target, normal to the flank; slopes are positive where material rises towards the tip or the upper \
               face. A characteristic is corrected where its common part is above the limit, by chance in less than the share p of all \
               cases. What goes around the gear once a turn comes from clamping, and no setting removes it."
            .into(),
    })
}
