//! Calls `cull_faces` with the inputs of its twin.

use twins::bound::Bound;
use twins::cull_faces::Face;
use twins::pairs::Sides;
use zerocopy::FromZeros as _;

use super::call::{Candidates, bound_record, words};
use crate::bench::Bench;
use crate::cases::eye::call::{address, put as put_records};
use crate::cases::whitted::isect::shape;
use crate::single::single;
use protocol::layout::{self, Candidate, Object};

/// The record of a face. `anything` fills the fields without meaning.
#[must_use]
pub fn record(face: &Face, anything: u32) -> Object {
    let sides = Sides { both: face.both, exit: anything & 1 != 0 };
    Object {
        leave: single(face.leave),
        ..shape::head(face.point, face.normal, anything, sides, anything)
    }
}

/// Puts the inputs of `cull_faces` into local store. Each pair is a face and a bound, given by
/// number. The list overwrites the candidates.
pub fn put(
    bench: &mut Bench,
    faces: &[Face],
    bounds: &[Bound],
    pairs: &[[usize; 2]],
    along: u32,
) -> Candidates {
    let anything = 0x5555_5555 ^ pairs.len() as u32;
    let faces: Vec<Object> = faces.iter().map(|face| record(face, anything)).collect();
    let faces = put_records(bench, &faces);
    let bounds: Vec<layout::Bound> =
        bounds.iter().map(|bound| bound_record(bound, anything)).collect();
    let bounds = put_records(bench, &bounds);
    let candidate = |(number, &[face, bound]): (usize, &[usize; 2])| Candidate {
        object: address::<Object>(faces, face).into(),
        packet: (0x5000_0000 + number as u32).into(),
        bound: address::<layout::Bound>(bounds, bound).into(),
        shear: (0x6000_0000 + number as u32).into(),
    };
    let given: Vec<Candidate> = pairs.iter().enumerate().map(candidate).collect();
    let mut list = given.clone();
    list.push(Candidate::new_zeroed());
    let room = put_records(bench, &list);
    Candidates {
        arguments: vec![room.address, pairs.len() as u32, room.address, along],
        given,
        list: room,
        room,
    }
}

/// Calls `cull_faces`. Returns the words of its inputs, and of its list.
///
/// # Panics
///
/// Panics if the returned end is not a possible end of a list, or if memory after the candidates
/// has changed.
pub fn cull_faces(
    bench: &mut Bench,
    faces: &[Face],
    bounds: &[Bound],
    pairs: &[[usize; 2]],
    along: u32,
) -> (Vec<[u32; 4]>, Vec<[u32; 4]>) {
    bench.reset();
    let candidates = put(bench, faces, bounds, pairs, along);
    let end = bench.call("cull_faces", &candidates.arguments).value;
    let mut list: Vec<Candidate> = bench.read_all(candidates.room);
    let behind = list.pop().map(|candidate| words(&candidate));
    assert_eq!(behind, Some([0; 4]), "behind the candidates");
    let ends = (0..=pairs.len()).find(|n| address::<Candidate>(candidates.room, *n) == end);
    list.truncate(ends.unwrap_or_else(|| panic!("no list ends at {end:#x}")));
    (candidates.given.iter().map(words).collect(), list.iter().map(words).collect())
}
