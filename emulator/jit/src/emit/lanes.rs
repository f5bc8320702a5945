//! Lanes of vectors: extracting, gathering, shifting and masking.

use cranelift_codegen::ir::{InstBuilder, Type, Value};

use super::Emitter;

impl Emitter<'_> {
    /// The lanes of a vector, in the host's order.
    pub(super) fn extract(&mut self, vector: Value) -> Vec<Value> {
        let lanes = self.b.func.dfg.value_type(vector).lane_count();
        (0..lanes as u8).map(|lane| self.b.ins().extractlane(vector, lane)).collect()
    }

    pub(super) fn gather(&mut self, ty: Type, lanes: &[Value]) -> Value {
        let first = self.b.ins().scalar_to_vector(ty, lanes[0]);
        (1u8..)
            .zip(&lanes[1..])
            .fold(first, |vector, (lane, &value)| self.b.ins().insertlane(vector, value, lane))
    }

    /// Each lane of `a` shifted left by a constant.
    pub(super) fn left(&mut self, a: Value, count: u32) -> Value {
        let count = self.word(count);
        self.b.ins().ishl(a, count)
    }

    /// Each lane of `a` shifted right by a constant, filled with zeros.
    pub(super) fn right(&mut self, a: Value, count: u32) -> Value {
        let count = self.word(count);
        self.b.ins().ushr(a, count)
    }

    /// Each lane of `a` shifted right by a constant, filled with the sign.
    pub(super) fn right_signed(&mut self, a: Value, count: u32) -> Value {
        let count = self.word(count);
        self.b.ins().sshr(a, count)
    }

    /// Each word of `a`, masked by `bits`.
    pub(super) fn and(&mut self, a: Value, bits: u32) -> Value {
        let bits = self.splat(bits);
        self.b.ins().band(a, bits)
    }
}
