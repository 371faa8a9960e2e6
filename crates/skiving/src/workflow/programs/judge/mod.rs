//! Any text held against a measurement or a scan of the job, by what its axes do: every recording and every edge is found by where the
//! tool stands, not by its place in the text's lines; what is wrong is reported with its block. Shares no step with the layout of programs.

mod following;
mod limits;
mod recordings;
mod scans;
mod ways;

pub(super) use following::{Followed, Motion, follow};
pub(super) use limits::limits;
pub(super) use recordings::recordings;
pub(super) use scans::scans;
pub(super) use ways::{Between, ways};

use super::stand::Stander;
use verdict::Remark;

/// What of a text serves the job.
#[derive(Clone, Debug, Default)]
pub(super) struct Judged {
    /// Recordings or edges that are as the job wants them.
    pub sound: usize,
    /// Greatest way of the flank between where the ideal tool touches and the nominal place of those that were found, mm.
    pub difference: f64,
    /// Greatest distance of the beam's axis from where the contacts want it, mm.
    pub axis_distance: f64,
    /// What is wrong, each with its block.
    pub faults: Vec<Remark>,
}

impl Judged {
    /// Takes in how far a place is off; gives it in words if `allowed` does not explain it.
    pub(super) fn off(&mut self, [difference, axis]: [f64; 2], allowed: f64) -> Option<String> {
        let difference = difference.abs();
        self.difference = self.difference.max(difference);
        self.axis_distance = self.axis_distance.max(axis);
        // Written so that NaN is off.
        let explained = difference <= allowed && axis <= allowed;
        (!explained).then(|| {
            let [found, axis, allowed] = [difference, axis, allowed].map(|x| x * 1e3);
            format!(
                "the ideal tool touches {found:.4} um off its nominal place, the beam lies {axis:.4} um off; digits explain {allowed:.6} um"
            )
        })
    }
}

/// Limits of every axis and the ways beside what is recorded.
///
/// # Errors
/// Positions that are not finite.
pub(super) fn beside(
    followed: &Followed,
    stander: &Stander<'_>,
    between: &Between<'_>,
) -> Result<Vec<Remark>, run::RunFailure> {
    let mut faults = followed.faults.clone();
    faults.extend(limits(followed, stander.machine));
    faults.extend(ways(followed, stander, between)?);
    Ok(faults)
}

/// A fault with its block in front.
pub(super) fn fault(code: &'static str, block: usize, text: &str, way_out: &'static str) -> Remark {
    Remark::new(code, format!("block {block}: {text}"), way_out)
}
