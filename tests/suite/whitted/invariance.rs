//! The bytes are the same however the work is split and whatever is skipped, and the statistics
//! add up.

use crate::prelude::*;
use crate::whitted::frame::{Frame, WHITTED};

const SIZE: (u32, u32) = (160, 90);

fn frame(scene: &scenes::Scene, spus: u32, split: Split, skip: Skip) -> Frame {
    let settings = Settings { spus, split, skip, ..Settings::default() };
    Frame::of(scene, WHITTED, SIZE, settings)
}

fn picture_is_independent_of_spus_and_work_units(name: &str) {
    let scene = nff_scene(name);
    let picture = render(&scene, SIZE.0, SIZE.1, Settings::default());
    let one = frame(&scene, 1, Split::Units, Skip::Misses);
    let all = frame(&scene, 1, Split::Units, Skip::Nothing);
    let others = [
        frame(&scene, 6, Split::Units, Skip::Misses),
        frame(&scene, 1, Split::Slices, Skip::Misses),
        frame(&scene, 6, Split::Slices, Skip::Misses),
        frame(&scene, 6, Split::Slices, Skip::Nothing),
    ];

    let rays = one.rays();
    println!("{name}: {rays:?}");
    for (number, other) in [&one, &all].into_iter().chain(&others).enumerate() {
        assert!(other.picture == picture, "{name}: frame {number}");
        assert_eq!(other.rays(), rays, "{name}: frame {number}");
    }
    assert_eq!(rays.eye, u64::from(SIZE.0 * SIZE.1));
    let generations = one.generations();
    assert_eq!(others[0].generations(), generations, "{name}");
    let count = |numbers: [usize; 2]| numbers.map(|of| generations[of].rays).iter().sum::<u64>();
    assert!(generations[0].rays >= rays.eye, "{generations:?}");
    assert_eq!(count([2, 4]), rays.reflected + rays.refracted, "{name}");
    assert_eq!(count([1, 3]) + generations[5].rays, rays.shadow, "{name}");
    for (number, of) in generations.iter().enumerate() {
        assert!(of.packets * 16 >= of.rays && of.rays > 0, "{name}: {of:?}");
        assert!(of.nodes > 0 && of.tests > 0, "{name}: {of:?}");
        // What curved surfaces send on is scattered.
        let is_scattered = number > 1 && of.packets_scattered == of.packets;
        assert!(is_scattered || of.packets_scattered == 0, "{name}: {of:?}");
    }
    assert!(rays.eye_hit > 0 && rays.eye_hit < rays.hit);
    assert!(rays.reflected > 0 && rays.refracted > 0 && rays.shadow > 0);
    // Rays that hit nothing are counted as the rest, and there must be some.
    assert!(rays.hit < rays.eye + rays.reflected + rays.refracted);

    let (all, some) = (all.statistics.tests(), one.statistics.tests());
    println!("{name}: {all:?}, {some:?}");
    assert_eq!(all.skipped, 0, "{name}");
    assert_eq!(some.made + some.skipped, all.made, "{name}");
    assert!(some.made < all.made / 2, "{name}: {some:?}");
}

#[test]
fn spheres() {
    picture_is_independent_of_spus_and_work_units("whitted16.nff");
}

#[test]
fn all_shapes() {
    picture_is_independent_of_spus_and_work_units("shapes.nff");
}
