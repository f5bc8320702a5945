//! The common forms of instructions: a function of the source registers, lane by lane.

use super::quad::Quad;
use super::spu::Spu;
use spu_isa::Instruction;
use std::array::from_fn;

impl Spu {
    #[inline]
    pub(super) fn ra(&self, i: Instruction) -> Quad {
        self.register(i.ra)
    }

    #[inline]
    pub(super) fn rb(&self, i: Instruction) -> Quad {
        self.register(i.rb)
    }

    #[inline]
    pub(super) fn rc(&self, i: Instruction) -> Quad {
        self.register(i.rc)
    }

    #[inline]
    pub(super) fn rt(&self, i: Instruction) -> Quad {
        self.register(i.rt)
    }

    #[inline]
    pub(super) fn set_rt(&mut self, i: Instruction, value: Quad) {
        self.set_register(i.rt, value);
    }

    /// rt = f(ra), by words.
    #[inline]
    pub(super) fn word_unary(&mut self, i: Instruction, f: impl Fn(u32) -> u32) {
        let Quad(a) = self.ra(i);
        self.set_rt(i, Quad(a.map(f)));
    }

    /// rt = f(ra, rb), by words.
    #[inline]
    pub(super) fn word_binary(&mut self, i: Instruction, f: impl Fn(u32, u32) -> u32) {
        let (Quad(a), Quad(b)) = (self.ra(i), self.rb(i));
        self.set_rt(i, Quad(from_fn(|n| f(a[n], b[n]))));
    }

    /// rt = f(ra, rb, rt), by words.
    #[inline]
    pub(super) fn word_accumulate(&mut self, i: Instruction, f: impl Fn(u32, u32, u32) -> u32) {
        let (Quad(a), Quad(b), Quad(t)) = (self.ra(i), self.rb(i), self.rt(i));
        self.set_rt(i, Quad(from_fn(|n| f(a[n], b[n], t[n]))));
    }

    /// rt = f(ra, rb, rc), by words.
    #[inline]
    pub(super) fn word_ternary(&mut self, i: Instruction, f: impl Fn(u32, u32, u32) -> u32) {
        let (Quad(a), Quad(b), Quad(c)) = (self.ra(i), self.rb(i), self.rc(i));
        self.set_rt(i, Quad(from_fn(|n| f(a[n], b[n], c[n]))));
    }

    /// rt = f(ra), by halfwords.
    #[inline]
    pub(super) fn halfword_unary(&mut self, i: Instruction, f: impl Fn(u16) -> u16) {
        let a = self.ra(i).halfwords();
        self.set_rt(i, Quad::from_halfwords(a.map(f)));
    }

    /// rt = f(ra, rb), by halfwords.
    #[inline]
    pub(super) fn halfword_binary(&mut self, i: Instruction, f: impl Fn(u16, u16) -> u16) {
        let (a, b) = (self.ra(i).halfwords(), self.rb(i).halfwords());
        self.set_rt(i, Quad::from_halfwords(from_fn(|n| f(a[n], b[n]))));
    }

    /// rt = f(ra), by bytes.
    #[inline]
    pub(super) fn byte_unary(&mut self, i: Instruction, f: impl Fn(u8) -> u8) {
        let a = self.ra(i).bytes();
        self.set_rt(i, Quad::from_bytes(a.map(f)));
    }

    /// rt = f(ra, rb), by bytes.
    #[inline]
    pub(super) fn byte_binary(&mut self, i: Instruction, f: impl Fn(u8, u8) -> u8) {
        let (a, b) = (self.ra(i).bytes(), self.rb(i).bytes());
        self.set_rt(i, Quad::from_bytes(from_fn(|n| f(a[n], b[n]))));
    }

    /// rt = f(ra), with the quadword as a number.
    #[inline]
    pub(super) fn quadword_unary(&mut self, i: Instruction, f: impl Fn(u128) -> u128) {
        let a = self.ra(i).to_u128();
        self.set_rt(i, Quad::from_u128(f(a)));
    }

    /// rt = f(ra, preferred word of rb), with the quadword as a number.
    #[inline]
    pub(super) fn quadword_by_scalar(&mut self, i: Instruction, f: impl Fn(u128, u32) -> u128) {
        let (a, b) = (self.ra(i).to_u128(), self.rb(i).preferred());
        self.set_rt(i, Quad::from_u128(f(a, b)));
    }
}
