//! `explore.json`, `explore.csv` and `explore.html` of a ranked catalogue. Every file appears whole or not at all.

use super::outcome::{CatalogueOutcome, CataloguePair, LifeCurve, LifePoint, PairFlank};
use super::plans_page::{plan_figures, plan_sections};
use super::whole::PairPlan;
use foundation::geometry::Flank;
use job::{Cell, Column, CsvError, CsvTable};
use report::charts::{ChartError, LineChart, Panel, Series, Svg, format_significant, line_chart};
use report::{Banner, Block, Column as PageColumn, Fact, Figure, PlanReport, Section, Stamp, Table, html};
use run::{WriteError, write_study};
use std::path::{Path, PathBuf};

/// Rows of the ranking on the page; all of them stand in `explore.csv`.
const ROWS: usize = 100;
/// Worms and dressers up to which the page shows every pair in one table.
const MATRIX: [usize; 2] = [40, 14];

/// Writes the files of a ranking into `directory` (made if missing); returns their paths, the page last.
///
/// # Errors
/// [`WriteError`]; files written before the error stay.
pub fn write_catalogue(outcome: &CatalogueOutcome, directory: &Path) -> Result<Vec<PathBuf>, WriteError> {
    write_study(outcome, table(outcome)?.text(), &html::render(&page(outcome)?), directory)
}

/// A figure of a flank with its column.
type OfFlank = (Column, fn(&PairFlank) -> Option<f64>);

const OF_FLANKS: [[OfFlank; 8]; 2] = [
    [
        (Column::new("left_crowning_by_motion", "um"), |f| Some(f.crowning_by_motion_um)),
        (Column::new("left_d_phi_S", "deg"), |f| Some(f.d_phi_s_deg)),
        (Column::new("left_d_gamma", "deg"), |f| Some(f.d_gamma_deg)),
        (Column::new("left_d_d", "mm"), |f| Some(f.d_d_mm)),
        (Column::new("left_d_v_yA", "mm"), |f| Some(f.d_v_ya_mm)),
        (Column::new("left_stretch", "percent"), |f| Some(100.0 * f.stretch)),
        (Column::new("left_profile_error", "um"), |f| Some(f.profile_error_um)),
        (Column::new("left_largest_tip_land", "mm"), |f| f.largest_tip_land_mm),
    ],
    [
        (Column::new("right_crowning_by_motion", "um"), |f| Some(f.crowning_by_motion_um)),
        (Column::new("right_d_phi_S", "deg"), |f| Some(f.d_phi_s_deg)),
        (Column::new("right_d_gamma", "deg"), |f| Some(f.d_gamma_deg)),
        (Column::new("right_d_d", "mm"), |f| Some(f.d_d_mm)),
        (Column::new("right_d_v_yA", "mm"), |f| Some(f.d_v_ya_mm)),
        (Column::new("right_stretch", "percent"), |f| Some(100.0 * f.stretch)),
        (Column::new("right_profile_error", "um"), |f| Some(f.profile_error_um)),
        (Column::new("right_largest_tip_land", "mm"), |f| f.largest_tip_land_mm),
    ],
];

/// A figure of a plan with its column.
type OfPlan = (Column, fn(&PairPlan) -> f64);

const OF_PLAN: [OfPlan; 4] = [
    (Column::new("deviation", "um"), |p| p.deviation_um),
    (Column::new("tolerance_share", ""), |p| p.tolerance_share),
    (Column::new("diagonal_ratio", ""), |p| p.diagonal_ratio),
    (Column::new("used_width", "mm"), |p| p.used_width_mm),
];

const RANGES: [[Column; 2]; 2] = [
    [Column::new("left_least_crowning", "um"), Column::new("left_largest_crowning", "um")],
    [Column::new("right_least_crowning", "um"), Column::new("right_largest_crowning", "um")],
];

/// All pairs in the order of the ranking.
fn table(outcome: &CatalogueOutcome) -> Result<CsvTable, CsvError> {
    let mut columns = vec![
        Column::new("rank", ""),
        Column::new("worm", ""),
        Column::new("dresser", ""),
        Column::new("ok", ""),
        Column::new("largest_share_of_limit", ""),
        Column::new("worm_pitch_diameter", "mm"),
        Column::new("life_to_pitch_diameter", "mm"),
        Column::new("life_ended_by", ""),
    ];
    columns.extend(OF_FLANKS.iter().flatten().map(|(column, _)| *column));
    columns.extend(OF_PLAN.iter().map(|(column, _)| *column));
    for (flank, columns_of) in Flank::BOTH.into_iter().zip(RANGES) {
        if outcome.wanted_over_width.contains_key(flank.name()) {
            columns.extend(columns_of);
        }
    }
    columns.push(Column::new("refused", ""));
    columns.push(Column::new("reason", ""));
    let mut table = CsvTable::new(&columns);
    let number = |x: Option<f64>| x.map_or(Cell::Empty, Cell::Number);
    for pair in &outcome.pairs {
        let ended = pair.life.as_ref().and_then(|life| life.ended_by.as_ref());
        let mut row = vec![
            Cell::Number(pair.rank as f64),
            Cell::Word(&pair.worm),
            Cell::Word(&pair.dresser),
            Cell::Word(if pair.ok { "yes" } else { "no" }),
            number(pair.largest_share_of_limit),
            number(pair.worm_pitch_diameter_mm),
            number(pair.life.as_ref().map(|life| life.to_mm)),
            ended.map_or(Cell::Empty, |refused| Cell::Word(refused.code)),
        ];
        for (flank, quantities) in Flank::BOTH.into_iter().zip(&OF_FLANKS) {
            let known = pair.flanks.get(flank.name());
            row.extend(quantities.iter().map(|(_, value)| number(known.and_then(value))));
        }
        row.extend(OF_PLAN.iter().map(|(_, value)| number(pair.plan.as_ref().map(value))));
        for flank in Flank::BOTH {
            if outcome.wanted_over_width.contains_key(flank.name()) {
                let range = pair.crowning_range.get(flank.name());
                row.extend([number(range.map(|r| r.least_um)), number(range.map(|r| r.largest_um))]);
            }
        }
        row.push(pair.refused.as_ref().map_or(Cell::Empty, |refused| Cell::Word(refused.code)));
        row.push(pair.refused.as_ref().map_or(Cell::Empty, |refused| Cell::Word(&refused.text)));
        table.push_cells(&row)?;
    }
    Ok(table)
}

/// A number with fixed decimals; what rounds to zero has no sign.
pub fn fixed(x: Option<f64>, decimals: usize) -> String {
    let Some(x) = x else { return "–".into() };
    let text = format!("{x:.decimals$}");
    match text.strip_prefix('-') {
        Some(rest) if rest.chars().all(|c| c == '0' || c == '.') => rest.to_owned(),
        Some(rest) => format!("−{rest}"),
        None => text,
    }
}

/// A share as a whole percentage.
pub fn percent(x: Option<f64>) -> String {
    fixed(x.map(|x| 100.0 * x), 0)
}

/// The page of a ranking.
///
/// # Errors
/// [`ChartError`] for numbers that cannot be drawn.
pub fn page(outcome: &CatalogueOutcome) -> Result<PlanReport, ChartError> {
    let shown = if outcome.ok > 0 { "the first one of the ranking" } else { "the one that comes nearest" };
    let (ok, all) = (outcome.ok, outcome.pairs.len());
    let headline = if outcome.is_by_plans() {
        format!("{ok} of {all} pairs meet the target as planned. The figures are those of {shown}.")
    } else {
        format!("{ok} of {all} pairs make the profile. The figures are those of {shown}.")
    };
    let figures = outcome.pairs.first().map_or_else(Vec::new, |pair| {
        let mut figures = vec![
            Fact::new("Worm", pair.worm.clone()),
            Fact::new("Dresser", pair.dresser.clone()),
            Fact::new(
                "Largest share of an axis limit",
                format!("{} %", percent(pair.largest_share_of_limit)),
            ),
            Fact::new("Stretch P", format!("{} %", fixed(pair.largest(|f| 100.0 * f.stretch), 2))),
            Fact::new("Profile error", format!("{} µm", fixed(pair.largest(|f| f.profile_error_um), 3))),
        ];
        figures.extend(plan_figures(pair));
        if let Some(life) = &pair.life {
            let pitch = |d: f64| fixed(Some(d), 2);
            figures.push(Fact::new(
                "Pitch diameter of the worm, now and at its end",
                format!("{} → {} mm", pitch(life.from_mm), pitch(life.to_mm)),
            ));
        }
        if let Some(refused) = &pair.refused {
            figures.push(Fact::new("Not made because", refused.text.clone()));
        }
        figures
    });
    let mut sections = Vec::new();
    let pairs = match matrix(outcome) {
        Some(table) => vec![Block::Table(table)],
        None => Vec::new(),
    };
    sections.push(Section::new("all-pairs", "All pairs", pairs));
    if outcome.is_by_plans() {
        sections.extend(plan_sections(outcome)?);
    }
    if let Some(svg) = life_chart(&outcome.lives)? {
        let caption = "From the present worm to the worn one, left flank (else the one that is ground). Without corrections: the \
            profile crowning that stands on the gear if only distance and phase are set; with them it is the wanted one. Filled: \
            the target is made; open: a limit is exceeded.";
        let figure = Block::Figure(Figure::new("life-of-the-worm", svg, caption));
        sections.push(Section::new("the-life-of-the-best-pairs", "The life of the best pairs", vec![figure]));
    }
    sections.push(Section::new("ranking", "Ranking", vec![Block::Table(ranking(outcome))]));
    sections.push(Section::new("limits", "Limits", vec![Block::Table(limits(outcome))]));
    let wanted: Vec<String> = outcome
        .wanted_profile_crowning_um
        .iter()
        .map(|(flank, um)| format!("{flank} {} µm", format_significant(*um, 4)))
        .collect();
    let asked = [
        Fact::new("Profile crowning, form to tip", wanted.join(", ")),
        Fact::new("Tolerance", format!("{} µm", format_significant(outcome.tolerance_um, 4))),
    ];
    let status = if outcome.ok > 0 { Stamp::Study } else { Stamp::NotProducible };
    let figures = figures.into_iter().chain(asked).collect();
    Ok(outcome.head.clone().page(Banner { status, headline, figures }, sections))
}

/// Worms down, dressers across; `None` for a catalogue that no page holds.
fn matrix(outcome: &CatalogueOutcome) -> Option<Table> {
    if outcome.worms.len() > MATRIX[0] || outcome.dressers.len() > MATRIX[1] {
        return None;
    }
    let cell = |worm: &String, dresser: &String| {
        let pair = outcome.pairs.iter().find(|p| p.worm == *worm && p.dresser == *dresser);
        pair.map_or_else(String::new, |p| match &p.refused {
            Some(_) if p.plan.is_some() => {
                format!("{} µm", fixed(p.plan.as_ref().map(|plan| plan.deviation_um), 2))
            }
            None => format!("✓ {} %", percent(p.largest_share_of_limit)),
            Some(refused) => match refused.code {
                "axis-limit" => format!("{} %", percent(p.largest_share_of_limit)),
                code => code.replace('-', " "),
            },
        })
    };
    let mut columns = vec![PageColumn::name("Worm")];
    columns.extend(outcome.dressers.iter().map(PageColumn::text));
    let row = |worm: &String| {
        let mut row = vec![worm.clone()];
        row.extend(outcome.dressers.iter().map(|dresser| cell(worm, dresser)));
        row
    };
    Some(Table {
        caption: String::new(),
        columns,
        rows: outcome.worms.iter().map(row).collect(),
        note: if outcome.is_by_plans() {
            "Largest share of an axis limit that the plan of the pair takes; where it misses the target, what it leaves; else why there is no \
             plan."
        } else {
            "Largest share of an axis limit that the pair takes, or why it does not make the profile."
        }
        .into(),
    })
}

/// A quantity over the life with the title of its panel.
type OfLife = (&'static str, fn(&LifePoint) -> Option<f64>);

/// Value of the left flank, or of the one that is ground.
fn of_first(point: &LifePoint, of: fn(&PairFlank) -> f64) -> Option<f64> {
    point.flanks.values().map(of).next()
}

const OF_LIFE: [OfLife; 7] = [
    ("crowning without corrections [µm]", |p| p.uncorrected_crowning_um.values().copied().next()),
    ("largest share of an axis limit [%]", |p| p.largest_share_of_limit.map(|share| 100.0 * share)),
    ("Δφ_S [°]", |p| of_first(p, |f| f.d_phi_s_deg)),
    ("Δγ [°]", |p| of_first(p, |f| f.d_gamma_deg)),
    ("Δd [mm]", |p| of_first(p, |f| f.d_d_mm)),
    ("Δv_yA [mm]", |p| of_first(p, |f| f.d_v_ya_mm)),
    ("profile stretch P [%]", |p| of_first(p, |f| 100.0 * f.stretch)),
];

fn life_chart(lives: &[LifeCurve]) -> Result<Option<Svg>, ChartError> {
    let mut panels = Vec::new();
    for (title, value) in OF_LIFE {
        let mut series = Vec::new();
        for life in lives {
            let now = life.points.first().map_or(0.0, |p| p.worm_pitch_diameter_mm);
            let points: Vec<(f64, f64, bool)> = life
                .points
                .iter()
                .filter_map(|p| Some((now - p.worm_pitch_diameter_mm, value(p)?, p.refused.is_none())))
                .collect();
            if points.is_empty() {
                continue;
            }
            let name = format!("{} · {} (from {} mm)", life.worm, life.dresser, fixed(Some(now), 1));
            let series_of =
                Series::new(name, points.iter().map(|p| p.0).collect(), points.iter().map(|p| p.1).collect());
            series.push(series_of.marked(points.iter().map(|p| p.2).collect()));
        }
        if !series.is_empty() {
            panels.push(Panel::linear(title, 1e-6, series));
        }
    }
    if panels.is_empty() {
        return Ok(None);
    }
    let chart = LineChart {
        title: "Life of the worm".into(),
        x_title: "dressed off the present diameter of the worm [mm]".into(),
        panels,
    };
    line_chart(&chart).map(Some)
}

fn ranking(outcome: &CatalogueOutcome) -> Table {
    let row = |p: &CataloguePair| {
        let verdict = match (&p.refused, p.life.as_ref().and_then(|life| life.ended_by.as_ref())) {
            (Some(refused), _) => refused.text.clone(),
            (None, _) if p.plan.is_some() => "meets the target as planned".into(),
            (None, Some(end)) => format!("makes it; before the worm is used up it ends: {}", end.text),
            (None, None) => "makes it".into(),
        };
        vec![
            p.rank.to_string(),
            p.worm.clone(),
            p.dresser.clone(),
            percent(p.largest_share_of_limit),
            fixed(p.largest(|f| f.d_phi_s_deg.abs()), 3),
            fixed(p.largest(|f| f.d_gamma_deg), 3),
            fixed(p.largest(|f| f.d_d_mm), 3),
            fixed(p.largest(|f| f.d_v_ya_mm.abs()), 2),
            fixed(p.largest(|f| 100.0 * f.stretch), 2),
            fixed(p.largest(|f| f.profile_error_um), 3),
            fixed(p.tip_land_mm(), 2),
            fixed(p.worm_pitch_diameter_mm, 2),
            fixed(p.life.as_ref().map(|life| life.to_mm), 2),
            verdict,
        ]
    };
    let rest = outcome.pairs.len().saturating_sub(ROWS);
    let more = if rest > 0 { format!(" More rows in explore.csv: {rest}.") } else { String::new() };
    Table {
        caption: String::new(),
        columns: vec![
            PageColumn::number("Rank", ""),
            PageColumn::name("Worm"),
            PageColumn::name("Dresser"),
            PageColumn::number("Limit", "%"),
            PageColumn::number("|Δφ_S|", "°"),
            PageColumn::number("Δγ", "°"),
            PageColumn::number("Δd", "mm"),
            PageColumn::number("|Δv_yA|", "mm"),
            PageColumn::number("P", "%"),
            PageColumn::number("Error", "µm"),
            PageColumn::number("Land", "mm"),
            PageColumn::number("d_S", "mm"),
            PageColumn::number("to", "mm"),
            PageColumn::text("Verdict"),
        ],
        rows: outcome.pairs.iter().take(ROWS).map(row).collect(),
        note: format!(
            "Ranking: {}. Of two flanks the larger value. Limit: largest share of an axis limit. Error: largest distance from the wanted \
             profile. Land: largest tip land that clears the opposite flank. To: pitch diameter down to which the pair makes the profile.{more}",
            outcome.ranking
        ),
    }
}

fn limits(outcome: &CatalogueOutcome) -> Table {
    let l = &outcome.limits;
    let mut rows = vec![
        vec!["|Δφ_S|".into(), format!("{}°", format_significant(l.d_phi_s_deg, 4))],
        vec!["|Δγ|".into(), format!("{}°", format_significant(l.d_gamma_deg, 4))],
        vec!["|Δd|".into(), format!("{} mm", format_significant(l.d_d_mm, 4))],
        vec!["|Δv_yA|".into(), format!("{} mm", format_significant(l.d_v_ya_mm, 4))],
    ];
    rows.extend(l.stretch.map(|p| vec!["|P|".into(), format!("{} %", format_significant(100.0 * p, 4))]));
    rows.push(vec![
        "tip land, where the catalogue states none".into(),
        format!("at least {} mm", format_significant(l.smallest_tip_land_mm, 4)),
    ]);
    rows.push(vec![
        "distance from the opposite flank".into(),
        format!("at least {} mm", format_significant(l.clearance_mm, 4)),
    ]);
    rows.push(vec![
        "distance from the wanted profile between the pitch points".into(),
        format!("at most {} µm", format_significant(outcome.tolerance_um, 4)),
    ]);
    Table {
        caption: String::new(),
        columns: vec![PageColumn::symbols("Quantity"), PageColumn::text("Limit")],
        rows,
        note: if outcome.is_by_plans() {
            "Figures of dressing are those of the profile crowning of the target over the whole width; plans and their verdict are of the \
             whole flank."
        } else {
            "Of the target the profile crowning alone is ranked; planning makes the whole flank with the best pair and has it proven."
        }
        .into(),
    }
}
