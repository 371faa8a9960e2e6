//! What a case of milling is made of.

use super::super::given::Checked;
use foundation::geometry::{BevelGear, Flank, Helicoid};

/// What a case is made of.
pub(super) enum Body {
    /// A cylindrical gear: its flank, both flanks.
    Cylinder {
        /// The flank of the case.
        helicoid: Helicoid,
        /// r_a and r_f, mm.
        radii: [f64; 2],
    },
    /// A bevel gear.
    Bevel(BevelGear),
    /// A blade.
    Blade,
}

/// The flank of that name.
pub(super) fn side(name: &str) -> Checked<Flank> {
    let found = Flank::BOTH.into_iter().find(|flank| flank.name() == name);
    found.ok_or_else(|| format!("flank: left or right is needed here, not {name:?}").into())
}
