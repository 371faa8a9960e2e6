//! Arcs and straight pieces on which the cutter comes to a row and leaves it, beside the overrun
//! (`docs/mathematics/milling.md#positions-of-five-axes`).

use super::{CutterPath, CutterPlace, MillingError, Patch};
use foundation::geometry::Cutter;
use nalgebra::Vector3;
use std::f64::consts::FRAC_PI_2;

/// How far straight blocks leave the quarter circle, mm: the accuracy of a machine. The circle curves away from the flank, so that its
/// chords lie farther from the flank than the circle: whatever this is, it costs no material.
const CHORD: f64 = 1e-3;

/// How a cutter comes to a row or, the other way round, leaves it: straight, then on an arc that touches the row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LeadArc {
    /// rho_A: radius of the arc, mm.
    pub radius: f64,
    /// Angle of the arc, rad, up to a quarter turn.
    pub angle: f64,
    /// Length of the straight piece, which touches the arc, mm.
    pub straight: f64,
}

impl LeadArc {
    /// A quarter circle, mm.
    pub const fn quarter(radius: f64) -> Self {
        Self { radius, angle: FRAC_PI_2, straight: 0.0 }
    }

    /// How far aside of the row it begins, mm.
    pub fn aside(&self) -> f64 {
        self.radius * (1.0 - self.angle.cos()) + self.straight * self.angle.sin()
    }
}

/// Arcs at the ends of rows.
pub(super) struct ApproachArcs<'a> {
    /// Before the first place of a path in the order of its columns, and behind the last one.
    pub leads: [Option<LeadArc>; 2],
    /// The cutter.
    pub cutter: &'a Cutter,
    /// The flank across the space.
    pub opposite: Option<Patch<'a>>,
    /// What the cutter keeps from it, mm.
    pub safety: f64,
}

impl ApproachArcs<'_> {
    /// A path of two places or more with an arc before its first and one behind its last place, where the flank's unit normal there is
    /// given.
    ///
    /// # Errors
    /// [`MillingError::Approach`].
    pub fn around(
        &self,
        path: CutterPath,
        [first, last]: [Option<Vector3<f64>>; 2],
    ) -> Result<CutterPath, MillingError> {
        let [begin, next, ..] = path.places[..] else { return Ok(path) };
        let [.., before, end] = path.places[..] else { return Ok(path) };
        let arc = |lead: Option<LeadArc>, [at, towards]: [CutterPlace; 2], normal: Option<Vector3<f64>>| {
            let Some((lead, normal)) = lead.zip(normal) else { return Ok(Vec::new()) };
            let way = towards.tip - at.tip;
            let travel = (way - normal * way.dot(&normal)).normalize();
            approach_arc(&at, &travel, &normal, &lead, self.room(&at))
        };
        let mut places = arc(self.leads[0], [begin, next], first)?;
        let departure = arc(self.leads[1], [end, before], last)?;
        places.extend(path.places);
        places.extend(departure.into_iter().rev());
        Ok(CutterPath { places })
    }

    /// What a cutter is free to move before it comes too near to the opposite flank, mm.
    fn room(&self, at: &CutterPlace) -> f64 {
        let clearance = |patch: &Patch| patch.clearance(self.cutter, &at.tip, &at.axis).value - self.safety;
        self.opposite.as_ref().map_or(f64::INFINITY, clearance)
    }
}

/// The way on which the cutter comes to the first place of a path, its axis as there, the place itself not included; the other
/// way round it is the departure from the last one. `travel` is the feed there, `normal` the flank's, both units; `room` is what the
/// cutter is free to move there, mm. The contact of a place is the point of the cutter that will touch.
///
/// # Errors
/// [`MillingError::Approach`] if the circle does not fit.
pub fn approach_arc(
    place: &CutterPlace,
    travel: &Vector3<f64>,
    normal: &Vector3<f64>,
    lead: &LeadArc,
    room: f64,
) -> Result<Vec<CutterPlace>, MillingError> {
    let LeadArc { radius, angle, straight } = *lead;
    let aside = lead.aside();
    // Written so that NaN fails.
    let fits = aside < room;
    if !fits {
        return Err(MillingError::Approach { aside, room });
    }
    // A chord over the angle x leaves its circle by radius (1 - cos(x/2)).
    let widest = 2.0 * (1.0 - CHORD / radius).max(-1.0).acos();
    let pieces = (angle / widest).ceil().max(1.0) as usize;
    let away = |(sin, cos): (f64, f64), straight: f64| {
        normal * (radius * (1.0 - cos) + straight * sin) - travel * (radius * sin + straight * cos)
    };
    let at = |away: Vector3<f64>| {
        let contact = place.contact.map(|contact| contact + away);
        CutterPlace { tip: place.tip + away, contact, ..*place }
    };
    let begin = (straight > 0.0).then(|| at(away(angle.sin_cos(), straight)));
    let arc =
        (0..pieces).map(|piece| at(away((angle * (1.0 - piece as f64 / pieces as f64)).sin_cos(), 0.0)));
    Ok(begin.into_iter().chain(arc).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn straight() -> CutterPath {
        let place = |k: f64| CutterPlace {
            tip: Vector3::new(0.0, 0.0, 3.0 * k),
            axis: Vector3::y(),
            contact: Some(Vector3::new(-2.0, 4.0, 3.0 * k)),
        };
        CutterPath { places: [0.0, 1.0, 2.0].map(place).to_vec() }
    }

    #[test]
    fn arcs_lead_tangentially_into_the_row_and_out_of_it() {
        let cutter =
            Cutter::new(foundation::geometry::CutterShape::end_mill(2.0, 0.5), 10.0, vec![]).unwrap();
        let leads = [Some(LeadArc::quarter(0.8)); 2];
        let arcs = ApproachArcs { leads, cutter: &cutter, opposite: None, safety: 0.2 };
        let normal = Vector3::x();
        let path = arcs.around(straight(), [Some(normal); 2]).unwrap().places;
        let one = (path.len() - 3) / 2;
        assert_eq!(path[one..one + 3], straight().places);
        // It begins a radius off the flank and a radius before the row, and ends likewise.
        for (at, z) in [(path[0], -0.8), (path[path.len() - 1], 6.8)] {
            assert!((at.tip - Vector3::new(0.8, 0.0, z)).norm() < 1e-15, "{at:?}");
            assert!((at.contact.unwrap() - at.tip - Vector3::new(-2.0, 4.0, 0.0)).norm() < 1e-15);
        }
        let centres = [Vector3::new(0.8, 0.0, 0.0), Vector3::new(0.8, 0.0, 6.0)];
        for (arc, centre) in [(&path[..=one], centres[0]), (&path[one + 2..], centres[1])] {
            for pair in arc.windows(2) {
                assert!(((pair[0].tip - centre).norm() - 0.8).abs() < 1e-15);
                let sag = 0.8 - (0.5 * (pair[0].tip + pair[1].tip) - centre).norm();
                assert!(sag > 0.0 && sag <= CHORD, "{sag}");
            }
        }
        // The last chord turns off the row by half of a piece, all others by a whole one.
        let chord = (path[one].tip - path[one - 1].tip).normalize();
        let piece = FRAC_PI_2 / one as f64;
        assert!((chord.x.abs().atan2(chord.z) - 0.5 * piece).abs() < 1e-12, "{chord} {piece}");
    }

    #[test]
    fn an_arc_that_does_not_fit_is_refused_with_its_numbers() {
        let at = straight().places[0];
        let arc = |lead: LeadArc| approach_arc(&at, &Vector3::z(), &Vector3::x(), &lead, 0.8);
        let refused = arc(LeadArc::quarter(0.81));
        let Err(MillingError::Approach { aside, room: 0.8 }) = refused else { panic!("{refused:?}") };
        assert!((aside - 0.81).abs() < 1e-15);
        assert!(arc(LeadArc::quarter(f64::NAN)).is_err());
        assert!(arc(LeadArc::quarter(0.79)).is_ok());
        // Shorter than what a chord may be off: one straight block.
        assert_eq!(arc(LeadArc::quarter(4e-4)).unwrap().len(), 1);
    }

    #[test]
    fn a_straight_piece_goes_on_where_the_arc_points() {
        let at = straight().places[0];
        let lead = LeadArc { radius: 2.0, angle: 0.5, straight: 1.5 };
        let places = approach_arc(&at, &Vector3::z(), &Vector3::x(), &lead, 10.0).unwrap();
        let [begin, arc] = [places[0].tip, places[1].tip].map(|tip| tip - at.tip);
        // The arc's centre is a radius off the row; the piece stands across its radius.
        let centre = Vector3::new(2.0, 0.0, 0.0);
        assert!(((arc - centre).norm() - 2.0).abs() < 1e-14 && ((begin - arc).norm() - 1.5).abs() < 1e-14);
        assert!((begin - arc).dot(&(arc - centre)).abs() < 1e-14);
        assert!((begin.x - lead.aside()).abs() < 1e-14, "{begin}");
        // Into the flank it never goes.
        assert!(places.iter().all(|place| (place.tip - at.tip).x > 0.0));
    }
}
