//! The cutters of the file.

use super::super::expected::Expected;
use super::super::given::{Checked, number};
use super::super::ledger::Ledger;
use foundation::geometry::{Cutter, CutterShape};
use serde::Deserialize;

/// Length of the edges, mm: files give none, so that no contact height is beyond them.
pub(super) const EDGES: f64 = 1000.0;

/// A cutter as the file has it.
#[derive(Clone, Copy, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
pub(super) enum Tool {
    /// An end mill with a corner radius.
    End {
        #[serde(rename = "R_mm")]
        radius: f64,
        #[serde(rename = "rc_mm", default)]
        corner: f64,
    },
    /// A ball.
    Ball {
        #[serde(rename = "R_mm")]
        radius: f64,
    },
    /// A cone.
    Cone {
        #[serde(rename = "R0_mm")]
        radius: f64,
        #[serde(rename = "kappa_deg")]
        half_angle: f64,
        #[serde(rename = "rc_mm", default)]
        corner: f64,
    },
}

impl Tool {
    /// The checked cutter.
    pub fn cutter(&self) -> Checked<Cutter> {
        let shape = match *self {
            Self::End { radius, corner } => CutterShape::end_mill(radius, corner),
            Self::Ball { radius } => CutterShape::ball(radius),
            Self::Cone { radius, half_angle, corner } => {
                CutterShape::Conical { radius, half_angle: half_angle.to_radians(), corner_radius: corner }
            }
        };
        of_shape(shape, EDGES)
    }
}

/// A checked cutter.
pub(super) fn of_shape(shape: CutterShape, edges: f64) -> Checked<Cutter> {
    Ok(Cutter::new(shape, edges, Vec::new())?)
}

/// An end mill whose sizes stand beside other quantities.
pub(super) fn end_mill(expected: &mut Expected<'_>, ledger: &mut Ledger) -> Checked<Cutter> {
    let [radius, corner] = [number(expected, "R_mm", ledger)?, number(expected, "rc_mm", ledger)?];
    of_shape(CutterShape::end_mill(radius, corner), EDGES)
}
