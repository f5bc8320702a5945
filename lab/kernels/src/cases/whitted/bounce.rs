//! `refract_r16` and `reflect_r16`: cases, hits from their domain, and their results compared with
//! f64.

use twins::bounce::{Bounce, CHAIN_STEP, Limits, Queued};
use twins::reflect::reflect;
use twins::refract::refract;

use crate::prelude::*;
use protocol::layout::{QueuedRay, Site};

/// A short list of sites, and a long one.
const SITES: Objects = Objects::List(2, 8);
/// The number of packets over which an error is measured.
const PACKETS: u32 = 1000;
/// The smallest refracted cosine for which `refract_r16` states its error.
pub const STEEP: f64 = 0.1;
/// If the cosine is closer to 0 than this, rounding may decide which normal is used.
pub const ALONG: f64 = 1e-5;

/// The kernels in this file.
pub fn kernels() -> Vec<Kernel> {
    vec![
        Kernel::of::<Hits<true>>([
            case("glass", SITES, |count| sharing(count, 1.0)),
            case("nothing lets through", SITES, |count| sharing(count, 0.0)),
        ])
        .error(|bench, random| worst::<true>(bench, random, refracted)),
        Kernel::of::<Hits<false>>([
            case("mirrors", SITES, |count| sharing(count, 1.0)),
            case("nothing reflects", SITES, |count| sharing(count, 0.0)),
        ])
        .error(|bench, random| worst::<false>(bench, random, reflected)),
    ]
}

/// Hits that all reflect and transmit this share.
fn sharing<const REFRACT: bool>(count: u32, share: f64) -> Hits<REFRACT> {
    let mut random = ChaCha8Rng::seed_from_u64(SEED);
    let packet = |_| {
        std::array::from_fn(|_| Bounce {
            mirror: from_f64(share),
            transmittance: from_f64(share),
            ..hit(&mut random)
        })
    };
    let packets = (0..count).map(packet).collect();
    Hits { packets, limits: Limits::NONE, junk: random.random() }
}

/// Sites in local store for a call, and the queue for their rays.
pub struct Sites {
    sites: Place,
    surfaces: Vec<Place>,
    queue: Place,
}

impl Sites {
    /// Puts the records of hits into local store. Fields that the kernels do not read are junk.
    pub fn put(bench: &mut Bench, packets: &[[Bounce; 16]], random: &mut impl Rng) -> Self {
        let mut surfaces = Vec::new();
        let sites: Vec<Site> = packets
            .iter()
            .map(|packet| {
                let (surface, rays) = records(packet, random);
                let surface = bench.place(surface.as_bytes());
                let rays = bench.place(rays.as_bytes());
                surfaces.push(surface);
                Site {
                    surfaces: surface.address.into(),
                    rays: rays.address.into(),
                    shines: random.random::<u32>().into(),
                    shadow: random.random::<u32>().into(),
                }
            })
            .collect();
        let sites = bench.place(sites.as_bytes());
        let mut queue = vec![0; (16 * packets.len() + 1) * size_of::<QueuedRay>()];
        random.fill_bytes(&mut queue);
        Self { sites, surfaces, queue: bench.place(&queue) }
    }

    /// The arguments of a kernel.
    #[must_use]
    pub fn arguments(&self, limits: Limits) -> Vec<u32> {
        let count = self.surfaces.len() as u32;
        vec![self.sites.address, count, self.queue.address, limits.min_weight, limits.deepest]
    }

    /// The rays that a kernel appended, up to the end that it returned.
    ///
    /// # Panics
    ///
    /// Panics if that is not the end of a whole ray within the queue.
    #[must_use]
    pub fn queued(&self, bench: &Bench, end: u32) -> Vec<Queued> {
        let bytes = end - self.queue.address;
        let size = size_of::<QueuedRay>() as u32;
        assert_eq!(bytes % size, 0, "part of a ray");
        let mut rays = bench.read_all::<QueuedRay>(self.queue);
        assert!(bytes / size < rays.len() as u32, "more rays than lanes");
        rays.truncate((bytes / size) as usize);
        let queued = rays.iter().map(|ray| Queued {
            origin: ray.origin.map(bits),
            weight: bits(ray.weight),
            direction: ray.direction.map(bits),
            pixel: ray.pixel.get(),
        });
        queued.collect()
    }

    /// The surfaces in local store.
    #[must_use]
    pub fn surfaces(&self, bench: &Bench) -> Vec<Surfaces> {
        let read = |place: &Place| bench.read(*place);
        self.surfaces.iter().map(read).collect()
    }
}

/// Hits that send on rays which are let through, with `REFRACT`, or else thrown back.
#[derive(Clone, Debug)]
pub struct Hits<const REFRACT: bool> {
    /// The hits.
    pub packets: Vec<[Bounce; 16]>,
    /// What ends chains of rays.
    pub limits: Limits,
    /// The seed for all fields that the kernels do not read.
    pub junk: u64,
}

/// The new rays, and the surfaces.
type Sent = (Vec<Queued>, Vec<Bits<Surfaces>>);

impl<const REFRACT: bool> Description for Hits<REFRACT> {
    const KERNEL: &'static str = if REFRACT { "refract_r16" } else { "reflect_r16" };
    const ROUNDS: [usize; 2] = [60, 3000];
    const LENGTHS: &'static [usize] = &[0, 1, 2, 3, 8];
    const SHARES: [Range<f64>; 2] = [0.1..0.9, if REFRACT { 0.005..0.9 } else { 0.06..0.9 }];
    /// The sites, and their surfaces before the call.
    type Placed = (Sites, Vec<Surfaces>);
    type Found = Sent;

    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        let packets = (0..count).map(|_| [(); 16].map(|()| hit(random))).collect();
        let limits = Limits {
            min_weight: from_f64(random.random_range(0.0..0.1)),
            deepest: random.random_range(8..16) * CHAIN_STEP,
        };
        let limits = if random.random() { Limits::NONE } else { limits };
        Self { packets, limits, junk: random.random() }
    }

    fn any(_: usize, random: &mut ChaCha8Rng) -> Self {
        let limits = Limits { min_weight: random.random(), deepest: random.random() };
        Self { packets: vec![any_bits(random)], limits, junk: random.random() }
    }

    fn place(&self, bench: &mut Bench) -> (Self::Placed, Vec<u32>) {
        let junk = &mut ChaCha8Rng::seed_from_u64(self.junk);
        let sites = Sites::put(bench, &self.packets, junk);
        let (before, arguments) = (sites.surfaces(bench), sites.arguments(self.limits));
        ((sites, before), arguments)
    }

    fn found(&self, bench: &Bench, (sites, _): &Self::Placed, end: u32) -> Sent {
        (sites.queued(bench, end), sites.surfaces(bench).into_iter().map(Bits).collect())
    }

    /// Only the share that a surface reflects may change.
    fn twin(&self, (_, before): &Self::Placed) -> Sent {
        let mut rays = Vec::new();
        let surfaces = self.packets.iter().zip(before).map(|(packet, before)| {
            let mirror = packet.each_ref().map(|hit| {
                let (ray, mirror) = if REFRACT {
                    refract(hit, self.limits)
                } else {
                    (reflect(hit, self.limits), hit.mirror)
                };
                rays.extend(ray);
                single(mirror)
            });
            Bits(Surfaces { mirror, ..*before })
        });
        let surfaces = surfaces.collect();
        (rays, surfaces)
    }

    /// How many send a ray.
    fn part(&self, (rays, _): &Sent) -> [usize; 2] {
        [rays.len(), 16 * self.packets.len()]
    }
}

/// The records of sixteen hits. Fields that the kernels do not read are junk.
fn records(packet: &[Bounce; 16], random: &mut impl Rng) -> (Surfaces, RayPacket) {
    let mut surfaces = Surfaces::new_zeroed();
    let mut rays = RayPacket::new_zeroed();
    random.fill_bytes(surfaces.as_mut_bytes());
    random.fill_bytes(rays.as_mut_bytes());
    for (lane, hit) in packet.iter().enumerate() {
        let vectors = [
            (&mut surfaces.point_x, &mut surfaces.point_y, &mut surfaces.point_z, hit.point),
            (&mut surfaces.normal_x, &mut surfaces.normal_y, &mut surfaces.normal_z, hit.normal),
            (&mut surfaces.plane_x, &mut surfaces.plane_y, &mut surfaces.plane_z, hit.plane),
            (&mut rays.direction_x, &mut rays.direction_y, &mut rays.direction_z, hit.direction),
        ];
        for (x, y, z, vector) in vectors {
            [x[lane], y[lane], z[lane]] = vector.map(single);
        }
        surfaces.leave[lane] = single(hit.leave);
        surfaces.mirror[lane] = single(hit.mirror);
        surfaces.transmittance[lane] = single(hit.transmittance);
        surfaces.ratio[lane] = single(hit.ratio);
        surfaces.schlick[lane] = single(hit.schlick);
        surfaces.grazing[lane] = single(hit.grazing);
        rays.weight[lane] = single(hit.weight);
        rays.pixel[lane] = hit.pixel.into();
    }
    (surfaces, rays)
}

/// A hit from the stated domain: any incidence, half of the hits on patches with normals that lean
/// by up to a half, and materials of glass, mirrors and neither.
pub fn hit(random: &mut impl Rng) -> Bounce {
    let (direction, plane) = loop {
        let [direction, plane] = [(); 2].map(|()| unit(in_cube(1.0, random)));
        if dot(direction, plane) < -1e-3 {
            break (direction, plane);
        }
    };
    let lean = if random.random() { 0.5 } else { 0.0 };
    let offset = in_cube(1.0, random);
    let leaning = unit(std::array::from_fn(|axis| plane[axis] + lean * offset[axis]));
    let normal = if dot(direction, leaning) < -1e-3 { leaning } else { plane };
    let index = random.random_range(0.25..4.0_f64);
    let head_on = ((1.0 - index) / (1.0 + index)).powi(2);
    let [schlick, grazing] = if random.random() { [head_on, 1.0 - head_on] } else { [0.0; 2] };
    let mut share = || random.random_range(-0.5..1.0_f64).max(0.0);
    let (mirror, transmittance) = (share(), share());
    Bounce {
        direction: point(direction),
        weight: from_f64(random.random_range(0.0..1.0)),
        pixel: random.random_range(0..16 * CHAIN_STEP),
        point: point(in_cube(10.0, random)),
        normal: point(normal),
        plane: point(plane),
        leave: from_f64(random.random_range(1e-6..1e-2)),
        mirror: from_f64(mirror),
        transmittance: from_f64(transmittance),
        ratio: from_f64(index),
        schlick: from_f64(schlick),
        grazing: from_f64(grazing),
    }
}

/// A function that returns the direction of the new ray in f64, from the same singles that a
/// kernel gets, and its share of the ray's weight. It returns `None` if there is no such ray or if
/// it is outside the stated domain.
type Truth = fn(&Bounce) -> Option<(Vector, f64)>;

/// The reflected ray.
#[must_use]
pub fn reflected(hit: &Bounce) -> Option<(Vector, f64)> {
    let [direction, normal, plane] =
        [hit.direction, hit.normal, hit.plane].map(|v| unit(v.map(to_f64)));
    let mirrored = |normal: Vector| -> Vector {
        let along = dot(direction, normal);
        unit(std::array::from_fn(|axis| direction[axis] - 2.0 * along * normal[axis]))
    };
    let by_normal = mirrored(normal);
    let off = dot(by_normal, plane);
    let share = to_f64(hit.mirror);
    let decided = off.abs() > ALONG && share > 0.0;
    let taken = if off > 0.0 { by_normal } else { mirrored(plane) };
    decided.then_some((taken, share))
}

/// The refracted ray.
#[must_use]
pub fn refracted(hit: &Bounce) -> Option<(Vector, f64)> {
    let [direction, normal, plane] =
        [hit.direction, hit.normal, hit.plane].map(|v| unit(v.map(to_f64)));
    let [ratio, schlick, grazing] = [hit.ratio, hit.schlick, hit.grazing].map(to_f64);
    let through = |normal: Vector| -> Option<(Vector, f64)> {
        let along = dot(direction, normal);
        let sine: Vector =
            std::array::from_fn(|axis| ratio * (direction[axis] - along * normal[axis]));
        let squared = 1.0 - dot(sine, sine);
        let cosine = squared.max(0.0).sqrt();
        let vector = std::array::from_fn(|axis| sine[axis] - cosine * normal[axis]);
        (cosine > STEEP).then_some((vector, cosine))
    };
    let (first, _) = through(normal)?;
    let off = dot(first, plane);
    let (taken, beyond) = if off < 0.0 { through(normal) } else { through(plane) }?;
    let near = -dot(direction, normal);
    let cosine = if ratio > 1.0 { beyond } else { near };
    let reflected = schlick + grazing * (1.0 - cosine).clamp(0.0, 1.0).powi(5);
    let share = to_f64(hit.transmittance) * (1.0 - reflected);
    (off.abs() > ALONG && share > 0.0).then_some((taken, share))
}

/// The largest error of a direction's component in ulps of 1. Infinite if a ray is missing.
fn worst<const REFRACT: bool>(bench: &mut Bench, random: &mut ChaCha8Rng, truth: Truth) -> f64 {
    let mut worst = 0.0_f64;
    for _ in 0..PACKETS {
        // One hit at a time, because only the pixel identifies a ray in the queue.
        let packet: [Bounce; 16] =
            std::array::from_fn(|lane| Bounce { pixel: lane as u32, ..hit(random) });
        let (packets, junk) = (vec![packet], random.random());
        let (queued, _) = Hits::<REFRACT> { packets, limits: Limits::NONE, junk }.call(bench);
        for (pixel, hit) in (0..).zip(&packet) {
            let Some((exact, _)) = truth(hit) else {
                continue;
            };
            let found = queued.iter().find(|ray| ray.pixel == pixel + CHAIN_STEP);
            worst = worst.max(found.map_or(f64::INFINITY, |ray| off(ray, exact)));
        }
    }
    worst
}

/// The largest error of a component of a ray's direction, in ulps of 1.
#[must_use]
pub fn off(ray: &Queued, exact: Vector) -> f64 {
    let found = ray.direction.map(to_f64).into_iter().zip(exact);
    let errors = found.map(|(found, exact)| (found - exact).abs() * 2_f64.powi(23));
    errors.fold(0.0, f64::max)
}
