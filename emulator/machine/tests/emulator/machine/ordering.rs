//! Fences and barriers, with `Policy::AtLast`, which runs the newest command first.

use spu_emulator::mfc::Policy;

use super::support::{Machine, run_to_stop};

/// Puts the words 1, 2, 3 to the same address with the given commands, and returns the word that
/// remains.
fn last_of(commands: [&str; 3]) -> u32 {
    let mut source = String::new();
    for (n, command) in commands.iter().enumerate() {
        source += &format!("        command {command}, {}\n", n * 16 + 0x10000);
    }
    // Opcode and tag come first in the macro below, so that a case is short.
    let source = format!(
        "
        .purgem command
        .macro  command opcode, tag, lsa
        set_channel 16, \\lsa
        wrch    $ch17,$2
        wrch    $ch18,$3
        set_channel 19, 16
        set_channel 20, \\tag
        set_channel 21, \\opcode
        .endm
{source}
        set_channel 22, -1 & 0x3ffff
        set_channel 23, 2
        rdch    $10,$ch24
        stop    1
"
    );
    let machine = Machine::new();
    let (spe, entry) = machine.loaded(Policy::AtLast, &source);
    for n in 1..=3_u8 {
        let at = 0x10000 + (u32::from(n) - 1) * 16;
        spe.local_store().write(at, &[0, 0, 0, n]);
    }
    assert_eq!(run_to_stop(&spe, entry), 1);
    machine.word(0)
}

#[test]
fn without_order_the_oldest_comes_last() {
    assert_eq!(last_of(["PUT, 1", "PUT, 1", "PUT, 1"]), 1);
    assert_eq!(last_of(["PUT, 1", "PUT, 2", "PUT, 3"]), 1);
}

#[test]
fn a_fence_comes_after_the_earlier_ones_of_its_tag() {
    assert_eq!(last_of(["PUT, 1", "PUT, 1", "PUTF, 1"]), 3);
    // The third command may run before the fence's predecessors.
    assert_eq!(last_of(["PUT, 1", "PUTF, 1", "PUT, 1"]), 2);
    // The fence does not apply to other tags.
    assert_eq!(last_of(["PUT, 1", "PUT, 2", "PUTF, 2"]), 1);
}

#[test]
fn a_barrier_also_holds_back_the_later_ones_of_its_tag() {
    assert_eq!(last_of(["PUT, 1", "PUTB, 1", "PUT, 1"]), 2);
    assert_eq!(last_of(["PUT, 1", "PUT, 1", "PUTB, 1"]), 3);
    assert_eq!(last_of(["PUT, 1", "PUTB, 1", "PUTF, 1"]), 3);
    assert_eq!(last_of(["PUT, 1", "PUTB, 2", "PUT, 2"]), 1);
}

#[test]
fn the_barrier_command_orders_every_tag() {
    assert_eq!(last_of(["PUT, 1", "BARRIER, 2", "PUT, 3"]), 3);
    assert_eq!(last_of(["PUT, 1", "MFCSYNC, 3", "PUT, 3"]), 3);
    assert_eq!(last_of(["PUT, 1", "MFCSYNC, 3", "PUT, 2"]), 1);
}
