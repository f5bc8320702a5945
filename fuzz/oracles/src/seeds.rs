//! Replays the seeds of the fuzz targets. An input that once found a fault or reached new code
//! stays a test on every machine, without a fuzzer.

use std::fs;
use std::path::Path;

fn replay(target: &str, oracle: fn(&[u8])) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../corpus")
        .join(target);
    let mut seeds: Vec<_> = fs::read_dir(&folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .collect();
    seeds.sort();
    assert!(!seeds.is_empty(), "no seeds in {}", folder.display());
    for seed in seeds {
        println!("{}", seed.display());
        oracle(&fs::read(&seed).unwrap());
    }
}

#[test]
fn programs() {
    replay("program", crate::program);
}

#[test]
fn dma_commands() {
    replay("dma", crate::dma);
}

#[test]
fn elf_files() {
    replay("elf", crate::elf);
}
