//! Replays the seeds of the fuzz targets. An input that once found a fault or reached new code
//! stays a test on every machine, without a fuzzer.

use std::fs;
use std::ops::Range;
use std::path::Path;

use rand::{Rng as _, SeedableRng as _};
use rand_chacha::ChaCha8Rng;

fn replay(target: &str, oracle: fn(&[u8])) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../corpus").join(target);
    let mut seeds: Vec<_> =
        fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().path()).collect();
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

#[test]
fn both_engines() {
    replay("engines", |input| {
        crate::engines(input);
    });
}

/// The seeds of `count` random inputs, times `CELLRAY_TEST_ROUNDS`, from `SPU_FUZZ_SEED` on.
fn seeds(count: u32) -> Range<u64> {
    let first = std::env::var("SPU_FUZZ_SEED").map_or(0, |seed| seed.parse().unwrap());
    first..first + u64::from(randomness::rounds(count))
}

fn random_inputs(count: u32, oracle: fn(&[u8]), input: fn(&mut ChaCha8Rng) -> Vec<u8>) {
    for seed in seeds(count) {
        let input = input(&mut ChaCha8Rng::seed_from_u64(seed));
        let run = std::panic::catch_unwind(|| oracle(&input));
        assert!(run.is_ok(), "SPU_FUZZ_SEED={seed} panics");
    }
}

/// Most packets are well-formed, and one input in eight is arbitrary bytes.
#[test]
fn debuggers() {
    random_inputs(100, crate::gdb, |random| {
        let mut input = vec![0; random.random_range(1..400)];
        random.fill(&mut input[..]);
        input[0] = random.random_ratio(7, 8).into();
        input
    });
}

/// Most words are small, so that they point to the input, or are the numbers of streams.
#[test]
fn library_calls() {
    random_inputs(1500, crate::calls, |random| {
        let mut input: Vec<u8> = Vec::new();
        for _ in 0..64 {
            input.push(random.random());
            input.extend((0..63).map(|at| match at % 16 {
                0 | 1 => 0,
                2 => random.random_range(0..4),
                3 if random.random() => random.random_range(0..8),
                3 => random.random(),
                _ if random.random_ratio(1, 8) => random.random(),
                _ => *b"%dslc[-].*09xafn ".get(random.random_range(0..24)).unwrap_or(&0),
            }));
        }
        input
    });
}

/// Programs that nobody has kept.
#[test]
fn both_engines_on_random_programs() {
    let (mut executed, mut compiled) = (0, 0);
    for seed in seeds(300) {
        let input = seed.to_be_bytes();
        let run = std::panic::catch_unwind(|| crate::engines(&input));
        let (all, some) = run.unwrap_or_else(|_| panic!("SPU_FUZZ_SEED={seed} differs"));
        (executed, compiled) = (executed + all, compiled + some);
    }
    // Elsewhere there is one engine.
    assert!(compiled > executed / 10 || cfg!(not(target_arch = "x86_64")));
}
