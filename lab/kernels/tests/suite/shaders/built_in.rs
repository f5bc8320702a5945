//! The built-in shaders: the checker follows its rule.

use kernels::cases::whitted::shaders::{CHECKER, Call};
use kernels::prelude::*;

/// The rule of the cubes in f64. A side at an integer must belong to one of its two cubes.
#[test]
fn the_checker_follows_its_rule() {
    let mut random = random();
    let mut bench = Bench::new();
    let mut odd = 0;
    for round in 0..200 {
        let scale = [1.0, 0.5, 4.0][round % 3];
        let mut call = Call::<CHECKER>::sensible(1, &mut random);
        call.mask = [true; 16];
        call.eye = [1.0, 2.0, 3.0].map(from_f64);
        call.parameters = [9.0, 9.0, 9.0, scale].map(from_f64);
        for lane in 0..16 {
            // In the plane x = 2 / scale, except for rounding in either direction.
            let off = random.random_range(-1e-5..1e-5);
            call.surfaces.point_x[lane] = single(from_f64(2.0 / scale - 1.0 + off));
        }
        let Bits(found) = call.call(&mut bench);
        for lane in 0..16 {
            let [y, z] = [
                to_f64(bits(call.surfaces.point_y[lane])) + 2.0,
                to_f64(bits(call.surfaces.point_z[lane])) + 3.0,
            ];
            let within = |place: f64| (place * scale + 1.0 / 1024.0).floor();
            // Too close to a side to be sure.
            let near = |place: f64| {
                let place = place * scale + 1.0 / 1024.0;
                (place - place.round()).abs() < 1e-4
            };
            if near(y) || near(z) {
                continue;
            }
            let expected = (2.0 + within(y) + within(z)).rem_euclid(2.0) == 1.0;
            let changed = to_f64(bits(found.red[lane])) == 9.0;
            assert_eq!(changed, expected, "{y}, {z}, {scale}");
            odd += u32::from(expected);
        }
    }
    assert!((1000..2200).contains(&odd), "{odd} in odd cubes");
}
