//! `spu profile` as a command: tables, listing, exit status, messages.

use std::fs;
use std::sync::Arc;

use spu_build::for_tests::build_source;
use spu_emulator::elf::Image;
use spu_emulator::machine::Machine;
use spu_emulator::memory::RegisteredMemory;
use spu_emulator::profile::ProgramId;
use spu_emulator::simulated::{CYCLES_PER_SECOND, SimulationOptions, Timing};
use spu_emulator::spe::{Config, Spe};
use spu_reports::ProfileFile;

use super::support::{Bench, Outcome};

const SOURCE: &str = "        .globl _start
        .type _start,@function
_start: il $5,3
again:  brsl $0,inner
        ai $5,$5,-1
        brnz $5,again
        stop 0x2000
        .size _start,.-_start
        .type inner,@function
inner:  fa $6,$6,$6     # a sum
        fa $6,$6,$6
        bi $0
        .size inner,.-inner
        .type never,@function
never:  stop 0
        .size never,.-never
";

/// A folder with a program and the profile of its run.
fn profiled() -> Bench {
    let bench = Bench::new();
    let bytes = fs::read(build_source(SOURCE, "calls", bench.folder.path(), &[])).unwrap();
    let options = SimulationOptions { profile: true, ..SimulationOptions::default() };
    let memory = Arc::new(RegisteredMemory::new());
    let machine = Machine::simulated_with(memory, Timing::default(), options);
    let spe = Spe::new(&machine, Config::default());
    let image = Image::parse(&bytes).unwrap();
    image.load(spe.local_store(), 0);
    spe.profile_as(ProgramId::of(&bytes));
    spe.run(image.entry());
    let profile = machine.simulation().unwrap().profile().unwrap();
    let text = serde_json::to_vec(&ProfileFile::new(CYCLES_PER_SECOND, &profile)).unwrap();
    bench.write("run.json", text);
    bench
}

fn profile(within: &Bench, arguments: &[&str]) -> Outcome {
    within.spu(&[&["profile"], arguments].concat())
}

fn shown(within: &Bench, arguments: &[&str]) -> String {
    let shown = profile(within, &[&["program", "run.json"], arguments].concat());
    assert_eq!((shown.status, shown.error.as_str()), (0, ""));
    shown.output
}

/// The words of the first line that ends like this.
fn row<'t>(text: &'t str, end: &str) -> Vec<&'t str> {
    let line = text.lines().find(|line| line.ends_with(end));
    let line = line.unwrap_or_else(|| panic!("{end}: {text}"));
    line.split_whitespace().collect()
}

#[test]
fn functions_are_told_with_their_calls() {
    let bench = profiled();
    let text = shown(&bench, &[]);
    // il, which pairs with brsl the first time: 1. brsl: 2 and three misses. ai: 3. brnz: 3, each
    // after one cycle of waiting for ai's result, and two misses. stop: 1.
    assert_eq!(row(&text, " _start")[..4], ["103", "57.9%", "1", "103.0"]);
    // In each of three passes: fa 1, then fa 6 to wait for the result of the first, then bi as its
    // pair, and a miss.
    assert_eq!(row(&text, " inner")[..4], ["75", "42.1%", "3", "25.0"]);
    assert!(!text.contains("never"), "{text}");
    let first = text.lines().next().unwrap();
    assert!(first.starts_with("all: "), "{first}");
}

#[test]
fn the_listing_shows_every_instruction_with_its_line() {
    let bench = profiled();
    let text = shown(&bench, &["--function", "inner"]);
    let sum = row(&text, "inner: fa $6,$6,$6 # a sum");
    assert_eq!(sum[..4], ["3", "4.0%", "3", "1.00"]);
    assert!(sum.contains(&"sources/calls.s:10"), "{text}");
    let back = row(&text, " bi $0");
    assert_eq!(back[..5], ["54", "72.0%", "3", "18.00", "100%"]);
    assert!(text.contains("3 calls, "), "{text}");
    let refused = profile(&bench, &["program", "run.json", "--function", "never"]);
    assert_eq!(refused.status, 127);
    assert!(refused.error.contains("no function never"), "{}", refused.error);
}

#[test]
fn lines_and_json_have_the_same_cycles() {
    let bench = profiled();
    let json: serde_json::Value = serde_json::from_str(&shown(&bench, &["--json"])).unwrap();
    let cycles = |value: &serde_json::Value| value["total"]["cycles"].as_u64().unwrap();
    let all = json["total"]["cycles"].as_u64().unwrap();
    for part in ["functions", "lines"] {
        let parts = json[part].as_array().unwrap();
        assert_eq!(parts.iter().map(cycles).sum::<u64>(), all, "{part}");
        // The most expensive come first.
        assert!(parts.is_sorted_by_key(|part| std::cmp::Reverse(cycles(part))));
    }
    let text = shown(&bench, &["--lines"]);
    let shown = text.lines().skip(1).map(|line| {
        let cycles = line.split_whitespace().next().unwrap();
        cycles.parse::<u64>().unwrap()
    });
    assert_eq!(shown.sum::<u64>(), all);
}

#[test]
fn damaged_profiles_and_other_programs_are_refused() {
    let bench = profiled();
    let whole = bench.read("run.json");
    let damaged = |from: &str, to: &str| {
        assert!(whole.contains(from), "{from}: {whole}");
        whole.replacen(from, to, 1)
    };
    for (text, expected) in [
        (String::new(), "not a profile: "),
        ("{}".into(), "not a profile: missing field"),
        (damaged("\"cycles\":", "\"cycles\":1"), "not the sum"),
        (damaged("\"issued\":3", "\"issued\":4"), "not the sum"),
        (damaged("\"joined\":0", "\"joined\":9"), "not the sum"),
        (damaged("branch miss", "bad luck"), "unknown cause \"bad luck\""),
        (damaged("\"address\":", "\"address\":9999999"), "address 0x"),
        (damaged("\"word\":", "\"word\":-"), "not a profile: "),
        (damaged("\"program\":\"", "\"program\":\"x"), "not a profile: "),
        (damaged("\"program\":\"", "\"program\":\"0"), "not a profile"),
    ] {
        bench.write("damaged.json", &text);
        let output = profile(&bench, &["program", "damaged.json"]);
        assert_eq!(output.status, 127, "{text}");
        let message = output.error;
        assert!(
            message.starts_with("spu: damaged.json: ") && message.contains(expected),
            "{expected}: {message}"
        );
    }
    for (arguments, expected) in [
        (["nothing", "run.json"], "nothing: "),
        (["program", "nothing"], "nothing: "),
        (["run.json", "run.json"], "run.json: not an ELF file"),
    ] {
        let output = profile(&bench, &arguments);
        assert_eq!(output.status, 127);
        let message = output.error;
        assert!(message.contains(expected), "{message}");
    }
}
