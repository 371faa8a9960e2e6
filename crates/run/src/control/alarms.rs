//! What the pulse interpolator's counters say that someone should know.

use electronic_gearbox::pulse::Status;
use job::control::ScaleInterpolation;
use verdict::Remark;

/// Warnings of intervals that were too short for their pulses, and of corrections that came late.
pub fn interpolator_alarms(feed: &ScaleInterpolation, status: &Status) -> Vec<Remark> {
    let mut warnings = Vec::new();
    if status.too_fast > 0 {
        warnings.push(Remark {
            code: "interpolator-too-fast",
            text: format!(
                "alarm: {} of {} intervals had fewer ticks than the {} pulses that belong in them; the feed follows up to {:.6} mm/min",
                status.too_fast,
                status.references.saturating_sub(1),
                feed.pulses_per_interval,
                60.0 * feed.greatest_speed_mm_per_s()
            ),
            way_out: "feed slower, insert fewer pulses, or take a faster clock or a coarser scale".into(),
        });
    }
    if status.overruns > 0 {
        warnings.push(Remark {
            code: "interpolator-overrun",
            text: format!(
                "alarm: {} intervals ended while corrections of the one before were still owed: pulses come late",
                status.overruns
            ),
            way_out: "a machine stops the feed here; feed slower, insert fewer pulses, or take a faster clock".into(),
        });
    }
    warnings
}
