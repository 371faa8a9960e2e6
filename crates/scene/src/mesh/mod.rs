//! Bodies, patches and tool paths as files for other programs: binary STL, 3MF and VTK PolyData, made in memory. Positions in mm.
//!
//! A solid is a [`TriangleMesh`] from [`patch`], [`swept`], [`revolved`] or by hand; every writer checks it first ([`TriangleMesh::check`]). The same
//! input gives the same bytes, on every machine.

mod cap;
mod edges;
pub mod error;
pub mod patch;
pub mod revolved;
mod section;
pub mod stl;
pub mod swept;
pub mod three_mf;
pub mod triangle_mesh;
mod vtk_document;
pub mod vtp;
mod weld;

pub use error::MeshError;
pub use patch::{PatchSide, patch};
pub use revolved::revolved;
pub use section::Section;
pub use stl::stl;
pub use swept::swept;
pub use three_mf::{NamedMesh, three_mf};
pub use triangle_mesh::{LARGEST_COORDINATE, TriangleMesh};
pub use vtp::{PointData, PointValues, vtp_of_mesh, vtp_of_paths};
