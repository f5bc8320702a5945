//! `sample_rays_r16`.

use kernels::cases::eye::error::camera;
use kernels::cases::whitted::rays::makers::SampleRays;
use kernels::prelude::*;
use twins::primary_rays::ABSENT;
use twins::sample_rays::{Pixel, sample};

#[test]
fn a_row_without_a_pixel_has_no_rays() {
    let mut bench = Bench::new();
    let basis = camera(&mut random());
    let pixels = [0, -1, 5, -1].map(|x| Pixel { sum: 0, x, y: 0 }).to_vec();
    let packets = SampleRays { basis, background: 0, pixels, across: 2 }.check(&mut bench);
    for (lane, ray) in packets[0].iter().enumerate() {
        assert_eq!(ray.t == ABSENT, lane / 4 % 2 == 1);
        assert_eq!(ray.weight == 0, lane / 4 % 2 == 1);
    }
}

#[test]
fn samples_are_evenly_spread() {
    for across in [2, 4] {
        let cells = (0..across).flat_map(|row| (0..across).map(move |column| [column, row]));
        let samples: Vec<_> = cells.map(|cell| sample(across, cell)).collect();
        for axis in [0, 1] {
            let mut places: Vec<_> = samples.iter().map(|sample| sample[axis]).collect();
            places.sort_by(f64::total_cmp);
            let count = f64::from(across * across);
            for (number, place) in (0..).zip(places) {
                assert_eq!(place, (f64::from(number) + 0.5) / count - 0.5);
            }
        }
    }
}
