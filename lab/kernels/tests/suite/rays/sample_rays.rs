//! `sample_rays_r16`.

use kernels::bench::{Bench, random};
use kernels::cases::eye::error::camera;
use kernels::cases::whitted::rays::call;
use rand::Rng as _;
use twins::primary_rays::ABSENT;
use twins::ray_setup::Basis;
use twins::sample_rays::{Pixel, sample, sample_ray};

use super::COUNTS;

fn check(bench: &mut Bench, basis: &Basis, background: u32, pixels: &[Pixel], across: u32) {
    let packets = call::sample_rays(bench, basis, background, pixels, across);
    assert_eq!(packets.len(), pixels.len() / 4);
    for (rows, packet) in pixels.chunks(4).zip(&packets) {
        for (lane, found) in packet.iter().enumerate() {
            let expected = sample_ray(basis, background, rows[lane / 4], across, lane);
            assert_eq!(*found, expected, "{basis:x?}, {rows:?}, lane {lane}");
        }
    }
}

#[test]
fn cameras_equal_the_twin_in_lists_of_any_length() {
    let mut random = random();
    let mut bench = Bench::new();
    for across in [2, 4] {
        for count in COUNTS {
            let basis = camera(&mut random);
            let pixels: Vec<_> = (0..4 * count)
                .map(|_| Pixel {
                    sum: random.random(),
                    x: random.random_range(-1..8192),
                    y: random.random_range(0..8192),
                })
                .collect();
            check(&mut bench, &basis, random.random(), &pixels, across);
        }
    }
}

#[test]
fn any_bits_at_all_equal_the_twin() {
    let mut random = random();
    let mut bench = Bench::new();
    for across in [2, 4] {
        for _ in 0..500 {
            let basis =
                Basis { corner: random.random(), right: random.random(), down: random.random() };
            let pixels = [(); 4].map(|()| Pixel {
                sum: random.random(),
                x: random.random(),
                y: random.random(),
            });
            check(&mut bench, &basis, random.random(), &pixels, across);
        }
    }
}

#[test]
fn a_row_without_a_pixel_has_no_rays() {
    let mut bench = Bench::new();
    let basis = camera(&mut random());
    let pixels = [0, -1, 5, -1].map(|x| Pixel { sum: 0, x, y: 0 });
    let packets = call::sample_rays(&mut bench, &basis, 0, &pixels, 2);
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
