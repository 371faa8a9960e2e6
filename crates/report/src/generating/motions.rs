//! Grinding motion, dressing corrections and convergence: charts with their tables.

use super::data::{ConvergenceRound, DressingMotion, GrindingMotion};
use crate::charts::{
    ChartError, LineChart, Panel, Series, Svg, YScale, format_fixed, format_significant, line_chart,
};
use crate::data::{Block, Column, Figure, Table};
use foundation::geometry::{Flank, Sides};

/// Rows of a table on the page; the files hold all of them.
const MOST_ROWS: usize = 17;

fn flank_name(side: Flank) -> &'static str {
    match side {
        Flank::Left => "left flank",
        Flank::Right => "right flank",
    }
}

/// The grinding motion over the feed, a panel for each axis.
///
/// # Errors
/// [`ChartError`] for motions that are not finite or of different length, or without any motion.
pub fn grinding_motion_chart(motions: &[GrindingMotion]) -> Result<Svg, ChartError> {
    let swivels = motions.iter().any(|m| m.delta_gamma_deg.iter().any(|&x| x != 0.0));
    let panel = |title: &str, least_span: f64, pick: fn(&GrindingMotion) -> &Vec<f64>| {
        let series =
            motions.iter().map(|m| Series::new(&m.flanks, m.z_v2_mm.clone(), pick(m).clone())).collect();
        Panel::linear(title, least_span, series)
    };
    let mut panels = vec![
        panel("Worm shift z_V1 [mm]", 0.1, |m| &m.z_v1_mm),
        panel("Centre distance Δd [µm]", 0.01, |m| &m.delta_d_um),
        panel("Workpiece rotation Δφ_2 [µrad]", 0.1, |m| &m.delta_phi_2_urad),
    ];
    if swivels {
        panels.push(panel("Crossed-axes angle Δγ [°]", 1e-4, |m| &m.delta_gamma_deg));
    }
    line_chart(&LineChart {
        title: "Grinding motion over the axial feed".to_owned(),
        x_title: "z_V2 [mm]".to_owned(),
        panels,
    })
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

pub(super) fn dressing(motions: &Sides<Option<DressingMotion>>) -> Result<Vec<Block>, ChartError> {
    let present: Vec<(Flank, &DressingMotion)> =
        motions.iter().filter_map(|(side, motion)| motion.as_ref().map(|motion| (side, motion))).collect();
    if present.is_empty() {
        return Ok(Vec::new());
    }
    let panel = |title: &str, least_span: f64, pick: fn(&DressingMotion) -> &Vec<f64>| {
        let series = present
            .iter()
            .map(|(side, motion)| {
                Series::new(flank_name(*side), motion.v_zs_mm.clone(), pick(motion).clone())
            })
            .collect();
        Panel::linear(title, least_span, series)
    };
    let svg = line_chart(&LineChart {
        title: "Dressing corrections over the worm position".to_owned(),
        x_title: "v_zS [mm]".to_owned(),
        panels: vec![
            panel("Worm rotation d_φS [°]", 1e-4, |m| &m.d_phi_s_deg),
            panel("Crossing angle d_γ [°]", 1e-4, |m| &m.d_gamma_deg),
            panel("Centre distance d_d [mm]", 1e-4, |m| &m.d_d_mm),
            panel("Tangential offset d_vyA [mm]", 1e-4, |m| &m.d_v_ya_mm),
        ],
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

pub(super) fn convergence(rounds: &[ConvergenceRound]) -> Result<Vec<Block>, ChartError> {
    if rounds.is_empty() {
        return Ok(Vec::new());
    }
    let mut series = Vec::new();
    for side in Flank::BOTH {
        let points: Vec<(f64, f64)> =
            rounds.iter().filter_map(|r| r.error_um[side].map(|error| (f64::from(r.round), error))).collect();
        if !points.is_empty() {
            let (x, y) = points.into_iter().unzip();
            series.push(Series::new(flank_name(side), x, y));
        }
    }
    let mut blocks = Vec::new();
    if rounds.len() > 1 && !series.is_empty() {
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
    let cell = |error: Option<f64>| error.map_or("–".to_owned(), |v| format_significant(v, 2));
    blocks.push(Block::Table(Table {
        caption: String::new(),
        columns: vec![
            Column::number("Round", ""),
            Column::number("Largest error, left", "µm"),
            Column::number("Largest error, right", "µm"),
        ],
        rows: rounds
            .iter()
            .map(|r| vec![r.round.to_string(), cell(r.error_um.left), cell(r.error_um.right)])
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
