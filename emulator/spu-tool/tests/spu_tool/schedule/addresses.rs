//! Loads and stores that move across the increments of their address, and kernels of several
//! passes: loops as a learner writes them, plain against scheduled.
//!
//! Provenance: `model`. The interpreter defines what the plain source does.

use std::fs;

use super::support::{DATA, Input, Workshop, compare};
use randomness::Random;

/// The middle of the data, from which every displacement leads to memory that is compared.
const MIDDLE: u32 = DATA + 0x8000;
/// More than overlap in any of these loops.
const MOST_PASSES: u32 = 14;

/// The function `f`: `body` is what a pass does between its label and its branch. It returns before
/// the loop if there are no passes, because a loop that counts down from 0 would not end.
fn looped(body: &[&str], after: &[&str]) -> String {
    let lines = |lines: &[&str]| -> String {
        let lines = lines.iter().map(|line| format!("        {line}\n"));
        lines.collect()
    };
    format!(
        "#   In      $3 x, $4 y, $5 a, $6 quadwords, $7 index\n#   Out     $3 $4 $7 $10\n        \
         .include \"kernel.inc\"\nfunction f\n        biz $6,$lr\nnext:\n{}        brnz $6,next\n{}        \
         bi $lr\nendfunction f\n",
        lines(body),
        lines(after)
    )
}

/// Schedules the loop, compares it with the plain one for each number of passes from 0 on, and
/// returns the message about it and the scheduled source.
fn same(source: &str, what: &str) -> (String, String) {
    same_from(0, source, what)
}

/// The same for loops that have at least `first` passes.
fn same_from(first: u32, source: &str, what: &str) -> (String, String) {
    let shop = Workshop::new(source);
    let messages = shop.schedule();
    let functions = ["f".to_owned()];
    let plain = shop.link("plain.s", &functions);
    let scheduled = shop.link("scheduled.s", &functions);
    let mut random = Random::new(what);
    for count in (first..=MOST_PASSES).chain([63, 64]) {
        let mut input = Input::default();
        for address in (DATA..DATA + 0x1_8000).step_by(16) {
            let quadword = [0; 4].map(|_| 0x3f00_0000 + random.below(0x0180_0000) as u32);
            input.memory.push((address, quadword));
        }
        let registers = [(3, MIDDLE), (4, MIDDLE + 0x4000), (5, 0x3fc0_0000), (6, count), (7, 0)];
        input.registers = registers.map(|(register, value)| (register, [value; 4])).to_vec();
        let (one, other) = (plain.call("f", &input), scheduled.call("f", &input));
        compare(&one, &other, &[3, 4, 7, 10], &format!("{what}, {count} passes"));
    }
    (messages, fs::read_to_string(shop.path("scheduled.s")).unwrap())
}

/// The scheduled instructions from `next:` up to the branch back, without notes.
fn kernel(scheduled: &str) -> Vec<&str> {
    let lines = scheduled.lines().skip_while(|line| *line != "next:").skip(1);
    let lines = lines.filter(|line| !line.ends_with(':'));
    let mut kernel = Vec::new();
    for line in lines {
        let code = line.split('#').next().unwrap_or_default().trim();
        kernel.push(code);
        if code.starts_with("brnz") {
            break;
        }
    }
    kernel
}

#[test]
fn saxpy_takes_four_cycles_a_pass() {
    let source = looped(
        &[
            "lqd $8,0($3)",
            "lqd $9,0($4)",
            "fma $9,$5,$8,$9",
            "stqd $9,0($4)",
            "ai $3,$3,16",
            "ai $4,$4,16",
            "ai $6,$6,-1",
        ],
        &["stqd $3,0x1000($4)"],
    );
    let (messages, scheduled) = same(&source, "saxpy");
    // Four even and four odd instructions: both pipes issue in each cycle.
    assert!(messages.contains("minimum 4, interval 4,"), "{messages}");
    assert!(messages.contains("copies 0, passes 2"), "{messages}");
    let kernel = kernel(&scheduled);
    assert_eq!(kernel.len(), 16, "{kernel:?}");
    let stores: Vec<_> = kernel.iter().filter(|line| line.starts_with("stqd")).collect();
    assert_eq!(stores.len(), 2);
    for store in stores {
        assert!(store.contains(",-") && store.ends_with("($4)"), "{store}");
    }
}

#[test]
fn saxpy_with_one_address_takes_four_cycles_a_pass() {
    let interleaved = looped(
        &[
            "lqd $8,0($4)",
            "lqd $9,16($4)",
            "fma $9,$5,$8,$9",
            "stqd $9,16($4)",
            "ai $4,$4,32",
            "ai $6,$6,-1",
        ],
        &[],
    );
    let indexed = looped(
        &[
            "lqx $8,$3,$7",
            "lqx $9,$4,$7",
            "fma $9,$5,$8,$9",
            "stqx $9,$4,$7",
            "ai $7,$7,16",
            "ai $6,$6,-1",
        ],
        &[],
    );
    for (source, what) in [(interleaved, "interleaved"), (indexed, "indexed")] {
        let (messages, _) = same(&source, what);
        assert!(messages.contains("interval 4,"), "{what}: {messages}");
    }
}

#[test]
fn a_loop_that_is_marked_has_one_pass_in_its_kernel() {
    let body = ["lqd $8,0($3)", "fa $8,$8,$5", "stqd $8,0($3)", "ai $3,$3,16", "ai $6,$6,-1"];
    let source = looped(&body, &[]);
    let marked = source.replace("brnz $6,next", "brnz $6,next # one pass: memory is short");
    let (several, _) = same(&source, "not marked");
    let (one, _) = same(&marked, "marked");
    let short = |message: &str| message.contains("interval 4,");
    assert!(short(&several) && !several.contains("passes 1"), "{several}");
    assert!(!short(&one) && one.contains("passes 1"), "{one}");
}

#[test]
fn a_loop_with_passes_enough_has_no_short_form() {
    let body = ["lqd $8,0($3)", "fa $8,$8,$5", "stqd $8,0($3)", "ai $3,$3,16", "ai $6,$6,-1"];
    let source = looped(&body, &[]);
    let stated = |passes: u32| {
        let comment = format!("brnz $6,next # at least {passes} passes: so it is called");
        same_from(passes, &source.replace("brnz $6,next", &comment), &format!("{passes} passes")).1
    };
    let (_, any) = same(&source, "any number of passes");
    assert!(any.contains("next_short:") && stated(2).contains("next_short:"));
    let enough = stated(8);
    assert!(!enough.contains("next_short:") && !enough.contains("too few passes"), "{enough}");
}

#[test]
fn displacements_stay_within_their_range() {
    let mut moved = 0;
    for step in [16, -16, 48, 496, -512] {
        for displacement in [-8192, -8176, -8144, -32, 0, 32, 8128, 8160, 8176] {
            let access = format!("{displacement}($4)");
            let source = looped(
                &[
                    &format!("lqd $8,{access}"),
                    "fma $9,$5,$8,$8",
                    "fma $9,$5,$9,$8",
                    &format!("stqd $9,{access}"),
                    "a $10,$10,$4",
                    &format!("ai $4,$4,{step}"),
                    "ai $6,$6,-1",
                ],
                &["stqd $4,0($3)"],
            );
            let what = format!("step {step}, displacement {displacement}");
            let (_, scheduled) = same(&source, &what);
            let kernel = kernel(&scheduled);
            moved += kernel
                .iter()
                .filter(|line| line.starts_with("lqd") || line.starts_with("stqd"))
                .filter(|line| !line.contains(&format!(",{displacement}(")))
                .count();
        }
    }
    assert!(moved > 20, "only {moved} accesses have moved");
}

#[test]
fn an_address_may_be_advanced_between_its_accesses() {
    let source = looped(
        &[
            "lqd $8,0($4)",
            "ai $4,$4,16",
            "lqd $9,-32($4)",
            "fma $9,$5,$8,$9",
            "ai $4,$4,-48",
            "fma $9,$5,$9,$8",
            "stqd $9,32($4)",
            "stqd $4,48($3)",
            "ai $4,$4,64",
            "ai $3,$3,32",
            "ai $6,$6,-1",
        ],
        &["lqd $10,-64($4)"],
    );
    same(&source, "several increments");
}

#[test]
fn access_with_unaligned_step_keeps_its_offset() {
    let source = looped(
        &["lqd $8,0($4)", "fma $9,$5,$8,$8", "stqd $9,0($4)", "ai $4,$4,20", "ai $6,$6,-1"],
        &[],
    );
    let (_, scheduled) = same(&source, "step 20");
    for line in kernel(&scheduled) {
        assert!(!line.contains("qd ") || line.contains(",0("), "{line}");
    }
}

#[test]
fn each_exit_of_a_kernel_of_several_passes_leads_on() {
    // The code after the loop is another loop, so that the drains can't contain it.
    let body = ["lqd $8,0($3)", "fa $8,$8,$5", "stqd $8,0($3)", "ai $3,$3,16", "ai $6,$6,-1"];
    let after = [
        "il $6,7",
        "again:",
        "lqd $9,0($4)",
        "fm $9,$9,$5",
        "fa $10,$9,$9",
        "stqd $9,0($4)",
        "ai $4,$4,16",
        "ai $6,$6,-1",
        "brnz $6,again",
    ];
    let (messages, scheduled) = same(&looped(&body, &after), "two loops");
    let several = messages.matches("passes 2").count() + messages.matches("passes 3").count();
    assert_eq!(several, 2, "{messages}");
    assert!(scheduled.contains("next_drain_2:"), "{scheduled}");
}
