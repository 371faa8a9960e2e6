//! Deviations of all teeth, pitch and mounting for the page.

use crate::MeasuringTrack;
use crate::page::{FlankDeviations, MeasuredView, PitchView, TrackDeviations, UncertainFigure, WorstTooth};
use crate::workflow::measurement::Measurement;
use crate::workflow::prepare::SkivingBodies;
use crate::workflow::result::SkivingResult;
use crate::workflow::run::SkivingOutcome;
use foundation::geometry::{Flank, Sides};
use foundation::numerics::power_series;

/// Rows of the table of teeth to look at.
const WORST: usize = 12;

/// Deviations of all teeth on all tracks.
pub(super) fn deviations(bodies: &SkivingBodies, m: &Measurement, result: &SkivingResult) -> MeasuredView {
    let evaluation = &m.evaluation;
    let um = |values: &[f64]| -> Vec<f64> { values.iter().map(|mm| 1e3 * mm).collect() };
    let of_flank = |flank: Flank| {
        let of_track = |(number, (track, _)): (usize, &(MeasuringTrack, _))| TrackDeviations {
            place: track.place,
            curve_um: 1e3 * power_series(&evaluation.profile.curve[flank], track.place)[0],
            measured_um: um(&evaluation.clocked.of[flank][number]),
            remaining_um: um(&evaluation.remaining.of[flank][number]),
        };
        FlankDeviations { tracks: bodies.flanks[flank].tracks.iter().enumerate().map(of_track).collect() }
    };
    let band = result.measurement.as_ref().map(|measured| measured.profile.band_um);
    MeasuredView { flanks: Sides::from_fn(of_flank), band_um: band, worst: worst(bodies, m) }
}

/// Teeth by their largest distance from the compensation curve.
fn worst(bodies: &SkivingBodies, m: &Measurement) -> Vec<WorstTooth> {
    let evaluation = &m.evaluation;
    let mut all = Vec::new();
    for flank in Flank::BOTH {
        for tooth in 0..bodies.teeth() {
            let off = |number: usize, track: &MeasuringTrack| {
                let curve = power_series(&evaluation.profile.curve[flank], track.place)[0];
                1e3 * (evaluation.remaining.of[flank][number][tooth] - curve)
            };
            let tracks = bodies.flanks[flank].tracks.iter().enumerate();
            let found = tracks
                .map(|(number, (track, _))| (number + 1, off(number, track)))
                .max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
            all.extend(found.map(|(track, off)| (flank, tooth, track, off)));
        }
    }
    all.sort_by(|a, b| b.3.abs().total_cmp(&a.3.abs()));
    let incomplete = m.measured.incomplete();
    all.retain(|(_, tooth, ..)| !incomplete.contains(tooth));
    let out = |flank: Flank, tooth: usize| evaluation.profile.out_of_band.contains(&(flank, tooth));
    let left_out = |tooth: usize| evaluation.mounting.left_out.contains(&tooth);
    let marked = all.iter().filter(|(flank, tooth, ..)| out(*flank, *tooth) || left_out(*tooth)).take(WORST);
    let lacking = incomplete.iter().take(WORST).map(|&tooth| WorstTooth {
        tooth,
        flank: None,
        track: None,
        from_curve_um: None,
        why: "did not switch on every track; the lines show the mean tooth where it lacks".into(),
    });
    let mut rows: Vec<WorstTooth> = lacking.collect();
    let marked = marked.map(|&(flank, tooth, track, off)| WorstTooth {
        tooth,
        flank: Some(flank),
        track: Some(track),
        from_curve_um: Some(off),
        why: match (out(flank, tooth), left_out(tooth)) {
            (true, true) => "out of the band; left out of means, mounting and correction",
            (true, false) => "out of the band",
            _ => "outlier; left out of means, mounting and correction",
        }
        .into(),
    });
    rows.extend(marked);
    for flank in Flank::BOTH {
        let largest = all.iter().find(|(f, tooth, ..)| *f == flank && !out(*f, *tooth) && !left_out(*tooth));
        rows.extend(largest.map(|&(_, tooth, track, off)| WorstTooth {
            tooth,
            flank: Some(flank),
            track: Some(track),
            from_curve_um: Some(off),
            why: "largest of the others on its flank".into(),
        }));
    }
    rows
}

/// Pitch and mounting.
pub(super) fn pitch(outcome: &SkivingOutcome) -> Option<PitchView> {
    let m = outcome.measurement.as_ref()?;
    let result = outcome.result.measurement.as_ref()?;
    let middle = outcome.bodies.flanks.left.tracks.len() / 2;
    let radius = |flank: Flank| outcome.bodies.flanks[flank].tracks[middle].0.radius();
    let radius_mm = 0.5 * (radius(Flank::Left) + radius(Flank::Right));
    let of_angle = |angle: f64| 1e3 * radius_mm * angle;
    let figure = |name: &str, symbol: &str, value: f64, unit: &str, deviation: Option<f64>| UncertainFigure {
        name: name.into(),
        symbol: symbol.into(),
        value,
        unit: unit.into(),
        deviation,
    };
    let spread = |name: &str| {
        let found = outcome.result.monte_carlo.as_ref()?.results.iter().find(|r| r.name == name)?;
        Some(found.sigma)
    };
    let mounting = &result.mounting;
    let [e, om] = [mounting.eccentricity_sigma_um, mounting.wobble_sigma_urad];
    let um = |values: &[f64]| -> Vec<f64> { values.iter().map(|mm| 1e3 * mm).collect() };
    let centre_um: Vec<f64> = m.evaluation.pitch.centres[middle].iter().map(|a| of_angle(*a)).collect();
    Some(PitchView {
        radius_mm,
        single_um: um(&m.evaluation.pitch.single),
        cumulative_um: um(&m.evaluation.pitch.cumulative),
        centre_um,
        harmonic_um: m.evaluation.pitch.first_harmonic.map(of_angle),
        outliers: mounting.left_out.clone(),
        figures: vec![
            figure("total cumulative pitch deviation", "F_p", result.pitch.total_um, "µm", spread("F_p")),
            figure(
                "largest single pitch deviation",
                "f_pmax",
                result.pitch.largest_single_um,
                "µm",
                spread("f_p,max"),
            ),
            figure("first harmonic of the tooth centres", "", result.pitch.first_harmonic_um, "µm", None),
            figure("eccentricity", "e_x", mounting.eccentricity_um[0], "µm", e.map(|s| s[0])),
            figure("eccentricity", "e_y", mounting.eccentricity_um[1], "µm", e.map(|s| s[1])),
            figure("wobble", "ω_x", mounting.wobble_urad[0], "µrad", om.map(|s| s[0])),
            figure("wobble", "ω_y", mounting.wobble_urad[1], "µrad", om.map(|s| s[1])),
        ],
    })
}
