//! Arithmetic, multiplication, counting, logic, selection, shuffling, masks and gathers.

use super::quad::Quad;
use super::spu::Spu;
use spu_isa::Instruction;
use std::array::from_fn;

instructions! {
    a(i): word_binary(u32::wrapping_add);
    ah(i): halfword_binary(u16::wrapping_add);
    ai(i): word_unary(|a| a.wrapping_add_signed(i.immediate));
    ahi(i): halfword_unary(|a| a.wrapping_add(i.immediate as u16));
    sf(i): word_binary(|a, b| b.wrapping_sub(a));
    sfh(i): halfword_binary(|a, b| b.wrapping_sub(a));
    sfi(i): word_unary(|a| (i.immediate as u32).wrapping_sub(a));
    sfhi(i): halfword_unary(|a| (i.immediate as u16).wrapping_sub(a));
    addx(i): word_accumulate(|a, b, t| a.wrapping_add(b).wrapping_add(t & 1));
}

/// The carry out of `a + b + carry`.
#[inline]
const fn carry(a: u32, b: u32, carry: u32) -> u32 {
    ((a as u64 + b as u64 + carry as u64) >> 32) as u32
}

instructions! {
    cg(i): word_binary(|a, b| carry(a, b, 0));
    cgx(i): word_accumulate(|a, b, t| carry(a, b, t & 1));
    sfx(i): word_accumulate(|a, b, t| b.wrapping_add(!a).wrapping_add(t & 1));
    bg(i): word_binary(|a, b| carry(!a, b, 1));
    bgx(i): word_accumulate(|a, b, t| carry(!a, b, t & 1));
}

#[inline]
const fn signed_low(x: u32) -> i32 {
    x as i16 as i32
}

#[inline]
const fn signed_high(x: u32) -> i32 {
    x as i32 >> 16
}

#[inline]
const fn low(x: u32) -> u32 {
    x & 0xffff
}

#[inline]
const fn high(x: u32) -> u32 {
    x >> 16
}

instructions! {
    mpy(i): word_binary(|a, b| (signed_low(a) * signed_low(b)) as u32);
    mpyu(i): word_binary(|a, b| low(a) * low(b));
    mpyi(i): word_unary(|a| (signed_low(a) * i.immediate) as u32);
    mpyui(i): word_unary(|a| low(a) * low(i.immediate as u32));
    mpya(i): word_ternary(|a, b, c| c.wrapping_add_signed(signed_low(a) * signed_low(b)));
    mpyh(i): word_binary(|a, b| (high(a) * low(b)) << 16);
    mpys(i): word_binary(|a, b| ((signed_low(a) * signed_low(b)) >> 16) as u32);
    mpyhh(i): word_binary(|a, b| (signed_high(a) * signed_high(b)) as u32);
    mpyhhu(i): word_binary(|a, b| high(a) * high(b));
    mpyhha(i): word_accumulate(|a, b, t| t.wrapping_add_signed(signed_high(a) * signed_high(b)));
    mpyhhau(i): word_accumulate(|a, b, t| t.wrapping_add(high(a) * high(b)));
    clz(i): word_unary(u32::leading_zeros);
    cntb(i): byte_unary(|a| a.count_ones() as u8);
    avgb(i): byte_binary(|a, b| ((u16::from(a) + u16::from(b) + 1) >> 1) as u8);
    absdb(i): byte_binary(u8::abs_diff);
}

#[inline]
pub(super) fn sumb(spu: &mut Spu, i: Instruction) {
    let sum = |x: u32| -> u32 { x.to_be_bytes().map(u32::from).iter().sum() };
    spu.word_binary(i, |a, b| sum(b) << 16 | sum(a));
}

instructions! {
    xsbh(i): halfword_unary(|a| a as i8 as u16);
    xshw(i): word_unary(|a| a as i16 as u32);
}

#[inline]
pub(super) fn xswd(spu: &mut Spu, i: Instruction) {
    let doublewords = spu.ra(i).doublewords();
    spu.set_rt(i, Quad::from_doublewords(doublewords.map(|a| a as i32 as u64)));
}

instructions! {
    and(i): word_binary(|a, b| a & b);
    or(i): word_binary(|a, b| a | b);
    xor(i): word_binary(|a, b| a ^ b);
    nand(i): word_binary(|a, b| !(a & b));
    nor(i): word_binary(|a, b| !(a | b));
    eqv(i): word_binary(|a, b| !(a ^ b));
    andc(i): word_binary(|a, b| a & !b);
    orc(i): word_binary(|a, b| a | !b);
}

/// The immediate in both halves of a word.
#[inline]
const fn halfwords(i: Instruction) -> u32 {
    i.immediate as u16 as u32 * 0x0001_0001
}

/// The immediate in all bytes of a word.
#[inline]
const fn bytes(i: Instruction) -> u32 {
    i.immediate as u8 as u32 * 0x0101_0101
}

instructions! {
    andi(i): word_unary(|a| a & i.immediate as u32);
    ori(i): word_unary(|a| a | i.immediate as u32);
    xori(i): word_unary(|a| a ^ i.immediate as u32);
    andhi(i): word_unary(|a| a & halfwords(i));
    orhi(i): word_unary(|a| a | halfwords(i));
    xorhi(i): word_unary(|a| a ^ halfwords(i));
    andbi(i): word_unary(|a| a & bytes(i));
    orbi(i): word_unary(|a| a | bytes(i));
    xorbi(i): word_unary(|a| a ^ bytes(i));
}

#[inline]
pub(super) fn orx(spu: &mut Spu, i: Instruction) {
    let Quad([a, b, c, d]) = spu.ra(i);
    spu.set_rt(i, Quad::scalar(a | b | c | d));
}

instructions! {
    selb(i): word_ternary(|a, b, c| b & c | a & !c);
}

/// Which of eight words a control selects, and whether it selects a whole word.
#[inline]
const fn selected_word(control: u32) -> (usize, bool) {
    const FIRST: u32 = 0x0001_0203;
    let first_byte = control & 0x1c;
    let halves = first_byte | first_byte << 8;
    let whole = control.wrapping_sub(FIRST) == halves | halves << 16;
    (first_byte as usize / 4, whole)
}

/// Most controls select whole words. The others go to a separate function.
#[inline]
pub(super) fn shufb(spu: &mut Spu, i: Instruction) {
    let (Quad([a, b, c, d]), Quad([e, f, g, h])) = (spu.ra(i), spu.rb(i));
    let source = [a, b, c, d, e, f, g, h];
    let control = spu.rc(i);
    let words = control.0.map(selected_word);
    let result = if words.iter().all(|&(_, whole)| whole) {
        Quad(words.map(|(word, _)| source[word]))
    } else {
        shuffled_bytes(source, control)
    };
    spu.set_rt(i, result);
}

fn shuffled_bytes(source: [u32; 8], control: Quad) -> Quad {
    // Controls from 0x80 on yield constants. Those bytes come after the bytes of the source.
    const CONSTANTS: u32 = 0x0000_ff80;
    const FIRST_CONSTANT: u32 = 0x2020_2020;
    let mut bytes = [0; 64];
    for (bytes, word) in bytes.chunks_exact_mut(4).zip(source.into_iter().chain([CONSTANTS])) {
        bytes.copy_from_slice(&word.to_be_bytes());
    }
    let indices = control.0.map(|control| {
        let lowest = control >> 7 & 0x0101_0101;
        let constant = (lowest << 8).wrapping_sub(lowest);
        let selected = control & 0x1f1f_1f1f & !constant;
        let other = (FIRST_CONSTANT | control >> 5 & 0x0303_0303) & constant;
        selected | other
    });
    Quad(indices.map(|indices| {
        let select = |shift: u32| u32::from(bytes[(indices >> shift & 63) as usize]) << shift;
        select(24) | select(16) | select(8) | select(0)
    }))
}

#[inline]
pub(super) fn fsm(spu: &mut Spu, i: Instruction) {
    let bits = spu.ra(i).preferred();
    let words = from_fn(|lane| (bits >> (3 - lane) & 1).wrapping_neg());
    spu.set_rt(i, Quad(words));
}

#[inline]
pub(super) fn fsmh(spu: &mut Spu, i: Instruction) {
    let bits = spu.ra(i).preferred();
    let halfwords = from_fn(|lane| ((bits >> (7 - lane) & 1) as u16).wrapping_neg());
    spu.set_rt(i, Quad::from_halfwords(halfwords));
}

/// Spreads each of the lowest sixteen bits over a byte, the leftmost bit first.
#[inline]
pub(super) fn spread_over_bytes(bits: u32) -> Quad {
    let bytes = from_fn(|lane| ((bits >> (15 - lane) & 1) as u8).wrapping_neg());
    Quad::from_bytes(bytes)
}

#[inline]
pub(super) fn fsmb(spu: &mut Spu, i: Instruction) {
    spu.set_rt(i, spread_over_bytes(spu.ra(i).preferred()));
}

/// The lowest bits of the lanes as a number, the leftmost lane first.
#[inline]
fn gather(lanes: impl IntoIterator<Item = u32>) -> Quad {
    let bits = lanes.into_iter().fold(0, |bits, lane| bits << 1 | lane & 1);
    Quad::scalar(bits)
}

#[inline]
pub(super) fn gb(spu: &mut Spu, i: Instruction) {
    spu.set_rt(i, gather(spu.ra(i).0));
}

#[inline]
pub(super) fn gbh(spu: &mut Spu, i: Instruction) {
    spu.set_rt(i, gather(spu.ra(i).halfwords().map(u32::from)));
}

#[inline]
pub(super) fn gbb(spu: &mut Spu, i: Instruction) {
    spu.set_rt(i, gather(spu.ra(i).bytes().map(u32::from)));
}
