//! The rounded edge between a flank and the tip of a cylindrical worm, and the root fillet that it leaves on the gear: the exact
//! envelope under the motion of grinding (`docs/mathematics/dressing.md#conditions`). The edge is traced by a ball that touches flank and
//! tip. Knows no dresser and no target.

use super::ContactError;
use foundation::geometry::InvoluteFlank;
use foundation::inverse::{NewtonOptions, newton};
use foundation::kinematics::{GeneratingMotion, MotionLaw, Pose, Workpiece, Worm};
use foundation::numerics::{Chebyshev, Scalar, gradient_of, value_of, variables};
use nalgebra::{Matrix3, Rotation3, Vector3};
use std::f64::consts::PI;

/// The edge of one flank. mm.
#[derive(Clone, Debug)]
pub struct TipCorner {
    flank: InvoluteFlank,
    radius: f64,
    tip: MotionLaw,
}

/// Centre of the ball with two unit normals across its path: that of the flank, and the one towards the tip.
struct Section<T: Scalar> {
    centre: Vector3<T>,
    flank_normal: Vector3<T>,
    outward: Vector3<T>,
}

/// A transverse section of the fillet, by the angle chi on the edge: 0 at the flank, largest at the root. mm, rad.
#[derive(Clone, Debug)]
pub struct RootFillet {
    /// Axial position of the section on the gear.
    pub z: f64,
    x: Chebyshev,
    y: Chebyshev,
    /// Unit normal of the gear at chi = 0, out of its material.
    flank_normal: Vector3<f64>,
}

/// Contacts over the edge from which the section is interpolated, and places at which its curvature is looked at.
const NODES: usize = 41;
const PLACES: usize = 201;

impl TipCorner {
    /// Edge of radius `radius` on a worm flank; `tip` is the tip radius over the worm's z.
    ///
    /// # Errors
    /// [`ContactError::InvalidNumber`] for a radius that is not above 0, [`ContactError::CornerTooLarge`] for one that does not fit
    /// between tip and base cylinder.
    pub fn new(flank: InvoluteFlank, radius: f64, tip: MotionLaw) -> Result<Self, ContactError> {
        if !(radius.is_finite() && radius > 0.0) {
            return Err(ContactError::InvalidNumber {
                field: "corner radius",
                value: radius,
                allowed: "a finite radius above 0 mm",
            });
        }
        let most = tip.value(0.0) - flank.base_radius;
        if radius >= most {
            return Err(ContactError::CornerTooLarge { radius, most });
        }
        Ok(Self { flank, radius, tip })
    }

    /// Largest length of roll of the flank at z, where the edge begins, mm.
    pub fn end_of_flank(&self, z: f64) -> f64 {
        let centre = self.tip.value(z) - self.radius;
        let square = centre * centre - self.flank.base_radius * self.flank.base_radius;
        square.max(0.0).sqrt() + self.radius * self.flank.base_helix_angle.cos()
    }

    /// The edge across the path of its ball, whose centre stands at the worm's z = `zeta`.
    fn section<T: Scalar>(&self, zeta: T) -> Section<T> {
        let f = &self.flank;
        let (s, r_b, twist) = (f.s(), f.base_radius, f.twist_per_length());
        let (sin, cos) = f.base_helix_angle.sin_cos();
        let [tip, slope] = self.tip.lifted(zeta);
        let r = tip - self.radius;
        // The centre runs on the involute that lies the radius inside the flank.
        let w = (r * r - r_b * r_b).sqrt();
        let frame = f.frame(w + self.radius * cos, zeta - s * self.radius * sin);
        let combined = |a: T, b: T, c: T| {
            Vector3::new(
                frame.e_r.x * a + frame.e_t.x * b,
                frame.e_r.y * a + frame.e_t.y * b,
                frame.e_r.z * a + frame.e_t.z * b + c,
            )
        };
        let centre = combined(T::from(r_b), w, zeta);
        // d(centre)/d(zeta): along the involute as the tip radius changes, and with the helix.
        let path = combined(r * slope / r_b - w * (twist * s), T::from(twist * s * r_b), T::from(1.0));
        let across = path.cross(&frame.n);
        let radial = Vector3::new(centre.x, centre.y, T::from(0.0));
        let turned = if value_of(across.dot(&radial)) < 0.0 { -1.0 } else { 1.0 };
        let scale = across.dot(&across).sqrt().recip() * turned;
        Section { centre, flank_normal: frame.n, outward: across * scale }
    }

    /// Angle chi at which the edge passes into the tip.
    fn end(&self, zeta: f64) -> f64 {
        let at = self.section(zeta);
        let [_, slope] = self.tip.lifted(zeta);
        let length = at.centre.xy().norm();
        let normal = Vector3::new(at.centre.x / length, at.centre.y / length, -slope);
        normal.dot(&at.outward).atan2(normal.dot(&at.flank_normal))
    }

    /// The fillet in the transverse section at the gear's z.
    ///
    /// # Errors
    /// [`ContactError::NoRootFillet`] where the edge leaves no envelope.
    pub fn fillet(
        &self,
        motion: &GeneratingMotion,
        work: &InvoluteFlank,
        z: f64,
    ) -> Result<RootFillet, ContactError> {
        // On the common perpendicular the tip faces the gear's axis.
        let feed = -z;
        let zeta = -motion.shift.value(feed);
        let centre = self.section(zeta).centre;
        let facing = centre.x.atan2(centre.y);
        let end = self.end(zeta);
        let mut start = Vector3::new(zeta, facing, feed);
        let nodes = Chebyshev::nodes(0.0, end, NODES);
        let phase = motion.phase[self.flank.flank];
        let mut found = Vec::with_capacity(NODES + 2);
        // From the root, where the contact is known, to the flank.
        for chi in std::iter::once(end).chain(nodes.into_iter().rev()).chain(std::iter::once(0.0)) {
            let solved = newton(start, &NewtonOptions::default(), |x| {
                let [zeta, angle, feed] = variables([x[0], x[1], x[2]]);
                let (conditions, point, _) = self.contact(motion, phase, chi, zeta, angle, feed);
                let rows = [conditions[0], conditions[1], point.z - z];
                let jacobian = Matrix3::from_fn(|i, j| gradient_of(&rows[i])[j]);
                Some((Vector3::from_fn(|i, _| value_of(rows[i])), jacobian))
            })
            .map_err(|_| ContactError::NoRootFillet { flank: self.flank.flank, z })?;
            start = solved.x;
            let (_, point, normal) = self.contact(motion, phase, chi, start[0], start[1], start[2]);
            found.push((point, normal));
        }
        let (root, flank) = (found[0], found[NODES + 1]);
        // Into the space centred on +y.
        let pitch = 2.0 * PI / work.teeth.abs();
        let space = (root.0.x.atan2(root.0.y) + z * work.twist_per_length()) / pitch;
        let turn = Rotation3::from_axis_angle(&Vector3::z_axis(), space.round() * pitch);
        let series = |k: usize| {
            let values: Vec<f64> = found[1..=NODES].iter().rev().map(|at| (turn * at.0)[k]).collect();
            Chebyshev::interpolate(0.0, end, &values)
        };
        Ok(RootFillet { z, x: series(0), y: series(1), flank_normal: turn * flank.1 })
    }

    /// Both conditions of the envelope, and point and outward normal of the gear, at an angle on the edge, a place of the ball, and
    /// the instant of the motion.
    fn contact<T: Scalar>(
        &self,
        motion: &GeneratingMotion,
        phase: f64,
        chi: f64,
        zeta: T,
        angle: T,
        feed: T,
    ) -> ([T; 2], Vector3<T>, Vector3<T>) {
        let at = self.section(zeta);
        let (sin, cos) = chi.sin_cos();
        let n = at.flank_normal.map(|x| x * cos) + at.outward.map(|x| x * sin);
        let state = motion.state(angle, feed, phase);
        let pose: Pose<Worm, Workpiece, T> = motion.chain.pose(&state);
        let rotation = pose.rotation();
        let on_gear = |x: &Vector3<T>| rotation.transpose() * x;
        // Of the ball's centre: the rotation of the normal about it changes nothing.
        let gear = on_gear(&(at.centre - pose.translation()));
        let axis: Vector3<T> = rotation.column(2).into();
        let turning = rotation * Vector3::new(-gear.y, gear.x, T::from(0.0));
        let (z_1, z_2) = (motion.threads, motion.teeth);
        let spin = Vector3::new(-at.centre.y, at.centre.x, T::from(0.0));
        let by_angle = turning.map(|x| x * (-z_1 / z_2)) - spin;
        let [_, shift] = motion.shift.lifted(feed);
        let [_, approach] = motion.delta_d.lifted(feed);
        let [_, turn] = motion.delta_phi_2.lifted(feed);
        let [_, swivel] = motion.delta_gamma.lifted(feed);
        let (sin_1, cos_1) = angle.sin_cos();
        let towards = Vector3::new(sin_1, cos_1, T::from(0.0));
        let rate = (shift * motion.shift_coupling + motion.feed_coupling) / z_2 + turn;
        let pivot = towards * (state.delta_d + motion.chain.centre_distance)
            - Vector3::new(T::from(0.0), T::from(0.0), state.shift);
        let by_feed =
            turning * rate + axis + towards * approach + towards.cross(&(at.centre - pivot)) * swivel
                - Vector3::new(T::from(0.0), T::from(0.0), shift);
        let normal = on_gear(&n);
        ([n.dot(&by_angle), n.dot(&by_feed)], gear + normal.map(|x| x * self.radius), -normal)
    }
}

impl RootFillet {
    /// Largest angle chi, at the root, rad.
    pub fn end(&self) -> f64 {
        self.x.interval().1
    }

    /// Point of the section at chi, mm.
    pub fn point(&self, chi: f64) -> [f64; 2] {
        [self.x.value(chi), self.y.value(chi)]
    }

    /// Points from the flank to the root, mm.
    pub fn points(&self, count: usize) -> Vec<[f64; 2]> {
        let last = count.max(2) - 1;
        (0..=last).map(|k| self.point(self.end() * k as f64 / last as f64)).collect()
    }

    /// Points from the flank to the root with the direction out of the material across the section there, mm.
    pub fn rays(&self, count: usize) -> Vec<([f64; 2], [f64; 2])> {
        let (dx, dy) = (self.x.derivative(), self.y.derivative());
        let ray = |k: usize| {
            let chi = self.end() * k as f64 / (count.max(2) - 1) as f64;
            let (x, y): (f64, f64) = (dx.value(chi), dy.value(chi));
            let point = self.point(chi);
            // At the root the space lies outwards.
            let outward = if point[0] * -y + point[1] * x < 0.0 { -1.0 } else { 1.0 } / x.hypot(y);
            (point, [-y * outward, x * outward])
        };
        (0..count.max(2)).map(ray).collect()
    }

    /// Radius at which it begins on the flank, mm.
    pub fn form_radius(&self) -> f64 {
        let [x, y] = self.point(0.0);
        x.hypot(y)
    }

    /// Radius at which it passes into the root, mm.
    pub fn root_radius(&self) -> f64 {
        let [x, y] = self.point(self.end());
        x.hypot(y)
    }

    /// Angle between flank and fillet at their junction, rad: 0 for a tangential transition.
    pub fn transition(&self) -> f64 {
        let (dx, dy): (f64, f64) = (self.x.derivative().value(0.0), self.y.derivative().value(0.0));
        let (n, length) = (self.flank_normal.xy().norm(), dx.hypot(dy));
        ((self.flank_normal.x * dx + self.flank_normal.y * dy) / (n * length)).asin().abs()
    }

    /// By how much its radius rises again on the way from the flank to the root, mm: 0 but for rounding, and for what the end on a
    /// changing tip is off; more is the notch of an undercut.
    pub fn rise(&self) -> f64 {
        let mut least = f64::INFINITY;
        let mut rise: f64 = 0.0;
        for chi in self.places() {
            let [x, y] = self.point(chi);
            let radius = x.hypot(y);
            rise = rise.max(radius - least);
            least = least.min(radius);
        }
        rise
    }

    /// Least radius of curvature, mm.
    pub fn least_radius_of_curvature(&self) -> f64 {
        let (dx, dy) = (self.x.derivative(), self.y.derivative());
        let (ddx, ddy) = (dx.derivative(), dy.derivative());
        let radius = |chi: f64| {
            let (x, y): (f64, f64) = (dx.value(chi), dy.value(chi));
            x.hypot(y).powi(3) / (x * ddy.value(chi) - y * ddx.value(chi)).abs()
        };
        self.places().map(radius).fold(f64::INFINITY, f64::min)
    }

    fn places(&self) -> impl Iterator<Item = f64> {
        let end = self.end();
        (0..PLACES).map(move |k| end * k as f64 / (PLACES - 1) as f64)
    }
}
