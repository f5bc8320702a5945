//! The built-in shaders and fog: cases, surfaces to shade, and errors.

use spu_emulator::float::single::fm;
use twins::{light, shader};

use crate::prelude::*;
use protocol::layout::{Material, ShaderContext};

/// The number of packets over which an error is measured.
const PACKETS: u32 = 500;

/// The kernels in this file.
pub fn kernels() -> Vec<Kernel> {
    vec![
        row::<CHECKER>(),
        row::<DEPTH>().error(depth_error),
        row::<SKY>().error(sky_error),
        row::<FOG>().error(fog_error),
    ]
}

/// `shader_checker`.
pub const CHECKER: usize = 0;
/// `shader_depth`.
pub const DEPTH: usize = 1;
/// `shader_sky`.
pub const SKY: usize = 2;
/// `fog_r16`, which gets its numbers as shaders get theirs.
pub const FOG: usize = 3;

/// The row of a kernel. The inputs are the same for all of them.
fn row<const SHADER: usize>() -> Kernel {
    Kernel::of([case("a packet", Objects::Fixed(1), |_| {
        let random = &mut ChaCha8Rng::seed_from_u64(SEED);
        Call::<SHADER>::random(random, |random| from_f64(random.random()))
    })])
}

/// The inputs of a shader.
#[derive(Clone, Debug)]
pub struct Call<const SHADER: usize> {
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

impl<const SHADER: usize> Call<SHADER> {
    /// Records of junk, except for the fields that shaders read, which come from `value`.
    pub fn random<R: Rng>(random: &mut R, mut value: impl FnMut(&mut R) -> Single) -> Self {
        let mut surfaces = Surfaces::new_zeroed();
        let mut rays = RayPacket::new_zeroed();
        random.fill_bytes(surfaces.as_mut_bytes());
        random.fill_bytes(rays.as_mut_bytes());
        let rows = [
            &mut rays.t,
            &mut rays.direction_x,
            &mut rays.direction_y,
            &mut rays.direction_z,
            &mut surfaces.lit_red,
            &mut surfaces.lit_green,
            &mut surfaces.lit_blue,
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

    /// A lane's colour.
    #[must_use]
    pub fn colour(&self, lane: usize) -> [Single; 3] {
        let Surfaces { red, green, blue, .. } = &self.surfaces;
        [red, green, blue].map(|channel: &[F32; 16]| bits(channel[lane]))
    }

    /// A lane's light so far.
    #[must_use]
    pub fn lit(&self, lane: usize) -> [Single; 3] {
        let Surfaces { lit_red, lit_green, lit_blue, .. } = &self.surfaces;
        [lit_red, lit_green, lit_blue].map(|channel: &[F32; 16]| bits(channel[lane]))
    }

    /// The point of a lane's surface.
    fn point(&self, lane: usize) -> [Single; 3] {
        let Surfaces { point_x, point_y, point_z, .. } = &self.surfaces;
        [point_x, point_y, point_z].map(|axis| bits(axis[lane]))
    }

    /// The direction of a lane's ray.
    #[must_use]
    pub fn direction(&self, lane: usize) -> [Single; 3] {
        let RayPacket { direction_x, direction_y, direction_z, .. } = &self.rays;
        [direction_x, direction_y, direction_z].map(|axis: &[F32; 16]| bits(axis[lane]))
    }
}

/// Sets a lane of a vector's rows.
fn set(rows: [&mut [F32; 16]; 3], lane: usize, vector: [Single; 3]) {
    for (row, component) in rows.into_iter().zip(vector) {
        row[lane] = single(component);
    }
}

impl<const SHADER: usize> Description for Call<SHADER> {
    const KERNEL: &'static str =
        ["shader_checker", "shader_depth", "shader_sky", "fog_r16"][SHADER];
    const ROUNDS: [usize; 2] = [500, 500];
    const LENGTHS: &'static [usize] = &[1];
    type Placed = Place;
    type Found = Bits<Surfaces>;

    fn sensible(_: usize, random: &mut ChaCha8Rng) -> Self {
        Self::random(random, |random| from_f64(random.random_range(-20.0..20.0)))
    }

    fn any(_: usize, random: &mut ChaCha8Rng) -> Self {
        Self::random(random, |random| random.random())
    }

    fn place(&self, bench: &mut Bench) -> (Place, Vec<u32>) {
        let mask = self.mask.map(|lane| U32::new(if lane { u32::MAX } else { 0 }));
        let mut material = Material::new_zeroed();
        material.parameters = self.parameters.map(single);
        let mut shading = ShaderContext::new_zeroed();
        shading.eye[..3].copy_from_slice(&self.eye.map(single));
        let surfaces = bench.place(self.surfaces.as_bytes());
        if SHADER == FOG {
            let others = [self.rays.as_bytes(), mask.as_bytes(), material.parameters.as_bytes()];
            let others = others.map(|bytes| bench.place(bytes).address);
            return (surfaces, [surfaces.address].into_iter().chain(others).collect());
        }
        let others = [
            bench.place(self.rays.as_bytes()),
            bench.place(mask.as_bytes()),
            bench.place(material.as_bytes()),
            bench.place(shading.as_bytes()),
        ];
        let arguments = [surfaces].into_iter().chain(others);
        (surfaces, arguments.map(|place| place.address).collect())
    }

    fn found(&self, bench: &Bench, surfaces: &Place, _: u32) -> Bits<Surfaces> {
        Bits(bench.read(*surfaces))
    }

    fn twin(&self, _: &Place) -> Bits<Surfaces> {
        let mut wanted = self.surfaces;
        let it = &mut wanted;
        for lane in (0..16).filter(|&lane| self.mask[lane]) {
            let (colour, lit) = (self.colour(lane), self.lit(lane));
            if SHADER == CHECKER {
                let colour = shader::checker(self.point(lane), colour, self.parameters, self.eye);
                set([&mut it.red, &mut it.green, &mut it.blue], lane, colour);
                continue;
            }
            let lit = if SHADER == SKY {
                shader::sky(self.direction(lane), colour, lit, self.parameters)
            } else if SHADER == FOG {
                let (passes, lit) = light::fog(bits(self.rays.t[lane]), lit, self.parameters);
                for share in [&mut it.mirror, &mut it.transmittance] {
                    share[lane] = single(fm(bits(share[lane]), passes));
                }
                lit
            } else {
                for share in
                    [&mut it.diffuse, &mut it.highlight, &mut it.mirror, &mut it.transmittance]
                {
                    share[lane] = single(0);
                }
                shader::depth(bits(self.rays.t[lane]), colour, self.parameters)
            };
            set([&mut it.lit_red, &mut it.lit_green, &mut it.lit_blue], lane, lit);
        }
        Bits(wanted)
    }
}

/// The largest error of a channel of the sky in ulps of 1, of colours up to 1.
fn sky_error(bench: &mut Bench, random: &mut ChaCha8Rng) -> f64 {
    let mut worst = 0.0_f64;
    for _ in 0..PACKETS {
        let mut call = Call::<SKY> {
            mask: [true; 16],
            ..Call::random(random, |random| from_f64(random.random()))
        };
        let mut unit = || {
            let axes: [f64; 3] = std::array::from_fn(|_| random.random_range(-1.0..1.0));
            let length = axes.iter().map(|axis| axis * axis).sum::<f64>().sqrt();
            axes.map(|axis| from_f64(axis / length))
        };
        let up = unit();
        call.parameters[..3].copy_from_slice(&up);
        for lane in 0..16 {
            let [x, y, z] = unit().map(single);
            call.rays.direction_x[lane] = x;
            call.rays.direction_y[lane] = y;
            call.rays.direction_z[lane] = z;
        }
        let Bits(found) = call.call(bench);
        for lane in 0..16 {
            let along = call.direction(lane).map(to_f64);
            let height: f64 = along.iter().zip(up).map(|(a, b)| a * to_f64(b)).sum();
            let lit = [found.lit_red, found.lit_green, found.lit_blue];
            let colours = call.colour(lane).into_iter().zip(call.lit(lane));
            for ((zenith, horizon), lit) in colours.zip(lit) {
                let (zenith, horizon) = (to_f64(zenith), to_f64(horizon));
                let expected = horizon + height.max(0.0) * (zenith - horizon);
                let error = (to_f64(bits(lit[lane])) - expected).abs();
                worst = worst.max(error * 2_f64.powi(23));
            }
        }
    }
    worst
}

/// The largest error of a channel, of colours up to 1.
fn fog_error(bench: &mut Bench, random: &mut ChaCha8Rng) -> f64 {
    let mut worst = 0.0_f64;
    for _ in 0..PACKETS {
        let mut call = Call::<FOG> {
            mask: [true; 16],
            ..Call::random(random, |random| from_f64(random.random()))
        };
        call.rays.t = std::array::from_fn(|_| F32::new(20.0 * random.random::<f32>()));
        let Bits(found) = call.call(bench);
        let [density, colour @ ..] = call.parameters.map(to_f64);
        for lane in 0..16 {
            let share = libm::exp2(-density * f64::from(call.rays.t[lane].get()));
            let lit = [found.lit_red, found.lit_green, found.lit_blue];
            for ((own, fog), lit) in call.lit(lane).into_iter().zip(colour).zip(lit) {
                let expected = fog + share * (to_f64(own) - fog);
                worst = worst.max((to_f64(bits(lit[lane])) - expected).abs());
            }
        }
    }
    worst
}

/// The largest error of a channel in ulps of 1.
fn depth_error(bench: &mut Bench, random: &mut ChaCha8Rng) -> f64 {
    let mut worst = 0.0_f64;
    for _ in 0..PACKETS {
        let call = Call::<DEPTH> {
            mask: [true; 16],
            ..Call::random(random, |random| from_f64(random.random()))
        };
        let Bits(found) = call.call(bench);
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
