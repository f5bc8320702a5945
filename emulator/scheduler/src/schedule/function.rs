//! A function as blocks of instructions, and the registers that are live between them.
//!
//! Blocks are in the order of the code. A block without a branch at its end continues in the next
//! one. Register numbers from 128 on are virtual: the step that creates them also removes them.

use std::collections::BTreeMap;

use super::displacement::Moved;

use super::Kind;
use spu_isa::{Class, Field, Instruction, Op, Pipe, Target};

/// Identifies a block independently of its position.
pub(super) type BlockId = usize;

/// A set of the registers 0 to 127, one bit each.
pub(super) type Registers = u128;

/// The registers that a leaf function may use without saving them.
pub(super) const POOL: std::ops::RangeInclusive<u8> = 2..=79;

const LINK: u8 = 0;
/// The link register, the stack pointer and the registers that a callee saves.
const KEPT: Registers = !0 << 80 | 0b11;

/// An address that an operand refers to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Reference {
    /// The start of a block.
    Block(BlockId),
    /// An address that the linker fills in.
    Symbol(Symbol),
    /// In a hint: the branch that ends a block, and the block that it goes to. There is no target
    /// if it goes to a register.
    Hint {
        branch: BlockId,
        target: Option<BlockId>,
        /// Whether the hint comes after the rest of its block's code, so that the branch is in
        /// reach.
        late: bool,
    },
}

/// An address that the linker fills in.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Symbol {
    /// The name, the offset in bytes from it, and the part of the address that is meant.
    pub name: String,
    pub addend: i64,
    pub part: &'static str,
    /// The section, or the symbol if it is in another file.
    pub place: String,
    /// Offset in bytes from the start of `place`.
    pub offset: i64,
}

impl Symbol {
    /// The address in assembly notation.
    pub fn text(&self) -> String {
        let Self { name, addend, part, .. } = self;
        match addend {
            0 => format!("{name}{part}"),
            1.. => format!("{name}+{addend}{part}"),
            _ => format!("{name}{addend}{part}"),
        }
    }
}

/// An instruction of the function.
#[derive(Clone, Debug)]
pub(super) struct Node {
    /// The instruction with the schedule's registers.
    pub i: Instruction,
    /// The instruction with the source's registers.
    pub plain: Instruction,
    pub reference: Option<Reference>,
    /// In a hint of the source: the block that begins with the hinted branch.
    pub hinted: Option<BlockId>,
    /// The line of the source, or 0 if the scheduler added the instruction.
    pub line: u64,
    /// Its address in the plain object, or `None` if the scheduler added it.
    pub origin: Option<u32>,
    /// A store that is marked as one that may overlap any other access.
    pub may_alias: bool,
    /// The branch of a loop that is marked as one whose kernel may contain only one pass.
    pub one_pass: bool,
    /// The branch of a loop: the minimum number of passes, which the source states.
    pub min_passes: u32,
    /// A memory access that stays in order with all other accesses. The passes of a loop may
    /// access the same memory in ways that can't be seen from registers any more.
    pub in_order: bool,
    /// In a pipelined loop: how many passes earlier than the current one it started.
    pub stage: u32,
    /// In a pipelined loop: how its displacement depends on the increments before it, if it does.
    pub moved: Option<Moved>,
    /// Why the scheduler added it.
    pub reason: &'static str,
}

impl Node {
    /// An instruction that the scheduler adds.
    pub fn added(i: Instruction, reference: Option<Reference>, reason: &'static str) -> Self {
        Self {
            i,
            plain: i,
            reference,
            hinted: None,
            line: 0,
            origin: None,
            may_alias: false,
            one_pass: false,
            min_passes: 1,
            in_order: false,
            stage: 0,
            moved: None,
            reason,
        }
    }

    pub fn class(&self) -> Class {
        self.i.op.row().class
    }

    pub fn pipe(&self) -> Pipe {
        self.class().pipe()
    }

    /// The fields and registers that the instruction reads.
    pub fn reads(&self) -> impl Iterator<Item = (Field, u8)> + use<'_> {
        let fields = self.i.op.row().reads.iter();
        fields.map(|&field| (field, self.i.register(field)))
    }

    /// The register that the instruction writes.
    pub fn writes(&self) -> Option<u8> {
        (self.i.op.row().target == Target::Rt).then_some(self.i.rt)
    }

    pub fn is_load(&self) -> bool {
        self.class() == Class::Ls && self.writes().is_some()
    }

    pub fn is_store(&self) -> bool {
        self.class() == Class::Ls && self.writes().is_none()
    }

    /// Whether no instruction may move past this one: channels, synchronisation, floating-point
    /// status.
    pub fn is_barrier(&self) -> bool {
        self.class() == Class::Spr
            || matches!(self.i.op, Op::Sync | Op::Dsync | Op::Fscrrd | Op::Fscrwr)
    }

    /// Whether it is the last of its block: a branch, stop or halt.
    pub fn ends_block(&self) -> bool {
        let halts = self.class() == Class::Fx2 && self.i.op.row().target == Target::False;
        halts || self.class() == Class::Br && !self.is_barrier()
    }

    pub fn is_return(&self) -> bool {
        self.i.op == Op::Bi && self.i.ra == LINK
    }

    /// Sets the register of an operand field or of the target.
    pub fn set_register(&mut self, field: Field, register: u8) {
        *self.i.register_mut(field) = register;
    }
}

/// Where execution continues after a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Flow {
    pub branch: Option<BlockId>,
    pub falls_through: bool,
    pub leaves: Leaves,
}

/// Whether code may leave the function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Leaves {
    No,
    Return,
    /// To code that may read any register.
    Anywhere,
}

/// Instructions that always run from the first to the last.
#[derive(Clone, Debug)]
pub(super) struct Block {
    pub id: BlockId,
    /// The label.
    pub name: Option<String>,
    pub nodes: Vec<Node>,
    /// The cycle of each node, if the block is already scheduled.
    pub cycles: Option<Vec<u64>>,
}

impl Block {
    pub fn flow(&self) -> Flow {
        let straight = Flow { branch: None, falls_through: true, leaves: Leaves::No };
        let Some(last) = self.nodes.last().filter(|node| node.ends_block()) else {
            return straight;
        };
        let branch = match last.reference {
            Some(Reference::Block(id)) => Some(id),
            _ => None,
        };
        let outside = match branch {
            Some(_) => Leaves::No,
            None => Leaves::Anywhere,
        };
        let indirect = if last.i.ra == LINK { Leaves::Return } else { Leaves::Anywhere };
        let (falls_through, leaves) = match last.i.op {
            Op::Br | Op::Bra => (false, outside),
            Op::Brz | Op::Brnz | Op::Brhz | Op::Brhnz => (true, outside),
            Op::Bi => (false, indirect),
            Op::Biz | Op::Binz | Op::Bihz | Op::Bihnz => (true, indirect),
            Op::Iret => (false, Leaves::Anywhere),
            _ => (true, Leaves::Anywhere),
        };
        Flow { branch, falls_through, leaves }
    }
}

/// A function.
#[derive(Clone, Debug)]
pub(super) struct Function {
    pub name: String,
    pub kind: Kind,
    pub blocks: Vec<Block>,
    /// Registers whose values the caller reads.
    pub results: Registers,
    /// How often each instruction of the plain code occurs in the schedule, by its address there.
    /// An instruction without an entry occurs once.
    pub copies: BTreeMap<u32, usize>,
}

/// The registers that are live at the start and the end of each block, by position.
pub(super) struct Liveness {
    pub start: Vec<Registers>,
    pub end: Vec<Registers>,
}

pub(super) const fn bit(register: u8) -> Registers {
    1 << (register & 127)
}

impl Function {
    pub fn position(&self, id: BlockId) -> usize {
        let found = self.blocks.iter().position(|block| block.id == id);
        found.expect("references refer to blocks of the function")
    }

    /// A new id for a block.
    pub fn new_id(&self) -> BlockId {
        self.blocks.iter().map(|block| block.id + 1).max().unwrap_or(0)
    }

    /// How many branches go to a block.
    pub fn branches_to(&self, id: BlockId) -> usize {
        let flows = self.blocks.iter().map(Block::flow);
        flows.filter(|flow| flow.branch == Some(id)).count()
    }

    pub fn liveness(&self) -> Liveness {
        let count = self.blocks.len();
        let mut start: Vec<Registers> = vec![0; count];
        let mut end: Vec<Registers> = vec![0; count];
        loop {
            let mut changed = false;
            for at in (0..count).rev() {
                let flow = self.blocks[at].flow();
                let mut live = match flow.leaves {
                    Leaves::No => 0,
                    Leaves::Return => KEPT | self.results,
                    Leaves::Anywhere => !0,
                };
                if let Some(id) = flow.branch {
                    live |= start[self.position(id)];
                }
                if flow.falls_through {
                    // Nothing is known about the code after the last block.
                    live |= start.get(at + 1).copied().unwrap_or(!0);
                }
                let before = live_before(&self.blocks[at].nodes, live);
                changed |= before != start[at] || live != end[at];
                (start[at], end[at]) = (before, live);
            }
            if !changed {
                return Liveness { start, end };
            }
        }
    }

    /// Records that an instruction occurs `times` times more in the schedule than before.
    pub fn copied(&mut self, node: &Node, times: usize) {
        if let Some(origin) = node.origin {
            *self.copies.entry(origin).or_insert(1) += times;
        }
    }

    /// Joins blocks that always follow each other.
    pub fn fuse(&mut self) {
        let mut at = 0;
        while at + 1 < self.blocks.len() {
            let (this, next) = (&self.blocks[at], &self.blocks[at + 1]);
            let ends = this.nodes.last().is_some_and(Node::ends_block);
            let scheduled = this.cycles.is_some() || next.cycles.is_some();
            let named = self.branches_to(next.id) > 0 || next.name.is_some();
            if ends || scheduled || named {
                at += 1;
                continue;
            }
            let next = self.blocks.remove(at + 1);
            self.blocks[at].nodes.extend(next.nodes);
        }
    }
}

/// The registers that are live before `nodes` if `live` are live after them.
pub(super) fn live_before(nodes: &[Node], live: Registers) -> Registers {
    nodes.iter().rev().fold(live, |live, node| {
        let written = node.writes().map_or(0, bit);
        let read = node.reads().fold(0, |set, (_, register)| set | bit(register));
        live & !written | read
    })
}
