//! Loads, stores, and the instructions that generate controls for insertion by `shufb`.

use spu_isa::{Instruction, LOCAL_STORE_SIZE};

use super::emitter::{ADDRESS, Emitter, Facts, LOCAL_STORE, quadword};
use super::shift_rotate::NUMBERS;
use crate::exit::Exit;

/// The bits of the address of a quadword.
const ADDRESSES: u32 = LOCAL_STORE_SIZE - 16;
/// The bytes of each word in reverse order: local store is big-endian, words of registers are not.
const SWAPPED: i128 = 0x0c0d_0e0f_0809_0a0b_0405_0607_0001_0203;

/// An address in local store.
#[derive(Clone, Copy)]
pub(super) enum Address {
    Constant(u32),
    /// On the stack.
    Pushed,
}

impl Emitter<'_> {
    pub(super) fn displaced(&mut self, i: Instruction) -> Address {
        self.push_scalar(i.ra);
        self.f().i32_const(i.immediate).i32_add();
        Address::Pushed
    }

    pub(super) fn indexed(&mut self, i: Instruction) -> Address {
        self.push_scalar(i.ra);
        self.push_scalar(i.rb);
        self.f().i32_add();
        Address::Pushed
    }

    /// Pushes the address in memory, and returns a constant to be added.
    fn place(&mut self, address: Address) -> u32 {
        match address {
            Address::Constant(at) => {
                self.f().local_get(LOCAL_STORE);
                at & ADDRESSES
            }
            Address::Pushed => {
                self.f().i32_const(ADDRESSES as i32).i32_and().local_get(LOCAL_STORE).i32_add();
                0
            }
        }
    }

    pub(super) fn load(&mut self, i: Instruction, address: Address) {
        let offset = self.place(address);
        self.f().v128_load(quadword(offset)).v128_const(SWAPPED).i8x16_swizzle();
        self.set(i.rt);
    }

    /// Leaves a store into the trace's own code to the interpreter.
    pub(super) fn store(&mut self, i: Instruction, address: Address) {
        let mut address = address;
        let mut tests = 0;
        if let Address::Pushed = address {
            self.f().i32_const(ADDRESSES as i32).i32_and().local_set(ADDRESS);
        }
        for (start, end) in self.code() {
            match address {
                Address::Constant(at) if !(start..end).contains(&(at & ADDRESSES)) => continue,
                Address::Constant(_) => _ = self.f().i32_const(1),
                Address::Pushed => {
                    let mut f = self.f();
                    f.local_get(ADDRESS).i32_const(start as i32).i32_sub();
                    f.i32_const((end - start) as i32).i32_lt_u();
                }
            }
            tests += 1;
            if tests > 1 {
                self.f().i32_or();
            }
        }
        if tests > 0 {
            self.aside(|e| e.exit(Exit::INTERPRET));
        }
        if let Address::Pushed = address {
            self.f().local_get(ADDRESS).local_get(LOCAL_STORE).i32_add();
            address = Address::Constant(0);
        } else {
            self.f().local_get(LOCAL_STORE);
        }
        let Address::Constant(offset) = address else { return };
        self.push(i.rt);
        let place = quadword(offset & ADDRESSES);
        self.f().v128_const(SWAPPED).i8x16_swizzle().v128_store(place);
    }

    /// Sets rt to the control that inserts `size` bytes at the address on the stack.
    pub(super) fn insert(&mut self, i: Instruction, size: u32) {
        // A doubleword is in bytes 0 to 7 of its register. A smaller scalar ends at byte 3.
        let scalar = if size == 8 { 0 } else { 4 - size as i32 };
        let position = self.temporary(0);
        let bytes = |byte: u8| i128::from_le_bytes([byte; 16]);
        let first = (16 - size) as i32;
        self.f().i32_const(first).i32_and().local_set(ADDRESS);
        let mut f = self.f();
        f.v128_const(NUMBERS).local_get(ADDRESS).i8x16_splat().i8x16_sub().local_tee(position);
        f.v128_const(bytes(scalar as u8)).i8x16_add();
        f.v128_const(NUMBERS + bytes(16));
        f.local_get(position).v128_const(bytes(size as u8)).i8x16_lt_u();
        f.v128_bitselect();
        self.set_with(i.rt, Facts::default());
    }
}
