//! The records of these kernels, made of the inputs of their twins.

use twins::bound::Bound;
use twins::primary_rays::Ray;

use crate::prelude::*;
use protocol::layout::Candidate;

/// Fills the fields without meaning.
pub const ANYTHING: u32 = 0x7fff_ffff;

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

/// Puts packets into local store, one after the other.
pub fn put_packets(bench: &mut Bench, packets: &[[Ray; 16]]) -> Place {
    let records: Vec<RayPacket> = packets.iter().map(rows).collect();
    put(bench, &records)
}

/// Puts bounds into local store.
pub fn put_bounds(bench: &mut Bench, bounds: &[Bound]) -> Place {
    let records: Vec<layout::Bound> =
        bounds.iter().map(|bound| bound_record(bound, ANYTHING)).collect();
    put(bench, &records)
}

/// The bounds in a buffer.
#[must_use]
pub fn bounds(bench: &Bench, place: Place) -> Vec<Bound> {
    bench.read_all(place).iter().map(bound).collect()
}

/// The rays in a buffer of packets.
#[must_use]
pub fn packets(bench: &Bench, place: Place) -> Vec<[Ray; 16]> {
    bench.read_all::<RayPacket>(place).iter().map(lanes).collect()
}

/// The words of candidates: object, packet, bound, shear.
#[must_use]
pub fn words(candidate: &Candidate) -> [u32; 4] {
    let &Candidate { object, packet, bound, shear } = candidate;
    [object, packet, bound, shear].map(zerocopy::big_endian::U32::get)
}

/// The words of the list that begins in `buffer` and ends at the address that a kernel returned.
///
/// # Panics
///
/// Panics if the address is not a possible end of such a list.
#[must_use]
pub fn listed(bench: &Bench, buffer: Place, end: u32) -> Vec<[u32; 4]> {
    bench.read_list(buffer, end).iter().map(words).collect()
}
