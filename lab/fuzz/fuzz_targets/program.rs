//! Fuzz target `program`: see `spu_fuzz_oracles::program`.

#![no_main]

libfuzzer_sys::fuzz_target!(|input: &[u8]| spu_fuzz_oracles::program(input));
