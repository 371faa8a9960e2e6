//! Worm and workpiece as removal sees them: densities, curvature of the gap and the worm's load along the profile.

use super::error::{in_range, positive};
use super::{Ground, TechnologyError};
use contact::{ContactError, FlankPair, Lever, Pair, StandOff};
use foundation::geometry::{Flank, InvoluteFlank, Sides};
use std::f64::consts::TAU;

/// Lengths of roll at which figures along the profile are given.
pub const STATIONS: usize = 9;

/// Worm and workpiece in contact.
#[derive(Clone, Debug)]
pub struct Bodies {
    /// Both bodies in their chain.
    pub pair: Pair,
    /// Tip radius of the worm, mm.
    pub worm_tip_radius: f64,
    /// Face width of the workpiece, mm; z from -b/2 to b/2.
    pub face_width: f64,
    /// Each flank.
    pub flanks: Sides<Engagement>,
}

/// One flank of worm and workpiece.
#[derive(Clone, Debug)]
pub struct Engagement {
    /// The pair at its centre distance.
    pub pair: FlankPair,
    /// Lengths of roll of the ground profile, form to tip, mm.
    pub roll: [f64; 2],
    face_width: f64,
    threads: f64,
    teeth: f64,
}

impl Bodies {
    /// For a cylindrical pair; `roll` are the lengths of roll of the ground profile.
    ///
    /// # Errors
    /// `CylindricalOnly`; `OutOfRange` for diameters and widths; `ContactBelowBase` where a place of the profile meets no worm flank.
    pub fn new(
        pair: Pair,
        worm_tip_radius: f64,
        face_width: f64,
        roll: Sides<[f64; 2]>,
    ) -> Result<Self, TechnologyError> {
        for (body, cylindrical) in
            [("worm", pair.worm.is_cylindrical()), ("workpiece", pair.work.is_cylindrical())]
        {
            if !cylindrical {
                return Err(TechnologyError::CylindricalOnly { body });
            }
        }
        positive("worm_tip_radius", worm_tip_radius)?;
        positive("face_width", face_width)?;
        let flanks = Sides::try_from_fn(|flank| {
            let [from, to] = roll[flank];
            in_range(
                "form_diameter",
                from,
                from > 0.0 && from < to,
                "a length of roll below that of the tip",
            )?;
            let engagement = Engagement {
                pair: pair.flanks[flank].clone(),
                roll: roll[flank],
                face_width,
                threads: pair.worm.tooth_count(),
                teeth: pair.work.tooth_count(),
            };
            let w_1 = engagement.worm_roll(to);
            if w_1.is_nan() || w_1 <= 0.0 {
                return Err(ContactError::ContactBelowBase { w_2: to, w_1 }.into());
            }
            Ok::<_, TechnologyError>(engagement)
        })?;
        Ok(Self { pair, worm_tip_radius, face_width, flanks })
    }

    /// Threads of the worm.
    pub fn threads(&self) -> f64 {
        self.pair.worm.tooth_count()
    }

    /// Teeth of the workpiece.
    pub fn teeth(&self) -> f64 {
        self.pair.work.tooth_count()
    }

    /// Revolutions per second of worm and workpiece at a cutting speed (m/s) on the worm's tip.
    pub fn speeds(&self, cutting_speed: f64) -> [f64; 2] {
        let n_1 = 1e3 * cutting_speed / (TAU * self.worm_tip_radius);
        [n_1, n_1 * self.threads() / self.teeth()]
    }

    /// How a stroke that leaves `left` (normal, mm) stands off the finished flanks that it grinds.
    pub fn stand_off(&self, ground: Ground, left: Sides<f64>) -> StandOff {
        let lever = |engagement: &Engagement| {
            let work = engagement.work();
            Lever {
                sine: engagement.pair.operating_alpha_n.sin(),
                arm: work.base_radius * work.base_helix_angle.cos(),
            }
        };
        let levers = Sides::from_fn(|flank| ground.has(flank).then(|| lever(&self.flanks[flank])));
        StandOff::of_ground(levers, left)
    }

    /// The largest value of a figure over the stations of some flanks.
    pub(crate) fn largest(
        &self,
        flanks: impl Iterator<Item = Flank>,
        figure: impl Fn(&Engagement, f64) -> f64,
    ) -> f64 {
        let of_flank = |flank: Flank| {
            let engagement = &self.flanks[flank];
            engagement.stations().into_iter().map(|w| figure(engagement, w)).fold(f64::MIN, f64::max)
        };
        flanks.map(of_flank).fold(f64::MIN, f64::max)
    }
}

impl Engagement {
    /// The workpiece's flank.
    pub fn work(&self) -> &InvoluteFlank {
        &self.pair.work
    }

    /// s of the flank.
    pub fn s(&self) -> f64 {
        self.pair.flank().sign()
    }

    /// s tan(beta_b2): the contact line is z + w times this = const.
    pub fn line_slope(&self) -> f64 {
        self.s() * self.pair.work.base_helix_angle.tan()
    }

    /// Equidistant lengths of roll over the profile, mm.
    pub fn stations(&self) -> [f64; STATIONS] {
        let [from, to] = self.roll;
        std::array::from_fn(|k| from + (to - from) * k as f64 / (STATIONS - 1) as f64)
    }

    /// J = dA/(dw dz) of the workpiece.
    pub fn area_density(&self, w: f64) -> f64 {
        let work = &self.pair.work;
        w / (work.base_radius * work.base_helix_angle.cos())
    }

    /// Area of the ground flank, mm^2.
    pub fn area(&self) -> f64 {
        let [from, to] = self.roll;
        self.face_width * 0.5 * (to - from) * (self.area_density(to) + self.area_density(from))
    }

    /// Length of roll on the worm that meets `w`, mm.
    pub fn worm_roll(&self, w: f64) -> f64 {
        self.pair.worm_roll(w, 0.0, 0.0)
    }

    /// lambda: width of the worm's active profile per length of roll of the workpiece.
    pub fn profile_width(&self, w: f64) -> f64 {
        let worm = &self.pair.worm;
        let (b_1, b_2) = (worm.base_helix_angle, self.pair.work.base_helix_angle);
        let w_1 = self.worm_roll(w);
        let along = w_1.hypot(worm.base_radius) * b_1.tan() / worm.base_radius;
        w_1 / (worm.base_radius * b_2.cos() * (1.0 + along * along).sqrt())
    }

    /// H: the worm leaves the gap H D^2/2 at the distance D ahead of the contact line, 1/mm.
    pub fn gap_curvature(&self, w: f64) -> f64 {
        self.pair.relative_curvature(self.worm_roll(w), w, 0.0).gap_along_feed()
    }

    /// chi: what is ground at the distance D ahead of the line is ground by a place of the worm chi D further along.
    pub fn ahead(&self, w: f64) -> f64 {
        let curvature = self.pair.relative_curvature(self.worm_roll(w), w, 0.0);
        let (h, moves) = (curvature.h, curvature.worm_moves());
        moves[(1, 0)] * h[(0, 1)] / h[(0, 0)] - moves[(1, 1)]
    }

    /// M: volume per millimetre of profile and worm width for each square millimetre of section that all spaces lose, mm.
    pub fn wear_factor(&self, w: f64) -> f64 {
        let (worm, work) = (&self.pair.worm, &self.pair.work);
        let w_1 = self.worm_roll(w);
        let cos_b1 = worm.base_helix_angle.cos();
        let worm_density = w_1 / (worm.base_radius * cos_b1);
        let circumference = TAU * w_1.hypot(worm.base_radius);
        circumference * self.teeth * self.area_density(w) * (work.base_helix_angle.cos() / cos_b1)
            / (self.threads * worm_density)
    }

    /// Length of the contact on the tooth for a distance D, mm.
    pub fn along_tooth(&self, w: f64, distance: f64) -> f64 {
        let work = &self.pair.work;
        let slope = w.hypot(work.base_radius) * work.base_helix_angle.tan() / work.base_radius;
        distance * slope.hypot(1.0)
    }

    /// C_c1, C_c2 and E with a raised centre distance, mm.
    pub fn raised(&self, delta_d: f64) -> [f64; 3] {
        let pair = &self.pair;
        let (sin, cos) = pair.operating_alpha_n.sin_cos();
        // T of the closed forms between cylinders; the crossed-axes angle is -(beta_w1 + beta_w2).
        let t = sin * -(pair.operating_beta_w1 + pair.operating_beta_w2).sin();
        let by = -self.s() * delta_d * cos / t;
        [
            pair.c_c1 + by * pair.operating_beta_w2.cos(),
            pair.c_c2 + by * pair.operating_beta_w1.cos(),
            -pair.hat_c + delta_d / sin,
        ]
    }
}
