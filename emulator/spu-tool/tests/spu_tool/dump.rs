use std::fs;

use super::support::{Bench, assert_golden};

#[test]
fn a_program_is_taken_apart() {
    let bench = Bench::new();
    bench.program("mailboxes");
    let outcome = bench.spu(&["dump", "mailboxes.elf"]);
    assert_eq!((outcome.status, outcome.error.as_str()), (0, ""));
    assert_golden("mailboxes.dump", &bench.without_folder(&outcome.output));
}

#[test]
fn data_and_zeros_are_in_the_map() {
    let bench = Bench::new();
    bench.program("files");
    let outcome = bench.spu(&["dump", "--map", "files.elf"]);
    assert_eq!((outcome.status, outcome.error.as_str()), (0, ""));
    assert_golden("files.map", &bench.without_folder(&outcome.output));
}

#[test]
fn without_sections_the_segments_are_listed() {
    let bench = Bench::new();
    let program = bench.instructions(" il $3,1\n stop 0x2000");
    let mut image = fs::read(&program).unwrap();
    // e_shoff, e_shnum and e_shstrndx of a 32-bit file.
    image[32..36].fill(0);
    image[48..52].fill(0);
    bench.write("stripped", image);
    let outcome = bench.spu(&["dump", "stripped"]);
    assert_eq!(outcome.status, 0, "{}", outcome.error);
    assert!(outcome.output.contains("00000  40800083  il $3,1"), "{}", outcome.output);
}
