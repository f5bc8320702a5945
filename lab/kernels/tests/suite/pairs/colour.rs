//! `colour_vertices_r16`.

use kernels::bench::{Bench, random};
use kernels::cases::whitted::colour::{any_hit, coloured, surfaces};
use kernels::cases::whitted::isect::error::SCALES;
use kernels::cases::whitted::texture::set_colour;
use kernels::description::any_bits;
use rand::Rng as _;
use spu_emulator::float::single::from_f64;
use twins::colour::{Hit, interpolated as twin};
use zerocopy::IntoBytes as _;

/// Runs the kernel and compares all surfaces with the twin.
fn check(bench: &mut Bench, hits: &[Option<Hit>; 16], are_roots: bool, anything: u32) {
    let found = coloured(bench, hits, are_roots, anything);
    let mut expected = surfaces(hits, anything);
    for (lane, hit) in hits.iter().enumerate() {
        if let Some(hit) = hit {
            set_colour(&mut expected, lane, twin(hit, are_roots));
        }
    }
    assert_eq!(found.as_bytes(), expected.as_bytes(), "{hits:x?}");
}

#[test]
fn sensible_hits_equal_the_twin() {
    let mut random = random();
    let mut bench = Bench::new();
    for _ in 0..100 {
        for scale in SCALES {
            let hits = std::array::from_fn(|_| {
                random.random_ratio(3, 4).then(|| any_hit(&mut random, scale))
            });
            check(&mut bench, &hits, random.random(), random.random());
        }
    }
}

#[test]
fn any_bits_at_all_equal_the_twin() {
    let mut random = random();
    let mut bench = Bench::new();
    for _ in 0..1000 {
        let hits = [(); 16].map(|()| Some(any_bits(&mut random)));
        check(&mut bench, &hits, random.random(), random.random());
    }
}

/// A vertex's colour is that of the point there, and white leaves a colour as it is.
#[test]
fn colours_at_vertices() {
    let mut bench = Bench::new();
    let vertices = [[-1.0, -1.0, -5.0], [1.0, -1.0, -5.0], [0.0, 1.0, -5.0]];
    let colour = [0.25, 0.5, 1.0];
    let white = 1023 << 22 | 1023 << 12 | 1023 << 2;
    for (corner, point) in vertices.into_iter().enumerate() {
        for colours in [[white, 0, 1023 << 12], [white; 3]] {
            let hit = Hit {
                vertices: vertices.map(|vertex| vertex.map(from_f64)),
                colours,
                point: point.map(from_f64),
                plane: [0.0, 0.0, 1.0].map(from_f64),
                colour: colour.map(from_f64),
            };
            let hits = [Some(hit); 16];
            for are_roots in [false, true] {
                let found = coloured(&mut bench, &hits, are_roots, 0);
                if colours == [white; 3] {
                    assert_eq!(found.as_bytes(), surfaces(&hits, 0).as_bytes());
                    continue;
                }
                let rows = [found.red, found.green, found.blue];
                for (channel, row) in rows.iter().enumerate() {
                    let is_lit = colours[corner] >> (22 - 10 * channel) & 1023 != 0;
                    let exact = if is_lit { colour[channel] } else { 0.0 };
                    let off = row.map(|it| (f64::from(it.get()) - exact).abs());
                    assert!(off.iter().all(|&off| off < 1e-6), "{corner} {off:?}");
                }
            }
        }
    }
}
