//! Settings of a worm grinding machine in the words of its operator: head swivel, centre distance, speeds, feed.

use super::tools::from_to;
use crate::workflow::programs::GrindingStroke;
use crate::workflow::programs::build::BuiltProgram;
use crate::workflow::programs::run_programs::RunPrograms;
use crate::workflow::programs::technology::Technology;
use machine::{Role, Station};
use report::{Quantity, Sheet};
use std::f64::consts::TAU;

/// What the settings follow from.
pub struct MachineSettings<'a> {
    /// Crossed-axes angle of worm and workpiece.
    pub crossed_axes_angle_deg: f64,
    /// Their centre distance.
    pub centre_distance_mm: f64,
    /// Largest radius of the worm, where the cutting speed is taken.
    pub worm_tip_radius_mm: f64,
    /// Threads of the worm.
    pub threads: i32,
    /// Teeth of the gear.
    pub teeth: i32,
    /// The feed's stroke, overrun included.
    pub feed_stroke_mm: [f64; 2],
    /// Feed per revolution of the gear, mm, where the job gives one.
    pub feed_given: Option<f64>,
    /// Speeds of the machine; `None` for a job that names none.
    pub technology: Option<&'a Technology>,
    /// Programs for it.
    pub programs: Option<&'a RunPrograms>,
}

impl MachineSettings<'_> {
    /// The list.
    pub fn sheet(&self) -> Sheet {
        let mut list = vec![self.head_swivel()];
        list.push(Quantity::rounded("centre distance, finishing", "a", self.centre_distance_mm, 4, "mm"));
        let mut remarks = Vec::new();
        match self.technology {
            Some(technology) => list.extend(self.speeds(technology)),
            None => {
                list.extend(self.feed_given.map(|feed| {
                    Quantity::rounded("axial feed per workpiece revolution", "f_a", feed, 3, "mm")
                }));
                remarks.push("Speeds: not given, the job names no machine.".to_owned());
            }
        }
        let [from, to] = self.feed_stroke_mm;
        list.push(Quantity::shown("axial stroke", "z_V2", from_to(from, to), "mm"));
        Sheet { title: "Machine settings".to_owned(), quantities: list, remarks }
    }

    /// The angle at which the head stands: that of the programs, else what the crossed-axes angle leaves beside a right angle.
    fn head_swivel(&self) -> Quantity {
        match self.programs.and_then(standing_tilt) {
            Some((axis, degrees)) => {
                Quantity::rounded(&format!("head swivel angle, axis {axis}"), "", degrees, 4, "deg")
            }
            None => {
                let beside = self.crossed_axes_angle_deg.abs() - 90.0;
                Quantity::rounded("head swivel angle, amount", "", beside.abs(), 4, "deg")
            }
        }
    }

    fn speeds(&self, technology: &Technology) -> Vec<Quantity> {
        let finishing = technology.finishing();
        let worm_rpm = finishing.worm_speed * 60.0 / TAU;
        let work_rpm = worm_rpm * (f64::from(self.threads) / f64::from(self.teeth)).abs();
        let cutting = finishing.worm_speed * self.worm_tip_radius_mm * 1e-3;
        let feed = finishing.feed_per_revolution;
        let mut list = vec![
            Quantity::rounded("worm speed", "n_0", worm_rpm, 0, "1/min"),
            Quantity::rounded("cutting speed", "v_c", cutting, 1, "m/s"),
            Quantity::rounded("workpiece speed", "n_2", work_rpm, 1, "1/min"),
            Quantity::rounded("axial feed per workpiece revolution", "f_a", feed, 3, "mm"),
            Quantity::rounded("axial feed rate", "v_f", feed * work_rpm, 1, "mm/min"),
        ];
        let roughing: Vec<&GrindingStroke> =
            technology.strokes.iter().filter(|stroke| !stroke.finishes()).collect();
        let of_roughing = roughing.first().filter(|stroke| stroke.feed_per_revolution != feed);
        list.extend(of_roughing.map(|stroke| {
            let name = "axial feed per workpiece revolution, first roughing stroke";
            Quantity::rounded(name, "f_a", stroke.feed_per_revolution, 3, "mm")
        }));
        let (driven, all) = (technology.strokes.len(), technology.strokes_of_a_pass());
        let roughing = roughing.len() * all / driven;
        if all > 1 {
            let name = if driven > all {
                "strokes of each flank: roughing, finishing, spark-out"
            } else {
                "strokes: roughing, finishing, spark-out"
            };
            list.push(Quantity::shown(name, "", format!("{roughing}, 1, {}", all - roughing - 1), ""));
        }
        list
    }
}

/// A way below this (deg) is rounding.
const STANDS_STILL: f64 = 1e-7;

/// Name and angle of the axis that tilts the head, where the grinding programs leave it standing; degrees, as the machine's
/// description counts.
fn standing_tilt(programs: &RunPrograms) -> Option<(String, f64)> {
    let machine = &programs.machine.machine;
    let number = machine.role(Role::Tilt)?;
    let axis = &machine.axes()[number];
    let grinding = programs.built.programs.iter().zip(&programs.result.programs);
    let (built, result): (&BuiltProgram, _) =
        grinding.into_iter().find(|(built, _)| built.station == Station::Work)?;
    let standing = result.axes.iter().find(|moved| moved.axis == axis.name && moved.way < STANDS_STILL);
    let unnamed =
        || built.layout.at_rest.iter().find(|(at, _)| *at == number).map(|(_, x)| axis.joint.shown(*x));
    Some((axis.name.clone(), standing.map(|moved| moved.from).or_else(unnamed)?))
}
