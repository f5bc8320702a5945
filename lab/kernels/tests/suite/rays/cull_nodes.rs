//! `cull_nodes` and `filter_children_r16`, and those for boxes.

use kernels::cases::whitted::rays::fans::{self, FANS};
use kernels::cases::whitted::rays::nodes::{
    BareBox, BareSphere, Child, CullNodes, FilterChildren, Listed, Volume,
};
use kernels::prelude::*;
use twins::bound::bound;
use twins::primary_rays::{ABSENT, Ray};

/// A lane without a child and a bound without rays meet nothing.
#[test]
fn empty_nodes_and_bounds_meet_nothing() {
    empty_volumes_are_culled::<BareSphere>();
    empty_volumes_are_culled::<BareBox>();
}

fn empty_volumes_are_culled<V: Volume>() {
    let mut random = random();
    let mut bench = Bench::new();
    for _ in 0..2000 {
        let fan = FANS[random.random_range(0..FANS.len())];
        let rays = fans::packet(fan, 1.0, &mut random);
        let absent = rays.map(|ray| Ray { t: ABSENT, ..ray });
        let nobody: [Child<V>; 4] = [(); 4].map(|()| {
            let child = Child::<V>::around(&mut random);
            Child { volume: child.volume.nobody(), ..child }
        });
        let nodes = vec![nobody, [(); 4].map(|()| Child::around(&mut random))];
        let packets = vec![rays, absent];
        let bounds: Vec<_> = packets.iter().map(bound).collect();
        let pairs = vec![[0, 0], [0, 1], [1, 1]];
        let culled = CullNodes {
            nodes: nodes.clone(),
            bounds: bounds.clone(),
            pairs: pairs.clone(),
            what: Listed::Address,
        };
        assert!(culled.check(&mut bench).is_empty());
        let filtered = FilterChildren { nodes, bounds, packets, pairs, in_place: false };
        assert!(filtered.check(&mut bench).is_empty());
    }
}

/// The rays of a packet meet fewer children than its bound does.
#[test]
fn rays_keep_fewer_children_than_their_bound() {
    fewer_are_kept::<BareSphere>();
    fewer_are_kept::<BareBox>();
}

fn fewer_are_kept<V: Volume>() {
    let mut random = random();
    let mut bench = Bench::new();
    let (mut kept, mut kept_by_rays) = (0, 0);
    for _ in 0..100 {
        let by_rays = FilterChildren::<V>::sensible(16, &mut random);
        let by_bounds = CullNodes {
            nodes: by_rays.nodes.clone(),
            bounds: by_rays.bounds.clone(),
            pairs: by_rays.pairs.clone(),
            what: Listed::Address,
        };
        kept += by_bounds.check(&mut bench).len();
        kept_by_rays += by_rays.check(&mut bench).len();
    }
    assert!(kept_by_rays > 0 && kept_by_rays < kept, "{kept_by_rays} of {kept}");
}
