//! Shifts and rotates.

use cranelift_codegen::ir::types::{self, I8X16, I16X8, I32X4};
use cranelift_codegen::ir::{InstBuilder, Type, Value};
use spu_isa::Instruction;

use super::Emitter;
use crate::tables::TABLES;

/// How each lane moves. The counts of right shifts are negated.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Move {
    Left,
    Rotate,
    Right,
    RightSigned,
}

/// How a quadword moves by up to seven bits.
#[derive(Clone, Copy)]
pub(super) enum Bits {
    Left,
    Rotate,
    Right,
}

/// How a quadword moves by whole bytes.
#[derive(Clone, Copy)]
pub(super) enum Bytes {
    Left,
    Rotate,
    Right,
}

/// Where an instruction has its count.
#[derive(Clone, Copy)]
pub(super) enum Count {
    Constant,
    /// In rb.
    Register,
    /// In rb, as a number of bits, which is eight times the number of bytes.
    RegisterInBits,
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

    /// Shifts each lane by its own count. The host's vector shifts use one count for all lanes, so
    /// lanes with different counts are shifted one by one.
    pub(super) fn shift(&mut self, i: Instruction, ty: Type, how: Move) {
        let counts = self.get(i.rb);
        if let Some([count, rest @ ..]) = self.constant(counts)
            && rest == [count; 3]
            && (ty == I32X4 || count >> 16 == count & 0xffff)
        {
            return self.shift_all(i, ty, how, count & 0xffff);
        }
        // In a type twice as wide no count is too large, and the host masks counts to that width,
        // as the SPU does.
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
        // The neighbouring word of each word, whose bits are shifted in.
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
        // The neighbour is shifted in two steps, because a count of 0 means a shift by 32 for it.
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
            Count::Register | Count::RegisterInBits => {
                let id = self.get(i.rb);
                self.constant(id).map(|words| words[0])
            }
        };
        let of_bits = matches!(count, Count::RegisterInBits);
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
