//! Statistics of a mesh's blocks that need no ray.

use protocol::layout::MESH_BLOCK;

/// The size of a mesh's blocks, and the work for a ray that meets the mesh's box, expected
/// according to the surface area heuristic: rays from all sides that nothing stops.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MeshStatistics {
    /// Triangles in blocks.
    pub triangles: usize,
    /// Spheres in blocks.
    pub spheres: usize,
    /// Cones in blocks.
    pub cones: usize,
    /// Triangles without an area, which are in no block.
    pub left_out: usize,
    /// Leaf blocks.
    pub leaves: usize,
    /// Inner blocks.
    pub inner: usize,
    /// Blocks that a ray needs.
    pub expected_blocks: f64,
    /// Nodes, of four boxes each, that a ray is tested with.
    pub expected_nodes: f64,
    /// Triangles that a ray is tested with.
    pub expected_triangles: f64,
    /// Spheres that a ray is tested with.
    pub expected_spheres: f64,
    /// Cones that a ray is tested with.
    pub expected_cones: f64,
}

impl MeshStatistics {
    /// The number of shapes in blocks: triangles, spheres and cones.
    #[must_use]
    pub fn objects(&self) -> usize {
        self.triangles + self.spheres + self.cones
    }

    /// All bytes by the number of triangles.
    #[must_use]
    pub fn bytes_a_triangle(&self) -> f64 {
        let blocks = self.leaves + self.inner;
        (blocks * MESH_BLOCK as usize) as f64 / self.triangles.max(1) as f64
    }
}
