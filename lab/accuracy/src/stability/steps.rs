//! The steps of tracing a tile with the tracer's own kernels, packet by packet: what rays hit, and
//! the rays that leave from there.
//!
//! Each packet has its own object.

use kernels::bench::Bench;
use kernels::cases::eye::call::{address, put};
use kernels::single::single;
use protocol::layout::{
    Candidate, Light, Material, Object, QueuedRay, RayPacket, Shear, Site, Surfaces,
};
use zerocopy::FromZeros as _;
use zerocopy::big_endian::U32;

use super::product::{Kind, Product};
use crate::stability::prelude::*;

/// The t of an absent ray: -1.
pub const NOT_THERE: Single = 0xbf80_0000;
/// The value of [`Ray::object`] after the ray has hit its packet's object.
pub const HIT: u32 = 1;

/// A ray as its origin and direction.
pub type Line = [[Single; 3]; 2];

/// Sixteen rays, of which some may be absent.
pub type Lanes = [Option<Ray>; 16];

/// The results for sixteen rays.
#[derive(Clone, Debug)]
pub struct Leaving {
    /// The points that they hit, and the surface there.
    pub surfaces: Surfaces,
    /// The reflected rays.
    pub reflected: Lanes,
    /// The refracted rays.
    pub refracted: Lanes,
    /// The shadow rays. Their `t` is that of the light.
    pub shadow: Lanes,
}

/// An absent ray.
pub const NO_RAY: Ray = Ray { origin: [0; 3], direction: [0; 3], t: NOT_THERE, object: 0 };

/// Tests packets against one object each, all of one kind. If a ray hits, its object is [`HIT`].
pub fn meet(bench: &mut Bench, products: &[&Product], packets: &[Lanes]) -> Vec<[Ray; 16]> {
    let Some(kind) = products.first().map(|product| product.kind) else {
        return Vec::new();
    };
    bench.reset();
    let record = |lanes: &Lanes| call::packet(&lanes.map(|ray| ray.unwrap_or(NO_RAY)), 0);
    let records: Vec<RayPacket> = packets.iter().map(record).collect();
    let placed = put(bench, &records);
    let count = packets.len() as u32;
    let shears = (kind == Kind::Triangle).then(|| {
        let shears = bench.place(&vec![0x55; size_of::<Shear>() * packets.len()]);
        let arguments = [placed.address, count, shears.address];
        bench.call("shear_packets_r16", &arguments);
        shears
    });
    let objects: Vec<u32> =
        products.iter().map(|product| bench.place(&product.object).address).collect();
    let candidates: Vec<Candidate> = (0..packets.len())
        .map(|number| Candidate {
            object: objects[number].into(),
            packet: address::<RayPacket>(placed, number).into(),
            bound: U32::ZERO,
            shear: shears.map_or(U32::ZERO, |shears| address::<Shear>(shears, number).into()),
        })
        .collect();
    let candidates = put(bench, &candidates);
    bench.call(kind.kernel(), &[candidates.address, count]);
    let after: Vec<RayPacket> = bench.read_all(placed);
    after
        .iter()
        .zip(objects)
        .map(|(packet, object)| {
            call::rays(packet)
                .map(|ray| Ray { object: u32::from(ray.object == object) * HIT, ..ray })
        })
        .collect()
}

/// The rays that leave from the hits of packets, as [`meet`] returns them, with a light at this
/// place. Hits on streamed objects are `refined`.
pub fn leave(
    bench: &mut Bench,
    products: &[&Product],
    packets: &[[Ray; 16]],
    light: [Single; 3],
    refined: bool,
) -> Vec<Leaving> {
    bench.reset();
    let nothing = put(bench, &[Material::new_zeroed()]);
    let background = Object { material: nothing.address.into(), ..Object::new_zeroed() };
    let background = put(bench, &[background]);
    let light = Light { position: light.map(single), ..Light::new_zeroed() };
    let light = put(bench, &[light]);
    let rays: Vec<RayPacket> = packets
        .iter()
        .zip(products)
        .map(|(rays, product)| {
            let material = bench.place(&product.material);
            let object = bench.place(&with_material(product, material.address));
            let mut packet = call::packet(rays, 0);
            for (lane, ray) in rays.iter().enumerate() {
                let hit = ray.object == HIT;
                let address = if hit { object } else { background }.address;
                packet.object[lane] = address.into();
                packet.weight[lane] = single(0x3f80_0000);
                packet.pixel[lane] = (lane as u32).into();
            }
            packet
        })
        .collect();
    let count = packets.len() as u32;
    let rays = put(bench, &rays);
    let surfaces = bench.place(&vec![0x55; size_of::<Surfaces>() * packets.len()]);
    let arguments = [rays.address, count, surfaces.address, background.address];
    bench.call("surfaces_r16", &arguments);
    if refined {
        bench.call("refine_hits_r16", &arguments[..3]);
    }
    let shadow = put(bench, &vec![RayPacket::new_zeroed(); packets.len()]);
    let site = |number: usize| Site {
        surfaces: address::<Surfaces>(surfaces, number).into(),
        rays: address::<RayPacket>(rays, number).into(),
        shines: U32::ZERO,
        shadow: U32::ZERO,
    };
    let list: Vec<Site> = (0..packets.len()).map(site).collect();
    let sites = put(bench, &list);
    let listed = put(bench, &list);
    let arguments = [
        sites.address,
        count,
        light.address,
        background.address,
        0,
        shadow.address,
        listed.address,
    ];
    let end = bench.call("shadow_rays_r16", &arguments).value;
    let listed_sites = (end - listed.address) as usize / size_of::<Site>();
    // Only sites with rays have a packet of them.
    let mut shadows = vec![[NO_RAY; 16]; packets.len()];
    let with_rays = bench.read_all::<Site>(listed);
    let packets_of_rays = bench.read_all::<RayPacket>(shadow);
    for (site, packet) in with_rays.iter().zip(&packets_of_rays).take(listed_sites) {
        let number = list.iter().position(|listed| listed.rays == site.rays);
        shadows[number.expect("a site of the list")] = call::rays(packet);
    }
    let found: Vec<Surfaces> = bench.read_all(surfaces);
    let mut leaving = Vec::new();
    // One site at a time, because a queued ray only identifies its pixel.
    let queue = put(bench, &[QueuedRay::new_zeroed(); 17]);
    for (number, (surfaces, shadow)) in found.iter().zip(&shadows).enumerate() {
        let mut queued = |kernel| {
            let Limits { min_weight, deepest } = Limits::NONE;
            let site = address::<Site>(sites, number);
            let arguments = [site, 1, queue.address, min_weight, deepest];
            let end = bench.call(kernel, &arguments).value;
            let count = (end - queue.address) as usize / size_of::<QueuedRay>();
            let mut lanes = [None; 16];
            for ray in &bench.read_all::<QueuedRay>(queue)[..count] {
                let [origin, direction] = [ray.origin, ray.direction].map(|v| v.map(bits));
                let lane = ray.pixel.get() - CHAIN_STEP;
                lanes[lane as usize] = Some(fresh(origin, direction));
            }
            lanes
        };
        let refracted = queued("refract_r16");
        let reflected = queued("reflect_r16");
        let shadow = shadow.map(|ray| Ray { object: 0, ..ray });
        leaving.push(Leaving {
            surfaces: *surfaces,
            reflected,
            refracted,
            shadow: shadow.map(|ray| Some(ray).filter(|ray| ray.t as i32 > 0)),
        });
    }
    leaving
}

/// The object's record with the address of its material.
fn with_material(product: &Product, material: u32) -> Vec<u8> {
    let mut bytes = product.object.clone();
    let field = Object::RECORD.fields.iter().find(|field| field.name == "material");
    let start = field.map_or(bytes.len(), |field| field.offset);
    bytes[start..start + 4].copy_from_slice(&material.to_be_bytes());
    bytes
}
