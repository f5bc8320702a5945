//! Floating point: registers to the functions of [`crate::float`], flags to the FPSCR.

use super::quad::Quad;
use super::spu::Spu;
use crate::float::fpscr::{Flags, Fpscr, Rounding};
use crate::float::single::Lanes;
use crate::float::{convert, double, estimate, single};
use crate::isa::Instruction;
use std::array::from_fn;

impl Spu {
    #[inline]
    fn set_singles(&mut self, i: Instruction, (values, flags): Lanes<4>) {
        self.fpscr.raise_single(flags);
        self.set_rt(i, Quad(values));
    }

    #[inline]
    fn single_binary(&mut self, i: Instruction, f: impl Fn([u32; 4], [u32; 4]) -> Lanes<4>) {
        let (Quad(a), Quad(b)) = (self.ra(i), self.rb(i));
        self.set_singles(i, f(a, b));
    }

    #[inline]
    fn single_ternary(
        &mut self,
        i: Instruction,
        f: impl Fn([u32; 4], [u32; 4], [u32; 4]) -> Lanes<4>,
    ) {
        let (Quad(a), Quad(b), Quad(c)) = (self.ra(i), self.rb(i), self.rc(i));
        self.set_singles(i, f(a, b, c));
    }

    #[inline]
    fn set_doubles(&mut self, i: Instruction, results: [(u64, Flags); 2]) {
        self.fpscr.raise_double(results.map(|(_, flags)| flags));
        let values = results.map(|(value, _)| value);
        self.set_rt(i, Quad::from_doublewords(values));
    }

    #[inline]
    fn double_binary(&mut self, i: Instruction, f: impl Fn(u64, u64, Rounding) -> (u64, Flags)) {
        let (a, b) = (self.ra(i).doublewords(), self.rb(i).doublewords());
        let fpscr = self.fpscr;
        self.set_doubles(i, from_fn(|n| f(a[n], b[n], fpscr.rounding(n))));
    }

    #[inline]
    fn double_accumulate(
        &mut self,
        i: Instruction,
        f: impl Fn(u64, u64, u64, Rounding) -> (u64, Flags),
    ) {
        let (a, b) = (self.ra(i).doublewords(), self.rb(i).doublewords());
        let t = self.rt(i).doublewords();
        let fpscr = self.fpscr;
        self.set_doubles(i, from_fn(|n| f(a[n], b[n], t[n], fpscr.rounding(n))));
    }

    #[inline]
    fn double_compare(&mut self, i: Instruction, f: impl Fn(u64, u64) -> (u64, Flags)) {
        self.double_binary(i, |a, b, _| f(a, b));
    }
}

#[inline]
fn split(lanes: [(u32, Flags); 4]) -> Lanes<4> {
    (lanes.map(|lane| lane.0), lanes.map(|lane| lane.1))
}

#[inline]
pub(super) fn fa(spu: &mut Spu, i: Instruction) {
    spu.single_binary(i, single::fa_lanes);
}

#[inline]
pub(super) fn fs(spu: &mut Spu, i: Instruction) {
    spu.single_binary(i, single::fs_lanes);
}

#[inline]
pub(super) fn fm(spu: &mut Spu, i: Instruction) {
    spu.single_binary(i, single::fm_lanes);
}

#[inline]
pub(super) fn fma(spu: &mut Spu, i: Instruction) {
    spu.single_ternary(i, single::fma_lanes);
}

#[inline]
pub(super) fn fms(spu: &mut Spu, i: Instruction) {
    spu.single_ternary(i, single::fms_lanes);
}

#[inline]
pub(super) fn fnms(spu: &mut Spu, i: Instruction) {
    spu.single_ternary(i, single::fnms_lanes);
}

#[inline]
fn estimate(spu: &mut Spu, i: Instruction, f: impl Fn(u32) -> u32) {
    let Quad(a) = spu.ra(i);
    spu.fpscr
        .raise_divide_by_zero(a.map(estimate::divides_by_zero));
    spu.set_rt(i, Quad(a.map(f)));
}

#[inline]
pub(super) fn frest(spu: &mut Spu, i: Instruction) {
    estimate(spu, i, estimate::frest);
}

#[inline]
pub(super) fn frsqest(spu: &mut Spu, i: Instruction) {
    estimate(spu, i, estimate::frsqest);
}

#[inline]
pub(super) fn fi(spu: &mut Spu, i: Instruction) {
    let (Quad(a), Quad(b)) = (spu.ra(i), spu.rb(i));
    let lanes: [_; 4] = from_fn(|n| estimate::fi_flagged(a[n], b[n]));
    spu.set_singles(i, split(lanes));
}

#[inline]
pub(super) fn csflt(spu: &mut Spu, i: Instruction) {
    let Quad(a) = spu.ra(i);
    spu.set_singles(i, split(a.map(|a| convert::csflt_flagged(a, i.immediate))));
}

#[inline]
pub(super) fn cuflt(spu: &mut Spu, i: Instruction) {
    let Quad(a) = spu.ra(i);
    spu.set_singles(i, split(a.map(|a| convert::cuflt_flagged(a, i.immediate))));
}

#[inline]
pub(super) fn cflts(spu: &mut Spu, i: Instruction) {
    spu.word_unary(i, |a| convert::cflts(a, i.immediate));
}

#[inline]
pub(super) fn cfltu(spu: &mut Spu, i: Instruction) {
    spu.word_unary(i, |a| convert::cfltu(a, i.immediate));
}

#[inline]
pub(super) fn fceq(spu: &mut Spu, i: Instruction) {
    spu.word_binary(i, single::fceq);
}

#[inline]
pub(super) fn fcmeq(spu: &mut Spu, i: Instruction) {
    spu.word_binary(i, single::fcmeq);
}

#[inline]
pub(super) fn fcgt(spu: &mut Spu, i: Instruction) {
    spu.word_binary(i, single::fcgt);
}

#[inline]
pub(super) fn fcmgt(spu: &mut Spu, i: Instruction) {
    spu.word_binary(i, single::fcmgt);
}

#[inline]
pub(super) fn dfa(spu: &mut Spu, i: Instruction) {
    spu.double_binary(i, double::dfa);
}

#[inline]
pub(super) fn dfs(spu: &mut Spu, i: Instruction) {
    spu.double_binary(i, double::dfs);
}

#[inline]
pub(super) fn dfm(spu: &mut Spu, i: Instruction) {
    spu.double_binary(i, double::dfm);
}

#[inline]
pub(super) fn dfma(spu: &mut Spu, i: Instruction) {
    spu.double_accumulate(i, double::dfma);
}

#[inline]
pub(super) fn dfms(spu: &mut Spu, i: Instruction) {
    spu.double_accumulate(i, double::dfms);
}

#[inline]
pub(super) fn dfnms(spu: &mut Spu, i: Instruction) {
    spu.double_accumulate(i, double::dfnms);
}

#[inline]
pub(super) fn dfnma(spu: &mut Spu, i: Instruction) {
    spu.double_accumulate(i, double::dfnma);
}

#[inline]
pub(super) fn fesd(spu: &mut Spu, i: Instruction) {
    let a = spu.ra(i).doublewords();
    spu.set_doubles(i, a.map(|a| double::fesd((a >> 32) as u32)));
}

#[inline]
pub(super) fn frds(spu: &mut Spu, i: Instruction) {
    let a = spu.ra(i).doublewords();
    let fpscr = spu.fpscr;
    let rounded = from_fn(|n| {
        let (single, flags) = double::frds(a[n], fpscr.rounding(n));
        (u64::from(single) << 32, flags)
    });
    spu.set_doubles(i, rounded);
}

#[inline]
pub(super) fn fscrrd(spu: &mut Spu, i: Instruction) {
    spu.set_rt(i, Quad(spu.fpscr.words()));
}

#[inline]
pub(super) fn fscrwr(spu: &mut Spu, i: Instruction) {
    spu.fpscr = Fpscr::from_words(spu.ra(i).0);
}

#[inline]
pub(super) fn dfceq(spu: &mut Spu, i: Instruction) {
    spu.double_compare(i, double::dfceq);
}

#[inline]
pub(super) fn dfcmeq(spu: &mut Spu, i: Instruction) {
    spu.double_compare(i, double::dfcmeq);
}

#[inline]
pub(super) fn dfcgt(spu: &mut Spu, i: Instruction) {
    spu.double_compare(i, double::dfcgt);
}

#[inline]
pub(super) fn dfcmgt(spu: &mut Spu, i: Instruction) {
    spu.double_compare(i, double::dfcmgt);
}

#[inline]
pub(super) fn dftsv(spu: &mut Spu, i: Instruction) {
    let a = spu.ra(i).doublewords();
    let tested = a.map(|a| double::dftsv(a, i.immediate as u32));
    spu.set_rt(i, Quad::from_doublewords(tested));
}
