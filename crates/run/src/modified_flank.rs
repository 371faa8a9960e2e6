//! The modification of a gear's flank as an offset along its normal.

use foundation::geometry::{NormalOffset, OffsetBounds};
use foundation::modification::{Modification, Smoothness};
use foundation::numerics::{Jet2, equidistant};

/// f_n = f_t cos(beta_b) of a modification.
#[derive(Clone, Debug)]
pub struct ModifiedFlank {
    modification: Modification,
    normal: f64,
    /// Rolls and lengths over which `bounds` hold, mm.
    seen: [[f64; 2]; 2],
    bounds: OffsetBounds,
}

/// Places along each side of the field, and of a box that reaches out of it, at which a modification is looked at for its bounds.
const PLACES: usize = 65;
const PLACES_OUTSIDE: usize = 5;
/// Share of the field by which its bounds reach beyond its borders.
const BEYOND: f64 = 0.25;
/// What the greatest value seen there is taken times, because it is seen, not known. It enters the search for the clearance beside
/// the flank's own speed, of which a modification is a thousandth part.
const MARGIN: f64 = 4.0;

impl ModifiedFlank {
    /// The offset of a modification, with bounds sought over its field.
    pub fn new(modification: Modification) -> Self {
        let field = modification.field();
        let normal = field.normal_factor();
        let seen = [field.roll(), field.face()].map(|[from, to]| {
            let beyond = BEYOND * (to - from);
            [from - beyond, to + beyond]
        });
        let bounds = seen_bounds(&modification, normal, seen, PLACES);
        Self { modification, normal, seen, bounds }
    }
}

/// Where the modification has no value the flank has none: the column there is refused.
fn offset(modification: &Modification, normal: f64, height: f64, length: f64) -> Jet2 {
    modification.jet(height, length).map_or(Jet2::constant(f64::NAN), |jet| jet * normal)
}

/// The greatest magnitudes over a box, from this many places along each side.
fn seen_bounds(
    modification: &Modification,
    normal: f64,
    [heights, lengths]: [[f64; 2]; 2],
    places: usize,
) -> OffsetBounds {
    // By value, slopes and second derivatives.
    let mut greatest = [0.0f64; 6];
    for a in equidistant(heights, places) {
        for b in equidistant(lengths, places) {
            let jet = offset(modification, normal, a, b);
            if jet.is_finite() {
                for (greatest, value) in
                    greatest.iter_mut().zip([jet.f, jet.fu, jet.fv, jet.fuu, jet.fuv, jet.fvv])
                {
                    *greatest = greatest.max(MARGIN * value.abs());
                }
            }
        }
    }
    let [value, by_height, by_length, second @ ..] = greatest;
    let second = if modification.smoothness() == Smoothness::C0 { [f64::INFINITY; 3] } else { second };
    OffsetBounds { value, by_height, by_length, second }
}

impl NormalOffset for ModifiedFlank {
    fn jet(&self, height: f64, length: f64) -> Jet2 {
        offset(&self.modification, self.normal, height, length)
    }

    /// Inside the field and a share beyond those of the whole: a box is asked for them thousands of times.
    fn bounds(&self, heights: [f64; 2], lengths: [f64; 2]) -> OffsetBounds {
        let inside = [heights, lengths]
            .iter()
            .zip(&self.seen)
            .all(|(range, seen)| range[0].min(range[1]) >= seen[0] && range[0].max(range[1]) <= seen[1]);
        if inside {
            self.bounds
        } else {
            seen_bounds(&self.modification, self.normal, [heights, lengths], PLACES_OUTSIDE)
        }
    }
}
