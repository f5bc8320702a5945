//! `spu debug` with commands from standard input.

use std::path::Path;

use super::support::{Bench, Outcome};

/// Debugs a program with these options and commands.
fn debug(bench: &Bench, options: &[&str], program: &Path, commands: &str) -> Outcome {
    let mut arguments = vec!["debug"];
    arguments.extend(options);
    arguments.push(program.to_str().unwrap());
    bench.spu_with_input(&arguments, commands)
}

/// Whether the lines appear in this order. Each is a part of a line of the text.
fn assert_lines(text: &str, lines: &[&str]) {
    let mut rest = text.lines();
    for line in lines {
        assert!(rest.any(|found| found.contains(line)), "no {line} in order in\n{text}");
    }
}

#[test]
fn breakpoints_steps_and_frames() {
    let bench = Bench::new();
    let program = bench.program("calls");
    let commands = "
        break inner      # a comment
        breakpoints
        continue
        backtrace
        registers $3
        finish
        frame
        backtrace
        delete inner
        break outer+0x24
        delete outer+36
        next 4
        frame
        finish
        registers $3
        continue
        registers";
    let outcome = debug(&bench, &[], &program, commands);
    assert_eq!((outcome.status, outcome.error.as_str()), (7, ""));
    assert_lines(
        &outcome.output,
        &[
            "<_start>",
            "breakpoint at",
            "<inner>",
            "Breakpoint:",
            "<inner>             ",
            "#0 ",
            "#1 ",
            "#2 ",
            "#3 ",
            "$3    00000003",
            // The way out of the first call.
            "lqd $4,32($1)",
            "<outer+0x14>",
            "#0 ",
            "<main+0x14>",
            "<_start+0x18>",
            // Four further ones: the second call counts as one.
            "<outer+0x24>",
            "<main+0x14>",
            "$3    00000007",
            "The program has ended with status 7.",
        ],
    );
    let frames = "#0 0x";
    assert_eq!(outcome.output.matches(frames).count(), 2);
    assert!(!outcome.output.contains("(spu)"), "no prompt for a script");
    let again = debug(&bench, &[], &program, commands);
    assert_eq!(outcome.output, again.output);
}

#[test]
fn registers_and_local_store_are_read_and_changed() {
    let bench = Bench::new();
    let source = "
        fsmbi   $3,0xffff
        ila     $4,0x8000
        stqd    $3,0($4)
        lqd     $5,4($4)
        stop    0x2001
        stop    0x2002";
    let program = bench.instructions(source);
    let commands = "
        step
        set $3 1 2 3 0x3f800000
        set $3 = 5
        r $3
        r float $3
        next 2
        x 0x8000 5
        set 0x8004 -1
        info memory 0x8000 4
        dis $pc 2
        set $pc 0x14
        c";
    let outcome = debug(&bench, &[], &program, commands);
    assert_eq!((outcome.status, outcome.error.as_str()), (2, ""));
    assert_lines(
        &outcome.output,
        &[
            "$3    00000005 00000002 00000003 3f800000",
            "0             0             0             1",
            "0x08000: 00000005 00000002 00000003 3f800000",
            "0x08010: 00000000",
            "0x08000: 00000005 ffffffff 00000003 3f800000",
            "> 0x0000c",
            "  0x00010",
            "ended with status 2",
        ],
    );
}

#[test]
fn the_mfc_and_channels_are_shown() {
    let bench = Bench::new();
    let source = "
        ila     $3,0x1000
        wrch    $ch16,$3
        il      $4,0
        wrch    $ch17,$4
        ilhu    $5,0x6000
        wrch    $ch18,$5
        il      $6,256
        wrch    $ch19,$6
        il      $7,9
        wrch    $ch20,$7
        il      $8,0x40
        wrch    $ch21,$8
        wrch    $ch28,$8
        il      $9,0x200
        wrch    $ch22,$9
        il      $9,2
        wrch    $ch23,$9
        rdch    $9,$ch24
        stop    0x2000";
    let program = bench.instructions(source);
    let commands = "
        break 0x34
        c
        mfc
        channels
        cycles
        break 0x48
        c
        mfc
        cycles
        c";
    let memory = ["--main-memory", "64K@0x60000000"];
    let get = "get          256 bytes, local store 0x01000, effective address 0x60000000, tag 9";
    let simulated = debug(&bench, &[&memory[..], &["--timing"]].concat(), &program, commands);
    assert_eq!(simulated.status, 0);
    let seen = [
        get,
        "busy tags            9",
        "inbound mailbox      0 words",
        "outbound mailbox     1 word",
        " cycles",
        "no command is under way",
        "busy tags            none",
        "tag mask             9",
    ];
    assert_lines(&simulated.output, &seen);
    // Without simulated time, a command waits only if it is put off.
    let delayed = debug(&bench, &[&memory[..], &["--mfc", "at-last"]].concat(), &program, commands);
    assert_eq!((delayed.status, delayed.error.as_str()), (0, ""));
    assert_lines(&delayed.output, &[get, "cycles are counted in simulated time", "none"]);
    let at_once = debug(&bench, &memory, &program, commands);
    assert!(!at_once.output.contains(get));
}

#[test]
fn a_fault_can_be_looked_at() {
    let bench = Bench::new();
    let source = " il $3,77\n heqi $3,77\n stop 0x2000";
    let program = bench.instructions(source);
    let commands = "c\nr $3\nc\n";
    let outcome = debug(&bench, &[], &program, commands);
    assert_eq!(outcome.status, 120);
    assert_lines(
        &outcome.output,
        &["The program has failed: halt", "heqi", "$3    0000004d", "can't go on; quit ends"],
    );
}

#[test]
fn wrong_commands_change_nothing() {
    let bench = Bench::new();
    let program = bench.program("calls");
    let wrong = [
        ("contiune", "there is no command contiune; did you mean continue?"),
        ("break outre", "the program has no symbol outre; did you mean outer?"),
        ("break 0x40000", "0x40000 is beyond local store"),
        ("break 2", "0x2 is no address of an instruction"),
        ("delete main", "there is no breakpoint at"),
        ("step many", "many is no number"),
        ("registers $200", "$200 is no register"),
    ];
    for (command, message) in wrong {
        let outcome = debug(&bench, &[], &program, &format!("{command}\ncontinue\n"));
        assert_eq!(outcome.status, 7, "{command}");
        assert_lines(&outcome.output, &[message, "ended with status 7"]);
    }
    // The end of the commands ends the program, too.
    for commands in ["", "step 3\n", "quit\ncontinue\n"] {
        let outcome = debug(&bench, &[], &program, commands);
        assert_eq!((outcome.status, outcome.error.as_str()), (0, ""));
        assert!(!outcome.output.contains("ended"), "{}", outcome.output);
    }
    let outcome = debug(&bench, &["--gdb", "0"], &program, "");
    assert_eq!(outcome.status, 127);
    assert_eq!(outcome.error, "spu: --gdb does not go with spu debug; use spu run\n");
}

/// With commands in a file, standard input is the program's. Its output comes before the
/// output of later commands.
#[test]
fn commands_from_a_file() {
    let bench = Bench::new();
    let program = bench.program("sum");
    bench.write("commands", "continue\n");
    let outcome = {
        let arguments = ["debug", "--commands", "commands", program.to_str().unwrap()];
        bench.spu_with_input(&arguments, " 40\n-2 ")
    };
    assert_eq!((outcome.status, outcome.error.as_str()), (2, ""));
    assert_lines(&outcome.output, &["<_start>", "38", "ended with status 2"]);
}
