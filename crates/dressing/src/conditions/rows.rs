//! Conditions on a dressing correction: what one of them asks, residual and gradient (`docs/mathematics/dressing.md#conditions`). Knows no
//! solver.

use crate::forward::head_gradient;
use crate::{DressedProfile, DresserTool, DressingError, FlankDresser, ProfilePoint};
use foundation::geometry::Flank;
use foundation::kinematics::DressingCorrection;
use foundation::numerics::{brent, value_of};

/// One row: what the dressed worm must fulfil.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Condition {
    /// Pitch point: modification f (mm) at length of roll w (mm).
    Point {
        /// Flank.
        flank: Flank,
        /// Length of roll, mm.
        w: f64,
        /// Wanted f_n, mm.
        f: f64,
    },
    /// Radius map: dresser parameter t dresses length of roll w.
    Map {
        /// Flank.
        flank: Flank,
        /// Dresser parameter, mm.
        t: f64,
        /// Length of roll, mm.
        w: f64,
    },
    /// Head height: the head profile at t_H dresses radius r.
    Head {
        /// Parameter of the head profile, mm.
        t: f64,
        /// Radius, mm.
        r: f64,
    },
    /// Missing degree of freedom: correction j (0..3) is fixed.
    Fixed {
        /// Component of DK.
        j: usize,
        /// Its value, rad or mm.
        x: f64,
    },
}

impl Condition {
    /// The radius map as radii: the dresser's circle of radius `dresser_radius` dresses the worm at `worm_radius`, mm.
    ///
    /// # Errors
    /// [`DressingError::InvalidNumber`] for a radius that the dresser's profile or the worm flank does not have.
    pub fn map_of_radii(
        dresser: &FlankDresser,
        dresser_radius: f64,
        worm_radius: f64,
    ) -> Result<Self, DressingError> {
        let (from, to) = dresser.profile.interval();
        let beyond = |t: f64| value_of(dresser.profile.at(t).r) - dresser_radius;
        let t = brent([from, to], [beyond(from), beyond(to)], 1e-13, |t| Some(beyond(t)));
        let w = dresser.worm.length_of_roll(worm_radius).ok().filter(|w| w.is_finite());
        let invalid = |field, value, allowed| DressingError::InvalidNumber { field, value, allowed };
        Ok(Self::Map {
            flank: dresser.worm.flank,
            t: t.ok_or(invalid("dresser radius", dresser_radius, "a radius of the dresser's profile"))?,
            w: w.ok_or(invalid("worm radius", worm_radius, "at least the worm's base radius"))?,
        })
    }

    /// The flank that the row stands on.
    pub fn flank(&self) -> Option<Flank> {
        match *self {
            Self::Point { flank, .. } | Self::Map { flank, .. } => Some(flank),
            Self::Head { .. } | Self::Fixed { .. } => None,
        }
    }

    /// # Errors
    /// Those of each row; [`DressingError::TwoFlanksOfCone`] for rows on both flanks of a conical worm.
    pub(crate) fn check_all<'c>(
        rows: impl Iterator<Item = &'c Self> + Clone,
        tool: &DresserTool,
    ) -> Result<(), DressingError> {
        let on = |flank: Flank| rows.clone().any(|row| row.flank() == Some(flank));
        if on(Flank::Left) && on(Flank::Right) && tool.flanks.left.chain != tool.flanks.right.chain {
            return Err(DressingError::TwoFlanksOfCone);
        }
        rows.clone().try_for_each(Self::check)
    }

    /// # Errors
    /// [`DressingError::InvalidNumber`] for a number that is not finite and a component that does not exist.
    fn check(&self) -> Result<(), DressingError> {
        let numbers = match *self {
            Self::Point { w, f, .. } => [("length of roll of a pitch point", w), ("wanted modification", f)],
            Self::Map { t, w, .. } => {
                [("dresser parameter of a radius map", t), ("length of roll of a radius map", w)]
            }
            Self::Head { t, r } => [("parameter of the head profile", t), ("head radius", r)],
            Self::Fixed { j, x } => {
                if j > 3 {
                    let (field, allowed) = ("component of a fixed correction", "0 to 3");
                    return Err(DressingError::InvalidNumber { field, value: j as f64, allowed });
                }
                [("fixed correction", x), ("fixed correction", x)]
            }
        };
        match numbers.into_iter().find(|(_, x)| !x.is_finite()) {
            Some((field, value)) => {
                Err(DressingError::InvalidNumber { field, value, allowed: "finite numbers" })
            }
            None => Ok(()),
        }
    }

    /// What the row is to be, in the unit of [`Made::value`].
    pub(crate) fn wanted(&self) -> f64 {
        match *self {
            Self::Point { f, .. } => f,
            Self::Map { w, .. } => w,
            Self::Head { r, .. } => r,
            Self::Fixed { x, .. } => x,
        }
    }

    /// Whether two rows ask for the same thing, perhaps with other wanted values.
    pub(crate) fn asks_as(&self, other: &Self) -> bool {
        match (*self, *other) {
            (Self::Point { flank, w, .. }, Self::Point { flank: its, w: roll, .. }) => {
                (flank, w) == (its, roll)
            }
            (Self::Map { flank, t, .. }, Self::Map { flank: its, t: parameter, .. }) => {
                (flank, t) == (its, parameter)
            }
            (Self::Head { t, .. }, Self::Head { t: parameter, .. }) => t == parameter,
            (Self::Fixed { j, .. }, Self::Fixed { j: component, .. }) => j == component,
            _ => false,
        }
    }

    /// Residual and gradient at DK, as [`Condition::made`] has them.
    ///
    /// # Errors
    /// Those of the forward calculation.
    pub(crate) fn row(
        &self,
        tool: &DresserTool,
        dk: &DressingCorrection,
        hint: &mut f64,
    ) -> Result<(f64, [f64; 4]), DressingError> {
        let made = self.made(tool, dk, hint)?;
        Ok((made.value - self.wanted(), made.gradient))
    }

    /// What the row comes to at DK. `hint` holds the profile parameter of a pitch point: that of a correction nearby, or NaN.
    ///
    /// # Errors
    /// Those of the forward calculation.
    pub(crate) fn made(
        &self,
        tool: &DresserTool,
        dk: &DressingCorrection,
        hint: &mut f64,
    ) -> Result<Made, DressingError> {
        let of = |(value, gradient)| Made { value, gradient, b: None };
        match *self {
            Self::Point { flank, w, .. } => {
                let at = near(&DressedProfile::new(tool, flank, *dk), w, hint)?;
                Ok(Made { value: at.f, gradient: at.df_dk, b: Some(at.b) })
            }
            Self::Map { flank, t, .. } => DressedProfile::new(tool, flank, *dk).map_gradient(t).map(of),
            Self::Head { t, .. } => head_gradient(tool, t, dk).map(of),
            Self::Fixed { j, .. } => {
                let mut gradient = [0.0; 4];
                gradient[j] = 1.0;
                Ok(of((dk[j], gradient)))
            }
        }
    }
}

/// What a row comes to.
pub(crate) struct Made {
    /// f_n, length of roll or radius, mm; a component of DK, rad or mm.
    pub value: f64,
    /// Its gradient, columns phi_S, gamma, d, v_y.
    pub gradient: [f64; 4],
    /// Of a pitch point: worm z of the contact at v_zS = 0, mm.
    pub b: Option<f64>,
}

/// The profile point at w from the parameter found last, or from afar where that leads nowhere.
fn near(profile: &DressedProfile<'_>, w: f64, hint: &mut f64) -> Result<ProfilePoint, DressingError> {
    let at = if hint.is_finite() { profile.at_roll_near(w, *hint).ok() } else { None };
    let at = at.map_or_else(|| profile.at_roll(w), Ok)?;
    *hint = at.t;
    Ok(at)
}
