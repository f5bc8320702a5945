//! The kernel that culls faces.

use twins::bound::{Bound, bound};
use twins::cull_faces::{Face, may_meet};
use twins::pairs::Sides;

use super::bounds::Point;
use super::call::{ANYTHING, listed, put_bounds, words};
use super::fans::{self, FANS};
use super::nodes::Candidates;
use crate::cases::whitted::isect::shape;
use crate::prelude::*;
use protocol::layout::{Candidate, Object};

/// How much an object's numbers add to `leave`, as a share of the magnitudes of its centre's
/// components.
const LEAVE: f64 = 1.0 / (1 << 22) as f64;

/// The word of the first candidate's packet. The others count from it.
const FIRST: u32 = 0x5000_0000;

/// The record of a face. `anything` fills the fields without meaning.
#[must_use]
pub fn record(face: &Face, anything: u32) -> Object {
    let sides = Sides { both: face.both, exit: anything & 1 != 0 };
    Object {
        leave: single(face.leave),
        ..shape::head(face.point, face.normal, anything, sides, anything)
    }
}

/// A face of any direction at a point.
pub fn face(point: Vector, random: &mut ChaCha8Rng) -> Face {
    let leave: f64 = point.iter().map(|component| component.abs()).sum();
    Face {
        point: point.map(from_f64),
        normal: any_direction(random).map(from_f64),
        leave: from_f64(leave * LEAVE * (1.0 + 1e-6)),
        both: random.random(),
    }
}

/// Faces and bounds, and pairs of both by their numbers. The list overwrites the candidates.
#[derive(Clone, Debug)]
pub struct CullFaces {
    /// The faces.
    pub faces: Vec<Face>,
    /// The bounds.
    pub bounds: Vec<Bound>,
    /// A face and a bound.
    pub pairs: Vec<[usize; 2]>,
    /// 1 if the rays go along their bounds' axes, -1 if they go against them.
    pub along: Single,
}

impl CullFaces {
    /// The number of the pair of which a word of the list is left.
    #[must_use]
    pub fn number(words: &[u32; 4]) -> usize {
        (words[1] - FIRST) as usize
    }
}

impl Description for CullFaces {
    const KERNEL: &'static str = "cull_faces";
    const ROUNDS: [usize; 2] = [50, 500];
    const LENGTHS: &'static [usize] = LENGTHS_FROM_0;
    const SHARES: [Range<f64>; 2] = [0.1..0.9, 0.03..1.0];
    type Placed = Candidates;
    type Found = Vec<[u32; 4]>;

    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        let bounds = (0..4)
            .map(|_| bound(&fans::packet(FANS[random.random_range(0..FANS.len())], 1.0, random)));
        let bounds = bounds.collect();
        Self {
            faces: (0..8).map(|_| face(in_cube(20.0, random), random)).collect(),
            bounds,
            pairs: (0..count).map(|_| [8, 4].map(|end| random.random_range(0..end))).collect(),
            along: Point::any(random).along,
        }
    }

    fn any(count: usize, random: &mut ChaCha8Rng) -> Self {
        let faces = (0..8).map(|_| Face {
            point: random.random(),
            normal: random.random(),
            leave: random.random(),
            both: random.random(),
        });
        let faces = faces.collect();
        let bounds = (0..4).map(|_| any_bits(random)).collect();
        Self { faces, bounds, along: random.random(), ..Self::sensible(count, random) }
    }

    fn place(&self, bench: &mut Bench) -> (Candidates, Vec<u32>) {
        let anything = ANYTHING ^ self.pairs.len() as u32;
        let faces: Vec<Object> = self.faces.iter().map(|face| record(face, anything)).collect();
        let faces = put(bench, &faces);
        let bounds = put_bounds(bench, &self.bounds);
        let candidate = |(number, &[face, bound]): (u32, &[usize; 2])| Candidate {
            object: address::<Object>(faces, face).into(),
            packet: (FIRST + number).into(),
            bound: address::<layout::Bound>(bounds, bound).into(),
            shear: (0x6000_0000 + number).into(),
        };
        let given: Vec<Candidate> = (0..).zip(&self.pairs).map(candidate).collect();
        let mut list = given.clone();
        list.push(Candidate::new_zeroed());
        let buffer = put(bench, &list);
        let arguments = vec![buffer.address, given.len() as u32, buffer.address, self.along];
        (Candidates { given, buffer }, arguments)
    }

    /// The list, and the words after the candidates, which must stay 0.
    fn found(&self, bench: &Bench, placed: &Candidates, end: u32) -> Vec<[u32; 4]> {
        let after = bench.read_all::<Candidate>(placed.buffer).last().map(words);
        assert_eq!(after, Some([0; 4]), "after the candidates");
        listed(bench, placed.buffer, end)
    }

    fn twin(&self, placed: &Candidates) -> Vec<[u32; 4]> {
        let candidates = placed.given.iter().zip(&self.pairs);
        let kept = candidates.filter(|(_, [face, bound])| {
            may_meet(&self.bounds[*bound], &self.faces[*face], self.along)
        });
        kept.map(|(candidate, _)| words(candidate)).collect()
    }

    fn part(&self, found: &Vec<[u32; 4]>) -> [usize; 2] {
        [found.len(), self.pairs.len()]
    }
}
