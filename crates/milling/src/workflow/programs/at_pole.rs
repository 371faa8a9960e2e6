//! What a job asks for near the pole (`docs/mathematics/milling.md#positions-of-five-axes`).

/// What is done near the pole. Angles in rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum AtPole {
    /// The geometry stays; within `cap` of the pole the feed is what the axes allow for that whole part.
    Slow {
        /// theta_cap.
        cap: f64,
    },
    /// Within `cap` of the pole the first rotary axis keeps its angle; for ball cutters only.
    Hold {
        /// theta_cap.
        cap: f64,
    },
    /// The workpiece is tilted by as little as keeps all paths `cap` away from the pole.
    Mount {
        /// theta_cap.
        cap: f64,
    },
}
