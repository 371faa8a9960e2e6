//! Finishing and roughing areas side by side on the worm, and the table of who occupies what.

use super::{AreaPlan, SAME_PLACE, WormExtent};
use crate::GeneratingError;
use crate::curve_law::number;
use foundation::geometry::{Flank, Sides};

/// More areas than any worm holds.
const MOST_AREAS: usize = 10_000;

/// What an area is for. Only finishing is judged against the target.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AreaKind {
    /// It makes the target.
    Finishing,
    /// It takes off stock, with a scaled modification or none.
    Roughing,
}

/// Areas of one kind.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AreaSet<'a> {
    /// Kind.
    pub kind: AreaKind,
    /// What one of them takes on the worm; a roughing area is the plan of a task without regions and with K_r as free ratio.
    pub plan: &'a AreaPlan,
    /// How many.
    pub count: usize,
    /// Least way along the worm between the lines of two of them, mm: what a dresser takes to go from one to the next.
    pub apart: f64,
}

/// What a place on the worm is used for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PlaceKind {
    /// A finishing area, whole.
    Finishing,
    /// Modified lines inside a finishing area; lines are oblique, so that their z_1 overlaps that of the free lines beside them.
    Modified,
    /// A roughing area.
    Roughing,
    /// Nothing is ground here.
    Unused,
}

/// One line of the table: z_1 from and to on one flank, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OccupiedPlace {
    /// Use.
    pub kind: PlaceKind,
    /// Flank of the worm.
    pub flank: Flank,
    /// Number of the area along the worm; `None` where nothing is ground.
    pub area: Option<usize>,
    /// z_1 from and to, mm.
    pub z_1: [f64; 2],
}

/// The partition of a worm.
#[derive(Clone, Debug, PartialEq)]
pub struct Occupation {
    /// Usable z_1 from and to, mm.
    pub width: [f64; 2],
    /// The table: areas in the order of z_1, each flank by flank, then what is unused.
    pub places: Vec<OccupiedPlace>,
    /// Added to z_V1 of the plan for each area, mm.
    pub shifts: Vec<f64>,
    /// Length from the first area to the end of the last, mm.
    pub needed: f64,
}

impl Occupation {
    /// Lays the areas of the sets, in their order, from the lower end of the usable width `[from, to]` (z_1, mm) upwards. Each
    /// begins a pitch of the one before it further (`docs/mathematics/planning.md#choice-of-the-ratio`), and so much further that the two
    /// share no worm line where areas of different shape meet.
    ///
    /// # Errors
    /// `InvalidNumber` for a bad width or no area at all, `WormTooShort` when they do not fit.
    pub fn lay(width: [f64; 2], sets: &[AreaSet<'_>]) -> Result<Self, GeneratingError> {
        let [from, to] = width;
        number("width_from", from, from.is_finite(), "a finite number")?;
        number("width_to", to, to.is_finite() && to > from, "above width_from")?;
        let count = sets.iter().fold(0usize, |n, set| n.saturating_add(set.count));
        number("areas", count as f64, (1..=MOST_AREAS).contains(&count), "1 .. 10000")?;
        let areas: Vec<(&AreaSet<'_>, usize)> =
            sets.iter().flat_map(|set| (0..set.count).map(move |k| (set, k))).collect();
        let mut places = Vec::new();
        let mut shifts = Vec::new();
        let mut start = from;
        let mut end = from;
        let mut last_line = Sides::both(f64::NEG_INFINITY);
        let mut ratio = 0.0_f64;
        for (area, &(set, number)) in areas.iter().enumerate() {
            let (kind, plan) = (set.kind, set.plan);
            if number > 0 {
                start += set.apart;
            }
            let origin = plan.z_1()[0];
            for (flank, extent) in plan.extents.iter() {
                let Some(extent) = extent else { continue };
                start = start.max(origin + last_line[flank] - extent.line[0]);
            }
            let moved = start - origin;
            // z_1 falls as z_V1 grows.
            shifts.push(-moved);
            for (flank, extent) in plan.extents.iter() {
                let Some(extent) = extent.map(|e| e.moved(moved)) else { continue };
                last_line[flank] = extent.line[1];
                places.extend(area_places(kind, plan, flank, area, extent, moved));
            }
            end = end.max(plan.z_1()[1] + moved);
            if plan.largest_ratio().abs() > ratio.abs() {
                ratio = plan.largest_ratio();
            }
            start += plan.pitch();
        }
        let needed = end - from;
        if needed > to - from + SAME_PLACE {
            return Err(GeneratingError::WormTooShort { needed, width: to - from, ratio });
        }
        let unused =
            Flank::BOTH.into_iter().flat_map(|flank| unused(&places, flank, width)).collect::<Vec<_>>();
        places.extend(unused);
        Ok(Self { width, places, shifts, needed })
    }
}

fn area_places(
    kind: AreaKind,
    plan: &AreaPlan,
    flank: Flank,
    area: usize,
    extent: WormExtent,
    moved: f64,
) -> Vec<OccupiedPlace> {
    let place = |kind, z_1| OccupiedPlace { kind, flank, area: Some(area), z_1 };
    match kind {
        AreaKind::Roughing => vec![place(PlaceKind::Roughing, extent.z_1)],
        AreaKind::Finishing => {
            let regions = plan.intervals.iter().zip(&plan.regions).filter(|(i, _)| i.flank == flank);
            let modified = regions.map(|(_, e)| place(PlaceKind::Modified, e.moved(moved).z_1));
            std::iter::once(place(PlaceKind::Finishing, extent.z_1)).chain(modified).collect()
        }
    }
}

/// What the areas of a flank leave of the width.
fn unused(places: &[OccupiedPlace], flank: Flank, [from, to]: [f64; 2]) -> Vec<OccupiedPlace> {
    let mut taken: Vec<[f64; 2]> = places.iter().filter(|p| p.flank == flank).map(|p| p.z_1).collect();
    if taken.is_empty() {
        return Vec::new();
    }
    taken.sort_by(|a, b| a[0].total_cmp(&b[0]));
    taken.push([to, to]);
    let mut reached = from;
    let mut gaps = Vec::new();
    for [lo, hi] in taken {
        if lo - reached > SAME_PLACE {
            gaps.push(OccupiedPlace { kind: PlaceKind::Unused, flank, area: None, z_1: [reached, lo] });
        }
        reached = reached.max(hi);
    }
    gaps
}
