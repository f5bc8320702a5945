//! Tallies by address, kept while the program runs.

use super::tally::Tally;
use crate::local_store::SIZE;
use crate::timer::Recorder;
use spu_isa::timing::{Issue, Pipeline, Stalls};
use spu_isa::{Class, Instruction};

const WORDS: usize = SIZE as usize / 4;

/// A tally. The code at an address may change, so the key is the address and the instruction.
#[derive(Clone, Debug)]
pub(crate) struct Entry {
    pub pc: u32,
    pub instruction: Instruction,
    pub tally: Tally,
}

/// The profile of one program. Invariant: no two entries have the same address and the same
/// instruction.
#[derive(Clone, Debug)]
pub(crate) struct Profile {
    entries: Vec<Entry>,
    /// For each address, the index plus 1 of the entry that was used last. 0 if there is none.
    latest: Box<[u32]>,
}

impl Default for Profile {
    fn default() -> Self {
        Self { entries: Vec::new(), latest: vec![0; WORDS].into_boxed_slice() }
    }
}

impl Profile {
    pub fn entries(&self) -> &[Entry] {
        &self.entries
    }

    #[inline]
    fn tally(&mut self, pc: u32, instruction: Instruction) -> &mut Tally {
        let word = pc as usize / 4 % WORDS;
        let at = self.latest[word] as usize;
        let at = match self.entries.get(at.wrapping_sub(1)) {
            Some(entry) if entry.instruction == instruction => at,
            _ => self.change(word, pc, instruction),
        };
        &mut self.entries[at - 1].tally
    }

    #[cold]
    fn change(&mut self, word: usize, pc: u32, instruction: Instruction) -> usize {
        let known = if self.latest[word] == 0 {
            None
        } else {
            let same = |entry: &Entry| entry.pc == pc && entry.instruction == instruction;
            self.entries.iter().position(same)
        };
        let at = known.unwrap_or_else(|| {
            self.entries.push(Entry { pc, instruction, tally: Tally::default() });
            self.entries.len() - 1
        });
        self.latest[word] = at as u32 + 1;
        at + 1
    }

    /// Adds the contents of `other`, and empties it.
    pub fn take(&mut self, other: &mut Self) {
        for Entry { pc, instruction, tally } in other.entries.drain(..) {
            other.latest[pc as usize / 4 % WORDS] = 0;
            self.tally(pc, instruction).add(&tally);
        }
    }
}

/// Charges cycles as they pass.
#[derive(Debug, Default)]
pub(crate) struct Recording {
    profile: Profile,
    /// The instruction to charge until the next one issues. `None` after a stop.
    last: Option<(u32, Instruction)>,
    /// Cycles charged so far, and those of them in which nothing issued.
    charged: u64,
    stalls: Stalls,
}

impl Recording {
    /// Charges the stalls up to the pipelines' clock to the instruction that issued last.
    pub fn charge_last(&mut self, pipeline: &Pipeline) {
        if pipeline.clock() != self.charged
            && let Some((pc, instruction)) = self.last
        {
            self.charge(pc, instruction, pipeline);
        }
    }

    #[inline]
    fn charge(&mut self, pc: u32, instruction: Instruction, pipeline: &Pipeline) {
        let stalls = pipeline.account().stalls();
        let passed = stalls.since(&self.stalls);
        self.profile.tally(pc, instruction).stalls.extend(&passed);
        self.stalls = stalls.clone();
        self.charged = pipeline.clock();
    }

    /// The charges since the last hand-over.
    pub fn profile(&self) -> &Profile {
        &self.profile
    }

    /// The tally of the instruction at `pc`, for charges that were computed elsewhere.
    pub fn tally(&mut self, pc: u32, instruction: Instruction) -> &mut Tally {
        self.profile.tally(pc, instruction)
    }

    /// Records that everything up to the pipelines' clock is charged, and that `last` issued last.
    pub fn catch_up(&mut self, last: (u32, Instruction), pipeline: &Pipeline) {
        self.last = Some(last);
        self.charged = pipeline.clock();
        self.stalls = pipeline.account().stalls().clone();
    }

    /// Hands over all charges since the last hand-over.
    pub fn hand_over(&mut self, to: &mut Profile) {
        to.take(&mut self.profile);
    }

    /// The program has stopped. The restart will not be charged to the stop. A channel instruction
    /// may still continue to sleep.
    pub fn stopped(&mut self) {
        self.last = self.last.filter(|(_, i)| i.op.row().class != Class::Br);
    }
}

impl Recorder for Recording {
    #[inline]
    fn issued(&mut self, pc: u32, instruction: Instruction, issue: &Issue, pipeline: &Pipeline) {
        self.last = Some((pc, instruction));
        let tally = self.profile.tally(pc, instruction);
        tally.issued += 1;
        tally.joined += u64::from(issue.dual);
        self.charged += u64::from(!issue.dual);
        if pipeline.clock() != self.charged {
            self.charge(pc, instruction, pipeline);
        }
    }

    #[inline]
    fn branched(&mut self, pipeline: &Pipeline) {
        self.charge_last(pipeline);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn instruction(word: u32) -> Instruction {
        Instruction::decode(word).unwrap()
    }

    /// How often each entry issued, in the order of creation.
    fn issued(profile: &Profile) -> Vec<(u32, u32, u64)> {
        let entries = profile.entries.iter();
        entries.map(|entry| (entry.pc, entry.instruction.encode(), entry.tally.issued)).collect()
    }

    const NOP: u32 = 0x4020_0000;
    const LNOP: u32 = 0x0020_0000;

    #[test]
    fn overwritten_code_keeps_its_own_tallies() {
        let (nop, lnop) = (instruction(NOP), instruction(LNOP));
        let mut profile = Profile::default();
        for (pc, instruction) in [(8, nop), (8, lnop), (8, nop), (0x3_fffc, nop), (8, nop)] {
            profile.tally(pc, instruction).issued += 1;
        }
        let expected = [(8, NOP, 3), (8, LNOP, 1), (0x3_fffc, NOP, 1)];
        assert_eq!(issued(&profile), expected);
    }

    #[test]
    fn profile_is_cleared_by_a_hand_over_and_adds_up() {
        let (nop, lnop) = (instruction(NOP), instruction(LNOP));
        let (mut all, mut part) = (Profile::default(), Profile::default());
        for _ in 0..3 {
            part.tally(0, nop).issued += 1;
            part.tally(0, lnop).issued += 2;
            all.take(&mut part);
            assert!(part.entries().is_empty());
        }
        assert_eq!(issued(&all), [(0, NOP, 3), (0, LNOP, 6)]);
    }

    /// All cycles are charged exactly once, whatever the pipelines do.
    #[test]
    fn a_stop_leaves_its_restart_to_what_comes_next() {
        let stop = instruction(0);
        let mut pipeline = Pipeline::default();
        let mut recording = Recording::default();
        let issue = |recording: &mut Recording, pipeline: &mut Pipeline, pc, instruction| {
            let issue = pipeline.issue(pc, instruction);
            recording.issued(pc, instruction, &issue, pipeline);
        };
        issue(&mut recording, &mut pipeline, 0, stop);
        recording.stopped();
        pipeline.branched(0, Some(64));
        recording.branched(&pipeline);
        issue(&mut recording, &mut pipeline, 64, instruction(NOP));
        let mut profile = Profile::default();
        recording.hand_over(&mut profile);
        let cycles = profile.entries.iter().map(|entry| entry.tally.cycles());
        assert_eq!(cycles.collect::<Vec<_>>(), [1, 19]);
        assert_eq!(pipeline.clock(), 20);
    }
}
