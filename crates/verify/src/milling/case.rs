//! A named flank with its cutter.

use super::super::expected::Expected;
use super::super::given::Checked;
use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::bevel_cases::BevelInput;
use super::blade_cases::BladeInput;
use super::body::Body;
use super::cutter::Tool;
use super::cylinder_cases::CylinderInput;
use foundation::geometry::Cutter;
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
    pub(super) fn of(case: &Value, tool: &Tool, contact_height: f64) -> Checked<Self> {
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
