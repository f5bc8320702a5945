//! Fuzz target `elf`: see `spu_fuzz_oracles::elf`.

#![no_main]

libfuzzer_sys::fuzz_target!(|input: &[u8]| spu_fuzz_oracles::elf(input));
