//! Places of a virtual edge: where it touches the finished flank, and the section of the edge around it.

use nalgebra::Vector3;

/// What the virtual tool and the finished flank share at one length of roll. Tool coordinates of tooth 0 unless said otherwise; mm, rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactPlace {
    /// w of the flank, mm.
    pub w: f64,
    /// f_n of the target there.
    pub modification: f64,
    /// chi: turn of the profile from its rest position.
    pub turn: f64,
    /// phi_1.
    pub tool_angle: f64,
    /// q: the point in the room beside the workpiece.
    pub engagement: Vector3<f64>,
    /// The workpiece's normal there, out of its material.
    pub work_normal: Vector3<f64>,
    /// m: the virtual contact point.
    pub point: Vector3<f64>,
    /// n_m: the tool's normal there, out of its material.
    pub normal: Vector3<f64>,
    /// g: direction of the flank's helix there, towards +z of the workpiece.
    pub flank_direction: Vector3<f64>,
    /// c: centre of the rounding.
    pub centre: Vector3<f64>,
    /// L = m_x n_y - m_y n_x: way of the normal per turn of the tool, mm/rad.
    pub lever: f64,
}

/// The section of the edge across its centre curve. Angles on the rounding count from the rake face's normal. mm, rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EdgeSection {
    /// c.
    pub centre: Vector3<f64>,
    /// t: direction of the centre curve.
    pub tangent: Vector3<f64>,
    /// n_r: normal of the rake face.
    pub rake_normal: Vector3<f64>,
    /// u: perpendicular to t and n_r, out of the tooth.
    pub outward: Vector3<f64>,
    /// n_c: normal of the clearance face.
    pub clearance_normal: Vector3<f64>,
    /// g_c: ruling of the clearance face, away from the edge.
    pub ruling: Vector3<f64>,
    /// Angle theta of the contact point.
    pub contact_angle: f64,
    /// Angle theta_c of the clearance face's normal.
    pub clearance_angle: f64,
    /// [theta_lo, theta_hi]: the rounding between its chamfers.
    pub range: [f64; 2],
}

impl EdgeSection {
    /// The normal of the rounding at an angle.
    pub fn direction(&self, angle: f64) -> Vector3<f64> {
        let (sin, cos) = angle.sin_cos();
        self.rake_normal * cos + self.outward * sin
    }

    /// The rounding's angle of a direction.
    pub fn angle_of(&self, direction: &Vector3<f64>) -> f64 {
        direction.dot(&self.outward).atan2(direction.dot(&self.rake_normal))
    }

    /// v: which way the centre goes when the rounding grows by a unit between its two faces, times minus one
    /// (`docs/mathematics/skiving.md#the-virtual-edge`).
    pub fn growth(&self) -> Vector3<f64> {
        (self.rake_normal + self.clearance_normal) / (1.0 + self.clearance_angle.cos())
    }

    /// How far the surface at an angle comes out per unit of a growing rounding; < 0 between the faces.
    pub fn growth_at(&self, angle: f64) -> f64 {
        let half = 0.5 * self.clearance_angle;
        1.0 - (angle - half).cos() / half.cos()
    }
}
