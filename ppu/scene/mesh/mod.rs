//! Meshes, spheres and cones in the form that SPUs stream from main memory: a BVH of boxes over
//! triangles, spheres and cones, cut into blocks of one DMA transfer each.
//!
//! A block has nodes in a few complete levels, and a leaf block also its triangles with their
//! vertices and texture coordinates, or its spheres or cones (`protocol/src/layout/mesh.rs`).
//! Positions are the mesh's own singles, so a box holds exactly its vertices. The triangles are
//! divided by the surface area heuristic until they fit a leaf block each; near that size the
//! heuristic counts blocks instead of triangles, so that blocks get full.
//!
//! Invariant: every sphere, cone, and triangle with an area is in exactly one leaf block. A
//! child's number is greater than its parent's, and all triangles of a block have the same sides. A
//! triangle without an area is left out: no ray hits it.

mod changes;
mod colour;
mod cone;
mod cut;
mod gather;
mod leaf;
mod moved;
mod moving;
mod normal;
mod objects;
mod pack;
mod pack_objects;
mod refit;
mod sorted;
mod sphere;
mod statistics;
mod sweep;
#[cfg(test)]
mod tests;
mod tree;
mod units;
mod write;

use glam::DVec3;
use protocol::layout::{
    MESH_BLOCK, MESH_BLOCKS, MESH_MATERIALS, SIDES_BOTH, SIDES_SMOOTH, SIDES_TEXTURED,
    STREAMED_MATERIALS,
};
use scenes::{Material, Mesh};

use self::colour::packed;
use self::tree::{Bounds, Kind, Piece, Tree};
use super::colour::Colour;
use super::single::LARGEST;

pub use self::cone::MeshCone;
pub(crate) use self::cone::Slant;
pub use self::gather::gathered;
pub(crate) use self::gather::{RESIDENT, are_many, gathered_all};
pub use self::moved::MovedVertices;
pub(in crate::scene) use self::moving::MovingObjects;
pub(in crate::scene) use self::objects::MeshObject;
pub use self::objects::MeshObjects;
pub use self::sorted::SortedMesh;
pub use self::sphere::MeshSphere;
pub use self::statistics::MeshStatistics;
pub(crate) use self::write::header as block_header;

/// The kinds of pieces: triangles by their sides, then spheres and cones, then a height field.
const KINDS: [Kind; 11] = [
    Kind::Triangles(0),
    Kind::Triangles(SIDES_BOTH),
    Kind::Triangles(SIDES_SMOOTH),
    Kind::Triangles(SIDES_BOTH | SIDES_SMOOTH),
    Kind::Triangles(SIDES_TEXTURED),
    Kind::Triangles(SIDES_TEXTURED | SIDES_BOTH),
    Kind::Triangles(SIDES_TEXTURED | SIDES_SMOOTH),
    Kind::Triangles(SIDES_TEXTURED | SIDES_BOTH | SIDES_SMOOTH),
    Kind::Spheres,
    Kind::Cones,
    Kind::Heights,
];
/// The place of spheres among them.
const SPHERES: usize = KINDS.len() - 3;
/// The place of cones.
const CONES: usize = KINDS.len() - 2;
/// The place of a height field.
const HEIGHTS: usize = KINDS.len() - 1;

/// Why a mesh can't be converted.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MeshError {
    /// No triangle has an area.
    #[error("all {0} triangles of the mesh are degenerate: their area is 0")]
    NoArea(usize),
    /// A coordinate is outside of the range in which the SPU's single format can hold its square.
    #[error("vertex {vertex} is at {position:?}: coordinates must be at most 2^62")]
    OutOfRange {
        /// The vertex's index.
        vertex: usize,
        /// Its position.
        position: [f32; 3],
    },
    /// The triangles and objects have too many materials.
    #[error("the scene's objects have {0} different materials; there may be {STREAMED_MATERIALS}")]
    TooManyMaterials(usize),
    /// The triangles take too many blocks.
    #[error("the mesh takes {0} blocks; there may be {MESH_BLOCKS}")]
    TooManyBlocks(usize),
}

/// A block's bytes, aligned as its DMA transfer needs it.
#[derive(Clone, Debug)]
#[repr(C, align(128))]
pub(crate) struct Block(pub [u8; MESH_BLOCK as usize]);

/// How wide the materials' numbers are in blocks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NumberWidth {
    /// A byte, for materials in local store.
    Byte,
    /// Two bytes, for materials in main memory.
    TwoBytes,
}

/// A height field beside the mesh.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ground {
    /// The box around it.
    bounds: Bounds,
    /// Its material.
    material: u32,
}

impl Ground {
    /// A height field between two corners, of a material of the scene. The box is a little larger.
    pub fn new([low, high]: [DVec3; 2], material: u32) -> Self {
        let [low, high] = [low, high].map(|corner| corner.as_vec3());
        let margin = low.abs().max(high.abs()).max_element() / (1 << 20) as f32;
        Self { bounds: Bounds { low: low - margin, high: high + margin }, material }
    }
}

/// The numbers of materials in blocks.
#[derive(Clone, Copy, Debug)]
pub(super) struct Numbers<'a> {
    /// For each material the first one that shares its number.
    pub firsts: &'a [u32],
    /// Their minimum width.
    pub minimum: NumberWidth,
}

/// A mesh in blocks.
#[derive(Clone, Debug)]
pub struct MeshBlocks {
    blocks: Vec<Block>,
    /// The number of blocks, of which not all need to be there.
    most: u32,
    materials: Vec<u32>,
    width: NumberWidth,
    is_coloured: bool,
    has_visibility: bool,
    /// The mesh's vertices that leaf blocks have, block after block.
    sources: Vec<u32>,
    /// How many vertices the mesh has.
    vertices: usize,
    /// The vertices with a normal of 0, in their order.
    flat: Vec<u32>,
    /// The triangles that were left out, because they had no area.
    without_area: Vec<u32>,
    /// Whether the triangles have all vertices.
    uses_all: bool,
    /// The surfaces of all boxes, each times the tests that a ray makes that meets it.
    cost: f64,
    cost_when_built: f64,
    statistics: MeshStatistics,
}

fn has_area(mesh: &Mesh, triangle: usize) -> bool {
    let [a, b, c] = mesh.corners(triangle).map(|corner| corner.as_dvec3());
    (b - a).cross(c - a) != DVec3::ZERO
}

/// Whether SPUs can compute with a position.
fn in_range(position: &[f32; 3]) -> bool {
    position.iter().all(|number| f64::from(number.abs()) <= LARGEST)
}

impl MeshBlocks {
    /// At most this number of blocks of a mesh, which are not made yet, and have these materials.
    fn unmade(mesh: &Mesh, materials: Vec<u32>, most: u32) -> Self {
        Self {
            blocks: Vec::new(),
            most,
            materials,
            width: NumberWidth::Byte,
            is_coloured: false,
            has_visibility: false,
            sources: Vec::new(),
            vertices: mesh.positions.len(),
            flat: write::flat(mesh).collect(),
            without_area: Vec::new(),
            uses_all: write::uses_all(mesh),
            cost: 1.0,
            cost_when_built: 1.0,
            statistics: MeshStatistics {
                triangles: mesh.triangles.len(),
                ..MeshStatistics::default()
            },
        }
    }

    /// Builds the BVH of a mesh and of objects whose materials are in `materials`, and cuts it
    /// into blocks. Their positions are relative to the mesh's origin. Each material that has a
    /// triangle or an object has its own number, and the numbers are as narrow as they can be.
    /// Colours of vertices are light.
    ///
    /// # Errors
    /// - No triangle has an area, and there is no object.
    /// - A coordinate is out of range.
    /// - There are more materials or blocks than the SPUs support.
    ///
    /// # Panics
    /// A triangle has a vertex, or it or an object a material, that doesn't exist.
    pub fn new(
        mesh: &Mesh,
        objects: &MeshObjects,
        materials: &[Material],
    ) -> Result<Self, MeshError> {
        let own: Vec<u32> = (0..).take(materials.len()).collect();
        let numbers = Numbers { firsts: &own, minimum: NumberWidth::Byte };
        Self::numbered(mesh, objects, None, materials, numbers, Colour::Linear)
    }

    /// [`MeshBlocks::new`] where materials may share their numbers, and with the place of a height
    /// field. `colour` is the colour space of vertices.
    pub(super) fn numbered(
        mesh: &Mesh,
        objects: &MeshObjects,
        ground: Option<Ground>,
        materials: &[Material],
        Numbers { firsts, minimum }: Numbers<'_>,
        colour: Colour,
    ) -> Result<Self, MeshError> {
        if let Some(vertex) = mesh.positions.iter().position(|it| !in_range(it)) {
            let position = mesh.positions[vertex];
            return Err(MeshError::OutOfRange { vertex, position });
        }
        let both: Vec<bool> = materials
            .iter()
            .map(|material| mesh.two_sided || material.transmittance > 0.0)
            .collect();
        let mut without_area = Vec::new();
        let mut kinds: [Vec<Piece>; KINDS.len()] = Default::default();
        let mut numbers = vec![None; materials.len()];
        let mut used = Vec::new();
        let mut number = |material: usize| {
            let first = firsts[material];
            numbers[first as usize].get_or_insert_with(|| {
                used.push(first);
                used.len() - 1
            });
        };
        if let Some(ground) = ground {
            // The number 0 stands for its material.
            number(ground.material as usize);
            kinds[HEIGHTS] = vec![Piece { bounds: ground.bounds, index: 0 }];
        }
        for material in objects.materials() {
            number(material as usize);
        }
        kinds[SPHERES] = objects.sphere_pieces();
        kinds[CONES] = objects.cone_pieces();
        for (triangle, &material) in mesh.materials.iter().enumerate() {
            if !has_area(mesh, triangle) {
                without_area.push(triangle as u32);
                continue;
            }
            let material = material as usize;
            number(material);
            let smooth = mesh.corner_normals(triangle).is_some();
            let textured = materials[material].texture.is_some()
                && mesh.corner_coordinates(triangle).is_some();
            let kind =
                usize::from(both[material]) + 2 * usize::from(smooth) + 4 * usize::from(textured);
            let corners = mesh.corners(triangle);
            kinds[kind].push(Piece {
                bounds: Bounds {
                    low: corners[0].min(corners[1]).min(corners[2]),
                    high: corners[0].max(corners[1]).max(corners[2]),
                },
                index: triangle as u32,
            });
        }
        if used.is_empty() {
            return Err(MeshError::NoArea(mesh.triangles.len()));
        }
        let width = match used.len() {
            count if count > STREAMED_MATERIALS as usize => {
                return Err(MeshError::TooManyMaterials(count));
            }
            count if count > MESH_MATERIALS as usize => NumberWidth::TwoBytes,
            _ => minimum,
        };

        let ranges = kinds.each_ref().map(Vec::len);
        let mut tree = Tree::new(mesh, kinds.concat(), width);
        let mut start = 0;
        let mut root = None;
        // The kind of the pieces before each index.
        let mut ends = Vec::new();
        for (length, kind) in ranges.into_iter().zip(KINDS) {
            if length > 0 {
                let grown = tree.grow(kind, start..start + length);
                root = Some(root.map_or(grown, |root| tree.join([root, grown])));
                start += length;
                ends.push((start, kind));
            }
        }
        let Some(root) = root else {
            return Err(MeshError::NoArea(mesh.triangles.len()));
        };
        let number = |&first: &u32| numbers[first as usize].unwrap_or_default() as u32;
        let numbers: Vec<u32> = firsts.iter().map(number).collect();
        let colours: Vec<u32> = mesh.colours.iter().map(|it| packed(*it, colour)).collect();
        let content = write::Content { mesh, objects, numbers: &numbers, colours: &colours };
        let blocks = write::blocks(content, tree, root, &ends, used)?;
        Ok(Self { without_area, ..blocks })
    }

    /// Whether a triangle that was left out has an area now.
    pub(crate) fn lacks_triangles(&self, mesh: &Mesh) -> bool {
        self.without_area.iter().any(|&triangle| has_area(mesh, triangle as usize))
    }

    /// The number of blocks.
    #[must_use]
    pub fn count(&self) -> u32 {
        self.most
    }

    /// The bytes of all blocks, aligned to 128 bytes. SPUs read them by their address.
    #[must_use]
    pub fn bytes(&self) -> &[u8] {
        let start = self.blocks.as_ptr().cast::<u8>();
        // SAFETY: the blocks are arrays of bytes, without padding, one after another: their size is
        // a multiple of their alignment. The slice borrows `self`, and bytes have no alignment.
        unsafe { std::slice::from_raw_parts(start, self.blocks.len() * MESH_BLOCK as usize) }
    }

    /// The address of the first block, for SPUs.
    #[must_use]
    pub fn address(&self) -> u64 {
        self.blocks.as_ptr().expose_provenance() as u64
    }

    /// The materials of the triangles and spheres, as indices in the scene's materials, in the
    /// order of their numbers in blocks. Of those that share a number it has the first one.
    #[must_use]
    pub fn materials(&self) -> &[u32] {
        &self.materials
    }

    /// Whether the triangles have colours at their vertices.
    #[must_use]
    pub fn is_coloured(&self) -> bool {
        self.is_coloured
    }

    /// Whether the triangles have masks of the lights that need no shadow rays.
    #[must_use]
    pub fn has_visibility(&self) -> bool {
        self.has_visibility
    }

    /// How wide these numbers are in blocks.
    #[must_use]
    pub fn width(&self) -> NumberWidth {
        self.width
    }

    /// How large the blocks are, and how much work they are for a ray.
    #[must_use]
    pub fn statistics(&self) -> MeshStatistics {
        self.statistics
    }
}
