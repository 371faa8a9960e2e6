//! Warnings of a run: corrections still owed, modes and motors at their limits.

use super::result::{AlongFeedResult, BudgetResult, GearboxSettingsResult, PulseFigures, ServoResult};
use super::result::{CorrectionResult, SplitResult};
use job::control::InterpolationMode;
use verdict::Remark;

/// Share of samples at the limit of the torque from which on the errors are those of the motor, not of the loop.
const LIMITED: f64 = 1e-3;

/// Jump of the speed, deg/s, from which on a table ends steeply: what an axis takes in a cycle of a millisecond at 10 deg/s^2.
const JUMP: f64 = 0.01;

/// What the figures say that someone should know.
pub(super) fn warnings(
    settings: &GearboxSettingsResult,
    pulses: &PulseFigures,
    budget: Option<&BudgetResult>,
    along: Option<&AlongFeedResult>,
    servo: Option<&ServoResult>,
) -> Vec<Remark> {
    let mut warnings = Vec::new();
    if pulses.pending_corrections != 0 {
        warnings.push(Remark {
            code: "corrections-pending",
            text: format!(
                "the run ends while {} corrections are still owed",
                pulses.pending_corrections.abs()
            ),
            way_out: "let it end later: a longer `rest_s` or a later `last_tick`".into(),
        });
    }
    let offset = along.and_then(|along| along.direction_offset_flank_um);
    match (settings.mode, offset) {
        (InterpolationMode::OneWay, Some(um)) => warnings.push(Remark {
            code: "direction-offset",
            text: format!("in mode one-way both senses of the feed differ by {um:.3} um at the flank"),
            way_out: "take mode = \"no-backlash\", or grind in one sense only".into(),
        }),
        (InterpolationMode::Literal, _) => warnings.push(Remark {
            code: "literal-mode",
            text: "mode literal loses pulses at quick reversals and has no bound".into(),
            way_out: "take mode = \"no-backlash\" on a machine".into(),
        }),
        _ => {}
    }
    if let Some((p, best)) =
        budget.and_then(|b| Some((f64::from(settings.pulses_per_interval), b.best_pulses_per_interval?)))
        && p > 2.0 * best
    {
        warnings.push(Remark {
            code: "more-pulses-than-help",
            text: format!(
                "{p} pulses per interval are more than the clock resolves at the greatest speed; beyond {best:.1} they no longer help"
            ),
            way_out: "insert fewer pulses or take a faster clock".into(),
        });
    }
    warnings.extend(servo.and_then(torque_limited));
    warnings
}

/// What corrections and voltage do that someone should know.
pub(super) fn of_additions(corrections: &[CorrectionResult], split: Option<&SplitResult>) -> Vec<Remark> {
    let jump = corrections.iter().map(|correction| correction.speed_jump_deg_per_s).fold(0.0, f64::max);
    let mut warnings = Vec::new();
    if jump > JUMP {
        warnings.push(Remark::new(
            "correction-ends-steeply",
            format!("a table that is added ends with a slope: the speed of the workpiece jumps by {jump:.4} deg/s there"),
            "let the table begin and end flat, or beyond the travel of the feed",
        ));
    }
    if let Some(split) =
        split.filter(|split| split.limits.greatest_um - split.limits.least_um > split.step_um)
    {
        warnings.push(Remark::new(
            "converter-coarser-than-parts",
            format!(
                "the voltage is off by up to {:.3} um at the flank, more than one part of a workpiece pulse, {:.3} um",
                split.limits.greatest_um.max(-split.limits.least_um),
                split.step_um
            ),
            "take a converter with more bits, adjust its slope, or insert fewer pulses",
        ));
    }
    warnings
}

/// A motor at its limit: what is left is its error, not that of the loop.
pub(super) fn torque_limited(servo: &ServoResult) -> Option<Remark> {
    (servo.torque_limited_share > LIMITED).then(|| {
        Remark::new(
            "torque-limited",
            format!(
                "the motor is at its greatest torque in {:.2} % of the samples",
                1e2 * servo.torque_limited_share
            ),
            "accelerate more slowly, or take a stronger motor or a smaller bandwidth",
        )
    })
}
