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

#[inline]
pub(super) fn fa(spu: &mut Spu, i: Instruction) {
    spu.single_binary(i, ordinary::fa, single::fa_lanes);
}

#[inline]
pub(super) fn fs(spu: &mut Spu, i: Instruction) {
    spu.single_binary(i, ordinary::fs, single::fs_lanes);
}

#[inline]
pub(super) fn fm(spu: &mut Spu, i: Instruction) {
    spu.single_binary(i, ordinary::fm, single::fm_lanes);
}

#[inline]
pub(super) fn fma(spu: &mut Spu, i: Instruction) {
    spu.single_ternary(i, ordinary::fma, single::fma_lanes);
}

#[inline]
pub(super) fn fms(spu: &mut Spu, i: Instruction) {
    spu.single_ternary(i, ordinary::fms, single::fms_lanes);
}

#[inline]
pub(super) fn fnms(spu: &mut Spu, i: Instruction) {
    spu.single_ternary(i, ordinary::fnms, single::fnms_lanes);
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

#[inline]
pub(super) fn fi(spu: &mut Spu, i: Instruction) {
    spu.single_binary(i, ordinary::fi, |a, b| split(from_fn(|n| estimate::fi_flagged(a[n], b[n]))));
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
