//! Which feeds and which part of the worm a rectangle of the workpiece flank needs (`docs/mathematics/generating-contact.md#limits`). All
//! relations are affine, so the corners decide.
//!
//! No command reaches it: `verify` recomputes the areas of references with it.

use super::{ContactError, DiagonalLine, DiagonalRatio, FlankPair};

/// Ranges [least, greatest] used while a field of the workpiece flank is ground, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WorkingArea {
    /// Feed z_V2.
    pub feed: [f64; 2],
    /// Tool shift z_V1.
    pub shift: [f64; 2],
    /// Length of roll w_1 on the worm.
    pub w_1: [f64; 2],
    /// Axial position z_1 on the worm.
    pub z_1: [f64; 2],
    /// Worm radius that the largest w_1 needs.
    pub worm_radius: f64,
}

impl FlankPair {
    /// Ranges for the field `w` x `z` of the workpiece at a constant diagonal ratio.
    ///
    /// # Errors
    /// `FeedDoesNotMoveContact`; `WormBelowBase` if the field needs w_1 <= 0.
    pub fn working_area(
        &self,
        w: [f64; 2],
        z: [f64; 2],
        diagonal: DiagonalRatio,
    ) -> Result<WorkingArea, ContactError> {
        let start = [f64::INFINITY, f64::NEG_INFINITY];
        let widen = |range: &mut [f64; 2], x: f64| *range = [range[0].min(x), range[1].max(x)];
        let mut area = WorkingArea { feed: start, shift: start, w_1: start, z_1: start, worm_radius: 0.0 };
        for w_2 in w {
            for z_2 in z {
                let at = self.point_map(w_2, z_2, diagonal)?;
                widen(&mut area.feed, at.feed);
                widen(&mut area.shift, at.shift);
                widen(&mut area.w_1, at.w_1);
                widen(&mut area.z_1, at.z_1);
            }
        }
        if area.w_1[0] <= 0.0 {
            return Err(ContactError::WormBelowBase { w_1: area.w_1[0] });
        }
        area.worm_radius = self.worm.radius(area.w_1[1]);
        Ok(area)
    }

    /// Range of the worm's line coordinate X_1 that the field `w` x `z` of the workpiece uses, mm.
    ///
    /// # Errors
    /// `FeedDoesNotMoveContact`.
    pub fn line_range(
        &self,
        worm: DiagonalLine,
        w: [f64; 2],
        z: [f64; 2],
        diagonal: DiagonalRatio,
    ) -> Result<[f64; 2], ContactError> {
        let mut range = [f64::INFINITY, f64::NEG_INFINITY];
        for w_2 in w {
            for z_2 in z {
                let at = self.point_map(w_2, z_2, diagonal)?;
                let x_1 = worm.coordinate(at.w_1, at.z_1);
                range = [range[0].min(x_1), range[1].max(x_1)];
            }
        }
        Ok(range)
    }
}
