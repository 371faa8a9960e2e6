//! Arranges what tangential dressing adds into sections.

use super::data::{
    ComparedMethod, FitRecord, PassReport, RadialFeedReport, SensitivityMap, TangentialReport,
};
use report::charts::{
    ChartError, ContourMap, LineChart, NamedTopography, Panel, Series, YScale, contour_map, format_fixed,
    format_significant, line_chart,
};
use report::data::{Block, Column, Figure, Section, Table};
use report::kebab;

/// Id of the section of variables, which belongs to the settings.
pub const VARIABLES: &str = "variables";

impl TangentialReport {
    /// The sections, in reading order.
    ///
    /// # Errors
    /// [`ChartError`] for values that are not finite.
    pub fn sections(&self) -> Result<Vec<Section>, ChartError> {
        let mut variables = Vec::new();
        let mut fits = Vec::new();
        for pass in &self.passes {
            variables.extend(of_pass(pass));
            fits.extend(fit_of_pass(pass)?);
        }
        let mut lengths: Vec<Block> = self.remarks.iter().cloned().map(Block::Paragraph).collect();
        if !self.worm_length.is_empty() {
            lengths.push(Block::Table(Table::of_quantities("", &self.worm_length)));
        }
        let all = [
            (VARIABLES, "Variables of dressing and grinding", variables),
            ("how-the-values-were-found", "How the values were found", fits),
            ("radial-feed", "Beside it: crowning by radial feed", radial(&self.radial_feed)?),
            ("worm-length-and-passes", "Worm length and passes", lengths),
            ("sensitivities", "Sensitivity topographies", sensitivities(&self.sensitivities)?),
        ];
        Ok(all
            .into_iter()
            .filter(|(.., blocks)| !blocks.is_empty())
            .map(|(id, title, blocks)| Section::new(id, title, blocks))
            .collect())
    }
}

fn of_pass(pass: &PassReport) -> Vec<Block> {
    let mut blocks = Vec::new();
    if !pass.variables.is_empty() {
        blocks.push(Block::Table(Table {
            caption: format!("{}: values", pass.name),
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
                    vec![v.name.clone(), v.meaning.clone(), format_significant(v.value, 6), v.unit.clone()]
                })
                .collect(),
            note: "The digit is the power of the abscissa: s/m_n on the dresser's profile, 2 x_D/b_w along the worm, 2 z/b_g along \
                   the gear. Positive profile thins the dresser."
                .to_owned(),
        }));
    }
    if !pass.selection.is_empty() {
        blocks.push(Block::Table(Table {
            caption: format!("{}: how the set came about", pass.name),
            columns: vec![
                Column::text("Step"),
                Column::number("Variables", ""),
                Column::number("Largest deviation", "µm"),
            ],
            rows: pass
                .selection
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

fn fit_of_pass(pass: &PassReport) -> Result<Vec<Block>, ChartError> {
    let mut blocks = Vec::new();
    if let Some(fit) = &pass.fit {
        blocks.push(Block::Paragraph(fit_in_words(pass, fit)));
        if fit.by_round_um.len() > 1 {
            blocks.push(Block::Figure(convergence(pass, fit)?));
        }
    }
    if !pass.compared.is_empty() {
        blocks.push(Block::Table(compared(pass)));
    }
    Ok(blocks)
}

fn fit_in_words(pass: &PassReport, fit: &FitRecord) -> String {
    let settled = if fit.converged { "settled" } else { "did not settle" };
    let stepped =
        if fit.steps > 1 { format!(", the target stepped up in {} parts", fit.steps) } else { String::new() };
    format!(
        "{}: method {}{stepped}, {} rounds, {settled} at a weighted root mean square of {} µm.",
        pass.name,
        fit.method,
        fit.rounds,
        format_significant(fit.weighted_rms_um, 4)
    )
}

fn convergence(pass: &PassReport, fit: &FitRecord) -> Result<Figure, ChartError> {
    let mut y = fit.by_round_um.clone();
    y.push(fit.weighted_rms_um);
    let x: Vec<f64> = (0..y.len()).map(|k| k as f64).collect();
    let filled = vec![true; y.len()];
    let chart = LineChart {
        title: format!("{}: convergence", pass.name),
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
    let id = format!("{}-convergence", kebab(&pass.name));
    Ok(Figure::new(id, line_chart(&chart)?, caption))
}

fn compared(pass: &PassReport) -> Table {
    let row = |c: &ComparedMethod| {
        let mut cells = vec![c.method.clone(), c.steps.to_string()];
        match &c.outcome {
            Ok((rounds, rms, largest, converged)) => cells.extend([
                rounds.to_string(),
                format_significant(*rms, 4),
                format_significant(*largest, 4),
                if *converged { "settled".to_owned() } else { "rounds ran out".to_owned() },
            ]),
            Err(why) => cells.extend(["–".to_owned(), "–".to_owned(), "–".to_owned(), why.clone()]),
        }
        cells
    };
    Table {
        caption: format!("{}: methods beside each other", pass.name),
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

fn radial(flanks: &[RadialFeedReport]) -> Result<Vec<Block>, ChartError> {
    if flanks.is_empty() {
        return Ok(Vec::new());
    }
    let or_dash = |x: Option<f64>| x.map_or("–".to_owned(), |x| format_fixed(x, 3));
    let mut blocks = vec![Block::Table(Table {
        caption: "Both methods side by side".to_owned(),
        columns: vec![
            Column::text("Flank"),
            Column::number("Helix crowning, normal", "µm"),
            Column::number("Twist of radial feed, closed form", "µm"),
            Column::number("Twist of radial feed, contact", "µm"),
            Column::number("Twist of tangential dressing", "µm"),
            Column::number("Largest deviation, radial feed", "µm"),
            Column::number("Largest deviation, tangential dressing", "µm"),
        ],
        rows: flanks
            .iter()
            .map(|f| {
                vec![
                    f.flank.clone(),
                    format_fixed(f.crowning_um, 3),
                    format_fixed(f.closed_twist_um, 3),
                    or_dash(f.twist_um),
                    format_fixed(f.tangential_twist_um, 3),
                    or_dash(f.largest_um),
                    format_fixed(f.tangential_largest_um, 3),
                ]
            })
            .collect(),
        note: "Twist from the corners, normal, positive = material removed, without what the target itself wants. Radial feed: a worm \
               that does not shift and has no modification along it, the best profile in the dresser, a parabola of the centre \
               distance over the feed."
            .to_owned(),
    })];
    for flank in flanks {
        if let Some(why) = &flank.refused {
            blocks.push(Block::Paragraph(format!("{}: {why}.", flank.flank)));
        }
        if let Some((radial, tangential)) = &flank.maps {
            let map = ContourMap {
                title: format!("Deviation from the target, {}", flank.flank.to_lowercase()),
                quantity: "m − f [µm]".into(),
                panels: vec![
                    NamedTopography::new("Radial feed", radial.clone()),
                    NamedTopography::new("Tangential dressing", tangential.clone()),
                ],
                scale: None,
            };
            let caption = "What each method leaves of the same target, on one scale.";
            let id = format!("deviation-from-the-target-{}", kebab(&flank.flank));
            blocks.push(Block::Figure(Figure::new(id, contour_map(&map)?, caption)));
        }
    }
    Ok(blocks)
}

/// Maps beside each other in one chart.
const BESIDE: usize = 3;

/// One chart a channel and flank, so that the powers of a channel share a scale.
fn sensitivities(maps: &[SensitivityMap]) -> Result<Vec<Block>, ChartError> {
    let mut blocks = Vec::new();
    if !maps.is_empty() {
        blocks.push(Block::Paragraph(
            "What a unit of each variable does to the unmodified flank, exact derivatives. Positive: material is left. The powers of a \
             channel share a scale. All numbers stand in sensitivities.csv."
                .to_owned(),
        ));
    }
    let mut rest = maps;
    while let Some(first) = rest.first() {
        let count = rest
            .iter()
            .take(BESIDE)
            .take_while(|m| m.channel == first.channel && m.flank == first.flank)
            .count();
        let (group, others) = rest.split_at(count);
        rest = others;
        let names: Vec<&str> = group.iter().map(|m| m.variable.as_str()).collect();
        if group.iter().all(|m| m.map.range_um() == (0.0, 0.0)) {
            let text =
                format!("{}, {}: no effect of first order.", names.join(", "), first.flank.to_lowercase());
            blocks.push(Block::Paragraph(text));
            continue;
        }
        let map = ContourMap {
            title: format!("Sensitivity to {}, {}", names.join(", "), first.flank.to_lowercase()),
            quantity: if first.unit.is_empty() { "dm/dc".into() } else { first.unit.clone() },
            panels: group.iter().map(|m| NamedTopography::new(&m.variable, m.map.clone())).collect(),
            scale: None,
        };
        let id = kebab(&format!("sensitivity to {} {}", names.join(" "), first.flank));
        blocks.push(Block::Figure(Figure::new(id, contour_map(&map)?, "")));
    }
    Ok(blocks)
}
