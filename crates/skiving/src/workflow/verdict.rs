//! Whether a measured tool is fit, and why not. Every figure is judged with the scatter of its own measurement: only what lies further
//! beyond its limit than the readings scatter is called missed; what lies beyond by less is not judged.

use super::measurement::Measurement;
use super::prepare::{PreparedSkiving, SkivingBodies};
use super::result::{MeasurementResult, SkivedFlankResult};
use crate::MeasuringTrack;
use foundation::geometry::Flank;
use foundation::numerics::{bisect, normal_upper_tail, power_series};
use std::collections::BTreeMap;
use verdict::{Remark, Verdict, agree};

/// Probability with which noise alone takes any of several figures further than their guard band.
const LEVEL: f64 = 0.05;
/// Fewest teeth of which one may be an outlier without a doubt about the others.
const PER_BROKEN: usize = 3;

/// What a run has to show for its verdict.
pub(super) struct Judged<'a> {
    pub prepared: &'a PreparedSkiving,
    pub measured: Option<(&'a Measurement, &'a MeasurementResult)>,
    pub flanks: &'a BTreeMap<&'static str, SkivedFlankResult>,
    /// What corrections promise, with the greatest difference between prediction and referee, um.
    pub promised: Vec<(&'static str, f64)>,
    /// Controls whose measuring programs were proven.
    pub programs: Vec<String>,
}

/// The verdict of a run.
pub(super) fn verdict(found: &Judged<'_>) -> Verdict {
    let mut verdict = Verdict::new();
    if let Some((measurement, result)) = found.measured {
        for flank in Flank::BOTH {
            worn(found, measurement, result, flank, &mut verdict);
        }
        for flank in Flank::BOTH {
            band(found, measurement, flank, &mut verdict);
        }
    }
    of_workpiece(found, &mut verdict);
    for (item, difference) in &found.promised {
        of_promise(item, *difference, found.prepared.tolerance_um, &mut verdict);
    }
    match found.measured {
        Some((measurement, _)) => of_teeth(found, measurement, &mut verdict),
        None => {
            verdict.leave("the tool", "nothing is measured: tracks, poses and the ideal edges are judged")
        }
    }
    verdict.leave("tip edges, root fillets and chamfers of the tool", "the tracks lie on the flanks' edges");
    verdict.leave("feed marks and the flank along the tooth", "the profile is judged for a feed of nothing");
    found.prepared.bodies.measures.leave_class(&mut verdict);
    if found.prepared.mounting.is_none() {
        verdict.leave("programs", "the job names no machine");
    }
    for program in &found.programs {
        verdict.met(
            format!("program for {program}: {}", of_program(program)),
            "every measured point within its limits, from the text",
        );
    }
    if !found.programs.is_empty() {
        verdict.leave(
            "moves of the programs between the recordings",
            "retreats and rapids are laid past the beam, and their text is not judged; the first rapid comes from wherever the axes stand",
        );
        verdict.leave(
            "collisions with parts of the machine",
            "light barrier, holder and spindle have no bodies; poses are checked against the flanks of the tool",
        );
    }
    verdict
}

/// Whether the ideal edge makes the wanted flank, as far as the run tells: prediction and referee agree, and of a tool that is not measured
/// the profile keeps its tolerance.
pub(super) fn is_sound(found: &Judged<'_>) -> bool {
    let tolerance = found.prepared.tolerance_um;
    found.flanks.values().all(|flank| {
        agree(flank.model_difference_um[0], tolerance)
            && (found.measured.is_some() || flank.max_deviation_um <= tolerance)
    })
}

/// Factor that takes a standard deviation to the guard band of one among `figures`.
fn guard_factor(figures: usize) -> f64 {
    let beyond = LEVEL / figures.max(1) as f64;
    // Chance beyond 38 standard deviations is no number any more.
    bisect(0.0, 38.0, |x| 2.0 * normal_upper_tail(x) - beyond).unwrap_or(38.0)
}

/// How a figure lies to its limit, both um.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Place {
    Within,
    Unsure,
    Beyond,
}

fn place(value: f64, limit: f64, guard: f64) -> Place {
    if value - guard > limit {
        Place::Beyond
    } else if value > limit {
        Place::Unsure
    } else {
        Place::Within
    }
}

/// A figure that was judged: what it says, its worst place, its guard band.
struct Figure {
    item: String,
    place: Place,
    detail: String,
    guard_um: f64,
}

fn note(verdict: &mut Verdict, figure: Figure, missed: impl FnOnce() -> Remark) {
    let Figure { item, place, detail, guard_um } = figure;
    match place {
        Place::Within => verdict.met(item, detail),
        Place::Beyond => verdict.missed(item, detail, missed()),
        Place::Unsure => {
            let text = format!(
                "{item}: {detail}; it lies beyond its limit by less than the measurement scatters, so that it is neither within nor beyond"
            );
            let way_out = format!(
                "measure more revolutions, at a lower speed, or in both senses: the guard band of {guard_um:.2} um shrinks with the root of their number"
            );
            verdict.owe(item, Remark::new("within-scatter", text, way_out));
        }
    }
}

/// Standard deviation of the number of a tooth on a track, um: the stated one, or that of the revolutions if they differ by more.
fn scatter_um(bodies: &SkivingBodies, measurement: &Measurement, flank: Flank) -> Vec<f64> {
    let stated = &measurement.deviations(bodies)[flank];
    let seen = measurement.measured.repeatability.as_ref().map(|of| &of[flank]);
    let larger = |(track, stated): (usize, &f64)| 1e3 * seen.map_or(*stated, |seen| seen[track].max(*stated));
    stated.iter().enumerate().map(larger).collect()
}

/// What is missing on the deepest track in the mean of the whole teeth.
fn worn(
    found: &Judged<'_>,
    measurement: &Measurement,
    result: &MeasurementResult,
    flank: Flank,
    verdict: &mut Verdict,
) {
    let limit = result.profile.wear_limit_um;
    let means = &result.profile.track_mean_um[flank.name()];
    let factor = guard_factor(2 * means.len()) / (measurement.evaluation.count() as f64).sqrt();
    let scatter = scatter_um(&found.prepared.bodies, measurement, flank);
    let of_track = |(mean, sigma): (&f64, f64)| {
        let guard = factor * sigma;
        (place(-mean, limit, guard), -mean, guard)
    };
    let all: Vec<(Place, f64, f64)> = means.iter().zip(scatter).map(of_track).collect();
    let Some(&(_, missing, guard_um)) = all.iter().max_by(|a, b| a.1.total_cmp(&b.1)) else { return };
    let place = all.iter().map(|(place, ..)| *place).max().unwrap_or(Place::Within);
    let figure = Figure {
        item: format!("wear of the {flank} edges"),
        place,
        detail: format!(
            "{:.2} of {limit} um missing on the deepest track in the mean, guard band {guard_um:.2} um",
            missing.max(0.0)
        ),
        guard_um,
    };
    note(verdict, figure, || {
        Remark::new(
            "tool-worn",
            format!(
                "the tool is worn ({flank} flank): {missing:.2} um are missing on a track in the mean, {limit} um are allowed"
            ),
            "grind the tool again; resharpening.csv tells how deep, with and without broken edges",
        )
    });
}

/// An edge with its largest distance from the compensation curve.
struct Edge {
    tooth: usize,
    place: Place,
    off_um: f64,
    guard_um: f64,
}

/// Single edges about the compensation curve.
fn band(found: &Judged<'_>, measurement: &Measurement, flank: Flank, verdict: &mut Verdict) {
    let evaluation = &measurement.evaluation;
    let tracks = &found.prepared.bodies.flanks[flank].tracks;
    let half_um = 0.5e3 * found.prepared.bodies.options.band;
    let incomplete = measurement.measured.incomplete();
    let factor = guard_factor(2 * tracks.len() * found.prepared.bodies.teeth());
    let scatter = scatter_um(&found.prepared.bodies, measurement, flank);
    let edge = |tooth: usize| {
        let of_track = |(number, (track, _)): (usize, &(MeasuringTrack, _))| {
            let curve = power_series(&evaluation.profile.curve[flank], track.place)[0];
            let off = 1e3 * (evaluation.remaining.of[flank][number][tooth] - curve).abs();
            let guard = factor * scatter[number];
            (place(off, half_um, guard), off, guard)
        };
        let all: Vec<(Place, f64, f64)> = tracks.iter().enumerate().map(of_track).collect();
        let place = all.iter().map(|(place, ..)| *place).max()?;
        let (_, off_um, guard_um) = *all.iter().max_by(|a, b| a.1.total_cmp(&b.1))?;
        Some(Edge { tooth, place, off_um, guard_um })
    };
    let edges: Vec<Edge> = (0..found.prepared.bodies.teeth())
        .filter(|tooth| !incomplete.contains(tooth))
        .filter_map(edge)
        .collect();
    let Some(worst) = edges.iter().max_by(|a, b| a.off_um.total_cmp(&b.off_um)) else { return };
    let place = edges.iter().map(|edge| edge.place).max().unwrap_or(Place::Within);
    let beyond = edges.iter().filter(|edge| edge.place == Place::Beyond).count();
    let unsure = edges.iter().filter(|edge| edge.place == Place::Unsure).count();
    let doubtful = if place == Place::Unsure {
        format!("; {} beyond the limit by less than the guard band", counted(unsure, "edge"))
    } else {
        String::new()
    };
    let figure = Figure {
        item: format!("{flank} edges in their band"),
        place,
        detail: format!(
            "{:.2} of {half_um} um off the compensation curve (tooth {}), guard band {:.2} um{doubtful}",
            worst.off_um, worst.tooth, worst.guard_um
        ),
        guard_um: worst.guard_um,
    };
    note(verdict, figure, || {
        Remark::new(
            "teeth-out-of-band",
            format!(
                "{} of the {flank} flank {} the band of {} um by more than the measurement scatters ({:.2} um), most of all that of tooth {} ({:.2} um off the curve)",
                counted(beyond, "edge"),
                if beyond == 1 { "leaves" } else { "leave" },
                2.0 * half_um,
                worst.guard_um,
                worst.tooth,
                worst.off_um
            ),
            "look at these teeth for chips and built-up edges, and measure again",
        )
    });
}

/// The workpiece to come, and whether prediction and referee agree on it.
fn of_workpiece(found: &Judged<'_>, verdict: &mut Verdict) {
    let tolerance = found.prepared.tolerance_um;
    for (name, flank) in found.flanks {
        let guard_um = found.measured.map_or(0.0, |(measurement, _)| {
            let scatter = scatter_um(&found.prepared.bodies, measurement, flank_named(name));
            let largest = scatter.iter().copied().fold(0.0, f64::max);
            largest * guard_factor(2 * scatter.len()) / (measurement.evaluation.count() as f64).sqrt()
        });
        let figure = Figure {
            item: format!("{name} flank of the workpiece"),
            place: place(flank.max_deviation_um, tolerance, guard_um),
            detail: format!(
                "{:.4} of {tolerance} um by the mean of the whole teeth, guard band {guard_um:.2} um",
                flank.max_deviation_um
            ),
            guard_um,
        };
        note(verdict, figure, || above_tolerance(flank, tolerance));
        let difference = flank.model_difference_um[0];
        if !agree(difference, tolerance) {
            let text = format!(
                "prediction and simulation of the {name} flank differ by {difference:.3} um, more than a tenth of the tolerance of {tolerance} um"
            );
            let way_out = "check the tool against the workpiece: another part of its edge may cut the flank; widen the tolerance, or lay no track on the corner of a relief";
            verdict.owe(
                format!("{name} flank of the workpiece: prediction against simulation"),
                Remark::new("models-disagree", text, way_out),
            );
        }
    }
}

/// A correction is judged by whether the referee leaves what was predicted of it.
fn of_promise(item: &'static str, difference: f64, tolerance: f64, verdict: &mut Verdict) {
    if agree(difference, tolerance) {
        verdict.met(item.to_owned(), format!("prediction within {difference:.4} um of the simulation"));
    } else {
        let text = format!(
            "prediction and simulation of the {item} differ by {difference:.3} um, more than a tenth of the tolerance of {tolerance} um"
        );
        let way_out = "correct a smaller error at a time, or widen the tolerance";
        verdict.owe(item.to_owned(), Remark::new("models-disagree", text, way_out));
    }
}

fn flank_named(name: &str) -> Flank {
    if name == Flank::Left.name() { Flank::Left } else { Flank::Right }
}

fn above_tolerance(flank: &SkivedFlankResult, tolerance_um: f64) -> Remark {
    let target = flank.target_um.iter().flatten();
    let corrected = flank
        .corrected_simulated_um
        .as_ref()
        .map(|found| found.iter().zip(target).map(|(f, t)| (f - t).abs()).fold(0.0, f64::max));
    let worst = flank.max_deviation_um;
    Remark::new(
        "above-tolerance",
        format!("the profile will deviate by {worst:.2} um, the tolerance is {tolerance_um} um"),
        match corrected {
            Some(after) if after <= tolerance_um => {
                format!("apply the correction of the setting: {after:.2} um remain")
            }
            Some(after) => {
                format!("apply the correction of the setting ({after:.2} um remain), or grind the tool again")
            }
            None => "check the tool against the workpiece: another part of its edge cuts the flank".into(),
        },
    )
}

/// Teeth that were not measured whole, and so many broken ones that the whole ones are no longer distinguishable.
fn of_teeth(found: &Judged<'_>, measurement: &Measurement, verdict: &mut Verdict) {
    let incomplete = measurement.measured.incomplete();
    if !incomplete.is_empty() {
        let text = format!(
            "{} of {} did not switch the light barrier on every track: {}",
            counted_teeth(incomplete.len()),
            found.prepared.bodies.teeth(),
            numbers(&incomplete)
        );
        let item = format!("teeth without a switch: {}", numbers(&incomplete));
        let way_out = "look whether these teeth are broken off, else measure again";
        verdict.owe(item, Remark::new("switches-missing", text, way_out));
    }
    let broken = &measurement.evaluation.mounting.left_out;
    if PER_BROKEN * broken.len() > found.prepared.bodies.teeth() {
        let text = format!(
            "{} of {} are outliers: which of them are whole is no longer certain",
            counted_teeth(broken.len()),
            found.prepared.bodies.teeth()
        );
        let way_out = "grind the tool again, or check `gear`, `skiving_tool` and the readings";
        verdict.owe("mounting and correction", Remark::new("too-many-broken", text, way_out));
    }
}

/// What is proven of a program, by what it is for.
fn of_program(file: &str) -> &'static str {
    if file.contains("/calibration-") {
        "ways and switches"
    } else if file.contains("/workpiece-") {
        "ball and flanks"
    } else if file.contains("/skiving-") {
        "coupling, law and flank"
    } else {
        "poses and turns"
    }
}

/// Numbers of teeth in words.
fn numbers(teeth: &[usize]) -> String {
    let list: Vec<String> = teeth.iter().map(ToString::to_string).collect();
    list.join(", ")
}

fn counted_teeth(count: usize) -> String {
    if count == 1 { "1 tooth".into() } else { format!("{count} teeth") }
}

fn counted(count: usize, what: &str) -> String {
    if count == 1 { format!("one {what}") } else { format!("{count} {what}s") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_guard_band_is_two_standard_deviations_of_one_figure_and_four_of_a_whole_tool() {
        assert!((guard_factor(1) - 1.959964).abs() < 1e-5);
        assert!((guard_factor(750) - 3.987).abs() < 1e-2);
    }

    #[test]
    fn a_figure_is_within_beyond_or_neither() {
        assert_eq!(place(3.0, 4.0, 0.9), Place::Within);
        assert_eq!(place(3.9, 4.0, 0.9), Place::Within);
        assert_eq!(place(4.8, 4.0, 0.9), Place::Unsure);
        assert_eq!(place(5.0, 4.0, 0.9), Place::Beyond);
        assert_eq!(place(4.0, 4.0, 0.0), Place::Within);
    }
}
