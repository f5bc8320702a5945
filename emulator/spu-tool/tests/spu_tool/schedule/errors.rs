//! Sources that can't be scheduled, and their error messages.

use std::fs;

use super::support::{Workshop, kernels, stderr, tools};

const START: &str = "        .include \"kernel.inc\"\nfunction f\n        il $3,1\n";
const END: &str = "        bi $lr\nendfunction f\n";

/// The messages for a function with this body.
fn messages(body: &str, status: i32) -> String {
    let shop = Workshop::new(&format!("{START}{body}{END}"));
    shop.assemble("plain.s", "plain.o");
    let output = shop.spu_schedule(&["plain.o", "plain.s"]);
    assert_eq!(output.status.code(), Some(status), "{}", stderr(&output));
    assert_eq!(output.stdout.is_empty(), status != 0);
    stderr(&output)
}

#[test]
fn faults_of_the_code_name_file_and_line() {
    for (body, expected) in [
        ("        il $3,1\n        .long 0x123\n", "plain.s:5: directive .long"),
        (
            "        .irp n,1\n        .endr\n        .ascii \"x\"\n        .skip 3\n",
            "plain.s:6: directive .ascii",
        ),
        ("        hbrr there,f\nthere:  brz $3,f\n", "plain.s:4: a branch hint"),
        ("        hbrp\n", "plain.s:4: a branch hint"),
        ("        lqr $3,f\n", "plain.s:4: it refers to 0x0"),
        ("        brz $3,f+12\n        il $3,1\n", ""),
    ] {
        let messages = messages(body, if expected.is_empty() { 0 } else { 127 });
        assert!(messages.contains(expected), "{body}: {messages}");
    }
}

#[test]
fn hints_of_drivers_need_a_branch_with_a_label() {
    for (body, status, expected) in [
        ("        hbrr there,f\nthere:  brz $3,f\n", 0, ""),
        ("        hbrp\n", 127, "plain.s:4: it refers to 0x4"),
    ] {
        let shop = Workshop::new(&format!("{START}{body}{END}"));
        shop.assemble("plain.s", "plain.o");
        let output = shop.spu_schedule(&["--driver", "plain.o", "plain.s"]);
        let messages = stderr(&output);
        assert_eq!(output.status.code(), Some(status), "{messages}");
        assert!(messages.contains(expected), "{body}: {messages}");
    }
}

#[test]
fn unpipelined_loops_are_named_with_reason() {
    for (body, reason) in [
        (
            "pass:   ai $4,$4,-1\n        brz $5,skip\n        a $6,$6,$4\nskip:   brnz $4,pass\n",
            "loop pass: not pipelined: it has several blocks",
        ),
        ("pass:   ai $4,$4,-2\n        brnz $4,pass\n", "not pipelined: it is not counted down"),
        (
            "pass:   ai $4,$4,-1\n        wrch $ch28,$5\n        brnz $4,pass\n",
            "not pipelined: `wrch` at line 5: no instruction may move past it",
        ),
        ("pass:   ai $4,$4,-1\n        brz $4,pass\n", "not pipelined: it is not counted down"),
    ] {
        let messages = messages(body, 0);
        assert!(messages.contains(reason), "{messages}");
        assert!(messages.starts_with("plain.s:"), "{messages}");
    }
}

#[test]
fn unsuitable_files_are_refused() {
    let good = format!("{START}        il $3,1\n{END}");
    let shop = Workshop::new(&good);
    shop.assemble("plain.s", "plain.o");
    let bare = tools().assemble_code(&[kernels()], &shop.path("bare.o"), &shop.path("plain.s"));
    bare.unwrap_or_else(|error| panic!("{error}"));
    fs::write(shop.path("other.s"), &good).unwrap();
    fs::write(shop.path("text.o"), "no object").unwrap();
    let broken = Workshop::new(
        "        .text\n        nop\n        .global f\n        .type f,@function\nf:\n        bi $lr\n        .size f,.-f\n",
    );
    broken.assemble("plain.s", "plain.o");
    let empty = Workshop::new("        .text\n        il $3,1\n");
    empty.assemble("plain.s", "plain.o");
    for (shop, arguments, expected) in [
        (&shop, ["none.o", "plain.s"], "none.o: "),
        (&shop, ["plain.o", "none.s"], "none.s: "),
        (&shop, ["text.o", "plain.s"], "text.o: not an ELF file"),
        (&shop, ["bare.o", "plain.s"], "bare.o: no line table: assemble with -g"),
        (&shop, ["plain.o", "other.s"], "does not name other.s"),
        (
            &broken,
            ["plain.o", "plain.s"],
            "plain.s:6: function f does not start at a multiple of 8",
        ),
        (&empty, ["plain.o", "plain.s"], "plain.o: no function"),
    ] {
        let output = shop.spu_schedule(&arguments);
        assert_eq!(output.status.code(), Some(127), "{arguments:?}");
        assert!(stderr(&output).contains(expected), "{}", stderr(&output));
        assert!(output.stdout.is_empty());
    }
}
