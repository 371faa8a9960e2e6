//! What is done where a path comes near the pole (`docs/mathematics/milling.md#positions-of-five-axes`): the axes take their time, the
//! first rotary axis is held, or the workpiece is tilted.

use super::at_pole::AtPole;
use super::failure::of_motion;
use super::passes::ToolPasses;
use foundation::geometry::Cutter;
use motion::milling::{
    AxisCourse, CutterPlace, DEFAULT_CAP, MillingSetup, PoleStrategy, TiltedMount, tilt_mount,
};
use run::RunFailure;

impl Default for AtPole {
    fn default() -> Self {
        Self::Slow { cap: DEFAULT_CAP }
    }
}

/// Greatest tilt of the workpiece that is tried: 30 degrees, rad.
const GREATEST_TILT: f64 = std::f64::consts::PI / 6.0;

impl AtPole {
    /// theta_cap.
    pub(super) fn cap(self) -> f64 {
        let (Self::Slow { cap } | Self::Hold { cap } | Self::Mount { cap }) = self;
        cap
    }

    /// How the positions along a path of this cutter are chosen.
    pub(super) fn strategy(self, cutter: Option<&Cutter>) -> PoleStrategy {
        match (self, cutter) {
            (Self::Hold { cap }, Some(cutter)) => PoleStrategy::Hold { cutter: *cutter.shape(), cap },
            _ => PoleStrategy::Slow,
        }
    }

    /// The tilt that all paths need; none unless that is how the pole is avoided.
    ///
    /// # Errors
    /// [`RunFailure`] where no tilt is enough.
    pub(super) fn tilt(
        self,
        setup: &MillingSetup<'_>,
        tools: &[ToolPasses],
    ) -> Result<Option<TiltedMount>, RunFailure> {
        let Self::Mount { cap } = self else { return Ok(None) };
        let paths = tools.iter().flat_map(|tool| &tool.passes).map(|pass| &pass.places[pass.cut()]);
        let paths: Vec<&[CutterPlace]> = paths.collect();
        tilt_mount(setup, &paths, cap, GREATEST_TILT).map(Some).map_err(|error| of_motion(&error, ""))
    }
}

/// By how much a ball of this radius (mm) leaves its straight way where the cutter's axis turns on a block because an axis is held:
/// tip and axis go straight, so that the ball goes through an arc about the tip.
pub(super) fn bulge(course: &AxisCourse, radius: f64) -> f64 {
    let turn = |k: usize| {
        let [a, b] = [k - 1, k].map(|place| course.places[place].axis.xyz);
        a.cross(&b).norm().atan2(a.dot(&b))
    };
    let beside_held = (1..course.places.len())
        .filter(|k| [*k - 1, *k].into_iter().any(|place| course.axis_errors[place] > 0.0));
    beside_held.map(|k| radius * (1.0 - (0.5 * turn(k)).cos())).fold(0.0, f64::max)
}
