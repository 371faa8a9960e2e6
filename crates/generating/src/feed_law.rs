//! How the tool shift follows the feed: a constant diagonal ratio that the plan centres on the tool, or a law as it is given.

use super::{FlankLines, GrindingSetup};
use foundation::geometry::Flank;
use foundation::kinematics::MotionLaw;
use foundation::numerics::extremes;

/// z_V1 as a function of z_V2.
#[derive(Clone, Debug, PartialEq)]
pub enum FeedLaw {
    /// z_V1 = K z_V2 + z_V01 with the used width of the tool centred; 0: no shift (class `radial`).
    Ratio(f64),
    /// As it stands, mm over mm.
    Law(MotionLaw),
}

impl FeedLaw {
    /// Whether there is no shift.
    pub fn is_radial(&self) -> bool {
        match self {
            Self::Ratio(ratio) => *ratio == 0.0,
            Self::Law(law) => law.is_constant(),
        }
    }

    /// The constant ratio, if it is one.
    pub fn ratio(&self) -> Option<f64> {
        match self {
            Self::Ratio(ratio) => Some(*ratio),
            Self::Law(_) => None,
        }
    }

    /// The law itself for the flanks `which`.
    pub fn law(&self, setup: &GrindingSetup, which: &[Flank]) -> MotionLaw {
        match self {
            Self::Ratio(ratio) => setup.centred(&MotionLaw::polynomial(0.0, vec![0.0, *ratio]), which),
            Self::Law(law) => law.clone(),
        }
    }
}

impl GrindingSetup {
    /// Numbers of the flanks `which`.
    fn lines_of<'a>(&'a self, which: &'a [Flank]) -> impl Iterator<Item = &'a FlankLines> {
        which.iter().map(|&flank| &self.lines[flank])
    }

    /// Used tool width [min, max] of z_1 over the evaluation fields of the flanks `which` under a law, mm.
    pub fn occupation(&self, law: &MotionLaw, which: &[Flank]) -> [f64; 2] {
        extremes(self.lines_of(which).flat_map(|lines| lines.occupation(law)))
    }

    /// Feed range [min, max] of z_V2 over the evaluation fields of the flanks `which`, mm.
    pub fn feed_range(&self, law: &MotionLaw, which: &[Flank]) -> [f64; 2] {
        extremes(self.lines_of(which).flat_map(|lines| lines.feed_range(law)))
    }

    /// The law moved by a constant so that its used width is centred on the tool (z_V01 of
    /// `docs/mathematics/planning.md#choice-of-the-ratio`).
    pub fn centred(&self, law: &MotionLaw, which: &[Flank]) -> MotionLaw {
        let centre = |law: &MotionLaw| {
            let [from, to] = self.occupation(law, which);
            0.5 * (from + to)
        };
        let here = centre(law);
        if self.pair.worm.is_cylindrical() {
            return law.raised(here);
        }
        // On a cone the shift also moves the contact: affine, so one secant settles it.
        law.raised(here / (here - centre(&law.raised(1.0))))
    }
}
