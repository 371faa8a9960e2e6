//! Quarter circles on which the cutter comes to a row and leaves it, instead of over the overrun
//! (`docs/mathematics/milling.md#positions-of-five-axes`).

use super::{CutterPath, CutterPlace, MillingError, Patch};
use foundation::geometry::Cutter;
use nalgebra::Vector3;
use std::f64::consts::FRAC_PI_2;

/// How far straight blocks leave the quarter circle, mm: the accuracy of a machine. The circle curves away from the flank, so that its
/// chords lie farther from the flank than the circle: whatever this is, it costs no material.
const CHORD: f64 = 1e-3;

/// Arcs at the ends of rows.
pub(super) struct ApproachArcs<'a> {
    /// rho_A, mm.
    pub radius: f64,
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
        let arc = |[at, towards]: [CutterPlace; 2], normal: Option<Vector3<f64>>| {
            let Some(normal) = normal else { return Ok(Vec::new()) };
            let way = towards.tip - at.tip;
            let travel = (way - normal * way.dot(&normal)).normalize();
            approach_arc(&at, &travel, &normal, self.radius, self.room(&at))
        };
        let mut places = arc([begin, next], first)?;
        let departure = arc([end, before], last)?;
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

/// A quarter circle on which the cutter comes to the first place of a path, its axis as there, the place itself not included; the other
/// way round it is the departure from the last one. `travel` is the feed there, `normal` the flank's, both units; `room` is what the
/// cutter is free to move there, mm. The contact of a place is the point of the cutter that will touch.
///
/// # Errors
/// [`MillingError::Approach`] if the circle does not fit.
pub fn approach_arc(
    place: &CutterPlace,
    travel: &Vector3<f64>,
    normal: &Vector3<f64>,
    radius: f64,
    room: f64,
) -> Result<Vec<CutterPlace>, MillingError> {
    if radius.is_nan() || radius >= room {
        return Err(MillingError::Approach { radius, room });
    }
    // A chord over the angle x leaves its circle by radius (1 - cos(x/2)).
    let widest = 2.0 * (1.0 - CHORD / radius).max(-1.0).acos();
    let pieces = (FRAC_PI_2 / widest).ceil().max(1.0) as usize;
    let at = |piece: usize| {
        let (sin, cos) = (FRAC_PI_2 * (1.0 - piece as f64 / pieces as f64)).sin_cos();
        let away = normal * (radius * (1.0 - cos)) - travel * (radius * sin);
        let contact = place.contact.map(|contact| contact + away);
        CutterPlace { tip: place.tip + away, contact, ..*place }
    };
    Ok((0..pieces).map(at).collect())
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
        let arcs = ApproachArcs { radius: 0.8, cutter: &cutter, opposite: None, safety: 0.2 };
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
        let refused = approach_arc(&at, &Vector3::z(), &Vector3::x(), 0.8, 0.8);
        assert_eq!(refused, Err(MillingError::Approach { radius: 0.8, room: 0.8 }));
        assert!(approach_arc(&at, &Vector3::z(), &Vector3::x(), f64::NAN, 0.8).is_err());
        assert!(approach_arc(&at, &Vector3::z(), &Vector3::x(), 0.79, 0.8).is_ok());
        // Shorter than what a chord may be off: one straight block.
        assert_eq!(approach_arc(&at, &Vector3::z(), &Vector3::x(), 4e-4, 0.8).unwrap().len(), 1);
    }
}
