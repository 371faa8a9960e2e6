//! Values of the variables between job files and process: a job names them by text, with the whole shift ratio and offset; the process
//! counts both from what follows from the bodies.

use super::finding;
use super::plan::PassPlan;
use super::prepare::{TangentialPrepared, channel_of, variable_of};
use crate::job::{
    Channel as JobChannel, FlankValues, Passes, SplineValues, TangentialJob,
    TangentialSettings as JobSettings,
};
use crate::{Channel, Shape, TangentialSettings, Variable};
use foundation::geometry::Flank;
use job::{Diagnostic, Problem};
use run::RunFailure;
use std::collections::BTreeMap;

/// A pass whose values are settled, by a plan or by the job.
pub(super) struct SettledPass {
    pub flanks: Vec<Flank>,
    pub settings: TangentialSettings,
    pub plan: Option<PassPlan>,
}

/// The values of a pass as the job has them; the shift ratio and offset of the job stand in place of those of the bodies.
pub(super) fn settings_of_job(
    given: &JobSettings,
    ready: &TangentialPrepared,
    pass: &[Flank],
) -> Result<TangentialSettings, RunFailure> {
    let values = given.of_flank(pass[0]);
    let mut settings = TangentialSettings::default();
    let offset = Variable::power(Channel::ToolShift, 0);
    for (&name, &value) in &values.values {
        let variable = variable_of(name, &format!("settings.values.{name}"))?;
        let own = if variable == offset { ready.model.shift_offset(pass) } else { 0.0 };
        settings.set(&variable, value - own);
    }
    if let Some(ratio) = values.kap {
        settings.set(&Variable::shift_ratio(), ratio - ready.model.shift_ratio);
    }
    for (i, spline) in values.splines.iter().enumerate() {
        let field = format!("settings.splines[{i}]");
        let channel = channel_of(spline.channel, &field)?;
        let functions = Variable::spline(channel, spline.intervals, ready.model.spline_range(channel, pass))
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

/// The values of a pass as a job carries them.
fn settings_for_job(ready: &TangentialPrepared, pass: &SettledPass) -> FlankValues {
    let mut values = BTreeMap::new();
    let mut splines: Vec<SplineValues> = Vec::new();
    let mut shift_offset = ready.model.shift_offset(&pass.flanks);
    for (variable, value) in pass.settings.values() {
        match (&variable.shape, variable.channel) {
            (_, Channel::ShiftRatio) => {}
            (Shape::Power(0), Channel::ToolShift) => shift_offset += value,
            (Shape::Power(_), _) => {
                if let Ok(name) = variable.to_string().parse() {
                    values.insert(name, *value);
                }
            }
            (Shape::Spline { basis, index, .. }, channel) => {
                let Some(named) = JobChannel::ALL.into_iter().find(|c| c.name() == channel.name()) else {
                    continue;
                };
                if !splines.iter().any(|s| s.channel == named) {
                    splines.push(SplineValues {
                        channel: named,
                        intervals: basis.count() - basis.degree(),
                        coefficients: vec![0.0; basis.count()],
                    });
                }
                if let Some(spline) = splines.iter_mut().find(|s| s.channel == named) {
                    spline.coefficients[*index] = *value;
                }
            }
        }
    }
    if let Ok(name) = Variable::power(Channel::ToolShift, 0).to_string().parse() {
        values.insert(name, shift_offset);
    }
    let ratio = ready.model.shift_ratio + pass.settings.value(&Variable::shift_ratio());
    FlankValues { kap: Some(ratio), values, splines }
}

pub(super) fn job_settings(
    job: &TangentialJob,
    ready: &TangentialPrepared,
    passes: &[SettledPass],
) -> JobSettings {
    let mut settings = JobSettings::default();
    for pass in passes {
        let values = settings_for_job(ready, pass);
        match (job.dressing.passes, pass.flanks.as_slice()) {
            (Passes::One, _) => settings.both = Some(values),
            (Passes::Each, [Flank::Left]) => settings.left = Some(values),
            (Passes::Each, _) => settings.right = Some(values),
        }
    }
    settings
}
