//! The strokes of a job on its bodies, as data: which dresser touches which part of the worm's profile. How they are laid out stands in
//! `stroke_layout`.

use dressing::{ActiveArea, DresserTool, WidthLaw};
use foundation::geometry::Sides;

/// One stroke: what dresses which lengths of roll.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StrokePlace {
    /// Number of the dresser, from 0.
    pub dresser: usize,
    /// What of it cuts.
    pub area: ActiveArea,
    /// Lengths of roll of the worm on which the active part is laid in the middle of the face, mm.
    pub range: [f64; 2],
    /// The same over the face, where it moves: laws of q, from -1 to 1 over the evaluated face.
    pub over_face: Option<[WidthLaw; 2]>,
}

impl StrokePlace {
    /// Least start and largest end over the face, mm.
    pub fn reach(&self) -> [f64; 2] {
        self.over_face.map_or(self.range, |[from, to]| [from.extremes(1.0)[0], to.extremes(1.0)[1]])
    }
}

/// The strokes of a job on its bodies.
#[derive(Clone, Debug)]
pub struct StrokeLayout {
    /// The dressers on the worm, each with its own modification.
    pub dressers: Vec<DresserTool>,
    /// Their tip radii, mm.
    pub tip_radii: Vec<f64>,
    /// The strokes of each flank, in ascending order of the sections.
    pub strokes: Sides<Vec<StrokePlace>>,
    /// Lengths of roll that have to be dressed: the used profile and what the contact may leave it by, up to the worm's tip. mm.
    pub profile: Sides<[f64; 2]>,
}
