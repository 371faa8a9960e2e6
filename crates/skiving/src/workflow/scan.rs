//! A stylus that scans the edges: the axes along the curve, and what it would find on the teeth of a simulated tool.

use super::finding::failure;
use super::measurement::Measurement;
use super::prepare::SkivingBodies;
use super::result::{ScanPlaceResult, ScanResult};
use crate::job::{ScanMotion, Stylus};
use crate::measuring::{Barrier, Beam, RealTool, ScanAxes, ScanPlace, check_pose, nominal_angle, scan_curve};
use crate::{SkivingError, VirtualEdge};
use foundation::geometry::Sides;
use foundation::numerics::wrapped_angle;
use nalgebra::Vector3;
use run::RunFailure;

/// A scan of both edges.
#[derive(Clone, Debug)]
pub struct Scan {
    /// The stylus.
    pub stylus: Beam,
    /// Axes that follow.
    pub axes: ScanAxes,
    /// From where to where along the edge, x.
    pub range: [f64; 2],
    /// Places of the edges.
    pub places: Sides<Vec<ScanPlace>>,
    /// Figures.
    pub result: ScanResult,
}

/// How much of the edge a scan leaves out at each end, in shares of half its length: a worn tooth touches a little beside the place.
const ENDS: f64 = 0.05;

/// Lays a scan over both edges.
///
/// # Errors
/// [`RunFailure`] where the stylus cannot be laid along an edge.
pub(super) fn scan(
    bodies: &SkivingBodies,
    given: &Stylus,
    measurement: Option<&Measurement>,
) -> Result<Scan, RunFailure> {
    let on = |error: SkivingError| {
        let field = match &error {
            SkivingError::AxisLimit { .. } => "measuring.travel",
            SkivingError::Shadowed { .. } | SkivingError::BodyTouched { .. } => "stylus.radius",
            _ => "stylus",
        };
        match failure(&error) {
            RunFailure::BadInput(finding) => RunFailure::bad_input(finding.field(field)),
            RunFailure::NotProducible(finding) => RunFailure::not_producible(finding.field(field)),
        }
    };
    let tilts = [given.tilt_x_deg, given.tilt_y_deg].map(f64::to_radians);
    let stylus = Beam::new(Vector3::from(given.point), tilts, given.radius).map_err(on)?;
    let axes = match given.axes {
        ScanMotion::All => ScanAxes::All,
        ScanMotion::WithoutY => ScanAxes::WithoutY,
    };
    let ends = [ENDS - 1.0, 1.0 - ENDS];
    let places =
        Sides::try_from_fn(|flank| scan_curve(&bodies.edges[flank], &stylus, axes, ends, given.places))
            .map_err(on)?;
    for (flank, curve) in places.iter() {
        for (number, place) in curve.iter().enumerate() {
            check_pose(&bodies.edges, &place.track, &place.pose, &stylus, &bodies.limits, (flank, number))
                .map_err(on)?;
        }
    }
    let tool = measurement.and_then(|m| m.tool.as_ref());
    let mut rows = Vec::new();
    for (flank, curve) in places.iter() {
        for place in curve {
            let found = |tooth: &usize| {
                tool.map(|tool| deflection(&bodies.edges[flank], &stylus, place, tool, *tooth))
            };
            let deviations = given.teeth.iter().filter_map(found).collect::<Result<Vec<f64>, _>>();
            let pose = &place.pose;
            rows.push(ScanPlaceResult {
                flank: flank.name(),
                place: place.track.place,
                w_mm: place.track.contact.w,
                a_deg: pose.swivel.to_degrees(),
                b_deg: pose.turn.to_degrees(),
                position_mm: pose.position.into(),
                off_flank_deg: pose.off_flank.to_degrees(),
                deviation_um: deviations.map_err(on)?.into_iter().map(|f| 1e3 * f).collect(),
            });
        }
    }
    let result = ScanResult { teeth: given.teeth.clone(), places: rows };
    Ok(Scan { stylus, axes, range: ends, places, result })
}

/// f = -L dB with the stylus held on the edge by B (`docs/mathematics/skiving.md#tracks-and-poses`).
fn deflection(
    edge: &VirtualEdge,
    stylus: &Beam,
    place: &ScanPlace,
    tool: &RealTool,
    tooth: usize,
) -> Result<f64, SkivingError> {
    let barrier = Barrier { beam: stylus, pose: &place.pose };
    let touch = barrier.touch(edge, tool, &place.track, tooth, stylus.radius)?;
    let nominal = nominal_angle(&place.pose, tooth, tool.teeth());
    Ok(-place.track.contact.lever * wrapped_angle(touch.turn - nominal))
}
