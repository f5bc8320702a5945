//! Counts what a program did.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::PathBuf;

use serde::Serialize;
use spu_emulator::interp::Spu;
use spu_emulator::local_store::LocalStore;
use spu_isa::LIMIT_MASK;
use spu_isa::{Class, Instruction, Op};

use super::output::{json, write_text};
use crate::failure::Failure;

const LIST_ELEMENT: u32 = 8;
/// The bits in a list element's first word that hold its size.
const ELEMENT_SIZE: u32 = 0x7fff;
const LINE: u64 = 128;

/// MFC commands of one kind.
#[derive(Clone, Copy, Debug, Default, Serialize)]
struct Commands {
    commands: u64,
    bytes: u64,
}

/// The parameters of the next MFC command, as the program wrote them.
#[derive(Clone, Copy, Debug, Default)]
struct Parameters {
    list: u32,
    size: u32,
}

#[derive(Debug, Default, Serialize)]
struct Branches {
    run: u64,
    taken: u64,
}

/// The counts, in the order in which they are written.
#[derive(Debug, Default, Serialize)]
struct Counts {
    instructions: u64,
    classes: BTreeMap<String, u64>,
    mnemonics: BTreeMap<&'static str, u64>,
    loads: u64,
    stores: u64,
    branches: Branches,
    dma: BTreeMap<&'static str, Commands>,
    library_calls: BTreeMap<String, u64>,
}

pub struct Statistics {
    path: Option<PathBuf>,
    json: bool,
    by_op: Vec<u64>,
    counts: Counts,
    parameters: Parameters,
    /// The last branch and its address. Its target is known only at the next instruction.
    branch: Option<u32>,
}

impl Statistics {
    /// The counts are written at the end to a file or to standard error.
    pub fn new(path: Option<PathBuf>, json: bool) -> Self {
        Self {
            path,
            json,
            by_op: vec![0; Op::rows().len()],
            counts: Counts::default(),
            parameters: Parameters::default(),
            branch: None,
        }
    }

    pub fn count(&mut self, spu: &Spu, instruction: Instruction, store: &LocalStore) {
        self.settle_branch(spu.pc());
        self.by_op[instruction.op as usize] += 1;
        match instruction.op {
            Op::Wrch => {
                let value = spu.register(instruction.rt).preferred();
                self.channel_write(instruction.ra, value, store);
            }
            op if is_branch(op) => self.branch = Some(spu.pc()),
            _ => {}
        }
    }

    fn settle_branch(&mut self, pc: u32) {
        if let Some(from) = self.branch.take() {
            self.counts.branches.run += 1;
            let taken = pc != from.wrapping_add(4) & LIMIT_MASK;
            self.counts.branches.taken += u64::from(taken);
        }
    }

    pub fn stopped(&mut self, spu: &Spu) {
        self.settle_branch(spu.pc());
    }

    pub fn called(&mut self, function: &str) {
        let count = self.counts.library_calls.entry(function.to_owned());
        *count.or_default() += 1;
    }

    fn channel_write(&mut self, channel: u8, value: u32, store: &LocalStore) {
        const LIST_ADDRESS: u8 = 18;
        const SIZE: u8 = 19;
        const COMMAND: u8 = 21;
        match channel {
            LIST_ADDRESS => self.parameters.list = value,
            SIZE => self.parameters.size = value,
            COMMAND => self.command(value as u8, store),
            _ => {}
        }
    }

    fn command(&mut self, opcode: u8, store: &LocalStore) {
        let Parameters { list, size } = self.parameters;
        let (kind, bytes) = match opcode {
            0x20..=0x22 | 0x30..=0x32 => ("put", size.into()),
            0x24..=0x26 | 0x34..=0x36 => ("put list", list_bytes(list, size, store)),
            0x40..=0x42 => ("get", size.into()),
            0x44..=0x46 => ("get list", list_bytes(list, size, store)),
            0xb0 | 0xb4 | 0xb8 | 0xd0 => ("atomic", LINE),
            0xa0..=0xa2 => ("signal", 4),
            _ => ("other", 0),
        };
        let commands = self.counts.dma.entry(kind).or_default();
        commands.commands += 1;
        commands.bytes += bytes;
    }

    /// Writes the counts. `executed` is the SPU's own count of completed instructions.
    pub fn write(mut self, executed: u64) -> Result<(), Failure> {
        self.summarise(executed);
        let text = if self.json { json(&self.counts) } else { self.table() };
        write_text(self.path.as_deref(), &text)
    }

    fn summarise(&mut self, executed: u64) {
        self.counts.instructions = executed;
        for (row, &count) in Op::rows().iter().zip(&self.by_op) {
            if count == 0 {
                continue;
            }
            self.counts.mnemonics.insert(row.mnemonic, count);
            let class = format!("{:?}", row.class).to_uppercase();
            *self.counts.classes.entry(class).or_default() += count;
            if row.class == Class::Ls {
                let stores = row.mnemonic.starts_with("st");
                *(if stores { &mut self.counts.stores } else { &mut self.counts.loads }) += count;
            }
        }
    }

    fn table(&self) -> String {
        let counts = &self.counts;
        let mut text = String::new();
        let mut line = |name: &str, value: String| {
            let _ = writeln!(text, "{name:16}{value:>14}");
        };
        line("instructions", counts.instructions.to_string());
        line("loads", counts.loads.to_string());
        line("stores", counts.stores.to_string());
        line("branches", counts.branches.run.to_string());
        line("  taken", counts.branches.taken.to_string());
        for (kind, commands) in &counts.dma {
            line(&format!("DMA {kind}"), commands.commands.to_string());
            line("  bytes", commands.bytes.to_string());
        }
        for (function, count) in &counts.library_calls {
            line(&format!("call {function}"), count.to_string());
        }
        let mut by_count: Vec<_> = counts.classes.iter().collect();
        by_count.sort_by_key(|(_, count)| std::cmp::Reverse(**count));
        for (class, count) in by_count {
            line(&format!("class {class}"), count.to_string());
        }
        let mut by_count: Vec<_> = counts.mnemonics.iter().collect();
        by_count.sort_by_key(|(_, count)| std::cmp::Reverse(**count));
        for (mnemonic, count) in by_count {
            line(mnemonic, count.to_string());
        }
        text
    }
}

/// Whether the instruction may continue at another address than the next one.
fn is_branch(op: Op) -> bool {
    let row = op.row();
    row.class == Class::Br && !matches!(op, Op::Stop | Op::Stopd | Op::Sync | Op::Dsync)
}

/// The number of bytes that a list asks for at the time when the command is issued.
fn list_bytes(list: u32, size: u32, store: &LocalStore) -> u64 {
    (0..size.min(0x4000) / LIST_ELEMENT)
        .map(|n| store.load_word(list.wrapping_add(n * LIST_ELEMENT)) & ELEMENT_SIZE)
        .map(u64::from)
        .sum()
}
