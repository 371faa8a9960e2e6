//! The bevel flank on the spherical involute, straight or along any flank line: `docs/mathematics/milling.md#flanks-as-patches`.
//!
//! Height = roll angle omega in rad, length = distance R from the apex in mm.

use super::{BevelGear, FlankLine};
use crate::geometry::surface::bounds::{largest, largest_cosine, largest_sine, remainder, smallest};
use crate::geometry::surface::turned;
use crate::geometry::{Flank, GeometryError, OffsetBase, SecondOrder, Surface, SurfaceJet};
use nalgebra::Vector3;
use std::f64::consts::PI;

/// One flank of a bevel gear's tooth space.
#[derive(Clone, Debug, PartialEq)]
pub struct SphericalInvolute {
    flank: Flank,
    line: FlankLine,
    base_space_half_angle: f64,
    sin_base: f64,
    cos_base: f64,
}

/// The orthonormal directions at a place, and the helix at its base.
struct Frame {
    /// P^: from the apex.
    ray: Vector3<f64>,
    /// n0: normal of the straight flank there.
    straight: Vector3<f64>,
    /// m: towards which P^ moves with omega.
    across: Vector3<f64>,
    sin_xi: f64,
    cos_xi: f64,
}

impl SphericalInvolute {
    /// A flank along the flank line of the drawing.
    pub fn new(gear: &BevelGear, flank: Flank) -> Self {
        let (sin_base, cos_base) = gear.base_angle().sin_cos();
        Self {
            flank,
            line: gear.line().clone(),
            base_space_half_angle: gear.base_space_half_angle(),
            sin_base,
            cos_base,
        }
    }

    /// A flank along another line than that of the drawing.
    ///
    /// # Errors
    /// [`GeometryError::FlankLineOutOfReach`] when it does not cover the face.
    pub fn with_line(gear: &BevelGear, flank: Flank, line: FlankLine) -> Result<Self, GeometryError> {
        line.check(gear.face())?;
        Ok(Self { line, ..Self::new(gear, flank) })
    }

    /// Which flank of the space.
    pub fn flank(&self) -> Flank {
        self.flank
    }

    /// Its flank line.
    pub fn line(&self) -> &FlankLine {
        &self.line
    }

    /// Largest sin(theta) over ascending xi.
    fn largest_polar_sine(&self, xi: [f64; 2]) -> f64 {
        // cos(theta) = cos(delta_b) cos(xi), falling: the sine is largest where the cosine is smallest.
        let cos_polar = self.cos_base * smallest([xi[1].cos(), xi[0].cos()]);
        ((1.0 - cos_polar) * (1.0 + cos_polar)).sqrt()
    }

    #[inline]
    fn frame(&self, omega: f64, turn: f64) -> Frame {
        let s = self.flank.sign();
        let (sin, cos) = (s * (omega + self.base_space_half_angle) - turn).sin_cos();
        let (sin_xi, cos_xi) = (omega * self.sin_base).sin_cos();
        let e_r = Vector3::new(sin, cos, 0.0);
        let u = Vector3::new(cos, -sin, 0.0);
        let mut g = e_r * self.sin_base;
        g.z = self.cos_base;
        let mut across = e_r * self.cos_base;
        across.z = -self.sin_base;
        Frame {
            ray: g * cos_xi - u * (s * sin_xi),
            straight: -(u * (s * cos_xi) + g * sin_xi),
            across,
            sin_xi,
            cos_xi,
        }
    }

    /// cos and sin of beta_b, and d(beta_b)/dR, from Theta' and Theta''.
    #[inline]
    fn base_helix(&self, distance: f64, line: &[f64; 4]) -> [f64; 3] {
        let tangent = distance * line[1] * self.sin_base;
        let cos = 1.0 / tangent.hypot(1.0);
        let rate = cos * cos * self.sin_base * (line[1] + distance * line[2]);
        [cos, cos * tangent, rate]
    }

    #[inline]
    fn jet_in(&self, frame: &Frame, distance: f64, line: &[f64; 4], helix: [f64; 3]) -> SurfaceJet {
        let s = self.flank.sign();
        let [cos, sin, rate] = helix;
        let (ray, straight) = (&frame.ray, &frame.straight);
        let point = ray * distance;
        let normal = straight * cos - ray * (s * sin);
        let leaning = straight * -sin - ray * (s * cos);
        SurfaceJet {
            point,
            by_height: frame.across * (distance * frame.sin_xi * self.cos_base),
            by_length: ray + turned(&point) * line[1],
            normal,
            normal_by_height: frame.across * (self.cos_base * (cos * frame.cos_xi - s * sin * frame.sin_xi)),
            normal_by_length: turned(&normal) * line[1] + leaning * rate,
        }
    }
}

impl Surface for SphericalInvolute {
    /// From the base cone through the plane at the apex to the base cone that faces it.
    fn domain(&self) -> [[f64; 2]; 2] {
        [[0.0, PI / self.sin_base], self.line.domain()]
    }

    #[inline]
    fn point(&self, omega: f64, distance: f64) -> Vector3<f64> {
        self.frame(omega, self.line.angle(distance)).ray * distance
    }

    #[inline]
    fn jet(&self, omega: f64, distance: f64) -> SurfaceJet {
        let line = self.line.derivatives(distance);
        let frame = self.frame(omega, line[0]);
        self.jet_in(&frame, distance, &line, self.base_helix(distance, &line))
    }

    /// Exact for straight teeth and circles: |S_omega| = R sin(xi) cos(delta_b), |S_R|^2 = 1 + (R Theta' sin(theta))^2.
    fn speed_bounds(&self, heights: [f64; 2], distances: [f64; 2]) -> [f64; 2] {
        let xi = heights.map(|omega| omega * self.sin_base);
        let turn = largest(self.line.bounds(distances).turn);
        [
            largest(distances) * largest_sine(xi) * self.cos_base,
            (turn * self.largest_polar_sine(xi)).hypot(1.0),
        ]
    }

    /// |S_omega_omega| = R hypot(sin(delta_b) lambda, mu cos(delta_b)), |S_omega_R| = mu hypot(1, cos(delta_b) R Theta'); S_RR is
    /// sin(theta) times (R Theta')' + Theta' across and R Theta'^2 towards the axis.
    fn off_tangent(&self, heights: [f64; 2], distances: [f64; 2]) -> f64 {
        let xi = heights.map(|omega| omega * self.sin_base);
        let (mu, lambda) = (self.cos_base * largest_sine(xi), self.cos_base * largest_cosine(xi));
        let line = self.line.bounds(distances);
        let turn = largest(line.turn);
        // A line that does not turn may go to the apex.
        let slope = if turn == 0.0 { 0.0 } else { turn / smallest(distances) };
        let second = [
            largest(distances) * (self.sin_base * lambda).hypot(self.cos_base * mu),
            mu * (self.cos_base * turn).hypot(1.0),
            self.largest_polar_sine(xi) * (line.turn_rate + slope).hypot(turn * slope),
        ];
        remainder(second, heights, distances)
    }
}

impl OffsetBase for SphericalInvolute {
    fn second_order(&self, omega: f64, distance: f64) -> SecondOrder {
        let s = self.flank.sign();
        let line = self.line.derivatives(distance);
        let [_, line_1, line_2, line_3] = line;
        let frame = self.frame(omega, line[0]);
        let helix = self.base_helix(distance, &line);
        let [cos, sin, rate] = helix;
        let jet = self.jet_in(&frame, distance, &line, helix);
        let Frame { ray, straight, across, sin_xi, cos_xi } = frame;

        // With omega: P^ moves by mu m, n0 by lambda m, m by -mu P^ - lambda n0.
        let (mu, lambda) = (self.cos_base * sin_xi, self.cos_base * cos_xi);
        let across_by_height = ray * -mu - straight * lambda;
        // Derivatives of mu and lambda: sin(delta_b) lambda and -sin(delta_b) mu.
        let bent = self.sin_base * self.cos_base * (-cos * sin_xi - s * sin * cos_xi);
        let turning = cos * lambda - s * sin * mu;

        // beta_b'' and the normal's dependence on beta_b: n_beta and n_beta_beta = -n.
        let rate_2 =
            cos * cos * self.sin_base * (2.0 * line_2 + distance * line_3) - 2.0 * (sin / cos) * rate * rate;
        let leaning = straight * -sin - ray * (s * cos);
        let leaning_by_height = across * (-sin * lambda - s * cos * mu);
        SecondOrder {
            jet,
            point: [
                (across * (self.sin_base * lambda) + across_by_height * mu) * distance,
                (across + turned(&across) * (distance * line_1)) * mu,
                turned(&ray) * line_1 + turned(&jet.point) * line_2 + turned(&jet.by_length) * line_1,
            ],
            normal: [
                across * bent + across_by_height * turning,
                turned(&jet.normal_by_height) * line_1 + leaning_by_height * rate,
                turned(&jet.normal) * line_2
                    + turned(&jet.normal_by_length) * line_1
                    + leaning * rate_2
                    + (turned(&leaning) * line_1 - jet.normal * rate) * rate,
            ],
        }
    }

    /// |n_omega| = cos(delta_b) |cos(xi + s beta_b)|; |n_R| at most |Theta'| + |beta_b'|.
    fn normal_speed_bounds(&self, heights: [f64; 2], distances: [f64; 2]) -> [f64; 2] {
        let s = self.flank.sign();
        let line = self.line.bounds(distances);
        let helix = line.turn.map(|turn| s * (turn * self.sin_base).atan());
        let [low, high] = if s > 0.0 { helix } else { [helix[1], helix[0]] };
        let xi = heights.map(|omega| omega * self.sin_base);
        // A line that does not turn may go to the apex.
        let turn = largest(line.turn);
        let turning = if turn == 0.0 { 0.0 } else { turn / smallest(distances) };
        let flattest = smallest(line.turn) * self.sin_base;
        let leaning = self.sin_base * line.turn_rate / (1.0 + flattest * flattest);
        [self.cos_base * largest_cosine([xi[0] + low, xi[1] + high]), turning + leaning]
    }
}
