//! The convex parts of a milling cutter: distance of a point and how it changes, in tool coordinates.
//!
//! Cutting part, neck, shank and holder are convex one by one, and the distance from a convex body is a convex function of the place:
//! it lies above each of its tangent planes. Every bound of the search for the lowest entry rests on that.

use foundation::geometry::{Cutter, CutterShape};

/// The part of a cutter that a ray meets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CutterPart {
    /// The cutting part, taken to go on upwards as far as its cutter says.
    Edges,
    /// Neck, shank or holder: index of the step of the cutter.
    Shank(usize),
}

#[derive(Clone, Copy, Debug)]
enum Body {
    /// All points nearer than `corner` to the cone (rho - rho_c) cos <= (z - corner) sin above z = corner.
    Conical { rho_c: f64, corner: f64, sin: f64, cos: f64 },
    /// All points nearer than `profile` to the circle, or point, from which the profile is drawn, its middle filled.
    Barrel { rho_c: f64, height: f64, profile: f64 },
    /// A cylinder that begins at a height.
    Step { radius: f64, from: f64 },
}

/// One convex part.
#[derive(Clone, Copy, Debug)]
pub(super) struct Part {
    pub name: CutterPart,
    /// A radius that is typical of its curvature across the axis, mm.
    pub radius: f64,
    body: Body,
    /// Height at which it ends, mm.
    top: f64,
}

impl Part {
    /// The parts of a cutter.
    pub fn of(cutter: &Cutter) -> Vec<Self> {
        let (radius, body) = match *cutter.shape() {
            CutterShape::Conical { radius, half_angle, corner_radius } => {
                let (sin, cos) = if half_angle == 0.0 { (0.0, 1.0) } else { half_angle.sin_cos() };
                let rho_c = radius + (sin - 1.0) * corner_radius / cos;
                (radius, Body::Conical { rho_c, corner: corner_radius, sin, cos })
            }
            CutterShape::Barrel { radius, height, profile_radius } => {
                (radius, Body::Barrel { rho_c: radius - profile_radius, height, profile: profile_radius })
            }
        };
        let steps = cutter.steps().iter().enumerate().map(|(i, step)| Self {
            name: CutterPart::Shank(i),
            radius: step.radius,
            body: Body::Step { radius: step.radius, from: step.from },
            top: f64::INFINITY,
        });
        std::iter::once(Self { name: CutterPart::Edges, radius, body, top: cutter.top() })
            .chain(steps)
            .collect()
    }

    /// Distance at radius rho and height z, mm, negative inside, with its derivatives by rho and by z. What ends at a height is the
    /// common part of two convex bodies: the greater distance, which is convex as both are.
    #[inline]
    pub fn distance(&self, rho: f64, z: f64) -> [f64; 3] {
        let endless = self.endless(rho, z);
        let above = z - self.top;
        if above > endless[0] { [above, 0.0, 1.0] } else { endless }
    }

    #[inline]
    fn endless(&self, rho: f64, z: f64) -> [f64; 3] {
        match self.body {
            Body::Conical { rho_c, corner, sin, cos } => {
                let (x, y) = (rho - rho_c, z - corner);
                let off_side = cos * x - sin * y;
                let [core, by_rho, by_z] = if off_side <= 0.0 && y >= 0.0 {
                    if off_side >= -y { [off_side, cos, -sin] } else { [-y, 0.0, -1.0] }
                } else if off_side > 0.0 && sin * x + cos * y >= 0.0 {
                    [off_side, cos, -sin]
                } else if y < 0.0 && x <= 0.0 {
                    [-y, 0.0, -1.0]
                } else {
                    radial(x, y)
                };
                [core - corner, by_rho, by_z]
            }
            Body::Barrel { rho_c, height, profile } => {
                // A profile radius below the largest radius would leave a hole around the axis; a mill has none.
                let x = if rho_c > 0.0 { (rho - rho_c).max(0.0) } else { rho - rho_c };
                let [core, by_rho, by_z] = radial(x, z - height);
                [core - profile, by_rho, by_z]
            }
            Body::Step { radius, from } => {
                let (x, y) = (rho - radius, from - z);
                if x > 0.0 && y > 0.0 {
                    let [d, by_x, by_y] = radial(x, y);
                    [d, by_x, -by_y]
                } else if x >= y {
                    [x, 1.0, 0.0]
                } else {
                    [y, 0.0, -1.0]
                }
            }
        }
    }
}

/// Length of (x, y) with its derivatives; at the origin a direction that every convex bound may use, none.
#[inline]
fn radial(x: f64, y: f64) -> [f64; 3] {
    // Not `hypot`: sizes are those of tools, and this is where the referee spends its time.
    let length = (x * x + y * y).sqrt();
    if length > 0.0 { [length, x / length, y / length] } else { [0.0; 3] }
}
