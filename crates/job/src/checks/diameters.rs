//! Diameters of worm and dresser, for whatever process and wherever a job names them: the pitch circle lies inside the
//! tip circle. Knows no table of a job.

use crate::contradiction::contradiction;
use crate::diagnostic::{Diagnostic, Problem};
use crate::node::shown_number;

/// `[worm]`: at least one diameter, the pitch circle inside the tip circle.
pub fn worm_diameters(pitch: Option<f64>, tip: Option<f64>, findings: &mut Vec<Diagnostic>) {
    if pitch.is_none() && tip.is_none() {
        findings.push(
            Diagnostic::new(Problem::MissingKey, "`worm` has no diameter")
                .field("worm.tip_diameter")
                .allowed("tip_diameter or pitch_diameter, or both")
                .way_out("add the present tip diameter of the worm in mm"),
        );
    }
    inside_tip("worm", pitch, tip, "leave `pitch_diameter` out: it follows from the tip diameter", findings);
}

/// A dresser, `at` in the job: the pitch circle inside the tip circle.
pub fn dresser_diameters(at: &str, pitch: Option<f64>, tip: f64, findings: &mut Vec<Diagnostic>) {
    let way_out = "leave `pitch_diameter` out: the disc tip then touches the worm root";
    inside_tip(at, pitch, Some(tip), way_out, findings);
}

/// The pitch circle of a body inside its tip circle, where both are given.
pub fn inside_tip(
    at: &str,
    pitch: Option<f64>,
    tip: Option<f64>,
    way_out: &str,
    findings: &mut Vec<Diagnostic>,
) {
    if let (Some(pitch), Some(tip)) = (pitch, tip)
        && pitch >= tip
    {
        findings.push(
            Diagnostic::new(
                Problem::InvalidGeometry,
                format!("the pitch diameter {pitch} is not below the tip diameter {tip}"),
            )
            .field(format!("{at}.pitch_diameter"))
            .value(shown_number(pitch))
            .allowed(format!("< {}", shown_number(tip)))
            .way_out(way_out),
        );
    }
}

/// The clearance at the worm's root places a dresser that is not placed by its pitch diameter.
pub fn root_clearance(pitch: Option<f64>, clearance: Option<f64>, findings: &mut Vec<Diagnostic>) {
    if let (Some(_), Some(clearance)) = (pitch, clearance) {
        findings.push(contradiction(
            "the pitch diameter already says how deep the dresser enters the worm",
            "dresser.root_clearance",
            shown_number(clearance),
            "no key, or no dresser.pitch_diameter",
            "leave one of the two out",
        ));
    }
}
