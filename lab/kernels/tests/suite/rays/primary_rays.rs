//! `primary_rays_r16`.

use kernels::bench::{Bench, random};
use kernels::cases::eye::error::camera;
use kernels::cases::whitted::rays::call::{self, sum_of};
use rand::Rng as _;
use twins::ONE;
use twins::primary_rays::{ABSENT, View, primary_ray};
use twins::ray_setup::Basis;

use super::COUNTS;

/// The first column and row whose pixel numbers are not exact in single precision.
const PIXELS_END: u32 = 1 << 23;

fn check(bench: &mut Bench, view: &View, corners: &[[u32; 2]], pixels: u32) {
    let packets = call::primary_rays(bench, view, corners, pixels);
    for (number, (corner, packet)) in corners.iter().zip(&packets).enumerate() {
        let corner = corner.map(|at| at as i32);
        for (lane, found) in packet.iter().enumerate() {
            let expected = primary_ray(view, sum_of(pixels, number), corner, lane);
            assert_eq!(*found, expected, "{view:x?}, {corner:?}, lane {lane}");
        }
    }
}

#[test]
fn cameras_equal_the_twin_in_lists_of_any_length() {
    let mut random = random();
    let mut bench = Bench::new();
    for _ in 0..20 {
        for count in COUNTS {
            let view = View {
                basis: camera(&mut random),
                background: random.random(),
                width: random.random_range(1..8192),
                height: random.random_range(1..8192),
            };
            let corners: Vec<[u32; 2]> =
                (0..count).map(|_| [0; 2].map(|_: u32| random.random_range(0..2048) * 4)).collect();
            check(&mut bench, &view, &corners, random.random());
        }
    }
}

#[test]
fn any_bits_at_all_equal_the_twin() {
    let mut random = random();
    let mut bench = Bench::new();
    for _ in 0..1000 {
        let view = View {
            basis: Basis { corner: random.random(), right: random.random(), down: random.random() },
            background: random.random(),
            width: random.random(),
            height: random.random(),
        };
        let corner = [0; 2].map(|_: u32| random.random_range(0..PIXELS_END - 4));
        check(&mut bench, &view, &[corner], random.random());
    }
}

#[test]
fn beyond_the_edges_no_ray_is_there() {
    let mut random = random();
    let mut bench = Bench::new();
    for (width, height) in (0..=9).flat_map(|width| (0..=9).map(move |height| (width, height))) {
        let view = View { basis: camera(&mut random), background: 0, width, height };
        let packets = call::primary_rays(&mut bench, &view, &[[4, 4]], 0);
        for (lane, ray) in (0..).zip(&packets[0]) {
            let within = 4 + lane % 4 < width && 4 + lane / 4 < height;
            let (t, weight) = if within { (twins::FARTHEST, ONE) } else { (ABSENT, 0) };
            assert_eq!((ray.t, ray.weight), (t, weight), "{width} x {height}, {lane}");
        }
    }
}
