//! The room about the beam: where a tool is drawn back to, and whether it is out of the beam on its way. Knows no steps.

use super::failure::{invalid, of_skiving};
use super::stand::Stander;
use crate::VirtualEdge;
use crate::measuring::{Beam, MeasuringPose};
use foundation::geometry::Sides;
use job::Diagnostic;
use machine::Positions;
use nalgebra::Vector3;
use run::RunFailure;

/// A beam and a tool that has to get out of it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Room {
    beam: Beam,
    /// Where it is to be drawn back to, if that is given.
    wanted: Option<Vector3<f64>>,
    /// Distance of beam and tool axis at which the tool is out of the beam, mm.
    clear: f64,
}

/// Places at which the way between two poses is looked at.
const PLACES: usize = 32;

impl Room {
    /// The room of a tool with these edges before a beam.
    ///
    /// # Errors
    /// An edge without contact at its ends.
    pub fn new(
        wanted: Option<Vector3<f64>>,
        edges: &Sides<&VirtualEdge>,
        beam: &Beam,
    ) -> Result<Self, RunFailure> {
        let mut outside = 0.0f64;
        for (_, edge) in edges.iter() {
            for w in edge.flank().range() {
                let contact = edge.contact(w).map_err(|error| of_skiving(&error))?;
                outside = outside.max(contact.point.x.hypot(contact.point.y));
            }
        }
        // Beyond the flank there is the tip's own rounding: it takes less than a module.
        let module = edges.left.pair().gear().data().normal_module;
        Ok(Self { beam: *beam, wanted, clear: outside + module + beam.radius })
    }

    /// The room of a body that leaves the beam free from a distance of its axis on, mm.
    pub fn around(beam: &Beam, clear: f64) -> Self {
        Self { beam: *beam, wanted: None, clear }
    }

    /// The direction in which the tool is drawn back from a pose.
    pub fn direction(&self, pose: &MeasuringPose) -> Result<Vector3<f64>, RunFailure> {
        if let Some(direction) = self.wanted {
            return Ok(direction);
        }
        let axis = Vector3::new(0.0, -pose.swivel.sin(), pose.swivel.cos());
        let to_beam = self.beam.point - pose.position;
        let away = axis * axis.dot(&to_beam) - to_beam;
        let length = away.norm();
        if length > 0.0 {
            Ok(away / length)
        } else {
            Err(invalid("retreat.direction", length, "a unit vector"))
        }
    }

    /// Whether the tool stays out of the beam from one place drawn back to the next; looked at in the plane of its rake face.
    ///
    /// # Errors
    /// A way that leads the tool into the beam.
    pub fn free(
        &self,
        stander: &Stander<'_>,
        [from, to]: [&Positions; 2],
        place: &str,
    ) -> Result<(), RunFailure> {
        let distance = self.nearest(stander, [from, to])?;
        if distance < self.clear {
            let text = format!(
                "{place}: on its way the tool's axis comes as near as {distance:.3} mm to the beam, {:.3} mm leave it free",
                self.clear
            );
            let finding = Diagnostic::with_code("beam-not-free", text).field("machine.retreat");
            let way_out = "draw the tool back farther, or move the light barrier";
            return Err(RunFailure::not_producible(finding.way_out(way_out)));
        }
        Ok(())
    }

    /// Distance of a point from the beam's axis, mm.
    pub fn distance(&self, point: &Vector3<f64>) -> f64 {
        self.beam.unit().cross(&(point - self.beam.point)).norm()
    }

    /// Distance of beam and tool axis at which the tool is out of the beam, mm.
    pub fn clear(&self) -> f64 {
        self.clear
    }

    /// Least distance of the tool's axis, in the plane of its rake face, from the beam on a straight way of the axes, mm.
    ///
    /// # Errors
    /// Positions that are not finite.
    pub fn nearest(&self, stander: &Stander<'_>, [from, to]: [&Positions; 2]) -> Result<f64, RunFailure> {
        let at_share = |share: f64| -> Result<f64, RunFailure> {
            let mut at = *from;
            for &axis in &stander.axes {
                at[axis] += share * (to[axis] - from[axis]);
            }
            Ok(self.distance(&stander.tool(&at)?.position))
        };
        let (mut least, mut found) = (f64::INFINITY, 0.0);
        for k in 0..=PLACES {
            let share = k as f64 / PLACES as f64;
            let distance = at_share(share)?;
            if distance < least {
                (least, found) = (distance, share);
            }
        }
        // Between the places beside the nearest one.
        let step = 1.0 / PLACES as f64;
        for k in 1..PLACES {
            let share = found + step * (2.0 * k as f64 / PLACES as f64 - 1.0);
            if (0.0..=1.0).contains(&share) {
                least = least.min(at_share(share)?);
            }
        }
        Ok(least)
    }
}
