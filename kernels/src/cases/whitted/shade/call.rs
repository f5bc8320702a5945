//! Calls of the surface kernels with what their twins take.

use oracle::twin::surfaces::{Material, Object, Ray};

use super::records::{self, PacketRay};
use crate::bench::Bench;
use crate::cases::eye::call::{address, put};
use crate::layout::{self, Surfaces};

/// What a lane's ray has hit: number of an object, of which the first is the background's.
#[derive(Clone, Copy, Debug)]
pub struct Hit {
    /// The ray.
    pub ray: Ray,
    /// The object's number.
    pub object: usize,
}

/// `kernel` on packets of hits of these objects, each of the material of that number; gives the
/// surfaces, the materials' addresses and the count of rays that hit something in each lane.
pub fn surfaces(
    bench: &mut Bench,
    kernel: &str,
    hits: &[[Hit; 16]],
    objects: &[(Object, usize)],
    materials: &[Material],
) -> (Vec<Surfaces>, Vec<u32>, [u32; 4]) {
    bench.reset();
    let records: Vec<layout::Material> = materials.iter().map(records::material).collect();
    let material_place = put(bench, &records);
    let materials: Vec<u32> = (0..materials.len())
        .map(|number| address::<layout::Material>(material_place, number))
        .collect();
    let records: Vec<layout::Object> = objects
        .iter()
        .map(|(object, material)| records::object(object, materials[*material]))
        .collect();
    let objects = put(bench, &records);
    let packets: Vec<layout::RayPacket> = hits
        .iter()
        .map(|packet| {
            records::rays(&packet.map(|hit| PacketRay {
                ray: hit.ray,
                object: address::<layout::Object>(objects, hit.object),
                // No part of it.
                weight: u32::MAX,
                pixel: u32::MAX,
            }))
        })
        .collect();
    let rays = put(bench, &packets);
    let found = bench.place(&vec![0x55; size_of::<Surfaces>() * hits.len()]);
    let count = hits.len() as u32;
    let background = objects.address;
    bench.call(kernel, &[rays.address, count, found.address, background]);
    (bench.read_all(found), materials, bench.returned_vector())
}
