//! A dresser settled on a worm that it was not designed for: the correction at which it serves that worm becomes part of its
//! kinematics, so that zero corrections dress the worm as well as the dresser can. Knows no wanted profile.

use crate::dresser::conjugate_line;
use crate::other_worms::other_worm::LINE_MARGIN;
use crate::{DresserTool, DressingError, WormSeat, fit_profile};
use foundation::geometry::{Flank, Sides};
use foundation::kinematics::{DressingChain, DressingCorrection};

/// A chain with a correction in it.
fn moved(chain: &DressingChain, dk: &DressingCorrection) -> DressingChain {
    DressingChain {
        worm_angle: chain.worm_angle + dk[0],
        crossing_angle: chain.crossing_angle + dk[1],
        centre_distance: chain.centre_distance + dk[2],
        offset: chain.offset + dk[3],
        ..*chain
    }
}

impl DresserTool {
    /// This dresser on another worm, settled: three points of the profile without modification, the end of the designed profile on
    /// that of the used one.
    ///
    /// # Errors
    /// Those of [`DresserTool::on_worm`] and [`fit_profile`].
    pub fn settled_on(&self, seat: &WormSeat) -> Result<Self, DressingError> {
        let tool = self.on_worm(seat)?;
        let dks = Sides::try_from_fn(|flank| {
            fit_profile(&tool, flank, seat.reference_radius(), 0.0, &[0.0; 4]).map(|fit| fit.dk)
        })?;
        let mut settled = tool;
        for flank in Flank::BOTH {
            let dresser = &mut settled.flanks[flank];
            dresser.chain = moved(&dresser.chain, &dks[flank]);
            dresser.settled = dks[flank];
            dresser.line = conjugate_line(&dresser.worm, &dresser.chain, &dresser.range, LINE_MARGIN)?;
        }
        Ok(settled)
    }

    /// The same with nominal kinematics: corrections then count from there.
    pub fn unsettled(&self) -> Self {
        let mut tool = self.clone();
        for flank in Flank::BOTH {
            let dresser = &mut tool.flanks[flank];
            dresser.chain = moved(&dresser.chain, &dresser.settled.map(|x| -x));
            dresser.settled = [0.0; 4];
        }
        tool
    }
}
