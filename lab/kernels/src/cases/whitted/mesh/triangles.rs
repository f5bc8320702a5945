//! The kernels that test the triangles of blocks with packets.

use twins::mesh_pairs::MeshBlock;
use twins::mesh_rows::{self, mesh_window};
use twins::primary_rays::Ray as WholeRay;
use twins::sphere_ray::Ray;

use super::call::{leaf, put_sheared, window_record};
use crate::cases::whitted::isect::call::{packets, whole};
use crate::cases::whitted::isect::shape::Shape as _;
use crate::cases::whitted::isect::triangle::TriangleObject;
use crate::prelude::*;
use protocol::layout::{MESH_FACES, MESH_RUN, MeshBound, MeshCandidate, MeshRows, MeshWindow};

/// The distance of an absent ray.
const ABSENT: u32 = 0xbf80_0000;

/// Sixteen rays.
pub type Packet = [Ray; 16];
/// Runs of a block's triangles, each with the number of the packet to test.
pub type Runs = Vec<(Range<usize>, usize)>;

/// Random triangles around a point that is as far as one of the scales, and packets of rays
/// from the eye that go to points on them and on their edges, to their vertices, and beside them.
/// The rays of a packet are as far apart as the triangles are wide.
pub fn aimed(random: &mut ChaCha8Rng) -> (MeshBlock, Vec<Packet>) {
    let distance = libm::pow(10.0, random.random_range(-3.0..4.0));
    let width = distance * libm::pow(10.0, random.random_range(-4.5..0.2));
    let towards = unit([(); 3].map(|()| random.random_range(-1.0..1.0)));
    let near = |random: &mut ChaCha8Rng, width: f64| {
        towards.map(|axis| axis * distance + random.random_range(-width..width))
    };
    let corners: Vec<[f64; 3]> =
        (0..24).map(|_| near(random, width).map(|axis| to_f64(from_f64(axis)))).collect();
    let faces: Vec<[u8; 3]> =
        (0..28).map(|_| [(); 3].map(|()| random.random_range(0..24))).collect();
    let packets = (0..8)
        .map(|_| {
            std::array::from_fn(|_| {
                let face = faces[random.random_range(0..faces.len())];
                let weights = match random.random_range(0..4) {
                    0 => [1.0, 0.0, 0.0],
                    1 => {
                        let along = random.random_range(0.0..1.0);
                        [along, 1.0 - along, 0.0]
                    }
                    2 => {
                        let [u, v] = [(); 2].map(|()| random.random_range(0.0..0.5));
                        [u, v, 1.0 - u - v]
                    }
                    _ => {
                        let [u, v] = [(); 2].map(|()| random.random_range(-1.0..2.0));
                        [u, v, 1.0 - u - v]
                    }
                };
                let target = std::array::from_fn(|axis| {
                    (0..3)
                        .map(|corner| weights[corner] * corners[usize::from(face[corner])][axis])
                        .sum()
                });
                Ray {
                    origin: [ZERO; 3],
                    direction: unit(target).map(from_f64),
                    t: if random.random_ratio(1, 12) { ABSENT } else { FARTHEST },
                    object: 0,
                }
            })
        })
        .collect();
    let block = MeshBlock {
        number: random.random_range(0..1 << 24),
        both: random.random(),
        vertices: corners.iter().map(|corner| corner.map(from_f64)).collect(),
        faces,
    };
    (block, packets)
}

fn some_runs(count: usize, packets: usize, faces: usize, random: &mut ChaCha8Rng) -> Runs {
    let run = |_| {
        let first = random.random_range(0..faces);
        let length = random.random_range(1..=MESH_RUN as usize);
        (first..(first + length).min(faces), random.random_range(0..packets))
    };
    (0..count).map(run).collect()
}

/// A block of random bits.
fn junk_block(random: &mut ChaCha8Rng) -> MeshBlock {
    MeshBlock {
        number: random.random_range(0..1 << 24),
        both: random.random(),
        vertices: (0..40).map(|_| random.random()).collect(),
        faces: (0..MESH_FACES).map(|_| [(); 3].map(|()| random.random_range(0..40))).collect(),
    }
}

/// The candidate of a run.
fn candidate(run: &Range<usize>, packet: u32, bound: u32, anything: u32) -> MeshCandidate {
    MeshCandidate {
        object: (4 * run.start as u32 + ((run.len() as u32) << 16)).into(),
        packet: packet.into(),
        bound: bound.into(),
        near: single(anything),
    }
}

/// How many rays of packets have other hits than before.
fn hits(before: &[Packet], after: &[[WholeRay; 16]]) -> [usize; 2] {
    let rays = before.iter().flatten().zip(after.iter().flatten());
    [rays.filter(|(before, after)| before.object != after.object).count(), 16 * before.len()]
}

/// Packets, and runs of a block's triangles to test them with.
#[derive(Clone, Debug)]
pub struct IsectRuns {
    /// The packets.
    pub packets: Vec<Packet>,
    /// The block.
    pub block: MeshBlock,
    /// The runs.
    pub runs: Runs,
    /// Fills the fields that have no meaning here.
    pub anything: u32,
}

impl Description for IsectRuns {
    const KERNEL: &'static str = "isect_mesh_pairs_r16";
    const ROUNDS: [usize; 2] = [20, 300];
    const LENGTHS: &'static [usize] = LENGTHS_FROM_0;
    const SHARES: [Range<f64>; 2] = [0.05..0.9, ANY_SHARE];
    type Placed = Place;
    /// All fields of the packets, of which only the hits may change.
    type Found = Vec<[WholeRay; 16]>;

    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        let around: Vec<_> = (0..8).map(|_| TriangleObject::around(random, 1.0)).collect();
        let mut faces: Vec<[u8; 3]> =
            (0..8).map(|face| [3 * face, 3 * face + 1, 3 * face + 2]).collect();
        faces.extend((0..20).map(|_| [(); 3].map(|()| random.random_range(0..24))));
        let runs = some_runs(count, around.len(), faces.len(), random);
        let block = MeshBlock {
            number: random.random_range(0..1 << 24),
            both: random.random(),
            vertices: around.iter().flat_map(|(of, _)| of.vertices).collect(),
            faces,
        };
        let packets = around.iter().map(|(_, rays)| *rays).collect();
        Self { packets, block, runs, anything: random.random() }
    }

    fn any(count: usize, random: &mut ChaCha8Rng) -> Self {
        let block = junk_block(random);
        let packets: Vec<_> = (0..4).map(|_| any_bits(random)).collect();
        let runs = some_runs(count, packets.len(), block.faces.len(), random);
        Self { packets, block, runs, anything: random.random() }
    }

    fn place(&self, bench: &mut Bench) -> (Place, Vec<u32>) {
        let Self { packets, block, runs, anything } = self;
        let [placed, bounds] = put_sheared(bench, packets, *anything);
        let candidate = |(run, packet): &(Range<usize>, usize)| {
            let bound = address::<MeshBound>(bounds, *packet);
            candidate(run, address::<RayPacket>(placed, *packet), bound, *anything)
        };
        let candidates: Vec<MeshCandidate> = runs.iter().map(candidate).collect();
        let candidates = put(bench, &candidates).address;
        let block = bench.place(&leaf(block, 3, *anything)).address;
        (placed, vec![candidates, runs.len() as u32, block])
    }

    fn found(&self, bench: &Bench, placed: &Place, _: u32) -> Self::Found {
        whole(&bench.read_all(*placed))
    }

    fn twin(&self, _: &Place) -> Self::Found {
        let mut expected = self.packets.clone();
        for (run, packet) in &self.runs {
            for ray in &mut expected[*packet] {
                *ray = self.block.isect_run(*ray, run.clone());
            }
        }
        whole(&packets(&expected, self.anything))
    }

    fn part(&self, found: &Self::Found) -> [usize; 2] {
        hits(&self.packets, found)
    }
}

/// Some rows of a packet and a triangle that they may hit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rows {
    /// The triangle's index.
    pub triangle: usize,
    /// Which rows.
    pub rows: [bool; 4],
    /// The packet's number.
    pub packet: usize,
}

impl Rows {
    /// The record, whose packets and bounds are at these addresses.
    fn record(self, packet: u32, bound: u32, anything: u32) -> MeshRows {
        let bits = self.rows.iter().fold(0, |bits, row| bits << 1 | u32::from(*row));
        MeshRows {
            rows: ((self.triangle as u32) << 10 | bits).into(),
            packet: packet.into(),
            bound: bound.into(),
            rest: anything.into(),
        }
    }
}

/// The windows of packets from the eye, and runs of a block's triangles that these may hit.
#[derive(Clone, Debug)]
pub struct FilterTriangles {
    /// The windows. A packet's address is its number, its bound's 16 times that.
    pub windows: Vec<mesh_rows::MeshWindow>,
    /// The block.
    pub block: MeshBlock,
    /// The runs.
    pub runs: Runs,
    /// Fills the fields that have no meaning here.
    pub anything: u32,
}

impl FilterTriangles {
    /// The rows that the twin lists.
    #[must_use]
    pub fn rows(&self) -> Vec<Rows> {
        let each = self.runs.iter().flat_map(|(run, packet)| {
            run.clone().map(|triangle| Rows {
                triangle,
                rows: self.windows[*packet].may_hit(&self.block.triangle(triangle).vertices),
                packet: *packet,
            })
        });
        each.filter(|rows| rows.rows.contains(&true)).collect()
    }

    fn tested(&self) -> usize {
        self.runs.iter().map(|(run, _)| run.len()).sum()
    }
}

impl Description for FilterTriangles {
    const KERNEL: &'static str = "filter_triangles_r16";
    const ROUNDS: [usize; 2] = IsectRuns::ROUNDS;
    const LENGTHS: &'static [usize] = LENGTHS_FROM_0;
    const SHARES: [Range<f64>; 2] = [0.25..0.95, ANY_SHARE];
    type Placed = Place;
    /// The list of rows, how many rows it has by the kernel's count, and how many triangles were
    /// tested.
    type Found = (Vec<Bits<MeshRows>>, usize, usize);

    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        let (block, packets) = aimed(random);
        let windows = packets.iter().map(mesh_window).collect();
        let runs = some_runs(count, packets.len(), block.faces.len(), random);
        Self { windows, block, runs, anything: random.random() }
    }

    fn any(count: usize, random: &mut ChaCha8Rng) -> Self {
        let block = junk_block(random);
        let windows: Vec<_> = (0..4).map(|_| mesh_window(&aimed(random).1[0])).collect();
        let runs = some_runs(count, windows.len(), block.faces.len(), random);
        Self { windows, block, runs, anything: random.random() }
    }

    fn place(&self, bench: &mut Bench) -> (Place, Vec<u32>) {
        let windows: Vec<MeshWindow> = self.windows.iter().map(window_record).collect();
        let windows = put(bench, &windows).address;
        let candidate = |(run, packet): &(Range<usize>, usize)| {
            candidate(run, *packet as u32, 16 * *packet as u32, self.anything)
        };
        let candidates: Vec<MeshCandidate> = self.runs.iter().map(candidate).collect();
        let candidates = put(bench, &candidates).address;
        let block = bench.place(&leaf(&self.block, 3, self.anything)).address;
        let buffer = put(bench, &vec![MeshRows::new_zeroed(); self.tested() + 1]);
        (buffer, vec![candidates, self.runs.len() as u32, block, buffer.address, windows])
    }

    fn found(&self, bench: &Bench, buffer: &Place, end: u32) -> Self::Found {
        let [_, rows, triangles, _] = bench.returned_vector();
        let list = bench.read_list(*buffer, end).into_iter().map(Bits);
        (list.collect(), rows as usize, triangles as usize)
    }

    fn twin(&self, _: &Place) -> Self::Found {
        let rows = self.rows();
        let count = rows.iter().flat_map(|of| of.rows).map(usize::from).sum();
        let record = |of: &Rows| {
            let packet = of.packet as u32;
            Bits(of.record(packet, 16 * packet, self.anything))
        };
        (rows.iter().map(record).collect(), count, self.tested())
    }

    fn part(&self, (_, rows, tested): &Self::Found) -> [usize; 2] {
        [*rows, 4 * tested]
    }
}

/// Packets from the eye, and rows of them to test with a block's triangles.
#[derive(Clone, Debug)]
pub struct IsectRows {
    /// The packets.
    pub packets: Vec<Packet>,
    /// The block.
    pub block: MeshBlock,
    /// The rows.
    pub rows: Vec<Rows>,
    /// Fills the fields that have no meaning here.
    pub anything: u32,
}

impl IsectRows {
    fn of(packets: Vec<Packet>, block: MeshBlock, count: usize, random: &mut ChaCha8Rng) -> Self {
        let row = |_| {
            let bits = random.random_range(1..16);
            Rows {
                triangle: random.random_range(0..block.faces.len()),
                rows: std::array::from_fn(|row| bits & 8 >> row != 0),
                packet: random.random_range(0..packets.len()),
            }
        };
        let rows = (0..count).map(row).collect();
        Self { packets, block, rows, anything: random.random() }
    }
}

impl Description for IsectRows {
    const KERNEL: &'static str = "isect_mesh_rows_r4";
    const ROUNDS: [usize; 2] = IsectRuns::ROUNDS;
    const LENGTHS: &'static [usize] = LENGTHS_FROM_0;
    const SHARES: [Range<f64>; 2] = [0.02..0.9, ANY_SHARE];
    type Placed = Place;
    type Found = Vec<[WholeRay; 16]>;

    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        let (block, packets) = aimed(random);
        Self::of(packets, block, count, random)
    }

    fn any(count: usize, random: &mut ChaCha8Rng) -> Self {
        let mut packets: Vec<Packet> = (0..4).map(|_| any_bits(random)).collect();
        packets.iter_mut().flatten().for_each(|ray| ray.origin = [ZERO; 3]);
        Self::of(packets, junk_block(random), count, random)
    }

    fn place(&self, bench: &mut Bench) -> (Place, Vec<u32>) {
        let Self { packets, block, rows, anything } = self;
        let [placed, bounds] = put_sheared(bench, packets, *anything);
        let record = |of: &Rows| {
            let packet = address::<RayPacket>(placed, of.packet);
            of.record(packet, address::<MeshBound>(bounds, of.packet), *anything)
        };
        let list: Vec<MeshRows> = rows.iter().map(record).collect();
        let list = put(bench, &list).address;
        let block = bench.place(&leaf(block, 3, *anything)).address;
        let count: usize = rows.iter().flat_map(|of| of.rows).map(usize::from).sum();
        (placed, vec![list, count as u32, block])
    }

    fn found(&self, bench: &Bench, placed: &Place, _: u32) -> Self::Found {
        whole(&bench.read_all(*placed))
    }

    fn twin(&self, _: &Place) -> Self::Found {
        let mut expected = self.packets.clone();
        for of in &self.rows {
            let rows = expected[of.packet].chunks_mut(4).zip(of.rows).filter(|(_, is_in)| *is_in);
            rows.for_each(|(rays, _)| self.block.isect_row(rays, of.triangle));
        }
        whole(&packets(&expected, self.anything))
    }

    fn part(&self, found: &Self::Found) -> [usize; 2] {
        hits(&self.packets, found)
    }
}
