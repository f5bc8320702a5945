//! `texture_places_r16` and `texture_filter_r16`.

use kernels::cases::whitted::isect::error::SCALES;
use kernels::cases::whitted::texture::{
    Filter, Places, Table, any_filtered, any_hit, coloured, table, truth,
};
use kernels::prelude::*;
use twins::texture::Hit;

const ANGLE: f64 = 1e-3;

/// A texture of 20x36 texels with all of its levels.
fn levels(wraps: u32) -> Table {
    table(&[(20, 36), (10, 18), (5, 9), (2, 4), (1, 2), (1, 1)], wraps)
}

/// The level is the one for the pixel's width, but where that is between two levels.
#[test]
fn the_level_is_that_of_a_pixels_width() {
    let mut random = random();
    let mut bench = Bench::new();
    let table = levels(10);
    let (mut compared, mut other, mut seen) = (0, 0, [0; 6]);
    for _ in 0..300 {
        for scale in SCALES {
            let hits: [Hit; 16] = std::array::from_fn(|_| any_hit(&mut random, scale));
            let inputs = Places { hits: hits.map(Some), table: table.clone(), anything: 0 };
            for (hit, found) in hits.iter().zip(inputs.check(&mut bench).iter().flatten()) {
                let (_, width) = truth(hit, ANGLE);
                let exact = libm::log2(width * libm::sqrt(20.0 * 36.0));
                let expected = (libm::round(exact).max(0.0) as usize).min(5);
                let firsts = table.levels.iter().map(|level| level.first);
                let level = firsts.filter(|&first| first <= found.tile).count() - 1;
                (compared, seen[level]) = (compared + 1, seen[level] + 1);
                if level != expected {
                    other += 1;
                    let between = (exact - libm::floor(exact) - 0.5).abs();
                    assert!(between < 1e-4, "{level} for {exact}");
                }
            }
        }
    }
    println!("{other} of {compared} levels differ; hits in each: {seen:?}");
    assert!(other < 5 && seen.iter().all(|&count| count > 50), "{seen:?}");
}

/// Coordinates outside of the texture are where `wraps` puts them.
#[test]
fn edges_are_continued() {
    let mut bench = Bench::new();
    // The whole triangle has the same coordinates.
    let hit = |u: f64, v: f64| Hit {
        vertices: [[-1.0, -1.0, -5.0], [1.0, -1.0, -5.0], [0.0, 1.0, -5.0]]
            .map(|it| it.map(from_f64)),
        coordinates: [[u, v].map(from_f64); 3],
        point: [0.0, 0.0, -5.0].map(from_f64),
        plane: [0.0, 0.0, 1.0].map(from_f64),
        origin: [0; 3],
        direction: [0.0, 0.0, -1.0].map(from_f64),
        t: from_f64(5.0),
    };
    // The texel at the middle of which the point is, counted from one before the first.
    let mut at = |wraps: u32, u: f64, v: f64| {
        let table = table(&[(64, 64)], wraps);
        let inputs = Places { hits: [Some(hit(u, v)); 16], table, anything: 0 };
        let found = inputs.check(&mut bench)[0].expect("a texel");
        assert_eq!((to_f64(found.right), to_f64(found.down)), (0.0, 0.0));
        let column = 8 * (found.tile % 9) + found.place / 4 % 9;
        let row = 8 * (found.tile / 9) + found.place / 4 / 9;
        (column, row)
    };
    let middle = |texel: f64| (texel + 0.5) / 64.0;
    assert_eq!(at(0, middle(3.0), middle(9.0)), (4, 10));
    // Repeated across and clamped down, then mirrored.
    assert_eq!(at(8, 7.0 + middle(3.0), 0.5 / 64.0), (4, 1));
    assert_eq!(at(8, middle(3.0) - 7.0, 1.0 - 0.5 / 64.0), (4, 64));
    assert_eq!(at(2, 0.5 / 64.0, middle(3.0) - 7.0), (1, 4));
    assert_eq!(at(12, 7.0 + middle(3.0), 0.5 / 64.0), (61, 1));
    assert_eq!(at(12, middle(3.0) - 8.0, 0.5 / 64.0), (4, 1));
    assert_eq!(at(15, middle(3.0) - 1.0, middle(5.0) + 1.0), (61, 59));
}

#[test]
fn white_texels_keep_colour() {
    let mut random = random();
    let mut bench = Bench::new();
    let lanes = std::array::from_fn(|_| {
        let mut lane = any_filtered(&mut random);
        lane.texels = [0xffff_ff00; 4];
        Some(lane)
    });
    for are_roots in [false, true] {
        let after = Filter { lanes, are_roots, anything: 0 }.check(&mut bench);
        assert_eq!(after, Bits(coloured(&lanes, 0)));
    }
}
