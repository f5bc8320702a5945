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
    assert!(
        outcome.error.contains("# library call: vprintf\n"),
        "{}",
        outcome.error
    );
    assert!(
        outcome.output.starts_with("hello"),
        "output and trace are apart"
    );
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
    let options = [
        "--stats=stats",
        "--json",
        "--main-memory",
        "4K@0x60000000",
        "--arg",
        "0x60000000:64",
    ];
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
