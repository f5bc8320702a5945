//! `load_rays_r16`.

use kernels::bench::{Bench, random};
use kernels::cases::whitted::rays::call;
use rand::Rng as _;
use twins::load_rays::{Queued, load_ray};

/// Random rays, which are copied whatever their bits are.
#[test]
fn queues_of_any_length_equal_the_twin() {
    let mut random = random();
    let mut bench = Bench::new();
    for count in (1..=65_usize).chain([127, 128, 129, 500]) {
        let memory: Vec<Queued> = (0..count.next_multiple_of(16))
            .map(|_| Queued {
                origin: random.random(),
                weight: random.random(),
                direction: random.random(),
                pixel: random.random(),
            })
            .collect();
        let [background, dummy] = random.random();
        let packets = call::load_rays(&mut bench, &memory, count as u32, background, dummy);
        assert_eq!(packets.len(), count.div_ceil(16));
        for (number, (found, queued)) in packets.as_flattened().iter().zip(&memory).enumerate() {
            let expected = load_ray(queued, number < count, background, dummy);
            assert_eq!(*found, expected, "ray {number} of {count}");
        }
    }
}
