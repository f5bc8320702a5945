//! Fuzz target `gdb`: see `spu_fuzz_oracles::gdb`.

#![no_main]

libfuzzer_sys::fuzz_target!(|input: &[u8]| spu_fuzz_oracles::gdb(input));
