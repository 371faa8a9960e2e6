//! What a job wants of the root of the gear: data of the bodies, below all that grinds it.

/// What is wanted of the root. mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GearRootChoice {
    /// Radius of the edge between flank and tip of the worm.
    pub corner_radius: f64,
    /// The root is a cylinder even where the centre distance changes; else the worm's tip is one.
    pub constant: bool,
    /// Least radius of curvature that the fillet must have.
    pub least_fillet_radius: Option<f64>,
}
