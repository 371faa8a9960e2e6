//! Puts the figures of gearbox and servo in their order.

use super::data::{ControlFlankReport, ControlReport, ToothTrace};
use crate::charts::{
    ChartError, LineChart, NamedTopography, Panel, Series, TopographyNet, format_fixed, format_significant,
    line_chart, topography_net,
};
use crate::data::{Block, Column, Figure, Table};
use foundation::geometry::Flank;

const INTRODUCTION: &str = "The stroke was simulated with the control of the job instead of ideal couplings: scales and encoders are \
     counted, the gearbox sums the counts, the servo follows with inertia, friction and disturbances. The figures are what that alone \
     leaves, normal to the flank, positive where material is left standing; with constant parts removed, as centring the tooth space does.";

/// Below this span (um) a line is drawn flat: the referee and the closed form agree no further.
const FLAT: f64 = 0.01;

impl ControlReport {
    /// Tables and figures of the section.
    ///
    /// # Errors
    /// [`ChartError`] for values that are not finite or lists of different length.
    pub fn blocks(&self) -> Result<Vec<Block>, ChartError> {
        let flanks: Vec<(Flank, &ControlFlankReport)> =
            self.flanks.iter().filter_map(|(side, flank)| Some((side, flank.as_ref()?))).collect();
        if flanks.is_empty() {
            return Ok(Vec::new());
        }
        let mut blocks = vec![Block::Paragraph(INTRODUCTION.to_owned()), Block::Table(table(&flanks))];
        blocks.push(Block::Table(Table::of_quantities("Control", &self.quantities)));
        blocks.push(figure(
            "error-of-the-workpiece-s-angle-over-the-stroke-as-it-would-stand-on-the-flank",
            stroke(&flanks)?,
            "Every point of the flank keeps the error of the moment in which it is ground.",
        ));
        let nets = flanks
            .iter()
            .map(|(side, flank)| NamedTopography::new(heading(*side), flank.first_tooth.clone()));
        let net = topography_net(&TopographyNet {
            title: "Deviation of the first tooth by gearbox and servo".to_owned(),
            panels: nets.collect(),
            range_um: None,
        })?;
        blocks.push(figure("deviation-of-the-first-tooth-by-gearbox-and-servo", net, "Errors at the frequency of the threads stand as waves along lines of equal rotation, slower ones as waves over the face width."));
        blocks.push(figure(
            "profile-traces-of-some-teeth-by-gearbox-and-servo",
            traces(&flanks, "Profile traces of some teeth by gearbox and servo", "w [mm]", |flank| {
                &flank.profiles
            })?,
            "At mid face width.",
        ));
        blocks.push(figure(
            "helix-traces-of-some-teeth-by-gearbox-and-servo",
            traces(&flanks, "Helix traces of some teeth by gearbox and servo", "z [mm]", |flank| {
                &flank.helices
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
}

fn heading(side: Flank) -> String {
    format!("{side} flank")
}

fn figure(id: &str, svg: crate::charts::Svg, caption: &str) -> Block {
    Block::Figure(Figure::new(id, svg, caption))
}

fn table(flanks: &[(Flank, &ControlFlankReport)]) -> Table {
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
                    format_fixed(f.with_control_um, 3),
                    format_fixed(f.pitch_um[0], 3),
                    format_fixed(f.pitch_um[1], 3),
                    format_significant(f.model_difference_um.0, 2),
                    format_fixed(f.torque_n_m.0, 2),
                    format_fixed(100.0 * f.torque_n_m.1, 1),
                ]
            })
            .collect(),
        note: format!(
            "Over all teeth. The last but two: rays of the flank in the motion that was really driven less those in the ideal one, on {} places.",
            flanks.iter().map(|(_, f)| f.model_difference_um.1).max().unwrap_or(0)
        ),
    }
}

/// Least and greatest value of each stretch as one line.
fn band(name: &str, x: &[f64], [least, greatest]: &[Vec<f64>; 2]) -> Series {
    let both = least.iter().zip(greatest);
    let x = x.iter().flat_map(|&x| [x, x]).collect();
    Series::new(name, x, both.flat_map(|(&a, &b)| [a, b]).collect())
}

fn stroke(flanks: &[(Flank, &ControlFlankReport)]) -> Result<crate::charts::Svg, ChartError> {
    let panels = flanks.iter().map(|(side, f)| {
        let series = vec![
            band("workpiece", &f.feed_mm, &f.actual_um),
            band("setpoint of the gearbox", &f.feed_mm, &f.setpoint_um),
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
    flanks: &[(Flank, &ControlFlankReport)],
    title: &str,
    x_title: &str,
    pick: impl Fn(&ControlFlankReport) -> &Vec<ToothTrace>,
) -> Result<crate::charts::Svg, ChartError> {
    let panels = flanks.iter().map(|(side, flank)| {
        let series = pick(flank).iter().map(|trace| {
            Series::new(format!("tooth {}", trace.tooth + 1), trace.coordinate_mm.clone(), trace.f_um.clone())
        });
        Panel::linear(format!("{}, f_n [µm]", heading(*side)), FLAT, series.collect())
    });
    line_chart(&LineChart { title: title.to_owned(), x_title: x_title.to_owned(), panels: panels.collect() })
}

fn pitch(flanks: &[(Flank, &ControlFlankReport)]) -> Result<crate::charts::Svg, ChartError> {
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
