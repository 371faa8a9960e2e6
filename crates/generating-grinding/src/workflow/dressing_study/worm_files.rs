//! Table and pictures of a dresser on other worms.

use super::files::label;
use super::{WormCurve, WormPoint};
use crate::job::StudyOver;
use job::{Cell, Column, CsvError, CsvTable};
use report::charts::{ChartError, LineChart, Panel, Series, Svg, format_significant, line_chart};
use report::{Column as PageColumn, Table};

/// A quantity of a worm that may be absent.
type OfWorm = (Column, &'static str, fn(&WormPoint) -> Option<f64>);

/// Quantities over worms.
const OF_WORMS: [OfWorm; 13] = [
    (Column::new("uncorrected_crowning", "um"), "profile crowning without corrections [µm]", |p| {
        p.uncorrected_crowning_um
    }),
    (Column::new("stretch", "percent"), "profile stretch P [%]", |p| Some(100.0 * p.stretch)),
    (Column::new("d_phi_S", "deg"), "Δφ_S [°]", |p| Some(p.d_phi_s_deg)),
    (Column::new("d_gamma", "deg"), "Δγ [°]", |p| Some(p.d_gamma_deg)),
    (Column::new("d_d", "mm"), "Δd [mm]", |p| Some(p.d_d_mm)),
    (Column::new("d_v_yA", "mm"), "Δv_yA [mm]", |p| Some(p.d_v_ya_mm)),
    (Column::new("error", "um"), "deviation of the profile with corrections [µm]", |p| Some(p.error_um)),
    (Column::new("largest_tip_land", "mm"), "largest tip land of the dresser [mm]", |p| {
        p.largest_tip_land_mm
    }),
    (Column::new("angle_without_stretch", "deg"), "pressure angle for P = 0 [°]", |p| {
        p.angle_without_stretch_deg
    }),
    (
        Column::new("angle_of_least_stretch_left", "deg"),
        "cylindrical worm of least stretch: pressure angle of the left flank [°]",
        |p| p.both_flanks?.cylindrical.map(|worm| worm.pressure_angle_left_deg),
    ),
    (Column::new("least_stretch", "percent"), "stretch that it leaves on both flanks [%]", |p| {
        let worm = p.both_flanks?.cylindrical?;
        Some(100.0 * worm.stretch_left.abs().max(worm.stretch_right.abs()))
    }),
    (Column::new("cone_without_stretch", "deg"), "conical worm without stretch: cone angle [°]", |p| {
        p.both_flanks?.conical.map(|worm| worm.cone_angle_deg)
    }),
    (
        Column::new("angle_of_cone_left", "deg"),
        "conical worm without stretch: pressure angle of the left flank [°]",
        |p| p.both_flanks?.conical.map(|worm| worm.pressure_angle_left_deg),
    ),
];

/// All points of all curves.
pub fn worm_table(curves: &[WormCurve]) -> Result<CsvTable, CsvError> {
    let mut columns = vec![Column::new("bodies", ""), Column::new("value", "")];
    columns.extend(OF_WORMS.iter().map(|(column, ..)| *column));
    let mut table = CsvTable::new(&columns);
    for curve in curves {
        for point in &curve.points {
            let mut row = vec![Cell::Word(&curve.bodies), Cell::Number(point.value)];
            row.extend(OF_WORMS.iter().map(|(_, _, value)| value(point).map_or(Cell::Empty, Cell::Number)));
            table.push_cells(&row)?;
        }
    }
    Ok(table)
}

/// Quantities over the worms, a panel each; those that no worm has are left out. `None` without points.
fn worm_chart(
    title: &str,
    x_title: &str,
    curves: &[WormCurve],
    quantities: &[OfWorm],
) -> Result<Option<Svg>, ChartError> {
    let mut panels = Vec::new();
    for (_, title, value) in quantities {
        let mut series = Vec::new();
        for c in curves {
            let (x, y): (Vec<f64>, Vec<f64>) =
                c.points.iter().filter_map(|p| value(p).map(|y| (p.value, y))).unzip();
            if !x.is_empty() {
                series.push(Series::new(label(&c.bodies), x, y));
            }
        }
        if !series.is_empty() {
            panels.push(Panel::linear(*title, 0.0, series));
        }
    }
    if panels.is_empty() {
        return Ok(None);
    }
    line_chart(&LineChart { title: title.into(), x_title: x_title.into(), panels }).map(Some)
}

/// Worms on which the dresser does not work.
pub fn worms_missing(curves: &[WormCurve]) -> Table {
    let rows = curves.iter().flat_map(|c| {
        c.missing.iter().map(|(value, refused)| {
            vec![label(&c.bodies), format_significant(*value, 6), refused.text.clone()]
        })
    });
    let rows: Vec<Vec<String>> = rows.collect();
    let note = if rows.is_empty() { "The dresser works on all worms of the study." } else { "" };
    Table {
        caption: String::new(),
        columns: vec![
            PageColumn::symbols("Bodies"),
            PageColumn::number("Worm", ""),
            PageColumn::text("Why the dresser does not work there"),
        ],
        rows,
        note: format!("{note} All points stand in explore.csv."),
    }
}

/// A picture of the page: section, name, drawing where there is something to draw, caption.
pub type WormFigure = (&'static str, &'static str, Option<Svg>, &'static str);

/// The pictures of a study over worms.
///
/// # Errors
/// [`ChartError`] for numbers that cannot be drawn.
pub fn worm_figures(curves: &[WormCurve], over: &str) -> Result<[WormFigure; 4], ChartError> {
    let x = if over == StudyOver::WormDiameter.name() {
        "pitch diameter of the worm d_S [mm]"
    } else {
        "pressure angle of the worm α_nS [°]"
    };
    let chart = |title: &str, quantities: &[OfWorm]| worm_chart(title, x, curves, quantities);
    Ok([
        (
            "Profile",
            "the-dresser-on-other-worms-profile",
            chart("The dresser on other worms: profile", &OF_WORMS[..2])?,
            "Above what comes about with nominal crossing angle and offset, distance and phase set to both ends of the profile; below \
             the stretch with corrections, by the three-point method with the radius map.",
        ),
        (
            "Corrections",
            "the-dresser-on-other-worms-corrections",
            chart("The dresser on other worms: corrections", &OF_WORMS[2..7])?,
            "Corrections against the nominal kinematics of each worm with which its profile is straight at both ends and in the middle.",
        ),
        (
            "Limits",
            "the-dresser-on-other-worms-tip-land-and-angle-without-stretch",
            chart("The dresser on other worms: tip land and angle without stretch", &OF_WORMS[7..9])?,
            "The largest tip land that clears the opposite flank, and the pressure angle of the worm for which this dresser needs no stretch.",
        ),
        (
            "Both flanks",
            "the-dresser-on-other-worms-without-stretch-on-both-flanks",
            chart("The dresser on other worms: both flanks without stretch", &OF_WORMS[9..])?,
            "The flanks of an asymmetric gear ask for different pressure angles. A cylindrical worm shares what is left between them; on a \
             conical worm neither flank is stretched.",
        ),
    ])
}
