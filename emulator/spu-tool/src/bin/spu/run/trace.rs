//! The trace: one line for each instruction with its address, symbol, text, and the register that
//! it wrote.

use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use spu_emulator::elf::Image;
use spu_emulator::interp::Spu;
use spu_isa::Instruction;

use crate::failure::Failure;
use spu_debugger::console::instruction_text;

/// Columns of the instruction's text and of the register.
const PLACE: usize = 28;
const TEXT: usize = 28;

pub struct Trace<'a> {
    image: &'a Image<'a>,
    path: PathBuf,
    output: BufWriter<Box<dyn Write + Send>>,
    /// The last instruction. Its result can be seen once it has run.
    line: Option<(String, Instruction)>,
    result: io::Result<()>,
}

impl<'a> Trace<'a> {
    /// Opens a file, or else standard error.
    pub fn open(path: Option<&Path>, image: &'a Image<'a>) -> Result<Self, Failure> {
        let output: Box<dyn Write + Send> = match path {
            Some(path) => Box::new(File::create(path).map_err(Failure::file(path))?),
            None => Box::new(io::stderr()),
        };
        Ok(Self {
            image,
            path: path.unwrap_or(Path::new("standard error")).to_path_buf(),
            output: BufWriter::new(output),
            line: None,
            result: Ok(()),
        })
    }

    fn write(&mut self, line: &str) {
        if self.result.is_ok() {
            self.result = writeln!(self.output, "{}", line.trim_end());
        }
    }

    pub fn begin_line(&mut self, spu: &Spu, instruction: Instruction) {
        let pc = spu.pc();
        let text = instruction_text(instruction.encode(), pc);
        let place = self.image.place(pc);
        self.line = Some((format!("{place:PLACE$} {text:TEXT$}"), instruction));
    }

    pub fn finish_line(&mut self, spu: &Spu) {
        let Some((mut line, instruction)) = self.line.take() else {
            return;
        };
        for register in instruction.writes().iter() {
            let [a, b, c, d] = spu.register(register).0;
            line += &format!(" ${register} = {a:08x} {b:08x} {c:08x} {d:08x}");
        }
        self.write(&line);
    }

    pub fn called(&mut self, function: &str) {
        self.write(&format!("# library call: {function}"));
    }

    pub fn finish(mut self) -> Result<(), Failure> {
        let flushed = self.result.and_then(|()| self.output.flush());
        messages::unless_closed(flushed).map_err(Failure::file(&self.path))
    }
}
