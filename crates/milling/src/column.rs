//! One column: the section of a flank with a plane that stands perpendicular to the guide curve
//! (`docs/mathematics/milling.md#columns-and-rows`).

use super::{ActiveFlank, HeightLimits, LeadPoint, MillingError};
use foundation::geometry::SurfaceJet;
use foundation::numerics::brent;

/// A column plane and the flank that it cuts.
#[derive(Clone, Debug)]
pub struct ColumnPlane<'a> {
    flank: &'a ActiveFlank,
    lead: LeadPoint,
}

/// A place of the flank in a column plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Section {
    /// Height parameter a.
    pub height: f64,
    /// Length parameter b.
    pub length: f64,
    /// The flank there.
    pub jet: SurfaceJet,
}

/// Newton's steps before the search by brackets, and the relative step that ends them (`docs/mathematics/milling.md#columns-and-rows`).
const STEPS: usize = 60;
const SMALLEST_STEP: f64 = 1e-13;

/// Pieces in which a sign change is looked for where Newton's iteration fails, over the face and this share of it beyond both ends.
const PIECES: usize = 64;
const BEYOND: f64 = 1.0;

impl<'a> ColumnPlane<'a> {
    /// The plane at a point of the guide curve.
    pub fn new(flank: &'a ActiveFlank, lead: LeadPoint) -> Self {
        Self { flank, lead }
    }

    /// The point of the guide curve with its frame.
    pub fn lead(&self) -> &LeadPoint {
        &self.lead
    }

    /// F = (S - c).t: distance from the plane, mm.
    fn off(&self, height: f64, length: f64) -> f64 {
        (self.flank.surface.point(height, length) - self.lead.point).dot(&self.lead.direction)
    }

    /// The length at which the line of one height crosses the plane, near a start.
    ///
    /// # Errors
    /// [`MillingError::ColumnNoSection`] if it does not; [`MillingError::ColumnKink`] if it does beyond a kink.
    pub fn section(&self, height: f64, start: f64) -> Result<Section, MillingError> {
        let section = self.by_newton(height, start).or_else(|| self.by_bracket(height, start));
        let section = section.ok_or(MillingError::ColumnNoSection { u: self.lead.u, height, start })?;
        match self.flank.kink {
            Some(kink) if (section.length - kink.length) * kink.side < 0.0 => {
                let length = section.length;
                Err(MillingError::ColumnKink { length, kink: kink.length, along: kink.along })
            }
            _ => Ok(section),
        }
    }

    fn by_newton(&self, height: f64, start: f64) -> Option<Section> {
        let [_, [least, greatest]] = self.flank.surface.domain();
        let mut length = start.clamp(least, greatest);
        for _ in 0..STEPS {
            let jet = self.flank.surface.jet(height, length);
            let step = (jet.point - self.lead.point).dot(&self.lead.direction)
                / jet.by_length.dot(&self.lead.direction);
            let next = length - step;
            if !(least..=greatest).contains(&next) {
                return None;
            }
            if step.abs() < SMALLEST_STEP * length.abs().max(1.0) {
                return Some(Section { height, length, jet });
            }
            length = next;
        }
        None
    }

    /// The crossing nearest to the start, by sign changes.
    fn by_bracket(&self, height: f64, start: f64) -> Option<Section> {
        let [_, [least, greatest]] = self.flank.surface.domain();
        let [from, to] = self.flank.face;
        let margin = BEYOND * (to - from);
        let (from, to) = ((from - margin).max(least), (to + margin).min(greatest));
        let at = |piece: usize| from + (to - from) * piece as f64 / PIECES as f64;
        let mut found: Option<f64> = None;
        for piece in 0..PIECES {
            let ends = [at(piece), at(piece + 1)];
            let values = ends.map(|length| self.off(height, length));
            if let Some(length) = brent(ends, values, 0.0, |length| Some(self.off(height, length)))
                && found.is_none_or(|best| (length - start).abs() < (best - start).abs())
            {
                found = Some(length);
            }
        }
        let length = found?;
        Some(Section { height, length, jet: self.flank.surface.jet(height, length) })
    }

    /// ds/da: how fast the column runs over the height at a section, mm per unit of the height.
    pub fn speed(&self, section: &Section) -> f64 {
        let (a, b) = (&section.jet.by_height, &section.jet.by_length);
        (a - b * (a.dot(&self.lead.direction) / b.dot(&self.lead.direction))).norm()
    }

    /// Heights at which the column begins and ends, [root, tip] (`docs/mathematics/milling.md#flanks-as-patches`).
    ///
    /// # Errors
    /// [`MillingError::ColumnNoLimit`] if a body does not end the column; those of [`Self::section`].
    pub fn heights(&self) -> Result<[f64; 2], MillingError> {
        let (bodies, between) = match self.flank.heights {
            HeightLimits::Constant(heights) => return Ok(heights),
            HeightLimits::Bodies { bodies, between } => (bodies, between),
        };
        let mut heights = [0.0; 2];
        for (height, body) in heights.iter_mut().zip(bodies) {
            let off = |a: f64| Some(body.off(&self.section(a, self.lead.u).ok()?.jet.point));
            let found = match (off(between[0]), off(between[1])) {
                (Some(first), Some(last)) => brent(between, [first, last], 0.0, off),
                _ => None,
            };
            *height = found.ok_or(MillingError::ColumnNoLimit { u: self.lead.u, body })?;
        }
        Ok(heights)
    }
}
