//! Whether the dresser of a pair comes too close to what it does not dress: opposite flank, and the worm that is left later
//! (`docs/mathematics/dressing.md#limits-of-a-correction`).

use super::pair::{Pair, PairFigures};
use super::refusal::Refusal;
use crate::{DresserSection, DresserTool, DressingError, ThreadSpace, WormFlank, WormSeat};
use foundation::geometry::Flank;
use foundation::kinematics::DressingCorrection;

impl Pair<'_> {
    fn section<'t>(&self, tool: &'t DresserTool, flank: Flank) -> Result<DresserSection<'t>, DressingError> {
        DresserSection::new(tool, flank, self.dresser.size.tip_radius)
    }

    /// Width that the tip land has, or must at least have.
    fn needed_land(&self) -> f64 {
        self.dresser.tip_land.unwrap_or(self.limits.tip_land)
    }

    /// Largest tip land that clears the opposite flank; `None` where none does.
    pub(super) fn largest_land(
        &self,
        tool: &DresserTool,
        flank: Flank,
        dk: &DressingCorrection,
    ) -> Result<Option<f64>, DressingError> {
        self.section(tool, flank)?.largest_tip_land(dk, self.limits.clearance, ThreadSpace::default())
    }

    /// Refuses a largest tip land that is narrower than the one needed.
    pub(super) fn check_land(&self, flank: Flank, largest: Option<f64>) -> Result<(), Refusal> {
        let needed = self.needed_land();
        // A land computed as the largest one may differ by rounding.
        if largest.is_some_and(|largest| largest >= needed * (1.0 - 1e-9)) {
            return Ok(());
        }
        Err(Refusal::TipLand { flank, largest, needed })
    }

    /// Refuses a flank on which the needed tip land comes too close to the opposite flank.
    pub(super) fn check_clearance(
        &self,
        tool: &DresserTool,
        flank: Flank,
        dk: &DressingCorrection,
    ) -> Result<(), Refusal> {
        let section = self.section(tool, flank)?;
        let needed = self.needed_land();
        let clear = needed <= section.full_land() * (1.0 + 1e-12)
            && section.counter_flank_clearance(dk, needed, ThreadSpace::default())? >= self.limits.clearance;
        if clear {
            return Ok(());
        }
        let largest = section.largest_tip_land(dk, self.limits.clearance, ThreadSpace::default())?;
        Err(Refusal::TipLand { flank, largest, needed })
    }

    /// Refuses a pair that, dressing the worm in its present state with its corrections, cuts into the worn worm that remains later. The leads of both
    /// differ, so that the ends of the worm decide.
    pub(super) fn check_undermining(
        &self,
        now: &WormSeat,
        figures: &PairFigures,
        later: &WormSeat,
    ) -> Result<(), Refusal> {
        let tool = self.designed.tool.on_worm(now)?;
        let other = later.worm.flanks().map(|flank, &f| WormFlank { flank: f, range: later.ranges[flank] });
        let half = 0.5 * self.worm.width;
        for (flank, dk) in figures.corrections().iter() {
            let Some(dk) = dk else { continue };
            let section = self.section(&tool, flank)?;
            let land = self.needed_land().min(section.full_land());
            let found = section.undermining(dk, land, &other, &[-half, 0.0, half])?;
            for (_, planes) in found.iter() {
                if let Some(at) = planes.iter().flatten().find(|at| at.f < 0.0) {
                    let pitch_diameter = 2.0 * later.reference_radius();
                    return Err(Refusal::Undermined { flank, cut: -at.f, pitch_diameter, b: at.b });
                }
            }
        }
        Ok(())
    }
}
