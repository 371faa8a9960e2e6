//! Passes with their values, and those as a job carries them: named by text, with the whole shift ratio and offset.

use super::plan::PassPlan;
use super::prepare::TangentialPrepared;
use crate::job::{Channel as JobChannel, FlankValues, SplineValues, TangentialSettings as JobSettings};
use crate::{Channel, Shape, TangentialSettings, Variable};
use foundation::geometry::Flank;
use std::collections::BTreeMap;

/// A pass whose values are settled, by a plan or by the job.
pub(super) struct SettledPass {
    pub flanks: Vec<Flank>,
    pub settings: TangentialSettings,
    pub plan: Option<PassPlan>,
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

/// Settings as a job carries them.
pub(super) fn job_settings(ready: &TangentialPrepared, passes: &[SettledPass]) -> JobSettings {
    let mut settings = JobSettings::default();
    for pass in passes {
        let values = settings_for_job(ready, pass);
        match pass.flanks.as_slice() {
            _ if ready.one_pass => settings.both = Some(values),
            [Flank::Left] => settings.left = Some(values),
            _ => settings.right = Some(values),
        }
    }
    settings
}
