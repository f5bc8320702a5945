//! Traces: paths through SPU code, which the compiler translates to units.

use spu_isa::{Class, Instruction, LIMIT_MASK, Op, feature};

/// The most instructions that a trace may have.
pub const MAX_STEPS: usize = 160;

/// A loop is unrolled up to this number of instructions. Each iteration of a unit's loop costs
/// some tens of the host's instructions, which a short loop would pay for each iteration of its
/// own.
const MAX_UNROLLED: usize = 40;

/// The scales at which every nonzero 32-bit integer converts to a number that IEEE singles have
/// too.
const SCALES: std::ops::RangeInclusive<i32> = -90..=126;

/// One instruction of a trace.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Step {
    /// Its address.
    pub pc: u32,
    /// Its instruction word.
    pub word: u32,
    /// The decoded word.
    pub instruction: Instruction,
    /// The address of the instruction that ran after it.
    pub next: u32,
}

/// Consecutive words of code.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Range {
    pub start: u32,
    pub words: Vec<u32>,
}

impl Range {
    pub fn end(&self) -> u32 {
        self.start + 4 * self.words.len() as u32
    }
}

/// A path through SPU code: each step is at the address to which the step before it went.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Trace {
    steps: Vec<Step>,
    ranges: Vec<Range>,
}

impl Trace {
    /// Makes a trace of these steps. Returns `None` if there are no steps, or if they are not a
    /// connected path of compilable instructions.
    #[must_use]
    pub fn new(steps: Vec<Step>) -> Option<Self> {
        let connected = steps.windows(2).all(|pair| pair[0].next == pair[1].pc);
        let compilable = steps.iter().all(|step| can_compile(step.instruction));
        if steps.is_empty() || !connected || !compilable {
            return None;
        }
        let mut words: Vec<_> = steps.iter().map(|step| (step.pc, step.word)).collect();
        words.sort_unstable();
        words.dedup();
        let mut ranges: Vec<Range> = Vec::new();
        for (pc, word) in words {
            match ranges.last_mut() {
                Some(range) if range.end() == pc => range.words.push(word),
                // One address has two words, so the code changed while it was recorded.
                Some(range) if range.end() > pc => return None,
                _ => ranges.push(Range { start: pc, words: vec![word] }),
            }
        }
        Some(Self { steps, ranges })
    }

    /// Its instructions, in the order in which they run.
    #[must_use]
    pub fn steps(&self) -> &[Step] {
        &self.steps
    }

    /// The address of its first instruction.
    #[must_use]
    pub fn start(&self) -> u32 {
        self.steps[0].pc
    }

    /// Whether the trace returns to its start.
    pub(crate) fn is_loop(&self) -> bool {
        let last = self.steps.last();
        last.is_some_and(|last| code_address(last.next) == self.start())
    }

    /// The trace, or several iterations of it if it is a short loop.
    #[must_use]
    pub fn unrolled(mut self) -> Self {
        if self.is_loop() && self.steps.len() <= MAX_UNROLLED / 2 {
            self.steps = self.steps.repeat(MAX_UNROLLED / self.steps.len());
        }
        self
    }

    /// One iteration of the loop, if the trace is an [unrolled](Self::unrolled) one.
    #[must_use]
    pub fn rolled(&self) -> Option<Self> {
        let again = self.steps.iter().skip(1).position(|step| step.pc == self.start())?;
        Self::new(self.steps[..=again].to_vec())
    }

    /// The trace up to its first double-precision instruction. Returns `None` if it has none, or
    /// begins with it.
    #[must_use]
    pub fn before_double_precision(&self) -> Option<Self> {
        let is_double = |step: &Step| step.instruction.op.row().class == Class::Fpd;
        let count = self.steps.iter().position(is_double)?;
        Self::new(self.steps[..count].to_vec())
    }

    /// Its words in the order of their addresses.
    pub fn code(&self) -> impl Iterator<Item = u32> {
        self.ranges.iter().flat_map(|range| range.words.iter().copied())
    }

    pub(crate) fn ranges(&self) -> &[Range] {
        &self.ranges
    }

    /// Whether the code is still the trace's. `word` returns the word at an address.
    #[must_use]
    pub fn matches(&self, word: impl Fn(u32) -> u32) -> bool {
        self.ranges.iter().all(|range| {
            (range.start..).step_by(4).zip(&range.words).all(|(pc, &expected)| word(pc) == expected)
        })
    }
}

/// Whether the instruction can be compiled. The interpreter runs all others: instructions that
/// access more than registers and local store, rare ones, and the double-precision extension.
#[must_use]
pub fn can_compile(i: Instruction) -> bool {
    use Op::*;
    match i.op {
        Stop | Stopd | Sync | Dsync | Mfspr | Rdch | Rchcnt | Wrch | Bisled | Iret | Fscrrd
        | Fscrwr | Dfceq | Dfcmeq | Dfcgt | Dfcmgt | Dftsv => false,
        Bi | Bisl | Biz | Binz | Bihz | Bihnz => {
            i.immediate & (feature::DISABLE | feature::ENABLE) == 0
        }
        Csflt | Cuflt => SCALES.contains(&i.immediate),
        _ => true,
    }
}

/// The address of the instruction after the one at `pc`.
pub(crate) const fn following(pc: u32) -> u32 {
    code_address(pc.wrapping_add(4))
}

/// The address from which the SPU fetches an instruction, for a branch to `address`.
pub(crate) const fn code_address(address: u32) -> u32 {
    address & LIMIT_MASK & !3
}

/// The immediate in both halfwords of a word.
pub(crate) const fn halfwords(i: Instruction) -> u32 {
    i.immediate as u16 as u32 * 0x0001_0001
}

/// The immediate in all four bytes of a word.
pub(crate) const fn bytes(i: Instruction) -> u32 {
    i.immediate as u8 as u32 * 0x0101_0101
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A loop of this many instructions at address 0, or the same code without the branch back.
    fn trace(count: u32, is_loop: bool) -> Trace {
        let instruction = Instruction::decode(0x4020_0000).expect("lnop");
        let step = |pc| Step {
            pc,
            word: 0x4020_0000,
            instruction,
            next: if is_loop && pc / 4 + 1 == count { 0 } else { pc + 4 },
        };
        Trace::new((0..count).map(|n| step(4 * n)).collect()).expect("a path")
    }

    #[test]
    fn short_loops_are_unrolled() {
        for count in 1..=MAX_STEPS as u32 {
            let one = trace(count, true);
            let several = one.clone().unrolled();
            assert_eq!(several.ranges(), one.ranges());
            assert!(several.is_loop());
            if count <= 20 {
                assert!((21..=40).contains(&several.steps().len()), "{count}");
                assert_eq!(several.rolled(), Some(one));
            } else {
                assert_eq!(several, one);
                assert_eq!(several.rolled(), None);
            }
        }
    }

    #[test]
    fn other_traces_are_not_unrolled() {
        let trace = trace(8, false);
        assert_eq!(trace.clone().unrolled(), trace);
        assert_eq!(trace.rolled(), None);
    }
}
