//! The time of blocks: the feed along the contact, unless an axis needs longer (`docs/mathematics/milling.md#positions-of-five-axes`).

use super::{CutterPlace, MillingSetup, PolePassage};
use crate::MotionError;
use machine::Positions;

/// What determines the time of a block.
#[derive(Clone, Debug, PartialEq)]
pub enum BlockLimit {
    /// The feed along the contact.
    Feed,
    /// The speed of an axis: its name.
    Axis(String),
}

impl BlockLimit {
    /// "feed", or the name of the axis.
    pub fn name(&self) -> &str {
        match self {
            Self::Feed => "feed",
            Self::Axis(name) => name,
        }
    }
}

/// The time of a block.
#[derive(Clone, Debug, PartialEq)]
pub struct BlockTime {
    /// dt, s.
    pub seconds: f64,
    /// What determines it.
    pub limit: BlockLimit,
    /// Speed of the tip on the workpiece, mm/min: the feed of the block with RTCP.
    pub tip_feed: f64,
    /// F of G93, 1/min: the feed of the block without RTCP.
    pub inverse_time: f64,
    /// Speed along the contact over the feed wanted, 1 where no axis slows the block.
    pub share: f64,
}

/// The time of one block from place to place; `arc` is the way of the contact (mm), `feed` its speed (mm/min). `None` where
/// nothing moves.
///
/// # Errors
/// [`MotionError::InvalidNumber`] for a feed that is not above 0.
pub fn block_time(
    setup: &MillingSetup,
    [from, to]: [(&CutterPlace, &Positions); 2],
    arc: f64,
    feed: f64,
) -> Result<Option<BlockTime>, MotionError> {
    if !(feed.is_finite() && feed > 0.0) {
        return Err(MotionError::InvalidNumber {
            field: "contact_feed_mm_per_min",
            value: feed,
            allowed: "above 0",
        });
    }
    let by_feed = 60.0 * arc / feed;
    let (mut seconds, mut limit) = (by_feed, BlockLimit::Feed);
    for axis in setup.axes().rotary.into_iter().chain(setup.axes().linear) {
        let described = &setup.machine().axes()[axis];
        let Some(most) = described.limits.velocity else { continue };
        let needed = (to.1[axis] - from.1[axis]).abs() / most;
        if needed > seconds {
            (seconds, limit) = (needed, BlockLimit::Axis(described.name.clone()));
        }
    }
    let tip = (to.0.tip.xyz - from.0.tip.xyz).norm();
    Ok((seconds > 0.0).then(|| BlockTime {
        seconds,
        limit,
        tip_feed: 60.0 * tip / seconds,
        inverse_time: 60.0 / seconds,
        share: by_feed / seconds,
    }))
}

/// The times of all blocks of a path, the contact going straight from place to place.
///
/// # Errors
/// [`MotionError::NoMotion`] for two places that are one; [`MotionError::InvalidNumber`].
pub fn block_times(
    setup: &MillingSetup,
    places: &[CutterPlace],
    nodes: &[Positions],
    feed: f64,
) -> Result<Vec<BlockTime>, MotionError> {
    places
        .windows(2)
        .zip(nodes.windows(2))
        .enumerate()
        .map(|(k, (place, node))| {
            let arc = (place[1].contact.xyz - place[0].contact.xyz).norm();
            let ends = [(&place[0], &node[0]), (&place[1], &node[1])];
            block_time(setup, ends, arc, feed)?.ok_or(MotionError::NoMotion { place: k + 1 })
        })
        .collect()
}

/// The feed that a part of a path near the pole allows.
#[derive(Clone, Debug, PartialEq)]
pub struct SectionFeed {
    /// The part.
    pub passage: PolePassage,
    /// Feed along the contact that no axis forbids on any block that begins or ends there, mm/min; at most the one wanted.
    pub feed: f64,
    /// What determines it.
    pub limit: BlockLimit,
}

/// The feeds of the parts near the pole, from the times of all blocks at the feed wanted (mm/min): strategy `slow` of
/// `docs/mathematics/milling.md#positions-of-five-axes`.
pub fn section_feeds(times: &[BlockTime], passages: &[PolePassage], feed: f64) -> Vec<SectionFeed> {
    let of = |passage: &PolePassage| {
        let touching = times.iter().enumerate().filter(|(k, _)| k + 1 >= passage.from && *k <= passage.to);
        let slowest = touching.map(|(_, time)| time).min_by(|a, b| a.share.total_cmp(&b.share));
        SectionFeed {
            passage: *passage,
            feed: slowest.map_or(feed, |time| feed * time.share),
            limit: slowest.map_or(BlockLimit::Feed, |time| time.limit.clone()),
        }
    };
    passages.iter().map(of).collect()
}
