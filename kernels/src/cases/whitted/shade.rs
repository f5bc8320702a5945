//! The kernels from hits to pixels, in the order in which a batch of packets goes through them.

pub mod call;
pub mod error;
pub mod records;
pub mod shapes;

use oracle::twin::surfaces::{Material, Ray};
use spu_emulator::float::single::from_f64;

use crate::bench::{self, Bench};
use crate::cases::eye::call::{address, put};
use crate::catalogue::{Case, Kernel, Objects};
use crate::layout;
use records::PacketRay;
use shapes::Shape;

/// Packets of a call: the cost of one more is what counts.
const PACKETS: Objects = Objects::List(4, 8);

/// The kernels of this file.
pub const KERNELS: &[Kernel] = &[Kernel {
    name: "surfaces_r16",
    rays: 16,
    cases: &[Case {
        name: "all hit",
        objects: PACKETS,
        place: surfaces,
    }],
    error: Some(error::surfaces),
}];

/// A background and a sphere ahead with their material, and packets of rays that hit the sphere.
fn hits(bench: &mut Bench, count: u32) -> (bench::Place, bench::Place) {
    let half = from_f64(0.5);
    let material = put(
        bench,
        &[records::material(&Material {
            colour: [half; 3],
            diffuse: half,
            highlight: half,
            exponent: from_f64(40.0),
            mirror: half,
            transmittance: half,
            inverse_index: from_f64(0.75),
            index: from_f64(4.0 / 3.0),
            schlick: 0,
            grazing: 0,
            emission: [0; 3],
            flags: 0,
        })],
    );
    let sphere = Shape::sphere([0.0, 0.0, -5.0], 1.0).object();
    let objects = put(bench, &[records::object(&sphere, material.address); 2]);
    let ray = PacketRay {
        ray: Ray {
            origin: [0; 3],
            direction: [0.0, 0.0, -1.0].map(from_f64),
            t: from_f64(4.0),
        },
        object: address::<layout::Object>(objects, 1),
        weight: from_f64(1.0),
        pixel: 0,
    };
    let packets = vec![records::rays(&[ray; 16]); count as usize];
    (objects, put(bench, &packets))
}

fn surfaces(bench: &mut Bench, count: u32) -> Vec<u32> {
    let (objects, rays) = hits(bench, count);
    let size = size_of::<layout::Surfaces>() * count as usize;
    let found = bench.place(&vec![0; size]);
    vec![rays.address, count, found.address, objects.address]
}
