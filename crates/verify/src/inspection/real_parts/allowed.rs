//! The tolerances that a measured part states for itself, and what follows from them for other units.

use super::super::super::expected::Expected;
use super::super::super::given::Checked;
use super::super::super::ledger::Ledger;

/// Allowed differences of one part. What the file does not state is NaN, which nothing passes.
pub(super) struct Allowed {
    /// Of evaluated deviations, um.
    pub um: f64,
    /// Of an evaluated deviation from the one that the machine printed, um.
    pub printed_um: f64,
    /// Of the measure over balls that the span means from the one that the machine printed, mm.
    pub over_balls_mm: f64,
}

impl Allowed {
    /// Takes the table `tolerance` of a part, quantity by quantity.
    ///
    /// # Errors
    /// The part states none.
    pub fn take(expected: &mut Expected<'_>, ledger: &mut Ledger) -> Checked<Self> {
        let mut table = expected.object("tolerance", ledger).ok_or("tolerance is missing")?;
        let mut of = |key: &str| table.given_optional(key, ledger).unwrap_or(f64::NAN);
        let allowed = Self { um: of("um"), printed_um: of("printed_um"), over_balls_mm: of("MdK_mm") };
        table.finish(ledger);
        Ok(allowed)
    }

    /// Of evaluated lengths, mm.
    pub fn mm(&self) -> f64 {
        self.um * 1e-3
    }

    /// Of the direction of something of this size, mm, in degree: a sideways step of the allowed deviation turns it by so much.
    pub fn direction_deg(&self, size: f64) -> f64 {
        (self.mm() / size).to_degrees()
    }
}
