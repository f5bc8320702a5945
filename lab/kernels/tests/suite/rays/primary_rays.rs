//! `primary_rays_r16`.

use kernels::cases::eye::error::camera;
use kernels::cases::whitted::rays::makers::PrimaryRays;
use kernels::prelude::*;
use twins::primary_rays::{ABSENT, View};

#[test]
fn primary_rays_outside_picture_are_absent() {
    let mut random = random();
    let mut bench = Bench::new();
    for (width, height) in (0..=9).flat_map(|width| (0..=9).map(move |height| (width, height))) {
        let view = View { basis: camera(&mut random), background: 0, width, height };
        let packets = PrimaryRays { view, corners: vec![[4, 4]], pixels: 0 }.check(&mut bench);
        for (lane, ray) in (0..).zip(&packets[0]) {
            let within = 4 + lane % 4 < width && 4 + lane / 4 < height;
            let (t, weight) = if within { (twins::FARTHEST, ONE) } else { (ABSENT, 0) };
            assert_eq!((ray.t, ray.weight), (t, weight), "{width} x {height}, {lane}");
        }
    }
}
