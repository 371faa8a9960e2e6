//! The part of a surface that is to be milled: from root to tip and between the ends of the face.

use foundation::geometry::Surface;
use nalgebra::Vector3;
use std::sync::Arc;

/// A body of revolution about the workpiece's axis that ends a flank: G = 0 on it, > 0 outside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LimitBody {
    /// A cylinder of this radius, mm.
    Cylinder(f64),
    /// A cone.
    Cone {
        /// Position of the apex on the axis, mm.
        apex: f64,
        /// Half angle, rad; the cone opens towards +z.
        half_angle: f64,
    },
}

impl LimitBody {
    /// G: distance of a point from the body, mm, > 0 outside.
    pub fn off(&self, point: &Vector3<f64>) -> f64 {
        let radius = point.x.hypot(point.y);
        match *self {
            Self::Cylinder(limit) => radius - limit,
            Self::Cone { apex, half_angle } => {
                let (sin, cos) = half_angle.sin_cos();
                radius * cos - (point.z - apex) * sin
            }
        }
    }
}

/// Where a flank begins and ends in height: [root, tip].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum HeightLimits {
    /// At constant parameters. The root may be the larger one (internal gears).
    Constant([f64; 2]),
    /// On bodies of revolution, looked for between two parameters [root side, tip side].
    Bodies {
        /// The body at the root and the one at the tip.
        bodies: [LimitBody; 2],
        /// Parameters between which both lie in every column.
        between: [f64; 2],
    },
}

/// What positions along the teeth of both halves are counted along.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Along {
    /// The axis: of a cylindrical gear.
    Axis,
    /// Rays from the apex: of a bevel gear.
    Rays,
}

/// The middle of a double-helical gear, seen from one half. mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Kink {
    /// Where the halves would meet, in the length parameter.
    pub length: f64,
    /// On which side (+1 or -1) the half lies.
    pub side: f64,
    /// What the length is counted along.
    pub along: Along,
}

impl Kink {
    /// Where along the teeth a point lies, mm.
    pub fn position(&self, point: &Vector3<f64>) -> f64 {
        match self.along {
            Along::Axis => point.z,
            Along::Rays => point.norm(),
        }
    }
}

/// A flank that is to be milled.
#[derive(Clone, Debug)]
pub struct ActiveFlank {
    /// The surface.
    pub surface: Arc<dyn Surface>,
    /// From root to tip.
    pub heights: HeightLimits,
    /// Both ends of the face in the length parameter, ascending.
    pub face: [f64; 2],
    /// What nothing that is milled may cross: where the halves of a double-helical gear meet.
    pub kink: Option<Kink>,
}

impl ActiveFlank {
    /// Parameters of the height that hold the whole flank, [root side, tip side].
    pub fn height_span(&self) -> [f64; 2] {
        match self.heights {
            HeightLimits::Constant(heights) => heights,
            HeightLimits::Bodies { between, .. } => between,
        }
    }

    /// The flank as if it went on beyond the middle of a double-helical gear, as all flanks do beyond the ends of their faces: columns
    /// that meet it there hold virtual points.
    pub fn extended(&self) -> Self {
        Self { kink: None, ..self.clone() }
    }

    /// Whether a length lies beyond the ends of the face, where the points are virtual.
    pub fn is_virtual(&self, length: f64) -> bool {
        length < self.face[0] || length > self.face[1]
    }
}
