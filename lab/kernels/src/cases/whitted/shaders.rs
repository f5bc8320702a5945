//! The built-in shaders: cases, surfaces to shade, and the error of `shader_depth`.

use rand::{Rng, SeedableRng as _};
use rand_chacha::ChaCha8Rng;
use spu_emulator::float::single::{from_f64, to_f64};
use twins::Single;
use zerocopy::big_endian::{F32, U32};
use zerocopy::{FromZeros as _, IntoBytes as _};

use crate::bench::{Bench, Place, SEED};
use crate::catalogue::{Case, Kernel, Objects};
use crate::single::{bits, single};
use protocol::layout::{Material, RayPacket, ShaderContext, Surfaces};

/// The number of packets over which an error is measured.
const PACKETS: u32 = 500;

/// The kernels in this file.
pub const KERNELS: &[Kernel] = &[
    Kernel {
        name: "shader_checker",
        rays: 16,
        cases: &[Case {
            name: "a packet",
            objects: Objects::Fixed(1),
            place: |bench, _| case(bench),
        }],
        error: None,
    },
    Kernel {
        name: "shader_depth",
        rays: 16,
        cases: &[Case {
            name: "a packet",
            objects: Objects::Fixed(1),
            place: |bench, _| case(bench),
        }],
        error: Some(depth_error),
    },
];

fn case(bench: &mut Bench) -> Vec<u32> {
    let mut random = ChaCha8Rng::seed_from_u64(SEED);
    let call = Call::random(&mut random, |random| from_f64(random.random()));
    let (_, arguments) = call.put(bench);
    arguments
}

/// The inputs of a shader.
pub struct Call {
    /// The surfaces.
    pub surfaces: Surfaces,
    /// The rays that hit them.
    pub rays: RayPacket,
    /// The lanes to shade.
    pub mask: [bool; 16],
    /// The shader's parameters.
    pub parameters: [Single; 4],
    /// The position of the eye in the scene.
    pub eye: [Single; 3],
}

impl Call {
    /// Records of junk, except for the fields that shaders read, which come from `value`.
    pub fn random<R: Rng>(random: &mut R, mut value: impl FnMut(&mut R) -> Single) -> Self {
        let mut surfaces = Surfaces::new_zeroed();
        let mut rays = RayPacket::new_zeroed();
        random.fill_bytes(surfaces.as_mut_bytes());
        random.fill_bytes(rays.as_mut_bytes());
        let rows = [
            &mut rays.t,
            &mut surfaces.point_x,
            &mut surfaces.point_y,
            &mut surfaces.point_z,
            &mut surfaces.red,
            &mut surfaces.green,
            &mut surfaces.blue,
        ];
        for row in rows {
            *row = std::array::from_fn(|_| single(value(random)));
        }
        Self {
            surfaces,
            rays,
            mask: random.random(),
            parameters: std::array::from_fn(|_| value(random)),
            eye: std::array::from_fn(|_| value(random)),
        }
    }

    /// Puts the records into local store. Returns the surfaces' buffer and the arguments.
    pub fn put(&self, bench: &mut Bench) -> (Place, Vec<u32>) {
        let mask = self
            .mask
            .map(|lane| U32::new(if lane { u32::MAX } else { 0 }));
        let mut material = Material::new_zeroed();
        material.parameters = self.parameters.map(single);
        let mut shading = ShaderContext::new_zeroed();
        shading.eye[..3].copy_from_slice(&self.eye.map(single));
        let surfaces = bench.place(self.surfaces.as_bytes());
        let others = [
            bench.place(self.rays.as_bytes()),
            bench.place(mask.as_bytes()),
            bench.place(material.as_bytes()),
            bench.place(shading.as_bytes()),
        ];
        let arguments = [surfaces].into_iter().chain(others);
        (surfaces, arguments.map(|place| place.address).collect())
    }

    /// A lane's colour.
    #[must_use]
    pub fn colour(&self, lane: usize) -> [Single; 3] {
        let Surfaces {
            red, green, blue, ..
        } = &self.surfaces;
        [red, green, blue].map(|channel: &[F32; 16]| bits(channel[lane]))
    }
}

/// The largest error of a channel in ulps of 1.
fn depth_error(bench: &mut Bench, random: &mut ChaCha8Rng) -> f64 {
    let mut worst = 0.0_f64;
    for _ in 0..PACKETS {
        let call = Call {
            mask: [true; 16],
            ..Call::random(random, |random| from_f64(random.random()))
        };
        bench.reset();
        let (place, arguments) = call.put(bench);
        bench.call("shader_depth", &arguments);
        let found: Surfaces = bench.read(place);
        let [far, scale, ..] = call.parameters.map(to_f64);
        for lane in 0..16 {
            let bright = ((far - to_f64(bits(call.rays.t[lane]))) * scale).clamp(0.0, 1.0);
            let lit = [found.lit_red, found.lit_green, found.lit_blue];
            for (colour, lit) in call.colour(lane).into_iter().zip(lit) {
                let error = (to_f64(bits(lit[lane])) - to_f64(colour) * bright).abs();
                worst = worst.max(error * 2_f64.powi(23));
            }
        }
    }
    worst
}
