//! What views of height fields guarantee.

use std::sync::Arc;

use glam::DVec3;
use rand::{Rng as _, SeedableRng as _};
use rand_chacha::ChaCha8Rng;
use scenes::{HeightField, HeightRegion, HeightSample};

use super::levels::{Levels, Packing};
use super::samples::HeightSamples;
use super::shaped::HeightViews;
use crate::scene::colour::Colour;

fn field(columns: u32, rows: u32) -> Arc<HeightField> {
    let heights = (0..columns * rows).map(|at| (at.wrapping_mul(2_654_435_761) >> 20) as u16);
    let field = HeightField::new([columns, rows], heights.collect(), Vec::new(), 1.0, 0.01);
    Arc::new(field.expect("a height field"))
}

#[test]
fn samples_of_all_levels_take_less_than_six_bytes_each() {
    let mut views = HeightViews::new(&field(1025, 1025), DVec3::ZERO, Colour::Srgb);
    views.look(DVec3::Y, Some((0, DVec3::ONE)));
    let bytes = views.samples().bytes() as f64 / f64::from(1025 * 1025);
    println!("{bytes} bytes a sample");
    assert!(bytes < 6.0, "{bytes}");
}

/// Every square of the first level is in exactly one block, from wherever it is seen.
#[test]
fn blocks_cover_the_field_once() {
    for (columns, rows) in [(2, 2), (9, 100), (345, 404), (1025, 513)] {
        let mut views = HeightViews::new(&field(columns, rows), DVec3::ZERO, Colour::Linear);
        for eye in [[0.0, 60.0, 0.0], [300.0, 5.0, -100.0], [-9e4, 10.0, 9e4]] {
            views.look(eye.into(), None);
            let mut seen = vec![0_u8; (columns * rows) as usize];
            for number in views.view().numbers() {
                let level = number >> 19 & 15;
                let [column, row] = [(number & 511) * 8, (number >> 9 & 1023) * 4];
                for z in (row << level)..((row + 4) << level).min(rows - 1) {
                    for x in (column << level)..((column + 8) << level).min(columns - 1) {
                        seen[(z * columns + x) as usize] += 1;
                    }
                }
            }
            let squares = (0..rows - 1).flat_map(|z| (0..columns - 1).map(move |x| (x, z)));
            let wrong = squares.filter(|&(x, z)| seen[(z * columns + x) as usize] != 1).count();
            assert_eq!(wrong, 0, "{columns} x {rows} from {eye:?}");
        }
    }
}

#[test]
fn views_are_used_in_turn() {
    let mut views = HeightViews::new(&field(65, 65), DVec3::ZERO, Colour::Linear);
    let mut shown = Vec::new();
    for frame in 0..20 {
        views.look(DVec3::new(f64::from(frame), 9.0, 0.0), None);
        shown.push(views.view().clone());
        if shown.len() > 2 {
            shown.remove(0);
        }
    }
    assert_eq!(views.count(), [3, 1]);
}

/// After each of many changes, anywhere and of any size, the samples are the same bytes as those
/// of a new field, while the two last pictures keep theirs.
#[test]
fn shaped_samples_are_those_of_a_new_field() {
    for (columns, rows) in [(2, 2), (9, 100), (64, 33), (345, 404)] {
        let mut field = HeightField::clone(&field(columns, rows));
        let packing = Packing::new(Colour::Srgb);
        let made = Arc::new(field.clone());
        let mut views = HeightViews::new(&made, DVec3::ZERO, Colour::Srgb);
        let mut shown = Vec::new();
        let mut random = ChaCha8Rng::seed_from_u64(1);
        for round in 0..40 {
            let mut range = |count: u32| {
                let start = random.random_range(0..count);
                start..start + random.random_range(1..2 + (count - start) / (1 + round % 5))
            };
            let region = HeightRegion { columns: range(columns), rows: range(rows) };
            let height: u16 = random.random();
            field.shape(&region, |[column, row], was| HeightSample {
                height: height ^ was.height >> 3,
                colour: [column as u8, row as u8, was.colour[0].wrapping_add(77)],
            });
            views.shape(&field, &region);
            if round % 3 > 0 {
                views.look(DVec3::new(0.0, 9.0, 0.0), None);
                shown.push((views.view().clone(), views.samples().clone()));
            }
            if shown.len() > 2 {
                shown.remove(0);
            }
            let new = HeightSamples::new(&field, &Levels::new(&field, &packing), &packing);
            assert!(*views.samples() == new, "{columns} x {rows}, round {round}, {region:?}");
        }
        assert!(views.count().iter().all(|count| *count <= 3), "{:?}", views.count());
    }
}
