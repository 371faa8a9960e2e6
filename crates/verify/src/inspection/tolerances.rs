//! Blocks `tolerances`, `tolerance_errors` and `classes`.

use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::evaluation_case::{check_each, check_refusals};
use metrology::inspection::{InspectionError, ToleranceGear, ToleranceQuantity, Tolerances, reached_classes};
use serde::Deserialize;
use serde_json::Value;
use std::collections::BTreeMap;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Input {
    teeth: Option<u32>,
    m_n_mm: f64,
    d_mm: f64,
    b_mm: f64,
    beta_deg: Option<f64>,
    tolerance_class: Option<i32>,
    values_um: Option<BTreeMap<String, f64>>,
}

impl Input {
    fn tolerances(&self) -> Result<Tolerances, InspectionError> {
        Tolerances::new(&ToleranceGear {
            // Number of teeth and helix angle bound the standard only: a case may leave them out.
            teeth: self.teeth.unwrap_or(30),
            normal_module: self.m_n_mm,
            reference_diameter: self.d_mm,
            face_width: self.b_mm,
            helix_angle: self.beta_deg.unwrap_or(0.0).to_radians(),
        })
    }

    fn class(&self) -> Result<i32, InspectionError> {
        self.tolerance_class.ok_or(InspectionError::WrongCount {
            field: "tolerance_class",
            found: 0,
            needed: 1,
        })
    }
}

/// Block `tolerances`: unrounded and rounded tolerances.
pub(crate) fn tolerances(_: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    check_each("tolerances", block, ledger, |input: &Input, tolerances, expected, ledger| {
        let (of, class, um) = (input.tolerances()?, input.class()?, tolerances.get("um"));
        for (key, rounded) in [("unrounded_um", false), ("rounded_um", true)] {
            let Some(mut expected) = expected.object(key, ledger) else { continue };
            for quantity in ToleranceQuantity::ALL {
                let value =
                    if rounded { of.rounded(quantity, class)? } else { of.unrounded(quantity, class)? };
                let kind = if quantity.is_informative() { "_informative" } else { "" };
                expected.number(&format!("{}{kind}", quantity.symbol()), value * 1e3, um, ledger);
            }
            expected.finish(ledger);
        }
        Ok(())
    });
}

/// Block `tolerance_errors`: what the standard does not cover.
pub(crate) fn tolerance_errors(_: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    check_refusals("tolerance_errors", block, ledger, |input: &Input| {
        input.tolerances()?.rounded(ToleranceQuantity::SinglePitch, input.class()?).map(|_| ())
    });
}

/// Block `classes`: the class that each value and the part reaches.
pub(crate) fn classes(_: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    check_each("classes", block, ledger, |input: &Input, _, expected, ledger| {
        let mut values = Vec::new();
        for (symbol, um) in input.values_um.iter().flatten() {
            match ToleranceQuantity::ALL.into_iter().find(|quantity| quantity.symbol() == symbol) {
                Some(quantity) => values.push((quantity, um * 1e-3)),
                None => ledger.fail(expected.case(), "input", symbol.as_str().into(), "unknown".into()),
            }
        }
        let found = reached_classes(&input.tolerances()?, &values)?;
        let each = found.each.iter().map(|(quantity, class)| (quantity.symbol(), *class));
        for (key, class) in each.chain([("overall", found.overall)]) {
            if let Some(value) = expected.take(key) {
                ledger.equal(expected.case(), &expected.name(key), value.clone(), class.into());
            }
        }
        Ok(())
    });
}
