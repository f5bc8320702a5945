//! The kernels of rectangles and planes.

use twins::rectangle::{Rectangle, any_rectangle, isect_plane, isect_rectangle};

use super::{Tested, around_rectangle, changed, code, put_rays, put_rectangle, tested};
use crate::flat_records::Ray;
use crate::prelude::*;

/// Tests whether a rectangle is in the way of rays.
pub const ANY: usize = 0;
/// Intersects rays with a rectangle.
pub const NEAREST: usize = 1;
/// Intersects rays with its plane.
pub const PLANE: usize = 2;

/// Rays and a rectangle, for one of these tests.
#[derive(Clone, Debug)]
pub struct WithRectangle<const TEST: usize> {
    /// The rays.
    pub rays: [Ray; 16],
    /// The rectangle.
    pub rectangle: Rectangle,
    /// Its number as an object.
    pub object: u32,
}

impl<const TEST: usize> Description for WithRectangle<TEST> {
    const KERNEL: &'static str =
        ["any_rectangle_r16", "isect_rectangle_r16", "isect_plane_r16"][TEST];
    const ROUNDS: [usize; 2] = [2000, 3000];
    const LENGTHS: &'static [usize] = &[1];
    const SHARES: [Range<f64>; 2] = [0.1..1.1, if TEST == PLANE { 0.02..0.9 } else { 0.0001..0.9 }];
    type Placed = Place;
    type Found = Tested;

    fn sensible(_: usize, random: &mut ChaCha8Rng) -> Self {
        let (rectangle, rays, _) = around_rectangle(random);
        Self { rays, rectangle, object: random.random() }
    }

    fn any(_: usize, random: &mut ChaCha8Rng) -> Self {
        Self { rays: any_bits(random), rectangle: any_bits(random), object: random.random() }
    }

    fn place(&self, bench: &mut Bench) -> (Place, Vec<u32>) {
        let rays = put_rays(bench, &self.rays);
        let shape = put_rectangle(bench, &self.rectangle, !self.object);
        let mut arguments = vec![rays.address, shape.address];
        arguments.extend((TEST != ANY).then_some(self.object));
        (rays, arguments)
    }

    fn found(&self, bench: &Bench, placed: &Place, returned: u32) -> Tested {
        if TEST == ANY {
            tested::<true>(bench, *placed, returned)
        } else {
            tested::<false>(bench, *placed, returned)
        }
    }

    fn twin(&self, _: &Place) -> Tested {
        let Self { rays, rectangle, object } = self;
        if TEST == ANY {
            let is_in_way =
                |ray: Ray| any_rectangle(ray.origin, ray.direction, rectangle, ray.hit.t);
            return (code(rays.map(is_in_way)), rays.map(|ray| ray.hit));
        }
        let twin = if TEST == PLANE { isect_plane } else { isect_rectangle };
        (0, rays.map(|ray| twin(ray.origin, ray.direction, rectangle, *object, ray.hit)))
    }

    fn part(&self, found: &Tested) -> [usize; 2] {
        [changed(&self.rays, found), 16]
    }
}
