//! What `cull_boxes` and `filter_boxes_r16` make of nothing.

use kernels::cases::whitted::mesh::boxes::{Boxed, NOBODY, some_node, some_packet};
use kernels::cases::whitted::mesh::call::Node;
use kernels::prelude::*;
use twins::mesh::mesh_bound;
use twins::primary_rays::{ABSENT, Ray};

/// A lane without a child and a packet without rays meet nothing, wherever the eye moves the former
/// and however it is widened.
#[test]
fn empty_nodes_and_bounds_meet_nothing() {
    let mut random = random();
    let mut bench = Bench::new();
    for _ in 0..500 {
        let (rays, bound) = some_packet(&mut random);
        let absent = rays.map(|ray| Ray { t: ABSENT, ..ray });
        let packets = vec![(rays, bound), (absent, mesh_bound(&absent))];
        let nobody = Node {
            boxes: [NOBODY.map(|corner| corner.map(|c| c - (1 << 5))); 4],
            words: random.random(),
        };
        let nodes = vec![nobody, some_node(&mut random)];
        let pairs = vec![[0, 0], [0, 1], [1, 1]];
        let culled = Boxed::<false> {
            nodes: nodes.clone(),
            packets: packets.clone(),
            pairs: pairs.clone(),
            base: 0,
        };
        assert!(culled.check(&mut bench).is_empty());
        assert!(Boxed::<true> { nodes, packets, pairs, base: 0 }.check(&mut bench).is_empty());
    }
}
