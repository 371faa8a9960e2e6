//! The cross-section of a disc dresser while it dresses one flank: active flank, tip land, opposite flank
//! (`docs/mathematics/dressing.md#limits-of-a-correction`).
//!
//! The tip land is made by shifting the opposite flank along the dresser's axis. Knows no worm and no motion.

use crate::{DresserTool, DressingError, FlankDresser};
use foundation::geometry::{Flank, Revolution};
use foundation::numerics::{brent, gradient_of, value_of, variables};

/// A part of the section.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SectionPart {
    /// The flank that dresses.
    ActiveFlank,
    /// The cylinder at the tip.
    TipLand,
    /// The flank that must not touch the worm.
    CounterFlank,
}

impl SectionPart {
    /// All parts in the order in which they follow each other around the tip.
    pub const ALL: [Self; 3] = [Self::ActiveFlank, Self::TipLand, Self::CounterFlank];
}

/// A circle of the dresser and how it changes along its part of the section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct SectionCircle {
    pub r: f64,
    pub z: f64,
    /// dr and dz by the parameter of the part.
    pub slope: [f64; 2],
}

/// Circles with which every part is looked at first, at equal distances of its parameter. The parts are nearly straight; what
/// decides between them is found by their slopes.
const FLANK_CIRCLES: usize = 25;
const LAND_CIRCLES: usize = 7;

/// Section of a dresser that dresses one flank, for any width of its tip land. mm.
#[derive(Clone, Debug)]
pub struct DresserSection<'a> {
    tool: &'a DresserTool,
    flank: Flank,
    tip_radius: f64,
    full_land: f64,
    /// +1 where the active flank faces +z of the dresser.
    side: f64,
    /// Parameter and circle, from the tip on; the opposite flank as without land.
    active: Vec<(f64, SectionCircle)>,
    counter: Vec<(f64, SectionCircle)>,
}

fn circle(profile: &Revolution, t: f64) -> SectionCircle {
    let [t] = variables([t]);
    let at = profile.at(t);
    SectionCircle {
        r: value_of(at.r),
        z: value_of(at.z),
        slope: [gradient_of(&at.r)[0], gradient_of(&at.z)[0]],
    }
}

/// Circles of a flank from the tip radius to the end of its profile.
fn circles(dresser: &FlankDresser, tip_radius: f64) -> Result<Vec<(f64, SectionCircle)>, DressingError> {
    let profile = &dresser.profile;
    let (from, to) = profile.interval();
    let above = |t: f64| profile.at(t).r - tip_radius;
    let inner = dresser.designed.w_na;
    let tip = brent([from, inner], [above(from), above(inner)], 1e-13 * inner, |t| Some(above(t)));
    let outside = || DressingError::TipOutsideProfile {
        flank: dresser.worm.flank,
        radius: tip_radius,
        from: profile.at(inner).r,
        to: profile.at(from).r,
    };
    let tip = tip.ok_or_else(outside)?;
    let last = (FLANK_CIRCLES - 1) as f64;
    let nodes = (0..FLANK_CIRCLES).map(|k| tip + (to - tip) * k as f64 / last);
    Ok(nodes.map(|t| (t, circle(profile, t))).collect())
}

impl<'a> DresserSection<'a> {
    /// The dresser with outside radius `tip_radius` (mm) dressing `flank`.
    ///
    /// # Errors
    /// [`DressingError::TipOutsideProfile`] for a radius that a profile does not have; [`DressingError::PointedTip`] where the
    /// profiles cross below it.
    pub fn new(tool: &'a DresserTool, flank: Flank, tip_radius: f64) -> Result<Self, DressingError> {
        if !tip_radius.is_finite() {
            return Err(DressingError::InvalidNumber {
                field: "dresser tip radius",
                value: tip_radius,
                allowed: "a finite length > 0 mm",
            });
        }
        let active = circles(&tool.flanks[flank], tip_radius)?;
        let counter = circles(&tool.flanks[flank.other()], tip_radius)?;
        let side = tool.flanks[flank].profile.at(active[0].0).n_z.signum();
        let full_land = side * (active[0].1.z - counter[0].1.z);
        if full_land < 0.0 {
            return Err(DressingError::PointedTip { radius: tip_radius, overlap: -full_land });
        }
        Ok(Self { tool, flank, tip_radius, full_land, side, active, counter })
    }

    /// The flank that is dressed.
    pub fn flank(&self) -> Flank {
        self.flank
    }

    /// The dresser.
    pub fn tool(&self) -> &'a DresserTool {
        self.tool
    }

    /// Outside radius, mm.
    pub fn tip_radius(&self) -> f64 {
        self.tip_radius
    }

    /// Width of the land that both flanks leave between them where they are designed, mm: the largest there is.
    pub fn full_land(&self) -> f64 {
        self.full_land
    }

    /// Refuses a tip land that this dresser cannot have.
    pub(crate) fn check_land(&self, tip_land: f64) -> Result<(), DressingError> {
        // A land computed as the full one may differ by rounding.
        if (0.0..=self.full_land * (1.0 + 1e-12)).contains(&tip_land) {
            Ok(())
        } else {
            Err(DressingError::TipLand { land: tip_land, full: self.full_land })
        }
    }

    /// Meridian point (r, z) of a part with a land of width `tip_land`, mm; `share` runs from 0 to 1 from the tip on, on the
    /// land from the active flank to the opposite flank.
    ///
    /// # Errors
    /// [`DressingError::TipLand`]; [`DressingError::InvalidNumber`] for a share outside 0..1.
    pub fn point(&self, part: SectionPart, share: f64, tip_land: f64) -> Result<[f64; 2], DressingError> {
        self.check_land(tip_land)?;
        if !(0.0..=1.0).contains(&share) {
            return Err(DressingError::InvalidNumber {
                field: "share of the section's part",
                value: share,
                allowed: "0 .. 1",
            });
        }
        let at = self.circle_at(part, share, tip_land);
        Ok([at.r, at.z])
    }

    /// The circle at a share of a part.
    pub(crate) fn circle_at(&self, part: SectionPart, share: f64, tip_land: f64) -> SectionCircle {
        let [from, to] = self.interval(part, tip_land);
        self.circle(part, from + share * (to - from), tip_land)
    }

    /// Interval of the parameter of a part.
    fn interval(&self, part: SectionPart, tip_land: f64) -> [f64; 2] {
        let ends = |list: &[(f64, SectionCircle)]| [list[0].0, list[list.len() - 1].0];
        match part {
            SectionPart::ActiveFlank => ends(&self.active),
            SectionPart::TipLand => [0.0, tip_land],
            SectionPart::CounterFlank => ends(&self.counter),
        }
    }

    /// The circle at a parameter of a part.
    pub(crate) fn circle(&self, part: SectionPart, t: f64, tip_land: f64) -> SectionCircle {
        match part {
            SectionPart::ActiveFlank => circle(&self.tool.flanks[self.flank].profile, t),
            SectionPart::TipLand => SectionCircle {
                r: self.tip_radius,
                z: self.active[0].1.z - self.side * t,
                slope: [0.0, -self.side],
            },
            SectionPart::CounterFlank => {
                self.shifted(circle(&self.tool.flanks[self.flank.other()].profile, t), tip_land)
            }
        }
    }

    /// The circles with which a part is looked at first.
    pub(crate) fn first_look(&self, part: SectionPart, tip_land: f64) -> Vec<(f64, SectionCircle)> {
        match part {
            SectionPart::ActiveFlank => self.active.clone(),
            SectionPart::TipLand => {
                let last = (LAND_CIRCLES - 1) as f64;
                let nodes = (0..LAND_CIRCLES).map(|k| tip_land * k as f64 / last);
                nodes.map(|t| (t, self.circle(part, t, tip_land))).collect()
            }
            SectionPart::CounterFlank => {
                self.counter.iter().map(|&(t, c)| (t, self.shifted(c, tip_land))).collect()
            }
        }
    }

    /// A circle of the opposite flank where the land has its width.
    fn shifted(&self, circle: SectionCircle, tip_land: f64) -> SectionCircle {
        SectionCircle { z: circle.z + self.side * (self.full_land - tip_land), ..circle }
    }
}
