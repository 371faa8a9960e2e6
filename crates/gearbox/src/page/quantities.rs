//! Settings, coupling and counters as the page lists them.

use crate::workflow::{CouplingResult, GearboxSettingsResult, PulseFigures};
use job::control::{InterpolationMode, RotationRate};
use report::Quantity;

pub(super) fn settings(s: &GearboxSettingsResult) -> Vec<Quantity> {
    vec![
        Quantity::number("reference pulses per metre", "q", s.pulses_per_metre, "1/m"),
        Quantity::number("pitch", "p", s.pitch_mm, "mm"),
        Quantity::number("clock", "f_1", s.clock_hz, "Hz"),
        Quantity::count("pulses per interval", "P", i64::from(s.pulses_per_interval)),
        Quantity::text("corrections", mode_word(s.mode)),
        Quantity::count(
            "workpiece pulses per revolution",
            "N_w",
            i64::from(s.workpiece_pulses_per_revolution),
        ),
        Quantity::text("rotation counted", rate_word(s.rate)),
        Quantity::text("machine counts the other way", if s.reversed { "yes" } else { "no" }),
        Quantity::number("greatest speed", "v_max", s.greatest_speed_mm_per_min, "mm/min"),
        Quantity::number("duration", "", s.duration_s, "s"),
    ]
}

/// The word of the job file for a mode.
fn mode_word(mode: InterpolationMode) -> &'static str {
    match mode {
        InterpolationMode::OneWay => "in one sense",
        InterpolationMode::NoBacklash => "without backlash",
        InterpolationMode::Literal => "pulse by pulse",
    }
}

/// A way of counting in words.
fn rate_word(rate: RotationRate) -> &'static str {
    match rate {
        RotationRate::Exact => "exactly",
        RotationRate::Bresenham => "by Bresenham's rule",
        RotationRate::Binary => "by a rate multiplier",
    }
}

pub(super) fn coupling(c: &CouplingResult) -> Vec<Quantity> {
    let mut list = Vec::new();
    list.extend(c.lead_mm.map(|lead| Quantity::number("lead", "p_z", lead, "mm")));
    list.push(Quantity::number("coefficient", "b", c.coefficient, ""));
    list.extend(c.coefficient_word.map(|word| Quantity::count("its word of 18 bits", "B", i64::from(word))));
    list.extend(
        c.coefficient_relative_error
            .map(|error| Quantity::number("relative error of the word", "", error, "")),
    );
    list.push(Quantity::number("rounding of the rotation in use", "", c.rotation_error_um_per_m, "µm/m"));
    list.push(Quantity::number("flank per workpiece pulse", "", c.flank_um_per_workpiece_pulse, "µm"));
    list.push(Quantity::number("flank per feed", "s_ax", c.flank_um_per_feed_um, "µm/µm"));
    list.push(Quantity::number("flank per angle", "s_rot", c.flank_um_per_rad, "µm/rad"));
    list
}

pub(super) fn counters(p: &PulseFigures) -> Vec<Quantity> {
    let count = |name: &str, symbol: &str, value: u64| Quantity::count(name, symbol, value as i64);
    vec![
        count("pulses", "", p.pulses),
        count("reference pulses", "R", p.references),
        count("intermediate pulses", "Z", p.intermediates),
        count("correction pulses", "K", p.corrections),
        Quantity::count("sum of signs, all pulses", "", p.net_pulses),
        Quantity::count("sum of signs, reference pulses", "", p.net_references),
        Quantity::count("corrections owed at the end", "", p.pending_corrections),
        count("alarms: overruns", "", p.overruns),
        count("alarms: too fast", "", p.too_fast),
        Quantity::count("rotation, whole workpiece pulses", "", p.rotation_workpiece_pulses),
        Quantity::count("rotation, rest in parts 1/P", "", p.rotation_rest_parts),
        Quantity::number("rotation", "", p.rotation_deg, "deg"),
    ]
}
