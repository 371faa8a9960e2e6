//! How slopes are counted: the sign that a sheet prints and the length that a slope refers to (`docs/mathematics/inspection.md`).
//!
//! Inside, every deviation is positive where material stands and every slope is positive where material rises along the abscissa.

use foundation::geometry::{Flank, Sides};

/// What a printed helix slope counts as positive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SlopeSign {
    /// Material rises towards +z (profile: towards the tip), on both flanks.
    Material,
    /// The flank turns right-handed, from whichever end one looks: opposite senses of material on the two flanks.
    Din,
    /// Signs as the measuring machine or the user states them.
    Custom(Sides<Sign>),
}

/// A sign.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sign {
    /// +1
    Plus,
    /// -1
    Minus,
}

/// What a slope refers to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SlopeReference {
    /// The face width, mm, whatever range was evaluated.
    FaceWidth(f64),
    /// The evaluation range.
    Range,
    /// Another length that the drawing names, mm.
    Given(f64),
}

/// How the slopes of a trace are counted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlopeRule {
    /// Flank of the trace.
    pub flank: Flank,
    /// Printed sign.
    pub sign: SlopeSign,
    /// Reference length.
    pub reference: SlopeReference,
}

/// A slope deviation with all that its number depends on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slope {
    /// Rise of material along the abscissa per length, mm/mm.
    pub gradient: f64,
    /// Reference length L_ref, mm.
    pub length: f64,
    /// How it is counted.
    pub rule: SlopeRule,
}

impl Sign {
    /// +1 or -1.
    pub fn factor(self) -> f64 {
        match self {
            Self::Plus => 1.0,
            Self::Minus => -1.0,
        }
    }
}

impl SlopeSign {
    /// sigma_F: printed slope over slope of material.
    pub fn sigma(self, flank: Flank) -> f64 {
        match self {
            Self::Material => 1.0,
            Self::Din => flank.sign(),
            Self::Custom(signs) => signs[flank].factor(),
        }
    }

    /// Stable name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Material => "material",
            Self::Din => "din",
            Self::Custom(_) => "custom",
        }
    }
}

impl SlopeRule {
    /// Profiles: material rising to the tip is positive on both flanks, per evaluation range.
    pub fn profile(flank: Flank) -> Self {
        Self { flank, sign: SlopeSign::Material, reference: SlopeReference::Range }
    }

    /// A slope counted so; `range` is the length of the evaluation range, mm.
    pub fn slope(self, gradient: f64, range: f64) -> Slope {
        let length = match self.reference {
            SlopeReference::FaceWidth(length) | SlopeReference::Given(length) => length,
            SlopeReference::Range => range,
        };
        Slope { gradient, length, rule: self }
    }
}

impl Slope {
    /// f_H of material, mm per reference length.
    pub fn material(&self) -> f64 {
        self.gradient * self.length
    }

    /// f_H as a sheet prints it, mm per reference length.
    pub fn printed(&self) -> f64 {
        self.rule.sign.sigma(self.rule.flank) * self.material()
    }

    /// f_H of material over another length, mm.
    pub fn over(&self, length: f64) -> f64 {
        self.gradient * length
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_material_slope_is_printed_in_every_way() {
        let custom = SlopeSign::Custom(Sides { left: Sign::Minus, right: Sign::Plus });
        for (sign, left, right) in
            [(SlopeSign::Material, 4.0, 4.0), (SlopeSign::Din, 4.0, -4.0), (custom, -4.0, 4.0)]
        {
            for (flank, want) in [(Flank::Left, left), (Flank::Right, right)] {
                let slope =
                    SlopeRule { flank, sign, reference: SlopeReference::FaceWidth(20.0) }.slope(0.2, 18.0);
                assert_eq!(
                    (slope.material(), slope.printed(), slope.over(10.0)),
                    (4.0, want, 2.0),
                    "{sign:?}"
                );
            }
        }
        assert_eq!(SlopeRule::profile(Flank::Right).slope(0.5, 3.0).printed(), 1.5);
    }
}
