//! The functions of a decomposition as B-splines, without the coordinates they depend on.

use super::Arguments;
use foundation::numerics::{BSpline, Jet2};

/// u = (w - middle)/half, -1 .. 1 over the samples.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RollScale {
    /// mm.
    pub middle: f64,
    /// mm; never 0.
    pub half: f64,
}

impl RollScale {
    pub(super) fn new([low, high]: [f64; 2]) -> Self {
        let half = 0.5 * (high - low);
        // Samples of a single w: u = 0 everywhere, F_L and F_Q stay undetermined and come out as 0.
        Self { middle: 0.5 * (low + high), half: if half > 0.0 { half } else { 1.0 } }
    }

    /// u of a length of roll.
    #[inline]
    pub fn u(&self, w: f64) -> f64 {
        (w - self.middle) / self.half
    }
}

/// F_C, F_L, F_Q, F_P, F_K; those outside the class are absent. Values mm, arguments mm.
#[derive(Clone, Debug, PartialEq)]
pub struct WormFunctions {
    /// F_C(X).
    pub constant: Option<BSpline>,
    /// F_L(X), factor u.
    pub linear: Option<BSpline>,
    /// F_Q(X), factor u^2.
    pub quadratic: Option<BSpline>,
    /// F_P(profile argument).
    pub profile: Option<BSpline>,
    /// F_K(X_K).
    pub kinematic: Option<BSpline>,
    /// u of w.
    pub scale: RollScale,
}

fn value(function: &Option<BSpline>, x: f64) -> f64 {
    function.as_ref().map_or(0.0, |f| f.value(x))
}

fn jet(function: &Option<BSpline>, x: f64) -> [f64; 3] {
    function.as_ref().map_or([0.0; 3], |f| f.jet(x))
}

/// h(argument(w, z)) from h, h', h''.
pub(super) fn along([f, fu, fuu]: [f64; 3], argument: Jet2) -> Jet2 {
    Jet2 { f, fu, fuu, ..Jet2::default() }.of(argument, Jet2::default())
}

impl WormFunctions {
    pub(super) fn none(scale: RollScale) -> Self {
        Self { constant: None, linear: None, quadratic: None, profile: None, kinematic: None, scale }
    }

    /// The sum at length of roll `w` and the arguments of that point.
    pub fn value(&self, w: f64, at: &Arguments) -> f64 {
        let u = self.scale.u(w);
        value(&self.constant, at.x)
            + u * (value(&self.linear, at.x) + u * value(&self.quadratic, at.x))
            + value(&self.profile, at.profile)
            + value(&self.kinematic, at.path)
    }

    /// F_C + F_L u + F_Q u^2 in (w, z) for X with its derivatives: what the dressing motion carries.
    pub fn dressing_jet(&self, w: f64, x: Jet2) -> Jet2 {
        let u = Jet2 { f: self.scale.u(w), fu: 1.0 / self.scale.half, ..Jet2::default() };
        let of = |function| along(jet(function, x.f), x);
        of(&self.constant) + u * (of(&self.linear) + u * of(&self.quadratic))
    }

    /// F_P with two derivatives in its argument.
    pub fn profile_jet(&self, argument: f64) -> [f64; 3] {
        jet(&self.profile, argument)
    }

    /// F_K with two derivatives in X_K.
    pub fn kinematic_jet(&self, path: f64) -> [f64; 3] {
        jet(&self.kinematic, path)
    }
}
