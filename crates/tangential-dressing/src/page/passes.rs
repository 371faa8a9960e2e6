//! The passes: variables with their values, how the set came about, how the values were found.

use super::heading;
use crate::workflow::{MethodResult, PassResult};
use report::charts::{ChartError, LineChart, Panel, Series, YScale, format_significant, line_chart};
use report::{Block, Column, Figure, Table, kebab};

pub(super) fn variables(pass: &PassResult) -> Vec<Block> {
    let name = heading(&pass.flanks);
    let mut blocks = Vec::new();
    if !pass.variables.is_empty() {
        blocks.push(Block::Table(Table {
            caption: format!("{name}: values"),
            columns: vec![
                Column::text("Variable"),
                Column::text("What moves"),
                Column::number("Value", ""),
                Column::text("Unit"),
            ],
            rows: pass
                .variables
                .iter()
                .map(|v| {
                    vec![v.name.clone(), v.meaning.into(), format_significant(v.value, 6), v.unit.into()]
                })
                .collect(),
            note: "The digit is the power of the abscissa: s/m_n on the dresser's profile, 2 x_D/b_w along the worm, 2 z/b_g along \
                   the gear. Positive profile thins the dresser."
                .to_owned(),
        }));
    }
    if !pass.choice.is_empty() {
        blocks.push(Block::Table(Table {
            caption: format!("{name}: how the set came about"),
            columns: vec![
                Column::text("Step"),
                Column::number("Variables", ""),
                Column::number("Largest deviation", "µm"),
            ],
            rows: pass
                .choice
                .iter()
                .map(|s| {
                    let sign = if s.taken { "+" } else { "−" };
                    vec![
                        format!("{sign} {}", s.variable),
                        s.count.to_string(),
                        format_significant(s.largest_um, 3),
                    ]
                })
                .collect(),
            note: "Forward selection takes in what explains most of what is left; backward elimination leaves out what is not needed. \
                   The set is small, not proven least."
                .to_owned(),
        }));
    }
    blocks
}

pub(super) fn fit(pass: &PassResult) -> Result<Vec<Block>, ChartError> {
    let mut blocks = vec![Block::Paragraph(fit_in_words(pass))];
    if pass.weighted_rms_by_round_um.len() > 1 {
        blocks.push(Block::Figure(convergence(pass)?));
    }
    if !pass.compared.is_empty() {
        blocks.push(Block::Table(compared(pass)));
    }
    Ok(blocks)
}

fn fit_in_words(pass: &PassResult) -> String {
    let settled = if pass.converged { "settled" } else { "did not settle" };
    let stepped = if pass.steps > 1 {
        format!(", the target stepped up in {} parts", pass.steps)
    } else {
        String::new()
    };
    format!(
        "{}: method {}{stepped}, {} rounds, {settled} at a weighted root mean square of {} µm.",
        heading(&pass.flanks),
        pass.method,
        pass.rounds,
        format_significant(pass.weighted_rms_um, 4)
    )
}

fn convergence(pass: &PassResult) -> Result<Figure, ChartError> {
    let name = heading(&pass.flanks);
    let mut y = pass.weighted_rms_by_round_um.clone();
    y.push(pass.weighted_rms_um);
    let x: Vec<f64> = (0..y.len()).map(|k| k as f64).collect();
    let filled = vec![true; y.len()];
    let chart = LineChart {
        title: format!("{name}: convergence"),
        x_title: "round".into(),
        panels: vec![Panel {
            y_title: "weighted rms [µm]".into(),
            least_span: 0.0,
            scale: YScale::Logarithmic,
            series: vec![Series::new("weighted rms of m − f", x, y).marked(filled)],
        }],
    };
    let caption =
        "Weighted root mean square of what is ground less what is wanted, before each round and at the end.";
    Ok(Figure::new(format!("{}-convergence", kebab(&name)), line_chart(&chart)?, caption))
}

fn compared(pass: &PassResult) -> Table {
    let row = |c: &MethodResult| {
        let mut cells = vec![c.method.to_owned(), c.steps.to_string()];
        match (c.rounds, c.weighted_rms_um, c.largest_um, c.converged) {
            (Some(rounds), Some(rms), Some(largest), Some(converged)) => cells.extend([
                rounds.to_string(),
                format_significant(rms, 4),
                format_significant(largest, 4),
                if converged { "settled".to_owned() } else { "rounds ran out".to_owned() },
            ]),
            _ => {
                let why = c.refused.as_ref().map_or_else(String::new, |refused| refused.text.clone());
                cells.extend(["–".to_owned(), "–".to_owned(), "–".to_owned(), why]);
            }
        }
        cells
    };
    Table {
        caption: format!("{}: methods beside each other", heading(&pass.flanks)),
        columns: vec![
            Column::text("Method"),
            Column::number("Steps of the target", ""),
            Column::number("Rounds", ""),
            Column::number("Weighted rms", "µm"),
            Column::number("Largest deviation", "µm"),
            Column::text("Remark"),
        ],
        rows: pass.compared.iter().map(row).collect(),
        note: "All from zero, with the same variables. svd: truncated singular values, every step taken; damped: the same, no step that \
               makes it worse; gauss-newton: minimum-norm steps in scaled variables."
            .to_owned(),
    }
}
