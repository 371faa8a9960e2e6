//! Switching angles of a tooth, about the middle of the nominal tooth.

use crate::MeasuringTrack;
use crate::evaluation::Evaluation;
use crate::workflow::SkivingBodies;
use foundation::geometry::{Flank, Sides};
use foundation::numerics::{equidistant, power_series};
use report::charts::{ChartError, check_values, round_below};

/// Places along the drawn edge.
const STATIONS: usize = 41;
/// Share of the tooth's width that the largest deviation takes when it is magnified.
const SHARE: f64 = 0.1;

/// A tooth with its edges.
pub(super) struct SwitchingAngles {
    /// Its number.
    pub tooth: usize,
    /// D: width of the tolerance band, um.
    pub band_um: f64,
    pub edges: Sides<EdgeAngles>,
}

/// An edge.
pub(super) struct EdgeAngles {
    /// The nominal edge, closely, ascending in x.
    pub stations: Vec<Station>,
    /// Its tracks, ascending in x.
    pub tracks: Vec<TrackAngles>,
}

/// A place of the nominal edge.
#[derive(Clone, Copy)]
pub(super) struct Station {
    /// R, mm.
    pub radius_mm: f64,
    /// F of the ideal tool, deg.
    pub nominal_deg: f64,
    /// Compensation curve less the ideal tool, deg.
    pub curve_deg: f64,
    /// Angle of D/2, deg.
    pub half_band_deg: f64,
}

/// A track of the edge.
#[derive(Clone, Copy)]
pub(super) struct TrackAngles {
    /// R, mm.
    pub radius_mm: f64,
    /// F of the ideal tool, deg.
    pub nominal_deg: f64,
    /// F as measured, deg.
    pub measured_deg: f64,
}

impl TrackAngles {
    /// Measured less nominal, deg.
    pub fn offset(&self) -> f64 {
        self.measured_deg - self.nominal_deg
    }
}

impl SwitchingAngles {
    /// Of a measured tooth.
    pub fn new(bodies: &SkivingBodies, evaluation: &Evaluation, tooth: usize) -> Self {
        let band = bodies.options.band;
        let edge = |flank: Flank| {
            let of = &bodies.flanks[flank];
            let station = |x: f64| {
                let track = MeasuringTrack::new(&of.edge, x).ok()?;
                let lever = track.contact.lever;
                Some(Station {
                    radius_mm: track.radius(),
                    nominal_deg: switch(&track).to_degrees(),
                    curve_deg: (-power_series(&evaluation.profile.curve[flank], x)[0] / lever).to_degrees(),
                    half_band_deg: (0.5 * band / lever.abs()).to_degrees(),
                })
            };
            let of_track = |(number, (track, _)): (usize, &(MeasuringTrack, _))| {
                let angle = evaluation.remaining.of[flank][number][tooth] / track.contact.lever;
                TrackAngles {
                    radius_mm: track.radius(),
                    nominal_deg: switch(track).to_degrees(),
                    measured_deg: (switch(track) - angle).to_degrees(),
                }
            };
            EdgeAngles {
                stations: equidistant([-1.0, 1.0], STATIONS).into_iter().filter_map(station).collect(),
                tracks: of.tracks.iter().enumerate().map(of_track).collect(),
            }
        };
        Self { tooth, band_um: 1e3 * band, edges: Sides::from_fn(edge) }
    }

    /// A round number that makes deviations visible.
    pub fn magnification(&self) -> Result<f64, ChartError> {
        let mut width = [f64::INFINITY, f64::NEG_INFINITY];
        let mut largest: f64 = 0.0;
        for (flank, edge) in self.edges.iter() {
            for station in &edge.stations {
                let Station { radius_mm, nominal_deg, curve_deg, half_band_deg } = *station;
                let offset = curve_deg.abs() + half_band_deg.abs();
                check_values(&format!("{flank} edge"), &[radius_mm, nominal_deg, offset])?;
                width = [width[0].min(nominal_deg), width[1].max(nominal_deg)];
                largest = largest.max(offset);
            }
            for track in &edge.tracks {
                let offset = track.offset();
                let values = [track.radius_mm, track.nominal_deg, offset];
                check_values(&format!("{flank} edge, tracks"), &values)?;
                largest = largest.max(offset.abs());
            }
        }
        let room = SHARE * (width[1] - width[0]);
        Ok(if largest > 0.0 && room > largest { round_below(room / largest) } else { 1.0 })
    }

    /// From the one nominal edge to the other, deg.
    pub fn width(&self) -> f64 {
        let angles = || self.edges.iter().flat_map(|(_, edge)| edge.stations.iter().map(|s| s.nominal_deg));
        let (lo, hi) = angles().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)));
        if lo < hi { hi - lo } else { 1.0 }
    }
}

/// Turn of the spindle at which the contact point passes where the middle of the tooth stands at 0: the negative of its own angle, rad.
fn switch(track: &MeasuringTrack) -> f64 {
    let m = &track.contact.point;
    m.x.atan2(m.y)
}
