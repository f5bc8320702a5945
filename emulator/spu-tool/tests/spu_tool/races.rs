//! Reports of a DMA that nobody waits for, and of where a program's cycles go.

use super::support::Bench;

/// Gets a quadword with tag 3, and uses it.
fn program(wait: &str) -> String {
    format!(
        "
        ila     $3,0x1000
        wrch    $ch16,$3
        il      $4,0
        wrch    $ch17,$4
        ilhu    $5,0x6000
        wrch    $ch18,$5
        il      $6,16
        wrch    $ch19,$6
        il      $7,3
        wrch    $ch20,$7
        il      $8,0x40
        wrch    $ch21,$8
        {wait}
        .global use
use:    lqd     $3,0($3)
        rotmi   $3,$3,-24
        ceqi    $3,$3,0x2a
        brz     $3,1f
        stop    0x202a
1:      stop    0x2000
"
    )
}

const WAIT: &str = "
        il      $9,8
        wrch    $ch22,$9
        il      $9,2
        wrch    $ch23,$9
        rdch    $9,$ch24";

const OPTIONS: [&str; 4] = ["--main-memory", "64K@0x60000000", "--load-mem", "data@0x60000000"];

#[test]
fn a_missing_wait_shows() {
    let bench = Bench::new();
    bench.write("data", [0x2a; 16]);
    let options = |more: &[&'static str]| [&OPTIONS[..], more].concat();
    let assembled = |name: &str, wait: &str| {
        let source = format!("        .text\n        .global _start\n_start:{}", program(wait));
        bench.assemble(name, &source)
    };
    let [right, wrong] = [("right", WAIT), ("wrong", "")].map(|(name, wait)| assembled(name, wait));
    // Everything looks well where data moves at once.
    for program in [&right, &wrong] {
        let outcome = bench.run(&options(&[]), program, 0x2a);
        assert_eq!(outcome.error, "");
        bench.run(&options(&["--mfc", "at-once"]), program, 0x2a);
    }
    bench.run(&options(&["--mfc", "at-last"]), &right, 0x2a);
    bench.run(&options(&["--mfc", "at-last"]), &wrong, 0);
    for engine in ["interpreter", "compiler"] {
        let timed = options(&["--timing=figures", "--engine", engine]);
        assert_eq!(bench.run(&timed, &right, 0x2a).error, "");
        let warning = bench.run(&timed, &wrong, 0x2a).error;
        assert_eq!(warning.matches("warning").count(), 1, "{warning}");
        let parts = [
            "spu: warning: DMA race: at 0x00030 <use> (",
            "wrong.s:",
            "a load reads local store at 0x01000",
            "get still writes (16 bytes, local store 0x01000, effective address 0x60000000, tag 3)",
            "given at 0x0002c <_start+0x2c>",
            "First write 0x8 to MFC_WrTagMask",
        ];
        assert!(parts.iter().all(|part| warning.contains(part)), "{warning}");
    }
    // A policy for commands that take no time makes no sense in simulated time.
    let refused = bench.run(&options(&["--mfc", "at-last", "--timing"]), &right, 127);
    assert!(refused.error.contains("cannot be used with"), "{}", refused.error);
}

#[test]
fn a_run_is_profiled() {
    let bench = Bench::new();
    let program = bench.program("calls");
    let shown = bench.run(&["--profile"], &program, 7);
    assert_eq!(shown.output, "");
    for function in ["_start", "main", "outer", "inner"] {
        assert!(shown.error.contains(function), "{}", shown.error);
    }
    // In a file, it is what `spu profile` takes. Both show the same.
    let kept = bench.run(&["--profile=run.json"], &program, 7);
    assert_eq!(kept.error, "");
    let program = program.to_str().unwrap();
    let again = bench.spu(&["profile", program, "run.json"]);
    assert_eq!((again.status, again.output), (0, shown.error));
    let lines = bench.spu(&["profile", program, "run.json", "--lines"]);
    assert!(lines.output.contains("calls.s"), "{}", lines.output);
}
