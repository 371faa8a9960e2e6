//! The cases: named flanks with a cutter, and every quantity that a case expects.

use super::super::expected::Expected;
use super::super::given::{Checked, check_object, number};
use super::super::ledger::Ledger;
use super::super::reference::{Reference, read};
use super::bevel_cases::BevelInput;
use super::blade_cases::BladeInput;
use super::cutter::Tool;
use super::cylinder_cases::CylinderInput;
use super::{columns, flank, residual};
use foundation::geometry::{BevelGear, Cutter, Helicoid};
use foundation::numerics::equidistant;
use milling::{
    ActiveFlank, CutterLocation, GridPlace, LeadCurve, LeadPoint, MillingError, Orientation, lead_range,
};
use serde::Deserialize;
use serde_json::Value;
use std::sync::Arc;

#[derive(Deserialize)]
#[serde(tag = "type", rename_all = "snake_case")]
enum Input {
    Cylindrical(CylinderInput),
    Bevel(BevelInput),
    Ruled(BladeInput),
}

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

/// A flank that is milled.
pub(super) struct MilledCase {
    pub flank: ActiveFlank,
    /// The other flank of the same space; blades have none.
    pub opposite: Option<ActiveFlank>,
    pub lead: Arc<dyn LeadCurve>,
    pub body: Body,
    pub cutter: Cutter,
    /// h, mm.
    pub contact_height: f64,
}

impl MilledCase {
    fn of(case: &Value, tool: &Tool, contact_height: f64) -> Checked<Self> {
        let input: Input = Input::deserialize(case)?;
        let cutter = tool.cutter()?;
        let (flank, opposite, lead, body): (_, _, Arc<dyn LeadCurve>, _) = match input {
            Input::Cylindrical(input) => {
                let (flank, opposite, lead, body) = input.case()?;
                (flank, Some(opposite), Arc::new(lead), body)
            }
            Input::Bevel(input) => {
                let (flank, opposite, lead, body) = input.case()?;
                (flank, Some(opposite), Arc::new(lead), body)
            }
            Input::Ruled(input) => {
                let (flank, lead) = input.case()?;
                (flank, None, Arc::new(lead), Body::Blade)
            }
        };
        Ok(Self { flank, opposite, lead, body, cutter, contact_height })
    }

    /// The case of that name.
    pub fn named(reference: &Reference<'_>, name: &str) -> Checked<Self> {
        let case = reference.root.get("cases").and_then(|cases| cases.get(name));
        let case = case.ok_or_else(|| format!("the file has no case {name}"))?;
        let height = case.get("contact_height_mm").and_then(Value::as_f64);
        let height = height.ok_or_else(|| format!("case {name}: contact_height_mm is missing"))?;
        Self::of(&case["input"], &Tool::deserialize(&case["tool"])?, height)
    }

    /// The case that the object names by `case`.
    pub fn given(
        reference: &Reference<'_>,
        expected: &mut Expected<'_>,
        ledger: &mut Ledger,
    ) -> Checked<Self> {
        Self::named(reference, super::super::given::text(expected, "case", ledger)?)
    }

    /// [u_min, u_max] without overrun.
    pub fn range(&self) -> Checked<[f64; 2]> {
        Ok(lead_range(&self.flank, &*self.lead)?)
    }

    /// So many lead parameters over the range.
    pub fn lead_parameters(&self, columns: usize) -> Checked<Vec<f64>> {
        Ok(equidistant(self.range()?, columns))
    }

    /// [a_root, a_tip], which are constants in every case.
    pub fn heights(&self) -> [f64; 2] {
        self.flank.height_span()
    }

    /// A height parameter between root (0) and tip (1).
    pub fn height_at(&self, share: f64) -> f64 {
        let [root, tip] = self.heights();
        root + share * (tip - root)
    }
}

/// The cutter at a place of a column.
pub(super) fn located(
    place: &GridPlace,
    lead: &LeadPoint,
    cutter: &Cutter,
    height: f64,
    tilt: f64,
) -> Result<CutterLocation, MillingError> {
    let orientation = Orientation { tilt, lead_angle: 0.0 };
    CutterLocation::new(&place.jet, lead, cutter.shape(), cutter.cutting_length(), height, orientation)
}

/// Block `cases`.
pub(crate) fn cases(_: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    let Some(cases) = block.as_object() else {
        return ledger.fail("cases", "cases", block.clone(), "a table of cases is needed here".into());
    };
    for (name, value) in cases {
        let expected = Expected::new(name, "", value, ledger);
        check_object(expected, ledger, |expected, ledger| case(name, value, expected, ledger));
    }
}

fn case(name: &str, value: &Value, expected: &mut Expected<'_>, ledger: &mut Ledger) -> Checked {
    expected.informative(&["input", "tool"]);
    let height = number(expected, "contact_height_mm", ledger)?;
    let tool = read::<Tool>(name, &value["tool"], ledger).ok_or("the cutter cannot be read")?;
    let case = MilledCase::of(&value["input"], &tool, height)?;
    // The file states no tolerances beside the parameters that follow from the drawing: those of the flank's points hold.
    let stated = |key: &str| value["flank_points"][key].as_f64().unwrap_or(f64::NAN);
    let tolerances = [stated("tolerance_mm"), stated("tolerance_n")];
    flank::derived(&case, tolerances, expected, ledger);
    flank::range(&case, expected, ledger)?;
    flank::points(&case, expected, ledger);
    columns::columns(&case, expected, ledger);
    columns::grids(&case, value, expected, ledger);
    if let Some(object) = expected.object("residual", ledger) {
        check_object(object, ledger, |object, ledger| residual::residual(&case, object, ledger));
    }
    Ok(())
}
