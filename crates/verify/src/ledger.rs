//! The book of comparisons: how many, which failed, how close the closest came to its tolerance.

use serde::Serialize;
use serde_json::Value;

/// A comparison that failed.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Failure {
    /// Case of the file.
    pub case: String,
    /// Quantity with its path inside the case.
    pub quantity: String,
    /// What the file says.
    pub expected: Value,
    /// What the library computes; a text when it could not.
    pub actual: Value,
    /// actual - expected (for angles: after whole periods are taken off), in the unit of the quantity.
    pub difference: Option<f64>,
    /// Allowed size of the difference.
    pub tolerance: Option<f64>,
}

/// A case left out because something outside the file is absent.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct NotRun {
    /// Case of the file.
    pub case: String,
    /// Why.
    pub reason: String,
}

/// The comparison that came closest to (or furthest over) its tolerance.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Worst {
    /// Case of the file.
    pub case: String,
    /// Quantity with its path inside the case.
    pub quantity: String,
    /// abs(difference)/tolerance.
    pub share_of_tolerance: f64,
}

/// Collects comparisons.
#[derive(Clone, Debug, Default)]
pub(super) struct Ledger {
    pub checks: usize,
    pub failures: Vec<Failure>,
    pub not_run: Vec<NotRun>,
    pub worst: Option<Worst>,
}

impl Ledger {
    /// Compares two numbers. A NaN anywhere fails.
    pub fn number(&mut self, case: &str, quantity: &str, expected: f64, actual: f64, tolerance: f64) {
        self.difference(case, quantity, expected, actual, actual - expected, tolerance);
    }

    /// Compares two numbers modulo a period.
    pub fn periodic(
        &mut self,
        (case, quantity): (&str, &str),
        expected: f64,
        actual: f64,
        period: f64,
        tolerance: f64,
    ) {
        let apart = actual - expected;
        let apart = apart - period * (apart / period).round();
        self.difference(case, quantity, expected, actual, apart, tolerance);
    }

    /// Compares a number that is the better the smaller it is.
    pub fn at_most(&mut self, case: &str, quantity: &str, expected: f64, actual: f64, tolerance: f64) {
        let excess = actual - expected;
        // A NaN is no improvement.
        let excess = if excess < 0.0 { 0.0 } else { excess };
        self.difference(case, quantity, expected, actual, excess, tolerance);
    }

    fn difference(
        &mut self,
        case: &str,
        quantity: &str,
        expected: f64,
        actual: f64,
        apart: f64,
        tolerance: f64,
    ) {
        self.checks += 1;
        let share = if apart == 0.0 && tolerance >= 0.0 { 0.0 } else { apart.abs() / tolerance };
        // Written so that NaN (of value or tolerance) fails.
        let good = apart.abs() <= tolerance;
        if !good {
            self.failures.push(Failure {
                case: case.into(),
                quantity: quantity.into(),
                expected: number(expected),
                actual: number(actual),
                difference: Some(apart).filter(|x| x.is_finite()),
                tolerance: Some(tolerance).filter(|x| x.is_finite()),
            });
        }
        let share = if share.is_nan() { f64::MAX } else { share.min(f64::MAX) };
        if self.worst.as_ref().is_none_or(|w| share > w.share_of_tolerance) {
            self.worst =
                Some(Worst { case: case.into(), quantity: quantity.into(), share_of_tolerance: share });
        }
    }

    /// Compares two values that must be equal: names of errors, choices, absence.
    pub fn equal(&mut self, case: &str, quantity: &str, expected: Value, actual: Value) {
        self.checks += 1;
        if expected != actual {
            self.fail(case, quantity, expected, actual);
        }
    }

    /// A failure without numbers: an unknown quantity, an input that cannot be read, an error of the library.
    pub fn fail(&mut self, case: &str, quantity: &str, expected: Value, actual: Value) {
        self.failures.push(Failure {
            case: case.into(),
            quantity: quantity.into(),
            expected,
            actual,
            difference: None,
            tolerance: None,
        });
    }

    /// Notes a case that cannot be run here.
    pub fn not_run(&mut self, case: &str, reason: &str) {
        self.not_run.push(NotRun { case: case.into(), reason: reason.into() });
    }
}

/// A number as JSON; what JSON cannot hold becomes a text.
fn number(x: f64) -> Value {
    serde_json::Number::from_f64(x).map_or_else(|| Value::String(x.to_string()), Value::Number)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nan_and_missing_tolerances_fail() {
        let mut ledger = Ledger::default();
        ledger.number("c", "nan", 1.0, f64::NAN, 1.0);
        ledger.number("c", "no tolerance", 1.0, 1.0, f64::NAN);
        ledger.number("c", "infinite", 1.0, f64::INFINITY, 1.0);
        ledger.periodic(("c", "angle"), 0.0, f64::NAN, 2.0, 1.0);
        assert_eq!((ledger.checks, ledger.failures.len()), (4, 4));
        ledger.number("c", "good", 1.0, 1.0, 0.0);
        ledger.periodic(("c", "angle"), 1e-12, 2.0 - 1e-12, 2.0, 1e-11);
        assert_eq!((ledger.checks, ledger.failures.len()), (6, 4));
        assert_eq!(ledger.worst.unwrap().quantity, "nan");
    }
}
