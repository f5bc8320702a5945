//! Byte shuffles, form-select-mask instructions and gathers.

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::{self, I8X16, I16X8, I32X4};
use cranelift_codegen::ir::{InstBuilder, Type, Value};
use spu_isa::Instruction;

use super::Emitter;
use super::commit::REVERSED_WORDS;
use super::registers::{Facts, Id};

/// The constants that `shufb` gives, indexed by the upper three bits of the control.
const CONSTANTS: [u8; 16] = [0, 0, 0, 0, 0, 0, 0xff, 0x80, 0, 0, 0, 0, 0, 0, 0, 0];

/// A control of `shufb` as the host needs it: its own controls for both operands, which give 0 for
/// bytes from elsewhere, and the constants.
#[derive(Clone, Copy)]
pub(super) struct ShuffleControl {
    from_a: Value,
    from_b: Value,
    constants: Value,
}

impl Emitter<'_> {
    pub(super) fn shuffle_bytes(&mut self, i: Instruction) {
        let control = self.get(i.rc);
        let (a, b) = (self.lanes(I8X16, i.ra), self.lanes(I8X16, i.rb));
        if let Some(words) = self.constant(control) {
            let shuffled = self.shuffle_by_constant(a, b, words);
            return self.set(i.rt, shuffled);
        }
        let ShuffleControl { from_a, from_b, constants } = self.shuffle_control(control);
        let from_a = self.b.ins().x86_pshufb(a, from_a);
        let from_b = self.b.ins().x86_pshufb(b, from_b);
        let bytes = self.b.ins().bor(from_a, from_b);
        let bytes = self.b.ins().bor(bytes, constants);
        self.set(i.rt, bytes);
    }

    /// The parts of a control that is not known when code is emitted.
    pub(super) fn shuffle_control(&mut self, id: Id) -> ShuffleControl {
        if let Some(parts) = self.node(id).shuffle_control {
            return parts;
        }
        let control = self.words(id);
        // On the host, bytes within a word are in reverse order.
        let index = self.bits_of_bytes(I32X4, control, 0x1f);
        let flip = self.splat(0x0303_0303);
        let index = self.b.ins().bxor(index, flip);
        let special = self.bits_of_bytes(I32X4, control, 0x80);
        // For indices from 16 on, and for constants, the highest bit gets set, which gives 0.
        let from_a = self.index(index, special);
        let flip = self.splat(0x1010_1010);
        let other = self.b.ins().bxor(index, flip);
        let from_b = self.index(other, special);
        let kind = self.right(control, 5);
        let kind = self.bits_of_bytes(I8X16, kind, 7);
        let constants = self.constant_bytes(I8X16, CONSTANTS.to_vec());
        let constants = self.b.ins().x86_pshufb(constants, kind);
        let parts = ShuffleControl { from_a, from_b, constants };
        if !self.in_side_exit {
            self.node(id).shuffle_control = Some(parts);
        }
        parts
    }

    fn bits_of_bytes(&mut self, ty: Type, value: Value, bits: u8) -> Value {
        let words = self.cast(I32X4, value);
        let masked = self.and(words, u32::from(bits) * 0x0101_0101);
        self.cast(ty, masked)
    }

    fn index(&mut self, index: Value, special: Value) -> Value {
        let index = self.cast(I8X16, index);
        let distance = self.constant_bytes(I8X16, vec![0x70; 16]);
        let index = self.b.ins().iadd(index, distance);
        let special = self.cast(I8X16, special);
        self.b.ins().bor(index, special)
    }

    fn shuffle_by_constant(&mut self, a: Value, b: Value, control: [u32; 4]) -> Value {
        let controls = control.map(u32::to_le_bytes).concat();
        let mut from = [0; 16];
        let mut constants = [0; 16];
        for (n, &control) in controls.iter().enumerate() {
            (from[n], constants[n]) = match control {
                0..0x80 => (control & 0x1f ^ 3, 0),
                0x80..0xc0 => (0xff, 0),
                0xc0..0xe0 => (0xff, 0xff),
                0xe0.. => (0xff, 0x80),
            };
        }
        if from == [0xff; 16] {
            return self.constant_bytes(I8X16, constants.to_vec());
        }
        let shuffled = if from.iter().all(|&from| from < 16 || from == 0xff) {
            // All bytes come from `a`, so one shuffle of the host suffices. It also gives zeros.
            let control = from.map(|from| if from == 0xff { 0x80 } else { from });
            let control = self.constant_bytes(I8X16, control.to_vec());
            self.b.ins().x86_pshufb(a, control)
        } else if from.iter().all(|&from| from >= 16) {
            let control = from.map(|from| if from == 0xff { 0x80 } else { from - 16 });
            let control = self.constant_bytes(I8X16, control.to_vec());
            self.b.ins().x86_pshufb(b, control)
        } else if from.contains(&0xff) {
            let one = from.map(|from| if from < 16 { from } else { 0x80 });
            let other = from.map(|from| if (16..32).contains(&from) { from - 16 } else { 0x80 });
            let one = self.constant_bytes(I8X16, one.to_vec());
            let other = self.constant_bytes(I8X16, other.to_vec());
            let from_a = self.b.ins().x86_pshufb(a, one);
            let from_b = self.b.ins().x86_pshufb(b, other);
            self.b.ins().bor(from_a, from_b)
        } else {
            self.shuffle(a, b, from)
        };
        if constants == [0; 16] {
            return shuffled;
        }
        let constants = self.constant_bytes(I8X16, constants.to_vec());
        self.b.ins().bor(shuffled, constants)
    }

    pub(super) fn form_mask_of_constant(&mut self, i: Instruction) {
        let bits = i.immediate as u32;
        let byte = |n: usize| if bits >> (15 - n) & 1 == 1 { 0xff } else { 0 };
        let words = std::array::from_fn(|word| {
            u32::from_be_bytes(std::array::from_fn(|n| byte(4 * word + n)))
        });
        self.set_constant(i.rt, words);
    }

    /// Sets each lane to ones if `bits` has the bit that `mask` has in that lane.
    fn form_mask(&mut self, i: Instruction, ty: Type, bits: Value, mask: Vec<u8>) {
        let mask = self.constant_bytes(ty, mask);
        let bit = self.b.ins().band(bits, mask);
        let ones = self.b.ins().icmp(IntCC::Equal, bit, mask);
        let facts = Facts { mask: ty == I32X4, ..Facts::default() };
        self.set_with(i.rt, ones, facts);
    }

    pub(super) fn form_mask_of_words(&mut self, i: Instruction) {
        let bits = self.splat_scalar(I32X4, i.ra);
        let mask = [8u32, 4, 2, 1].map(u32::to_le_bytes).concat();
        self.form_mask(i, I32X4, bits, mask);
    }

    pub(super) fn form_mask_of_halfwords(&mut self, i: Instruction) {
        let bits = self.splat_scalar(I16X8, i.ra);
        let bit = |lane: u16| 1u16 << (7 - (lane ^ 1));
        let mask = (0..8).flat_map(|lane| bit(lane).to_le_bytes()).collect();
        self.form_mask(i, I16X8, bits, mask);
    }

    pub(super) fn form_mask_of_bytes(&mut self, i: Instruction) {
        let bits = self.splat_scalar(I16X8, i.ra);
        let from = [1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0];
        let bits = self.shuffle(bits, bits, from);
        let bit = |byte: u8| 1u8 << (7 - ((byte ^ 3) & 7));
        self.form_mask(i, I8X16, bits, (0..16).map(bit).collect());
    }

    pub(super) fn gather_words(&mut self, i: Instruction) {
        let a = self.lanes(I32X4, i.ra);
        let reversed = self.shuffle(a, a, REVERSED_WORDS);
        let reversed = self.cast(I32X4, reversed);
        let high = self.left(reversed, 31);
        let bits = self.b.ins().vhigh_bits(types::I32, high);
        self.set_scalar(i.rt, bits);
    }

    pub(super) fn gather_halfwords(&mut self, i: Instruction) {
        let a = self.lanes(I16X8, i.ra);
        // The host's lane n gets halfword 7 - n, which is in lane (7 - n) ^ 1.
        let from = std::array::from_fn(|byte| {
            let lane = (7 - byte / 2) ^ 1;
            (2 * lane + byte % 2) as u8
        });
        let reversed = self.shuffle(a, a, from);
        let reversed = self.cast(I16X8, reversed);
        let high = self.left(reversed, 15);
        let bits = self.b.ins().vhigh_bits(types::I32, high);
        self.set_scalar(i.rt, bits);
    }

    pub(super) fn gather_bytes(&mut self, i: Instruction) {
        let a = self.lanes(I8X16, i.ra);
        let from = std::array::from_fn(|byte| ((15 - byte) ^ 3) as u8);
        let reversed = self.shuffle(a, a, from);
        let reversed = self.cast(I16X8, reversed);
        let high = self.left(reversed, 7);
        let high = self.cast(I8X16, high);
        let bits = self.b.ins().vhigh_bits(types::I32, high);
        self.set_scalar(i.rt, bits);
    }
}
