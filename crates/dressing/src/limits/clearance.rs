//! How close the dresser comes to the flank across the thread space, and how wide its tip land may be
//! (`docs/mathematics/dressing.md#limits-of-a-correction`). Knows no wanted modification.

use crate::DressingError;
use crate::envelope::{RelativeScrew, circle_contact};
use crate::limits::dresser_pose::DresserPose;
use crate::limits::dresser_section::{DresserSection, SectionCircle, SectionPart};
use crate::limits::swept_circle::{CircleLeast, FlankSweep};
use foundation::kinematics::DressingCorrection;
use foundation::numerics::brent;
use std::f64::consts::PI;

/// The thread space in which the dresser works.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ThreadSpace {
    /// Threads removed between the flank that is dressed and the one across the space.
    pub left_out: u32,
    /// Worm z from and to, mm: needed where the flanks have different leads (conical worms), because the space then changes
    /// along the worm.
    pub width: Option<[f64; 2]>,
}

impl From<u32> for ThreadSpace {
    fn from(left_out: u32) -> Self {
        Self { left_out, width: None }
    }
}

/// Where a dresser comes closest to a worm flank. mm, rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clearance {
    /// Least distance along the rays of the nominal flank, mm; < 0 where the dresser cuts into it.
    pub f: f64,
    /// Part of the section.
    pub part: SectionPart,
    /// Circle of the dresser: radius and axial position in its own frame, mm.
    pub circle: [f64; 2],
    /// Angle on the circle against the direction to the worm axis, rad.
    pub psi: f64,
    /// Length of roll of the ray, mm.
    pub w: f64,
    /// Plane z = b of the worm in which the distance was sought, mm.
    pub b: f64,
}

impl Clearance {
    /// The circle without its place in the section.
    pub(crate) fn section_circle(&self) -> SectionCircle {
        let [r, z] = self.circle;
        SectionCircle { r, z, slope: [0.0; 2] }
    }
}

/// Flanks with leads that differ by less than this share form a space that is the same everywhere.
const SAME_LEAD: f64 = 1e-9;
/// Accuracy of the tip land, mm.
const LAND: f64 = 1e-10;
/// Clearances up to which is searched at last, in distances of neighbouring threads: everything on the half of the dresser that
/// faces the worm.
const FARTHEST: f64 = 1e3;

impl DresserSection<'_> {
    /// Pose of the dresser and the number of the thread space that it works in.
    pub(crate) fn seat(&self, dk: &DressingCorrection) -> Result<(DresserPose, f64), DressingError> {
        for (field, &value) in ["d_phi_S", "d_gamma", "d_d", "d_v_yA"].into_iter().zip(dk) {
            if !value.is_finite() {
                return Err(DressingError::InvalidNumber { field, value, allowed: "a finite number" });
            }
        }
        let dresser = &self.tool().flanks[self.flank()];
        let chain = &dresser.chain;
        let pose = DresserPose::new(chain, dk);
        let t = dresser.designed.middle();
        let screw = RelativeScrew {
            gamma: chain.crossing_angle + dk[1],
            d: chain.centre_distance + dk[2],
            v_y: chain.offset + dk[3],
            rates: [0.0; 4],
            p: chain.screw_parameter,
        };
        let contact = circle_contact(&dresser.profile.at(t), &screw)
            .ok_or(DressingError::NoContact { flank: self.flank(), t })?;
        let sweep = FlankSweep::new(pose, &dresser.worm, dresser.range, 0.0, 0.0, 0.0);
        Ok((pose, sweep.nearest_space(contact.q.into(), 2.0 * PI / dresser.worm.teeth)))
    }

    /// Where the dresser at `dk` comes closest to the flank across the thread space; `None` where it does not reach the used
    /// part of that flank at all.
    ///
    /// The worm passes the dresser along the lead of the flank that is dressed.
    ///
    /// # Errors
    /// [`DressingError::TipLand`] for a land that the dresser cannot have, [`DressingError::InvalidNumber`] for more left-out
    /// threads than the worm has or a conical worm without width, [`DressingError::NoContact`].
    pub fn counter_flank(
        &self,
        dk: &DressingCorrection,
        tip_land: f64,
        space: ThreadSpace,
    ) -> Result<Option<Clearance>, DressingError> {
        self.check_land(tip_land)?;
        let sweeps = self.counter_sweeps(dk, space)?;
        Ok(nearest(sweeps.iter().filter_map(|sweep| self.nearest_to(sweep, tip_land))))
    }

    /// Sweeps over the flank across the space, one for every plane z = b that is needed.
    fn counter_sweeps(
        &self,
        dk: &DressingCorrection,
        space: ThreadSpace,
    ) -> Result<Vec<FlankSweep>, DressingError> {
        let counter = &self.tool().flanks[self.flank().other()];
        let active = &self.tool().flanks[self.flank()];
        let worm = &counter.worm;
        self.check_left_out(space.left_out)?;
        let same = (worm.twist_per_length() * active.chain.screw_parameter - 1.0).abs() < SAME_LEAD;
        let planes = match space.width {
            Some([from, to]) if !(from.is_finite() && to.is_finite() && from <= to) => {
                return Err(DressingError::InvalidNumber {
                    field: "worm width from",
                    value: from,
                    allowed: "finite and not above the width's end",
                });
            }
            _ if same => vec![0.0],
            // At every place of the section f changes linearly with b, so that the least one is at an end.
            Some([from, to]) => vec![from, to],
            None => {
                return Err(DressingError::InvalidNumber {
                    field: "screw parameter of the opposite flank",
                    value: 1.0 / worm.twist_per_length(),
                    allowed: "that of the flank which is dressed, or a worm width has to be given",
                });
            }
        };
        let (pose, number) = self.seat(dk)?;
        let beyond = 2.0 * PI / worm.teeth * f64::from(space.left_out);
        Ok(planes
            .into_iter()
            .map(|b| FlankSweep::new(pose, worm, counter.range, number, beyond, b))
            .collect())
    }

    /// Least clearance of [`DresserSection::counter_flank`], mm; infinite where the dresser does not reach the flank.
    ///
    /// # Errors
    /// As [`DresserSection::counter_flank`].
    pub fn counter_flank_clearance(
        &self,
        dk: &DressingCorrection,
        tip_land: f64,
        space: ThreadSpace,
    ) -> Result<f64, DressingError> {
        Ok(self.counter_flank(dk, tip_land, space)?.map_or(f64::INFINITY, |at| at.f))
    }

    /// Largest tip land with which the clearance of the opposite flank is at least `limit`, mm; `None` if a dresser without land
    /// collides.
    ///
    /// A wider land contains the narrower one, so that the clearance falls with it.
    ///
    /// # Errors
    /// As [`DresserSection::counter_flank`]; [`DressingError::InvalidNumber`] for a limit that is not finite.
    pub fn largest_tip_land(
        &self,
        dk: &DressingCorrection,
        limit: f64,
        space: ThreadSpace,
    ) -> Result<Option<f64>, DressingError> {
        if !limit.is_finite() {
            return Err(DressingError::InvalidNumber {
                field: "least clearance",
                value: limit,
                allowed: "a finite length",
            });
        }
        let sweeps = self.counter_sweeps(dk, space)?;
        let spare = |land: f64| {
            // Out of reach is as good as the farthest that is looked for.
            let clearance =
                |sweep: &FlankSweep| self.nearest_to(sweep, land).map_or(sweep.reach() * FARTHEST, |at| at.f);
            sweeps.iter().map(clearance).fold(f64::INFINITY, f64::min) - limit
        };
        let full = self.full_land();
        let at_full = spare(full);
        if at_full >= 0.0 {
            return Ok(Some(full));
        }
        let at_none = spare(0.0);
        if at_none < 0.0 {
            return Ok(None);
        }
        Ok(brent([0.0, full], [at_none, at_full], LAND, |land| Some(spare(land))))
    }

    /// Refuses as many inactive threads as the worm has, or more.
    pub(crate) fn check_left_out(&self, left_out: u32) -> Result<(), DressingError> {
        if f64::from(left_out) < self.tool().flanks[self.flank()].worm.teeth {
            return Ok(());
        }
        Err(DressingError::InvalidNumber {
            field: "inactive threads",
            value: f64::from(left_out),
            allowed: "fewer than the worm has threads",
        })
    }

    /// Least distance of the whole section from a flank.
    pub(crate) fn nearest_to(&self, sweep: &FlankSweep, tip_land: f64) -> Option<Clearance> {
        for factor in [1.0, FARTHEST] {
            let most = sweep.reach() * factor;
            let parts = SectionPart::ALL.into_iter();
            let found = nearest(parts.filter_map(|part| self.part(sweep, part, tip_land, most)));
            if let Some(at) = found
                && at.f <= most
            {
                return Some(at);
            }
        }
        None
    }

    /// Least distance of one part of the section.
    fn part(&self, sweep: &FlankSweep, part: SectionPart, tip_land: f64, most: f64) -> Option<Clearance> {
        let mut best: Option<(SectionCircle, CircleLeast)> = None;
        let mut offer = |circle: SectionCircle, at: CircleLeast| {
            if best.is_none_or(|(_, least)| at.f < least.f) {
                best = Some((circle, at));
            }
        };
        let nodes: Vec<(f64, Option<CircleLeast>)> = self
            .first_look(part, tip_land)
            .into_iter()
            .map(|(t, circle)| {
                let at = sweep.least(&circle, most);
                if let Some(at) = at {
                    offer(circle, at);
                }
                (t, at)
            })
            .collect();
        for pair in nodes.windows(2) {
            let [(t_0, at_0), (t_1, at_1)] = [pair[0], pair[1]];
            // Where a circle has lost the flank, the least value rises steeply towards it: an end of the used flank lies between.
            let (slope_0, slope_1) = match (at_0, at_1) {
                (Some(a), Some(b)) => (a.slope, b.slope),
                (Some(a), None) => (a.slope, a.slope.abs()),
                (None, Some(b)) => (-b.slope.abs(), b.slope),
                (None, None) => continue,
            };
            if !(slope_0 < 0.0 && slope_1 > 0.0) {
                continue;
            }
            let beyond = if at_0.is_some() { slope_1 } else { slope_0 };
            brent([t_0, t_1], [slope_0, slope_1], 1e-11, |t| {
                let circle = self.circle(part, t, tip_land);
                let at = sweep.least(&circle, most);
                if let Some(at) = at {
                    offer(circle, at);
                }
                Some(at.map_or(beyond, |at| at.slope))
            });
        }
        best.map(|(circle, at)| Clearance {
            f: at.f,
            part,
            circle: [circle.r, circle.z],
            psi: at.psi,
            w: at.w,
            b: sweep.b(),
        })
    }
}

/// The closest of several.
fn nearest(found: impl Iterator<Item = Clearance>) -> Option<Clearance> {
    found.min_by(|a, b| a.f.total_cmp(&b.f))
}
