//! Dressing in strokes: what each dresses and with which corrections, as a table and as charts over the worm position.

use super::motions::{DressingCurves, correction_chart};
use crate::workflow::executed_strokes::ExecutedStroke;
use foundation::geometry::{Flank, Sides};
use report::charts::{ChartError, Series, format_fixed};
use report::{Block, Column, Figure, Table};

/// The strokes of one flank with their corrections as curves.
type Shown<'a> = [(&'a ExecutedStroke, DressingCurves)];

/// Table and charts of the strokes of each flank; empty without strokes.
pub(super) fn figures(strokes: &Sides<&[ExecutedStroke]>) -> Result<Vec<Block>, ChartError> {
    let mut blocks = Vec::new();
    for (flank, strokes) in strokes.iter().filter(|(_, strokes)| !strokes.is_empty()) {
        let curves =
            |stroke: &ExecutedStroke| DressingCurves::over(&stroke.motion, stroke.corrections[0].interval());
        let shown: Vec<_> = strokes.iter().map(|stroke| (stroke, curves(stroke))).collect();
        blocks.push(Block::Table(table(flank, &shown)));
        // Constant corrections need no chart.
        if shown.iter().any(|(_, curves)| varies(curves)) {
            blocks.push(chart(flank, &shown)?);
        }
    }
    Ok(blocks)
}

fn varies(motion: &DressingCurves) -> bool {
    let lists = [&motion.d_phi_s_deg, &motion.d_gamma_deg, &motion.d_d_mm, &motion.d_v_ya_mm];
    lists.into_iter().any(|list| list.windows(2).any(|pair| pair[0] != pair[1]))
}

/// The value in the middle of a list.
fn middle(list: &[f64]) -> f64 {
    list.get(list.len() / 2).copied().unwrap_or(0.0)
}

fn table(flank: Flank, strokes: &Shown<'_>) -> Table {
    let row = |(k, (stroke, m)): (usize, &(&ExecutedStroke, DressingCurves))| {
        let mut cells = vec![(k + 1).to_string(), (stroke.place.dresser + 1).to_string()];
        let figures = [
            (stroke.place.range[0], 3),
            (stroke.place.range[1], 3),
            (middle(&m.d_phi_s_deg), 5),
            (middle(&m.d_gamma_deg), 5),
            (middle(&m.d_d_mm), 5),
            (middle(&m.d_v_ya_mm), 5),
        ];
        cells.extend(figures.map(|(value, decimals)| format_fixed(value, decimals)));
        cells
    };
    Table {
        caption: format!("Strokes of the {flank} worm flank"),
        columns: vec![
            Column::number("Stroke", ""),
            Column::number("Dresser", ""),
            Column::number("from w_1", "mm"),
            Column::number("to w_1", "mm"),
            Column::number("d_φS", "°"),
            Column::number("d_γ", "°"),
            Column::number("d_d", "mm"),
            Column::number("d_vyA", "mm"),
        ],
        rows: strokes.iter().enumerate().map(row).collect(),
        note: "Corrections in the middle of the worm; the files hold all positions.".to_owned(),
    }
}

fn chart(flank: Flank, strokes: &Shown<'_>) -> Result<Block, ChartError> {
    let svg =
        correction_chart(format!("Strokes of the {flank} worm flank over the worm position"), |pick| {
            let series = |(k, (_, motion)): (usize, &(&ExecutedStroke, DressingCurves))| {
                let list = pick(motion);
                let at = middle(list);
                let change = list.iter().map(|x| x - at).collect();
                Series::new(format!("stroke {}", k + 1), motion.v_zs_mm.clone(), change)
            };
            strokes.iter().enumerate().map(series).collect()
        })?;
    let id = format!("strokes-of-the-{flank}-worm-flank-over-the-worm-position");
    let caption = "Changes of the corrections against those in the middle of the worm.";
    Ok(Block::Figure(Figure::new(id, svg, caption)))
}
