//! Where paths end in the middle of a double-helical gear (`docs/mathematics/milling.md#flanks-as-patches`): in its middle plane (of a bevel
//! gear a sphere about the apex), or before where the cutter comes to the other half.

use super::{Clearance, CutterPath, CutterPlace, HIDDEN, Kink, MillingError, Obstacle};
use foundation::geometry::Cutter;
use foundation::numerics::brent;

/// A path as far as it may go.
#[derive(Clone, Debug)]
pub(super) struct Ended {
    /// The path.
    pub path: CutterPath,
    /// Where it ends before it would, as the number of its place before it was ended: 2.5 half-way between the third and the fourth.
    pub at: Option<f64>,
}

/// Distances that count as none, mm: what the search for a clearance is polished to.
const NONE: f64 = 1e-6;
/// Accuracy of the share of a block at which a path ends.
const SHARE: f64 = 1e-9;

/// The place at a share of a straight block: tip and axis linear, as the machine goes.
fn within([from, to]: [&CutterPlace; 2], share: f64) -> CutterPlace {
    let between = |a: nalgebra::Vector3<f64>, b: nalgebra::Vector3<f64>| a + (b - a) * share;
    CutterPlace {
        tip: between(from.tip, to.tip),
        axis: between(from.axis, to.axis).normalize(),
        contact: from.contact.zip(to.contact).map(|(a, b)| between(a, b)),
    }
}

/// What keeps a path of one half in its half.
pub(super) struct Limits<'a> {
    /// The middle and the side of it on which the half lies.
    pub middle: Kink,
    /// The cutter.
    pub cutter: &'a Cutter,
    /// The other half.
    pub other_half: Vec<Obstacle<'a>>,
}

impl Limits<'_> {
    /// Where along the teeth a place counts: where it touches, or else its tip. mm.
    fn position(&self, place: &CutterPlace) -> f64 {
        self.middle.position(&place.contact.unwrap_or(place.tip))
    }

    /// How far a place is from the middle on its own side, mm.
    fn before_middle(&self, place: &CutterPlace) -> f64 {
        (self.position(place) - self.middle.length) * self.middle.side
    }

    /// Obstacles that a place is too near to, each with what is missing.
    fn met(&self, place: &CutterPlace) -> Vec<(&Obstacle<'_>, Clearance)> {
        let mut met = Vec::new();
        for obstacle in &self.other_half {
            let (patch, wanted) = (&obstacle.patch, obstacle.wanted);
            if patch.keeps(self.cutter, &place.tip, &place.axis, wanted).is_err() {
                let kept = patch.clearance(self.cutter, &place.tip, &place.axis);
                if kept.value < wanted - NONE {
                    met.push((obstacle, kept));
                }
            }
        }
        met
    }

    /// A path whose places ascend along the teeth, ended where it would cross the middle or come too near to the other half. It is
    /// followed from the far end of the half; `row` is its number for messages.
    ///
    /// # Errors
    /// [`MillingError::ColumnKink`] and [`MillingError::ToolGap`] if already its begin there is on the wrong side or too near.
    pub fn end(&self, path: CutterPath, row: usize) -> Result<Ended, MillingError> {
        let mut places = path.places;
        let last = places.len().saturating_sub(1);
        let inwards = self.middle.side > 0.0;
        if inwards {
            places.reverse();
        }
        let mut end = None;
        for (number, place) in places.iter().enumerate() {
            let met = self.met(place);
            let crossed = self.before_middle(place) < -NONE;
            if !crossed && met.is_empty() {
                continue;
            }
            let Some(before) = number.checked_sub(1) else {
                return Err(self.refused_at_begin(place, &met, row));
            };
            let block = [&places[before], place];
            let mut share = self.share_with_room(block, &met, crossed, 1.0);
            // Where both halves are relieved at their common end the cutter is past the edge of the other one at the next place and digs
            // into it in the middle itself.
            let mut edge = self.met(&within(block, share));
            edge.retain(|(obstacle, kept)| kept.value < obstacle.wanted - HIDDEN);
            if !edge.is_empty() {
                share = self.share_with_room(block, &edge, false, share);
            }
            end = Some((before, share, within(block, share)));
            break;
        }
        let mut at = None;
        if let Some((before, share, place)) = end {
            places.truncate(before + 1);
            if share > 0.0 {
                places.push(place);
            }
            let number = before as f64 + share;
            at = Some(if inwards { last as f64 - number } else { number });
        }
        if inwards {
            places.reverse();
        }
        Ok(Ended { path: CutterPath { places }, at })
    }

    /// How far a block may go, up to a share of it, so that nothing of these comes too near and, if it crosses the middle, it does not.
    fn share_with_room(
        &self,
        block: [&CutterPlace; 2],
        met: &[(&Obstacle<'_>, Clearance)],
        crossed: bool,
        most: f64,
    ) -> f64 {
        let room = |share: f64| {
            let at = within(block, share);
            let kept = met.iter().map(|(obstacle, _)| {
                obstacle.patch.clearance(self.cutter, &at.tip, &at.axis).value - obstacle.wanted
            });
            kept.fold(if crossed { self.before_middle(&at) } else { f64::INFINITY }, f64::min)
        };
        let ends = [room(0.0), room(most)];
        // A place that has just no room left is the end itself.
        brent([0.0, most], ends, SHARE, |share| Some(room(share))).unwrap_or(0.0)
    }

    fn refused_at_begin(
        &self,
        place: &CutterPlace,
        met: &[(&Obstacle<'_>, Clearance)],
        row: usize,
    ) -> MillingError {
        match met.first() {
            Some((obstacle, kept)) => MillingError::ToolGap {
                row,
                column: 0,
                from: obstacle.name,
                clearance: kept.value,
                wanted: obstacle.wanted,
            },
            None => {
                let Kink { length: kink, along, .. } = self.middle;
                MillingError::ColumnKink { length: self.position(place), kink, along }
            }
        }
    }
}
