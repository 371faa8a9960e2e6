//! Why a cutter cannot touch a flank as wanted.

/// Why a cutter cannot touch as wanted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TouchFault {
    /// The contact height is outside the straight side. mm.
    Height {
        /// Wanted.
        height: f64,
        /// Where the straight side begins and ends.
        allowed: [f64; 2],
    },
    /// The axis leans so that the upper edge would cut: angle between side and tangent plane, rad.
    UpperEdge {
        /// Its angle, > 0.
        angle: f64,
    },
    /// The cutter has a sharp corner where a rounded one would have to touch.
    SharpCorner,
    /// The contact lies outside the arc of the barrel: height above the tip and its limits, mm.
    Arc {
        /// Wanted.
        height: f64,
        /// Where the arc begins and ends.
        allowed: [f64; 2],
    },
}

impl std::fmt::Display for TouchFault {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        match self {
            Self::Height { height, allowed: [from, to] } => {
                write!(f, "height {height} mm, the straight side goes from {from:.4} to {to:.4} mm")
            }
            Self::UpperEdge { angle } => {
                write!(
                    f,
                    "its upper edge would cut, the side leans {:.6} deg into the flank",
                    angle.to_degrees()
                )
            }
            Self::SharpCorner => f.write_str("a sharp corner would have to touch"),
            Self::Arc { height, allowed: [from, to] } => {
                write!(f, "height {height:.4} mm, the arc goes from {from:.4} to {to:.4} mm")
            }
        }
    }
}
