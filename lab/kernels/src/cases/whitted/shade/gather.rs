//! The kernels that gather the surfaces that rays have hit.

use twins::refine_hits::refine;
use twins::surfaces::{Material, Object, Ray, same_objects, surface};

use super::error::{any_hits, any_material};
use super::light::{NO_RAY, whole};
use super::{LENGTHS, records};
use crate::prelude::*;

/// The hit of a lane's ray. The object is a number, of which the first is the background.
#[derive(Clone, Copy, Debug)]
pub struct Hit {
    /// The ray.
    pub ray: Ray,
    /// The object's number.
    pub object: usize,
}

/// Packets of hits of objects. With `SAME`, the rays of a packet have hit the same object.
#[derive(Clone, Debug)]
pub struct Hits<const SAME: bool> {
    /// The packets.
    pub packets: Vec<[Hit; 16]>,
    /// The objects, each with the number of its material.
    pub objects: Vec<(Object, usize)>,
    /// The materials.
    pub materials: Vec<Material>,
}

impl<const SAME: bool> Hits<SAME> {
    fn with_same_objects(mut self) -> Self {
        for packet in self.packets.iter_mut().filter(|_| SAME) {
            *packet = packet.map(|hit| Hit { object: packet[0].object, ..hit });
        }
        self
    }
}

/// The surfaces, and the number of rays in each lane that hit something.
type Gathered = (Vec<Bits<Surfaces>>, [u32; 4]);

impl<const SAME: bool> Description for Hits<SAME> {
    const KERNEL: &'static str = if SAME { "surfaces_same_r16" } else { "surfaces_r16" };
    const ROUNDS: [usize; 2] = [20, 1000];
    const LENGTHS: &'static [usize] = LENGTHS;
    /// The place of the surfaces, and the addresses of the materials.
    type Placed = (Place, Vec<u32>);
    type Found = Gathered;

    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        let (_, mut objects, first) = any_hits(random);
        let materials: Vec<Material> = (0..5).map(|_| any_material(random)).collect();
        for (object, material) in &mut objects {
            object.sides = random.random::<u32>() << 29;
            *material = random.random_range(0..materials.len());
        }
        let mut packet = || {
            let mut hits = first;
            for hit in &mut hits {
                match random.random_range(0..8) {
                    0 => hit.ray.t = from_f64(-1.0),
                    1 => (hit.ray.t, hit.object) = (FARTHEST, 0),
                    _ => {}
                }
            }
            hits
        };
        let packets = (0..count).map(|_| packet()).collect();
        Self { packets, objects, materials }.with_same_objects()
    }

    fn any(count: usize, random: &mut ChaCha8Rng) -> Self {
        let materials = (0..3).map(|_| any_bits(random)).collect();
        let objects = (0..6).map(|number| (any_bits(random), number % 3)).collect();
        let mut hit = || Hit { ray: any_bits(random), object: random.random_range(0..6) };
        let packets = (0..count).map(|_| [(); 16].map(|()| hit())).collect();
        Self { packets, objects, materials }.with_same_objects()
    }

    fn place(&self, bench: &mut Bench) -> (Self::Placed, Vec<u32>) {
        let records: Vec<layout::Material> = self.materials.iter().map(records::material).collect();
        let materials = put(bench, &records);
        let materials: Vec<u32> = (0..records.len())
            .map(|number| address::<layout::Material>(materials, number))
            .collect();
        let records: Vec<layout::Object> = self
            .objects
            .iter()
            .map(|(object, material)| records::object(object, materials[*material]))
            .collect();
        let objects = put(bench, &records);
        let packets: Vec<RayPacket> = self
            .packets
            .iter()
            .map(|packet| {
                let hit = |hit: Hit| whole(hit.ray, address::<layout::Object>(objects, hit.object));
                rows(&packet.map(hit))
            })
            .collect();
        let rays = put(bench, &packets);
        let found = bench.place(&vec![0x55; size_of::<Surfaces>() * packets.len()]);
        let count = packets.len() as u32;
        let arguments = vec![rays.address, count, found.address, objects.address];
        ((found, materials), arguments)
    }

    fn found(&self, bench: &Bench, (surfaces, _): &Self::Placed, _: u32) -> Gathered {
        let surfaces = bench.read_all(*surfaces).into_iter().map(Bits);
        (surfaces.collect(), bench.returned_vector())
    }

    fn twin(&self, (_, materials): &Self::Placed) -> Gathered {
        let mut counts = [0; 4];
        let surfaces = self.packets.iter().map(|packet| {
            for (lane, hit) in packet.iter().enumerate() {
                counts[lane % 4] += u32::from(hit.object != 0 && hit.ray.t >> 31 == 0);
            }
            let surfaces = packet.map(|hit| {
                let (object, material) = &self.objects[hit.object];
                surface(&hit.ray, object, &self.materials[*material])
            });
            let at = packet.map(|hit| materials[self.objects[hit.object].1]);
            Bits(records::surfaces(&surfaces, &surfaces.map(|lane| lane.plane), at))
        });
        (surfaces.collect(), counts)
    }
}

/// Hits whose surfaces `surfaces_r16` has made.
#[derive(Clone, Debug)]
pub struct RefineHits(pub Hits<false>);

impl Description for RefineHits {
    const KERNEL: &'static str = "refine_hits_r16";
    const ROUNDS: [usize; 2] = [20, 1000];
    const LENGTHS: &'static [usize] = LENGTHS;
    type Placed = (Place, Vec<u32>);
    type Found = Vec<Bits<Surfaces>>;

    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        Self(Hits::sensible(count, random))
    }

    fn any(count: usize, random: &mut ChaCha8Rng) -> Self {
        Self(Hits::any(count, random))
    }

    fn place(&self, bench: &mut Bench) -> (Self::Placed, Vec<u32>) {
        let (placed, mut arguments) = self.0.place(bench);
        let surfaces: Vec<Surfaces> = self.0.twin(&placed).0.into_iter().map(|it| it.0).collect();
        let found = put(bench, &surfaces);
        arguments.truncate(2);
        arguments.push(found.address);
        ((found, placed.1), arguments)
    }

    fn found(&self, bench: &Bench, (surfaces, _): &Self::Placed, _: u32) -> Self::Found {
        bench.read_all(*surfaces).into_iter().map(Bits).collect()
    }

    fn twin(&self, placed: &Self::Placed) -> Self::Found {
        let (mut surfaces, _) = self.0.twin(placed);
        for (packet, Bits(rows)) in self.0.packets.iter().zip(&mut surfaces) {
            for (lane, hit) in packet.iter().enumerate() {
                let Some([point, normal]) = refine(&hit.ray, &self.0.objects[hit.object].0) else {
                    continue;
                };
                [rows.point_x[lane], rows.point_y[lane], rows.point_z[lane]] = point.map(single);
                [rows.plane_x[lane], rows.plane_y[lane], rows.plane_z[lane]] = normal.map(single);
                [rows.normal_x[lane], rows.normal_y[lane], rows.normal_z[lane]] =
                    normal.map(single);
            }
        }
        surfaces
    }
}

/// Packets of rays by the addresses of the objects that they have hit.
#[derive(Clone, Debug)]
pub struct SameObjects {
    /// The packets.
    pub packets: Vec<[u32; 16]>,
}

impl Description for SameObjects {
    const KERNEL: &'static str = "same_objects_r16";
    const ROUNDS: [usize; 2] = [50, 500];
    const LENGTHS: &'static [usize] = &[1, 2, 3, 8, 32];
    const SHARES: [Range<f64>; 2] = [0.6..0.9, 0.4..0.6];
    type Placed = ();
    type Found = u32;

    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        let mut objects = Self::any(count, random);
        for object in objects.packets.as_flattened_mut() {
            *object &= 0x3_fff0;
        }
        objects
    }

    /// Half of the packets have another object in one lane.
    fn any(count: usize, random: &mut ChaCha8Rng) -> Self {
        let mut packet = || {
            let mut objects = [random.random(); 16];
            if random.random() {
                objects[random.random_range(0..16_usize)] ^= 1 << random.random_range(0..32);
            }
            objects
        };
        Self { packets: (0..count).map(|_| packet()).collect() }
    }

    fn place(&self, bench: &mut Bench) -> ((), Vec<u32>) {
        let packet = |objects: &[u32; 16]| rows(&objects.map(|object| whole(NO_RAY, object)));
        let packets: Vec<RayPacket> = self.packets.iter().map(packet).collect();
        ((), vec![put(bench, &packets).address, packets.len() as u32])
    }

    fn found(&self, _: &Bench, (): &(), bits: u32) -> u32 {
        bits
    }

    fn twin(&self, (): &()) -> u32 {
        same_objects(&self.packets)
    }

    /// How many packets have hit one object.
    fn part(&self, found: &u32) -> [usize; 2] {
        [found.count_ones() as usize, self.packets.len()]
    }
}
