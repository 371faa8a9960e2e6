//! The ease-off of three amounts: crowning along the tooth, along the profile, and bias; `docs/mathematics/milling.md#flanks-as-patches`.

use super::bounds::largest;
use super::{NormalOffset, OffsetBounds};
use crate::geometry::{BevelGear, GeometryError};
use crate::numerics::Jet2;

/// Amounts of an ease-off at the borders of the flank, mm; positive = material removed.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct EaseOffAmounts {
    /// C_beta: at both ends of the face width.
    pub length_crowning: f64,
    /// C_alpha: at root and tip.
    pub profile_crowning: f64,
    /// C_bias: at two corners, its opposite at the others.
    pub bias: f64,
}

/// f = -C_beta X^2 - C_alpha Y^2 - C_bias X Y over a flank whose borders lie at X = +-1 along and Y = +-1 across it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EaseOff {
    amounts: EaseOffAmounts,
    middle: [f64; 2],
    half: [f64; 2],
}

impl EaseOff {
    /// Over a box of heights (root, tip) and lengths.
    ///
    /// # Errors
    /// [`GeometryError::InvalidNumber`] for numbers that are not finite and a box without extent.
    pub fn new(amounts: EaseOffAmounts, heights: [f64; 2], lengths: [f64; 2]) -> Result<Self, GeometryError> {
        let number = |field, value: f64, good: bool, allowed| {
            if good { Ok(()) } else { Err(GeometryError::InvalidNumber { field, value, allowed }) }
        };
        for (field, value) in [
            ("length_crowning", amounts.length_crowning),
            ("profile_crowning", amounts.profile_crowning),
            ("bias", amounts.bias),
        ] {
            number(field, value, value.is_finite(), "a finite length")?;
        }
        let middle = [heights, lengths].map(|[from, to]| (from + to) / 2.0);
        let half = [heights, lengths].map(|[from, to]| (to - from) / 2.0);
        for (field, value) in [("height of the flank", half[0]), ("length of the flank", half[1])] {
            number(field, 2.0 * value, value.is_finite() && value != 0.0, "finite and not 0")?;
        }
        Ok(Self { amounts, middle, half })
    }

    /// Over the flank of a bevel gear, from its form cone to its tip cone and over its face width.
    ///
    /// # Errors
    /// [`GeometryError::InvalidNumber`] for amounts that are not finite.
    pub fn of_bevel(amounts: EaseOffAmounts, gear: &BevelGear) -> Result<Self, GeometryError> {
        Self::new(amounts, gear.heights(), gear.face())
    }

    fn place(&self, height: f64, length: f64) -> [f64; 2] {
        [(length - self.middle[1]) / self.half[1], (height - self.middle[0]) / self.half[0]]
    }
}

impl NormalOffset for EaseOff {
    fn jet(&self, height: f64, length: f64) -> Jet2 {
        let EaseOffAmounts { length_crowning: along, profile_crowning: across, bias } = self.amounts;
        let [x, y] = self.place(height, length);
        let [h_a, h_b] = self.half;
        Jet2 {
            f: -along * x * x - across * y * y - bias * x * y,
            fu: (-2.0 * across * y - bias * x) / h_a,
            fv: (-2.0 * along * x - bias * y) / h_b,
            fuu: -2.0 * across / (h_a * h_a),
            fuv: -bias / (h_a * h_b),
            fvv: -2.0 * along / (h_b * h_b),
        }
    }

    /// The gradient is linear, so that its bounds are exact; the second derivatives are the same everywhere.
    fn bounds(&self, heights: [f64; 2], lengths: [f64; 2]) -> OffsetBounds {
        let EaseOffAmounts { length_crowning: along, profile_crowning: across, bias } = self.amounts;
        let mut bounds = OffsetBounds { value: 0.0, by_height: 0.0, by_length: 0.0, second: [0.0; 3] };
        let (mut far_x, mut far_y) = ([0.0; 2], [0.0; 2]);
        for i in 0..2 {
            for j in 0..2 {
                let jet = self.jet(heights[i], lengths[j]);
                bounds.by_height = bounds.by_height.max(jet.fu.abs());
                bounds.by_length = bounds.by_length.max(jet.fv.abs());
                bounds.second = [jet.fuu, jet.fuv, jet.fvv].map(f64::abs);
                [far_x[j], far_y[i]] = self.place(heights[i], lengths[j]);
            }
        }
        let (x, y) = (largest(far_x), largest(far_y));
        bounds.value = along.abs() * x * x + across.abs() * y * y + bias.abs() * x * y;
        bounds
    }
}
