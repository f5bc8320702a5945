//! The built-in shaders: compared with their twins bit for bit, and checked for
//! changes outside their outputs.

use kernels::bench::{Bench, random};
use kernels::cases::whitted::shaders::Call;
use kernels::single::{bits, single};
use protocol::layout::Surfaces;
use rand::Rng;
use spu_emulator::float::single::{from_f64, to_f64};
use twins::shader;
use zerocopy::IntoBytes as _;

/// Calls a shader, and compares all surfaces with the lanes that `expected` computes.
fn check(
    bench: &mut Bench,
    kernel: &str,
    call: &Call,
    expected: impl Fn(&Call, &mut Surfaces, usize),
) {
    bench.reset();
    let (place, arguments) = call.put(bench);
    let mut wanted = call.surfaces;
    for lane in (0..16).filter(|&lane| call.mask[lane]) {
        expected(call, &mut wanted, lane);
    }
    bench.call(kernel, &arguments);
    let found: Surfaces = bench.read(place);
    let (found, wanted) = (found.as_bytes(), wanted.as_bytes());
    let differs = found.iter().zip(wanted).position(|(found, wanted)| found != wanted);
    assert_eq!(differs, None, "{kernel}: the byte of SURFACES that differs");
}

fn depth(call: &Call, wanted: &mut Surfaces, lane: usize) {
    let lit = shader::depth(bits(call.rays.t[lane]), call.colour(lane), call.parameters);
    let channels = [&mut wanted.lit_red, &mut wanted.lit_green, &mut wanted.lit_blue];
    for (channel, lit) in channels.into_iter().zip(lit) {
        channel[lane] = single(lit);
    }
    let shares =
        [&mut wanted.diffuse, &mut wanted.highlight, &mut wanted.mirror, &mut wanted.transmittance];
    for share in shares {
        share[lane] = single(0);
    }
}

fn checker(call: &Call, wanted: &mut Surfaces, lane: usize) {
    let Surfaces { point_x, point_y, point_z, .. } = &call.surfaces;
    let point = [point_x, point_y, point_z].map(|axis| bits(axis[lane]));
    let colour = shader::checker(point, call.colour(lane), call.parameters, call.eye);
    let channels = [&mut wanted.red, &mut wanted.green, &mut wanted.blue];
    for (channel, colour) in channels.into_iter().zip(colour) {
        channel[lane] = single(colour);
    }
}

fn sky(call: &Call, wanted: &mut Surfaces, lane: usize) {
    let [colour, lit] = [call.colour(lane), call.lit(lane)];
    let lit = shader::sky(call.direction(lane), colour, lit, call.parameters);
    let channels = [&mut wanted.lit_red, &mut wanted.lit_green, &mut wanted.lit_blue];
    for (channel, lit) in channels.into_iter().zip(lit) {
        channel[lane] = single(lit);
    }
}

#[test]
fn equal_their_twins() {
    let mut random = random();
    let mut bench = Bench::new();
    for _ in 0..500 {
        let call = Call::random(&mut random, |random| from_f64(random.random_range(-20.0..20.0)));
        check(&mut bench, "shader_depth", &call, depth);
        check(&mut bench, "shader_checker", &call, checker);
        check(&mut bench, "shader_sky", &call, sky);
    }
}

#[test]
fn any_bits_at_all_equal_their_twins() {
    let mut random = random();
    let mut bench = Bench::new();
    for _ in 0..500 {
        let call = Call::random(&mut random, |random| random.random());
        check(&mut bench, "shader_depth", &call, depth);
        check(&mut bench, "shader_checker", &call, checker);
        check(&mut bench, "shader_sky", &call, sky);
    }
}

/// The rule of the cubes in f64. A side at an integer must belong to one of its two cubes.
#[test]
fn the_checker_follows_its_rule() {
    let mut random = random();
    let mut bench = Bench::new();
    let mut odd = 0;
    for round in 0..200 {
        let scale = [1.0, 0.5, 4.0][round % 3];
        let mut call =
            Call::random(&mut random, |random| from_f64(random.random_range(-20.0..20.0)));
        call.mask = [true; 16];
        call.eye = [1.0, 2.0, 3.0].map(from_f64);
        call.parameters = [9.0, 9.0, 9.0, scale].map(from_f64);
        for lane in 0..16 {
            // In the plane x = 2 / scale, except for rounding in either direction.
            let off = random.random_range(-1e-5..1e-5);
            call.surfaces.point_x[lane] = single(from_f64(2.0 / scale - 1.0 + off));
        }
        bench.reset();
        let (place, arguments) = call.put(&mut bench);
        bench.call("shader_checker", &arguments);
        let found: Surfaces = bench.read(place);
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
