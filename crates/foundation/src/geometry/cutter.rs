//! Milling cutters as bodies: surfaces of revolution that fill themselves when they turn, with the distance of a point from them.
//!
//! Tool coordinates: z along the axis from the tip towards the shank, rho from the axis (`docs/mathematics/milling.md#cutter-location`).
//! Knows no flank and no motion; contact with a flank is found elsewhere.

use super::GeometryError;
use nalgebra::Vector3;

/// The cutting part of a mill. mm, rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CutterShape {
    /// Cylinder (half angle 0) or cone with a rounded corner: end mill, torus, cone; with corner = radius a ball.
    Conical {
        /// R, or R_0 of a cone: the radius at which the side meets the tip plane.
        radius: f64,
        /// kappa: half angle of the cone, > 0 where the shank is thicker.
        half_angle: f64,
        /// r_c: radius of the corner.
        corner_radius: f64,
    },
    /// A profile of one arc: barrel, drum, lens.
    Barrel {
        /// R_max: largest radius.
        radius: f64,
        /// h_0: height of the largest radius above the tip.
        height: f64,
        /// R_b: radius of the profile.
        profile_radius: f64,
    },
}

/// A part of the tool behind its cutting edges: neck, shank or holder, from a height on upwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShankStep {
    /// Radius, mm.
    pub radius: f64,
    /// Height above the tip at which it begins, mm.
    pub from: f64,
}

/// A cutter with its neck, shank and holder; checked once.
#[derive(Clone, Debug, PartialEq)]
pub struct Cutter {
    shape: CutterShape,
    cutting_length: f64,
    steps: Vec<ShankStep>,
    overhang: Option<f64>,
    /// Height at which the cutting part ends, mm.
    top: f64,
}

/// How far a corner may be larger than the radius before a ball is no ball: rounding of numbers in files.
const ROUNDING: f64 = 1e-12;

impl CutterShape {
    /// An end mill with a corner radius.
    pub const fn end_mill(radius: f64, corner_radius: f64) -> Self {
        Self::Conical { radius, half_angle: 0.0, corner_radius }
    }

    /// A ball.
    pub const fn ball(radius: f64) -> Self {
        Self::end_mill(radius, radius)
    }

    /// R, the radius at the tip plane of a cone, the largest one of a barrel, mm.
    pub const fn radius(&self) -> f64 {
        let (Self::Conical { radius, .. } | Self::Barrel { radius, .. }) = *self;
        radius
    }

    /// Whether the cutting part is one ball (with a neck or a shank above its middle).
    pub fn is_ball(&self) -> bool {
        matches!(self, Self::Conical { radius, half_angle, corner_radius }
            if *half_angle == 0.0 && (radius - corner_radius).abs() <= ROUNDING * radius)
    }

    /// Distance of a point at radius rho and height z from the cutting part, mm: exact outside, negative and not above the true
    /// distance inside; nowhere does it change faster than the point moves.
    #[inline]
    pub fn distance(&self, rho: f64, z: f64) -> f64 {
        self.support(rho, z).distance
    }

    /// The distance with its slope. It is a convex function of the point: over (rho, z) it is the distance from a convex region, signed
    /// or not, and it does not fall with rho, which is a convex function itself.
    #[inline(always)]
    pub fn support(&self, rho: f64, z: f64) -> Support {
        match *self {
            Self::Conical { radius, half_angle, corner_radius } => {
                // The convex core, all of its boundary moved inwards by the corner radius; its corner lies at (rho_c, r_c).
                let (sin, cos) = if half_angle == 0.0 { (0.0, 1.0) } else { half_angle.sin_cos() };
                let rho_c = radius + (sin - 1.0) * corner_radius / cos;
                let (x, y) = (rho - rho_c, z - corner_radius);
                let (off_side, up_side) = (cos * x - sin * y, sin * x + cos * y);
                let inside = off_side <= 0.0 && y >= 0.0;
                let (core, slope) = if inside && off_side >= -y || off_side > 0.0 && up_side >= 0.0 {
                    (off_side, [cos, -sin])
                } else if inside || y < 0.0 && x <= 0.0 {
                    (-y, [0.0, -1.0])
                } else {
                    let core = x.hypot(y);
                    (core, [x / core, y / core])
                };
                Support { distance: core - corner_radius, slope }
            }
            Self::Barrel { radius, height, profile_radius } => {
                // Of a drum, the arc's centre lies off the axis and what is inside of it is full.
                let middle = radius - profile_radius;
                let off = if middle > 0.0 { (rho - middle).max(0.0) } else { rho - middle };
                Support::from_core(off, z - height, profile_radius)
            }
        }
    }
}

/// Distance of a point from a convex part of a tool, and how it changes with the point's radius and height: at every other point the
/// distance is at least what goes on from here with this slope.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Support {
    /// The distance, mm, as [`CutterShape::distance`] has it.
    pub distance: f64,
    /// By the radius (>= 0) and by the height; no longer than 1.
    pub slope: [f64; 2],
}

impl Support {
    /// Off a circle of this radius by x and y from its middle.
    #[inline(always)]
    fn from_core(x: f64, y: f64, radius: f64) -> Self {
        let off = x.hypot(y);
        // At the middle the distance is least: no slope at all goes on below it.
        let slope = if off > 0.0 { [x / off, y / off] } else { [0.0; 2] };
        Self { distance: off - radius, slope }
    }
}

impl ShankStep {
    /// A cylinder that begins at a height: exact outside, and convex as the cutting part is.
    #[inline(always)]
    fn support(&self, rho: f64, z: f64) -> Support {
        let (x, y) = (rho - self.radius, self.from - z);
        if x <= 0.0 && y <= 0.0 {
            let (distance, slope) = if x >= y { (x, [1.0, 0.0]) } else { (y, [0.0, -1.0]) };
            return Support { distance, slope };
        }
        Support::from_core(x.max(0.0), -y.max(0.0), 0.0)
    }
}

impl Cutter {
    /// A cutter whose edges reach to `cutting_length` above the tip.
    ///
    /// # Errors
    /// [`GeometryError::InvalidNumber`] for sizes that are no tool (`E_TOOL` of `docs/mathematics/milling.md#limits`).
    pub fn new(
        shape: CutterShape,
        cutting_length: f64,
        steps: Vec<ShankStep>,
    ) -> Result<Self, GeometryError> {
        let need = |field, value: f64, good: bool, allowed| {
            let good = good && value.is_finite();
            if good { Ok(()) } else { Err(GeometryError::InvalidNumber { field, value, allowed }) }
        };
        match shape {
            CutterShape::Conical { radius, half_angle, corner_radius } => {
                need("cutter radius", radius, radius > 0.0, "> 0 mm")?;
                let angle = half_angle.to_degrees();
                need("cutter half_angle_deg", angle, (0.0..90.0).contains(&angle), "0 to below 90 deg")?;
                let largest = radius * half_angle.cos() / (1.0 - half_angle.sin());
                let fits = corner_radius >= 0.0 && corner_radius <= largest * (1.0 + ROUNDING);
                need("cutter corner_radius", corner_radius, fits, "0 to what the tip radius has room for")?;
            }
            CutterShape::Barrel { radius, height, profile_radius } => {
                need("cutter radius", radius, radius > 0.0, "> 0 mm")?;
                need("cutter profile_radius", profile_radius, profile_radius > 0.0, "> 0 mm")?;
                need("cutter largest_radius_height", height, height >= 0.0, ">= 0 mm")?;
            }
        }
        need("cutter cutting_length", cutting_length, cutting_length > 0.0, "> 0 mm")?;
        for step in &steps {
            need("cutter shank radius", step.radius, step.radius > 0.0, "> 0 mm")?;
            need("cutter shank from", step.from, step.from > 0.0, "> 0 mm above the tip")?;
        }
        Ok(Self { shape, cutting_length, steps, overhang: None, top: f64::INFINITY })
    }

    /// The cutting part.
    pub fn shape(&self) -> &CutterShape {
        &self.shape
    }

    /// l_c: height up to which the cutter cuts, mm above the tip.
    pub fn cutting_length(&self) -> f64 {
        self.cutting_length
    }

    /// Neck, shank and holder.
    pub fn steps(&self) -> &[ShankStep] {
        &self.steps
    }

    /// The cutter in a spindle of this diameter whose nose stands at this height above the tip, mm: the last cylinder of the tool.
    ///
    /// # Errors
    /// [`GeometryError::InvalidNumber`] for a height that is not above the tip and for a diameter that is none.
    pub fn in_spindle(mut self, overhang: f64, diameter: f64) -> Result<Self, GeometryError> {
        for (field, value) in [("tool_length", overhang), ("spindle_diameter", diameter)] {
            if !(value > 0.0 && value.is_finite()) {
                return Err(GeometryError::InvalidNumber { field, value, allowed: "> 0 mm" });
            }
        }
        self.overhang = Some(overhang);
        self.steps.push(ShankStep { radius: 0.5 * diameter, from: overhang });
        Ok(self)
    }

    /// Whether anything is known of what holds the cutter: shank, holder or spindle.
    pub fn is_held(&self) -> bool {
        !self.steps.is_empty()
    }

    /// The cutter whose cutting part goes on upwards to this height only, mm: for a cutter of which nothing else is known, in a bore that it
    /// would cross otherwise.
    pub fn ending_at(mut self, height: f64) -> Self {
        self.top = self.cutting_length.max(height);
        self
    }

    /// Height to which the cutting part is taken to go on, mm; infinite as a rule.
    pub fn top(&self) -> f64 {
        self.top
    }

    /// The cutting part up to its end. Next to the end the distance is below the true one.
    #[inline(always)]
    fn edges(&self, rho: f64, z: f64) -> Support {
        let support = self.shape.support(rho, z);
        let above = z - self.top;
        if above > support.distance { Support { distance: above, slope: [0.0, 1.0] } } else { support }
    }

    /// Height above the tip up to which the tool is known to go, mm: to the nose of the spindle, else to the begin of its last step, at
    /// least to the end of its edges.
    pub fn length(&self) -> f64 {
        let steps = self.steps.iter().map(|step| step.from);
        steps.chain(self.overhang).fold(self.cutting_length, f64::max)
    }

    /// Distance of a point in tool coordinates from the whole tool, mm, as [`CutterShape::distance`] has it; the cutting part is
    /// taken to go on upwards to its [`top`](Self::top).
    pub fn distance(&self, rho: f64, z: f64) -> f64 {
        let edges = self.edges(rho, z).distance;
        self.steps.iter().fold(edges, |least, step| least.min(step.support(rho, z).distance))
    }

    /// Distances and slopes of its convex parts: cutting part, neck, shank and holder.
    #[inline]
    pub fn supports(&self, rho: f64, z: f64) -> impl Iterator<Item = Support> {
        std::iter::once(self.edges(rho, z)).chain(self.steps.iter().map(move |s| s.support(rho, z)))
    }
}

/// Radius and height of a point in the coordinates of a tool with its tip at `tip` and the unit axis `axis` towards its shank.
#[inline]
pub fn in_tool(point: &Vector3<f64>, tip: &Vector3<f64>, axis: &Vector3<f64>) -> [f64; 2] {
    let from_tip = point - tip;
    let z = from_tip.dot(axis);
    // Not from the squares' difference: that loses half of the digits near the axis.
    [(from_tip - axis * z).norm(), z]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Shapes of every kind, balls and sharp corners among them.
    fn shapes() -> Vec<CutterShape> {
        let conical =
            |half_angle, corner_radius| CutterShape::Conical { radius: 3.0, half_angle, corner_radius };
        let barrel = |profile_radius| CutterShape::Barrel { radius: 3.0, height: 4.0, profile_radius };
        vec![
            conical(0.0, 0.0),
            conical(0.0, 1.0),
            conical(0.0, 3.0),
            conical(0.4, 0.0),
            conical(0.4, 1.0),
            barrel(40.0),
            barrel(3.0),
            barrel(1.0),
        ]
    }

    #[test]
    fn distances_lie_above_their_tangents() {
        let step = ShankStep { radius: 2.0, from: 5.0 };
        let places = || {
            let along = |n: usize| (0..n).map(move |k| k as f64 / n as f64);
            along(13).flat_map(move |u| along(17).map(move |v| (8.0 * u, 14.0 * v - 4.0)))
        };
        for shape in shapes() {
            let whole = Cutter::new(shape, 10.0, vec![step]).unwrap();
            let bare = Cutter::new(shape, 6.0, Vec::new()).unwrap().ending_at(7.0);
            let above = |z: f64| bare.distance(0.5, z);
            assert!(above(8.0) >= 1.0 && above(6.9) < above(8.0), "{shape:?}");
            for (cutter, (rho, z)) in
                [&whole, &bare].into_iter().flat_map(|cutter| places().map(move |place| (cutter, place)))
            {
                let parts: Vec<Support> = cutter.supports(rho, z).collect();
                let least = parts.iter().map(|part| part.distance).fold(f64::INFINITY, f64::min);
                assert_eq!(least, cutter.distance(rho, z));
                for part in &parts {
                    let [by_rho, by_z] = part.slope;
                    assert!(by_rho >= 0.0 && by_rho.hypot(by_z) <= 1.0 + 1e-15, "{shape:?} {part:?}");
                }
                for (other_rho, other_z) in places() {
                    for (other, part) in cutter.supports(other_rho, other_z).zip(&parts) {
                        let [by_rho, by_z] = part.slope;
                        let tangent = part.distance + by_rho * (other_rho - rho) + by_z * (other_z - z);
                        assert!(other.distance >= tangent - 1e-13, "{shape:?} {part:?} {other:?}");
                    }
                }
            }
        }
    }
}
