//! Errors of a mesh and of the data that go with it.

use thiserror::Error;

/// Errors of meshes and of their files. Counting begins with 0.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum MeshError {
    /// A number that is not finite or too large for a file.
    #[error("{what} {index} holds {value}; allowed: {allowed}")]
    InvalidNumber {
        /// Kind of the element, or name of the point data.
        what: String,
        /// Which one.
        index: usize,
        /// The offending value.
        value: f64,
        /// Allowed range in words.
        allowed: &'static str,
    },
    /// A list with another number of elements than it must have.
    #[error("{what}: {found} given, {expected} needed")]
    WrongCount {
        /// What the list holds.
        what: String,
        /// Elements needed.
        expected: usize,
        /// Elements given.
        found: usize,
    },
    /// A list with fewer elements than make sense.
    #[error("{what}: {found} given, at least {least} needed")]
    TooFew {
        /// What the list holds.
        what: &'static str,
        /// Least number.
        least: usize,
        /// Elements given.
        found: usize,
    },
    /// A list with more elements than a file can number.
    #[error("{what}: {found} given, at most {most} can be written")]
    TooMany {
        /// What the list holds.
        what: &'static str,
        /// Largest number.
        most: usize,
        /// Elements given.
        found: usize,
    },
    /// A corner that is no vertex.
    #[error("triangle {triangle} names vertex {vertex}, but there are {vertices} vertices")]
    IndexOutOfRange {
        /// The triangle.
        triangle: usize,
        /// The vertex it names.
        vertex: u32,
        /// Number of vertices.
        vertices: usize,
    },
    /// A triangle without area: corners on one line within the rounding of their coordinates.
    #[error("triangle {triangle} has no area")]
    DegenerateTriangle {
        /// The triangle.
        triangle: usize,
    },
    /// An edge without exactly one triangle on each side.
    #[error(
        "the edge from vertex {from} to vertex {to} is used {along} times in this sense and {against} times in the other; \
         a closed body has it once in each"
    )]
    NotWatertight {
        /// First vertex of the edge.
        from: u32,
        /// Its second vertex.
        to: u32,
        /// Triangles that run along it.
        along: usize,
        /// Triangles that run against it.
        against: usize,
    },
    /// A closed mesh that encloses nothing.
    #[error("the body encloses no volume")]
    NoVolume,
    /// An outline that crosses or touches itself or a hole, or a hole that does not lie inside.
    #[error("the outline of section {section} and its holes bound no area: {reason}")]
    OutlineNotSimple {
        /// The section, from 0.
        section: usize,
        /// What was found.
        reason: &'static str,
    },
    /// Two sets of point data with one name.
    #[error("two sets of point data are called `{name}`")]
    DuplicateName {
        /// The name.
        name: String,
    },
    /// The package of a 3MF file cannot be made.
    #[error("the 3MF package cannot be made: {reason}")]
    Package {
        /// What the packer says.
        reason: String,
    },
}

impl MeshError {
    /// A stable name of the error, for scripts.
    pub fn code(&self) -> &'static str {
        match self {
            Self::InvalidNumber { .. } => "invalid-number",
            Self::WrongCount { .. } => "wrong-count",
            Self::TooFew { .. } => "too-few",
            Self::TooMany { .. } => "too-many",
            Self::IndexOutOfRange { .. } => "index-out-of-range",
            Self::DegenerateTriangle { .. } => "degenerate-triangle",
            Self::NotWatertight { .. } => "not-watertight",
            Self::NoVolume => "no-volume",
            Self::OutlineNotSimple { .. } => "outline-not-simple",
            Self::DuplicateName { .. } => "duplicate-name",
            Self::Package { .. } => "package",
        }
    }

    /// What the user can do about it, in one sentence.
    pub fn way_out(&self) -> &'static str {
        match self {
            Self::InvalidNumber { .. } => "leave out the points without a value or give them one",
            Self::WrongCount { .. } => "give one element for each place",
            Self::TooFew { .. } => "sample the surface or the path with more points",
            Self::TooMany { .. } => "sample more coarsely or write several files",
            Self::IndexOutOfRange { .. } => "number the vertices from 0 in the order of their list",
            Self::DegenerateTriangle { .. } => "leave the triangle out or move its corners apart",
            Self::NotWatertight { .. } => {
                "join the patches with common vertices and turn them to the same side"
            }
            Self::NoVolume => "move the sections apart",
            Self::OutlineNotSimple { .. } => {
                "sample the outline so that it runs round once without meeting itself"
            }
            Self::DuplicateName { .. } => "name each set of point data differently",
            Self::Package { .. } => "sample more coarsely or write several files",
        }
    }
}
