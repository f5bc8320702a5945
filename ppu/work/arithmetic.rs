//! For tests: primary rays and their intersections with spheres in the SPU's arithmetic, as the
//! kernels compute them, and random cameras and spheres.

use glam::DVec3;
use rand::Rng as _;
use rand_chacha::ChaCha8Rng;
use scenes::{Camera, View};
use spu_emulator::float::estimate::{fi, frsqest};
use spu_emulator::float::single::{fm, fma, fnms, to_f64};
use twins::sphere::{Axis, Constants, Eye as _, Perpendicular};
use twins::sphere_ray::BareSphere;
use zerocopy::big_endian::F32;

use crate::scene;
use crate::scene::random::{across, magnitude, unit};
use protocol::formulation::EyeRecord;
use protocol::layout::Sphere;

/// A vector of the SPU's singles.
pub type Singles = [u32; 3];

const ONE: u32 = 0x3f80_0000;
const HALF: u32 = 0x3f00_0000;

pub fn bits(vector: [F32; 3]) -> Singles {
    vector.map(|value| value.get().to_bits())
}

pub fn wide(vector: Singles) -> DVec3 {
    DVec3::from_array(vector.map(to_f64))
}

fn nearest(vector: DVec3) -> Singles {
    vector.to_array().map(|value| (value as f32).to_bits())
}

fn is_negative(value: u32) -> bool {
    value >> 31 == 1
}

/// The unit direction through a point of the picture, which may be between pixels.
pub fn direction(camera: &Camera, x: f64, y: f64) -> Singles {
    let [corner, right, down] = [camera.corner, camera.right, camera.down].map(nearest);
    let [x, y] = [x, y].map(|value| (value as f32).to_bits());
    let along = [0, 1, 2].map(|axis| fma(y, down[axis], fma(x, right[axis], corner[axis])));
    let [dx, dy, dz] = along;
    let length_squared = fma(dz, dz, fma(dy, dy, fm(dx, dx)));
    let estimate = fi(length_squared, frsqest(length_squared));
    let error = fnms(fm(length_squared, estimate), estimate, ONE);
    let inverse = fma(error, fm(estimate, HALF), estimate);
    along.map(|component| fm(component, inverse))
}

/// Whether a direction's product with the centre is above a limit, as `filter_spheres_r16` and
/// `cull_spheres_p16` compute it.
pub fn is_above(limit: F32, centre: [F32; 3], direction: Singles) -> bool {
    let product = |sum, (c, d)| fnms(c, d, sum);
    let terms = bits(centre).into_iter().zip(direction);
    is_negative(terms.fold(limit.get().to_bits(), product))
}

/// Whether a sphere is outside of a plane, as `frustum_spheres` computes it.
pub fn is_outside(sphere: &Sphere, normal: Singles) -> bool {
    let product = |sum, (c, n)| fma(c, n, sum);
    let terms = bits(sphere.centre).into_iter().zip(normal);
    is_negative(terms.fold(sphere.reach.get().to_bits(), product))
}

/// A random form of the sphere records.
pub fn form(random: &mut ChaCha8Rng) -> EyeRecord {
    if random.random() { EyeRecord::Centre } else { EyeRecord::Axis }
}

/// The distance at which a ray enters a sphere, as the kernel for records of this form computes
/// it.
pub fn entry(sphere: &Sphere, form: EyeRecord, direction: Singles) -> Option<f64> {
    let word = |value: F32| value.get().to_bits();
    let (centre, square) = (bits(sphere.centre), word(sphere.radius_squared));
    let found = match form {
        EyeRecord::Centre => {
            Perpendicular::entry(direction, &BareSphere { centre, radius_squared: square })
        }
        EyeRecord::Axis => Constants::entry(
            direction,
            &Axis { axis: centre, k: square, distance: word(sphere.distance) },
        ),
    };
    (!is_negative(found.outside) && !is_negative(found.t)).then(|| to_f64(found.t))
}

/// A random camera near the origin, with any direction and a narrow or wide angle.
pub fn camera(random: &mut ChaCha8Rng, width: u32, height: u32) -> Camera {
    let from = unit(random) * magnitude(random, -6.0, 6.0);
    let sight = unit(random);
    let view = View {
        from,
        at: from + sight,
        up: across(random, sight),
        angle: if random.random() {
            random.random_range(1.0..60.0)
        } else {
            random.random_range(60.0..179.0)
        },
        hither: 0.0,
        resolution: (width, height),
    };
    view.camera(width, height).expect("a camera")
}

/// A random sphere in a direction from `eye`: small or large, far from the eye or close to it.
pub fn sphere(random: &mut ChaCha8Rng, eye: DVec3, towards: DVec3) -> scene::Sphere {
    let distance = magnitude(random, -10.0, 20.0);
    let share = match random.random_range(0..3) {
        0 => magnitude(random, -24.0, 0.0),
        1 => random.random_range(0.0..1.0),
        _ => 1.0 - magnitude(random, -24.0, 0.0),
    };
    scene::Sphere {
        centre: eye + towards * distance,
        radius: (distance * share).max(1e-9),
        colour: DVec3::ONE,
    }
}
