//! The kernels that make patches of hits.

use twins::mesh_pairs::MeshBlock;
use twins::mesh_patches::{flat_patch, list_hits};

use super::call::{leaf, sides};
use crate::cases::whitted::height::HeightCorners;
use crate::cases::whitted::isect::shape::Shape as _;
use crate::cases::whitted::isect::triangle::TriangleObject;
use crate::prelude::*;
use protocol::layout::{
    Boxes, MESH_HIT, MESH_LEAF_PLACES, Material, MeshHeader, MeshHit, MeshLeaf, MeshVertex, Object,
    Patch,
};

/// What the rays of packets have hit.
#[derive(Clone, Debug)]
pub struct ListHits {
    /// The objects.
    pub objects: Vec<[u32; 16]>,
}

impl Description for ListHits {
    const KERNEL: &'static str = "mesh_list_hits_r16";
    const ROUNDS: [usize; 2] = [45, 90];
    const LENGTHS: &'static [usize] = &[0, 1, 2, 3, 4, 5, 6, 7, 8];
    const SHARES: [Range<f64>; 2] = [0.1..0.9, 0.1..0.9];
    /// The packets and the patches.
    type Placed = [Place; 2];
    /// What the packets have as their objects, and the objects of the patches, in all four words.
    type Found = (Vec<[u32; 16]>, Vec<[u32; 4]>);

    /// Few triangles, so that rays share them; and objects of no mesh.
    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        let mut packet = || {
            let few = random.random_range(1..9);
            std::array::from_fn(|_| match random.random_range(0..8) {
                0 => random.random_range(0..2) << 7,
                _ => MESH_HIT + random.random_range(0..few),
            })
        };
        Self { objects: (0..count).map(|_| packet()).collect() }
    }

    fn any(count: usize, random: &mut ChaCha8Rng) -> Self {
        Self { objects: (0..count).map(|_| random.random()).collect() }
    }

    fn place(&self, bench: &mut Bench) -> ([Place; 2], Vec<u32>) {
        let record = |objects: &[u32; 16]| RayPacket {
            object: objects.map(Into::into),
            ..RayPacket::new_zeroed()
        };
        let records: Vec<RayPacket> = self.objects.iter().map(record).collect();
        let packets = put(bench, &records);
        let patches = put(bench, &vec![Patch::new_zeroed(); 16 * records.len()]);
        let none = bench.place(&[0; 16]);
        let count = records.len() as u32;
        ([packets, patches], vec![packets.address, count, patches.address, none.address])
    }

    fn found(&self, bench: &Bench, &[packets, patches]: &[Place; 2], end: u32) -> Self::Found {
        let packets: Vec<RayPacket> = bench.read_all(packets);
        let patches: Vec<Patch> = bench.read_list(patches, end);
        let listed = |patch: &Patch| std::array::from_fn(|word| patch.triangle[word].get());
        (
            packets.iter().map(|packet| packet.object.map(U32::get)).collect(),
            patches.iter().map(listed).collect(),
        )
    }

    fn twin(&self, &[_, patches]: &[Place; 2]) -> Self::Found {
        let mut expected = (Vec::new(), Vec::new());
        for objects in &self.objects {
            let first = address::<Patch>(patches, expected.1.len());
            let (patches, listed) = list_hits(objects, first, size_of::<Patch>() as u32);
            expected.0.push(patches);
            expected.1.extend(listed.iter().map(|object| [*object; 4]));
        }
        expected
    }

    fn part(&self, (_, listed): &Self::Found) -> [usize; 2] {
        [listed.len(), 16 * self.objects.len()]
    }
}

/// The object's record that a patch begins with.
fn record(patch: &Patch) -> Bits<Object> {
    Bits(Object::read_from_prefix(patch.as_bytes()).expect("a patch is longer").0)
}

/// Where the mesh's first material is said to be.
const MATERIALS: u32 = 0x1_2340;

/// Patches of triangles that were hit, and the leaves that are there.
#[derive(Clone, Debug)]
pub struct FlatPatches {
    /// The patches' objects.
    pub objects: Vec<u32>,
    /// The leaves, whose places in the table differ.
    pub leaves: Vec<MeshBlock>,
    /// Fills the fields that have no meaning here.
    pub anything: u32,
}

impl FlatPatches {
    /// Objects of these leaves, of others, and of no mesh.
    fn of(leaves: Vec<MeshBlock>, count: usize, random: &mut ChaCha8Rng) -> Self {
        let object = |_| {
            let leaf = &leaves[random.random_range(0..leaves.len())];
            let hit = leaf.hit(random.random_range(0..leaf.faces.len()));
            match random.random_range(0..8) {
                0 => hit ^ random.random_range(1..1 << 16) << 7,
                1 => hit & !MESH_HIT,
                _ => hit,
            }
        };
        Self { objects: (0..count).map(object).collect(), leaves, anything: random.random() }
    }

    /// The record of an object's surface, if its leaf is there.
    fn surface(&self, object: u32) -> Option<Object> {
        let number = (object & !MESH_HIT) >> 7;
        let leaf = self.leaves.iter().find(|leaf| leaf.number == number);
        let leaf = leaf.filter(|_| object & MESH_HIT != 0)?;
        let patch = flat_patch(&leaf.triangle((object & 127) as usize).vertices);
        Some(Object {
            centre: patch.centre.map(single),
            gain: single(0),
            axis: patch.normal.map(single),
            slope: single(ONE),
            offset: single(0),
            leave: single(patch.leave),
            material: (MATERIALS + (self.anything & 0xff) * size_of::<Material>() as u32).into(),
            sides: sides(leaf, self.anything).into(),
        })
    }
}

/// Three leaves with a hundred triangles between these vertices.
fn leaves(
    mut vertices: impl FnMut(&mut ChaCha8Rng) -> Vec<[u32; 3]>,
    random: &mut ChaCha8Rng,
) -> Vec<MeshBlock> {
    let leaf = |leaf| MeshBlock {
        number: (random.random_range(0..1 << 15)..)
            .find(|number| HeightCorners::place_of(*number) == leaf)
            .expect("each place is one of the next numbers'"),
        both: random.random(),
        vertices: vertices(random),
        faces: (0..100).map(|_| [(); 3].map(|()| random.random_range(0..24))).collect(),
    };
    (0..3).map(leaf).collect()
}

impl Description for FlatPatches {
    const KERNEL: &'static str = "mesh_flat_patches";
    const ROUNDS: [usize; 2] = [160, 280];
    const LENGTHS: &'static [usize] = LENGTHS_FROM_0;
    const SHARES: [Range<f64>; 2] = [0.6..0.9, 0.6..0.9];
    /// The patches and the list.
    type Placed = [Place; 2];
    /// The objects in the list and their patches, and the surfaces of the others.
    type Found = (Vec<[u32; 2]>, Vec<Bits<Object>>);

    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        let vertices = |random: &mut ChaCha8Rng| {
            let scale = 10_f64.powi(random.random_range(-3..4));
            (0..8).flat_map(|_| TriangleObject::around(random, scale).0.vertices).collect()
        };
        Self::of(leaves(vertices, random), count, random)
    }

    fn any(count: usize, random: &mut ChaCha8Rng) -> Self {
        let vertices = |random: &mut ChaCha8Rng| (0..24).map(|_| random.random()).collect();
        Self::of(leaves(vertices, random), count, random)
    }

    fn place(&self, bench: &mut Bench) -> ([Place; 2], Vec<u32>) {
        let Self { objects, leaves, anything } = self;
        let mut patches = vec![Patch::new_zeroed(); objects.len() + 3];
        for (patch, object) in patches.iter_mut().zip(objects) {
            patch.triangle[..4].fill((*object).into());
        }
        let patches = put(bench, &patches);
        // Both versions of the kernel must read the same bytes of a leaf that isn't there.
        let nothing = bench.place(&[0; 5000]).address;
        let none = MeshLeaf {
            number: u32::MAX.into(),
            vertices: nothing.into(),
            faces: nothing.into(),
            sides: (*anything).into(),
        };
        let mut table = [none; MESH_LEAF_PLACES as usize];
        for block in leaves {
            let place = bench.place(&leaf(block, 2, *anything)).address as usize;
            let vertices = place + size_of::<MeshHeader>() + 2 * size_of::<Boxes>();
            let faces = vertices + block.vertices.len() * size_of::<MeshVertex>();
            table[HeightCorners::place_of(block.number)] = MeshLeaf {
                number: block.number.into(),
                vertices: (vertices as u32).into(),
                faces: (faces as u32).into(),
                sides: sides(block, *anything).into(),
            };
        }
        let table = put(bench, &table).address;
        let list = put(bench, &vec![MeshHit::new_zeroed(); objects.len() + 4]);
        let fours = objects.len().div_ceil(4) as u32;
        ([patches, list], vec![patches.address, fours, table, list.address, MATERIALS])
    }

    fn found(&self, bench: &Bench, &[patches, list]: &[Place; 2], end: u32) -> Self::Found {
        let list: Vec<MeshHit> = bench.read_list(list, end);
        let patches: Vec<Patch> = bench.read_all(patches);
        let made = self.objects.iter().zip(&patches).filter(|of| self.surface(*of.0).is_some());
        (
            list.iter().map(|hit| [hit.object.get(), hit.patch.get()]).collect(),
            made.map(|(_, patch)| record(patch)).collect(),
        )
    }

    fn twin(&self, &[patches, _]: &[Place; 2]) -> Self::Found {
        let (mut missing, mut made) = (Vec::new(), Vec::new());
        for (at, object) in self.objects.iter().enumerate() {
            if let Some(surface) = self.surface(*object) {
                made.push(Bits(surface));
            } else if object & MESH_HIT != 0 {
                missing.push([*object, address::<Patch>(patches, at)]);
            }
        }
        (missing, made)
    }

    fn part(&self, (_, made): &Self::Found) -> [usize; 2] {
        [made.len(), self.objects.len()]
    }
}
