//! The direction along which a modification is constant, or a wave with varying amplitude.

use super::Modification;
use super::node::Node;

impl Modification {
    /// tan(rho) of the lines w sin(rho) + z cos(rho) = const on which this modification stands: reliefs across a direction and
    /// waves. `None` for functions of the profile alone, for sums and products, and for everything without such lines.
    pub fn line_direction(&self) -> Option<f64> {
        self.root.line_direction()
    }
}

impl Node {
    fn line_direction(&self) -> Option<f64> {
        match self {
            Node::Ridge { a, b, .. } if *b != 0.0 => Some(a / b),
            Node::Waviness(wave) if wave.wave[1] != 0.0 => Some(wave.wave[0] / wave.wave[1]),
            Node::Scale(_, child) => child.line_direction(),
            Node::MirrorZ(child) => child.line_direction().map(|t| -t),
            _ => None,
        }
    }
}
