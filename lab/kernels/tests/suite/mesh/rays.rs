//! No ray is left out that enters a box of a block that rays go through one by one.

use kernels::cases::whitted::mesh::call::Node;
use kernels::cases::whitted::mesh::rays::{Batch, FewRays, FilterRays};
use kernels::cases::whitted::rays::fans::FANS;
use twins::mesh::Corners;
use twins::mesh_rays::bit;

use super::conservative::{self, AXES, SLACK};
use kernels::prelude::*;

/// Boxes that touch a ray or almost do, with the slack that they have in blocks, are met by it:
/// by f64 from the singles of the records.
#[test]
fn entered_boxes_are_kept() {
    let mut random = random();
    let mut bench = Bench::new();
    let [mut met, mut found] = [0; 2];
    for round in 0..800 {
        let scale = magnitude(1e-6..1e9, &mut random);
        let fan = FANS[round % FANS.len()];
        let axes = AXES[round % AXES.len()];
        let rays = conservative::packet(fan, axes, scale, &mut random);
        let number = random.random_range(0..16);
        let ray = rays[number as usize];
        if ray.t >> 31 != 0 {
            continue;
        }
        let corners: [Corners; 4] =
            std::array::from_fn(|_| conservative::touching(&ray, scale, &mut random));
        let node = Node {
            boxes: corners.map(|corners| conservative::widened(&corners, SLACK)),
            words: [1, 2, 3, 4],
        };
        let batch = Batch { packets: vec![rays], nodes: vec![node], bits: bit(number) };
        let (visits, _) = FilterRays(batch.clone()).check(&mut bench);
        let few = FewRays { batch, base: 0 }.check(&mut bench);
        for (word, corners) in (1..).zip(&corners) {
            if conservative::meets(&ray, corners) {
                met += 1;
                assert!(visits.iter().any(|visit| visit.child == word), "{ray:x?} {corners:x?}");
                assert!(few.contains(&(word, 0)), "{ray:x?} {corners:x?}");
            }
        }
        found += visits.len();
    }
    println!("{found} found, {met} met");
    assert!(met > 300);
}
