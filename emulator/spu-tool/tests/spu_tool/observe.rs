use std::path::Path;

use super::support::{Bench, assert_golden};

const LOOP: &str = "
        il      $3,3
again:  ai      $3,$3,-1
        stqd    $3,64($1)
        lqd     $4,64($1)
        brnz    $3,again
        stop    0x2000";

#[test]
fn a_trace_shows_what_each_instruction_wrote() {
    let bench = Bench::new();
    bench.run(&["--trace=trace"], &bench.instructions(LOOP), 0);
    assert_golden("loop.trace", &bench.read("trace"));
    let program = bench.program("hello");
    let outcome = bench.run(&["--trace"], &program, 42);
    assert!(outcome.error.contains("# library call: vprintf\n"), "{}", outcome.error);
    assert!(outcome.output.starts_with("hello"), "output and trace are apart");
}

#[test]
fn statistics_count_what_ran() {
    let bench = Bench::new();
    let program = bench.instructions(LOOP);
    bench.run(&["--stats=stats", "--json"], &program, 0);
    let stats: serde_json::Value = serde_json::from_str(&bench.read("stats")).unwrap();
    assert_eq!(stats["instructions"], 14);
    assert_eq!(stats["loads"], 3);
    assert_eq!(stats["stores"], 3);
    assert_eq!(stats["branches"]["run"], 3);
    assert_eq!(stats["branches"]["taken"], 2);
    assert_eq!(stats["classes"]["LS"], 6);
    assert_eq!(stats["classes"]["FX2"], 4);
    assert_eq!(stats["mnemonics"]["ai"], 3);
    let outcome = bench.run(&["--stats"], &program, 0);
    assert_golden("loop.stats", &outcome.error);
}

#[test]
fn statistics_count_transfers_and_calls() {
    let bench = Bench::new();
    let program = bench.program("dma");
    let options =
        ["--stats=stats", "--json", "--main-memory", "4K@0x60000000", "--arg", "0x60000000:64"];
    bench.run(&options, &program, 0);
    let stats: serde_json::Value = serde_json::from_str(&bench.read("stats")).unwrap();
    for kind in ["get", "put"] {
        assert_eq!(stats["dma"][kind]["commands"], 1);
        assert_eq!(stats["dma"][kind]["bytes"], 128);
    }
    bench.run(&["--stats=stats", "--json"], &bench.program("hello"), 42);
    let stats: serde_json::Value = serde_json::from_str(&bench.read("stats")).unwrap();
    assert_eq!(stats["library_calls"]["vprintf"], 1);
}

/// The figures of `--timing` as JSON. The program must exit with `status`.
fn timing(bench: &Bench, program: &Path, options: &[&str], status: i32) -> serde_json::Value {
    let options = [&["--timing=figures.json", "--json"], options].concat();
    bench.run(&options, program, status);
    serde_json::from_str(&bench.read("figures.json")).unwrap()
}

#[test]
fn timing_says_where_the_cycles_went() {
    let bench = Bench::new();
    // il issues in cycle 0 and its result is ready in cycle 2, that of the first product in cycle
    // 8. No instruction waits for the second product. So the operands cost 1 cycle for FX2 and 5
    // for FP6.
    let program = bench.instructions(
        "        il $3,1\n        fm $4,$3,$3\n        fm $5,$4,$4\n        stop 0x2000",
    );
    let figures = timing(&bench, &program, &[], 0);
    assert_eq!(figures["instructions"], 4);
    assert_eq!(figures["stalls"]["operand of FX2"], 1);
    assert_eq!(figures["stalls"]["operand of FP6"], 5);
    let counted = ["single_issue", "dual_issue"].map(|name| figures[name].as_u64().unwrap());
    let stalls = figures["stalls"].as_object().unwrap();
    let stalled: u64 = stalls.values().map(|cycles| cycles.as_u64().unwrap()).sum();
    assert_eq!(figures["cycles"], counted.iter().sum::<u64>() + stalled);
}

#[test]
fn timed_runs_repeat_and_count_simulated_time() {
    let bench = Bench::new();
    // A thousand taken branches without hints between two reads of the decrementer: each costs 20
    // cycles, including 2 for ai. A tick has 40 cycles. The number of ticks is the exit status.
    let program = bench.instructions(
        "        il $3,-1\n        wrch $ch7,$3\n        il $3,100\n        rdch $4,$ch8\n\
         again:  ai $3,$3,-1\n        brnz $3,again\n        rdch $5,$ch8\n        sf $5,$5,$4\n\
         ila $6,ticks\n        stqd $5,0($6)\n        stop 0x2000\n        .data\n        .align 4\n\
         ticks:  .space 16\n",
    );
    let first = timing(&bench, &program, &["--dump-ls=first"], 0);
    let second = timing(&bench, &program, &["--dump-ls=second"], 0);
    assert_eq!(first, second);
    let checked = timing(&bench, &program, &["--check"], 0);
    assert_eq!(first, checked);
    let outcome = bench.run(&["--check", "--engine=interpreter"], &program, 127);
    assert!(outcome.error.contains("--engine"), "{}", outcome.error);
    let bytes = |name| std::fs::read(bench.path(name)).unwrap();
    assert!(bytes("first") == bytes("second"));
    let misses = first["stalls"]["branch miss"].as_u64().unwrap();
    assert_eq!(misses, 99 * 18);
}

#[test]
fn timing_goes_with_transfers_and_library_calls_but_not_with_mailboxes() {
    let bench = Bench::new();
    let figures = timing(&bench, &bench.program("hello"), &[], 42);
    assert!(figures["instructions"].as_u64().unwrap() > 10);
    // A transfer from the program's own file takes time.
    let program = bench.instructions(
        "        il $3,0x4000\n        wrch $ch16,$3\n        il $4,0\n        wrch $ch17,$4\n\
         ilhu $5,0x1000\n        wrch $ch18,$5\n        il $6,128\n        wrch $ch19,$6\n\
         wrch $ch20,$4\n        il $7,0x40\n        wrch $ch21,$7\n        il $8,1\n\
         wrch $ch22,$8\n        il $8,2\n        wrch $ch23,$8\n        rdch $9,$ch24\n\
         stop 0x2000",
    );
    let figures = timing(&bench, &program, &[], 0);
    assert_eq!(figures["bytes_in"], 128);
    let waited = figures["stalls"]["DMA"].as_u64().unwrap();
    assert!(waited > 100, "{figures}");
    // The same from memory that is farther away.
    std::fs::write(bench.path("far.toml"), "[memory]\nget_latency = 1280\n").unwrap();
    let far = bench.path("far.toml").display().to_string();
    let figures = timing(&bench, &program, &["--machine", &far], 0);
    assert_eq!(figures["stalls"]["DMA"], waited + 1000);
    assert!(figures["blocked_by"]["tag"].as_u64().unwrap() > 100, "{figures}");

    bench.write("words", "1\n");
    let outcome = bench.run(&["--timing", "--in-mbox=words"], &program, 127);
    assert!(outcome.error.contains("--in-mbox"), "{}", outcome.error);
    let asleep = bench.instructions("        rdch $3,$ch29\n        stop 0x2000");
    let outcome = bench.run(&["--timing", "--patience=1"], &asleep, 125);
    assert!(outcome.error.contains("sleeps for ever"), "{}", outcome.error);
}
