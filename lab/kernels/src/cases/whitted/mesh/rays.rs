//! The kernels that take rays through blocks one by one.

use twins::mesh::Corners;
use twins::mesh_rays::{self, Visit, bit};
use twins::primary_rays::Ray;

use super::call::{LOWER, Node, TO_UPPER, boxes};
use crate::cases::whitted::rays::call::put_packets;
use crate::cases::whitted::rays::fans::{self, FANS, SCALES};
use crate::prelude::*;
use protocol::layout::{Boxes, MeshBound, MeshCandidate, MeshRay, MeshVisit};

/// Packets of a batch.
const BATCHES: &[usize] = &[1, 2, 3, 7, 8];
/// Rays that are few: the list of all that they may meet has to fit.
const FEW: usize = 16;
/// The most lowest nodes of a block here.
const LOWEST: usize = 13;

fn fans_of(count: usize, scale: f64, random: &mut ChaCha8Rng) -> Vec<[Ray; 16]> {
    let mut fan = || fans::packet(FANS[random.random_range(0..FANS.len())], scale, random);
    (0..count).map(|_| fan()).collect()
}

fn junk(count: usize, random: &mut ChaCha8Rng) -> Vec<[Ray; 16]> {
    (0..count).map(|_| any_bits(random)).collect()
}

/// The record of the ray with this number.
fn ray_record(ray: &Ray, number: u32) -> MeshRay {
    let ray = mesh_rays::mesh_ray(ray);
    let plane = |axis: usize| {
        let lower = LOWER[axis] as u32;
        lower + if ray.down[axis] { TO_UPPER as u32 } else { 0 }
    };
    MeshRay {
        planes: (plane(0) | plane(2) << 24).into(),
        inverse: ray.inverse.map(single),
        number: (plane(1) | (127 - number) << 24).into(),
        near_shift: ray.near_shift.map(single),
        t: single(ray.t),
        far_shift: ray.far_shift.map(single),
    }
}

fn ray_records(packets: &[[Ray; 16]]) -> Vec<MeshRay> {
    packets.iter().flatten().zip(0..).map(|(ray, number)| ray_record(ray, number)).collect()
}

/// Packets whose rays get records.
#[derive(Clone, Debug)]
pub struct Records {
    /// The packets.
    pub packets: Vec<[Ray; 16]>,
}

impl Description for Records {
    const KERNEL: &'static str = "mesh_rays_r16";
    const ROUNDS: [usize; 2] = [40, 200];
    const LENGTHS: &'static [usize] = BATCHES;
    type Placed = Place;
    type Found = Vec<[u32; 12]>;

    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        let scale = magnitude(SCALES, random);
        Self { packets: fans_of(count, scale, random) }
    }

    fn any(count: usize, random: &mut ChaCha8Rng) -> Self {
        Self { packets: junk(count, random) }
    }

    fn place(&self, bench: &mut Bench) -> (Place, Vec<u32>) {
        let count = self.packets.len();
        let packets = put_packets(bench, &self.packets).address;
        let records = put(bench, &vec![MeshRay::new_zeroed(); 16 * count]);
        (records, vec![packets, count as u32, records.address])
    }

    fn found(&self, bench: &Bench, placed: &Place, _: u32) -> Self::Found {
        bench.read_all(*placed).iter().map(words).collect()
    }

    fn twin(&self, _: &Place) -> Self::Found {
        ray_records(&self.packets).iter().map(words).collect()
    }
}

fn words(record: &MeshRay) -> [u32; 12] {
    let (words, _) = record.as_bytes().as_chunks();
    std::array::from_fn(|word| u32::from_be_bytes(words[word]))
}

/// Packets of which those rays are found that count farther than a distance.
#[derive(Clone, Debug)]
pub struct Alive {
    /// The packets.
    pub packets: Vec<[Ray; 16]>,
    /// The distance.
    pub near: Single,
    /// A bit for each ray.
    pub bits: u128,
}

impl Description for Alive {
    const KERNEL: &'static str = "mesh_alive_r16";
    const ROUNDS: [usize; 2] = [60, 300];
    const LENGTHS: &'static [usize] = BATCHES;
    const SHARES: [Range<f64>; 2] = [0.05..0.9, 0.05..0.9];
    type Placed = Place;
    type Found = u128;

    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        let packets = fans_of(count, 1.0, random);
        let near = match random.random_range(0..3) {
            0 => packets[0][0].t,
            1 => from_f64(random.random_range(-1.0..50.0)),
            _ => random.random(),
        };
        Self { packets, near, bits: random.random() }
    }

    fn any(count: usize, random: &mut ChaCha8Rng) -> Self {
        Self { packets: junk(count, random), ..Self::sensible(count, random) }
    }

    fn place(&self, bench: &mut Bench) -> (Place, Vec<u32>) {
        let packets = put_packets(bench, &self.packets).address;
        let bits = bench.place(&self.bits.to_be_bytes());
        (bits, vec![packets, self.packets.len() as u32, self.near, bits.address])
    }

    fn found(&self, bench: &Bench, placed: &Place, _: u32) -> u128 {
        u128::from_be_bytes(bench.read(*placed))
    }

    fn twin(&self, _: &Place) -> u128 {
        mesh_rays::alive(&self.packets, self.near, self.bits)
    }

    fn part(&self, found: &u128) -> [usize; 2] {
        [found, &self.bits].map(|bits| bits.count_ones() as usize)
    }
}

/// Rays of packets, and a block's nodes.
#[derive(Clone, Debug)]
pub struct Batch {
    /// The packets.
    pub packets: Vec<[Ray; 16]>,
    /// The nodes.
    pub nodes: Vec<Node>,
    /// A bit for each ray that is there.
    pub bits: u128,
}

/// Nodes of a block: levels of them. Words of the lowest nodes are 0 where there is no child.
fn nodes(mut boxes: impl FnMut(&mut ChaCha8Rng) -> Corners, random: &mut ChaCha8Rng) -> Vec<Node> {
    let lowest = random.random_range(1..=LOWEST);
    let middle = match lowest {
        0..=4 => 0,
        _ => lowest.div_ceil(4),
    };
    let upper = usize::from(lowest > 1) + middle;
    let count = upper + lowest;
    let mut below = 1;
    let node = |node| {
        let lanes = match node {
            _ if node >= upper => random.random_range(0..=4),
            0 if middle > 0 => middle,
            _ => (count - below).min(4),
        };
        if node < upper {
            below += lanes;
        }
        Node {
            boxes: std::array::from_fn(|_| boxes(random)),
            words: std::array::from_fn(|lane| match lane {
                _ if lane < lanes => random.random_range(1..u32::MAX),
                _ => 0,
            }),
        }
    };
    (0..count).map(node).collect()
}

/// Bits of rays of this number of packets, of all of them or of a few.
fn some(count: usize, random: &mut ChaCha8Rng) -> u128 {
    let there = u128::MAX << (128 - 16 * count);
    there
        & match random.random_range(0..4) {
            0 => u128::MAX,
            1 => random.random(),
            2 => [(); 4].iter().fold(u128::MAX, |bits, ()| bits & random.random::<u128>()),
            _ => bit(random.random_range(0..128)) | bit(random.random_range(0..128)),
        }
}

impl Batch {
    /// Rays like those of frames, and boxes near them.
    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        let boxes = |random: &mut ChaCha8Rng| {
            let centre = in_cube(20.0, random);
            let half = magnitude(1.0..30.0, random);
            [-half, half].map(|way| centre.map(|c| from_f64(c + way)))
        };
        let packets = fans_of(count, 1.0, random);
        Self { packets, nodes: nodes(boxes, random), bits: some(count, random) }
    }

    fn any(count: usize, random: &mut ChaCha8Rng) -> Self {
        let nodes = nodes(|random| random.random(), random);
        Self { packets: junk(count, random), nodes, bits: some(count, random) }
    }

    /// With few of the rays, but one at least.
    fn few(self, random: &mut ChaCha8Rng) -> Self {
        let rays = 16 * self.packets.len() as u32;
        let some = (0..128).filter(|number| self.bits & bit(*number) != 0).take(FEW - 1);
        let bits = some.fold(bit(random.random_range(0..rays)), |bits, ray| bits | bit(ray));
        Self { bits, ..self }
    }

    /// Puts nodes, bits with space for those of other nodes, records, packets, and space for a list
    /// of rays into local store. The records have other distances than the packets, as before they
    /// are brought up to date. Returns the addresses.
    fn place(&self, bench: &mut Bench) -> [u32; 5] {
        let nodes: Vec<Boxes> = self.nodes.iter().map(boxes).collect();
        let mut records = ray_records(&self.packets);
        records.iter_mut().for_each(|record| record.t = 0.5.into());
        let mut buffer = self.bits.to_be_bytes().to_vec();
        buffer.resize(16 * (nodes.len() + 3), 0x55);
        let places = [
            put(bench, &nodes),
            bench.place(&buffer),
            put(bench, &records),
            put_packets(bench, &self.packets),
            bench.place(&[0x55; 16 * 131]),
        ];
        places.map(|place| place.address)
    }

    /// The rays as the twins take them.
    fn rays(&self) -> Vec<mesh_rays::MeshRay> {
        self.packets.iter().flatten().map(mesh_rays::mesh_ray).collect()
    }

    /// The nodes as the twins take them.
    fn parts(&self) -> Vec<([Corners; 4], [u32; 4])> {
        self.nodes.iter().map(|node| (node.boxes, node.words)).collect()
    }
}

/// The children of lowest nodes that any of the rays meet.
#[derive(Clone, Debug)]
pub struct FilterRays(pub Batch);

impl Description for FilterRays {
    const KERNEL: &'static str = "mesh_filter_rays";
    const ROUNDS: [usize; 2] = [60, 300];
    const LENGTHS: &'static [usize] = BATCHES;
    const SHARES: [Range<f64>; 2] = [0.01..0.9, 0.01..1.0];
    type Placed = Place;
    /// The visits, and how many tests they took.
    type Found = (Vec<Visit>, u32);

    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        Self(Batch::sensible(count, random))
    }

    fn any(count: usize, random: &mut ChaCha8Rng) -> Self {
        Self(Batch::any(count, random))
    }

    fn place(&self, bench: &mut Bench) -> (Place, Vec<u32>) {
        let [nodes, bits, records, packets, list] = self.0.place(bench);
        let count = self.0.nodes.len();
        let buffer = put(bench, &vec![MeshVisit::new_zeroed(); 4 * count + 3]);
        (buffer, vec![nodes, count as u32, bits, buffer.address, records, packets, list])
    }

    fn found(&self, bench: &Bench, buffer: &Place, end: u32) -> Self::Found {
        let visit = |visit: &MeshVisit| {
            assert_eq!([visit.reserved.get(), visit.reserved_2.get()], [0; 2]);
            Visit {
                child: visit.child.get(),
                near: bits(visit.near),
                rays: visit.rays.iter().fold(0, |rays, word| rays << 32 | u128::from(word.get())),
            }
        };
        (bench.read_list(*buffer, end).iter().map(visit).collect(), bench.returned_second())
    }

    fn twin(&self, _: &Place) -> Self::Found {
        mesh_rays::filter_rays(&self.0.rays(), self.0.bits, &self.0.parts())
    }

    fn part(&self, (visits, _): &Self::Found) -> [usize; 2] {
        [visits.len(), 4 * self.0.nodes.len()]
    }
}

/// Where the bounds of packets are said to be.
const BOUNDS: u32 = 0x1_2340;

/// The first packet's candidate, and what is added for each further one.
fn steps(bench: &mut Bench, packets: u32) -> u32 {
    let of = |packet: u32, bound: u32| MeshCandidate {
        object: 0.into(),
        packet: packet.into(),
        bound: bound.into(),
        near: single(0),
    };
    let sizes = of(size_of::<RayPacket>() as u32, size_of::<MeshBound>() as u32);
    put(bench, &[of(packets, BOUNDS), sizes]).address
}

/// The words of candidates, and the numbers of their packets.
fn candidates(bench: &Bench, packets: u32, buffer: Place, end: u32) -> Vec<(u32, u32)> {
    let candidate = |candidate: &MeshCandidate| {
        let packet = (candidate.packet.get() - packets) / size_of::<RayPacket>() as u32;
        let bound = BOUNDS + packet * size_of::<MeshBound>() as u32;
        assert_eq!(candidate.bound.get(), bound, "the bound of packet {packet}");
        (candidate.object.get(), packet)
    };
    bench.read_list(buffer, end).iter().map(candidate).collect()
}

/// The children that each of a few rays meets.
#[derive(Clone, Debug)]
pub struct FewRays {
    /// The rays and the nodes.
    pub batch: Batch,
    /// The offset that is added to the children's words.
    pub base: u32,
}

impl Description for FewRays {
    const KERNEL: &'static str = "mesh_few_rays";
    const ROUNDS: [usize; 2] = FilterRays::ROUNDS;
    const LENGTHS: &'static [usize] = BATCHES;
    const SHARES: [Range<f64>; 2] = FilterRays::SHARES;
    /// The packets' address, and the buffer for the list.
    type Placed = (u32, Place);
    type Found = Vec<(u32, u32)>;

    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        Self { batch: Batch::sensible(count, random).few(random), base: random.random() }
    }

    fn any(count: usize, random: &mut ChaCha8Rng) -> Self {
        Self { batch: Batch::any(count, random).few(random), base: random.random() }
    }

    fn place(&self, bench: &mut Bench) -> (Self::Placed, Vec<u32>) {
        let [nodes, bits, records, packets, list] = self.batch.place(bench);
        let [_, most] = self.part(&Vec::new());
        let buffer = put(bench, &vec![MeshCandidate::new_zeroed(); most + 3]);
        let (count, steps) = (self.batch.nodes.len() as u32, steps(bench, packets));
        let arguments = vec![nodes, count, bits, buffer.address, records, steps, self.base, list];
        ((packets, buffer), arguments)
    }

    fn found(&self, bench: &Bench, &(packets, buffer): &Self::Placed, end: u32) -> Self::Found {
        candidates(bench, packets, buffer, end)
    }

    fn twin(&self, _: &Self::Placed) -> Self::Found {
        let Self { batch, base } = self;
        let found = mesh_rays::few_rays(&batch.rays(), batch.bits, &batch.parts()).into_iter();
        found.map(|(word, ray)| (word.wrapping_add(*base), ray / 16)).collect()
    }

    fn part(&self, found: &Self::Found) -> [usize; 2] {
        [found.len(), 4 * self.batch.nodes.len() * self.batch.bits.count_ones() as usize]
    }
}

/// Visits by rays, of which candidates of their packets are made.
#[derive(Clone, Debug)]
pub struct Visits {
    /// The visits.
    pub visits: Vec<Visit>,
    /// The offset that is added to the children's words.
    pub base: u32,
}

/// Where the packets of these visits are said to be.
const PACKETS: u32 = 0x2_0000;

impl Description for Visits {
    const KERNEL: &'static str = "mesh_candidates";
    const ROUNDS: [usize; 2] = [60, 300];
    const LENGTHS: &'static [usize] = LENGTHS_FROM_0;
    type Placed = Place;
    type Found = Vec<(u32, u32)>;

    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        let packets = random.random_range(1..=8);
        let visit = |_| Visit {
            child: random.random(),
            near: random.random(),
            rays: some(packets, random) | bit(random.random_range(0..16 * packets as u32)),
        };
        Self { visits: (0..count).map(visit).collect(), base: random.random() }
    }

    fn any(count: usize, random: &mut ChaCha8Rng) -> Self {
        let visit =
            |_| Visit { child: random.random(), near: random.random(), rays: random.random() };
        Self { visits: (0..count).map(visit).collect(), base: random.random() }
    }

    fn place(&self, bench: &mut Bench) -> (Place, Vec<u32>) {
        let record = |visit: &Visit| MeshVisit {
            child: visit.child.into(),
            reserved: 0.into(),
            near: single(visit.near),
            reserved_2: 0.into(),
            rays: std::array::from_fn(|word| ((visit.rays >> (96 - 32 * word)) as u32).into()),
        };
        let records: Vec<MeshVisit> = self.visits.iter().map(record).collect();
        let visits = put(bench, &records).address;
        let buffer = put(bench, &vec![MeshCandidate::new_zeroed(); 8 * records.len() + 7]);
        let steps = steps(bench, PACKETS);
        (buffer, vec![visits, records.len() as u32, buffer.address, self.base, steps])
    }

    fn found(&self, bench: &Bench, buffer: &Place, end: u32) -> Self::Found {
        candidates(bench, PACKETS, *buffer, end)
    }

    fn twin(&self, _: &Place) -> Self::Found {
        let of_packets = |visit: &Visit| {
            let (rays, child) = (visit.rays, visit.child.wrapping_add(self.base));
            let there = (0..8).filter(move |packet| rays << (16 * packet) >> 112 != 0);
            there.map(move |packet| (child, packet))
        };
        self.visits.iter().flat_map(of_packets).collect()
    }
}
