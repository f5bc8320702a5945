//! `shade_depth_r16`.

use kernels::bench::{Bench, random};
use kernels::cases::eye::{call, error};
use kernels::description::any_bits;
use kernels::eye_records::{Hits, Vectors};
use rand::Rng as _;
use spu_emulator::float::single::{from_f64, to_f64};
use twins::Single;
use twins::isect_pairs::Hit;
use twins::shade_depth::{Depth, shade_depth};

use super::COUNTS;

/// Compares with the twin, and returns the colours.
fn check(bench: &mut Bench, hits: &[Hits], colours: &[[Single; 3]], depth: Depth) -> Vec<Vectors> {
    let (found, counts) = call::shade_depth(bench, hits, colours, depth);
    let mut expected_counts = [0; 4];
    for (hits, found) in hits.iter().zip(&found) {
        for (lane, (hit, found)) in hits.iter().zip(found).enumerate() {
            let none = hit.object == 0;
            let expected = shade_depth(hit.t, colours[hit.object as usize], none, depth);
            assert_eq!(*found, expected, "{hit:x?}, {depth:x?}");
            expected_counts[lane % 4] += u32::from(!none);
        }
    }
    assert_eq!(counts, expected_counts, "rays that hit something");
    found
}

#[test]
fn scenes_equal_the_twin_in_lists_of_any_length() {
    let mut random = random();
    let mut bench = Bench::new();
    for _ in 0..30 {
        for count in COUNTS {
            let (depth, colours, first) = error::shaded_hits(&mut random);
            let mut hits = vec![first; count];
            for hit in hits.iter_mut().flatten().filter(|hit| hit.object != 0) {
                hit.object = random.random_range(0..colours.len() as u32);
                hit.t = from_f64(to_f64(hit.t) * random.random_range(0.9..1.1));
            }
            check(&mut bench, &hits, &colours, depth);
        }
    }
}

#[test]
fn colours_fade_from_whole_to_black_and_the_background_does_not() {
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
        let hit = Hit { t: from_f64(t), object };
        let found = check(&mut bench, &[[hit; 16]], &colours, depth);
        let expected = colours[object as usize].map(|channel| bright * to_f64(channel));
        assert_eq!(found[0][0].map(to_f64), expected, "object {object} at {t}");
    }
}

#[test]
fn any_bits_at_all_equal_the_twin() {
    let mut random = random();
    let mut bench = Bench::new();
    for _ in 0..1000 {
        let colours: [[Single; 3]; 20] = random.random();
        let depth = any_bits(&mut random);
        let hits = [[(); 16]; 2].map(|packet| {
            packet.map(|()| Hit { t: random.random(), object: random.random_range(0..20) })
        });
        check(&mut bench, &hits, &colours, depth);
    }
}
