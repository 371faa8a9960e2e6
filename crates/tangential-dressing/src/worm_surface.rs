//! The worm flank that a dresser leaves whose motion and profile are functions of its axial position x_D: a tool surface over
//! (s, x_D) (`docs/mathematics/tangential-dressing.md#the-dressed-worm`). The dressing contact is the closed form of one circle; knows no
//! gear.

use super::profile::Profile;
use contact::{SurfaceJet, ToolSurface};
use dressing::{DresserAxes, RoomContact, WormScrew, touch};
use foundation::geometry::MeridianPoint;
use foundation::kinematics::{DressingChain, MotionLaw};
use foundation::numerics::{Scalar, value_of};
use nalgebra::Vector3;

/// Laws of the dresser over x_D, mm and rad over mm.
#[derive(Clone, Debug)]
pub(super) struct DresserLaws {
    /// F_p over s.
    pub profile: MotionLaw,
    /// F_z.
    pub tangential: MotionLaw,
    /// dX.
    pub axial: MotionLaw,
    /// dA.
    pub distance: MotionLaw,
    /// Delta gA.
    pub angle: MotionLaw,
}

impl DresserLaws {
    fn with_share(&self, share: f64) -> Self {
        Self {
            profile: self.profile.scaled(share),
            tangential: self.tangential.scaled(share),
            axial: self.axial.scaled(share),
            distance: self.distance.scaled(share),
            angle: self.angle.scaled(share),
        }
    }
}

/// One flank of the worm as dressed.
#[derive(Clone, Debug)]
pub(super) struct WormSurface<'a> {
    pub profile: &'a Profile,
    pub chain: DressingChain,
    pub laws: DresserLaws,
    /// Side of the dresser, sigma.
    pub sigma: f64,
}

/// Profile and laws with their first two derivatives at one place.
struct Local {
    /// h over s.
    profile: [f64; 3],
    tangential: [f64; 3],
    axial: [f64; 3],
    distance: [f64; 3],
    angle: [f64; 3],
}

/// Value and first derivative of a function known by its jet, `dx` beside that place.
fn lifted<T: Scalar>(jet: &[f64; 3], dx: T) -> [T; 2] {
    [dx * jet[1] + jet[0], dx * jet[2] + jet[1]]
}

/// Where a circle of the dresser touches the worm, with what moves there. Room frame at x_D = 0.
pub(super) struct DressedPoint<T: Scalar> {
    pub contact: RoomContact<T>,
    pub axes: DresserAxes<T>,
}

impl WormSurface<'_> {
    fn local(&self, s: f64, x_d: f64) -> Local {
        let nominal = self.profile.half_thickness(s);
        let removed = self.laws.profile.jet(s);
        Local {
            profile: std::array::from_fn(|k| self.sigma * (nominal[k] - removed[k])),
            tangential: self.laws.tangential.jet(x_d),
            axial: self.laws.axial.jet(x_d),
            distance: self.laws.distance.jet(x_d),
            angle: self.laws.angle.jet(x_d),
        }
    }

    /// The contact of the circle at height s while the dresser is at x_D; `None` where there is none.
    pub fn touch<T: Scalar>(&self, s: T, x_d: T) -> Option<DressedPoint<T>> {
        self.touch_at(&self.local(value_of(s), value_of(x_d)), s, x_d)
    }

    fn touch_at<T: Scalar>(&self, at: &Local, s: T, x_d: T) -> Option<DressedPoint<T>> {
        let dx = x_d - value_of(x_d);
        let [height, slope] = lifted(&at.profile, s - value_of(s));
        let length = (slope * slope + 1.0).sqrt();
        let meridian = MeridianPoint {
            r: s + self.profile.pitch_radius,
            z: height,
            n_r: -slope * self.sigma / length,
            n_z: length.recip() * self.sigma,
        };
        let [tangential, tangential_rate] = lifted(&at.tangential, dx);
        let [_, axial_rate] = lifted(&at.axial, dx);
        let [distance, distance_rate] = lifted(&at.distance, dx);
        let [angle, angle_rate] = lifted(&at.angle, dx);
        let mut axes = DresserAxes::kinematic(
            angle + self.chain.crossing_angle,
            distance + self.chain.centre_distance,
            T::from(0.0),
        );
        axes.centre.y = -tangential;
        // dP/dx_D + (1/p) k x P, times p: the screw of the worm with what the dresser does besides.
        let p = self.chain.screw_parameter;
        let screw = WormScrew {
            spin: Vector3::new(-angle_rate * p, T::from(0.0), T::from(1.0)),
            drift: Vector3::new(
                distance_rate * p,
                -tangential_rate * p,
                (axial_rate - angle_rate * tangential + 1.0) * p,
            ),
        };
        let contact = touch(&meridian, &axes, &screw)?;
        Some(DressedPoint { contact, axes })
    }

    /// How fast the contact condition of a circle changes along it; 0 where its envelope folds.
    pub fn circle_rate(&self, s: f64, x_d: f64) -> Option<f64> {
        let at = self.local(s, x_d);
        let DressedPoint { contact, axes } = self.touch_at(&at, s, x_d)?;
        let [distance, tangential, axial, angle] =
            [at.distance, at.tangential, at.axial, at.angle].map(|jet| jet[1]);
        let turn = 1.0 / self.chain.screw_parameter;
        let over = |v: &Vector3<f64>| Vector3::new(-v.y * turn, v.z * angle + v.x * turn, -v.y * angle);
        let arm = contact.q - axes.centre;
        let velocity = Vector3::new(distance, -tangential, axial + 1.0)
            + over(&arm)
            + Vector3::new(-axes.centre.y, axes.centre.x, 0.0) * turn;
        let along = axes.axis.cross(&arm);
        let along_n = axes.axis.cross(&contact.n);
        Some(along_n.dot(&velocity) + contact.n.dot(&over(&along)))
    }

    /// The same surface without profile function and corrections.
    pub fn unmodified(&self) -> Self {
        Self { laws: self.laws.with_share(0.0), ..self.clone() }
    }

    /// phi_S at x_D.
    pub fn worm_angle<T: Scalar>(&self, x_d: T) -> T {
        -x_d / self.chain.screw_parameter + self.chain.worm_angle
    }
}

impl ToolSurface for WormSurface<'_> {
    /// By hand, not by dual numbers, for this is the inner loop of every fit; the tests compare both.
    fn jet(&self, s: f64, x_d: f64) -> Option<SurfaceJet> {
        let at = self.local(s, x_d);
        let DressedPoint { contact, axes } = self.touch_at(&at, s, x_d)?;
        let Local { profile: h, tangential, axial, distance, angle: [_, angle_1, angle_2] } = at;
        let centre = |k: usize| Vector3::new(distance[k], -tangential[k], axial[k]);
        // Turning with the dresser: a vector fixed to it moves by -gA' e_x x it.
        let tilted = |v: &Vector3<f64>| Vector3::new(0.0, v.z, -v.y);
        let about_z = |v: &Vector3<f64>| Vector3::new(-v.y, v.x, 0.0);
        let turn = 1.0 / self.chain.screw_parameter;

        let mut centre_now = axes.centre;
        centre_now.z += x_d + axial[0];
        let arm = contact.q - axes.centre;
        let point = centre_now + arm;
        let mut centre_1 = centre(1);
        centre_1.z += 1.0;
        // Velocity of the dresser's point over the worm, per mm of x_D, and its own change along x_D.
        let arm_x = tilted(&arm) * angle_1;
        let point_x = centre_1 + arm_x;
        let velocity = point_x + about_z(&point) * turn;
        let velocity_x =
            centre(2) + tilted(&arm) * angle_2 + tilted(&arm_x) * angle_1 + about_z(&point_x) * turn;
        let over = |v: &Vector3<f64>| tilted(v) * angle_1 + about_z(v) * turn;

        let rho = s + self.profile.pitch_radius;
        let radial = (arm - axes.axis * h[0]) / rho;
        let tangent = axes.axis.cross(&radial);
        let length = (1.0 + h[1] * h[1]).sqrt();
        let bend = self.sigma * h[2] / (length * length * length);
        let n = contact.n;
        let (point_s, n_s) = (radial + axes.axis * h[1], -(radial + axes.axis * h[1]) * bend);
        let (point_t, n_t) = (tangent * rho, tangent * n.dot(&radial));
        let n_x = tilted(&n) * angle_1;
        // n . velocity = 0 holds along the flank: it says how the place on the circle moves.
        let by_t = n_t.dot(&velocity) + n.dot(&over(&point_t));
        let t_s = -(n_s.dot(&velocity) + n.dot(&over(&point_s))) / by_t;
        let t_x = -(n_x.dot(&velocity) + n.dot(&velocity_x)) / by_t;

        let (sin, cos) = (-self.worm_angle(x_d)).sin_cos();
        let turned = |v: &Vector3<f64>| Vector3::new(cos * v.x - sin * v.y, sin * v.x + cos * v.y, v.z);
        // The dresser's outward normal points into the worm.
        Some(SurfaceJet {
            p: turned(&point),
            n: -turned(&n),
            p_p: turned(&(point_s + point_t * t_s)),
            p_q: turned(&(velocity + point_t * t_x)),
            n_p: -turned(&(n_s + n_t * t_s)),
            n_q: -turned(&(n_x + about_z(&n) * turn + n_t * t_x)),
        })
    }

    fn start(&self, w_1: f64, z_1: f64) -> (f64, f64) {
        (self.profile.height(w_1), z_1 - self.profile.line(w_1))
    }

    fn with_share(&self, share: f64) -> Box<dyn ToolSurface + '_> {
        Box::new(Self { laws: self.laws.with_share(share), ..self.clone() })
    }

    fn step_limits(&self) -> (f64, f64) {
        (1.0, 6.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{ProfileKind, TangentialError};
    use foundation::numerics::variables;

    fn surface(profile: &Profile, chain: DressingChain) -> WormSurface<'_> {
        let law = |c: &[f64]| MotionLaw::polynomial(0.0, c.to_vec());
        let laws = DresserLaws {
            profile: law(&[0.0, 0.01, -0.02, 0.003]),
            tangential: law(&[0.3, 0.02, 1e-3, -2e-5]),
            axial: law(&[-0.2, 0.01, 2e-3, 1e-5]),
            distance: law(&[0.1, -0.02, 1e-3]),
            angle: law(&[2e-3, 1e-4, -2e-5]),
        };
        WormSurface { profile, chain, laws, sigma: -1.0 }
    }

    #[test]
    fn the_jet_by_hand_is_that_of_dual_numbers() -> Result<(), TangentialError> {
        let model = crate::model::tests::source_model(ProfileKind::Conjugate)?;
        let surface = surface(&model.profiles.left, model.chain);
        for (s, x_d) in [(-3.5, 20.0), (0.0, 0.0), (1.3, -31.0), (2.9, 7.0)] {
            let [sd, xd] = variables([s, x_d]);
            let dressed = surface.touch(sd, xd).unwrap();
            let axial = xd + surface.laws.axial.lifted(xd)[0];
            let (point, normal) = dressed.contact.on_worm(surface.worm_angle(xd), axial);
            let expected = SurfaceJet::of_duals(&point, &-normal);
            let found = surface.jet(s, x_d).unwrap();
            let pairs = [
                (expected.p, found.p),
                (expected.n, found.n),
                (expected.p_p, found.p_p),
                (expected.p_q, found.p_q),
                (expected.n_p, found.n_p),
                (expected.n_q, found.n_q),
            ];
            for (k, (a, b)) in pairs.into_iter().enumerate() {
                assert!((a - b).norm() < 1e-11 * (1.0 + a.norm()), "{k} at {s}, {x_d}: {a} {b}");
            }
        }
        Ok(())
    }
}
