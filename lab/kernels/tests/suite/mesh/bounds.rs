//! Every lane counts in `mesh_bounds_r16` and `mesh_farthest_r16`.

use kernels::cases::whitted::mesh::bounds::{Bounds, Farthest};
use kernels::cases::whitted::rays::fans;
use kernels::prelude::*;
use twins::mesh::{mesh_bound, mesh_farthest};
use twins::primary_rays::{ABSENT, Ray};

/// Checks both kernels: the second one with the rays' distances changed to those of `later`.
fn check(bench: &mut Bench, packet: [Ray; 16], later: [Ray; 16]) {
    let bounds = vec![mesh_bound(&packet)];
    Bounds { packets: vec![packet], shears: 0 }.check(bench);
    Farthest { packets: vec![later], bounds }.check(bench);
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
        check(&mut bench, alone, far);
        assert_eq!(mesh_bound(&alone).farthest, rays[lane].t);
        assert_eq!(mesh_farthest(&far), 5 << 28);
    }
    let absent = rays.map(|ray| Ray { t: ABSENT, ..ray });
    check(&mut bench, absent, absent);
    assert_eq!(mesh_bound(&absent).farthest, ABSENT);
    assert_eq!(mesh_farthest(&absent), ABSENT);
}
