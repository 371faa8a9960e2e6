//! Errors of a mesh and of the data that go with it.

use finding::Finding;
use thiserror::Error;

/// Errors of meshes and of their files. Counting begins with 0.
#[derive(Clone, Debug, PartialEq, Error, Finding)]
pub enum MeshError {
    /// A number that is not finite or too large for a file.
    #[error("{what} {index} holds {value}; allowed: {allowed}")]
    #[finding(code = "invalid-number")]
    #[way_out("leave out the points without a value or give them one")]
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
    #[finding(code = "wrong-count")]
    #[way_out("give one element for each place")]
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
    #[finding(code = "too-few")]
    #[way_out("sample the surface or the path with more points")]
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
    #[finding(code = "too-many")]
    #[way_out("sample more coarsely or write several files")]
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
    #[finding(code = "index-out-of-range")]
    #[way_out("number the vertices from 0 in the order of their list")]
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
    #[finding(code = "degenerate-triangle")]
    #[way_out("leave the triangle out or move its corners apart")]
    DegenerateTriangle {
        /// The triangle.
        triangle: usize,
    },
    /// An edge without exactly one triangle on each side.
    #[error(
        "the edge from vertex {from} to vertex {to} is used {along} times in this sense and {against} times in the other; \
         a closed body has it once in each"
    )]
    #[finding(code = "not-watertight")]
    #[way_out("join the patches with common vertices and turn them to the same side")]
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
    #[finding(code = "no-volume")]
    #[way_out("move the sections apart")]
    NoVolume,
    /// An outline that crosses or touches itself or a hole, or a hole that does not lie inside.
    #[error("the outline of section {section} and its holes bound no area: {reason}")]
    #[finding(code = "outline-not-simple")]
    #[way_out("sample the outline so that it runs round once without meeting itself")]
    OutlineNotSimple {
        /// The section, from 0.
        section: usize,
        /// What was found.
        reason: &'static str,
    },
    /// Two sets of point data with one name.
    #[error("two sets of point data are called `{name}`")]
    #[finding(code = "duplicate-name")]
    #[way_out("name each set of point data differently")]
    DuplicateName {
        /// The name.
        name: String,
    },
    /// The package of a 3MF file cannot be made.
    #[error("the 3MF package cannot be made: {reason}")]
    #[finding(code = "package")]
    #[way_out("sample more coarsely or write several files")]
    Package {
        /// What the packer says.
        reason: String,
    },
}
