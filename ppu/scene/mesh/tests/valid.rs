//! Checks every field of every block, as an SPU could, and against the mesh.

use std::collections::HashMap;

use glam::Vec3;
use protocol::layout::{
    Boxes, Cone, MESH_BLOCK, MESH_CONES, MESH_FACES, MESH_INNER, MESH_LEAF, MESH_LEVELS,
    MESH_MAGIC, MESH_RUN, MESH_SPHERES, MESH_UPPER, MESH_VERTICES, MeshColour, MeshCoordinates,
    MeshFace, MeshHeader, MeshVertex, MeshVisibility, NO_BOX, Object, SIDES_BOTH, SIDES_COLOURED,
    SIDES_SMOOTH, SIDES_TEXTURED, SIDES_VISIBILITY, SIDES_WIDE,
};
use scenes::{Material, Mesh};
use zerocopy::FromBytes as _;
use zerocopy::big_endian::F32;

use super::super::colour::packed as packed_colour;
use super::super::normal::packed;
use super::super::{Colour, MeshBlocks, tree::Bounds};

/// A block, taken apart.
pub struct Parts {
    pub header: MeshHeader,
    pub nodes: Vec<Boxes>,
    pub vertices: Vec<MeshVertex>,
    pub faces: Vec<MeshFace>,
    pub coordinates: Vec<MeshCoordinates>,
    pub colours: Vec<MeshColour>,
    pub visibility: Vec<MeshVisibility>,
    /// The upper bytes of the faces' materials, or zeros.
    pub upper: Vec<u8>,
}

impl Parts {
    pub fn of(blocks: &MeshBlocks, number: u32) -> Self {
        let size = MESH_BLOCK as usize;
        let block = &blocks.bytes()[number as usize * size..][..size];
        let (header, rest) = MeshHeader::read_from_prefix(block).unwrap();
        let count = |count: zerocopy::big_endian::U32| count.get() as usize;
        let (nodes, rest) =
            <[Boxes]>::ref_from_prefix_with_elems(rest, count(header.nodes)).unwrap();
        let (vertices, rest) =
            <[MeshVertex]>::ref_from_prefix_with_elems(rest, count(header.vertices)).unwrap();
        let record = match header.kind.get() {
            MESH_SPHERES => size_of::<Object>(),
            MESH_CONES => size_of::<Cone>(),
            _ => 0,
        };
        let has_objects = record > 0;
        let faces = if has_objects { 0 } else { count(header.triangles) };
        let (faces, rest) = <[MeshFace]>::ref_from_prefix_with_elems(rest, faces).unwrap();
        let rest = &rest[record * count(header.triangles)..];
        // Texture coordinates begin at the next quadword.
        let is_textured = header.sides.get() & SIDES_TEXTURED != 0;
        let gap = if is_textured { rest.len() % 16 } else { 0 };
        assert!(rest[..gap].iter().all(|&byte| byte == 0), "block {number}");
        let coordinates = if is_textured { vertices.len() } else { 0 };
        let (coordinates, rest) =
            <[MeshCoordinates]>::ref_from_prefix_with_elems(&rest[gap..], coordinates).unwrap();
        let is_coloured = header.sides.get() & SIDES_COLOURED != 0;
        let gap = if is_coloured { rest.len() % 16 } else { 0 };
        assert!(rest[..gap].iter().all(|&byte| byte == 0), "block {number}");
        let colours = if is_coloured { vertices.len() } else { 0 };
        let (colours, rest) =
            <[MeshColour]>::ref_from_prefix_with_elems(&rest[gap..], colours).unwrap();
        let is_marked = header.sides.get() & SIDES_VISIBILITY != 0;
        let gap = if is_marked { rest.len() % 16 } else { 0 };
        assert!(rest[..gap].iter().all(|&byte| byte == 0), "block {number}");
        let visibility = if is_marked { faces.len() } else { 0 };
        let (visibility, rest) =
            <[MeshVisibility]>::ref_from_prefix_with_elems(&rest[gap..], visibility).unwrap();
        let is_wide = header.sides.get() & SIDES_WIDE != 0;
        let mut upper = vec![0; faces.len()];
        let (rest, following) = match is_wide {
            true => rest.split_at(rest.len() - (MESH_BLOCK - MESH_UPPER) as usize),
            false => (rest, &[][..]),
        };
        assert!(rest.iter().all(|&byte| byte == 0), "block {number}");
        if is_wide {
            let (own, following) = following.split_at(faces.len());
            upper.copy_from_slice(own);
            assert!(following.iter().all(|&byte| byte == 0), "block {number}");
        }
        Self {
            header,
            nodes: nodes.to_vec(),
            vertices: vertices.to_vec(),
            faces: faces.to_vec(),
            coordinates: coordinates.to_vec(),
            colours: colours.to_vec(),
            visibility: visibility.to_vec(),
            upper,
        }
    }

    /// The boxes and offsets of a leaf's spheres or cones.
    pub fn objects(&self) -> Vec<(Bounds, u32)> {
        let mut boxes = self.children(size_of::<MeshHeader>() as u32);
        if self.header.levels.get() == 2 {
            boxes = boxes.iter().flat_map(|it| self.children(it.1)).collect();
        }
        assert_eq!(boxes.len() as u32, self.header.triangles.get());
        boxes
    }

    pub fn is_leaf(&self) -> bool {
        self.header.kind.get() == MESH_LEAF
    }

    pub fn position(&self, vertex: u8) -> Vec3 {
        let position = self.vertices[vertex as usize].position;
        position.map(F32::get).into()
    }

    pub fn corners(&self, face: usize) -> [Vec3; 3] {
        self.faces[face].vertex.map(|vertex| self.position(vertex))
    }

    /// The children of the node at an offset: the box and the word of each.
    pub fn children(&self, offset: u32) -> Vec<(Bounds, u32)> {
        let place = offset as usize - size_of::<MeshHeader>();
        assert!(place.is_multiple_of(size_of::<Boxes>()));
        let node = &self.nodes[place / size_of::<Boxes>()];
        let none = f32::from_bits(NO_BOX);
        let mut children = Vec::new();
        for lane in 0..4 {
            let low = [node.lo_x, node.lo_y, node.lo_z].map(|axis| axis[lane].get());
            let high = [node.hi_x, node.hi_y, node.hi_z].map(|axis| axis[lane].get());
            if low == [none; 3] {
                assert_eq!((high, node.child[lane].get()), ([-none; 3], 0));
                continue;
            }
            let (low, high) = (low.into(), high.into());
            children.push((Bounds { low, high }, node.child[lane].get()));
        }
        assert!(!children.is_empty());
        children
    }
}

/// What was found in the blocks: each triangle of the mesh by its corners, its material, its sides
/// and the visibility of lights.
type Found = HashMap<([[u32; 3]; 3], u32, u32, [u16; 2]), usize>;

/// Checks all blocks against the mesh that they were made of.
pub fn check(mesh: &Mesh, materials: &[Material], blocks: &MeshBlocks) {
    let mut found = Found::new();
    let mut visited = vec![false; blocks.count() as usize];
    let bounds = visit(mesh, blocks, 0, &mut visited, &mut found);
    assert!(visited.iter().all(|&it| it), "a block is unreachable");

    let mut wanted = Found::new();
    let mut whole = Bounds::EMPTY;
    for triangle in 0..mesh.triangles.len() {
        let corners = mesh.corners(triangle);
        let [a, b, c] = corners.map(|corner| corner.as_dvec3());
        if (b - a).cross(c - a) == glam::DVec3::ZERO {
            continue;
        }
        for corner in corners {
            let (low, high) = (corner, corner);
            whole = whole.with(Bounds { low, high });
        }
        let material = mesh.materials[triangle];
        let both = mesh.two_sided || materials[material as usize].transmittance > 0.0;
        let mut sides = if both { SIDES_BOTH } else { 0 };
        if mesh.corner_normals(triangle).is_some() {
            sides |= SIDES_SMOOTH;
        }
        let has_texture = materials[material as usize].texture.is_some();
        if has_texture && !mesh.texture_coordinates.is_empty() {
            sides |= SIDES_TEXTURED;
        }
        if !mesh.colours.is_empty() {
            sides |= SIDES_COLOURED;
            if !mesh.visibility.is_empty() {
                sides |= SIDES_VISIBILITY;
            }
        }
        let known = mesh.visibility.get(triangle).filter(|_| !mesh.colours.is_empty());
        let known = known.map_or([0; 2], |known| [known.dark, known.lit]);
        let key = (bits(corners), material, sides, known);
        *wanted.entry(key).or_default() += 1;
    }
    assert_eq!(found, wanted);
    assert_eq!(bounds, whole);
}

fn bits(corners: [Vec3; 3]) -> [[u32; 3]; 3] {
    // Blocks have no negative 0.
    corners.map(|corner| corner.to_array().map(|x| (x + 0.0).to_bits()))
}

/// Checks a block and all below it, and returns their box.
fn visit(
    mesh: &Mesh,
    blocks: &MeshBlocks,
    number: u32,
    visited: &mut [bool],
    found: &mut Found,
) -> Bounds {
    assert!(!std::mem::replace(&mut visited[number as usize], true));
    let parts = Parts::of(blocks, number);
    let header = &parts.header;
    assert_eq!(header.magic.get(), MESH_MAGIC);
    assert_eq!(header.number.get(), number);
    assert!((1..=MESH_LEVELS).contains(&header.levels.get()));
    if parts.is_leaf() {
        assert!((1..=MESH_FACES).contains(&header.triangles.get()));
        assert!((3..=MESH_VERTICES).contains(&header.vertices.get()));
    } else {
        assert_eq!(header.kind.get(), MESH_INNER);
        let rest = (header.triangles, header.vertices, header.sides);
        assert_eq!(rest, Default::default());
    }
    let mut level = vec![size_of::<MeshHeader>() as u32];
    let mut expected = level[0];
    let mut boxes: Vec<(Bounds, u32)> = Vec::new();
    for depth in 1..=header.levels.get() {
        let mut next = Vec::new();
        for offset in level {
            assert_eq!(offset, expected, "breadth first");
            expected += size_of::<Boxes>() as u32;
            let children = parts.children(offset);
            // A node's box is the one that its parent has for it.
            if let Some(place) = boxes.iter().position(|it| it.1 == offset) {
                let own = children.iter().fold(Bounds::EMPTY, |sum, it| sum.with(it.0));
                assert_eq!(boxes[place].0, own);
            }
            next.extend(children);
        }
        boxes = next;
        level = boxes.iter().map(|it| it.1).collect();
        if depth == header.levels.get() {
            break;
        }
    }
    let nodes = (expected as usize - size_of::<MeshHeader>()) / size_of::<Boxes>();
    assert_eq!(nodes, parts.nodes.len());
    if parts.is_leaf() {
        leaf(mesh, blocks, &parts, &boxes, found);
    } else {
        for &(bounds, child) in &boxes {
            assert!(child > number && child < blocks.count());
            assert_eq!(visit(mesh, blocks, child, visited, found), bounds);
        }
    }
    boxes.iter().fold(Bounds::EMPTY, |sum, it| sum.with(it.0))
}

fn leaf(
    mesh: &Mesh,
    blocks: &MeshBlocks,
    parts: &Parts,
    runs: &[(Bounds, u32)],
    found: &mut Found,
) {
    let mut next = 0;
    for &(bounds, run) in runs {
        let (first, count) = (run as u16 / 4, run >> 16);
        assert_eq!(run as u16 % 4, 0);
        assert_eq!(u32::from(first), next);
        assert!((1..=MESH_RUN).contains(&count));
        let mut own = Bounds::EMPTY;
        for face in next..next + count {
            let corners = parts.corners(face as usize);
            for corner in corners {
                own = own.with(Bounds { low: corner, high: corner });
            }
            let lower = parts.faces[face as usize].material;
            let number = u16::from_be_bytes([parts.upper[face as usize], lower]);
            let material = blocks.materials()[usize::from(number)];
            let sides = parts.header.sides.get() & !SIDES_WIDE;
            let known = parts.visibility.get(face as usize);
            let known = known.map_or([0; 2], |it| [it.dark.get(), it.lit.get()]);
            *found.entry((bits(corners), material, sides, known)).or_default() += 1;
        }
        assert_eq!(own, bounds);
        next += count;
    }
    assert_eq!(next, parts.header.triangles.get());
    let normals: HashMap<[u32; 3], Vec<u32>> =
        (0..mesh.normals.len()).fold(HashMap::new(), |mut normals, vertex| {
            let [x, y, z] = mesh.normals[vertex].map(f64::from);
            if [x, y, z] != [0.0; 3] {
                let position = mesh.positions[vertex].map(f32::to_bits);
                let normal = packed(glam::DVec3::new(x, y, z));
                normals.entry(position).or_default().push(normal);
            }
            normals
        });
    for (vertex, found) in parts.vertices.iter().zip(&parts.coordinates) {
        let position = vertex.position.map(F32::get);
        let mut all = mesh.positions.iter().zip(&mesh.texture_coordinates);
        let found = [found.u.get(), found.v.get()];
        assert!(all.any(|known| known == (&position, &found)), "{position:?}");
    }
    assert_eq!(parts.colours.is_empty(), mesh.colours.is_empty());
    for (vertex, found) in parts.vertices.iter().zip(&parts.colours) {
        let position = vertex.position.map(F32::get);
        let mut all = mesh.positions.iter().zip(&mesh.colours);
        let found = found.packed.get();
        let is_known = |(known, colour): (&[f32; 3], &[f32; 3])| {
            *known == position && packed_colour(*colour, Colour::Linear) == found
        };
        assert!(all.any(is_known), "{position:?}");
    }
    for vertex in &parts.vertices {
        if parts.header.sides.get() & SIDES_SMOOTH == 0 {
            assert_eq!(vertex.normal.get(), 0);
        } else {
            let position = vertex.position.map(|number| number.get().to_bits());
            assert!(normals[&position].contains(&vertex.normal.get()));
        }
    }
}
