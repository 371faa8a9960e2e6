//! Limits of characteristics by the class of ISO 1328-1 that a part has to reach. Values in um.

use flankwright::metrology::inspection::{InspectionError, ToleranceQuantity, Tolerances};

/// Lower and upper limit.
pub(super) type Limits = [Option<f64>; 2];

/// Tolerances of a class for the symbols of the standard.
#[derive(Clone, Debug, Default)]
pub(super) struct ClassLimits(Vec<(&'static str, Limits)>);

impl ClassLimits {
    /// Of a gear.
    ///
    /// # Errors
    /// A class outside the standard.
    pub fn new(tolerances: &Tolerances, class: i32) -> Result<Self, InspectionError> {
        let verified = ToleranceQuantity::ALL.into_iter().filter(|quantity| !quantity.is_informative());
        let limits = verified.map(|quantity| {
            let upper = 1e3 * tolerances.rounded(quantity, class)?;
            // Slopes have a sign; everything else is a range or a largest amount.
            let slope = matches!(quantity, ToleranceQuantity::ProfileSlope | ToleranceQuantity::HelixSlope);
            Ok((quantity.symbol(), [slope.then_some(-upper), Some(upper)]))
        });
        limits.collect::<Result<_, _>>().map(Self)
    }

    /// Limits of a symbol; none where the standard has none.
    pub fn of(&self, symbol: &str) -> Limits {
        self.0.iter().find(|(known, _)| *known == symbol).map_or([None; 2], |(_, limits)| *limits)
    }
}
