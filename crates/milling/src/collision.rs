//! Whether a cutter on its way keeps away from what it must not touch (`docs/mathematics/milling.md#root-and-clearance`): at every place
//! and between them.

use super::CutterPlace;
use super::obstacle::{Collision, Obstacle};
use super::probe::Moves;
use foundation::geometry::Cutter;

/// Motion to both sides of a place at which the cutter keeps what is wanted, below which nothing is looked for between: mm.
const STEP: f64 = 1e-3;

/// The first place of a path at which a cutter does not keep what an obstacle wants; blocks between places included.
///
/// # Errors
/// The [`Collision`].
pub fn check_path(
    cutter: &Cutter,
    places: &[CutterPlace],
    obstacles: &[Obstacle],
) -> Result<(), Box<Collision>> {
    for obstacle in obstacles {
        let check = Check { cutter, obstacle };
        if !obstacle.between || places.len() == 1 {
            for (number, place) in places.iter().enumerate() {
                check.block(number, [place, place], [0.0, 0.0])?;
            }
            continue;
        }
        for (block, ends) in places.windows(2).enumerate() {
            check.block(block, [&ends[0], &ends[1]], [0.0, 1.0])?;
        }
    }
    Ok(())
}

struct Check<'a> {
    cutter: &'a Cutter,
    obstacle: &'a Obstacle<'a>,
}

impl Check<'_> {
    /// A piece of a block: safe if the cutter keeps what is wanted wherever it moves to from its middle; else both halves.
    fn block(&self, block: usize, ends: [&CutterPlace; 2], shares: [f64; 2]) -> Result<(), Box<Collision>> {
        let [from, to] = shares.map(|share| between(ends, share));
        let share = 0.5 * (shares[0] + shares[1]);
        let middle = between(ends, share);
        let Obstacle { name, patch, wanted, .. } = self.obstacle;
        let moves = Moves::between(&middle, [&from, &to]);
        let Err(doubtful) = patch.keeps_moving(self.cutter, (&middle.tip, &middle.axis), &moves, *wanted)
        else {
            return Ok(());
        };
        let collision = |clearance| Box::new(Collision { block, share, name, clearance, wanted: *wanted });
        patch.keeps(self.cutter, &middle.tip, &middle.axis, *wanted).map_err(collision)?;
        if moves.of(&(patch.point(doubtful.place) - middle.tip), 0.0) < STEP {
            return Ok(());
        }
        self.block(block, ends, [shares[0], share])?;
        self.block(block, ends, [share, shares[1]])
    }
}

/// The cutter at a share of a block: tip linear, axis linear and made a unit vector.
fn between([from, to]: [&CutterPlace; 2], share: f64) -> CutterPlace {
    CutterPlace {
        tip: from.tip + (to.tip - from.tip) * share,
        axis: (from.axis + (to.axis - from.axis) * share).normalize(),
        contact: None,
    }
}
