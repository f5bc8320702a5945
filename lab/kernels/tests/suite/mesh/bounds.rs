//! `mesh_bounds_r16` and `mesh_farthest_r16` compared with their twins.

use kernels::bench::{Bench, random};
use kernels::cases::whitted::mesh::call;
use kernels::cases::whitted::rays::fans::{self, FANS, SCALES};
use kernels::description::any_bits;
use kernels::vector::magnitude;
use protocol::layout::Shear;
use rand::Rng as _;
use twins::mesh::{MeshBound, mesh_bound, mesh_farthest};
use twins::primary_rays::{ABSENT, Ray};

use super::COUNTS;

/// Checks both kernels: the second one with the rays' distances changed to those of `later`.
fn check(bench: &mut Bench, packets: &[[Ray; 16]], later: &[[Ray; 16]], shears: u32) {
    let mut expected: Vec<(MeshBound, u32)> = (0..)
        .zip(packets)
        .map(|(number, rays)| (mesh_bound(rays), shears + number * size_of::<Shear>() as u32))
        .collect();
    assert_eq!(call::bounds(bench, packets, shears), expected, "{packets:x?}");
    let bounds: Vec<MeshBound> = expected.iter().map(|(bound, _)| *bound).collect();
    let found = call::farthest(bench, later, &bounds, shears);
    for ((bound, at), rays) in expected.iter_mut().zip(later) {
        bound.farthest = mesh_farthest(rays);
        *at = shears;
    }
    assert_eq!(found, expected, "{later:x?}");
}

#[test]
fn packets_equal_the_twin_in_lists_of_any_length() {
    let mut random = random();
    let mut bench = Bench::new();
    for _ in 0..40 {
        for count in COUNTS {
            let [packets, later] = std::array::from_fn(|_| {
                let mut fan = || {
                    let scale = magnitude(SCALES, &mut random);
                    fans::packet(FANS[random.random_range(0..FANS.len())], scale, &mut random)
                };
                (0..count).map(|_| fan()).collect::<Vec<_>>()
            });
            check(&mut bench, &packets, &later, 0x1_2340);
        }
    }
}

#[test]
fn any_bits_at_all_equal_the_twin() {
    let mut random = random();
    let mut bench = Bench::new();
    for _ in 0..1000 {
        let [packet, later] = [(); 2].map(|()| any_bits(&mut random));
        check(&mut bench, &[packet], &[later], random.random_range(0..1 << 30));
    }
}

/// Every lane in turn is the only one with a ray, and then the farthest of all.
#[test]
fn every_lane_counts() {
    let mut random = random();
    let mut bench = Bench::new();
    let rays = fans::packet(fans::Fan::Eye, 1.0, &mut random);
    for lane in 0..16 {
        let alone: [Ray; 16] = std::array::from_fn(|other| Ray {
            t: if other == lane { rays[lane].t } else { ABSENT },
            ..rays[other]
        });
        let far: [Ray; 16] = std::array::from_fn(|other| Ray {
            t: if other == lane { 5 } else { 4 } << 28,
            ..rays[other]
        });
        check(&mut bench, &[alone], &[far], 0);
        assert_eq!(mesh_bound(&alone).farthest, rays[lane].t);
        assert_eq!(mesh_farthest(&far), 5 << 28);
    }
    let absent = rays.map(|ray| Ray { t: ABSENT, ..ray });
    check(&mut bench, &[absent], &[absent], 0);
    assert_eq!(mesh_bound(&absent).farthest, ABSENT);
    assert_eq!(mesh_farthest(&absent), ABSENT);
}
