//! Times of operations and of the whole program.

use super::shown_motion::ShownMotion;
use crate::workflow::ProgramOperation;
use report::charts::format_fixed;
use report::{Column, Table};

/// Operations of a motion with what sets their times.
pub(super) fn table(shown: &ShownMotion<'_>) -> Table {
    let s = |x: f64| format_fixed(x, 1);
    let mut rows: Vec<Vec<String>> = shown
        .result
        .operations
        .iter()
        .map(|operation| {
            let mut limits: Vec<(&String, &usize)> = operation.limited_by.iter().collect();
            limits.sort_by(|a, b| b.1.cmp(a.1).then(a.0.cmp(b.0)));
            let limits: Vec<String> = limits.iter().map(|(name, count)| format!("{name} {count}")).collect();
            let [a, b] = operation.rotary_travel_deg.map(|deg| format_fixed(deg, 0));
            vec![
                operation.name.clone(),
                operation.tool.to_string(),
                operation.blocks.to_string(),
                s(operation.one_space_s),
                s(operation.cutting_s),
                s(operation.rapid_s),
                s(operation.cutting_s + operation.rapid_s),
                limits.join(", "),
                format!("{a} / {b}"),
            ]
        })
        .collect();
    let sum = |of: &dyn Fn(&ProgramOperation) -> f64| shown.result.operations.iter().map(of).sum::<f64>();
    rows.push(vec![
        "all".into(),
        String::new(),
        shown.result.blocks.to_string(),
        s(shown.result.one_space_s),
        s(sum(&|operation| operation.cutting_s)),
        s(sum(&|operation| operation.rapid_s)),
        s(shown.result.duration_s),
    ]);
    Table {
        caption: format!("Cycle times: {}", shown.controls),
        columns: vec![
            Column::text("Operation"),
            Column::number("Tool", ""),
            Column::number("Blocks", ""),
            Column::number("One space", "s"),
            Column::number("Cutting", "s"),
            Column::number("Rapid", "s"),
            Column::number("Whole", "s"),
            Column::text("Time of cuts set by"),
            Column::number("Rotary travel", "deg"),
        ],
        rows,
        note: "Cutting, rapid and whole are of all spaces. What sets the time: the feed, or the axis that would be too fast, with the \
               number of blocks. Changes of tools and the control's braking are not in the times."
            .into(),
    }
}
