//! Whether a dresser that works on one worm would cut into the flanks of another one: undermining of worms of smaller diameter
//! (`docs/mathematics/dressing.md#limits-of-a-correction`). Knows no wanted modification.

use crate::limits::swept_circle::FlankSweep;
use crate::{Clearance, DresserSection, DressingError, GeometricRange};
use foundation::geometry::{InvoluteFlank, Sides};
use foundation::kinematics::DressingCorrection;

/// A worm flank and the part of it that is used.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WormFlank {
    /// The unmodified flank.
    pub flank: InvoluteFlank,
    /// Used lengths of roll.
    pub range: GeometricRange,
}

impl DresserSection<'_> {
    /// Where the dresser at `dk`, moved as for its own worm, comes closest to both flanks of another worm in each of the planes
    /// z = b (mm): undermining where f < 0. The groove centres of both worms stand on one line at z = 0. `None` where the
    /// dresser does not reach the used flank.
    ///
    /// # Errors
    /// [`DressingError::TipLand`], [`DressingError::NoContact`]; [`DressingError::InvalidNumber`] for another number of threads
    /// or hand, flanks of the wrong side, and a plane that is not finite.
    pub fn undermining(
        &self,
        dk: &DressingCorrection,
        tip_land: f64,
        other: &Sides<WormFlank>,
        b: &[f64],
    ) -> Result<Sides<Vec<Option<Clearance>>>, DressingError> {
        self.check_land(tip_land)?;
        self.check_other(other, b)?;
        let (pose, number) = self.seat(dk)?;
        Ok(other.map(|_, worm| {
            b.iter()
                .map(|&b| {
                    let sweep = FlankSweep::new(pose, &worm.flank, worm.range, number, 0.0, b);
                    self.nearest_to(&sweep, tip_land)
                })
                .collect()
        }))
    }

    /// Refuses another worm that cannot stand in the place of the own one, and planes that are none.
    pub(crate) fn check_other(&self, other: &Sides<WormFlank>, b: &[f64]) -> Result<(), DressingError> {
        let own = &self.tool().flanks[self.flank()].worm;
        let refuse = |field, value, allowed| Err(DressingError::InvalidNumber { field, value, allowed });
        for (flank, worm) in other.iter() {
            if worm.flank.teeth != own.teeth {
                return refuse(
                    "threads of the other worm",
                    worm.flank.teeth,
                    "those of the dresser's own worm",
                );
            }
            if worm.flank.flank != flank || worm.flank.twist_per_length() * own.twist_per_length() <= 0.0 {
                let twist = worm.flank.twist_per_length();
                return refuse(
                    "twist of the other worm",
                    twist,
                    "the hand of the own worm, left flank as left",
                );
            }
            if !(worm.range.w_nf > 0.0 && worm.range.w_na > worm.range.w_nf && worm.range.w_na.is_finite()) {
                return refuse("w_NfS of the other worm", worm.range.w_nf, "0 < w_NfS < w_NaS");
            }
        }
        if let Some(&b) = b.iter().find(|b| !b.is_finite()) {
            return refuse("worm position b", b, "a finite length");
        }
        Ok(())
    }
}
