//! Fuzz target `engines`: see `spu_fuzz_oracles::engines`.

#![no_main]

libfuzzer_sys::fuzz_target!(|input: &[u8]| {
    spu_fuzz_oracles::engines(input);
});
