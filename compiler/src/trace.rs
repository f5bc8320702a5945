//! Paths through SPU code, from which units are made.

use spu_isa::{Instruction, LIMIT_MASK, Op, feature};

/// The most instructions of a trace.
pub const MOST_STEPS: usize = 160;

/// Scales at which every 32-bit integer other than 0 converts to a number that IEEE has too.
const SCALES: std::ops::RangeInclusive<i32> = -90..=126;

/// One instruction of a trace.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Step {
    /// Where it stands.
    pub pc: u32,
    /// Its word.
    pub word: u32,
    /// What the word means.
    pub instruction: Instruction,
    /// Where the SPU went after it.
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

/// A path through SPU code: each step stands where the step before went.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Trace {
    steps: Vec<Step>,
    ranges: Vec<Range>,
}

impl Trace {
    /// A trace of these steps; `None` without any, or if they are no path of compilable
    /// instructions.
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
                // One address with two words: the code changed meanwhile.
                Some(range) if range.end() > pc => return None,
                _ => ranges.push(Range {
                    start: pc,
                    words: vec![word],
                }),
            }
        }
        Some(Self { steps, ranges })
    }

    /// Its instructions, in the order in which they run.
    #[must_use]
    pub fn steps(&self) -> &[Step] {
        &self.steps
    }

    /// Where it starts.
    #[must_use]
    pub fn start(&self) -> u32 {
        self.steps[0].pc
    }

    pub(crate) fn ranges(&self) -> &[Range] {
        &self.ranges
    }

    /// Whether `word`, which gives the word at an address, finds the code of the trace.
    #[must_use]
    pub fn stands_in(&self, word: impl Fn(u32) -> u32) -> bool {
        self.ranges.iter().all(|range| {
            (range.start..)
                .step_by(4)
                .zip(&range.words)
                .all(|(pc, &expected)| word(pc) == expected)
        })
    }
}

/// Whether a unit can have the instruction. The others are the interpreter's: what reaches beyond
/// registers and local store, what is rare, and double precision.
#[must_use]
pub fn can_compile(i: Instruction) -> bool {
    use Op::*;
    match i.op {
        Stop | Stopd | Sync | Dsync | Mfspr | Rdch | Rchcnt | Wrch | Bisled | Iret | Dfa | Dfs
        | Dfm | Dfma | Dfms | Dfnms | Dfnma | Fesd | Frds | Fscrrd | Fscrwr | Dfceq | Dfcmeq
        | Dfcgt | Dfcmgt | Dftsv => false,
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

/// An address as the SPU fetches from it.
pub(crate) const fn code_address(address: u32) -> u32 {
    address & LIMIT_MASK & !3
}
