//! An assembled source: the program that runs, and the object that the analyser reads.

use spu_assembler::{Errors, Linked, Program, Section};

use crate::Problem;

/// The source's name in schedules and messages.
pub const FILE: &str = "playground.s";

/// An assembled source.
pub struct Assembled {
    /// As an object with a line table.
    pub object: Vec<u8>,
    /// Local store at the start, from address 0.
    pub image: Vec<u8>,
    pub entry: u32,
    /// Addresses of instructions and their source lines.
    pub lines: Vec<(u32, u32)>,
}

impl Assembled {
    pub fn new(source: &str) -> Result<Self, Vec<Problem>> {
        let program = spu_assembler::assemble(FILE, source).map_err(problems)?;
        let linked = program.link(0).map_err(problems)?;
        Ok(Self {
            object: program.elf(),
            lines: lines(&program, &linked),
            entry: linked.entry,
            image: linked.bytes,
        })
    }
}

fn problems(errors: Errors) -> Vec<Problem> {
    let problem = |error: spu_assembler::Diagnostic| Problem {
        line: error.position.line,
        column: error.position.column,
        message: error.message,
    };
    errors.errors.into_iter().map(problem).collect()
}

/// The source line of each place in the code.
fn lines(program: &Program, linked: &Linked) -> Vec<(u32, u32)> {
    let is_code = |section: &&Section| section.executable && section.size() > 0;
    let placed = program.sections.iter().filter(is_code).zip(&linked.code);
    let lines = placed.flat_map(|(section, (address, _))| {
        section.places.iter().map(move |(offset, place)| (address + offset, place.line))
    });
    lines.collect()
}
