//! The section on gearbox and servo: what they cost at the flank, over the stroke, on traces and from tooth to tooth.

use crate::workflow::control::result::{ControlFlankResult, ControlResult, Trace};
use foundation::geometry::Flank;
use report::charts::{
    ChartError, LineChart, NamedTopography, Panel, Series, Svg, Topography, TopographyNet, format_fixed,
    format_significant, line_chart, topography_net,
};
use report::{Block, Column, Figure, Quantity, Table};

const INTRODUCTION: &str = "The stroke was simulated with the control of the job instead of ideal couplings: scales and encoders are \
     counted, the gearbox sums the counts, the servo follows with inertia, friction and disturbances. The figures are what that alone \
     leaves, normal to the flank, positive where material is left standing; with constant parts removed, as centring the tooth space does.";

/// Below this span (um) a line is drawn flat: the referee and the closed form agree no further.
const FLAT: f64 = 0.01;

/// Tables and figures of the section; `grid` gives lengths of roll and axial positions of a flank of the job, mm. Nothing without flanks.
///
/// # Errors
/// [`ChartError`] for values that are not finite or lists of different length.
pub fn control_blocks(
    control: &ControlResult,
    grid: impl Fn(Flank) -> Option<[Vec<f64>; 2]>,
) -> Result<Vec<Block>, ChartError> {
    let mut flanks: Vec<(Flank, &ControlFlankResult)> = Vec::new();
    let mut nets = Vec::new();
    for side in Flank::BOTH {
        let (Some(f), Some([w, z])) = (control.flanks.get(side.name()), grid(side)) else { continue };
        nets.push(NamedTopography::new(heading(side), Topography::new(w, z, f.topography_um.clone())?));
        flanks.push((side, f));
    }
    if flanks.is_empty() {
        return Ok(Vec::new());
    }
    let mut blocks = vec![Block::Paragraph(INTRODUCTION.to_owned()), Block::Table(table(&flanks))];
    blocks.push(Block::Table(Table::of_quantities("Control", &quantities(control))));
    blocks.push(figure(
        "error-of-the-workpiece-s-angle-over-the-stroke-as-it-would-stand-on-the-flank",
        stroke(&flanks)?,
        "Every point of the flank keeps the error of the moment in which it is ground.",
    ));
    let net = topography_net(&TopographyNet {
        title: "Deviation of the first tooth by gearbox and servo".to_owned(),
        panels: nets,
        range_um: None,
    })?;
    blocks.push(figure("deviation-of-the-first-tooth-by-gearbox-and-servo", net, "Errors at the frequency of the threads stand as waves along lines of equal rotation, slower ones as waves over the face width."));
    blocks.push(figure(
        "profile-traces-of-some-teeth-by-gearbox-and-servo",
        traces(&flanks, "Profile traces of some teeth by gearbox and servo", "w [mm]", |flank| {
            (&flank.trace_w_mm, &flank.profiles)
        })?,
        "At mid face width.",
    ));
    blocks.push(figure(
        "helix-traces-of-some-teeth-by-gearbox-and-servo",
        traces(&flanks, "Helix traces of some teeth by gearbox and servo", "z [mm]", |flank| {
            (&flank.trace_z_mm, &flank.helices)
        })?,
        "At the middle of the roll.",
    ));
    blocks.push(figure(
        "mean-deviation-of-each-tooth-by-gearbox-and-servo",
        pitch(&flanks)?,
        "Errors once per turn of the workpiece stay with the tooth: they are pitch deviations.",
    ));
    Ok(blocks)
}

fn quantities(control: &ControlResult) -> Vec<Quantity> {
    vec![
        Quantity::number("speed of the worm", "n_1", control.worm_speed_rpm, "1/min"),
        Quantity::number("speed of the workpiece", "n_2", control.work_speed_rpm, "1/min"),
        Quantity::number("speed of the feed", "", control.feed_mm_per_min, "mm/min"),
        Quantity::number("pitch of the feed's scale", "p", control.scale_pitch_um, "µm"),
        Quantity::number("flank per part of the setpoint", "", control.setpoint_step_um, "µm"),
        Quantity::number("flank per count of the workpiece's encoder", "", control.encoder_step_um, "µm"),
        Quantity::number("rounding of the feed's ratio", "", control.ratio_error_um_per_m, "µm per m"),
        Quantity::number("frequency of the threads", "", control.thread_frequency_hz, "Hz"),
        Quantity::number(
            "flank per torque at that frequency",
            "",
            control.compliance_at_threads_um_per_n_m,
            "µm/Nm",
        ),
    ]
}

fn heading(side: Flank) -> String {
    format!("{side} flank")
}

fn figure(id: &str, svg: Svg, caption: &str) -> Block {
    Block::Figure(Figure::new(id, svg, caption))
}

fn table(flanks: &[(Flank, &ControlFlankResult)]) -> Table {
    Table {
        caption: "What gearbox and servo leave".to_owned(),
        columns: vec![
            Column::text("Flank"),
            Column::number("Largest", "µm"),
            Column::number("Root mean square", "µm"),
            Column::number("Deviation from the target with it", "µm"),
            Column::number("Single pitch", "µm"),
            Column::number("Cumulative pitch", "µm"),
            Column::number("Closed form against rays in time", "µm"),
            Column::number("Greatest torque", "Nm"),
            Column::number("At the torque limit", "%"),
        ],
        rows: flanks
            .iter()
            .map(|(side, f)| {
                vec![
                    side.to_string(),
                    format_fixed(f.largest_um, 3),
                    format_fixed(f.rms_um, 3),
                    format_fixed(f.deviation_with_control_um, 3),
                    format_fixed(f.single_pitch_um, 3),
                    format_fixed(f.cumulative_pitch_um, 3),
                    format_significant(f.model_difference_um, 2),
                    format_fixed(f.greatest_torque_n_m, 2),
                    format_fixed(100.0 * f.torque_limited_share, 1),
                ]
            })
            .collect(),
        note: format!(
            "Over all teeth. The last but two: rays of the flank in the motion that was really driven less those in the ideal one, on {} places.",
            flanks.iter().map(|(_, f)| f.sample).max().unwrap_or(0)
        ),
    }
}

/// Least and greatest value of each stretch as one line.
fn band(name: &str, x: &[f64], [least, greatest]: &[Vec<f64>; 2]) -> Series {
    let both = least.iter().zip(greatest);
    let x = x.iter().flat_map(|&x| [x, x]).collect();
    Series::new(name, x, both.flat_map(|(&a, &b)| [a, b]).collect())
}

fn stroke(flanks: &[(Flank, &ControlFlankResult)]) -> Result<Svg, ChartError> {
    let panels = flanks.iter().map(|(side, f)| {
        let series = vec![
            band("workpiece", &f.error.feed_mm, &f.error.actual_um),
            band("setpoint of the gearbox", &f.error.feed_mm, &f.error.setpoint_um),
        ];
        Panel::linear(format!("{}, error at the flank [µm]", heading(*side)), FLAT, series)
    });
    line_chart(&LineChart {
        title: "Error of the workpiece's angle over the stroke, as it would stand on the flank".to_owned(),
        x_title: "z_V2 [mm]".to_owned(),
        panels: panels.collect(),
    })
}

fn traces(
    flanks: &[(Flank, &ControlFlankResult)],
    title: &str,
    x_title: &str,
    pick: impl Fn(&ControlFlankResult) -> (&Vec<f64>, &Vec<Trace>),
) -> Result<Svg, ChartError> {
    let panels = flanks.iter().map(|(side, flank)| {
        let (at, traces) = pick(flank);
        let series = traces
            .iter()
            .map(|trace| Series::new(format!("tooth {}", trace.tooth + 1), at.clone(), trace.f_um.clone()));
        Panel::linear(format!("{}, f_n [µm]", heading(*side)), FLAT, series.collect())
    });
    line_chart(&LineChart { title: title.to_owned(), x_title: x_title.to_owned(), panels: panels.collect() })
}

fn pitch(flanks: &[(Flank, &ControlFlankResult)]) -> Result<Svg, ChartError> {
    let series = flanks.iter().map(|(side, flank)| {
        let count = flank.tooth_means_um.len();
        let teeth = (1..=count).map(|tooth| tooth as f64).collect();
        Series::new(heading(*side), teeth, flank.tooth_means_um.clone())
            .marked(vec![*side == Flank::Left; count])
    });
    line_chart(&LineChart {
        title: "Mean deviation of each tooth by gearbox and servo".to_owned(),
        x_title: "tooth".to_owned(),
        panels: vec![Panel::linear("mean f_n [µm]", FLAT, series.collect())],
    })
}
