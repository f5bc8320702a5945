//! Portals: cases, rays that cross them, and errors.

use twins::shader::Portal;

use super::shaders::{Call, DEPTH};
use crate::prelude::*;

/// The number of packets over which the error is measured.
const PACKETS: u32 = 500;

/// The kernels in this file.
pub fn kernels() -> Vec<Kernel> {
    let cases = [case("a packet", Objects::Fixed(1), |_| {
        Crossed::sensible(1, &mut ChaCha8Rng::seed_from_u64(SEED))
    })];
    vec![Kernel::of(cases).error(error)]
}

/// Rays that meet a portal.
#[derive(Clone, Debug)]
pub struct Crossed(Call<DEPTH>);

/// The rows of a vector of each lane.
type Rows<'a> = [&'a mut [F32; 16]; 3];

impl Crossed {
    fn random(random: &mut ChaCha8Rng, value: fn(&mut ChaCha8Rng) -> Single) -> Self {
        let mut call = Call::random(random, value);
        let Call { surfaces, rays, .. } = &mut call;
        for row in vectors(surfaces, rays).into_iter().flatten() {
            *row = std::array::from_fn(|_| single(value(random)));
        }
        Self(call)
    }
}

/// The normals, the points and the directions, in this order.
fn vectors<'a>(surfaces: &'a mut Surfaces, rays: &'a mut RayPacket) -> [Rows<'a>; 4] {
    let it = surfaces;
    [
        [&mut it.normal_x, &mut it.normal_y, &mut it.normal_z],
        [&mut it.plane_x, &mut it.plane_y, &mut it.plane_z],
        [&mut it.point_x, &mut it.point_y, &mut it.point_z],
        [&mut rays.direction_x, &mut rays.direction_y, &mut rays.direction_z],
    ]
}

/// Which of them is the point.
const POINT: usize = 2;

impl Description for Crossed {
    const KERNEL: &'static str = "shader_portal";
    const ROUNDS: [usize; 2] = [500, 500];
    const LENGTHS: &'static [usize] = &[1];
    type Placed = (Place, u32);
    type Found = (Bits<Surfaces>, Bits<RayPacket>);

    fn sensible(_: usize, random: &mut ChaCha8Rng) -> Self {
        Self::random(random, |random| from_f64(random.random_range(-20.0..20.0)))
    }

    fn any(_: usize, random: &mut ChaCha8Rng) -> Self {
        Self::random(random, |random| random.random())
    }

    fn place(&self, bench: &mut Bench) -> ((Place, u32), Vec<u32>) {
        let (surfaces, arguments) = self.0.place(bench);
        ((surfaces, arguments[1]), arguments)
    }

    fn found(&self, bench: &Bench, &(surfaces, rays): &(Place, u32), _: u32) -> Self::Found {
        (
            Bits(bench.read(surfaces)),
            Bits(bench.read(Place { address: rays, size: size_of::<RayPacket>() })),
        )
    }

    fn twin(&self, _: &(Place, u32)) -> Self::Found {
        let Call { mut surfaces, mut rays, mask, parameters, eye } = self.0;
        let portal = Portal::new(parameters, eye);
        for (number, rows) in vectors(&mut surfaces, &mut rays).into_iter().enumerate() {
            let [xs, ys, zs] = rows;
            for lane in (0..16).filter(|&lane| mask[lane]) {
                let from = [xs[lane], ys[lane], zs[lane]].map(bits);
                let to = if number == POINT { portal.moved(from) } else { portal.turned(from) };
                [xs[lane], ys[lane], zs[lane]] = to.map(single);
            }
        }
        (Bits(surfaces), Bits(rays))
    }
}

/// The largest error of a direction's component in ulps of 1, and of a point's in ulps of the
/// largest coordinate by which it is computed.
fn error(bench: &mut Bench, random: &mut ChaCha8Rng) -> f64 {
    let mut worst = 0.0_f64;
    for _ in 0..PACKETS {
        let mut crossed = Crossed::sensible(1, random);
        let call = &mut crossed.0;
        call.mask = [true; 16];
        let angle: f64 = random.random_range(-180.0..=180.0);
        call.parameters[3] = from_f64(libm::tan((0.5 * angle).to_radians()));
        let h = to_f64(call.parameters[3]);
        let (cosine, sine) = ((1.0 - h * h) / (1.0 + h * h), 2.0 * h / (1.0 + h * h));
        let by: [f64; 3] = std::array::from_fn(|axis| to_f64(call.parameters[axis]));
        let eye = call.eye.map(to_f64);
        let (Bits(mut surfaces), Bits(mut rays)) = crossed.call(bench);
        let Call { surfaces: mut before, rays: mut rays_before, .. } = crossed.0;
        let old = vectors(&mut before, &mut rays_before);
        let new = vectors(&mut surfaces, &mut rays);
        for (number, (old, new)) in old.into_iter().zip(new).enumerate() {
            for lane in 0..16 {
                let [x, y, z] = [0, 1, 2].map(|axis| to_f64(bits(old[axis][lane])));
                let found = [0, 1, 2].map(|axis| to_f64(bits(new[axis][lane])));
                let (from, then) = match number {
                    POINT => (eye, [by[0] - eye[0], by[1], by[2] - eye[2]]),
                    _ => ([0.0; 3], [0.0; 3]),
                };
                let [far_x, far_z] = [x + from[0], z + from[2]];
                let expected = [
                    cosine * far_x + sine * far_z + then[0],
                    y + then[1],
                    cosine * far_z - sine * far_x + then[2],
                ];
                let used = [x, y, z].into_iter().chain(from).chain(then);
                let largest = used.fold(0.0, |largest: f64, it| largest.max(it.abs()));
                for (found, expected) in found.into_iter().zip(expected) {
                    worst = worst.max((found - expected).abs() / largest * 2_f64.powi(23));
                }
            }
        }
    }
    worst
}
