//! 40-tdm: tangential dressing of one gear: bodies, nominal contact, sensitivities, ground flanks, undercut, fits. Every block sees
//! the file's input, points and tolerances, and nothing else of it, but for the targets that two flanks share with an example.

mod bodies;
mod fits;
mod flanks;
mod limits;

pub(super) use bodies::{dresser_profile, grid, input, machine};
pub(super) use fits::{examples, two_flank_same_motions};
pub(super) use flanks::{left, right};
pub(super) use limits::{twist_conventional, undercut};

use super::expected::{Expected, numbers};
use super::ledger::Ledger;
use super::reference::{Reference, Tolerances};
use bodies::Input;
use foundation::geometry::Flank;
use serde::Deserialize;
use serde_json::Value;
use std::error::Error;
use tangential_dressing::{
    ProfileKind, RollGrid, TangentialError, TangentialModel, TangentialSettings, Variable,
};

const UM: f64 = 1e-3;

/// What a comparison ends with: an error is a failure of the whole object.
type Outcome = Result<(), Box<dyn Error>>;

/// What the blocks share.
struct Setup<'a> {
    file: &'a Reference<'a>,
    input: Input,
    model: TangentialModel,
    tolerances: Tolerances<'a>,
}

impl<'a> Setup<'a> {
    fn read(file: &'a Reference<'a>) -> Result<Self, Box<dyn Error>> {
        let input = Input::deserialize(&file.root["input"]).map_err(|e| format!("the file's input: {e}"))?;
        let model = input.model(ProfileKind::Conjugate, input.kappa)?;
        Ok(Self { file, input, model, tolerances: file.tolerances() })
    }

    /// Radii and axial positions of the file's points.
    fn points(&self) -> Result<[Vec<f64>; 2], Box<dyn Error>> {
        let grid = &self.file.root["grid"];
        let list = |key: &str| numbers(&grid[key]).filter(|list| !list.is_empty());
        match (list("R"), list("Z")) {
            (Some(radii), Some(faces)) => Ok([radii, faces]),
            _ => Err("the file's block grid lists no points".into()),
        }
    }

    /// The file's points on a flank.
    fn grid(&self, flank: Flank) -> Result<RollGrid, Box<dyn Error>> {
        let [radii, z] = self.points()?;
        let w = radii.iter().map(|&r| self.roll(flank, r)).collect::<Result<_, _>>()?;
        Ok(RollGrid { w, z })
    }

    fn roll(&self, flank: Flank, radius: f64) -> Result<f64, TangentialError> {
        Ok(self.model.pair.work.flank(flank).length_of_roll(radius)?)
    }
}

/// Compares an object that expects something; one that expects nothing needs no input.
fn with_setup(
    name: &str,
    file: &Reference<'_>,
    block: &Value,
    ledger: &mut Ledger,
    check: impl FnOnce(&Setup<'_>, &mut Expected<'_>, &mut Ledger) -> Outcome,
) {
    let mut item = Expected::new(name, "", block, ledger);
    if block.as_object().is_some_and(|map| !map.is_empty()) {
        let outcome = Setup::read(file).and_then(|setup| check(&setup, &mut item, ledger));
        if let Err(error) = outcome {
            item.refused(&error, ledger);
        }
    }
    item.finish(ledger);
}

/// Settings under the key `variables`: names of design variables with their values, mm and rad.
fn given_settings(item: &mut Expected<'_>) -> Result<TangentialSettings, Box<dyn Error>> {
    let table =
        item.take("variables").and_then(Value::as_object).ok_or("variables are needed here as input")?;
    let mut settings = TangentialSettings::default();
    for (name, value) in table {
        let value = value.as_f64().ok_or_else(|| format!("{name} needs a number"))?;
        settings.set(&name.parse()?, value);
    }
    Ok(settings)
}

/// Names of design variables under the key `keys`.
fn given_variables(item: &mut Expected<'_>) -> Result<Vec<Variable>, Box<dyn Error>> {
    let list = item.take("keys").and_then(Value::as_array).ok_or("a list of variables is needed here")?;
    let one = |name: &Value| -> Result<Variable, Box<dyn Error>> {
        Ok(name.as_str().ok_or("a name of a variable is needed here")?.parse()?)
    };
    list.iter().map(one).collect()
}

/// +1 or -1 under the key `flank`.
fn given_sign(item: &mut Expected<'_>, ledger: &mut Ledger) -> Option<Flank> {
    let sign = item.given("flank", ledger)?;
    let flank = Flank::BOTH.into_iter().find(|flank| flank.sign() == sign);
    if flank.is_none() {
        ledger.fail(item.case(), "flank", sign.into(), "1 for left or -1 for right is needed here".into());
    }
    flank
}

/// A refusal in the files' words.
fn name_in_files(error: &TangentialError) -> &'static str {
    match error {
        // The files know one word for both.
        TangentialError::Undercut { .. } | TangentialError::NotSettled { .. } => "Undercut",
        TangentialError::OutsideTool { .. } => "OutsideTool",
        other => other.code(),
    }
}
