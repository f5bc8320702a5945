//! Shifts and rotates.

use cranelift_codegen::ir::types::{self, I8X16, I16X8, I32X4};
use cranelift_codegen::ir::{InstBuilder, Type, Value};
use spu_isa::Instruction;

use super::Emitter;
use crate::tables::TABLES;

/// What becomes of each lane. The right shifts take their counts negated.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Move {
    Left,
    Rotate,
    Right,
    RightSigned,
}

/// What becomes of a quadword, by up to seven bits.
#[derive(Clone, Copy)]
pub(super) enum Bits {
    Left,
    Rotate,
    Right,
}

/// What becomes of a quadword, by bytes.
#[derive(Clone, Copy)]
pub(super) enum Bytes {
    Left,
    Rotate,
    Right,
}

/// Where the count is.
#[derive(Clone, Copy)]
pub(super) enum Count {
    Constant,
    /// In rb.
    Register,
    /// In rb, eight times.
    RegisterOfBits,
}

impl Emitter<'_> {
    pub(super) fn shift_constant(&mut self, i: Instruction, ty: Type, how: Move) {
        self.shift_all(i, ty, how, i.immediate as u32);
    }

    fn shift_all(&mut self, i: Instruction, ty: Type, how: Move, count: u32) {
        let width = ty.lane_bits();
        let a = self.lanes(ty, i.ra);
        let right = count.wrapping_neg() & (2 * width - 1);
        let shifted = match how {
            Move::Left => match count & (2 * width - 1) {
                count if count < width => self.left(a, count),
                _ => self.splat(0),
            },
            Move::Rotate => match count & (width - 1) {
                0 => a,
                count => {
                    let left = self.left(a, count);
                    let right = self.right(a, width - count);
                    self.b.ins().bor(left, right)
                }
            },
            Move::Right if right < width => self.right(a, right),
            Move::Right => self.splat(0),
            Move::RightSigned => self.right_signed(a, right.min(width - 1)),
        };
        self.set(i.rt, shifted);
    }

    /// The host shifts all lanes by one count, so lanes with their own go one by one.
    pub(super) fn shift(&mut self, i: Instruction, ty: Type, how: Move) {
        let counts = self.get(i.rb);
        if let Some([count, rest @ ..]) = self.constant(counts)
            && rest == [count; 3]
            && (ty == I32X4 || count >> 16 == count & 0xffff)
        {
            return self.shift_all(i, ty, how, count & 0xffff);
        }
        // Within a type twice as wide no count is too large, and the host masks counts to its
        // width, as the SPU does.
        let (lane, wide) = match ty {
            I16X8 => (types::I16, types::I32),
            _ => (types::I32, types::I64),
        };
        let (a, counts) = (self.lanes(ty, i.ra), self.lanes(ty, i.rb));
        let (a, counts) = (self.extract(a), self.extract(counts));
        let shifted: Vec<Value> = a
            .into_iter()
            .zip(counts)
            .map(|(a, count)| {
                if how == Move::Rotate {
                    return self.b.ins().rotl(a, count);
                }
                let signed = how == Move::RightSigned;
                let a = if signed {
                    self.b.ins().sextend(wide, a)
                } else {
                    self.b.ins().uextend(wide, a)
                };
                let count = self.b.ins().uextend(wide, count);
                let shifted = match how {
                    Move::Left => self.b.ins().ishl(a, count),
                    Move::Right => {
                        let count = self.b.ins().ineg(count);
                        self.b.ins().ushr(a, count)
                    }
                    _ => {
                        let count = self.b.ins().ineg(count);
                        self.b.ins().sshr(a, count)
                    }
                };
                self.b.ins().ireduce(lane, shifted)
            })
            .collect();
        let shifted = self.gather(ty, &shifted);
        self.set(i.rt, shifted);
    }

    pub(super) fn shift_bits(&mut self, i: Instruction, how: Bits, count: Count) {
        let a = self.lanes(I32X4, i.ra);
        // The word whose bits come in, if any does.
        let from = match how {
            Bits::Left => [4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 16, 16, 16],
            Bits::Rotate => [4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 0, 1, 2, 3],
            Bits::Right => [16, 16, 16, 16, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11],
        };
        let zeros = self.splat(0);
        let neighbour = self.shuffle(a, zeros, from);
        let neighbour = self.cast(I32X4, neighbour);
        let right = matches!(how, Bits::Right);
        let (count, rest) = if let Count::Constant = count {
            let count = i.immediate as u32;
            let count = if right { count.wrapping_neg() } else { count } & 7;
            (self.word(count), self.word(31 - count))
        } else {
            let mut count = self.scalar(i.rb);
            if right {
                count = self.b.ins().ineg(count);
            }
            let count = self.b.ins().band_imm_u(count, 7);
            let most = self.word(31);
            (count, self.b.ins().isub(most, count))
        };
        // In two steps, as a count of 0 leaves 32 for the neighbour.
        let shifted = if right {
            let neighbour = self.left(neighbour, 1);
            let bits = self.b.ins().ishl(neighbour, rest);
            let a = self.b.ins().ushr(a, count);
            self.b.ins().bor(a, bits)
        } else {
            let neighbour = self.right(neighbour, 1);
            let bits = self.b.ins().ushr(neighbour, rest);
            let a = self.b.ins().ishl(a, count);
            self.b.ins().bor(a, bits)
        };
        self.set(i.rt, shifted);
    }

    pub(super) fn shift_bytes(&mut self, i: Instruction, how: Bytes, count: Count) {
        let a = self.lanes(I8X16, i.ra);
        let (table, mask): (&[[u8; 16]], u32) = match how {
            Bytes::Rotate => (&TABLES.rotate, 15),
            Bytes::Left => (&TABLES.left, 31),
            Bytes::Right => (&TABLES.right, 31),
        };
        let known = match count {
            Count::Constant => Some(i.immediate as u32),
            Count::Register | Count::RegisterOfBits => {
                let id = self.get(i.rb);
                self.constant(id).map(|words| words[0])
            }
        };
        let of_bits = matches!(count, Count::RegisterOfBits);
        let right = matches!(how, Bytes::Right);
        let control = if let Some(count) = known {
            let count = if of_bits { count >> 3 } else { count };
            let count = if right { count.wrapping_neg() } else { count } & mask;
            if count == 0 {
                let id = self.get(i.ra);
                return self.put(i.rt, id);
            }
            let row = table[count as usize];
            if !row.contains(&0x80) {
                let shuffled = self.shuffle(a, a, row);
                return self.set(i.rt, shuffled);
            }
            self.constant_bytes(I8X16, row.to_vec())
        } else {
            let mut count = self.scalar(i.rb);
            if of_bits {
                count = self.b.ins().ushr_imm_u(count, 3);
            }
            if right {
                count = self.b.ins().ineg(count);
            }
            self.table_row(table.as_ptr().cast(), count, mask)
        };
        let shifted = self.b.ins().x86_pshufb(a, control);
        self.set(i.rt, shifted);
    }
}
