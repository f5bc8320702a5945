//! The local-store bytes that an instruction reads: with a load, or with a DMA command out of local
//! store.
//!
//! A load reads a whole quadword, whatever the program wants of it. The parameters of DMA commands
//! are known from the channel instructions that came before.

use spu_emulator::interp::Spu;
use spu_emulator::local_store::{LocalStore, SIZE};
use spu_isa::{Instruction, Op};

const QUADWORD: u32 = 16;
/// Bytes that an atomic command moves.
const LINE: u32 = 128;

const LSA: u8 = 16;
const EAL: u8 = 18;
const TRANSFER_SIZE: u8 = 19;
const COMMAND: u8 = 21;

/// Bytes of local store.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Range {
    pub start: u32,
    pub length: u32,
}

impl Range {
    /// Whether both have a byte in common. Addresses wrap at the end of local store.
    pub fn meets(self, other: Self) -> bool {
        let distance = |from: u32, to: u32| to.wrapping_sub(from) & (SIZE - 1);
        distance(self.start, other.start) < self.length
            || distance(other.start, self.start) < other.length
    }
}

/// The parameters of the next DMA command.
#[derive(Clone, Copy, Debug, Default)]
pub struct Parameters {
    lsa: u32,
    eal: u32,
    size: u32,
}

/// The local-store accesses of the next instruction.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Accesses {
    pub read: Option<Range>,
    pub stored: Option<Range>,
}

impl Parameters {
    /// Returns what the instruction at the program counter will access, and remembers the
    /// parameters that it sets.
    pub fn before(&mut self, spu: &Spu, store: &LocalStore) -> Accesses {
        let Some(instruction) = Instruction::decode(store.load_word(spu.pc())) else {
            return Accesses::default();
        };
        if instruction.op == Op::Wrch {
            let value = spu.register(instruction.rt).preferred();
            let read = self.write(instruction.ra, value, store);
            return Accesses { read, stored: None };
        }
        let Some(access) = spu.access(instruction) else {
            return Accesses::default();
        };
        let quadword = Some(Range { start: access.address, length: QUADWORD });
        if access.is_store {
            Accesses { read: None, stored: quadword }
        } else {
            Accesses { read: quadword, stored: None }
        }
    }

    /// A value is written to a channel. Returns what a command reads.
    fn write(&mut self, channel: u8, value: u32, store: &LocalStore) -> Option<Range> {
        match channel {
            LSA => self.lsa = value,
            EAL => self.eal = value,
            TRANSFER_SIZE => self.size = value,
            COMMAND => return self.read_by(value as u8, store),
            _ => {}
        }
        None
    }

    fn read_by(&self, opcode: u8, store: &LocalStore) -> Option<Range> {
        const PUTS: std::ops::RangeInclusive<u8> = 0x20..=0x2f;
        const LIST: u8 = 4;
        const PUTLLUC: u8 = 0xb0;
        const PUTLLC: u8 = 0xb4;
        const PUTQLLUC: u8 = 0xb8;
        let (start, length) = match opcode {
            PUTLLUC | PUTLLC | PUTQLLUC => (self.lsa & !(LINE - 1), LINE),
            opcode if !PUTS.contains(&opcode) => return None,
            opcode if opcode & LIST != 0 => (self.lsa, self.listed(store)),
            _ => (self.lsa, self.size),
        };
        Some(Range { start, length })
    }

    /// The bytes that the elements of a list move. Each element's data begins at a quadword.
    fn listed(&self, store: &LocalStore) -> u32 {
        const ELEMENT: u32 = 8;
        const SIZE_MASK: u32 = 0x7fff;
        let elements = self.size.min(SIZE / QUADWORD) / ELEMENT;
        let size = |n| store.load_word(self.eal.wrapping_add(n * ELEMENT)) & SIZE_MASK;
        let sizes = (0..elements).map(|n| size(n).next_multiple_of(QUADWORD));
        sizes.sum::<u32>().min(SIZE)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use spu_emulator::interp::Quad;

    fn range(start: u32, length: u32) -> Range {
        Range { start, length }
    }

    #[test]
    fn ranges_meet_across_the_end_of_local_store() {
        assert!(range(0x100, 16).meets(range(0x10f, 1)));
        assert!(!range(0x100, 16).meets(range(0x110, 4)));
        assert!(range(0x10f, 1).meets(range(0x100, 16)));
        assert!(range(SIZE - 8, 16).meets(range(4, 1)));
        assert!(!range(SIZE - 8, 16).meets(range(8, 1)));
        assert!(!range(0x100, 0).meets(range(0x200, 16)));
    }

    /// Writes these values to channels, and returns what the last of them reads.
    fn written(store: &LocalStore, values: &[(u8, u32)]) -> Option<Range> {
        let mut parameters = Parameters::default();
        let mut spu = Spu::new();
        let mut read = None;
        for &(channel, value) in values {
            // wrch $channel,$3
            let word = 0x21a0_0003 | u32::from(channel) << 7;
            store.write(0, &word.to_be_bytes());
            spu.set_register(3, Quad::scalar(value));
            read = parameters.before(&spu, store).read;
        }
        read
    }

    #[test]
    fn commands_out_of_local_store_read_it() {
        let store = LocalStore::new();
        let put = [(LSA, 0x1000), (TRANSFER_SIZE, 32), (COMMAND, 0x20)];
        assert_eq!(written(&store, &put), Some(range(0x1000, 32)));
        let get = [(LSA, 0x1000), (TRANSFER_SIZE, 32), (COMMAND, 0x40)];
        assert_eq!(written(&store, &get), None);
        let atomic = [(LSA, 0x1090), (COMMAND, 0xb4)];
        assert_eq!(written(&store, &atomic), Some(range(0x1080, 128)));
        // A list of 16 and 4 bytes.
        store.write(0x2000, &[0, 0, 0, 16, 0, 0, 0, 0, 0, 0, 0, 4, 0, 0, 0, 0]);
        let list = [(LSA, 0x1000), (EAL, 0x2000), (TRANSFER_SIZE, 16), (COMMAND, 0x24)];
        assert_eq!(written(&store, &list), Some(range(0x1000, 32)));
    }

    #[test]
    fn loads_and_stores_take_whole_quadwords() {
        let store = LocalStore::new();
        let mut spu = Spu::new();
        spu.set_register(4, Quad::scalar(0x1008));
        let mut parameters = Parameters::default();
        // lqd $3,16($4)
        store.write(0, &0x3400_4203_u32.to_be_bytes());
        let loaded = parameters.before(&spu, &store);
        assert_eq!(loaded.read, Some(range(0x1010, 16)));
        assert_eq!(loaded.stored, None);
        // stqa $3,0x80
        store.write(0, &0x2080_1003_u32.to_be_bytes());
        let stored = parameters.before(&spu, &store);
        assert_eq!((stored.read, stored.stored), (None, Some(range(0x80, 16))));
    }
}
