//! Regions with their ratios put together to one tool shift over the whole feed.

use super::polygon::range;
use super::{
    AreaTask, FeedInterval, FeedSegment, SAME_PLACE, SharedLines, WormExtent, conflicts, exclusive, extent,
    feed_intervals, feeds,
};
use crate::curve_law::number;
use crate::{FlankLines, GeneratingError};
use foundation::geometry::Sides;
use foundation::kinematics::MotionLaw;

/// The tool shift that gives every region its ratio, and what it takes on the worm.
#[derive(Clone, Debug, PartialEq)]
pub struct AreaPlan {
    /// Where the regions are ground, in the order of the feed.
    pub intervals: Vec<FeedInterval>,
    /// Stretches of constant ratio, in the order of the feed.
    pub segments: Vec<FeedSegment>,
    /// z_V1 = F(z_V2): the broken line through the segments, 0 at the first feed.
    pub shift: MotionLaw,
    /// Ranges on the worm per flank.
    pub extents: Sides<Option<WormExtent>>,
    /// Ranges on the worm per region, in the order of `intervals`.
    pub regions: Vec<WormExtent>,
    /// Worm lines that a region shares with another segment; none in a usable plan.
    pub shared: Vec<SharedLines>,
}

impl AreaTask {
    /// Puts the regions together.
    ///
    /// # Errors
    /// `NoFlank`, `InvalidNumber` for a free ratio or a feed travel that is not finite, `WormDirectionDegenerate`, errors of [`feed_intervals`], `AreasOverlap`. Worm lines used
    /// twice are listed in the plan; [`AreaPlan::check_exclusive`] makes an error of them.
    pub fn plan(&self) -> Result<AreaPlan, GeneratingError> {
        number("free_ratio", self.free_ratio, self.free_ratio.is_finite(), "a finite number")?;
        let corners = self.lines.iter().filter_map(|(_, lines)| lines.as_ref());
        let feeds = corners.flat_map(|lines| lines.corners().map(|(w, z)| lines.path_feed(w, z)));
        let travel = range(feeds).ok_or(GeneratingError::NoFlank)?;
        let stroke = travel[1] - travel[0];
        number("feed travel", stroke, stroke.is_finite() && stroke > SAME_PLACE, "> 0 mm")?;
        for (_, lines) in self.lines.iter() {
            lines.as_ref().map_or(Ok(()), FlankLines::check_worm_direction)?;
        }
        let intervals = feed_intervals(self)?;
        if let Some(&[i, j]) = conflicts(&intervals).first() {
            return Err(GeneratingError::AreasOverlap { first: intervals[i], second: intervals[j] });
        }
        let segments = feeds::segments(&intervals, travel, self.free_ratio);
        let touched = self
            .lines
            .map(|_, lines| lines.as_ref().map_or(Vec::new(), |lines| extent::by_segment(lines, &segments)));
        let extents = touched.map(|_, parts| parts.iter().flatten().copied().reduce(WormExtent::with));
        let (regions, shared) = exclusive::regions_on_worm(self, &intervals, &segments, &touched);
        let (nodes, shifts) = nodes(&segments);
        let shift = MotionLaw::broken_line(&nodes, &shifts)?;
        Ok(AreaPlan { intervals, segments, shift, extents, regions, shared })
    }
}

/// Corners of the broken line: z_V2 and z_V1, mm.
fn nodes(segments: &[FeedSegment]) -> (Vec<f64>, Vec<f64>) {
    let first = segments.first().map(|s| (s.feed[0], s.ratio * s.feed[0] + s.shift_origin));
    let ends = segments.iter().map(|s| (s.feed[1], s.ratio * s.feed[1] + s.shift_origin));
    first.into_iter().chain(ends).unzip()
}

impl AreaPlan {
    /// Corners of the broken line: z_V2 and z_V1, mm.
    pub fn nodes(&self) -> (Vec<f64>, Vec<f64>) {
        nodes(&self.segments)
    }

    /// A C1 tool shift: every corner between a region and a free area is moved into the free area by `half_length` and rounded
    /// by a parabola over +-`half_length`, so that every region keeps its ratio over its whole interval. Beyond the last corner
    /// z_V1 differs from that of the broken line.
    ///
    /// # Errors
    /// `Law` with `RoundingOutOfRange` when a free area is too short for its corners, or two regions with different ratios touch.
    pub fn rounded_shift(&self, half_length: f64) -> Result<MotionLaw, GeneratingError> {
        let (mut feeds, _) = self.nodes();
        for (k, pair) in self.segments.windows(2).enumerate() {
            feeds[k + 1] += match (pair[0].modified, pair[1].modified) {
                (true, false) => half_length,
                (false, true) => -half_length,
                // Two regions of different ratio touch: no room to change the ratio in.
                _ => {
                    return Err(foundation::kinematics::LawError::RoundingOutOfRange {
                        half_length,
                        largest: 0.0,
                    }
                    .into());
                }
            };
        }
        let mut shifts = vec![0.0];
        for (k, segment) in self.segments.iter().enumerate() {
            shifts.push(shifts[k] + segment.ratio * (feeds[k + 1] - feeds[k]));
        }
        if self.segments.len() == 1 {
            return Ok(self.shift.clone());
        }
        Ok(MotionLaw::rounded_line(&feeds, &shifts, half_length)?)
    }

    /// z_1 from and to over both flanks, mm.
    pub fn z_1(&self) -> [f64; 2] {
        let both = self.extents.iter().filter_map(|(_, e)| *e).reduce(WormExtent::with);
        // A plan has at least one flank, with at least one segment.
        both.map_or([0.0, 0.0], |extent| extent.z_1)
    }

    /// Length on the worm, union of both flanks, mm.
    pub fn length(&self) -> f64 {
        let [from, to] = self.z_1();
        to - from
    }

    /// Pitch of areas P, mm: the largest range of worm lines of a flank. Areas that far apart share no line.
    pub fn pitch(&self) -> f64 {
        self.extents.iter().filter_map(|(_, e)| *e).map(|e| e.line[1] - e.line[0]).fold(0.0, f64::max)
    }

    /// The diagonal ratio of largest size.
    pub fn largest_ratio(&self) -> f64 {
        self.segments.iter().map(|s| s.ratio).fold(0.0, |m: f64, k| if k.abs() > m.abs() { k } else { m })
    }

    /// Whether every modified region has its worm lines for itself.
    ///
    /// # Errors
    /// `WormLinesShared` with all of them.
    pub fn check_exclusive(&self) -> Result<(), GeneratingError> {
        match self.shared.iter().copied().reduce(|a, b| if b.overlap > a.overlap { b } else { a }) {
            None => Ok(()),
            Some(largest) => Err(GeneratingError::WormLinesShared { largest, shared: self.shared.clone() }),
        }
    }

    /// Number of areas side by side on a usable worm length (mm): area j has z_V01 shifted by j times the pitch.
    ///
    /// # Errors
    /// `InvalidNumber`, `WormTooShort` when not even one fits.
    pub fn areas_on(&self, usable: f64) -> Result<usize, GeneratingError> {
        number("usable_worm_length", usable, usable.is_finite() && usable > 0.0, "> 0 mm")?;
        let (length, pitch) = (self.length(), self.pitch());
        if usable < length - SAME_PLACE {
            let ratio = self.largest_ratio();
            return Err(GeneratingError::WormTooShort { needed: length, width: usable, ratio });
        }
        Ok((((usable - length + SAME_PLACE) / pitch).floor() as usize).saturating_add(1))
    }
}
