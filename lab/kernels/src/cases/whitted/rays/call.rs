//! Calls these kernels with the inputs of their twins.

use twins::bound::Bound;
use twins::load_rays::Queued;
use twins::primary_rays::{Ray, View};
use twins::ray_setup::Basis;
use twins::sample_rays::Pixel;
use twins::{ONE, Single, cull_box_nodes, cull_nodes};
use zerocopy::big_endian::F32;
use zerocopy::{FromZeros as _, Immutable, IntoBytes};

use crate::bench::{Bench, Place};
use crate::cases::eye::call::{address, put, put_places};
use crate::eye_records;
use crate::single::{bits, single};
use protocol::layout::{self, BoxNode, Candidate, Node, QueuedRay, RayPacket};

/// Fills the fields without meaning.
const ANYTHING: u32 = 0x7fff_ffff;

/// A bounding sphere.
#[derive(Clone, Copy, Debug)]
pub struct BareSphere {
    /// The centre.
    pub centre: [Single; 3],
    /// The radius, including the margin for the test's rounding.
    pub radius: Single,
}

/// A box along the axes.
#[derive(Clone, Copy, Debug)]
pub struct BareBox {
    /// The centre.
    pub centre: [Single; 3],
    /// Half of the sizes, including the margin for the test's rounding.
    pub half: [Single; 3],
}

/// A child of a node.
#[derive(Clone, Copy, Debug)]
pub struct Child<V> {
    /// Its bounding volume.
    pub volume: V,
    /// The address of its record.
    pub address: u32,
}

/// The volumes of nodes, and the kernels and twins that test them.
pub trait Volume: Copy + std::fmt::Debug {
    /// The record of a node.
    type Node: IntoBytes + Immutable;
    /// The kernel that tests nodes with packets' bounds.
    const CULL: &'static str;
    /// The kernel that tests children with packets' rays.
    const FILTER: &'static str;
    /// The record of a node with these children.
    fn node(children: &[Child<Self>; 4]) -> Self::Node;
    /// The twin of the first kernel.
    fn may_meet(&self, bound: &Bound) -> bool;
    /// The twin of the second kernel.
    fn any_may_meet(&self, bound: &Bound, rays: &[Ray; 16]) -> bool;
}

impl Volume for BareSphere {
    type Node = Node;
    const CULL: &'static str = "cull_nodes";
    const FILTER: &'static str = "filter_children_r16";

    fn node(children: &[Child<Self>; 4]) -> Node {
        let [x, y, z] = centres(children, |sphere| sphere.centre);
        Node {
            x,
            y,
            z,
            radius: children.map(|child| single(child.volume.radius)),
            child: children.map(|child| child.address.into()),
        }
    }

    fn may_meet(&self, bound: &Bound) -> bool {
        cull_nodes::may_meet(bound, self.centre, self.radius)
    }

    fn any_may_meet(&self, bound: &Bound, rays: &[Ray; 16]) -> bool {
        cull_nodes::any_may_meet(bound, rays, self.centre, self.radius)
    }
}

impl Volume for BareBox {
    type Node = BoxNode;
    const CULL: &'static str = "cull_box_nodes";
    const FILTER: &'static str = "filter_box_children_r16";

    fn node(children: &[Child<Self>; 4]) -> BoxNode {
        let [x, y, z] = centres(children, |bounds| bounds.centre);
        let [half_x, half_y, half_z] = centres(children, |bounds| bounds.half);
        BoxNode {
            x,
            y,
            z,
            half_x,
            half_y,
            half_z,
            child: children.map(|child| child.address.into()),
        }
    }

    fn may_meet(&self, bound: &Bound) -> bool {
        cull_box_nodes::may_meet(bound, self.centre, self.half)
    }

    fn any_may_meet(&self, bound: &Bound, rays: &[Ray; 16]) -> bool {
        cull_box_nodes::any_may_meet(bound, rays, self.centre, self.half)
    }
}

/// A vector of each of a node's children, by axes.
fn centres<V>(children: &[Child<V>; 4], of: impl Fn(&V) -> [Single; 3]) -> [[F32; 4]; 3] {
    let vectors = children.each_ref().map(|child| of(&child.volume));
    std::array::from_fn(|axis| vectors.map(|vector| single(vector[axis])))
}

/// The record of a packet.
#[must_use]
pub fn packet(rays: &[Ray; 16]) -> RayPacket {
    let mut record = RayPacket::new_zeroed();
    for (lane, ray) in rays.iter().enumerate() {
        [record.origin_x[lane], record.origin_y[lane], record.origin_z[lane]] =
            ray.origin.map(single);
        [record.direction_x[lane], record.direction_y[lane], record.direction_z[lane]] =
            ray.direction.map(single);
        record.t[lane] = single(ray.t);
        record.object[lane] = ray.object.into();
        record.weight[lane] = single(ray.weight);
        record.pixel[lane] = ray.pixel.into();
    }
    record
}

/// The rays of a record.
#[must_use]
pub fn rays(record: &RayPacket) -> [Ray; 16] {
    let vector = |axes: [[F32; 16]; 3], lane: usize| axes.map(|axis| bits(axis[lane]));
    std::array::from_fn(|lane| Ray {
        origin: vector([record.origin_x, record.origin_y, record.origin_z], lane),
        direction: vector([record.direction_x, record.direction_y, record.direction_z], lane),
        t: bits(record.t[lane]),
        object: record.object[lane].get(),
        weight: bits(record.weight[lane]),
        pixel: record.pixel[lane].get(),
    })
}

fn splat(value: Single) -> [F32; 4] {
    [single(value); 4]
}

/// The record of a bound. `anything` fills the fields without meaning.
#[must_use]
pub fn bound_record(bound: &Bound, anything: u32) -> layout::Bound {
    let [apex_x, apex_y, apex_z] = bound.apex.map(splat);
    let [axis_x, axis_y, axis_z] = bound.axis.map(splat);
    layout::Bound {
        apex_x,
        apex_y,
        apex_z,
        axis_x,
        axis_y,
        axis_z,
        cosine: splat(bound.cosine),
        sine: splat(bound.sine),
        radius: splat(bound.radius),
        farthest: splat(bound.farthest),
        apex: first_words(bound.apex, anything),
        axis: first_words(bound.axis, anything),
        limits: first_words([bound.sine, bound.radius, anything], anything),
    }
}

/// A quadword of three words and an arbitrary one.
fn first_words([x, y, z]: [Single; 3], anything: u32) -> [F32; 4] {
    [x, y, z, anything].map(single)
}

/// The bound in a record.
///
/// # Panics
///
/// Panics if its lanes differ, or the fields that it contains twice.
#[must_use]
pub fn bound(record: &layout::Bound) -> Bound {
    let one = |lanes: [F32; 4]| {
        let lanes = lanes.map(bits);
        assert_eq!(lanes, [lanes[0]; 4], "lanes of a bound");
        lanes[0]
    };
    let bound = Bound {
        apex: [record.apex_x, record.apex_y, record.apex_z].map(one),
        axis: [record.axis_x, record.axis_y, record.axis_z].map(one),
        cosine: one(record.cosine),
        sine: one(record.sine),
        radius: one(record.radius),
        farthest: one(record.farthest),
    };
    assert_eq!(record.apex.map(bits)[..3], bound.apex, "apex");
    assert_eq!(record.axis.map(bits)[..3], bound.axis, "axis");
    let limits = [bound.sine, bound.radius];
    assert_eq!(record.limits.map(bits)[..2], limits, "limits");
    bound
}

/// Puts the inputs of `primary_rays_r16` into local store: packets whose top left pixels are at
/// `corners`. The sum of each packet is a tile's row after that of the one before. Returns the
/// packets and the arguments.
pub fn put_primary_rays(
    bench: &mut Bench,
    view: &View,
    corners: &[[u32; 2]],
    pixels: u32,
) -> (Vec<Place>, Vec<u32>) {
    let basis = put(bench, &[eye_records::basis(&view.basis)]);
    let packets: Vec<Place> = corners.iter().map(|_| bench.junk::<RayPacket>()).collect();
    let places = put_places(bench, &packets, |number| {
        let [x, y] = corners[number];
        [sum_of(pixels, number), x, y]
    });
    let arguments = vec![
        places.address,
        corners.len() as u32,
        basis.address,
        view.background,
        view.width as u32,
        view.height as u32,
    ];
    (packets, arguments)
}

/// The address of the sum of a packet's top left pixel, as placed by [`put_primary_rays`].
#[must_use]
pub fn sum_of(pixels: u32, packet: usize) -> u32 {
    pixels.wrapping_add(packet as u32 * 1024)
}

/// Calls `primary_rays_r16`.
pub fn primary_rays(
    bench: &mut Bench,
    view: &View,
    corners: &[[u32; 2]],
    pixels: u32,
) -> Vec<[Ray; 16]> {
    bench.reset();
    let (packets, arguments) = put_primary_rays(bench, view, corners, pixels);
    bench.call("primary_rays_r16", &arguments);
    let packets = packets.iter().map(|packet| rays(&bench.read(*packet)));
    packets.collect()
}

/// Puts the inputs of `sample_rays_r16` into local store: four pixels for each packet, which have
/// `across` squared samples. Returns the address of the packets and the arguments.
pub fn put_sample_rays(
    bench: &mut Bench,
    basis: &Basis,
    background: u32,
    pixels: &[Pixel],
    across: u32,
) -> (Place, Vec<u32>) {
    let packets = vec![RayPacket::new_zeroed(); pixels.len() / 4];
    let packets = put(bench, &packets);
    let basis = put(bench, &[eye_records::basis(basis)]);
    let places = pixels.iter().map(|pixel| layout::Place {
        packet: ANYTHING.into(),
        pixels: pixel.sum.into(),
        x: (pixel.x as u32).into(),
        y: (pixel.y as u32).into(),
    });
    let places = put(bench, &places.collect::<Vec<_>>());
    let arguments = vec![
        places.address,
        pixels.len() as u32 / 4,
        basis.address,
        background,
        across * across,
        packets.address,
    ];
    (packets, arguments)
}

/// Calls `sample_rays_r16`.
pub fn sample_rays(
    bench: &mut Bench,
    basis: &Basis,
    background: u32,
    pixels: &[Pixel],
    across: u32,
) -> Vec<[Ray; 16]> {
    bench.reset();
    let (packets, arguments) = put_sample_rays(bench, basis, background, pixels, across);
    bench.call("sample_rays_r16", &arguments);
    let packets = bench.read_all::<RayPacket>(packets);
    packets.iter().map(rays).collect()
}

/// Puts the inputs of `load_rays_r16` into local store: `count` rays, and the rest of `queue`
/// after them. Returns the packets and the arguments.
pub fn put_queue(
    bench: &mut Bench,
    queue: &[Queued],
    count: u32,
    background: u32,
    dummy: u32,
) -> (Place, Vec<u32>) {
    let packets = queue.len() / 16;
    let queue: Vec<QueuedRay> = queue
        .iter()
        .map(|queued| QueuedRay {
            origin: queued.origin.map(single),
            weight: single(queued.weight),
            direction: queued.direction.map(single),
            pixel: queued.pixel.into(),
        })
        .collect();
    let queue = put(bench, &queue);
    let packets = put(bench, &vec![RayPacket::new_zeroed(); packets]);
    let arguments = vec![queue.address, count, packets.address, background, dummy];
    (packets, arguments)
}

/// Calls `load_rays_r16`.
pub fn load_rays(
    bench: &mut Bench,
    queue: &[Queued],
    count: u32,
    background: u32,
    dummy: u32,
) -> Vec<[Ray; 16]> {
    bench.reset();
    let (packets, arguments) = put_queue(bench, queue, count, background, dummy);
    bench.call("load_rays_r16", &arguments);
    bench.read_all(packets).iter().map(rays).collect()
}

/// A point where rays start or end.
#[derive(Clone, Copy, Debug)]
pub struct Point {
    /// The position.
    pub place: [Single; 3],
    /// The greatest distance of the rays' ends from it.
    pub near: Single,
    /// 1 if rays start there, -1 if they end there.
    pub along: Single,
}

/// Puts packets and bounds into local store. Returns the bounds' buffer and the arguments of
/// `bound_origins_r16`.
pub fn put_for_bounds(
    bench: &mut Bench,
    packets: &[[Ray; 16]],
    bounds: &[Bound],
) -> (Place, Vec<u32>) {
    let records: Vec<RayPacket> = packets.iter().map(packet).collect();
    let records = put(bench, &records);
    let bounds: Vec<layout::Bound> =
        bounds.iter().map(|bound| bound_record(bound, ANYTHING)).collect();
    let bounds = put(bench, &bounds);
    let arguments = vec![records.address, packets.len() as u32, bounds.address];
    (bounds, arguments)
}

/// Puts the inputs of `bound_fan_r16` into local store. Returns the bounds' buffer and the
/// arguments.
pub fn put_for_fans(bench: &mut Bench, packets: &[[Ray; 16]], point: &Point) -> (Place, Vec<u32>) {
    let records: Vec<RayPacket> = packets.iter().map(packet).collect();
    let records = put(bench, &records);
    let bounds = put(bench, &vec![layout::Bound::new_zeroed(); packets.len()]);
    let light = layout::Light {
        position: point.place.map(single),
        directional: ANYTHING.into(),
        brightness: [ANYTHING; 3].map(single),
        near: single(point.near),
    };
    let light = put(bench, &[light]);
    let arguments =
        vec![records.address, packets.len() as u32, bounds.address, light.address, point.along];
    (bounds, arguments)
}

/// Calls `bound_fan_r16`.
pub fn fans(bench: &mut Bench, packets: &[[Ray; 16]], point: &Point) -> Vec<Bound> {
    bench.reset();
    let (bounds, arguments) = put_for_fans(bench, packets, point);
    bench.call("bound_fan_r16", &arguments);
    bench.read_all(bounds).iter().map(bound).collect()
}

/// Calls `bound_fan_r16` with any point, and then `bound_origins_r16`.
pub fn bounds(bench: &mut Bench, packets: &[[Ray; 16]]) -> Vec<Bound> {
    let point = Point { place: [ANYTHING; 3], near: ANYTHING, along: ONE };
    let fans = fans(bench, packets, &point);
    bench.reset();
    let (bounds, arguments) = put_for_bounds(bench, packets, &fans);
    bench.call("bound_origins_r16", &arguments);
    bench.read_all(bounds).iter().map(bound).collect()
}

/// The inputs of `cull_nodes`, `cull_faces`, `filter_children_r16` and those for boxes.
pub struct Candidates {
    /// The arguments.
    pub arguments: Vec<u32>,
    /// The candidates.
    pub given: Vec<Candidate>,
    /// Where these are.
    pub list: Place,
    /// The buffer for the list.
    pub room: Place,
}

/// Puts the inputs of `cull_nodes` into local store, with children by their addresses, or with
/// packets those of `filter_children_r16`: all four children of each node. Each pair is a node and
/// a bound, which is that of the packet with the same number.
pub fn put_candidates<V: Volume>(
    bench: &mut Bench,
    nodes: &[[Child<V>; 4]],
    bounds: &[Bound],
    packets: Option<&[[Ray; 16]]>,
    pairs: &[[usize; 2]],
) -> Candidates {
    let nodes: Vec<V::Node> = nodes.iter().map(V::node).collect();
    let nodes = put(bench, &nodes);
    let bounds: Vec<layout::Bound> =
        bounds.iter().map(|bound| bound_record(bound, ANYTHING)).collect();
    let bounds = put(bench, &bounds);
    let packets = packets.map(|packets| {
        let packets: Vec<RayPacket> = packets.iter().map(packet).collect();
        put(bench, &packets)
    });
    let candidate = |(number, &[node, bound]): (usize, &[usize; 2])| Candidate {
        object: address::<V::Node>(nodes, node).into(),
        packet: packets
            .map_or(0x5000_0000 + number as u32, |packets| address::<RayPacket>(packets, bound))
            .into(),
        bound: address::<layout::Bound>(bounds, bound).into(),
        shear: (0x6000_0000 + number as u32).into(),
    };
    let mut given: Vec<Candidate> = pairs.iter().enumerate().map(candidate).collect();
    if packets.is_some() {
        let child = |candidate: Candidate, lane: u32| Candidate {
            object: (candidate.object.get() + 4 * lane).into(),
            ..candidate
        };
        let all = given.iter();
        given = all.flat_map(|&candidate| (0..4).map(move |lane| child(candidate, lane))).collect();
    }
    let list = put(bench, &given);
    let room = put(bench, &vec![Candidate::new_zeroed(); 4 * pairs.len() + 1]);
    Candidates {
        arguments: vec![list.address, given.len() as u32, room.address, 0],
        given,
        list,
        room,
    }
}

/// The words of candidates: object, packet, bound, shear.
#[must_use]
pub fn words(candidate: &Candidate) -> [u32; 4] {
    let &Candidate { object, packet, bound, shear } = candidate;
    [object, packet, bound, shear].map(zerocopy::big_endian::U32::get)
}

/// What `cull_nodes` puts in its list of a child.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Listed {
    /// Its address.
    Address = 0,
    /// The address of its node plus 4 times its lane.
    Lane = 4,
}

/// Calls `cull_nodes`, or `cull_box_nodes`. Returns its inputs, and the words of its list.
pub fn cull_nodes<V: Volume>(
    bench: &mut Bench,
    nodes: &[[Child<V>; 4]],
    bounds: &[Bound],
    pairs: &[[usize; 2]],
    what: Listed,
) -> (Vec<Candidate>, Vec<[u32; 4]>) {
    bench.reset();
    let mut candidates = put_candidates(bench, nodes, bounds, None, pairs);
    candidates.arguments[3] = what as u32;
    let list = listed(bench, V::CULL, &candidates.arguments, candidates.room);
    (candidates.given, list)
}

/// Calls `filter_children_r16` or `filter_box_children_r16` with packets, their bounds and all
/// children of nodes. Returns its inputs, and the words of its list.
///
/// # Panics
///
/// Panics if the list is another one when it goes to the candidates' own place.
pub fn filter_children_r16<V: Volume>(
    bench: &mut Bench,
    nodes: &[[Child<V>; 4]],
    bounds: &[Bound],
    packets: &[[Ray; 16]],
    pairs: &[[usize; 2]],
) -> (Vec<Candidate>, Vec<[u32; 4]>) {
    let kernel = V::FILTER;
    bench.reset();
    let apart = put_candidates(bench, nodes, bounds, Some(packets), pairs);
    let list = listed(bench, kernel, &apart.arguments, apart.room);
    bench.reset();
    let mut inside = put_candidates(bench, nodes, bounds, Some(packets), pairs);
    inside.arguments[2] = inside.list.address;
    let same = listed(bench, kernel, &inside.arguments, inside.list);
    assert_eq!(list, same, "in place");
    (apart.given, list)
}

/// The words of the list that a kernel makes in `room`.
fn listed(bench: &mut Bench, kernel: &str, arguments: &[u32], room: Place) -> Vec<[u32; 4]> {
    let end = bench.call(kernel, arguments).value;
    let mut list: Vec<Candidate> = bench.read_all(room);
    let ends = (0..=list.len()).find(|number| address::<Candidate>(room, *number) == end);
    list.truncate(ends.unwrap_or_else(|| panic!("no list ends at {end:#x}")));
    list.iter().map(words).collect()
}
