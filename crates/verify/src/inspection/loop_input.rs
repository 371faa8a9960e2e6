//! What a case of the closed loop was made of: hidden errors, the settings that may be turned, their bounds.

use super::super::expected::{Expected, numbers};
use super::super::given::{Checked, number};
use super::super::ledger::Ledger;
use super::grinding::{setting, unit};
use generating::correction::Setting;
use serde_json::Value;

/// What was wrong with the machine.
pub(super) struct Hidden {
    pub settings: Vec<(Setting, f64)>,
    pub delta_gamma: f64,
    pub wave: f64,
}

impl Hidden {
    pub fn read(input: &mut Expected<'_>, ledger: &mut Ledger) -> Checked<Self> {
        let settings = input.take("hidden_machine_errors").and_then(Value::as_object);
        let settings = settings.ok_or("hidden_machine_errors: an object is needed here")?;
        let settings = settings.iter().map(|(name, value)| {
            let setting = setting(name)?;
            let value = value.as_f64().ok_or("hidden_machine_errors: numbers are needed here")?;
            Ok((setting, value * unit(setting)))
        });
        Ok(Self {
            settings: settings.collect::<Checked<_>>()?,
            delta_gamma: number(input, "hidden_crossing_angle_error_deg", ledger)?.to_radians(),
            wave: number(input, "hidden_worm_wave_um", ledger)?,
        })
    }
}

/// The settings that a case turns.
pub(super) fn settings_used(input: &mut Expected<'_>) -> Checked<Vec<Setting>> {
    let names = input.take("settings_used").and_then(Value::as_array);
    let names = names.ok_or("settings_used: a list of names is needed here")?;
    names.iter().map(|name| setting(name.as_str().unwrap_or_default())).collect()
}

/// Bounds of the settings used, in units of the library.
pub(super) fn bounds(input: &mut Expected<'_>, used: &[Setting]) -> Checked<Vec<[f64; 2]>> {
    let mut bounds = vec![[f64::NEG_INFINITY, f64::INFINITY]; used.len()];
    let Some(table) = input.take("bounds").filter(|value| !value.is_null()) else { return Ok(bounds) };
    for (name, pair) in table.as_object().ok_or("bounds: an object is needed here")? {
        let setting = setting(name)?;
        let place = used.iter().position(|s| *s == setting).ok_or_else(|| format!("{name} is not used"))?;
        let pair = numbers(pair).and_then(|pair| <[f64; 2]>::try_from(pair).ok());
        bounds[place] = pair.ok_or("bounds: two numbers are needed here")?.map(|x| x * unit(setting));
    }
    Ok(bounds)
}
