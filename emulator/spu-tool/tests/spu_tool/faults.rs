use std::fs;

use proptest::prelude::*;

use super::support::Bench;

/// Checks that the program ends with this status and that standard error names the fault and the
/// place.
fn fault(source: &str, options: &[&str], status: i32, names: &[&str]) {
    let bench = Bench::new();
    let program = bench.instructions(source);
    let outcome = bench.run(options, &program, status);
    assert_eq!(outcome.output, "");
    for name in names {
        assert!(outcome.error.contains(name), "{name} in: {}", outcome.error);
    }
}

#[test]
fn each_fault_has_its_status() {
    fault(" il $3,5\nhere: heqi $3,5", &[], 120, &["halt", "0x00004 <here>", "heqi $0,$3,5"]);
    fault(" nop\n .long 0x00800000", &[], 121, &["invalid instruction 0x00800000", "<_start+0x4>"]);
    fault(" rdch $3,$ch100", &[], 122, &["rdch is not possible on channel 100"]);
    let command = " il $3,3\n wrch $ch19,$3\n il $4,0x40\n wrch $ch21,$4\n stop 0x2000";
    fault(command, &[], 123, &["DMA alignment", "3 bytes"]);
    let nowhere =
        " il $3,16\n wrch $ch19,$3\n wrch $ch18,$3\n il $4,0x40\n wrch $ch21,$4\n stop 0x2000";
    fault(nowhere, &[], 123, &["storage fault", "0x10"]);
    fault(" stop 0x123", &[], 124, &["stop 0x0123"]);
    fault(" stopd $3,$3,$3", &[], 124, &["0x3fff"]);
    fault("again: br again", &["--max-instructions", "1000"], 125, &["limit", "<again>"]);
}

#[test]
fn the_limit_counts_every_instruction() {
    let source = " il $3,1\n il $4,2\n stop 0x2000";
    fault(source, &["--max-instructions", "0"], 125, &["0x00000"]);
    fault(source, &["--max-instructions", "2"], 125, &["0x00008", "stop"]);
    let bench = Bench::new();
    bench.run(&["--max-instructions", "3"], &bench.instructions(source), 0);
    // Instructions before a library call count, too.
    let call = " ila $3,0x1000\n stop 0x2100\n .long 0x03001000\n stop 0x2000";
    let program = bench.instructions(call);
    bench.run(&["--max-instructions", "2"], &program, 125);
    bench.run(&["--max-instructions", "3"], &program, 0);
}

#[test]
fn unsupported_calls_are_named() {
    fault(" stop 0x2109\n nop", &[], 124, &["class 0x09", "stop 0x2109"]);
    fault(" stop 0x2100\n .long 0x2a000000", &[], 124, &["call 42", "C99", "1 to 41"]);
    fault(" stop 0x2101\n .long 0", &[], 124, &["call 0", "Posix", "1 to 68"]);
}

/// A program that closes standard error still gets its exit status.
#[test]
fn a_fault_without_standard_error() {
    let source = "
        ila     $3,0x1000
        il      $4,2
        stqd    $4,0($3)
        stop    0x2101
        .long   0x02001000
        heq     $3,$3";
    fault(source, &[], 120, &[]);
}

#[test]
fn a_program_that_sleeps_for_ever_is_ended() {
    fault(" nop\n rdch $3,$ch29", &[], 125, &["inbound mailbox", "no more words", "<_start+0x4>"]);
    // Nobody reads a mailbox without a file, in simulated time or not.
    for (channel, option) in [(28, "--out-mbox"), (30, "--out-intr-mbox")] {
        let twice = format!(" wrch $ch{channel},$3\n wrch $ch{channel},$3\n stop 0x2000");
        fault(&twice, &[], 125, &["mailbox is full", option, "<_start+0x4>"]);
    }
    fault(" rdch $3,$ch3", &["--patience", "0"], 125, &["sleeps for ever"]);
}

#[test]
fn unusable_files_are_named() {
    let bench = Bench::new();
    let program = bench.instructions(" stop 0x2000");
    let program = program.to_str().unwrap();
    bench.write("words", "1\n2 three\n");
    bench.write("large", "1 0x100000000");
    bench.write("data", [0; 100]);
    let cases: &[(&[&str], &[&str])] = &[
        (&["none.elf"], &["none.elf", "No such file"]),
        (&["--in-mbox", "words", program], &["words", "line 2", "three"]),
        (&["--in-mbox", "large", program], &["large", "32 bits"]),
        (&["--load-ls", "none@0", program], &["none"]),
        (&["--load-ls", "data@0x3fff0", program], &["data", "0x3fff0", "does not fit"]),
        (&["--load-mem", "data@0x9000", program], &["data", "0x9000"]),
        (&["--dump-mem", "out@0x9000:16", program], &["out", "0x9000"]),
        (&["--main-memory", "4K@0x10000000", program], &["0x10000000", "overlaps"]),
        (&["--main-memory", "4K", program], &["SIZE@EA"]),
        (&["--main-memory", "9G@0", program], &["4G"]),
        (&["--arg", "0x100000000", program], &[":64"]),
        (&["--arg", "seven", program], &["seven"]),
        (&["--out-mbox", "none/out", program], &["none/out"]),
        (&["--trace=none/trace", program], &["none/trace"]),
        (&["--json", program], &["--stats"]),
        (&["--arg", "1", program, "argument"], &["--arg"]),
        (&[], &["PROGRAM"]),
    ];
    for (arguments, names) in cases {
        let outcome = bench.spu(&[&["run"], *arguments].concat());
        assert_eq!(outcome.status, 127, "{arguments:?}: {}", outcome.error);
        for name in *names {
            let found = outcome.error.replace("do not fit", "does not fit");
            assert!(found.contains(name), "{name} in: {}", outcome.error);
        }
    }
}

#[test]
fn invalid_program_is_refused() {
    let bench = Bench::new();
    let program = bench.program("hello");
    let image = fs::read(&program).unwrap();
    bench.write("text", "not a program");
    bench.write("short", &image[..image.len() / 2]);
    let mut other = image.clone();
    other[19] = 21;
    bench.write("other", other);
    for verb in ["run", "dump"] {
        for (file, name) in
            [("text", "not an ELF file"), ("short", "damaged"), ("other", "machine 21")]
        {
            let outcome = bench.spu(&[verb, file]);
            assert_eq!(outcome.status, 126, "{}", outcome.error);
            assert!(
                outcome.error.contains(name) && outcome.error.contains(file),
                "{}",
                outcome.error
            );
        }
    }
}

#[test]
fn damaged_images_never_crash() {
    let bench = Bench::new();
    let image = fs::read(bench.program("hello")).unwrap();
    let mut runner = proptest::test_runner::TestRunner::new(ProptestConfig::with_cases(150));
    let changes = prop::collection::vec((0..image.len(), any::<u8>()), 1..8);
    let ran = runner.run(&changes, |changes| {
        let mut damaged = image.clone();
        for (at, byte) in changes {
            damaged[at] = byte;
        }
        bench.write("damaged", damaged);
        let dump = bench.spu(&["dump", "damaged"]);
        prop_assert!([0, 126, 127].contains(&dump.status), "{}", dump.error);
        prop_assert!(!dump.error.contains("panicked"), "{}", dump.error);
        let limits = ["run", "--max-instructions", "10000", "--patience", "1", "damaged"];
        let run = bench.spu(&limits);
        prop_assert!(!run.error.contains("panicked"), "{}", run.error);
        Ok(())
    });
    ran.unwrap();
}
