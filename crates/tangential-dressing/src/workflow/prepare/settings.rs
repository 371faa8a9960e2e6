//! The settings that stand in a job, pass by pass. A job names variables by text and counts shift ratio and offset from nothing; the
//! process counts both from what follows from the bodies.

use super::TangentialPrepared;
use super::names::{channel_of, variable_of};
use crate::job::{LoadedTangentialJob, TangentialSettings as JobSettings};
use crate::workflow::finding;
use crate::{Channel, TangentialModel, TangentialSettings, Variable};
use foundation::geometry::Flank;
use job::{Diagnostic, Problem};
use run::RunFailure;

/// The values of each pass.
///
/// # Errors
/// [`RunFailure`], among them a job without `[settings]`.
pub fn given_settings(
    loaded: &LoadedTangentialJob,
    ready: &TangentialPrepared,
) -> Result<Vec<TangentialSettings>, RunFailure> {
    let Some(given) = &loaded.job.settings else { return Err(RunFailure::no_settings()) };
    ready.passes.iter().map(|pass| of_pass(given, &ready.model, pass)).collect()
}

fn of_pass(
    given: &JobSettings,
    model: &TangentialModel,
    pass: &[Flank],
) -> Result<TangentialSettings, RunFailure> {
    let values = given.of_flank(pass[0]);
    let mut settings = TangentialSettings::default();
    let offset = Variable::power(Channel::ToolShift, 0);
    for (&name, &value) in &values.values {
        let variable = variable_of(name, &format!("settings.values.{name}"))?;
        let own = if variable == offset { model.shift_offset(pass) } else { 0.0 };
        settings.set(&variable, value - own);
    }
    if let Some(ratio) = values.kap {
        settings.set(&Variable::shift_ratio(), ratio - model.shift_ratio);
    }
    for (i, spline) in values.splines.iter().enumerate() {
        let field = format!("settings.splines[{i}]");
        let channel = channel_of(spline.channel, &field)?;
        let functions = Variable::spline(channel, spline.intervals, model.spline_range(channel, pass))
            .map_err(|e| finding::on_field(&e, &field))?;
        if functions.len() != spline.coefficients.len() {
            let text =
                format!("a spline of {} intervals has {} coefficients", spline.intervals, functions.len());
            let finding = Diagnostic::new(Problem::InvalidJob, text)
                .field(format!("{field}.coefficients"))
                .value(spline.coefficients.len())
                .allowed(functions.len().to_string())
                .way_out("take the coefficients as `plan` wrote them");
            return Err(RunFailure::bad_input(finding));
        }
        for (variable, &value) in functions.iter().zip(&spline.coefficients) {
            settings.set(variable, value);
        }
    }
    Ok(settings)
}
