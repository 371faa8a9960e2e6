//! How close the dresser comes to worm flanks that it does not dress: counter flank of the thread space, largest tip land,
//! undermining of a worm of smaller diameter (spec 30 section 13). Knows no wanted modification.

use super::dresser_section::{DresserSection, SectionCircle, SectionPart};
use super::envelope::{RelativeScrew, circle_contact};
use super::swept_circle::{CircleLeast, DresserPose, FlankSweep};
use super::{DressingError, GeometricRange};
use crate::geometry::{InvoluteFlank, Sides};
use crate::kinematics::DressingCorrection;
use crate::numerics::brent;
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

/// A worm flank and the part of it that is used.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WormFlank {
    /// The unmodified flank.
    pub flank: InvoluteFlank,
    /// Used lengths of roll.
    pub range: GeometricRange,
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

/// Flanks with leads that differ by less than this share form a space that is the same everywhere.
const SAME_LEAD: f64 = 1e-9;
/// Accuracy of the tip land, mm.
const LAND: f64 = 1e-10;
/// Steps by which the search reaches further out where nothing is near; the second one sees everything on the half of the
/// dresser that faces the worm.
const REACHES: [f64; 2] = [1.0, 1e3];

impl<'a> DresserSection<'a> {
    /// Pose of the dresser and the number of the thread space that it works in.
    fn seat(&self, dk: &DressingCorrection) -> Result<(DresserPose, f64), DressingError> {
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
        Ok(nearest(
            sweeps.iter().filter_map(|(sweep, b, reach)| self.nearest_to(sweep, tip_land, *b, *reach)),
        ))
    }

    /// Sweeps over the flank across the space, with b and the distance at which threads follow each other.
    fn counter_sweeps(
        &self,
        dk: &DressingCorrection,
        space: ThreadSpace,
    ) -> Result<Vec<(FlankSweep, f64, f64)>, DressingError> {
        let counter = &self.tool().flanks[self.flank().other()];
        let active = &self.tool().flanks[self.flank()];
        let worm = &counter.worm;
        if f64::from(space.left_out) >= worm.teeth {
            return Err(DressingError::InvalidNumber {
                field: "left-out threads",
                value: f64::from(space.left_out),
                allowed: "fewer than the worm has threads",
            });
        }
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
                    field: "screw parameter of the counter flank",
                    value: 1.0 / worm.twist_per_length(),
                    allowed: "that of the flank which is dressed, or a worm width has to be given",
                });
            }
        };
        let (pose, number) = self.seat(dk)?;
        let pitch = 2.0 * PI / worm.teeth;
        let beyond = pitch * f64::from(space.left_out);
        let reach = base_pitch(worm) * f64::from(1 + space.left_out);
        Ok(planes
            .into_iter()
            .map(|b| (FlankSweep::new(pose, worm, counter.range, number, beyond, b), b, reach))
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

    /// Largest tip land with which the clearance of the counter flank is at least `limit`, mm; `None` if a dresser without land
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
            let clearances =
                sweeps.iter().filter_map(|(sweep, b, reach)| self.nearest_to(sweep, land, *b, *reach));
            nearest(clearances).map_or(f64::INFINITY, |at| at.f) - limit
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
        if at_none.is_infinite() {
            return Ok(None);
        }
        Ok(brent([0.0, full], [at_none, at_full], LAND, |land| Some(spare(land))))
    }

    /// Where the dresser at `dk`, moved as for its own worm, comes closest to both flanks of another worm in each of the planes
    /// z = b (mm): undermining where f < 0. The groove centres of both worms stand on one line at z = 0. `None` where the
    /// dresser does not reach the used flank.
    ///
    /// # Errors
    /// [`DressingError::TipLand`], [`DressingError::NoContact`]; [`DressingError::InvalidNumber`] for another number of threads
    /// or hand, flanks of the wrong side, and a plane that is not finite.
    pub fn undermining(
        &self,
        dk: &DressingCorrection,
        tip_land: f64,
        other: &Sides<WormFlank>,
        b: &[f64],
    ) -> Result<Sides<Vec<Option<Clearance>>>, DressingError> {
        self.check_land(tip_land)?;
        let own = &self.tool().flanks[self.flank()].worm;
        let refuse = |field, value, allowed| Err(DressingError::InvalidNumber { field, value, allowed });
        for (flank, worm) in other.iter() {
            if worm.flank.teeth != own.teeth {
                return refuse(
                    "threads of the other worm",
                    worm.flank.teeth,
                    "those of the dresser's own worm",
                );
            }
            if worm.flank.flank != flank || worm.flank.twist_per_length() * own.twist_per_length() <= 0.0 {
                let twist = worm.flank.twist_per_length();
                return refuse(
                    "twist of the other worm",
                    twist,
                    "the hand of the own worm, left flank as left",
                );
            }
            if !(worm.range.w_nf > 0.0 && worm.range.w_na > worm.range.w_nf && worm.range.w_na.is_finite()) {
                return refuse("w_NfS of the other worm", worm.range.w_nf, "0 < w_NfS < w_NaS");
            }
        }
        if let Some(&b) = b.iter().find(|b| !b.is_finite()) {
            return refuse("worm position b", b, "a finite length");
        }
        let (pose, number) = self.seat(dk)?;
        Ok(other.map(|_, worm| {
            b.iter()
                .map(|&b| {
                    let sweep = FlankSweep::new(pose, &worm.flank, worm.range, number, 0.0, b);
                    self.nearest_to(&sweep, tip_land, b, base_pitch(&worm.flank))
                })
                .collect()
        }))
    }

    /// Least distance of the whole section from a flank.
    fn nearest_to(&self, sweep: &FlankSweep, tip_land: f64, b: f64, reach: f64) -> Option<Clearance> {
        for factor in REACHES {
            let most = reach * factor;
            let parts = SectionPart::ALL.into_iter();
            let found = nearest(parts.filter_map(|part| self.part(sweep, part, tip_land, most, b)));
            if let Some(at) = found
                && at.f <= most
            {
                return Some(at);
            }
        }
        None
    }

    /// Least distance of one part of the section.
    fn part(
        &self,
        sweep: &FlankSweep,
        part: SectionPart,
        tip_land: f64,
        most: f64,
        b: f64,
    ) -> Option<Clearance> {
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
            b,
        })
    }
}

/// The closest of several.
fn nearest(found: impl Iterator<Item = Clearance>) -> Option<Clearance> {
    found.min_by(|a, b| a.f.total_cmp(&b.f))
}

/// Normal distance of neighbouring threads, mm.
fn base_pitch(flank: &InvoluteFlank) -> f64 {
    2.0 * PI * flank.base_radius * flank.base_helix_angle.cos() / flank.teeth
}
