//! The cutters of a job as bodies, each with what holds it.

use crate::job::{MillingCutter, MillingJob};
use foundation::geometry::Cutter;
use run::{RunFailure, geometry_finding};
use verdict::Remark;

/// Cutters with their shanks, in the spindle where the job names a machine.
pub(super) struct Cutters {
    /// Of the flanks.
    pub finishing: Cutter,
    /// Of the bottom, where it has its own.
    pub bottom: Option<Cutter>,
    /// For clearing the space, where that has its own.
    pub roughing: Option<Cutter>,
}

impl Cutters {
    pub fn of_job(job: &MillingJob) -> Result<Self, RunFailure> {
        let spindle = job.machine.as_ref().map(|machine| machine.spindle_diameter);
        let cutter = |cutter: &MillingCutter, table: &str| {
            let spindle = job.tool_length_of(cutter).zip(spindle);
            let body = cutter.body().and_then(|body| match spindle {
                Some((tool_length, diameter)) => body.in_spindle(tool_length, diameter),
                None => Ok(body),
            });
            body.map_err(|error| RunFailure::bad_input(geometry_finding(&error, table)))
        };
        let other = |given: &Option<MillingCutter>, table| {
            given.as_ref().map(|given| cutter(given, table)).transpose()
        };
        Ok(Self {
            finishing: cutter(&job.cutter, "cutter")?,
            bottom: other(&job.bottom_cutter, "bottom_cutter")?,
            roughing: other(&job.roughing_cutter, "roughing_cutter")?,
        })
    }

    /// Ends cutters without a known shank at the radius of a bore, so that only their edges are kept from the other side of the ring; a
    /// remark if there are some.
    pub fn in_bore(&mut self, bore: f64) -> Option<Remark> {
        let all = [Some(&mut self.finishing), self.bottom.as_mut(), self.roughing.as_mut()];
        let free: Vec<_> = all.into_iter().flatten().filter(|cutter| !cutter.is_held()).collect();
        if free.is_empty() {
            return None;
        }
        free.into_iter().for_each(|cutter| *cutter = cutter.clone().ending_at(bore));
        Some(Remark {
            code: "holder-not-judged",
            text: "neither shank nor spindle of a cutter is known, so that only its edges are kept from the other side of the ring".into(),
            way_out: "list neck, shank and holder in `shank`, or give [machine] with `tool_length` and `spindle_diameter`".into(),
        })
    }
}
