//! The modification of a gear's flank as an offset along its normal.

use crate::geometry::{NormalOffset, OffsetBounds};
use crate::modification::Modification;
use crate::numerics::{Jet2, equidistant, extremes};

/// f_n = f_t cos(beta_b) of a modification.
#[derive(Clone, Debug)]
pub(super) struct ModifiedFlank {
    modification: Modification,
    normal: f64,
}

/// Places along each side of a box at which a modification is looked at for its bounds.
const PLACES: usize = 5;
/// What the greatest value seen there is taken times, because it is seen, not known. It enters the search for the clearance beside
/// the flank's own speed, of which a modification is a thousandth part.
const MARGIN: f64 = 4.0;

impl ModifiedFlank {
    pub fn new(modification: Modification) -> Self {
        let normal = modification.field().normal_factor();
        Self { modification, normal }
    }
}

impl NormalOffset for ModifiedFlank {
    fn jet(&self, height: f64, length: f64) -> Jet2 {
        // Where the modification has no value the flank has none: the column there is refused.
        let none = Jet2::constant(f64::NAN);
        self.modification.jet(height, length).map_or(none, |jet| jet * self.normal)
    }

    fn bounds(&self, heights: [f64; 2], lengths: [f64; 2]) -> OffsetBounds {
        let jets: Vec<Jet2> = equidistant(heights, PLACES)
            .into_iter()
            .flat_map(|a| equidistant(lengths, PLACES).into_iter().map(move |b| (a, b)))
            .map(|(a, b)| self.jet(a, b))
            .filter(Jet2::is_finite)
            .collect();
        let greatest = |of: fn(&Jet2) -> f64| MARGIN * extremes(jets.iter().map(|j| of(j).abs()))[1].max(0.0);
        OffsetBounds {
            value: greatest(|jet| jet.f),
            by_height: greatest(|jet| jet.fu),
            by_length: greatest(|jet| jet.fv),
        }
    }
}
