//! Compares `shufb` with its byte-by-byte definition, for controls of whole words, of bytes and of
//! constants.

use super::machine::{Script, instruction, put};
use crate::prelude::*;
use std::array::from_fn;

fn model(a: Quad, b: Quad, control: Quad) -> Quad {
    let bytes = [a.bytes(), b.bytes()].concat();
    Quad::from_bytes(control.bytes().map(|control| match control {
        0x80..=0xbf => 0x00,
        0xc0..=0xdf => 0xff,
        0xe0..=0xff => 0x80,
        _ => bytes[usize::from(control & 0x1f)],
    }))
}

#[test]
fn shuffles_are_what_their_bytes_say() {
    let mut random = Random::new("shufb");
    let local_store = LocalStore::new();
    put(&local_store, 0, instruction(Op::Shufb, 0));
    let mut spu = Spu::new();
    for round in 0..rounds(50_000) {
        let [a, b]: [Quad; 2] = from_fn(|_| Quad(from_fn(|_| random.bits() as u32)));
        let whole = |n: u64| 0x0001_0203 + 0x0404_0404 * n as u32;
        let mut control = Quad(from_fn(|_| match round % 4 {
            0 => random.bits() as u32,
            1 => random.bits() as u32 & 0x1f1f_1f1f,
            _ => whole(random.below(8)),
        }));
        // A control that differs by one bit from one of whole words.
        if round % 4 == 3 {
            control.0[random.below(4) as usize] ^= 1 << random.below(32);
        }
        for (number, value) in (4..).zip([a, b, control]) {
            spu.set_register(number, value);
        }
        spu.set_pc(0);
        let stopped = spu.step(&local_store, &mut Script::default());
        assert_eq!(stopped, None);
        let expected = model(a, b, control);
        assert_eq!(spu.register(3), expected, "{a:08x?} {b:08x?} {control:08x?}");
    }
}
