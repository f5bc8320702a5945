//! Sources that are used without the SPU binutils.

use crate::support::Bench;

const SOURCE: &str = "        .text
        .global _start
_start: ila     $3,values
        lqd     $4,0($3)
        ai      $3,$4,37
        stop    0x2005

        .data
        .align  4
values: .long   5,6,7,8
";

#[test]
fn a_source_runs_and_is_timed_as_it_is() {
    let bench = Bench::new();
    bench.write("five.s", SOURCE);
    for arguments in [&["asm", "five.s"][..], &["asm", "--program", "five.s"]] {
        let outcome = bench.spu(arguments);
        assert_eq!((outcome.status, outcome.error.as_str()), (0, ""));
    }
    let [source, program] =
        ["five.s", "five.elf"].map(|file| bench.spu(&["run", "--dump-regs", file]));
    assert_eq!((source.status, program.status), (5, 5), "{}", source.error);
    assert!(source.error.contains("0000002a") || source.output.contains("0000002a"));
    assert_eq!(source.output, program.output);
    let [source, object] = ["five.s", "five.o"].map(|file| bench.spu(&["time", file]).output);
    assert_eq!(source, object);
    assert!(source.contains("ai\t") || source.contains("ai "), "{source}");
    let dump = bench.spu(&["dump", "five.s"]);
    assert!(dump.output.contains("_start"), "{}{}", dump.output, dump.error);
}

#[test]
fn errors_of_a_source_name_its_line() {
    let bench = Bench::new();
    bench.write("wrong.s", "        nop\n        aii     $3,$3,1\n");
    for command in ["asm", "run", "debug", "time", "dump"] {
        let outcome = bench.spu(&[command, "wrong.s"]);
        assert_eq!(outcome.status, 127);
        let expected = "spu: wrong.s:2:9: there is no instruction aii; did you mean ai?\n";
        assert_eq!(outcome.error, expected, "{command}");
    }
    bench.write("macro.s", "        .macro m\n        .endm\n");
    assert!(bench.spu(&["asm", "macro.s"]).error.contains("SPU binutils"));
}
