//! Fills the page of the electronic gearbox. Timing stays out of it, so that the same job gives the same bytes.

use super::result::{ExploreResult, GearboxResult, RangeUm, ServoResult, SetUpResult};
use super::run::GearboxOutcome;
use crate::job::GearboxJob;
use crate::page::{Band, BandPanel, BudgetRow, GearboxReport, ServoReport, SetUpPoint, SetUpReport};
use control::{Extremes, FollowingRecord};
use job::control::{InterpolationMode, RotationRate};
use report::charts::{ChartError, format_significant};
use report::{Column, Quantity, Table, html};
use run::{Answer, report_head};

/// Rows of the table of set-ups; all of them stand in `set-ups.csv`.
const ROWS: usize = 200;
/// How far beyond the limits of constant speed a chart reaches, as a share of their distance.
const BEYOND: f64 = 0.25;

/// The report of a run as a self-contained HTML page.
///
/// # Errors
/// A number that is not finite.
pub fn html_page(
    job: &GearboxJob,
    outcome: &GearboxOutcome,
    files: &[(String, &'static str)],
) -> Result<String, ChartError> {
    let result = &outcome.result;
    let answer = Answer {
        process: "Electronic gearbox",
        status: result.verdict.status(),
        reason: result.verdict.reason(),
        warnings: &result.warnings,
        headline: headline(result),
        figures: figures(result),
    };
    let report = GearboxReport {
        head: report_head(&job.job, answer, files),
        settings: settings(result),
        coupling: coupling(result),
        counters: counters(result),
        errors: errors(result),
        error_panels: error_panels(outcome),
        budget: budget(result),
        servo: result
            .servo
            .as_ref()
            .zip(outcome.servo.as_ref())
            .map(|(s, record)| servo(s, record, result.coupling.flank_um_per_rad)),
        set_ups: result.explore.as_ref().map(set_ups),
    };
    Ok(html::render(&report.to_page()?))
}

fn headline(result: &GearboxResult) -> String {
    if let Some(reason) = result.verdict.reason() {
        return format!("{}.", reason.text);
    }
    if let Some(explored) = &result.explore {
        return format!(
            "{} of {} set-ups keep to {} µm at the flank.",
            explored.feasible,
            explored.set_ups.len(),
            explored.wanted_um
        );
    }
    let pulses = &result.pulses;
    let of_angle = result.angle.and_then(|angle| angle.within_bound);
    let of_feed = result.along_feed.as_ref().and_then(|along| along.within_bound);
    let kept = of_angle.zip(of_feed).map(|(a, b)| a && b);
    let within = match kept {
        Some(true) => ", every error within its limits",
        Some(false) => ", ERRORS OUTSIDE THEIR LIMITS",
        None => "",
    };
    format!("{} reference pulses became {} pulses{within}.", pulses.references, pulses.pulses)
}

fn figures(result: &GearboxResult) -> Vec<(String, String)> {
    let um = |x: f64| format!("{} µm", format_significant(x, 4));
    let mut figures =
        vec![("alarms".to_owned(), (result.pulses.too_fast + result.pulses.overruns).to_string())];
    if let Some(angle) = &result.angle {
        let RangeUm { least_um, greatest_um } = angle.flank;
        figures.push((
            "error at the flank".into(),
            format!("{} to {}", format_significant(least_um, 4), um(greatest_um)),
        ));
    }
    if let Some(servo) = &result.servo {
        figures.push(("servo, rms at the flank".into(), um(servo.workpiece.rms_um)));
    }
    if let Some(best) = result.explore.as_ref().and_then(|e| e.best) {
        figures.push(("cheapest set-up costs".into(), format_significant(best.set_up.cost, 6)));
        figures.extend(best.set_up.flank_um.map(|x| ("its budget".into(), um(x))));
    }
    figures
}

fn settings(result: &GearboxResult) -> Vec<Quantity> {
    let s = &result.settings;
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
        InterpolationMode::OneWay => "one-way",
        InterpolationMode::NoBacklash => "no-backlash",
        InterpolationMode::Literal => "literal",
    }
}

/// The word of the job file for a way of counting.
fn rate_word(rate: RotationRate) -> &'static str {
    match rate {
        RotationRate::Exact => "exact",
        RotationRate::Bresenham => "bresenham",
        RotationRate::Binary => "binary",
    }
}

fn coupling(result: &GearboxResult) -> Vec<Quantity> {
    let c = &result.coupling;
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

fn counters(result: &GearboxResult) -> Vec<Quantity> {
    let p = &result.pulses;
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

fn errors(result: &GearboxResult) -> Vec<Quantity> {
    let mut list = Vec::new();
    let range = |list: &mut Vec<Quantity>, name: &str, range: Option<RangeUm>| {
        if let Some(RangeUm { least_um, greatest_um }) = range {
            let text =
                format!("{} … {}", format_significant(least_um, 5), format_significant(greatest_um, 5));
            let mut quantity = Quantity::text(name, text);
            quantity.unit = "µm".into();
            list.push(quantity);
        }
    };
    if let Some(along) = &result.along_feed {
        range(&mut list, "along the feed, whole motion", along.whole);
        range(&mut list, "limits of it", along.bound);
        range(&mut list, "along the feed, constant speed", along.steady);
        range(&mut list, "limits of it", along.steady_bound);
        for (name, value) in [
            ("mean upwards", along.mean_up_um),
            ("mean downwards", along.mean_down_um),
            ("difference of the senses along the feed", along.direction_offset_um),
            ("difference of the senses at the flank", along.direction_offset_flank_um),
        ] {
            list.extend(value.map(|um| Quantity::number(name, "", um, "µm")));
        }
    }
    if let Some(angle) = &result.angle {
        range(&mut list, "rotation at the flank, whole motion", Some(angle.flank));
        range(&mut list, "limits of it", angle.bound);
    }
    list
}

/// Least and greatest of bins in a unit.
fn band<'a, B: 'a>(
    bins: &'a [B],
    scale: f64,
    time: impl Fn(&'a B) -> f64,
    value: impl Fn(&'a B) -> Extremes,
) -> Band {
    Band {
        time_s: bins.iter().map(time).collect(),
        least: bins.iter().map(|bin| scale * value(bin).least).collect(),
        greatest: bins.iter().map(|bin| scale * value(bin).greatest).collect(),
    }
}

fn error_panels(outcome: &GearboxOutcome) -> Vec<BandPanel> {
    let (result, bins) = (&outcome.result, &outcome.run.bins);
    let (Some(along), false) = (&result.along_feed, bins.is_empty()) else { return Vec::new() };
    let ends = |range: RangeUm| [range.least_um, range.greatest_um];
    let axial = band(bins, 1e3, |bin| bin.time, |bin| bin.axial);
    let mut panels = vec![BandPanel {
        title: "along the feed [µm]".into(),
        band: axial.clone(),
        limits: along.bound.map(ends),
        cut: None,
    }];
    panels.extend(along.steady_bound.map(ends).map(|limits| {
        let room = BEYOND * (limits[1] - limits[0]);
        BandPanel {
            title: "along the feed, limits of constant speed [µm]".into(),
            band: axial,
            limits: Some(limits),
            cut: Some([limits[0] - room, limits[1] + room]),
        }
    }));
    panels.push(BandPanel {
        title: "rotation at the flank, normal [µm]".into(),
        band: band(bins, result.coupling.flank_um_per_rad, |bin| bin.time, |bin| bin.angle),
        limits: result.angle.and_then(|angle| angle.bound).map(ends),
        cut: None,
    });
    panels
}

fn budget(result: &GearboxResult) -> Vec<BudgetRow> {
    let Some(b) = &result.budget else { return Vec::new() };
    [
        ("staircase of the pulses", "p/P", b.quantisation_um),
        ("whole counts of the period", "v (P − 1)/f_1", b.truncation_um),
        ("pulses are seen a tick late", "v/f_1", b.synchronisation_um),
        ("speed of the interval before", "a p²/v²", b.acceleration_um),
    ]
    .into_iter()
    .map(|(name, formula, along_um)| BudgetRow {
        name: name.into(),
        formula: formula.into(),
        along_um,
        flank_um: along_um * result.coupling.flank_um_per_feed_um,
    })
    .collect()
}

fn servo(result: &ServoResult, record: &FollowingRecord, um: f64) -> ServoReport {
    let quantities = vec![
        Quantity::number("settling before the motion", "", result.settling_s, "s"),
        Quantity::number("setpoint, rms", "", result.setpoint.rms_um, "µm"),
        Quantity::number("setpoint, peak", "", result.setpoint.peak_um, "µm"),
        Quantity::number("workpiece, rms", "", result.workpiece.rms_um, "µm"),
        Quantity::number("workpiece, peak", "", result.workpiece.peak_um, "µm"),
        Quantity::number("workpiece, mean removed", "", result.workpiece.mean_um, "µm"),
        Quantity::number("greatest torque", "", result.greatest_torque_n_m, "N m"),
        Quantity::number("samples at the limit of the torque", "", 1e2 * result.torque_limited_share, "%"),
        Quantity::number("largest pole", "|z|", result.largest_pole, ""),
    ];
    let panel = |title: &str, band: Band| BandPanel { title: title.into(), band, limits: None, cut: None };
    ServoReport {
        quantities,
        panels: vec![
            panel("setpoint of the gearbox [µm]", band(&record.bins, um, |bin| bin.time, |bin| bin.setpoint)),
            panel("workpiece [µm]", band(&record.bins, um, |bin| bin.time, |bin| bin.actual)),
            panel("torque of the motor [N m]", band(&record.bins, 1.0, |bin| bin.time, |bin| bin.torque)),
        ],
        response: result.disturbance_response.iter().map(|r| [r.frequency_hz, r.um_per_n_m]).collect(),
    }
}

fn set_ups(explored: &ExploreResult) -> SetUpReport {
    let points = explored.set_ups.iter().filter_map(|s| {
        let fast = s.refused != Some("interpolator-too-fast");
        Some(SetUpPoint { cost: s.cost, flank_um: s.flank_um?, fast })
    });
    let best = explored.best.map_or_else(Vec::new, |best| {
        let s = best.set_up;
        let mut list = vec![
            Quantity::number("cost", "", s.cost, ""),
            Quantity::number("reference pulses per metre", "q", s.pulses_per_metre, "1/m"),
            Quantity::number("clock", "f_1", s.clock_hz, "Hz"),
            Quantity::count("pulses per interval", "P", i64::from(s.pulses_per_interval)),
            Quantity::count("workpiece pulses per revolution", "N_w", i64::from(s.pulses_per_revolution)),
        ];
        list.extend(s.flank_um.map(|um| Quantity::number("budget at the flank", "", um, "µm")));
        for (name, value) in [
            ("simulated, constant speed", best.measured_steady_um),
            ("simulated, starts and reversals among it", best.measured_whole_um),
        ] {
            list.extend(value.map(|um| Quantity::number(name, "", um, "µm")));
        }
        list
    });
    SetUpReport { wanted_um: explored.wanted_um, points: points.collect(), best, table: ranking(explored) }
}

/// A verdict in as few words as the table has room for.
fn verdict(refused: Option<&str>) -> &str {
    match refused {
        None => "accurate",
        Some("not-accurate-enough") => "coarse",
        Some("interpolator-too-fast") => "too slow",
        Some(_) => "b ≥ 1",
    }
}

fn ranking(explored: &ExploreResult) -> Table {
    let um = |x: f64| format_significant(x, 4);
    let row = |s: &SetUpResult| {
        vec![
            s.rank.to_string(),
            format_significant(s.cost, 6),
            s.flank_um.map_or_else(|| "–".into(), um),
            format_significant(s.pulses_per_metre, 7),
            format_significant(s.clock_hz, 7),
            s.pulses_per_interval.to_string(),
            s.pulses_per_revolution.to_string(),
            um(s.quantisation_um),
            um(s.clock_um),
            um(s.acceleration_um),
            um(s.resolution_um),
            s.rounding_um.map_or_else(|| "–".into(), um),
            verdict(s.refused).to_owned(),
        ]
    };
    let rest = explored.set_ups.len().saturating_sub(ROWS);
    let more = if rest > 0 { format!(" {rest} more rows stand in set-ups.csv.") } else { String::new() };
    Table {
        caption: "Ranking".into(),
        columns: vec![
            Column::number("Rank", ""),
            Column::number("Cost", ""),
            Column::number("Flank", "µm"),
            Column::number("q", "1/m"),
            Column::number("Clock", "Hz"),
            Column::number("P", ""),
            Column::number("N_w", "1/rev"),
            Column::number("Staircase", "µm"),
            Column::number("Clock", "µm"),
            Column::number("Accel.", "µm"),
            Column::number("Resol.", "µm"),
            Column::number("Round.", "µm"),
            Column::text("Verdict"),
        ],
        rows: explored.set_ups.iter().take(ROWS).map(row).collect(),
        note: format!(
            "At {} mm/min and {} mm/s². Ranked: {}.{more}",
            format_significant(explored.speed_mm_per_min, 6),
            format_significant(explored.acceleration_mm_per_s2, 6),
            explored.ranking
        ),
    }
}
