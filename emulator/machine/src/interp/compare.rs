//! Integer compares. A lane of the result is all ones if true, all zeros if false.

use super::spu::Spu;
use spu_isa::Instruction;

#[inline]
const fn word(condition: bool) -> u32 {
    (condition as u32).wrapping_neg()
}

#[inline]
const fn halfword(condition: bool) -> u16 {
    (condition as u16).wrapping_neg()
}

#[inline]
const fn byte(condition: bool) -> u8 {
    (condition as u8).wrapping_neg()
}

instructions! {
    ceq(i): word_binary(|a, b| word(a == b));
    ceqh(i): halfword_binary(|a, b| halfword(a == b));
    ceqb(i): byte_binary(|a, b| byte(a == b));
    ceqi(i): word_unary(|a| word(a == i.immediate as u32));
    ceqhi(i): halfword_unary(|a| halfword(a == i.immediate as u16));
    ceqbi(i): byte_unary(|a| byte(a == i.immediate as u8));
    cgt(i): word_binary(|a, b| word(a as i32 > b as i32));
    cgth(i): halfword_binary(|a, b| halfword(a as i16 > b as i16));
    cgtb(i): byte_binary(|a, b| byte(a as i8 > b as i8));
    cgti(i): word_unary(|a| word(a as i32 > i.immediate));
    cgthi(i): halfword_unary(|a| halfword(a as i16 > i.immediate as i16));
    cgtbi(i): byte_unary(|a| byte(a as i8 > i.immediate as i8));
    clgt(i): word_binary(|a, b| word(a > b));
    clgth(i): halfword_binary(|a, b| halfword(a > b));
    clgtb(i): byte_binary(|a, b| byte(a > b));
    clgti(i): word_unary(|a| word(a > i.immediate as u32));
    clgthi(i): halfword_unary(|a| halfword(a > i.immediate as u16));
    clgtbi(i): byte_unary(|a| byte(a > i.immediate as u8));
}
