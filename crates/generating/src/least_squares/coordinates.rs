//! The arguments of the worm functions at a point of the flank: X of the dressed lines, the argument of the profile and X_K
//! of the contact paths. Constant and variable ratios, cylindrical and conical bodies differ in nothing else here.

use super::super::GeneratingError;
use foundation::numerics::Jet2;

/// Arguments of the worm functions at one point, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arguments {
    /// X: argument of F_C, F_L, F_Q.
    pub x: f64,
    /// Argument of F_P: w, or the rack height w + m z of conical bodies.
    pub profile: f64,
    /// X_K: argument of F_K.
    pub path: f64,
}

/// Coordinates on one flank, with derivatives. A closure (w, z) -> [X, profile, X_K] is one.
pub trait FlankCoordinates {
    /// [X, profile argument, X_K] at (w, z), with derivatives in w and z; mm.
    fn jets(&self, w: f64, z: f64) -> [Jet2; 3];

    /// The values alone.
    fn arguments(&self, w: f64, z: f64) -> Arguments {
        let [x, profile, path] = self.jets(w, z);
        Arguments { x: x.f, profile: profile.f, path: path.f }
    }

    /// How the other arguments follow from X and w where all are straight: `None` for curved lines. The gauge needs it.
    fn straight(&self) -> Option<StraightRelations> {
        None
    }
}

/// X_K = path[0] X + path[1] w and profile argument = profile[0] X + profile[1] w.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StraightRelations {
    /// Shares of X and w in X_K.
    pub path: [f64; 2],
    /// Shares of X and w in the argument of the profile.
    pub profile: [f64; 2],
}

impl<F: Fn(f64, f64) -> [Jet2; 3]> FlankCoordinates for F {
    fn jets(&self, w: f64, z: f64) -> [Jet2; 3] {
        self(w, z)
    }
}

/// Constant diagonal ratio: X = c (t w + z), X_K = c_K (t_K w + z), profile argument w + m z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DiagonalCoordinates {
    t: f64,
    t_k: f64,
    rack_slope: f64,
}

/// Directions closer than this count as one: |t_2 - t_K| (`docs/mathematics/generating-contact.md#contact-path-lines-and-the-diagonal-ratio`).
const SAME_DIRECTION: f64 = 1e-6;

impl DiagonalCoordinates {
    /// Directions t = tan(rho_2) of the dressed lines and t_K of the contact paths on the workpiece; `rack_slope` is the m of
    /// the profile argument w + m z (0 for cylindrical bodies).
    ///
    /// # Errors
    /// `DirectionAlongPath` if the directions agree within 1e-6 or are no numbers (diagonal ratio 0).
    pub fn new(t: f64, t_k: f64, rack_slope: f64) -> Result<Self, GeneratingError> {
        let apart = (t - t_k).abs();
        if !(apart.is_finite() && apart >= SAME_DIRECTION && rack_slope.is_finite()) {
            return Err(GeneratingError::DirectionAlongPath { t, t_k });
        }
        Ok(Self { t, t_k, rack_slope })
    }

    /// For the class {P, K} of the radial method: nothing depends on X, its direction is the face direction.
    ///
    /// # Errors
    /// `DirectionAlongPath` if t_K is no number.
    pub fn radial(t_k: f64, rack_slope: f64) -> Result<Self, GeneratingError> {
        // Any direction that is not the path's.
        Self::new(t_k + 1.0, t_k, rack_slope)
    }

    /// tan(rho_2).
    pub fn t(&self) -> f64 {
        self.t
    }

    /// t_K.
    pub fn t_k(&self) -> f64 {
        self.t_k
    }
}

fn cosine(t: f64) -> f64 {
    1.0 / t.hypot(1.0)
}

impl FlankCoordinates for DiagonalCoordinates {
    fn jets(&self, w: f64, z: f64) -> [Jet2; 3] {
        let at = self.arguments(w, z);
        let (c, c_k) = (cosine(self.t), cosine(self.t_k));
        let line = |f: f64, fu: f64, fv: f64| Jet2 { f, fu, fv, ..Jet2::default() };
        [
            line(at.x, c * self.t, c),
            line(at.profile, 1.0, self.rack_slope),
            line(at.path, c_k * self.t_k, c_k),
        ]
    }

    #[inline]
    fn arguments(&self, w: f64, z: f64) -> Arguments {
        Arguments {
            x: cosine(self.t) * (self.t * w + z),
            profile: w + self.rack_slope * z,
            path: cosine(self.t_k) * (self.t_k * w + z),
        }
    }

    fn straight(&self) -> Option<StraightRelations> {
        // z = X/c - t w.
        let (c, c_k, m) = (cosine(self.t), cosine(self.t_k), self.rack_slope);
        Some(StraightRelations {
            path: [c_k / c, c_k * (self.t_k - self.t)],
            profile: [m / c, 1.0 - m * self.t],
        })
    }
}
