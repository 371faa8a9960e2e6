//! What closes the system of a machine that has more axes than a pose determines (`docs/mathematics/programs.md#from-bodies-to-axes`).

/// The rule of dressing: the dresser is a body of revolution, so a machine with a swivel has six axes for five demands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DressingRule {
    /// The swivel is given, rad: two solutions, one where they coincide.
    Swivel(f64),
    /// The worm's axis is given, rad: one solution.
    WormAngle(f64),
    /// The axial slide is given, mm.
    AxialSlide(f64),
}

impl DressingRule {
    pub(super) fn value(self) -> f64 {
        match self {
            Self::Swivel(x) | Self::WormAngle(x) | Self::AxialSlide(x) => x,
        }
    }
}
