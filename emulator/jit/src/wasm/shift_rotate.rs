//! Shifts and rotates.
//!
//! Every count is masked. Counts beyond the lane's width give zeros (or signs), and right shifts
//! take the negated count. WebAssembly takes counts modulo the width.

use spu_isa::Instruction;

use super::emitter::{ADDRESS, Emitter};
use super::integer::Operation;

/// For each byte of a register, its number from the left.
pub(super) const NUMBERS: i128 = 0x0c0d_0e0f_0809_0a0b_0405_0607_0001_0203;

/// How lanes move.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Move {
    Left,
    Right,
    RightSigned,
    Rotate,
}

/// Operations on lanes of one width.
pub(super) struct Lanes {
    pub width: u32,
    pub left: Operation,
    pub right: Operation,
    pub right_signed: Operation,
}

/// Where the count is.
#[derive(Clone, Copy)]
pub(super) enum Count {
    Constant,
    Register,
    /// In the register, as a number of bits of which whole bytes count.
    RegisterInBits,
}

impl Emitter<'_> {
    pub(super) fn shift_constant(&mut self, i: Instruction, lanes: &Lanes, way: Move) {
        let width = lanes.width as i32;
        let left = i.immediate & (2 * width - 1);
        let right = -i.immediate & (2 * width - 1);
        self.push(i.ra);
        match way {
            Move::Left if left < width => _ = (lanes.left)(self.f().i32_const(left)),
            Move::Right if right < width => _ = (lanes.right)(self.f().i32_const(right)),
            Move::Left | Move::Right => _ = self.f().drop().v128_const(0),
            Move::RightSigned => {
                _ = (lanes.right_signed)(self.f().i32_const(right.min(width - 1)));
            }
            Move::Rotate => {
                let left = left & (width - 1);
                (lanes.left)(self.f().i32_const(left));
                if left != 0 {
                    self.push(i.ra);
                    (lanes.right)(self.f().i32_const(width - left)).v128_or();
                }
            }
        }
        self.set(i.rt);
    }

    /// Shifts words by the counts in rb. Each is moved by itself.
    pub(super) fn shift_words(&mut self, i: Instruction, way: Move) {
        self.f().v128_const(0);
        for lane in 0..4 {
            self.push(i.ra);
            self.f().i32x4_extract_lane(lane);
            match way {
                Move::Left | Move::Right => _ = self.f().i64_extend_i32_u(),
                Move::RightSigned => _ = self.f().i64_extend_i32_s(),
                Move::Rotate => {}
            }
            if let Move::Right | Move::RightSigned = way {
                self.f().i32_const(0);
            }
            self.push(i.rb);
            let mut f = self.f();
            f.i32x4_extract_lane(lane);
            if let Move::Right | Move::RightSigned = way {
                f.i32_sub();
            }
            match way {
                Move::Rotate => f.i32_rotl(),
                Move::Left => f.i64_extend_i32_u().i64_shl().i32_wrap_i64(),
                Move::Right => f.i64_extend_i32_u().i64_shr_u().i32_wrap_i64(),
                Move::RightSigned => f.i64_extend_i32_u().i64_shr_s().i32_wrap_i64(),
            };
            f.i32x4_replace_lane(lane);
        }
        self.set(i.rt);
    }

    /// Sets the address to the count, masked.
    fn count(&mut self, i: Instruction, count: Count, negated: bool, mask: i32) {
        if negated {
            self.f().i32_const(0);
        }
        match count {
            Count::Constant => _ = self.f().i32_const(i.immediate),
            Count::Register => self.push_scalar(i.rb),
            Count::RegisterInBits => {
                self.push_scalar(i.rb);
                self.f().i32_const(3).i32_shr_u();
            }
        }
        if negated {
            self.f().i32_sub();
        }
        self.f().i32_const(mask).i32_and().local_set(ADDRESS);
    }

    /// Shifts the quadword by whole bytes. A byte from beyond its ends is 0.
    pub(super) fn shift_bytes(&mut self, i: Instruction, way: Move, count: Count) {
        let mask = if way == Move::Rotate { 15 } else { 31 };
        self.count(i, count, way == Move::Right, mask);
        self.push(i.ra);
        let mut f = self.f();
        f.v128_const(NUMBERS).local_get(ADDRESS).i8x16_splat();
        let bytes = |byte: u8| i128::from_le_bytes([byte; 16]);
        match way {
            Move::Rotate => f.i8x16_add().v128_const(bytes(15)).v128_and(),
            Move::Left => f.i8x16_add(),
            Move::Right | Move::RightSigned => f.i8x16_sub(),
        };
        f.v128_const(bytes(3)).v128_xor().i8x16_swizzle();
        self.set(i.rt);
    }

    /// Shifts the quadword by up to seven bits, some of which come from the next word.
    pub(super) fn shift_bits(&mut self, i: Instruction, way: Move, count: Count) {
        let right = way == Move::Right;
        self.count(i, count, right, 7);
        let (one, other): (Operation, Operation) = if right {
            (|f| f.i32x4_shr_u(), |f| f.i32x4_shl())
        } else {
            (|f| f.i32x4_shl(), |f| f.i32x4_shr_u())
        };
        // Numbers from 16 on are of bytes that are 0.
        let neighbours = match way {
            Move::Rotate => [4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 0, 1, 2, 3],
            Move::Left => [4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 16, 16, 16],
            _ => [16, 16, 16, 16, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11],
        };
        self.push(i.ra);
        one(self.f().local_get(ADDRESS));
        self.push(i.ra);
        let mut f = self.f();
        f.v128_const(i128::from_le_bytes(neighbours)).i8x16_swizzle();
        // In two steps, because the count may be 0.
        other(f.i32_const(1));
        other(f.i32_const(31).local_get(ADDRESS).i32_sub()).v128_or();
        self.set(i.rt);
    }
}
