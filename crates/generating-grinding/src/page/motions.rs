//! Grinding motion, dressing corrections and convergence: charts with their tables.

use crate::workflow::tables::ROWS;
use foundation::geometry::{Flank, Sides};
use foundation::kinematics::DressingMotion;
use foundation::numerics::equidistant;
use report::charts::{
    ChartError, LineChart, Panel, Series, Svg, YScale, format_fixed, format_significant, line_chart,
};
use report::{Block, Column, Figure, Table};
use run::{GrindingMotion, grinding_motion_chart};

/// Dressing corrections DK of one flank over the worm position; lists of equal length.
#[derive(Clone, Debug, PartialEq)]
pub struct DressingCurves {
    /// Axial position of the worm v_zS, mm.
    pub v_zs_mm: Vec<f64>,
    /// Change of the worm's rotation, degree.
    pub d_phi_s_deg: Vec<f64>,
    /// Change of the crossing angle, degree.
    pub d_gamma_deg: Vec<f64>,
    /// Change of the centre distance of dresser and worm, mm.
    pub d_d_mm: Vec<f64>,
    /// Change of the dresser's tangential offset, mm.
    pub d_v_ya_mm: Vec<f64>,
}

impl DressingCurves {
    /// Of a dressing motion between two worm positions, mm.
    pub fn over(motion: &DressingMotion, (from, to): (f64, f64)) -> Self {
        let v: Vec<f64> = equidistant([from, to], ROWS);
        let component = |j: usize, unit: f64| v.iter().map(|&v| motion.correction_at(v)[j] * unit).collect();
        let deg = 180.0 / std::f64::consts::PI;
        Self {
            d_phi_s_deg: component(0, deg),
            d_gamma_deg: component(1, deg),
            d_d_mm: component(2, 1.0),
            d_v_ya_mm: component(3, 1.0),
            v_zs_mm: v,
        }
    }
}

/// Rows of a table on the page; the files hold all of them.
const MOST_ROWS: usize = 17;

fn flank_name(side: Flank) -> &'static str {
    match side {
        Flank::Left => "left flank",
        Flank::Right => "right flank",
    }
}

pub(super) fn grinding(motions: &[GrindingMotion]) -> Result<Vec<Block>, ChartError> {
    if motions.is_empty() {
        return Ok(Vec::new());
    }
    let svg = grinding_motion_chart(motions)?;
    let mut blocks = vec![figure(
        "grinding-motion-over-the-axial-feed",
        svg,
        "Corrections beside the rolling motion of the electronic gearbox.",
    )];
    let tables = motions.iter().map(|motion| {
        let columns = [
            (Column::number("z_V2", "mm"), &motion.z_v2_mm, 3),
            (Column::number("z_V1", "mm"), &motion.z_v1_mm, 4),
            (Column::number("Δd", "µm"), &motion.delta_d_um, 3),
            (Column::number("Δφ_2", "µrad"), &motion.delta_phi_2_urad, 3),
        ];
        let caption = match motions {
            [_] => "Grinding motion".to_owned(),
            _ => format!("Grinding motion, {}", motion.flanks),
        };
        thinned(&caption, columns)
    });
    blocks.push(Block::Tables(tables.collect()));
    Ok(blocks)
}

/// One of the corrections over the worm position.
pub(super) type Correction = fn(&DressingCurves) -> &Vec<f64>;

/// Corrections over the worm position, a panel for each; `series` gives the lines of one.
pub(super) fn correction_chart(
    title: String,
    series: impl Fn(Correction) -> Vec<Series>,
) -> Result<Svg, ChartError> {
    let corrections: [(&str, Correction); 4] = [
        ("Worm rotation d_φS [°]", |m| &m.d_phi_s_deg),
        ("Crossing angle d_γ [°]", |m| &m.d_gamma_deg),
        ("Centre distance d_d [mm]", |m| &m.d_d_mm),
        ("Tangential offset d_vyA [mm]", |m| &m.d_v_ya_mm),
    ];
    let panels = corrections.map(|(name, pick)| Panel::linear(name, 1e-4, series(pick)));
    line_chart(&LineChart { title, x_title: "v_zS [mm]".to_owned(), panels: panels.into() })
}

pub(super) fn dressing(motions: &Sides<Option<DressingCurves>>) -> Result<Vec<Block>, ChartError> {
    let present: Vec<(Flank, &DressingCurves)> =
        motions.iter().filter_map(|(side, motion)| motion.as_ref().map(|motion| (side, motion))).collect();
    if present.is_empty() {
        return Ok(Vec::new());
    }
    let svg = correction_chart("Dressing corrections over the worm position".to_owned(), |pick| {
        let series = |(side, motion): &(Flank, &DressingCurves)| {
            Series::new(flank_name(*side), motion.v_zs_mm.clone(), pick(motion).clone())
        };
        present.iter().map(series).collect()
    })?;
    let mut blocks = vec![figure(
        "dressing-corrections-over-the-worm-position",
        svg,
        "Changes against the nominal dressing position, per flank of the worm.",
    )];
    let tables = present.into_iter().map(|(side, motion)| {
        let columns = [
            (Column::number("v_zS", "mm"), &motion.v_zs_mm, 3),
            (Column::number("d_φS", "°"), &motion.d_phi_s_deg, 6),
            (Column::number("d_γ", "°"), &motion.d_gamma_deg, 6),
            (Column::number("d_d", "mm"), &motion.d_d_mm, 6),
            (Column::number("d_vyA", "mm"), &motion.d_v_ya_mm, 6),
        ];
        thinned(&format!("Dressing corrections, {}", flank_name(side)), columns)
    });
    blocks.push(Block::Tables(tables.collect()));
    Ok(blocks)
}

/// Largest error of the model by round of the precompensation, um; nothing without rounds.
pub(super) fn convergence(by_round_um: &Sides<Vec<f64>>) -> Result<Vec<Block>, ChartError> {
    let rounds = by_round_um.left.len().max(by_round_um.right.len());
    if rounds == 0 {
        return Ok(Vec::new());
    }
    let mut series = Vec::new();
    for (side, errors) in by_round_um.iter().filter(|(_, errors)| !errors.is_empty()) {
        let x = (0..errors.len()).map(|round| round as f64).collect();
        series.push(Series::new(flank_name(side), x, errors.clone()));
    }
    let mut blocks = Vec::new();
    if rounds > 1 {
        let panel = Panel {
            y_title: "Largest error of the model [µm]".to_owned(),
            least_span: 0.0,
            scale: YScale::Logarithmic,
            series,
        };
        let title = "Convergence of the precompensation".to_owned();
        let svg = line_chart(&LineChart { title, x_title: "round".to_owned(), panels: vec![panel] })?;
        blocks.push(figure("convergence-of-the-precompensation", svg, "Round 0: commands of first order."));
    }
    let cell = |errors: &[f64], round: usize| {
        errors.get(round).map_or("–".to_owned(), |&v| format_significant(v, 2))
    };
    blocks.push(Block::Table(Table {
        caption: String::new(),
        columns: vec![
            Column::number("Round", ""),
            Column::number("Largest error, left", "µm"),
            Column::number("Largest error, right", "µm"),
        ],
        rows: (0..rounds)
            .map(|k| vec![k.to_string(), cell(&by_round_um.left, k), cell(&by_round_um.right, k)])
            .collect(),
        note: String::new(),
    }));
    Ok(blocks)
}

fn figure(id: &str, svg: Svg, caption: &str) -> Block {
    Block::Figure(Figure::new(id, svg, caption))
}

/// A table of columns of equal length with their decimals, thinned to rows that a reader can take in.
fn thinned<const N: usize>(caption: &str, columns: [(Column, &Vec<f64>, usize); N]) -> Table {
    let count = columns.iter().map(|(_, values, _)| values.len()).min().unwrap_or(0);
    let shown = count.min(MOST_ROWS);
    let rows = (0..shown)
        .map(|k| if shown < 2 { k } else { k * (count - 1) / (shown - 1) })
        .map(|k| columns.iter().map(|(_, values, decimals)| format_fixed(values[k], *decimals)).collect())
        .collect();
    let note = if shown < count {
        format!("{shown} of {count} positions; the files hold all of them.")
    } else {
        String::new()
    };
    Table { caption: caption.to_owned(), columns: columns.map(|(column, ..)| column).into(), rows, note }
}
