//! Exact forward calculation at constant DK: profile, derivatives and contact line (`docs/mathematics/dressing.md`).

use super::dresser::FlankDresser;
use super::placement::{DresserAxes, WormScrew, slack, touch};
use super::{DresserTool, DressingError, TiltChart};
use foundation::geometry::Flank;
use foundation::kinematics::DressingCorrection;
use foundation::numerics::{Scalar, gradient_of, value_of, variables};
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
    /// df/dK_j at fixed (w, b): mm/rad, mm/rad, 1, 1; in the tilt chart by its four numbers.
    pub df_dk: [f64; 4],
}

/// Circles looked at over the whole profile, in search of one that touches.
const FIRST_CIRCLES: u8 = 17;

/// Forward calculation of one flank in one constant position of the dresser.
#[derive(Clone, Copy, Debug)]
pub struct DressedProfile<'a> {
    dresser: &'a FlankDresser,
    setting: Setting,
}

/// A constant position in one of the charts.
#[derive(Clone, Copy, Debug)]
enum Setting {
    Correction(DressingCorrection),
    Tilt([f64; 4]),
}

struct Foot<T: Scalar> {
    w: T,
    f: T,
    b: T,
    q: Vector3<T>,
    n: Vector3<T>,
    r: T,
}

impl<'a> DressedProfile<'a> {
    /// Profile of `flank` dressed by `tool` at the correction `dk`.
    pub fn new(tool: &'a DresserTool, flank: Flank, dk: DressingCorrection) -> Self {
        Self::of_flank(&tool.flanks[flank], dk)
    }

    /// Profile dressed by one flank of a dresser at the correction `dk`.
    pub fn of_flank(dresser: &'a FlankDresser, dk: DressingCorrection) -> Self {
        Self { dresser, setting: Setting::Correction(dk) }
    }

    /// Profile dressed by one flank of a dresser in a position of the tilt chart. Derivatives are by (phi_S, gamma_X, d_X, tau);
    /// worm positions b lie v_y sin(gamma) below those of the same kinematics K.
    pub fn tilted(dresser: &'a FlankDresser, at: &TiltChart) -> Self {
        Self { dresser, setting: Setting::Tilt([at.phi, at.gamma, at.d, at.tau]) }
    }

    fn no_contact(&self, t: f64) -> DressingError {
        // Nothing touches at a number that is none.
        match self.numbers().into_iter().chain([t]).find(|x| !x.is_finite()) {
            Some(value) => DressingError::InvalidNumber {
                field: "length of roll, profile parameter or correction",
                value,
                allowed: "finite numbers",
            },
            None => DressingError::NoContact { flank: self.dresser.worm.flank, t },
        }
    }

    /// The four numbers of the setting.
    fn numbers(&self) -> [f64; 4] {
        match self.setting {
            Setting::Correction(x) | Setting::Tilt(x) => x,
        }
    }

    /// Worm angle and dresser for the numbers of the setting, or dual numbers there.
    fn placed<T: Scalar>(&self, x: &[T; 4]) -> (T, DresserAxes<T>) {
        let chain = &self.dresser.chain;
        match self.setting {
            Setting::Correction(_) => (
                x[0] + chain.worm_angle,
                DresserAxes::kinematic(
                    x[1] + chain.crossing_angle,
                    x[2] + chain.centre_distance,
                    x[3] + chain.offset,
                ),
            ),
            Setting::Tilt(_) => (x[0], DresserAxes::tilted(x[1], x[2], x[3])),
        }
    }

    fn foot_at<T: Scalar>(&self, t: T, x: &[T; 4]) -> Result<Foot<T>, DressingError> {
        let (phi, dresser) = self.placed(x);
        self.foot(t, phi, &dresser).ok_or_else(|| self.no_contact(value_of(t)))
    }

    fn foot<T: Scalar>(&self, t: T, phi: T, dresser: &DresserAxes<T>) -> Option<Foot<T>> {
        let meridian = self.dresser.profile.at(t);
        let contact = touch(&meridian, dresser, &WormScrew::steady(self.dresser.chain.screw_parameter))?;
        let (sin, cos) = (-phi).sin_cos();
        let q = contact.q;
        let x = Vector3::new(cos * q.x - sin * q.y, sin * q.x + cos * q.y, q.z);
        let at = self.dresser.worm.deviation(&x);
        value_of(at.w).is_finite().then_some(Foot {
            w: at.w,
            f: at.f_n,
            b: at.z,
            q,
            n: contact.n,
            r: meridian.r,
        })
    }

    /// How far the dresser circle with profile parameter t is from losing contact, without unit: 1 - D^2/Q of the contact
    /// condition A cos(psi) + B sin(psi) + D = 0, Q = A^2 + B^2; at 0 it touches in one last point, below nowhere.
    pub fn slack(&self, t: f64) -> f64 {
        let (_, dresser) = self.placed(&self.numbers());
        slack(&self.dresser.profile.at(t), &dresser, &WormScrew::steady(self.dresser.chain.screw_parameter))
    }

    /// Parameter interval of the dresser's profile, mm.
    pub fn interval(&self) -> (f64, f64) {
        self.dresser.profile.interval()
    }

    /// Change of the dressed length of roll by the profile parameter at t; `None` where the circle touches nothing.
    pub fn roll_slope(&self, t: f64) -> Option<f64> {
        let (phi, dresser) = self.placed(&self.numbers().map(DualSVec64::<1>::from));
        let [t] = variables([t]);
        self.foot(t, phi, &dresser).map(|at| gradient_of(&at.w)[0])
    }

    /// w(t), f, b of the dresser circle with profile parameter t.
    ///
    /// # Errors
    /// [`DressingError::NoContact`]; [`DressingError::InvalidNumber`] for a parameter that the profile does not have.
    pub fn at_parameter(&self, t: f64) -> Result<ProfilePoint, DressingError> {
        self.on_profile(t)?;
        let at = self.foot_at(t, &self.numbers())?;
        Ok(self.point(t, &at))
    }

    fn on_profile(&self, t: f64) -> Result<(), DressingError> {
        if self.dresser.profile.covers(t) {
            return Ok(());
        }
        let (field, allowed) = ("dresser profile parameter", "within the profile of the dresser");
        Err(DressingError::InvalidNumber { field, value: t, allowed })
    }

    fn point(&self, t: f64, at: &Foot<f64>) -> ProfilePoint {
        let q = &at.q;
        let (phi, dresser) = self.placed(&self.numbers());
        let last = match self.setting {
            Setting::Correction(_) => -dresser.e2,
            Setting::Tilt(_) => dresser.e2.cross(&(q - dresser.centre)),
        };
        let velocities =
            [Vector3::new(q.y, -q.x, 0.0), Vector3::new(0.0, q.z, -q.y), Vector3::new(1.0, 0.0, 0.0), last];
        // Nominal worm normal on the ray, turned into the room.
        let turned = self.dresser.worm.phi(at.w, at.b) - (phi + std::f64::consts::FRAC_PI_2);
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
        let (range, designed) = (&self.dresser.range, &self.dresser.designed);
        self.at_roll_near(w, designed.w_nf + (w - range.w_nf) * (designed.length() / range.length()))
    }

    /// The same with a profile parameter near the one sought, mm, such as that of a position nearby.
    ///
    /// # Errors
    /// As [`DressedProfile::at_roll`].
    pub fn at_roll_near(&self, w: f64, t: f64) -> Result<ProfilePoint, DressingError> {
        if !w.is_finite() {
            let (field, allowed) = ("length of roll", "finite numbers");
            return Err(DressingError::InvalidNumber { field, value: w, allowed });
        }
        let (from, to) = self.interval();
        let outside = || DressingError::OutOfDresser { flank: self.dresser.worm.flank, w, from, to };
        let (phi, axes) = self.placed(&self.numbers().map(DualSVec64::<1>::from));
        // w(t) and its slope; where the dresser's radii follow each other backwards is no contact that counts.
        let roll = |t: f64| {
            let [td] = variables([t]);
            let at = self.foot(td, phi, &axes).ok_or_else(|| self.no_contact(t))?;
            let slope = gradient_of(&at.w)[0];
            if slope > 0.0 { Ok((value_of(at.w), slope)) } else { Err(outside()) }
        };
        let (mut t, mut at) = self.first_contact(t.clamp(from, to), &roll)?;
        // The root lies between these; an end of the profile counts as long as it has not been looked at.
        let (mut low, mut high) = (from, to);
        let mut previous = f64::INFINITY;
        for _ in 0..120 {
            let step = (w - at.0) / at.1;
            if step > 0.0 {
                low = t
            } else {
                high = t
            }
            if step.abs() < 1e-12 || (step.abs() < 1e-9 && step.abs() >= previous) {
                t += step;
                return if self.dresser.profile.covers(t) { self.at_parameter(t) } else { Err(outside()) };
            }
            if low >= to || high <= from {
                return Err(outside());
            }
            previous = step.abs();
            let mut next = (t + step.clamp(-2.0, 2.0)).clamp(from, to);
            if (next >= high && high < to) || (next <= low && low > from) {
                next = 0.5 * (low + high);
            }
            // Back towards the contact where there is none.
            loop {
                match roll(next) {
                    Ok(found) => {
                        (t, at) = (next, found);
                        break;
                    }
                    Err(failure) if (next - t).abs() < 1e-9 => return Err(failure),
                    Err(_) => {
                        if next > t {
                            high = next
                        } else {
                            low = next
                        }
                        next = 0.5 * (t + next);
                    }
                }
            }
        }
        Err(outside())
    }

    /// A profile parameter near to `t` where the dresser touches, with w and its slope: itself or the nearest of some over the
    /// whole profile.
    fn first_contact(
        &self,
        t: f64,
        roll: &impl Fn(f64) -> Result<(f64, f64), DressingError>,
    ) -> Result<(f64, (f64, f64)), DressingError> {
        roll(t).map(|at| (t, at)).or_else(|none| {
            let (from, to) = self.interval();
            let steps = f64::from(FIRST_CIRCLES - 1);
            let mut circles: Vec<f64> =
                (0..FIRST_CIRCLES).map(|k| from + (to - from) * f64::from(k) / steps).collect();
            circles.sort_by(|a, b| (a - t).abs().total_cmp(&(b - t).abs()));
            circles.into_iter().find_map(|t| roll(t).ok().map(|at| (t, at))).ok_or(none)
        })
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
    /// As [`DressedProfile::at_parameter`].
    pub fn map_gradient(&self, t: f64) -> Result<(f64, [f64; 4]), DressingError> {
        self.on_profile(t)?;
        let at = self.foot_at(DualSVec64::<4>::from(t), &variables(self.numbers()))?;
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
    if !head.covers(t) {
        let (field, allowed) = ("head profile parameter", "within the head profile of the dresser");
        return Err(DressingError::InvalidNumber { field, value: t, allowed });
    }
    let chain = &tool.flanks.left.chain;
    let [_, gamma, d, v_y] = variables(*dk);
    let dresser =
        DresserAxes::kinematic(gamma + chain.crossing_angle, d + chain.centre_distance, v_y + chain.offset);
    let meridian = head.at(DualSVec64::<4>::from(t));
    let contact = touch(&meridian, &dresser, &WormScrew::steady(chain.screw_parameter))
        .ok_or(DressingError::NoContact { flank: Flank::Left, t })?;
    let radius = DualNum::sqrt(&(contact.q.x * contact.q.x + contact.q.y * contact.q.y));
    Ok((value_of(radius), gradient_of(&radius)))
}
