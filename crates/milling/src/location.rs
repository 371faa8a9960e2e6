//! Where the cutter stands to touch the flank at a point (`docs/mathematics/milling.md#cutter-location`): its axis in the column plane and
//! perpendicular to the normal, tilted or leant if wanted, its tip from the part of the cutter that touches.

use super::touch_fault::TouchFault;
use super::{LeadPoint, MillingError};
use foundation::geometry::{CutterShape, SurfaceJet};
use nalgebra::{Rotation3, Unit, Vector3};

/// How the axis is turned against its natural place. rad.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Orientation {
    /// > 0 leans the shank away from the flank, within the column plane.
    pub tilt: f64,
    /// Turn of the axis about the flank's normal; the axis leaves the column plane by that.
    pub lead_angle: f64,
}

/// The part of a cutter that touches.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ContactZone {
    /// The straight side of a cylinder or cone.
    Side,
    /// The rounded corner, or the ball.
    Corner,
    /// The arc of a barrel.
    Barrel,
}

/// A cutter in contact with the flank. mm, workpiece coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CutterLocation {
    /// T: the tip, on the axis.
    pub tip: Vector3<f64>,
    /// a: the axis, towards the shank, a unit vector.
    pub axis: Vector3<f64>,
    /// e: from the axis to the contact point, a unit vector perpendicular to the axis.
    pub radial: Vector3<f64>,
    /// mu: angle between the axis and the flank's tangent plane within the column plane, rad.
    pub tilt: f64,
    /// asin(a.t): how far the axis has left the column plane, rad; 0 without a lead angle.
    pub out_of_plane: f64,
    /// What touches.
    pub zone: ContactZone,
    /// Radius of the cutter at the contact, mm.
    pub contact_radius: f64,
    /// Height of the contact above the tip, mm.
    pub contact_height: f64,
}

/// How far the axis may lie off the tangent plane where a straight side is to touch: its sine.
const FLAT: f64 = 1e-9;

impl CutterLocation {
    /// The place of a cutter that touches at a point of a column; `height` is that of the contact on a straight side and of no
    /// meaning for corners, balls and barrels.
    ///
    /// # Errors
    /// [`MillingError::AxisNone`] where no axis in the plane has the wanted angle; [`MillingError::ContactOffTool`] where that part of the
    /// cutter does not reach.
    pub fn new(
        jet: &SurfaceJet,
        lead: &LeadPoint,
        shape: &CutterShape,
        cutting_length: f64,
        height: f64,
        orientation: Orientation,
    ) -> Result<Self, MillingError> {
        let (normal, direction) = (&jet.normal, &lead.direction);
        let across = normal.dot(direction);
        let in_plane = (1.0 - across * across).sqrt();
        let half_angle = match shape {
            CutterShape::Conical { half_angle, .. } => *half_angle,
            CutterShape::Barrel { .. } => 0.0,
        };
        let sine = half_angle.sin() / in_plane;
        if sine.is_nan() || sine.abs() > 1.0 {
            return Err(MillingError::AxisNone { u: lead.u, half_angle, out_of_plane: across.asin() });
        }
        let projected = (normal - direction * across) / in_plane;
        // The shank stands away from the base body.
        let upright = normal.cross(direction) / in_plane;
        let upright = if upright.dot(&lead.base_normal) < 0.0 { -upright } else { upright };
        let tilt = sine.asin() + orientation.tilt;
        let mut axis = upright * tilt.cos() + projected * tilt.sin();
        if orientation.lead_angle != 0.0 {
            axis = Rotation3::from_axis_angle(&Unit::new_unchecked(*normal), orientation.lead_angle) * axis;
        }
        let touch = Touch::on(shape, cutting_length, normal, &axis, height)
            .map_err(|fault| MillingError::ContactOffTool { u: lead.u, fault })?;
        let radial = -(normal - axis * normal.dot(&axis)).normalize();
        Ok(Self {
            tip: jet.point - radial * touch.radius - axis * touch.height,
            axis,
            radial,
            tilt,
            out_of_plane: axis.dot(direction).asin(),
            zone: touch.zone,
            contact_radius: touch.radius,
            contact_height: touch.height,
        })
    }
}

/// A point of a cutter's profile.
struct Touch {
    zone: ContactZone,
    radius: f64,
    height: f64,
}

impl Touch {
    /// The profile's point whose outward normal is -n. Radius and height.
    fn on(
        shape: &CutterShape,
        cutting_length: f64,
        normal: &Vector3<f64>,
        axis: &Vector3<f64>,
        height: f64,
    ) -> Result<Self, TouchFault> {
        // The outward normal of the cutter is m = -n; its part along the axis and across.
        let along = -normal.dot(axis);
        let across = (1.0 - along * along).max(0.0).sqrt();
        match *shape {
            CutterShape::Conical { radius, half_angle, corner_radius } => {
                let (sin, cos) = half_angle.sin_cos();
                // Of the corner's circle; the side begins where its normal does.
                let circle = radius + (sin - 1.0) * corner_radius / cos;
                let off_side = along + sin;
                if shape.is_ball() && along <= FLAT {
                    return Ok(Self {
                        zone: ContactZone::Corner,
                        radius: radius * across,
                        height: radius * (1.0 + along),
                    });
                }
                if off_side.abs() < FLAT {
                    let allowed = [corner_radius * (1.0 - sin), cutting_length];
                    if !(allowed[0]..=allowed[1]).contains(&height) {
                        return Err(TouchFault::Height { height, allowed });
                    }
                    return Ok(Self {
                        zone: ContactZone::Side,
                        radius: radius + height * half_angle.tan(),
                        height,
                    });
                }
                if off_side > 0.0 {
                    return Err(TouchFault::UpperEdge { angle: off_side.min(1.0).asin() });
                }
                if corner_radius == 0.0 {
                    return Err(TouchFault::SharpCorner);
                }
                Ok(Self {
                    zone: ContactZone::Corner,
                    radius: circle + corner_radius * across,
                    height: corner_radius * (1.0 + along),
                })
            }
            CutterShape::Barrel { radius, height: largest, profile_radius } => {
                let at = largest + profile_radius * along;
                let allowed = [0.0, cutting_length];
                if !(allowed[0]..=allowed[1]).contains(&at) {
                    return Err(TouchFault::Arc { height: at, allowed });
                }
                Ok(Self {
                    zone: ContactZone::Barrel,
                    radius: radius - profile_radius + profile_radius * across,
                    height: at,
                })
            }
        }
    }
}
