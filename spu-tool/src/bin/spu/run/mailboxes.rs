//! The PPE's side of the mailboxes, which files provide.
//!
//! Words are exchanged before each channel instruction, on the SPU's own thread. The program
//! therefore finds the same words at the same instructions in every run.

use std::collections::VecDeque;
use std::fs::{self, File};
use std::io::{self, BufWriter, Write as _};
use std::path::{Path, PathBuf};
use std::time::Instant;

use spu_emulator::spe::Spe;
use spu_isa::{Instruction, Op};

use super::options::{Options, number};
use crate::failure::Failure;

const IN_MBOX: u8 = 29;

/// A file of outbound words, and the first error in writing it.
struct Output {
    path: PathBuf,
    file: BufWriter<File>,
    result: io::Result<()>,
}

impl Output {
    fn open(path: &Path) -> Result<Self, Failure> {
        let file = File::create(path).map_err(Failure::file(path))?;
        Ok(Self {
            path: path.to_path_buf(),
            file: BufWriter::new(file),
            result: Ok(()),
        })
    }

    fn put(&mut self, word: u32) {
        if self.result.is_ok() {
            self.result = writeln!(self.file, "{word:#010x}");
        }
    }

    fn finish(mut self) -> Result<(), Failure> {
        let result = self.result.and_then(|()| self.file.flush());
        result.map_err(Failure::file(&self.path))
    }
}

pub struct Mailboxes {
    inbound: VecDeque<u32>,
    outbound: Option<Output>,
    interrupt: Option<Output>,
    starved: bool,
    /// In simulated time, the PPE's calls happen at simulated times for which the SPU's own thread
    /// can't wait. No words are then exchanged, and the options exclude each other.
    closed: bool,
}

impl Mailboxes {
    pub fn open(options: &Options) -> Result<Self, Failure> {
        let output = |path: &Option<PathBuf>| path.as_deref().map(Output::open).transpose();
        Ok(Self {
            inbound: match &options.in_mbox {
                Some(path) => words(path)?,
                None => VecDeque::new(),
            },
            outbound: output(&options.out_mbox)?,
            interrupt: output(&options.out_intr_mbox)?,
            starved: false,
            closed: options.timing.is_some(),
        })
    }

    /// Fills the inbound mailbox and empties the outbound ones. Outbound words without a file are
    /// dropped.
    pub fn exchange(&mut self, spe: &Spe) {
        if self.closed {
            return;
        }
        let at_once = Some(Instant::now());
        while let Some(&word) = self.inbound.front()
            && spe.write_inbound(word, at_once)
        {
            self.inbound.pop_front();
        }
        while let Some(word) = spe.read_outbound(at_once) {
            if let Some(output) = &mut self.outbound {
                output.put(word);
            }
        }
        while let Some(word) = spe.read_outbound_interrupt(at_once) {
            if let Some(output) = &mut self.interrupt {
                output.put(word);
            }
        }
    }

    /// Exchanges words. Ends the run if the instruction is a read that would wait for ever.
    pub fn before_channel(&mut self, spe: &Spe, instruction: Instruction) {
        self.exchange(spe);
        let waits = instruction.op == Op::Rdch && instruction.ra == IN_MBOX;
        if !self.closed && waits && spe.inbound_room() == spu_emulator::mailbox::INBOUND_DEPTH {
            self.starved = true;
            spe.request_stop();
        }
    }

    /// Whether the run ended because it ran out of inbound words.
    pub fn starved(&self) -> bool {
        self.starved
    }

    pub fn finish(self) -> Result<(), Failure> {
        for output in [self.outbound, self.interrupt].into_iter().flatten() {
            output.finish()?;
        }
        Ok(())
    }
}

fn words(path: &Path) -> Result<VecDeque<u32>, Failure> {
    let text = fs::read_to_string(path).map_err(Failure::file(path))?;
    let mut words = VecDeque::new();
    for (index, line) in text.lines().enumerate() {
        let line = line.split('#').next().unwrap_or_default();
        for word in line.split_whitespace() {
            let value = number(word).and_then(|value| {
                u32::try_from(value).map_err(|_| format!("`{word}` does not fit in 32 bits"))
            });
            words.push_back(value.map_err(|what| Failure::Contents {
                path: path.to_path_buf(),
                what: format!("line {}: {what}", index + 1),
            })?);
        }
    }
    Ok(words)
}
