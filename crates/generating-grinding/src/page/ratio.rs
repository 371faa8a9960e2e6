//! The diagonal ratio, why it was chosen, and what was compared with it.

use crate::workflow::result::{CandidateResult, SettingsResult};
use report::charts::{
    ChartError, LineChart, Panel, Series, Svg, YScale, format_fixed, format_significant, line_chart,
};
use report::{Block, Column, Figure, Table};

/// Ratios from which on a picture says more than the table.
const WORTH_A_PICTURE: usize = 3;
/// Least deviation that the picture shows, um: what is below is rounding.
const LEAST_SHOWN: f64 = 1e-3;

/// Sentence and table.
///
/// # Errors
/// [`ChartError`].
pub(super) fn choice(settings: &SettingsResult) -> Result<Vec<Block>, ChartError> {
    let reason = settings.diagonal_ratio_reason.as_deref().unwrap_or_default();
    let chosen = settings.settings.diagonal_ratio;
    let text = format!("Diagonal ratio K = {}. {reason}", format_significant(chosen, 6));
    let mut blocks = vec![Block::Paragraph(text)];
    if settings.candidates.is_empty() {
        return Ok(blocks);
    }
    if settings.candidates.len() >= WORTH_A_PICTURE {
        let caption = "Each point is a ratio. To the left a plan uses less of the worm, upwards it leaves more or asks more of the axes.";
        let trade = trade(&settings.candidates, chosen)?;
        blocks.push(Block::Figure(Figure::new("deviation-over-used-worm-width", trade, caption)));
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
    Ok(blocks)
}

/// Deviation and share of the limits over the used width of the worm.
fn trade(candidates: &[CandidateResult], chosen: f64) -> Result<Svg, ChartError> {
    let panel = |y_title: &str, value: fn(&CandidateResult) -> f64| {
        let series = |name: &str, which: &dyn Fn(&&CandidateResult) -> bool| {
            let of: Vec<&CandidateResult> = candidates.iter().filter(which).collect();
            let x = of.iter().map(|c| c.worm_occupation_mm).collect();
            (!of.is_empty()).then(|| Series::points(name, x, of.into_iter().map(value).collect()))
        };
        let is_chosen = |c: &&CandidateResult| c.diagonal_ratio == chosen;
        let ringed = candidates.iter().filter(is_chosen).map(|c| {
            ([c.worm_occupation_mm, value(c)], format!("K = {}", format_fixed(c.diagonal_ratio, 3)))
        });
        let mut all: Vec<Series> = Vec::new();
        all.extend(series("allowed", &|c| c.refused.is_none()));
        all.extend(series("not allowed", &|c| c.refused.is_some()));
        all.push(Series::rings("chosen", ringed.take(1).collect()));
        Panel { y_title: y_title.to_owned(), least_span: 0.0, scale: YScale::Logarithmic, series: all }
    };
    line_chart(&LineChart {
        title: "Diagonal ratios: what they leave and what they use".to_owned(),
        x_title: "Used width of the worm [mm]".to_owned(),
        panels: vec![
            panel("Deviation of the ideal worm [µm]", |c| c.ideal_error_um.max(LEAST_SHOWN)),
            panel("Largest share of a limit", |c| c.score.max(LEAST_SHOWN)),
        ],
    })
}
