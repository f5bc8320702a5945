//! Floating point: calls the functions of [`crate::float`] on registers, and raises their flags in
//! the FPSCR.

use super::quad::Quad;
use super::spu::Spu;
use crate::float::fpscr::{Flags, Fpscr, Rounding};
use crate::float::single::Lanes;
use crate::float::{convert, double, estimate, ordinary, single};
use spu_isa::Instruction;
use std::array::from_fn;

/// The register fields of the single-precision instructions: few enough to be passed in a
/// register.
#[derive(Clone, Copy)]
struct Fields {
    rt: u8,
    ra: u8,
    rb: u8,
    rc: u8,
    immediate: i32,
}

impl From<Instruction> for Fields {
    #[inline]
    fn from(i: Instruction) -> Self {
        Self { rt: i.rt, ra: i.ra, rb: i.rb, rc: i.rc, immediate: i.immediate }
    }
}

/// Runs an instruction that has a special operand or result. It is kept out of the run loop, and
/// gets no argument that the loop would have to hold in memory.
#[cold]
#[inline(never)]
fn specially(spu: &mut Spu, i: Fields, f: impl FnOnce(&mut Spu, Fields)) {
    f(spu, i);
}

impl Spu {
    fn raise_and_set(&mut self, rt: u8, (values, flags): Lanes<4>) {
        self.fpscr.raise_single(flags);
        self.set_register(rt, Quad(values));
    }

    /// rt = f(ra, immediate). `ordinary` computes it if it can, else `full`.
    #[inline]
    fn single_unary(
        &mut self,
        i: Instruction,
        ordinary: impl Fn([u32; 4], i32) -> Option<[u32; 4]>,
        full: impl Fn([u32; 4], i32) -> Lanes<4>,
    ) {
        match ordinary(self.ra(i).0, i.immediate) {
            Some(values) => self.set_rt(i, Quad(values)),
            None => specially(self, i.into(), move |spu, i| {
                spu.raise_and_set(i.rt, full(spu.register(i.ra).0, i.immediate));
            }),
        }
    }

    /// rt = f(ra, rb). Works as [`single_unary`](Self::single_unary).
    #[inline]
    fn single_binary(
        &mut self,
        i: Instruction,
        ordinary: impl Fn([u32; 4], [u32; 4]) -> Option<[u32; 4]>,
        full: impl Fn([u32; 4], [u32; 4]) -> Lanes<4>,
    ) {
        match ordinary(self.ra(i).0, self.rb(i).0) {
            Some(values) => self.set_rt(i, Quad(values)),
            None => specially(self, i.into(), move |spu, i| {
                spu.raise_and_set(i.rt, full(spu.register(i.ra).0, spu.register(i.rb).0));
            }),
        }
    }

    /// rt = f(ra, rb, rc). Works as [`single_unary`](Self::single_unary).
    #[inline]
    fn single_ternary(
        &mut self,
        i: Instruction,
        ordinary: impl Fn([u32; 4], [u32; 4], [u32; 4]) -> Option<[u32; 4]>,
        full: impl Fn([u32; 4], [u32; 4], [u32; 4]) -> Lanes<4>,
    ) {
        match ordinary(self.ra(i).0, self.rb(i).0, self.rc(i).0) {
            Some(values) => self.set_rt(i, Quad(values)),
            None => specially(self, i.into(), move |spu, i| {
                spu.raise_and_set(
                    i.rt,
                    full(spu.register(i.ra).0, spu.register(i.rb).0, spu.register(i.rc).0),
                );
            }),
        }
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

fn split(lanes: [(u32, Flags); 4]) -> Lanes<4> {
    (lanes.map(|lane| lane.0), lanes.map(|lane| lane.1))
}

instructions! {
    fa(i): single_binary(ordinary::fa, single::fa_lanes);
    fs(i): single_binary(ordinary::fs, single::fs_lanes);
    fm(i): single_binary(ordinary::fm, single::fm_lanes);
    fma(i): single_ternary(ordinary::fma, single::fma_lanes);
    fms(i): single_ternary(ordinary::fms, single::fms_lanes);
    fnms(i): single_ternary(ordinary::fnms, single::fnms_lanes);
}

#[inline]
fn estimate(spu: &mut Spu, i: Instruction, f: impl Fn(u32) -> u32) {
    let Quad(a) = spu.ra(i);
    if a.map(estimate::divides_by_zero) != [false; 4] {
        specially(spu, i.into(), |spu, i| {
            let zeros = spu.register(i.ra).0.map(estimate::divides_by_zero);
            spu.fpscr.raise_divide_by_zero(zeros);
        });
    }
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

instructions! {
    fi(i): single_binary(ordinary::fi, |a, b| split(from_fn(|n| estimate::fi_flagged(a[n], b[n]))));
}

#[inline]
pub(super) fn csflt(spu: &mut Spu, i: Instruction) {
    spu.single_unary(i, ordinary::csflt, |a, scale| {
        split(a.map(|a| convert::csflt_flagged(a, scale)))
    });
}

#[inline]
pub(super) fn cuflt(spu: &mut Spu, i: Instruction) {
    spu.single_unary(i, ordinary::cuflt, |a, scale| {
        split(a.map(|a| convert::cuflt_flagged(a, scale)))
    });
}

instructions! {
    cflts(i): word_unary(|a| convert::cflts(a, i.immediate));
    cfltu(i): word_unary(|a| convert::cfltu(a, i.immediate));
    fceq(i): word_binary(single::fceq);
    fcmeq(i): word_binary(single::fcmeq);
    fcgt(i): word_binary(single::fcgt);
    fcmgt(i): word_binary(single::fcmgt);
    dfa(i): double_binary(double::dfa);
    dfs(i): double_binary(double::dfs);
    dfm(i): double_binary(double::dfm);
    dfma(i): double_accumulate(double::dfma);
    dfms(i): double_accumulate(double::dfms);
    dfnms(i): double_accumulate(double::dfnms);
    dfnma(i): double_accumulate(double::dfnma);
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

instructions! {
    dfceq(i): double_compare(double::dfceq);
    dfcmeq(i): double_compare(double::dfcmeq);
    dfcgt(i): double_compare(double::dfcgt);
    dfcmgt(i): double_compare(double::dfcmgt);
}

#[inline]
pub(super) fn dftsv(spu: &mut Spu, i: Instruction) {
    let a = spu.ra(i).doublewords();
    let tested = a.map(|a| double::dftsv(a, i.immediate as u32));
    spu.set_rt(i, Quad::from_doublewords(tested));
}
