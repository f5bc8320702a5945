//! Fuzz target `dma`: see `oracles::dma`.

#![no_main]

#[allow(dead_code, reason = "each target uses one of the oracles")]
#[path = "../oracles.rs"]
mod oracles;

libfuzzer_sys::fuzz_target!(|input: &[u8]| oracles::dma(input));
