//! Loads, stores, and the controls for inserting into a quadword with `shufb`.

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::{InstBuilder, MemFlagsData, Value, types};
use spu_isa::{Instruction, LIMIT_MASK};

use super::commit::Pending;
use super::registers::Id;
use super::{Emitter, field};
use crate::cpu::{WATCH_LOADS, WATCH_STORES};
use crate::tables::TABLES;

/// The most stores held back with which a load is compared. With more, a commit costs less.
const MAX_COMPARED: usize = 4;

const QUADWORD_MASK: u32 = LIMIT_MASK & !15;

/// The value of an address, as far as it is constant when code is emitted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Key {
    Constant(u32),
    /// The sum of a value's preferred word and a constant.
    Based(Id, u32),
    Unknown,
}

/// The address of a quadword in local store.
#[derive(Clone, Copy)]
pub(super) struct Address {
    pub key: Key,
    /// The address in local store.
    pub masked: Value,
    /// The address on the host is this pointer plus `offset`.
    pub pointer: Value,
    pub offset: i32,
}

enum Overlap {
    Same,
    None,
    Perhaps,
}

impl Key {
    fn overlap(self, other: Self) -> Overlap {
        match (self, other) {
            (Self::Constant(a), Self::Constant(b)) if a == b => Overlap::Same,
            (Self::Constant(_), Self::Constant(_)) => Overlap::None,
            (Self::Based(a, n), Self::Based(b, m)) if a == b => {
                let distance = n.wrapping_sub(m) & LIMIT_MASK;
                match distance {
                    0 => Overlap::Same,
                    16..=0x3_fff0 => Overlap::None,
                    _ => Overlap::Perhaps,
                }
            }
            _ => Overlap::Perhaps,
        }
    }

    fn plus(self, distance: u32) -> Self {
        match self {
            Self::Constant(at) => Self::Constant(at.wrapping_add(distance)),
            Self::Based(id, at) => Self::Based(id, at.wrapping_add(distance)),
            Self::Unknown => Self::Unknown,
        }
    }
}

/// A shuffle that reverses the bytes of each word.
const SWAPPED: [u8; 16] = [3, 2, 1, 0, 7, 6, 5, 4, 11, 10, 9, 8, 15, 14, 13, 12];

impl Emitter<'_> {
    fn key(&mut self, id: Id) -> Key {
        let node = self.node(id);
        match (node.constant, node.root) {
            (Some(words), _) => Key::Constant(words[0]),
            (None, Some((root, distance))) => Key::Based(root, distance),
            (None, None) => Key::Based(id, 0),
        }
    }

    fn at(&mut self, key: Key, sum: Value) -> Address {
        if let Key::Constant(at) = key {
            let at = at & QUADWORD_MASK;
            return Address {
                key: Key::Constant(at),
                masked: self.word(at),
                pointer: self.local_store,
                offset: at as i32,
            };
        }
        let masked = self.b.ins().band_imm_u(sum, i64::from(QUADWORD_MASK));
        let wide = self.b.ins().uextend(types::I64, masked);
        let pointer = self.b.ins().iadd(self.local_store, wide);
        Address { key, masked, pointer, offset: 0 }
    }

    /// The address that is the sum of a register and a constant.
    pub(super) fn displaced(&mut self, i: Instruction) -> Address {
        let base = self.get(i.ra);
        let key = self.key(base).plus(i.immediate as u32);
        let scalar = self.scalar_of(base);
        let sum = self.b.ins().iadd_imm_s(scalar, i64::from(i.immediate));
        self.at(key, sum)
    }

    /// The address that is the sum of two registers.
    pub(super) fn indexed(&mut self, i: Instruction) -> Address {
        let (a, b) = (self.get(i.ra), self.get(i.rb));
        let key = match (self.key(a), self.key(b)) {
            (Key::Constant(at), key) | (key, Key::Constant(at)) => key.plus(at),
            _ => Key::Unknown,
        };
        let (a, b) = (self.scalar_of(a), self.scalar_of(b));
        let sum = self.b.ins().iadd(a, b);
        self.at(key, sum)
    }

    pub(super) fn fixed(&mut self, at: u32) -> Address {
        self.at(Key::Constant(at), self.registers)
    }

    /// If the quadword is watched for such accesses, the next commit exits.
    fn watch(&mut self, address: Address, accesses: u8) {
        const QUADWORD_SHIFT: u32 = 4;
        if !self.watches {
            return;
        }
        let table = self.load_field(types::I64, field::WATCHED);
        let (place, offset) = match address.key {
            Key::Constant(at) => (table, (at >> QUADWORD_SHIFT) as i32),
            _ => {
                let wide = self.b.ins().uextend(types::I64, address.masked);
                let number = self.b.ins().ushr_imm_u(wide, i64::from(QUADWORD_SHIFT));
                (self.b.ins().iadd(table, number), 0)
            }
        };
        let flags = MemFlagsData::trusted();
        let watched = self.b.ins().load(types::I8, flags, place, offset);
        let hit = self.b.ins().band_imm_u(watched, i64::from(accesses));
        self.unverified.watched = Some(self.or(self.unverified.watched, hit));
    }

    pub(super) fn load(&mut self, i: Instruction, address: Address) {
        self.watch(address, WATCH_LOADS);
        let (mut forwarded, mut others) = (None, Vec::new());
        for held in self.pending.iter().rev() {
            match held.address.key.overlap(address.key) {
                Overlap::None => {}
                Overlap::Same => {
                    forwarded = Some(held.words);
                    break;
                }
                Overlap::Perhaps => others.push(held.address.masked),
            }
        }
        if !others.is_empty() && (self.in_doubles || others.len() > MAX_COMPARED) {
            self.commit();
            (forwarded, others) = (None, Vec::new());
        }
        for other in others {
            self.has_fallback = true;
            let same = self.b.ins().icmp(IntCC::Equal, other, address.masked);
            self.unverified.overlapping = Some(self.or(self.unverified.overlapping, same));
        }
        let words = match forwarded {
            Some(words) => words,
            None => {
                let flags = MemFlagsData::trusted();
                let bytes = self.b.ins().load(types::I8X16, flags, address.pointer, address.offset);
                self.shuffle(bytes, bytes, SWAPPED)
            }
        };
        self.set(i.rt, words);
    }

    pub(super) fn store(&mut self, i: Instruction, address: Address) {
        self.watch(address, WATCH_STORES);
        let id = self.get(i.rt);
        let words = self.words(id);
        self.node(id).computed = true;
        let bytes = self.shuffle(words, words, SWAPPED);
        self.pending.push(Pending { address, bytes, words });
    }

    /// Sets rt to the control that inserts `1 << size` bytes at the address in `scalar`.
    fn insert(&mut self, rt: u8, size: usize, key: Key, scalar: Value) {
        let table = &TABLES.insertion[size];
        if let Key::Constant(at) = key {
            let bytes = &table[at as usize & 15];
            let words = std::array::from_fn(|n| {
                u32::from_le_bytes(std::array::from_fn(|byte| bytes[4 * n + byte]))
            });
            return self.set_constant(rt, words);
        }
        let control = self.table_row(table.as_ptr().cast(), scalar, 15);
        self.set(rt, control);
    }

    /// Loads the quadword of a table that the bits `mask` of `index` select.
    pub(super) fn table_row(&mut self, table: *const u8, index: Value, mask: u32) -> Value {
        let index = self.b.ins().band_imm_u(index, i64::from(mask));
        let wide = self.b.ins().uextend(types::I64, index);
        let distance = self.b.ins().ishl_imm_u(wide, 4);
        let table = self.b.ins().iconst(types::I64, table as i64);
        let row = self.b.ins().iadd(table, distance);
        self.b.ins().load(types::I8X16, MemFlagsData::trusted(), row, 0)
    }

    pub(super) fn insert_displaced(&mut self, i: Instruction, size: usize) {
        let base = self.get(i.ra);
        let key = self.key(base).plus(i.immediate as u32);
        let scalar = self.scalar_of(base);
        let sum = self.b.ins().iadd_imm_s(scalar, i64::from(i.immediate));
        self.insert(i.rt, size, key, sum);
    }

    pub(super) fn insert_indexed(&mut self, i: Instruction, size: usize) {
        let (a, b) = (self.get(i.ra), self.get(i.rb));
        let key = match (self.key(a), self.key(b)) {
            (Key::Constant(a), Key::Constant(b)) => Key::Constant(a.wrapping_add(b)),
            _ => Key::Unknown,
        };
        let (a, b) = (self.scalar_of(a), self.scalar_of(b));
        let sum = self.b.ins().iadd(a, b);
        self.insert(i.rt, size, key, sum);
    }
}
