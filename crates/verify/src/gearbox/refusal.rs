//! Why a case cannot be computed, and files that expect just that.

use super::super::expected::Expected;
use super::super::ledger::Ledger;
use control::ControlError;
use serde_json::Value;
use std::fmt::Display;

/// A refused input.
#[derive(Debug)]
pub(super) struct Refusal {
    code: &'static str,
    told: String,
}

impl Refusal {
    fn new(code: &'static str, error: &dyn Display) -> Self {
        Self { code, told: error.to_string() }
    }

    /// A case that contradicts itself or asks for what no check can give.
    pub fn of_case(told: String) -> Self {
        Self { code: "bad-case", told }
    }

    /// Good if the case expects this very error; else the case cannot be compared.
    pub fn compare(&self, expected: &mut Expected<'_>, ledger: &mut Ledger) {
        let Some(wanted) = expected.take("error") else { return expected.refused(&self.told, ledger) };
        let same = wanted.as_str().is_some_and(|name| letters(name) == letters(self.code));
        let found = if same { wanted.clone() } else { Value::from(format!("{}: {}", self.code, self.told)) };
        ledger.equal(expected.case(), "error", wanted.clone(), found);
    }
}

impl From<electronic_gearbox::Error> for Refusal {
    fn from(error: electronic_gearbox::Error) -> Self {
        Self::new(error.code(), &error)
    }
}

impl From<ControlError> for Refusal {
    fn from(error: ControlError) -> Self {
        Self::new(error.code(), &error)
    }
}

/// An error's name whether it is written `BadTable`, `bad_table` or `bad-table`, without its data in parentheses.
fn letters(name: &str) -> String {
    name.chars()
        .take_while(|c| *c != '(')
        .filter(char::is_ascii_alphanumeric)
        .collect::<String>()
        .to_lowercase()
}

#[cfg(test)]
mod tests {
    use super::letters;

    #[test]
    fn names_are_the_same_in_every_spelling() {
        for name in ["BadParameter(q)", "bad_parameter", "bad-parameter"] {
            assert_eq!(letters(name), "badparameter");
        }
        assert_ne!(letters("BadTable"), letters("bad-gear"));
    }
}
