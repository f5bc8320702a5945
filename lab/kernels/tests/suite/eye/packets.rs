//! The kernels that make, cull, shade and pack packets.

use kernels::cases::eye::cull::{FilterSpheres, HiddenPairs};
use kernels::cases::eye::error::{self, NO_HITS};
use kernels::cases::eye::packets::{Pack, ShadeDepth};
use kernels::prelude::*;
use kernels::source::Source;
use protocol::layout::Sphere;
use twins::isect_pairs::Hit;
use twins::ray_setup::Basis;
use twins::shade_depth::Depth;

#[test]
fn filter_keeps_sphere_that_one_ray_meets() {
    let mut bench = Bench::new();
    let sphere = Sphere {
        centre: [0.0, 0.0, -5.0].map(|value| single(from_f64(value))),
        ray_limit: single(from_f64(4.9)),
        ..Sphere::new_zeroed()
    };
    let [along, away] = [[0.0, 0.0, -1.0], [0.0, 1.0, 0.0]].map(|ray| ray.map(from_f64));
    let mut passing = |rays| {
        let inputs = FilterSpheres { packets: vec![rays], spheres: vec![sphere; 4] };
        inputs.check(&mut bench).len()
    };
    for lane in 0..16 {
        let mut rays = [away; 16];
        rays[lane] = along;
        assert_eq!(passing(rays), 4);
    }
    assert_eq!(passing([away; 16]), 0);
}

#[test]
fn pair_seen_by_one_ray_is_not_hidden() {
    let mut bench = Bench::new();
    let near = from_f64(2.0);
    let mut stays = |lane: usize, t| {
        let mut hits = NO_HITS.map(|hit| Hit { t: near, ..hit });
        hits[lane].t = t;
        let inputs = HiddenPairs { packets: vec![hits], near: vec![near] };
        inputs.check(&mut bench).len() == 1
    };
    for lane in 0..16 {
        assert!(stays(lane, near + 1) && stays(lane, FARTHEST));
        // The largest possible distance. Such a ray can't hit any part of the sphere.
        assert!(!stays(lane, near - 1) && !stays(lane, near));
    }
}

#[test]
fn directions_with_zeros_and_extreme_lengths() {
    let header = Source::find("ray_setup_r16").and_then(Source::header);
    let stated = header.and_then(|header| header.stated_error()).expect("an error");
    let mut bench = Bench::new();
    for scale in [1e-9, 1.0, 1e9] {
        for axis in 0..3 {
            let mut corner = [0; 3];
            corner[axis] = from_f64(scale);
            let basis = Basis { corner, right: [0; 3], down: [0x8000_0000; 3] };
            let error = error::error_of_rays(&mut bench, &basis, &[[0, 8188]]);
            assert!(error <= stated, "{basis:x?}: {error}");
        }
    }
}

#[test]
fn colours_fade_with_depth_except_background() {
    let mut bench = Bench::new();
    let colours = [[0.25, 0.5, 0.75], [1.0, 0.5, 0.25]].map(|colour| colour.map(from_f64));
    let depth = Depth { far: from_f64(8.0), scale: from_f64(0.25) };
    for (t, object, bright) in [
        (0.0, 1, 1.0),
        (4.0, 1, 1.0),
        (6.0, 1, 0.5),
        (8.0, 1, 0.0),
        (1e30, 1, 0.0),
        (1e30, 0, 1.0),
        (6.0, 0, 1.0),
    ] {
        let hits = vec![[Hit { t: from_f64(t), object }; 16]];
        let (found, _) = ShadeDepth { hits, colours: colours.to_vec(), depth }.check(&mut bench);
        let expected = colours[object as usize].map(|channel| bright * to_f64(channel));
        assert_eq!(found[0][0].map(to_f64), expected, "object {object} at {t}");
    }
}

#[test]
fn pack_keeps_every_byte_and_clamps_out_of_range() {
    let mut bench = Bench::new();
    let beyond = [
        (0x8000_0000, 0),
        (0xffff_ffff, 0),
        (from_f64(-0.001), 0),
        (from_f64(1.001), 255),
        (0x7fff_ffff, 255),
    ];
    let bytes = (0..=255_u32).map(|byte| (from_f64(f64::from(byte) / 255.0), byte));
    for (value, byte) in bytes.chain(beyond) {
        let words = Pack { colours: vec![[[value; 3]; 16]], shifts: [24, 8, 0] }.check(&mut bench);
        assert_eq!(words[0], [byte * 0x0100_0101; 16], "{value:x}");
    }
}
