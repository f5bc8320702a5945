//! Loads and stores of a loop that may move across the increments of their address.
//!
//! A register that each pass advances by a constant, by `ai`, holds the same address as before plus
//! a known number of steps wherever a load or store with a displacement reads it. Such an access
//! need not run between two certain increments: another displacement makes up for those that come
//! too early or too late. So the address needs no copy, however many passes overlap. Invariant: in
//! every place where the access is put, register and displacement together make the address of the
//! plain code, and the displacement can be encoded.

use super::dependence::Freedom;
use super::function::Node;
use super::memory::{Root, trace};
use super::values::{Source, Values};
use spu_isa::{Field, Op};

/// The displacements that `lqd` and `stqd` can encode, which are multiples of 16.
const LEAST: i64 = -8192;
const MOST: i64 = 8176;
const UNIT: i64 = 16;

/// An access that may move across increments of its address.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Movable {
    /// The register that one pass hands to the next.
    pub register: u8,
    /// The only node that writes this register.
    pub increment: usize,
    /// The bytes by which the register moves in a pass.
    step: i64,
    /// The displacement from what the register holds when the pass starts.
    displacement: i64,
    /// How many steps the register may be ahead of that value, so that the displacement can be
    /// encoded. 0 or 1 is always among them.
    pub ahead: (i64, i64),
}

impl Movable {
    /// For each node of a loop's body: whether and how it may move.
    pub fn of_loop(nodes: &[Node], freedom: Freedom) -> Vec<Option<Self>> {
        let values = Values::of(nodes);
        let movable = |at| freedom.moves.then(|| Self::at(nodes, &values, at)).flatten();
        (0..nodes.len()).map(movable).collect()
    }

    fn at(nodes: &[Node], values: &Values, at: usize) -> Option<Self> {
        let node = &nodes[at];
        if !matches!(node.i.op, Op::Lqd | Op::Stqd) || node.reference.is_some() {
            return None;
        }
        let (root, offset) = trace(nodes, values, values.operand(at, Field::Ra)?);
        let Root::Entry(register) = root else {
            return None;
        };
        let increment = values.last[usize::from(register)]?;
        let (carried, step) = trace(nodes, values, Source::Node(increment));
        let displacement = offset + i64::from(node.i.immediate);
        if carried != root || step == 0 || step % UNIT != 0 || displacement % UNIT != 0 {
            return None;
        }
        let one = (displacement - MOST, displacement - LEAST);
        let ahead = if step > 0 {
            (ceiling(one.0, step), one.1.div_euclid(step))
        } else {
            (ceiling(-one.1, -step), (-one.0).div_euclid(-step))
        };
        // The first passes have no increments before them, and the last ones none after them, so
        // that fewer steps than in the others must be possible, too.
        (ahead.0 <= 1 && ahead.1 >= 0 && ahead.0 <= ahead.1).then_some(Self {
            register,
            increment,
            step,
            displacement,
            ahead,
        })
    }

    /// The displacement where the register is `ahead` steps ahead.
    fn displacement(&self, ahead: i64) -> i32 {
        (self.displacement - ahead * self.step) as i32
    }
}

fn ceiling(dividend: i64, divisor: i64) -> i64 {
    -(-dividend).div_euclid(divisor)
}

/// An access in a schedule of overlapping passes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Moved {
    access: Movable,
    /// How many steps the register is ahead in the kernel.
    ahead: i64,
}

impl Moved {
    /// The access in the kernel, with `ahead` increments of this pass and later ones before it. If
    /// negative, that number of earlier passes' increments comes after it.
    pub fn new(access: Movable, ahead: i64) -> Self {
        Self { access, ahead }
    }

    /// Whether a displacement is that of the plain access but for whole steps of the register.
    pub fn allows(&self, displacement: i32) -> bool {
        let Movable { step, displacement: plain, .. } = self.access;
        let displacement = i64::from(displacement);
        (LEAST..=MOST).contains(&displacement) && (plain - displacement) % step == 0
    }

    pub fn in_kernel(&self) -> i32 {
        self.access.displacement(self.ahead)
    }

    /// Its displacement in the fill, in the pass with this number, before which no more increments
    /// than passes have run.
    pub fn in_fill(&self, pass: i64) -> i32 {
        self.access.displacement(self.ahead.max(-pass))
    }

    /// Its displacement in the drain, in a pass that `following` passes follow.
    pub fn in_drain(&self, following: i64) -> i32 {
        self.access.displacement(self.ahead.min(following + 1))
    }
}

#[cfg(test)]
mod tests {
    use super::super::layout::plain;
    use super::*;

    /// `lqd $5,displacement($4)`, after or before `ai $4,$4,step`.
    fn load(displacement: i32, step: i32, after: bool) -> Option<Movable> {
        let load = Node::added(plain(Op::Lqd, 5, 4, displacement), None, "");
        let advance = Node::added(plain(Op::Ai, 4, 4, step), None, "");
        let nodes = if after { [advance, load] } else { [load, advance] };
        let moves = Freedom { moves: true, ..Freedom::NONE };
        Movable::of_loop(&nodes, moves)[usize::from(after)]
    }

    #[test]
    fn an_access_moves_as_far_as_its_displacement_can_follow() {
        for displacement in [-8192, -8176, -48, 0, 16, 8160, 8176] {
            for step in [-512, -48, -16, 16, 32, 496] {
                for after in [false, true] {
                    let movable = load(displacement, step, after).unwrap();
                    let plain = i64::from(displacement) + i64::from(after) * i64::from(step);
                    let fits = |ahead: &i64| {
                        let needed = plain - ahead * i64::from(step);
                        (-8192..=8176).contains(&needed)
                    };
                    let fitting: Vec<i64> = (-2000..=2000).filter(fits).collect();
                    let all: Vec<i64> = (movable.ahead.0..=movable.ahead.1).collect();
                    assert_eq!(all, fitting, "{displacement}, {step}, {after}");
                    for ahead in all {
                        let moved = movable.displacement(ahead);
                        assert_eq!(i64::from(moved), plain - ahead * i64::from(step));
                    }
                }
            }
        }
    }

    #[test]
    fn the_first_and_last_passes_have_fewer_increments_around_them() {
        let access = load(32, 16, false).unwrap();
        let late = Moved::new(access, 3);
        assert_eq!(late.in_kernel(), 32 - 48);
        assert_eq!([0, 1, 9].map(|pass| late.in_fill(pass)), [32 - 48; 3]);
        // The last pass has only its own increment before the access, the one before it two.
        assert_eq!([0, 1, 2, 3].map(|more| late.in_drain(more)), [16, 0, -16, -16]);
        let early = Moved::new(access, -2);
        assert_eq!(early.in_kernel(), 64);
        assert_eq!([0, 1, 2, 3].map(|pass| early.in_fill(pass)), [32, 48, 64, 64]);
        assert_eq!([0, 1].map(|more| early.in_drain(more)), [64; 2]);
    }

    #[test]
    fn other_addresses_do_not_move() {
        assert_eq!(load(0, 20, false), None);
        assert_eq!(load(0, 0, false), None);
        let store = Node::added(plain(Op::Stqd, 5, 4, 0), None, "");
        let reload = Node::added(plain(Op::Lqd, 4, 4, 16), None, "");
        let moves = Freedom { moves: true, ..Freedom::NONE };
        assert_eq!(Movable::of_loop(&[store, reload], moves), [None, None]);
    }
}
