//! The PPE's side of the mailboxes, which files provide.
//!
//! Words are exchanged before each channel instruction, on the SPU's own thread. The program
//! therefore finds the same words at the same instructions in every run.

use std::collections::VecDeque;
use std::fs::{self, File};
use std::io::{self, BufWriter, Write as _};
use std::path::{Path, PathBuf};
use std::time::Instant;

use spu_emulator::mailbox::INBOUND_DEPTH;
use spu_emulator::spe::Spe;
use spu_isa::{Instruction, Op};

use super::options::{Options, number};
use crate::failure::Failure;

const OUT_MBOX: u8 = 28;
const IN_MBOX: u8 = 29;
const OUT_INTR_MBOX: u8 = 30;

/// A file of outbound words, and the first error in writing it.
struct Output {
    path: PathBuf,
    file: BufWriter<File>,
    result: io::Result<()>,
}

impl Output {
    fn open(path: &Path) -> Result<Self, Failure> {
        let file = File::create(path).map_err(Failure::file(path))?;
        Ok(Self { path: path.to_path_buf(), file: BufWriter::new(file), result: Ok(()) })
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
    /// Why the program can't go on.
    stuck: Option<&'static str>,
    /// In simulated time, the PPE's calls happen at simulated times for which the SPU's own thread
    /// can't wait. No words are then exchanged, and the options exclude each other.
    closed: bool,
    /// A debugger can interrupt a program that waits for ever.
    debugged: bool,
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
            stuck: None,
            closed: options.is_simulated(),
            debugged: options.gdb.is_some(),
        })
    }

    /// Fills the inbound mailbox and empties the outbound ones that have a file.
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
        if let Some(output) = &mut self.outbound {
            while let Some(word) = spe.read_outbound(at_once) {
                output.put(word);
            }
        }
        if let Some(output) = &mut self.interrupt {
            while let Some(word) = spe.read_outbound_interrupt(at_once) {
                output.put(word);
            }
        }
    }

    /// Exchanges words. Ends the run if the instruction would wait for ever.
    pub fn before_channel(&mut self, spe: &Spe, instruction: Instruction) {
        self.exchange(spe);
        if self.closed {
            return;
        }
        self.stuck = match (instruction.op, instruction.ra) {
            (Op::Rdch, IN_MBOX) if spe.inbound_free() == INBOUND_DEPTH => Some(
                "it waits for the inbound mailbox, and there are no more words for it (--in-mbox)",
            ),
            (Op::Wrch, OUT_MBOX) if spe.outbound_waiting() > 0 => Some(
                "it waits because the outbound mailbox is full, and no one reads it (--out-mbox)",
            ),
            (Op::Wrch, OUT_INTR_MBOX) if spe.outbound_interrupt_waiting() > 0 => Some(
                "it waits because the outbound interrupt mailbox is full, and no one reads it \
                 (--out-intr-mbox)",
            ),
            _ => None,
        };
        if self.stuck.is_some() && !self.debugged {
            spe.request_stop();
        }
    }

    /// Why the run ended, if it would have waited for a mailbox for ever.
    pub fn stuck(&self) -> Option<&'static str> {
        self.stuck
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
            let place = format!("{}: line {}", path.display(), index + 1);
            words.push_back(value.map_err(Failure::of(place))?);
        }
    }
    Ok(words)
}
