//! The SPU's registers as the remote protocol transfers them.

use gdbstub::arch::{Arch, Registers};
use spu_emulator::interp::Quad;

const GENERAL: usize = 128;
const QUADWORD: usize = 16;

/// The SPU for gdb. Its registers have the numbers and sizes of gdb's own port to the SPU: `r0` to
/// `r127`, the context's id, and the program counter.
#[derive(Debug)]
pub enum Spu {}

impl Arch for Spu {
    type Usize = u32;
    type Registers = SpuRegisters;
    type BreakpointKind = usize;
    type RegId = ();

    fn target_description_xml() -> Option<&'static str> {
        Some(include_str!("spu.xml"))
    }
}

/// All registers.
#[derive(Clone, Debug, PartialEq)]
pub struct SpuRegisters {
    pub general: [Quad; GENERAL],
    pub pc: u32,
}

impl Default for SpuRegisters {
    fn default() -> Self {
        Self { general: [Quad::ZERO; GENERAL], pc: 0 }
    }
}

impl Registers for SpuRegisters {
    type ProgramCounter = u32;

    fn pc(&self) -> u32 {
        self.pc
    }

    fn gdb_serialize(&self, mut write_byte: impl FnMut(Option<u8>)) {
        const ID: u32 = 0;
        let words = self.general.iter().flat_map(|quad| quad.0);
        for byte in words.chain([ID, self.pc]).flat_map(u32::to_be_bytes) {
            write_byte(Some(byte));
        }
    }

    fn gdb_deserialize(&mut self, bytes: &[u8]) -> Result<(), ()> {
        let (quads, rest) = bytes.split_at_checked(GENERAL * QUADWORD).ok_or(())?;
        for (quad, bytes) in self.general.iter_mut().zip(quads.as_chunks().0) {
            *quad = Quad::from_bytes(*bytes);
        }
        let pc = rest.get(4..8).ok_or(())?.first_chunk().ok_or(())?;
        self.pc = u32::from_be_bytes(*pc);
        Ok(())
    }
}
