//! The opposite flank while a plan's worm is dressed: the largest tip land that clears it
//! (`docs/mathematics/dressing.md#limits-of-a-correction`). Knows no worm function.

use super::{GeneratingError, GrindingSetup};
use dressing::{DresserSection, DresserTool, SectionOutline, ShownWorm, ThreadSpace, WormFlank};
use foundation::geometry::{Flank, Sides};
use foundation::kinematics::DressingCorrection;
use foundation::numerics::{Chebyshev, equidistant};

/// Where along the worm the dresser has least room.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LeastRoom {
    /// The largest tip land that clears the opposite flank there, mm; `None` if a dresser without land cuts into it.
    pub tip_land: Option<f64>,
    /// DK there.
    pub dk: DressingCorrection,
}

/// Worm positions at which the clearance is looked at: DK(v) is smooth.
const POSITIONS: usize = 17;

impl LeastRoom {
    /// For the motion DK(v) of one flank by a dresser of tip radius `tip_radius` (mm). `left_out`: threads removed across the space.
    ///
    /// # Errors
    /// Those of [`DresserSection`].
    pub fn of_motion(
        tool: &DresserTool,
        tip_radius: f64,
        flank: Flank,
        corrections: &[Chebyshev; 4],
        left_out: u32,
    ) -> Result<Self, GeneratingError> {
        let section = DresserSection::new(tool, flank, tip_radius)?;
        // At worm position v the dresser works about z = -v, all of it within a pitch; the space of a conical worm is another
        // one elsewhere.
        let worm = &tool.flanks[flank].worm;
        let reach =
            (2.0 * std::f64::consts::PI * tool.flanks[flank].chain.screw_parameter / worm.teeth).abs();
        let (from, to) = corrections[0].interval();
        let mut least: Option<Self> = None;
        for v in equidistant([from, to], POSITIONS) {
            let dk = std::array::from_fn(|j| corrections[j].value(v));
            let space = ThreadSpace { left_out, width: Some([-v - reach, -v + reach]) };
            let here = Self { tip_land: section.largest_tip_land(&dk, 0.0, space)?, dk };
            if here.tip_land.is_none() {
                return Ok(here);
            }
            if least.is_none_or(|least| here.tip_land < least.tip_land) {
                least = Some(here);
            }
        }
        least.ok_or(GeneratingError::NotDressed)
    }

    /// Thread space and dresser with a tip land there, as a picture shows them; a conical worm at z = 0.
    ///
    /// # Errors
    /// Those of [`DresserSection::outline`].
    pub fn outline(
        &self,
        setup: &GrindingSetup,
        (tool, tip_radius): (&DresserTool, f64),
        flank: Flank,
        tip_land: f64,
        left_out: u32,
    ) -> Result<SectionOutline, GeneratingError> {
        let worm = ShownWorm {
            flanks: Sides::from_fn(|flank| WormFlank {
                flank: tool.flanks[flank].worm,
                range: tool.flanks[flank].range,
            }),
            left_out,
            radii: [setup.worm_root_radius, setup.worm_tip_radius],
            b: 0.0,
        };
        Ok(DresserSection::new(tool, flank, tip_radius)?.outline(&self.dk, tip_land, &worm)?)
    }
}
