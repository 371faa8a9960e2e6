//! Dressing in several strokes: every ray of the worm is shortened by each of them, and the shortest length stays. A stroke that does
//! not reach a ray leaves it as it is. Knows nothing of how the strokes were found.

use super::dressed_flank::DressedRay;
use super::{DressedFlank, Dressing, RayGrid, RemovalError, Statistics, Uncut, dress};
use foundation::numerics::Progress;

/// Shortens the rays of `grid` by all strokes. A dresser of which only a part cuts is a part of its body
/// ([`foundation::geometry::Revolution::part`]).
///
/// # Errors
/// [`RemovalError::InvalidNumber`] without strokes; those of [`dress`] of the first stroke that has one.
pub fn dress_in_strokes(
    strokes: &[Dressing<'_>],
    grid: &RayGrid,
    progress: &dyn Progress,
) -> Result<DressedFlank, RemovalError> {
    let mut left: Option<DressedFlank> = None;
    for stroke in strokes {
        let cut = dress(stroke, grid, progress)?;
        left = Some(match left {
            None => cut,
            Some(before) => both(before, &cut),
        });
    }
    left.ok_or(RemovalError::InvalidNumber {
        field: "number of dressing strokes",
        value: 0.0,
        allowed: "at least 1",
    })
}

/// What two strokes leave.
fn both(mut flank: DressedFlank, cut: &DressedFlank) -> DressedFlank {
    for (ray, other) in flank.rays.iter_mut().zip(&cut.rays) {
        *ray = shorter(*ray, *other);
    }
    for (check, other) in flank.checks.iter_mut().zip(&cut.checks) {
        check.2 = shorter(check.2, other.2);
    }
    flank.error_um = flank.error_um.max(cut.error_um);
    // A ray is one ray, however many strokes it meets.
    let rays = flank.statistics.rays;
    flank.statistics = Statistics { rays, ..flank.statistics + cut.statistics };
    flank
}

fn shorter(a: Result<DressedRay, Uncut>, b: Result<DressedRay, Uncut>) -> Result<DressedRay, Uncut> {
    match (a, b) {
        (Ok(a), Ok(b)) => Ok(if b.f < a.f { b } else { a }),
        (Ok(one), Err(_)) | (Err(_), Ok(one)) => Ok(one),
        // What says most: that a ray is not reached is so for every stroke but its own.
        (Err(Uncut::NotReached), Err(other)) => Err(other),
        (Err(reason), Err(_)) => Err(reason),
    }
}
