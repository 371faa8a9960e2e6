//! Where single teeth switch over the radius, beside the nominal edge: angles about the middle of the tooth.

use crate::MeasuringTrack;
use crate::page::{AngleEdge, AngleStation, AngleTrack, AngleView};
use crate::workflow::run::SkivingOutcome;
use foundation::geometry::{Flank, Sides};
use foundation::numerics::{equidistant, power_series};

/// Places along the drawn edge.
const STATIONS: usize = 41;

/// Tooth 0, and the tooth that leaves its band the farthest, if one does.
pub(super) fn angles(outcome: &SkivingOutcome) -> Vec<AngleView> {
    let Some(measured) = &outcome.result.measurement else { return Vec::new() };
    let out = &measured.profile.out_of_band;
    let farthest = out.iter().max_by(|a, b| a.off_um.total_cmp(&b.off_um)).map(|found| found.tooth);
    let mut teeth = vec![0];
    teeth.extend(farthest.filter(|tooth| *tooth != 0));
    teeth.into_iter().map(|tooth| view(outcome, tooth)).collect()
}

fn view(outcome: &SkivingOutcome, tooth: usize) -> AngleView {
    let band = outcome.bodies.options.band;
    let edge = |flank: Flank| {
        let of = &outcome.bodies.flanks[flank];
        let evaluation = outcome.measurement.as_ref().map(|m| &m.evaluation);
        let station = |x: f64| {
            let track = MeasuringTrack::new(&of.edge, x).ok()?;
            let lever = track.contact.lever;
            Some(AngleStation {
                radius_mm: track.radius(),
                nominal_deg: switch(&track).to_degrees(),
                curve_deg: evaluation
                    .map(|e| (-power_series(&e.profile.curve[flank], x)[0] / lever).to_degrees()),
                half_band_deg: Some((0.5 * band / lever.abs()).to_degrees()),
            })
        };
        let of_track = |(number, (track, _)): (usize, &(MeasuringTrack, _))| AngleTrack {
            radius_mm: track.radius(),
            nominal_deg: switch(track).to_degrees(),
            measured_deg: evaluation.map(|e| {
                let angle = e.remaining.of[flank][number][tooth] / track.contact.lever;
                (switch(track) - angle).to_degrees()
            }),
        };
        AngleEdge {
            stations: equidistant([-1.0, 1.0], STATIONS).into_iter().filter_map(station).collect(),
            tracks: of.tracks.iter().enumerate().map(of_track).collect(),
        }
    };
    AngleView { tooth, band_um: Some(1e3 * band), edges: Sides::from_fn(edge) }
}

/// Turn of the spindle at which the contact point passes where the middle of the tooth stands at 0: the negative of its own angle, rad.
fn switch(track: &MeasuringTrack) -> f64 {
    let m = &track.contact.point;
    m.x.atan2(m.y)
}
