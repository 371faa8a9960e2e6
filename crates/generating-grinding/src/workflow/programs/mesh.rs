//! Where worm and blank may overlap as bodies of revolution beside a stroke: the worm comes in and goes out with its threads in the tooth
//! spaces, where no stock is. Judged from the places of a text, the finished flanks and the feeds between which stock is met.

use super::grinding_stroke::{GrindingStroke, StockContact};
use super::indexing::Indexing;
use super::work::GrindingWork;
use foundation::geometry::Flank;
use foundation::kinematics::{GeneratingState, Pose, Workpiece, Worm};
use motion::{Tracked, beyond};
use std::f64::consts::TAU;

/// What a place may reach below the finished flank before it is in it, mm: digits and chords of a text.
const ROUNDING: f64 = 2e-3;

/// The strokes of a text with the stock that each meets.
pub struct Mesh<'a> {
    work: &'a GrindingWork,
    /// First and last block of each stroke, from 1, rising, and where it meets stock.
    strokes: Vec<([usize; 2], StockContact)>,
    /// Blocks of rapid moves, rising.
    rapids: Vec<usize>,
}

impl<'a> Mesh<'a> {
    /// Of strokes at these blocks of a text; `None` where the stock of a stroke is not known. A text with other strokes than the job is
    /// judged by the widest contact of all.
    pub fn new(
        tracked: &Tracked,
        blocks: &[[usize; 2]],
        (work, of_job, indexing): (&'a GrindingWork, impl Iterator<Item = &'a GrindingStroke>, &Indexing),
    ) -> Option<Self> {
        let contacts = of_job.map(|stroke| stroke.contact).collect::<Option<Vec<_>>>()?;
        let widest = contacts.iter().copied().reduce(StockContact::joined)?;
        let each = indexing.offsets.len().max(1);
        let as_job = blocks.len().is_multiple_of(contacts.len() * each);
        let of_stroke = |k: usize| if as_job { contacts[(k / each) % contacts.len()] } else { widest };
        let mut strokes: Vec<_> = blocks.to_vec();
        strokes.sort_unstable();
        let strokes = strokes.into_iter().enumerate().map(|(k, blocks)| (blocks, of_stroke(k))).collect();
        Some(Self { work, strokes, rapids: tracked.rapid_blocks().collect() })
    }

    /// Whether the threads stand in the tooth spaces beside all stock at a place of a block.
    pub fn is_clear(&self, block: usize, bodies: &Pose<Worm, Workpiece>) -> bool {
        let Some(contact) = self.contact_of(block) else { return false };
        let start = GeneratingState {
            worm_angle: 0.0,
            work_angle: 0.0,
            shift: 0.0,
            feed: 0.0,
            delta_d: 0.0,
            delta_gamma: 0.0,
        };
        let motion = &self.work.motion;
        let Some(state) = motion.chain.state_of(bodies, &start) else { return false };
        if !contact.is_clear(state.feed) {
            return false;
        }
        let feeds = self.work.feeds;
        let coupled = -state.worm_angle * motion.threads
            + self.work.phase
            + state.shift * motion.shift_coupling
            + state.feed * motion.feed_coupling;
        let turned =
            state.work_angle - coupled / motion.teeth - beyond(&motion.delta_phi_2, feeds, state.feed);
        let tooth = TAU / motion.teeth.abs();
        let turned = turned - tooth * (turned / tooth).round();
        let lifted = state.delta_d - beyond(&motion.delta_d, feeds, state.feed);
        Flank::BOTH.iter().all(|&flank| {
            let off = |lever: contact::Lever| lifted * lever.sine - flank.sign() * lever.arm * turned;
            self.work.levers[flank].is_none_or(|lever| off(lever) >= -ROUNDING)
        })
    }

    /// Where the stroke meets stock that a block belongs to: itself, the retraction behind it up to the next rapid move, or the infeed
    /// before it.
    fn contact_of(&self, block: usize) -> Option<StockContact> {
        let next = self.strokes.partition_point(|(blocks, _)| blocks[1] < block);
        let before = next.checked_sub(1).map(|k| &self.strokes[k]);
        let retracts = before.filter(|(blocks, _)| {
            let rapid = self.rapids.partition_point(|rapid| *rapid <= blocks[1]);
            self.rapids.get(rapid).is_none_or(|rapid| block < *rapid)
        });
        let starts = self.strokes.get(next).filter(|(blocks, _)| block >= blocks[0]);
        starts.or(retracts).or(self.strokes.get(next)).map(|(_, contact)| *contact)
    }
}
