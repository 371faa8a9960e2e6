//! Patches that share sample points become one surface: vertices at the same place are united.

use super::triangle_mesh::TriangleMesh;
use std::collections::HashMap;
use std::collections::hash_map::Entry;

impl TriangleMesh {
    /// The mesh with vertices at equal coordinates united, in order of their first appearance. Equal means the same number: patches meet
    /// where their common edge was sampled once, or by the same formula. Vertices without a triangle fall away.
    #[must_use]
    pub fn welded(&self) -> Self {
        let mut numbers: HashMap<[u64; 3], u32> = HashMap::with_capacity(self.vertices.len());
        let mut welded = Self { vertices: Vec::new(), triangles: Vec::with_capacity(self.triangles.len()) };
        for corners in &self.triangles {
            welded.triangles.push(corners.map(|corner| {
                // What is out of range stays so.
                let Some(point) = self.vertices.get(corner as usize) else { return u32::MAX };
                // Adding zero makes -0 and 0 the same place.
                match numbers.entry([point.x, point.y, point.z].map(|c| (c + 0.0).to_bits())) {
                    Entry::Occupied(known) => *known.get(),
                    Entry::Vacant(place) => {
                        welded.vertices.push(*point);
                        *place.insert(welded.vertices.len() as u32 - 1)
                    }
                }
            }));
        }
        welded
    }
}
