//! Fuzz target `dma`: see `spu_fuzz_oracles::dma`.

#![no_main]

libfuzzer_sys::fuzz_target!(|input: &[u8]| spu_fuzz_oracles::dma(input));
