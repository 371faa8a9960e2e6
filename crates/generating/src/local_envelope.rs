//! The local-envelope model of grinding (`docs/mathematics/generating-contact.md#exact-contact`): how the contact shifts under a
//! modification, to second order of the unmodified surfaces. Start values and estimates only; the forward model of the product is the exact
//! contact.

use super::GeneratingError;
use contact::{ContactError, FlankPair, ThreadFunction};
use foundation::kinematics::GeneratingMotion;
use foundation::numerics::Jet2;
use nalgebra::{Matrix2, Vector2};

/// A cylindrical pair, a motion and a worm modification, one flank. Delta_gamma is not part of the model.
#[derive(Clone, Copy, Debug)]
pub struct LocalEnvelope<'a, F: ThreadFunction> {
    pair: &'a FlankPair,
    motion: &'a GeneratingMotion,
    function: &'a F,
}

/// Newton steps at most; 6 to 12 are usual.
const STEPS: usize = 40;
/// Converged when the contact moves by less than this, mm.
const CONVERGED: f64 = 1e-11;

/// What the model needs of one unmodified contact.
struct Contact {
    w_1: f64,
    z_1: f64,
    feed: f64,
    /// mu and nu of d.
    mu: Jet2,
    nu: Jet2,
    /// Radii of curvature of worm and workpiece.
    radii: [f64; 2],
}

/// a dw + b dz + c.
fn affine(a: f64, b: f64, c: f64) -> Jet2 {
    Jet2 { f: c, fu: a, fv: b, ..Jet2::default() }
}

fn hessian(j: &Jet2) -> Matrix2<f64> {
    Matrix2::new(j.fuu, j.fuv, j.fuv, j.fvv)
}

fn t_k(pair: &FlankPair) -> f64 {
    pair.flank().sign() * pair.work.base_helix_angle.tan()
}

impl Contact {
    fn new(pair: &FlankPair, w_2: f64, z_2: f64) -> Result<Self, GeneratingError> {
        let w_1 = pair.worm_roll(w_2, 0.0, 0.0);
        if !(w_1 > 0.0 && w_2 > 0.0) {
            return Err(ContactError::ContactBelowBase { w_2, w_1 }.into());
        }
        let t_k = t_k(pair);
        let rolled = w_2 / pair.work.base_radius;
        Ok(Self {
            w_1,
            z_1: 0.0,
            feed: pair.c_c2 - t_k * w_2 - z_2,
            mu: affine(rolled, -rolled * t_k, 0.0),
            nu: affine(0.0, 1.0 / pair.work.base_helix_angle.cos(), 0.0),
            radii: [w_1 / pair.worm.base_helix_angle.cos(), w_2 / pair.work.base_helix_angle.cos()],
        })
    }

    /// (1/2) d^T R d + terms in the radial displacement `lift` of the worm flank along e_r1.
    fn curvature(&self, pair: &FlankPair, lift: Jet2) -> Jet2 {
        let [_, g_2] = pair.generatrices();
        let across = self.mu * pair.e_r1.dot(&pair.e_r2) + self.nu * pair.e_r1.dot(&g_2) + -lift;
        self.mu * self.mu * (0.5 / self.radii[1]) + across * across * (0.5 / self.radii[0])
    }
}

/// q of `docs/mathematics/generating-contact.md#exact-contact`, mm: a motion whose normal amount changes by F' per mm of feed leaves the
/// flank q F'^2/2 deeper, and its contact runs ahead by q F'.
///
/// # Errors
/// `ContactBelowBase`.
pub fn kinematic_compliance(pair: &FlankPair, w_2: f64) -> Result<f64, GeneratingError> {
    let contact = Contact::new(pair, w_2, 0.0)?;
    let slope = Vector2::new(t_k(pair), 1.0);
    let inverse = hessian(&contact.curvature(pair, Jet2::default())).try_inverse();
    Ok(inverse.map_or(f64::INFINITY, |r| slope.dot(&(r * slope))))
}

impl<'a, F: ThreadFunction> LocalEnvelope<'a, F> {
    /// For one flank of a cylindrical pair.
    pub fn new(pair: &'a FlankPair, motion: &'a GeneratingMotion, function: &'a F) -> Self {
        Self { pair, motion, function }
    }

    fn contact(&self, w_2: f64, z_2: f64) -> Result<Contact, GeneratingError> {
        let mut contact = Contact::new(self.pair, w_2, z_2)?;
        contact.z_1 = self.pair.worm_z(contact.w_1, self.motion.shift.value(contact.feed), contact.feed);
        Ok(contact)
    }

    /// J(d) with its derivatives in d = (dw, dz); without the terms of second order of the true Delta_d when `held`.
    fn gap(&self, at: &Contact, d: [f64; 2], held: bool) -> Result<Jet2, GeneratingError> {
        let (pair, motion) = (self.pair, self.motion);
        let s = pair.flank().sign();
        let (worm, work) = (&pair.worm, &pair.work);
        let ((sb_1, cb_1), cb_2) = (worm.base_helix_angle.sin_cos(), work.base_helix_angle.cos());
        let t_k = t_k(pair);
        let [g_1, g_2] = pair.generatrices();
        let at_d = |j: Jet2| Jet2 { f: j.f + j.fu * d[0] + j.fv * d[1], ..j };
        let (mu, nu) = (at_d(at.mu), at_d(at.nu));
        let q = at.feed - t_k * d[0] - d[1];
        let of_feed = |jet: [f64; 3]| Jet2::ridge(jet, -t_k, -1.0);
        let delta_d = of_feed(motion.delta_d.jet(q));
        let delta_phi = of_feed(motion.delta_phi_2.jet(q));
        let shift = of_feed(motion.shift.jet(q));
        let (sin_a1, cos_a1) = pair.operating_alpha_t1().sin_cos();
        // The foot on the worm for a work point that is held; `lift`: the part that the true Delta_d moves.
        let lift = if held { Jet2::default() } else { delta_d };
        let tau_z = lift * (cb_1 * s * sb_1 * sin_a1);
        let tau_w = lift * (worm.base_radius / at.w_1 * cos_a1) + tau_z * (s * sb_1 / cb_1);
        let w_c = affine(-cb_1 / cb_2, 0.0, -cb_1 / cb_2 * d[0]);
        let advance = Jet2::constant(motion.shift.value(at.feed)) + -shift;
        let z_c = w_c * (-s * sb_1 / cb_1) + advance;
        let z_t = (mu * g_1.dot(&pair.e_r2) + nu * g_1.dot(&g_2)) * -cb_1;
        let radial = mu * pair.e_r1.dot(&pair.e_r2) + nu * pair.e_r1.dot(&g_2);
        let w_t = radial * (-worm.base_radius / at.w_1) + z_t * (s * sb_1 / cb_1);
        let w = w_c + w_t + tau_w + Jet2::constant(at.w_1);
        let z = z_c + z_t + tau_z + Jet2::constant(at.z_1);
        let f_n1 = self.function.jet(w.f, z.f).ok_or(ContactError::WormSurfaceMissing { p: w.f, q: z.f })?;
        let lever = work.base_radius * cb_2;
        let moved = delta_d * pair.operating_alpha_n.sin() + delta_phi * (-s * lever);
        let shifted = Contact { mu, nu, ..*at };
        Ok(moved + shifted.curvature(pair, lift * cos_a1) + -f_n1.of(w, z))
    }

    /// f_n2 at the workpiece point (w_2, z_2) by minimising J over the displacement of the contact, mm.
    ///
    /// # Errors
    /// `ContactBelowBase`, `WormSurfaceMissing`; `EnvelopeBroken` where J has no minimum near the unmodified contact.
    pub fn value(&self, w_2: f64, z_2: f64) -> Result<f64, GeneratingError> {
        let at = self.contact(w_2, z_2)?;
        let plain = hessian(&at.curvature(self.pair, Jet2::default())).determinant();
        let mut d = Vector2::zeros();
        let broken =
            |ratio: f64| GeneratingError::EnvelopeBroken { flank: self.pair.flank(), ratio, limit: 0.0 };
        for _ in 0..STEPS {
            let j = self.gap(&at, d.into(), false)?;
            let h = hessian(&j);
            let ratio = h.determinant() / plain;
            let step = h.try_inverse().ok_or_else(|| broken(ratio))? * Vector2::new(j.fu, j.fv);
            d -= step;
            if step.norm() < CONVERGED {
                let j = self.gap(&at, d.into(), false)?;
                return if j.fuu > 0.0 && ratio > 0.0 { Ok(j.f) } else { Err(broken(ratio)) };
            }
        }
        Err(broken(0.0))
    }

    /// f_n2 to second order: m - (1/2) g^T R^-1 g with the slopes of m at a held work point, mm.
    ///
    /// # Errors
    /// `ContactBelowBase`, `WormSurfaceMissing`.
    pub fn second_order(&self, w_2: f64, z_2: f64) -> Result<f64, GeneratingError> {
        let at = self.contact(w_2, z_2)?;
        let j = self.gap(&at, [0.0; 2], true)?;
        let slope = Vector2::new(j.fu, j.fv);
        let inverse = hessian(&at.curvature(self.pair, Jet2::default())).try_inverse();
        Ok(inverse.map_or(f64::NEG_INFINITY, |r| j.f - 0.5 * slope.dot(&(r * slope))))
    }
}
