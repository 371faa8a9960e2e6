//! The lines of one flank as work for a machine.

use crate::workflow::line_dressing::WrittenFlank;
use crate::workflow::programs::cylinders::CLEARANCE;
use crate::workflow::programs::indexing::Indexing;
use crate::workflow::programs::technology::Technology;
use foundation::geometry::{Flank, Sides};
use motion::{LineCourse, MotionError};
use std::f64::consts::TAU;

/// Height over the flank at which the disc goes from line to line, above the largest dressing stock, mm.
const OVER_STOCK: f64 = 0.15;
/// A stroke counts as a line up to this height over the flank, above the largest dressing stock, mm.
const COUNTED: f64 = 0.1;
/// The lift out of the thread space is above that from line to line by at least this, mm.
const LEAST_LIFT: f64 = 1.0;

/// The lines of one flank of the worm.
#[derive(Clone, Copy, Debug)]
pub struct LineWork<'a> {
    /// The flank.
    pub flank: Flank,
    /// Its lines.
    pub written: &'a WrittenFlank,
}

impl<'a> LineWork<'a> {
    /// The flanks that a run writes by lines.
    pub fn of_run(written: &'a Sides<Option<WrittenFlank>>) -> Vec<Self> {
        let of = |(flank, written): (Flank, &'a Option<WrittenFlank>)| {
            written.as_ref().map(|written| Self { flank, written })
        };
        written.iter().filter_map(of).collect()
    }

    /// Its name: capital letters and blanks.
    pub fn name(&self) -> String {
        format!("DRESSING {} FLANK BY LINES", self.flank.name().to_uppercase())
    }

    /// Lines of one thread.
    pub fn count(&self) -> usize {
        self.written.plan.lines.len()
    }

    /// A line in the space of a thread, `stock` mm above the wanted flank.
    ///
    /// # Errors
    /// [`MotionError::InvalidNumber`] for a line of fewer than four places.
    pub fn course(
        &self,
        line: usize,
        (thread, threads): (u32, u32),
        stock: f64,
        technology: &Technology,
    ) -> Result<LineCourse, MotionError> {
        let written = self.written;
        let mut path = written.path(line).map_err(|_| MotionError::InvalidNumber {
            field: "nodes of a dressing line",
            value: written.plan.nodes as f64,
            allowed: "at least 4, over a line that has a length",
        })?;
        let turned = -TAU / f64::from(threads) * f64::from(thread);
        let angle = if stock > 0.0 { turned + stock / self.stock_per_angle() } else { turned };
        path.worm_angle = path.worm_angle.raised(angle);
        Ok(LineCourse {
            path,
            backwards: line % 2 == 1,
            contacts: written.contacts[line].clone(),
            reach: written.bodies.worm_pitch_radius,
            mounts: technology.dressing,
        })
    }

    /// Stock that turning the worm against the disc leaves, the same all over an involute helicoid, mm/rad.
    fn stock_per_angle(&self) -> f64 {
        let worm = &self.written.bodies.worm;
        let (w, z) = self.written.plan.lines.first().map_or((0.0, 0.0), |line| line.point(line.range[0]));
        let (p, n) = (worm.point(w, z), worm.frame(w, z).n);
        // Turning the worm by d moves the disc by -d z x p against it.
        -(n.y * p.x - n.x * p.y)
    }

    /// Height over the flank up to which a stroke counts as a line, mm.
    pub fn counted_below(&self, technology: &Technology) -> f64 {
        largest_stock(technology) + COUNTED
    }

    /// Lift with which the disc goes from line to line, mm.
    pub fn hop(&self, technology: &Technology) -> f64 {
        let contacts = self.written.contacts.iter().flatten();
        let per_lift = contacts.map(|contact| contact.normal.x).fold(f64::INFINITY, f64::min);
        (largest_stock(technology) + OVER_STOCK) / per_lift
    }

    /// Lift that brings the disc out of the thread space, mm.
    pub fn lift(&self, technology: &Technology) -> f64 {
        let out = self.written.bodies.worm_tip_radius - self.written.plan.deepest + CLEARANCE;
        technology.clearance.max(out).max(self.hop(technology) + LEAST_LIFT)
    }

    /// Greatest speed of the disc on its way against the worm, mm/s: that of the worm's pitch cylinder.
    pub fn speed(&self, technology: &Technology) -> f64 {
        self.written.bodies.worm_pitch_radius * technology.dressing_speed
    }

    /// A thread as operators read it.
    pub fn on_thread(&self, thread: u32, indexing: &Indexing) -> String {
        if indexing.active.len() > 1 {
            format!("{} THREAD {} OF {}", self.name(), thread + 1, indexing.threads)
        } else {
            self.name()
        }
    }
}

/// Largest stock of the dressing strokes before the last, mm.
fn largest_stock(technology: &Technology) -> f64 {
    technology.dressing_stock.iter().copied().fold(0.0, f64::max)
}
