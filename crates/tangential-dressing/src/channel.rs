//! The channels of the motion and of the dresser's profile, and the design variables that they carry
//! (`docs/mathematics/tangential-dressing.md#channels-and-variables`).
//!
//! A variable is a coefficient: of a power of the channel's own abscissa, or of a B-spline over it. mm; gA in rad. Knows no bodies.

use super::TangentialError;
use foundation::geometry::Flank;
use foundation::numerics::{BSpline, BSplineBasis};
use std::fmt;
use std::str::FromStr;
use std::sync::Arc;

/// What a design variable acts on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Channel {
    /// F_p: profile of the dresser in axial direction; > 0 thins the dresser. `None`: both sides alike.
    Profile(Option<Flank>),
    /// F_z: shift of the dresser perpendicular to the worm axis, over x_D.
    TangentialShift,
    /// dX: axial offset of the dresser, over x_D; the same as a worm turn of -dX/p.
    AxialOffset,
    /// dA: dressing centre distance, over x_D.
    DressingDistance,
    /// gA: dressing crossing angle, over x_D; rad.
    DressingAngle,
    /// gam: crossed-axes angle of grinding, over z: gamma_0 + c/(2 pi m_n).
    CrossedAxesAngle,
    /// dist: centre distance of grinding, over z: d_0 + c/tan(alpha_n).
    CentreDistance,
    /// F_C: extra turn of the workpiece, over z: c/r_p2.
    WorkTurn,
    /// F_T: tool shift, over z.
    ToolShift,
    /// kappa: tool shift per feed, mm/mm; it has no exponent.
    ShiftRatio,
}

/// Over what a channel runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Abscissa {
    /// u = s/m_n on the dresser's profile.
    Profile,
    /// zeta = 2 x_D/b_w along the worm.
    Worm,
    /// eta = 2 z/b_g along the gear.
    Gear,
}

impl Channel {
    /// All channels.
    pub const ALL: [Channel; 12] = [
        Channel::Profile(None),
        Channel::Profile(Some(Flank::Left)),
        Channel::Profile(Some(Flank::Right)),
        Channel::TangentialShift,
        Channel::AxialOffset,
        Channel::DressingDistance,
        Channel::DressingAngle,
        Channel::CrossedAxesAngle,
        Channel::CentreDistance,
        Channel::WorkTurn,
        Channel::ToolShift,
        Channel::ShiftRatio,
    ];

    /// As spec and files write it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Profile(None) => "Fp",
            Self::Profile(Some(Flank::Left)) => "FpL",
            Self::Profile(Some(Flank::Right)) => "FpR",
            Self::TangentialShift => "Fz",
            Self::AxialOffset => "dX",
            Self::DressingDistance => "dA",
            Self::DressingAngle => "gA",
            Self::CrossedAxesAngle => "gam",
            Self::CentreDistance => "dist",
            Self::WorkTurn => "FC",
            Self::ToolShift => "FT",
            Self::ShiftRatio => "kap",
        }
    }

    /// What moves, in words.
    pub fn meaning(self) -> &'static str {
        match self {
            Self::Profile(None) => "dresser profile, both sides",
            Self::Profile(Some(Flank::Left)) => "dresser profile for the left flank",
            Self::Profile(Some(Flank::Right)) => "dresser profile for the right flank",
            Self::TangentialShift => "tangential shift of the dresser",
            Self::AxialOffset => "axial offset of the dresser",
            Self::DressingDistance => "dressing centre distance",
            Self::DressingAngle => "dressing crossing angle",
            Self::CrossedAxesAngle => "crossed-axes angle of grinding",
            Self::CentreDistance => "centre distance of grinding",
            Self::WorkTurn => "extra turn of the workpiece",
            Self::ToolShift => "tool shift",
            Self::ShiftRatio => "tool shift per feed",
        }
    }

    /// The channel of a name.
    pub fn of_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|c| c.name() == name)
    }

    /// What it is a function of; the shift ratio is the slope of the tool shift.
    pub fn abscissa(self) -> Abscissa {
        match self {
            Self::Profile(_) => Abscissa::Profile,
            Self::TangentialShift | Self::AxialOffset | Self::DressingDistance | Self::DressingAngle => {
                Abscissa::Worm
            }
            Self::CrossedAxesAngle
            | Self::CentreDistance
            | Self::WorkTurn
            | Self::ToolShift
            | Self::ShiftRatio => Abscissa::Gear,
        }
    }

    /// Whether it acts on a flank.
    pub fn concerns(self, flank: Flank) -> bool {
        !matches!(self, Self::Profile(Some(own)) if own != flank)
    }

    /// Unit of its coefficients.
    pub fn unit(self) -> &'static str {
        match self {
            Self::DressingAngle => "rad",
            Self::ShiftRatio => "mm/mm",
            _ => "mm",
        }
    }
}

/// The function whose coefficient a variable is.
#[derive(Clone, Debug)]
pub enum Shape {
    /// The power of the abscissa.
    Power(u32),
    /// One function of a B-spline basis over the abscissa.
    Spline {
        /// All functions.
        basis: Arc<BSplineBasis>,
        /// Which of them.
        index: usize,
        /// The function itself.
        function: Arc<BSpline>,
    },
}

impl Shape {
    /// Value at an abscissa.
    pub fn value(&self, x: f64) -> f64 {
        match self {
            Self::Power(k) => x.powi(*k as i32),
            Self::Spline { function, .. } => function.value(x),
        }
    }
}

impl PartialEq for Shape {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Power(a), Self::Power(b)) => a == b,
            (Self::Spline { basis: a, index: i, .. }, Self::Spline { basis: b, index: j, .. }) => {
                i == j && a == b
            }
            _ => false,
        }
    }
}

/// A design variable: one coefficient of one channel.
#[derive(Clone, Debug, PartialEq)]
pub struct Variable {
    /// The channel.
    pub channel: Channel,
    /// The function it multiplies.
    pub shape: Shape,
}

/// Degree of the splines: their second derivative, which the curvature of the worm needs, is smooth as well.
const SPLINE_DEGREE: usize = 4;
/// Largest exponent: beyond it powers over the same range can no longer be distinguished.
pub const LARGEST_EXPONENT: u32 = 9;

impl Variable {
    /// The coefficient of a power.
    pub fn power(channel: Channel, exponent: u32) -> Self {
        Self { channel, shape: Shape::Power(exponent) }
    }

    /// The shift ratio.
    pub fn shift_ratio() -> Self {
        Self::power(Channel::ShiftRatio, 1)
    }

    /// All coefficients of a B-spline of degree 4 with `intervals` equal pieces over the abscissae `range` of a channel.
    ///
    /// # Errors
    /// [`TangentialError::InvalidNumber`] for no intervals, an empty range or the shift ratio, which is a number.
    pub fn spline(channel: Channel, intervals: usize, range: [f64; 2]) -> Result<Vec<Self>, TangentialError> {
        let refused = |field, value, allowed| TangentialError::InvalidNumber { field, value, allowed };
        if channel == Channel::ShiftRatio {
            return Err(refused(
                "splines.channel kap",
                1.0,
                "a channel that is a function; FT holds the shift",
            ));
        }
        let basis = BSplineBasis::uniform(range, intervals, SPLINE_DEGREE, &[]).map_err(|_| {
            refused("splines.intervals", intervals as f64, "at least 1 on a range with a length")
        })?;
        let basis = Arc::new(basis);
        let one = |index: usize| {
            let coefficients = (0..basis.count()).map(|j| f64::from(u8::from(j == index))).collect();
            let function = BSpline::new((*basis).clone(), coefficients)
                .map_err(|_| refused("splines.intervals", intervals as f64, "fewer intervals"))?;
            let shape = Shape::Spline { basis: basis.clone(), index, function: Arc::new(function) };
            Ok(Self { channel, shape })
        };
        (0..basis.count()).map(one).collect()
    }
}

impl fmt::Display for Variable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.shape {
            Shape::Power(_) if self.channel == Channel::ShiftRatio => f.write_str(self.channel.name()),
            Shape::Power(k) => write!(f, "{}{k}", self.channel.name()),
            Shape::Spline { basis, index, .. } => {
                write!(f, "{}[{}/{}]", self.channel.name(), index + 1, basis.count())
            }
        }
    }
}

impl FromStr for Variable {
    type Err = TangentialError;

    /// A name such as `Fp1`, `FpL2`, `dX2` or `kap`.
    fn from_str(name: &str) -> Result<Self, TangentialError> {
        let unknown = || TangentialError::UnknownVariable { name: name.to_owned() };
        if name == Channel::ShiftRatio.name() {
            return Ok(Self::shift_ratio());
        }
        let digits = name.find(|c: char| c.is_ascii_digit()).ok_or_else(unknown)?;
        let channel = Channel::of_name(&name[..digits]).ok_or_else(unknown)?;
        let exponent: u32 = name[digits..].parse().map_err(|_| unknown())?;
        let written = exponent.to_string() == name[digits..];
        if !written || channel == Channel::ShiftRatio || exponent > LARGEST_EXPONENT {
            return Err(unknown());
        }
        Ok(Self::power(channel, exponent))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_and_variables_belong_together() {
        for name in ["Fp1", "FpL2", "FpR9", "Fz3", "dX0", "dA2", "gA1", "gam0", "dist3", "FC4", "FT0", "kap"]
        {
            assert_eq!(name.parse::<Variable>().unwrap().to_string(), name);
        }
        for name in ["", "Fp", "Fp01", "Fp10", "kap1", "dx2", "FC-1", "F2", "2", "Fp1 "] {
            let error = name.parse::<Variable>().unwrap_err();
            assert_eq!((error.code(), error.is_bad_input()), ("unknown-variable", true), "{name}");
        }
    }

    #[test]
    fn spline_functions_add_up_to_one() {
        let functions = Variable::spline(Channel::AxialOffset, 6, [-1.4, 1.4]).unwrap();
        assert_eq!(functions.len(), 10);
        for x in [-1.3, 0.0, 0.77] {
            let sum: f64 = functions.iter().map(|v| v.shape.value(x)).sum();
            assert!((sum - 1.0).abs() < 1e-14);
        }
        assert_eq!(functions[2].to_string(), "dX[3/10]");
        assert!(Variable::spline(Channel::ShiftRatio, 6, [-1.0, 1.0]).is_err());
        assert!(Variable::spline(Channel::AxialOffset, 0, [-1.0, 1.0]).is_err());
        assert!(Variable::spline(Channel::AxialOffset, 3, [1.0, 1.0]).is_err());
    }
}
