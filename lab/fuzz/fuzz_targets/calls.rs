//! Fuzz target `calls`: see `spu_fuzz_oracles::calls`.

#![no_main]

libfuzzer_sys::fuzz_target!(|input: &[u8]| spu_fuzz_oracles::calls(input));
