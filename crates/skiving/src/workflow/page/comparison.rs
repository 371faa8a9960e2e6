//! The workpiece to come, corrections, the usual way, history, scatter and programs for the page.

use crate::history::HistoryRecord;
use crate::job::SkivingJob;
use crate::page::{
    ConventionalRow, CorrectionsView, FlankProfile, HistoryRow, HistoryView, MonteCarloRow, MonteCarloView,
    ProfileView, ProgramRow, ProgramsView, SettingChange, WearRow, WearTrend,
};
use crate::workflow::prepare::SkivingBodies;
use crate::workflow::programs::ToolProgramResult;
use crate::workflow::resharpening::BrokenEdge;
use crate::workflow::result::{ResharpeningResult, SkivingResult};
use crate::workflow::run::SkivingOutcome;
use foundation::geometry::{Flank, Sides};
use report::Quantity;

/// Broken edges in the table of regrinding, the deepest first.
const BROKEN_SHOWN: usize = 6;

/// Profiles as deviations from the target.
pub(super) fn profile(result: &SkivingResult) -> ProfileView {
    let of_flank = |flank: Flank| {
        let f = &result.flanks[flank.name()];
        let target: Vec<f64> = f.target_um.iter().flatten().copied().collect();
        let beyond = |values: &mut dyn Iterator<Item = f64>| -> Vec<f64> {
            values.zip(&target).map(|(value, target)| value - target).collect()
        };
        let measured = result.measurement.is_some();
        let ends = |k: usize| beyond(&mut f.teeth_um.iter().map(|ends| ends[k]));
        let simulated = f.simulated_um.iter().flatten().copied();
        FlankProfile {
            roll_mm: f.w_mm.clone(),
            mean_um: beyond(&mut f.planned_um.iter().flatten().copied()),
            least_um: if measured { ends(0) } else { Vec::new() },
            greatest_um: if measured { ends(1) } else { Vec::new() },
            corrected_um: if measured { beyond(&mut f.corrected_um.iter().copied()) } else { Vec::new() },
            simulated: f
                .w_mm
                .iter()
                .zip(simulated.zip(&target))
                .map(|(w, (found, target))| [*w, found - target])
                .collect(),
            tolerance_um: Some([-result.tolerance_um, result.tolerance_um]),
        }
    };
    ProfileView { flanks: Sides::from_fn(of_flank) }
}

/// Changes of the setting, wear, when to grind again.
pub(super) fn corrections(job: &SkivingJob, outcome: &SkivingOutcome) -> Option<CorrectionsView> {
    let measured = outcome.result.measurement.as_ref()?;
    let (correction, limits) = (&measured.correction, &job.evaluation.limits);
    let spread = |name: &str| {
        let found = outcome.result.monte_carlo.as_ref()?.results.iter().find(|r| r.name == name)?;
        Some(found.sigma)
    };
    let free = |setting| outcome.bodies.free.contains(&setting);
    use crate::Setting;
    let all = [
        (
            Setting::CentreDistance,
            "centre distance",
            "Δd",
            correction.centre_distance_um,
            "µm",
            1e3 * limits.centre_distance,
        ),
        (
            Setting::CrossedAxesAngle,
            "crossed-axes angle",
            "Δγ",
            correction.crossed_axes_angle_deg,
            "deg",
            limits.crossed_axes_angle_deg,
        ),
        (Setting::ToolShift, "tool shift", "Δz_V1", correction.tool_shift_um, "µm", 1e3 * limits.tool_shift),
        (Setting::ToolAngle, "tool angle", "Δφ_1", correction.tool_angle_deg, "deg", limits.tool_angle_deg),
    ];
    let changes = all.into_iter().filter(|(setting, ..)| free(*setting)).map(
        |(_, name, symbol, change, unit, limit)| SettingChange {
            name: name.into(),
            symbol: symbol.into(),
            change,
            unit: unit.into(),
            limit: Some(limit),
            at_limit: correction.at_limit.contains(&name),
            deviation: spread(&format!("correction {name}")),
        },
    );
    let wear = Flank::BOTH.into_iter().filter_map(|flank| {
        let means = measured.profile.track_mean_um.get(flank.name())?;
        let (track, mean) = means.iter().enumerate().min_by(|a, b| a.1.total_cmp(b.1))?;
        Some(WearRow {
            flank,
            track: track + 1,
            mean_um: *mean,
            limit_um: measured.profile.wear_limit_um,
            worn: measured.profile.worn[flank.name()],
        })
    });
    Some(CorrectionsView {
        changes: changes.collect(),
        rms_um: Some(correction.rms_um),
        wear: wear.collect(),
        regrind: regrind(outcome),
    })
}

/// Depth of the next grinding, and when it is due.
fn regrind(outcome: &SkivingOutcome) -> Vec<Quantity> {
    let Some(measured) = &outcome.result.measurement else { return Vec::new() };
    let depth = &measured.resharpening;
    let mut rows = vec![
        Quantity::number("off the rake faces, along their normal", "", 1e3 * depth.depth_mm, "µm"),
        Quantity::number("the same along the tool's axis", "", 1e3 * depth.axial_depth_mm, "µm"),
    ];
    rows.extend(of_broken(depth));
    let Some(history) = &outcome.result.history else { return rows };
    for (flank, trend) in &history.flanks {
        match (trend.limit_at_parts, trend.remaining_parts, &trend.no_forecast) {
            (Some(at), Some(left), _) => {
                let due = if left > 0.0 {
                    format!("at {at:.0} workpieces: {left:.0} are left")
                } else {
                    format!("since {at:.0} workpieces: {:.0} too many", -left)
                };
                rows.push(Quantity::text(&format!("{flank} flank reaches its limit of wear"), due));
            }
            (.., Some(why)) => rows.push(Quantity::text(&format!("{flank} flank"), why.clone())),
            _ => {}
        }
    }
    rows
}

/// What broken edges ask for, which of them by how much, and what the rest alone asks for.
fn of_broken(depth: &ResharpeningResult) -> Vec<Quantity> {
    let mut rows = Vec::new();
    if !depth.broken.is_empty() {
        let alone = &depth.without_broken;
        rows.push(Quantity::number(
            "without the broken edges, along the normal",
            "",
            1e3 * alone.depth_mm,
            "µm",
        ));
        rows.push(Quantity::number("the same along the tool's axis", "", 1e3 * alone.axial_depth_mm, "µm"));
    }
    let mut broken: Vec<&BrokenEdge> = depth.broken.iter().collect();
    broken.sort_by(|a, b| b.depth_mm.total_cmp(&a.depth_mm));
    for edge in broken.iter().take(BROKEN_SHOWN) {
        let text = format!("{:.0} µm missing, at least {:.0} µm off", edge.missing_um, 1e3 * edge.depth_mm);
        rows.push(Quantity::text(&format!("broken: tooth {}, {} edge", edge.tooth, edge.flank), text));
    }
    if let Some(more @ 1..) = broken.len().checked_sub(BROKEN_SHOWN) {
        rows.push(Quantity::text("further broken edges", format!("{more}, in resharpening.csv")));
    }
    if !depth.not_covered.is_empty() {
        let teeth: Vec<String> = depth.not_covered.iter().map(ToString::to_string).collect();
        let text = "no switch: not counted in the depths";
        rows.push(Quantity::text(&format!("tooth {}", teeth.join(", ")), text));
    }
    rows
}

/// The usual way beside the contact points: of the simulated tool, else of the ideal one.
pub(super) fn conventional(bodies: &SkivingBodies, result: &SkivingResult) -> Vec<ConventionalRow> {
    let row = |found: &crate::workflow::result::ConventionalResult| {
        let flank = Flank::BOTH.into_iter().find(|flank| flank.name() == found.flank)?;
        let section = &bodies.flanks[flank].tracks.get(found.track - 1)?.0.section;
        let of_tool = found.measured_um.zip(found.reported_um);
        Some(ConventionalRow {
            flank,
            track: found.track,
            virtual_um: of_tool.map_or(0.0, |(measured, _)| measured),
            conventional_um: of_tool.map(|(_, reported)| reported).or(found.ideal_um),
            contact_deg: section.contact_angle.to_degrees(),
            touch_deg: found.touch_deg,
            end_deg: section.range[1].to_degrees(),
        })
    };
    result.conventional.iter().filter_map(row).collect()
}

/// Earlier measurements and the trend.
pub(super) fn history(outcome: &SkivingOutcome) -> Option<HistoryView> {
    let noted = outcome.history.as_ref()?;
    let row = |record: &HistoryRecord| HistoryRow {
        name: record.time.clone(),
        parts: record.parts,
        wear_um: Sides::from_fn(|flank| Some(1e3 * record.wear_point(flank).wear)),
        remark: match record.out_of_band.len() {
            0 => String::new(),
            count => format!("{count} edges out of their band"),
        },
    };
    let trend = |flank: Flank| {
        let none = WearTrend { line: Vec::new(), forecast: None, forecast_deviation: None };
        let Some(found) = &noted.trends[flank] else { return none };
        let forecast = found.forecast.as_ref().ok();
        // Beyond twice the workpieces so far a line says nothing.
        let shown = forecast.filter(|f| f.parts > 0.0 && f.parts <= 2.0 * found.last_parts);
        let last = shown.map_or(found.last_parts, |f| f.parts.max(found.last_parts));
        WearTrend {
            line: [0.0, last].map(|parts| [parts, 1e3 * found.wear_at(parts)]).to_vec(),
            forecast: shown.map(|f| [f.parts, 1e3 * found.limit]),
            forecast_deviation: shown.map(|f| f.deviation),
        }
    };
    Some(HistoryView {
        measurements: noted.cycle.iter().map(row).collect(),
        trends: Sides::from_fn(trend),
        limit_um: Some(1e3 * outcome.bodies.options.wear_limit),
    })
}

/// The scatter of what counts for the whole tool; the rest stands in its table.
pub(super) fn monte_carlo(result: &SkivingResult) -> Option<MonteCarloView> {
    let found = result.monte_carlo.as_ref()?;
    let rows = found.results.iter().filter(|r| !r.name.contains("tooth")).map(|r| MonteCarloRow {
        name: r.name.clone(),
        symbol: String::new(),
        unit: if r.unit == "um" {
            "µm"
        } else if r.unit == "urad" {
            "µrad"
        } else {
            r.unit
        }
        .into(),
        mean: r.mean,
        deviation: r.sigma,
        stated_deviation: r.stated_sigma,
        interval: r.interval,
    });
    Some(MonteCarloView {
        runs: found.measurements,
        noise:
            "Jitter of the barrier and edge of the beam scatter; angles are rounded to steps of the encoder."
                .into(),
        rows: rows.collect(),
    })
}

/// Programs and their proof.
pub(super) fn programs(outcome: &SkivingOutcome) -> Option<ProgramsView> {
    let programs = &outcome.result.programs;
    let worst = |of: fn(&ToolProgramResult) -> f64| programs.iter().map(of).fold(0.0, f64::max);
    let row = |program: &ToolProgramResult| ProgramRow {
        file: program.file.clone(),
        control: program.control.into(),
        blocks: program.blocks,
        duration_s: program.duration_s,
    };
    let proof = "Every text was read by a reader that shares nothing with the writer, its axes were taken through the kinematics of the \
                 machine to the tool, and the ideal tool was measured there: it switches where it should, as far as numbers are rounded.";
    let mut figures = vec![
        Quantity::number(
            "touch of the ideal tool off its nominal place",
            "",
            worst(|p| p.proof_difference_um),
            "µm",
        ),
        Quantity::number("beam off its place at the contact", "", worst(|p| p.proof_axis_distance_um), "µm"),
        Quantity::number("explained by rounded numbers", "", worst(|p| p.proof_allowed_um), "µm"),
    ];
    let between = programs.iter().filter_map(|p| p.between_places_um).reduce(f64::max);
    figures.extend(
        between.map(|um| Quantity::number("left by straight blocks between places of a scan", "", um, "µm")),
    );
    (!programs.is_empty()).then(|| ProgramsView {
        proof: vec![proof.into()],
        programs: programs.iter().map(row).collect(),
        figures,
    })
}
