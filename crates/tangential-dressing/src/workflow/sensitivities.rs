//! What a unit of each variable does to the unmodified flank.

use super::prepare::TangentialPrepared;
use super::result::SensitivityResult;
use super::settings::SettledPass;
use crate::{Channel, FitGrid, Shape, TangentialError, TangentialFlank, TangentialSettings, Variable};

/// The nine variables of the source, whose topographies every report shows (its table 3).
const SOURCE_VARIABLES: [(Channel, u32); 9] = [
    (Channel::Profile(None), 1),
    (Channel::Profile(None), 2),
    (Channel::Profile(None), 3),
    (Channel::TangentialShift, 2),
    (Channel::TangentialShift, 3),
    (Channel::CrossedAxesAngle, 0),
    (Channel::CentreDistance, 0),
    (Channel::WorkTurn, 2),
    (Channel::WorkTurn, 3),
];

/// Points of a sensitivity topography each way.
const SENSITIVITY_POINTS: usize = 11;

/// Derivatives of the unmodified flank by the variables of the source and those that the passes use.
pub(super) fn sensitivities(
    ready: &TangentialPrepared,
    passes: &[SettledPass],
) -> Result<Vec<SensitivityResult>, TangentialError> {
    let mut all = Vec::new();
    for pass in passes {
        let mut variables: Vec<Variable> = SOURCE_VARIABLES.map(|(c, k)| Variable::power(c, k)).into();
        let used = pass.settings.values().iter().map(|(v, _)| v);
        for variable in used.filter(|v| matches!(v.shape, Shape::Power(_))) {
            if !variables.contains(variable) {
                variables.push(variable.clone());
            }
        }
        for &flank in &pass.flanks {
            let settings = TangentialSettings::default();
            let measure = ready.rules.measure;
            let plain = TangentialFlank::new(&ready.model, flank, &pass.flanks, &settings, measure);
            let grid = FitGrid::Radii(SENSITIVITY_POINTS).of(&ready.model, flank);
            let (_, by) = plain.linearised(&grid, &variables)?;
            let columns = grid.z.len();
            for (j, variable) in variables.iter().enumerate().filter(|(_, v)| v.channel.concerns(flank)) {
                let angle = variable.channel == Channel::DressingAngle;
                let values = (0..grid.w.len())
                    .map(|i| (0..columns).map(|k| without_rounding(by[(i * columns + k, j)])).collect())
                    .collect();
                all.push(SensitivityResult {
                    flank: flank.name(),
                    variable: variable.to_string(),
                    // mm per rad are um per mrad.
                    unit: if angle { "um/mrad" } else { "um/um" },
                    w_mm: grid.w.clone(),
                    z_mm: grid.z.clone(),
                    values,
                });
            }
        }
    }
    Ok(all)
}

/// Derivatives below this are rounding: a crossed-axes angle has no effect of first order.
const ROUNDING: f64 = 1e-9;

fn without_rounding(x: f64) -> f64 {
    if x.abs() < ROUNDING { 0.0 } else { x }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn variables_of_the_source_are_those_that_a_job_names_so() {
        let named = crate::job::Variable::SOURCE.map(|v| v.to_string());
        assert_eq!(named, SOURCE_VARIABLES.map(|(c, k)| Variable::power(c, k).to_string()));
    }
}
