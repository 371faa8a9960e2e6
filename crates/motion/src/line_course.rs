//! The disc of line dressing on one line of the worm, over the parameter t along it.

use super::{BodyPlace, Waypoint};
use foundation::kinematics::{Dresser, DressingPath, DressingPosition, Point, Pose, Worm};
use foundation::numerics::equidistant;
use machine::{Mounts, StationSpindle, ToolSpindle};
use nalgebra::Vector3;
use std::f64::consts::TAU;

/// Where the disc touches the worm at a place of a line, in coordinates of the disc, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineContact {
    /// Place t on the line, mm.
    pub t: f64,
    /// Point.
    pub point: Vector3<f64>,
    /// Normal out of the worm's material.
    pub normal: Vector3<f64>,
}

/// A line's bodies.
#[derive(Clone, Debug)]
pub struct LineCourse {
    /// The motion over t.
    pub path: DressingPath,
    /// Whether t falls while it is driven.
    pub backwards: bool,
    /// Contacts at some places, t ascending; between them they change evenly.
    pub contacts: Vec<LineContact>,
    /// Radius at which a turn of the worm counts as way of the disc, mm.
    pub reach: f64,
    /// How the bodies are clamped.
    pub mounts: Mounts,
}

/// A position of the bodies beside a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BesideLine {
    /// Place of the line next to it, t, mm.
    pub t: f64,
    /// How far the disc stands off the line's position there, along the worm's normal at the contact, mm; positive leaves material.
    pub height: f64,
}

/// Steps to the nearest place: each squares what is missing.
const STEPS: usize = 4;
/// Places at which the way over t is looked at.
const PLACES: usize = 33;

impl LineCourse {
    /// t where the line begins and ends as it is driven, mm.
    pub fn ends(&self) -> [f64; 2] {
        let [from, to] = self.path.domain;
        if self.backwards { [to, from] } else { [from, to] }
    }

    /// Position of the bodies at a place.
    pub fn position(&self, at: &Waypoint) -> DressingPosition {
        let [from, to] = self.path.domain;
        let mut position: DressingPosition = self.path.position(at.v.clamp(from, to));
        position.worm_angle += at.lead;
        position.centre_distance += at.lift;
        position
    }

    /// Greatest way of the disc against the worm over t.
    pub fn way_over_t(&self) -> f64 {
        equidistant(self.path.domain, PLACES)
            .into_iter()
            .map(|t| Vector3::from(self.jets(t).map(|[_, slope]| slope)).norm())
            .fold(0.0, f64::max)
    }

    /// Ways and their slopes over t: of the turn at `reach`, along the worm, of the distance.
    fn jets(&self, t: f64) -> [[f64; 2]; 3] {
        let [phi, v, d] =
            [&self.path.worm_angle, &self.path.worm_shift, &self.path.centre_distance].map(|law| law.jet(t));
        [[self.reach * phi[0], self.reach * phi[1]], [v[0], v[1]], [d[0], d[1]]]
    }

    /// Where a position stands beside the line; `near` is a place nearby, whose lift counts as wanted. Full turns mean nothing.
    pub fn beside(&self, is: &DressingPosition, near: &Waypoint) -> BesideLine {
        let [from, to] = self.path.domain;
        let turned = is.worm_angle - near.lead - self.position(near).worm_angle;
        let worm_angle = is.worm_angle - near.lead - TAU * (turned / TAU).round();
        let mut t = near.v.clamp(from, to);
        for _ in 0..STEPS {
            let [phi, v, d] = self.jets(t);
            let off = Vector3::new(
                self.reach * worm_angle - phi[0],
                is.worm_shift - v[0],
                is.centre_distance - near.lift - d[0],
            );
            let slope = Vector3::new(phi[1], v[1], d[1]);
            let step = off.dot(&slope) / slope.norm_squared();
            if !step.is_finite() {
                break;
            }
            t = (t + step).clamp(from, to);
        }
        let wanted = self.position(&Waypoint { v: t, ..*near });
        // Where a point of the disc is against where it is wanted, in coordinates of the wanted disc.
        let moved: Pose<Dresser, Dresser> = wanted.pose().inverse().then(&is.pose());
        let (point, normal) = self.contact(t);
        let height = normal.dot(&(moved.point(&Point::from_vector(point)).xyz - point));
        BesideLine { t, height }
    }

    /// Contact at t, between its neighbours in `contacts`; the middle of the rim for a line without any.
    fn contact(&self, t: f64) -> (Vector3<f64>, Vector3<f64>) {
        let behind = self.contacts.partition_point(|contact| contact.t <= t);
        let last = self.contacts.len().saturating_sub(1);
        let pair =
            (self.contacts.get(behind.saturating_sub(1).min(last)), self.contacts.get(behind.min(last)));
        let (Some(a), Some(b)) = pair else { return (Vector3::zeros(), -Vector3::x()) };
        let share = if b.t > a.t { ((t - a.t) / (b.t - a.t)).clamp(0.0, 1.0) } else { 0.0 };
        (a.point + (b.point - a.point) * share, (a.normal + (b.normal - a.normal) * share).normalize())
    }

    pub(super) fn place(&self, at: &Waypoint) -> BodyPlace {
        BodyPlace::of_dressing(&self.mounts, &self.position(at))
    }

    pub(super) fn off(&self, pose: &Pose<ToolSpindle, StationSpindle>, near: &Waypoint) -> Option<f64> {
        let bodies: Pose<Worm, Dresser> = self.mounts.bodies(pose);
        let is = DressingPosition::of_pose(&bodies, self.position(near).worm_angle)?;
        Some(self.beside(&is, near).height.abs())
    }
}
