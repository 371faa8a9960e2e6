//! Exact forward calculation at constant DK: profile, derivatives and contact line (spec 30 sections 4 to 6).

use super::dresser::FlankDresser;
use super::envelope::{RelativeScrew, circle_contact};
use super::{DresserTool, DressingError};
use crate::geometry::{Flank, InvoluteFlank, Revolution};
use crate::kinematics::{DressingChain, DressingCorrection};
use crate::numerics::{Scalar, gradient_of, value_of, variables};
use nalgebra::Vector3;
use num_dual::{DualNum, DualSVec64};

/// One point of a dressed profile.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProfilePoint {
    /// Length of roll on the worm, mm.
    pub w: f64,
    /// Normal modification f_nFS(w), mm; > 0 material left.
    pub f: f64,
    /// Worm z of the contact at v_zS = 0, mm.
    pub b: f64,
    /// Dresser profile parameter that dresses it, mm.
    pub t: f64,
    /// Dresser radius of the contact, mm.
    pub r_a: f64,
    /// df/dK_j at fixed (w, b): mm/rad, mm/rad, 1, 1.
    pub df_dk: [f64; 4],
}

/// Forward calculation of one flank at one constant correction DK.
#[derive(Clone, Copy, Debug)]
pub struct DressedProfile<'a> {
    dresser: &'a FlankDresser,
    dk: DressingCorrection,
}

struct Foot<T: Scalar> {
    w: T,
    f: T,
    b: T,
    q: Vector3<T>,
    n: Vector3<T>,
    r: T,
}

/// Kinematics as scalars: nominal values plus corrections.
fn kinematics<T: Scalar>(chain: &DressingChain, dk: &[T; 4]) -> (T, RelativeScrew<T>) {
    let zero = T::from(0.0);
    let screw = RelativeScrew {
        gamma: dk[1] + chain.crossing_angle,
        d: dk[2] + chain.centre_distance,
        v_y: dk[3] + chain.offset,
        rates: [zero; 4],
        p: chain.screw_parameter,
    };
    (dk[0] + chain.worm_angle, screw)
}

fn foot<T: Scalar>(
    flank: &InvoluteFlank,
    profile: &Revolution,
    t: T,
    phi: T,
    screw: &RelativeScrew<T>,
) -> Option<Foot<T>> {
    let meridian = profile.at(t);
    let contact = circle_contact(&meridian, screw)?;
    let (sin, cos) = (-phi).sin_cos();
    let q = contact.q;
    let x = Vector3::new(cos * q.x - sin * q.y, sin * q.x + cos * q.y, q.z);
    let at = flank.deviation(&x);
    value_of(at.w).is_finite().then_some(Foot { w: at.w, f: at.f_n, b: at.z, q, n: contact.n, r: meridian.r })
}

impl<'a> DressedProfile<'a> {
    /// Profile of `flank` dressed by `tool` at the correction `dk`.
    pub fn new(tool: &'a DresserTool, flank: Flank, dk: DressingCorrection) -> Self {
        Self::of_flank(&tool.flanks[flank], dk)
    }

    /// Profile dressed by one flank of a dresser at the correction `dk`.
    pub fn of_flank(dresser: &'a FlankDresser, dk: DressingCorrection) -> Self {
        Self { dresser, dk }
    }

    fn no_contact(&self, t: f64) -> DressingError {
        DressingError::NoContact { flank: self.dresser.worm.flank, t }
    }

    fn foot_at<T: Scalar>(&self, t: T, dk: &[T; 4]) -> Result<Foot<T>, DressingError> {
        let (phi, screw) = kinematics(&self.dresser.chain, dk);
        foot(&self.dresser.worm, &self.dresser.profile, t, phi, &screw)
            .ok_or_else(|| self.no_contact(value_of(t)))
    }

    /// w(t), f, b of the dresser circle with profile parameter t.
    ///
    /// # Errors
    /// [`DressingError::NoContact`].
    pub fn at_parameter(&self, t: f64) -> Result<ProfilePoint, DressingError> {
        let at = self.foot_at(t, &self.dk)?;
        Ok(self.point(t, &at))
    }

    fn point(&self, t: f64, at: &Foot<f64>) -> ProfilePoint {
        let gamma = self.dresser.chain.crossing_angle + self.dk[1];
        let (sin, cos) = gamma.sin_cos();
        let q = &at.q;
        let velocities = [
            Vector3::new(q.y, -q.x, 0.0),
            Vector3::new(0.0, q.z, -q.y),
            Vector3::new(1.0, 0.0, 0.0),
            Vector3::new(0.0, -cos, sin),
        ];
        // Nominal worm normal on the ray, turned into the room.
        let turned = self.dresser.worm.phi(at.w, at.b)
            - (self.dresser.chain.worm_angle + self.dk[0] + std::f64::consts::FRAC_PI_2);
        let (sp, cp) = turned.sin_cos();
        let (sb, cb) = self.dresser.worm.base_helix_angle.sin_cos();
        let s = self.dresser.worm.s();
        let normal = Vector3::new(s * cb * sp, s * cb * cp, -s * sb);
        let facing = at.n.dot(&normal);
        ProfilePoint {
            w: at.w,
            f: at.f,
            b: at.b,
            t,
            r_a: at.r,
            df_dk: velocities.map(|v| at.n.dot(&v) / facing),
        }
    }

    /// The profile point at length of roll w: f_nFS(w; DK) with its derivatives.
    ///
    /// # Errors
    /// [`DressingError::NoContact`], [`DressingError::OutOfDresser`].
    pub fn at_roll(&self, w: f64) -> Result<ProfilePoint, DressingError> {
        let (from, to) = self.dresser.profile.interval();
        let outside = || DressingError::OutOfDresser { flank: self.dresser.worm.flank, w, from, to };
        let (range, designed) = (&self.dresser.range, &self.dresser.designed);
        let scaled = designed.w_nf + (w - range.w_nf) * (designed.length() / range.length());
        let mut t = scaled.clamp(from, to);
        let fixed = self.dk.map(DualSVec64::<1>::from);
        let mut previous = f64::INFINITY;
        for _ in 0..40 {
            let [td] = variables([t]);
            let at = self.foot_at(td, &fixed)?;
            let slope = gradient_of(&at.w)[0];
            let step = (value_of(at.w) - w) / slope;
            if !step.is_finite() || slope <= 0.0 {
                return Err(outside());
            }
            t -= step.clamp(-2.0, 2.0);
            if !self.dresser.profile.covers(t) {
                return Err(outside());
            }
            if step.abs() < 1e-12 || (step.abs() < 1e-9 && step.abs() >= previous) {
                return self.at_parameter(t);
            }
            previous = step.abs();
        }
        Err(outside())
    }

    /// Profile points at several lengths of roll.
    ///
    /// # Errors
    /// As [`DressedProfile::at_roll`].
    pub fn at_rolls(&self, w: &[f64]) -> Result<Vec<ProfilePoint>, DressingError> {
        w.iter().map(|&w| self.at_roll(w)).collect()
    }

    /// w(t; K) and its gradient by K (radius map rows).
    ///
    /// # Errors
    /// [`DressingError::NoContact`].
    pub fn map_gradient(&self, t: f64) -> Result<(f64, [f64; 4]), DressingError> {
        let dk = variables(self.dk);
        let at = self.foot_at(DualSVec64::<4>::from(t), &dk)?;
        Ok((value_of(at.w), gradient_of(&at.w)))
    }
}

/// Radius dressed by the head profile at parameter t_H and its gradient by K.
///
/// # Errors
/// [`DressingError::InvalidNumber`] for a dresser without head, [`DressingError::NoContact`].
pub fn head_gradient(
    tool: &DresserTool,
    t: f64,
    dk: &DressingCorrection,
) -> Result<(f64, [f64; 4]), DressingError> {
    let head = tool.head.as_ref().ok_or(DressingError::InvalidNumber {
        field: "head condition",
        value: t,
        allowed: "only for a dresser with a head profile",
    })?;
    let (_, screw) = kinematics(&tool.flanks.left.chain, &variables(*dk));
    let contact = circle_contact(&head.at(DualSVec64::<4>::from(t)), &screw)
        .ok_or(DressingError::NoContact { flank: Flank::Left, t })?;
    let radius = DualNum::sqrt(&(contact.q.x * contact.q.x + contact.q.y * contact.q.y));
    Ok((value_of(radius), gradient_of(&radius)))
}
