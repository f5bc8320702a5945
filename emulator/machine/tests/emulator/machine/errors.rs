//! Tests that every broken rule of the MFC stops the SPU with the error for that rule.

use spu_emulator::memory::Access;
use spu_emulator::mfc::{DmaError, Policy};
use spu_emulator::stop::{Stop, Stopped};

use super::support::{BASE, Machine, run};

/// The error of a command with this opcode, local-store address, offset from the base, size and
/// tag.
fn error_of(policy: Policy, opcode: u32, lsa: u32, offset: u32, size: u32, tag: u32) -> DmaError {
    let source = format!(
        "
        ila     $4,{offset}
        a       $4,$4,$3
        command {opcode}, {lsa}, $4, {size}, {tag}
        set_channel 22, 0x3ffff
        set_channel 23, 2
        rdch    $10,$ch24
        stop    1
"
    );
    let machine = Machine::new();
    machine.memory.register(BASE + 0x5_0000, vec![0; 256], Access::ReadOnly).unwrap();
    let (spe, entry) = machine.loaded(policy, &source);
    match run(&spe, entry) {
        Stopped { reason: Stop::Dma(error), .. } => error,
        other => panic!("{opcode:#x} {lsa:#x} {offset:#x} {size} {tag}: {other}"),
    }
}

#[test]
fn alignment() {
    let cases = [
        (0x40, 0x10000, 0, 3, 0, "not 1, 2, 4, 8"),
        (0x40, 0x10000, 0, 24, 0, "not 1, 2, 4, 8"),
        (0x40, 0x10000, 0, 16400, 0, "16 KB"),
        (0x20, 0x10008, 8, 16, 0, "local-store address"),
        (0x20, 0x10000, 8, 16, 0, "effective address"),
        (0x20, 0x10002, 2, 4, 0, "effective address"),
        (0x20, 0x10004, 8, 4, 0, "low 4 bits"),
        (0xa0, 0x10000, 0, 8, 0, "sndsig"),
        (0x44, 0x10000, 0, 12, 0, "list size"),
        (0x44, 0x10000, 4, 8, 0, "list's address"),
        (0x44, 0x10000, 0, 16392, 0, "2048 elements"),
    ];
    for (opcode, lsa, offset, size, tag, text) in cases {
        let error = error_of(Policy::AtOnce, opcode, lsa, offset, size, tag);
        let DmaError::Alignment { what, command, .. } = error else {
            panic!("{error}");
        };
        assert!(what.contains(text), "{what} / {text}");
        assert_eq!(u32::from(command), opcode);
    }
}

#[test]
fn invalid_commands() {
    let cases = [
        (0x00, 0, "opcode"),
        (0x43, 0, "opcode"),
        (0xff, 0, "opcode"),
        (0x0140, 0, "upper half"),
        (0x28, 0, "start"),
        (0x4a, 0, "start"),
        (0x40, 32, "tag"),
    ];
    for (opcode, tag, text) in cases {
        let error = error_of(Policy::AtOnce, opcode, 0x10000, 0, 16, tag);
        let DmaError::InvalidCommand { what, command } = error else {
            panic!("{error}");
        };
        assert!(what.contains(text), "{what} / {text}");
        assert_eq!(command, opcode);
    }
}

#[test]
fn an_unknown_tag_condition_is_invalid() {
    let (spe, entry) = Machine::new().loaded(Policy::AtOnce, "set_channel 23, 3\n stop 1\n");
    let stopped = run(&spe, entry);
    assert!(
        matches!(stopped.reason, Stop::Dma(DmaError::InvalidCommand { command: 3, .. })),
        "{stopped}"
    );
}

#[test]
fn storage_faults_name_the_address() {
    // A read from where there is no memory, a read across the end, and a write to read-only
    // memory. Then the same with atomic commands.
    let cases = [
        (0x40, 0x8_0000_u32 >> 1 | 0x2_0000, 16, 0x6_0000),
        (0x40, 0x3_fff0, 32, 0x4_0000),
        (0x20, 0x5_0000, 16, 0x5_0000),
        (0xd0, 0x4_5000, 128, 0x4_5000),
        (0xb0, 0x5_0000, 128, 0x5_0000),
    ];
    for policy in [Policy::AtOnce, Policy::AtLast] {
        for (opcode, offset, size, fault) in cases {
            // ila takes 18 bits, but these offsets may have 19.
            let low = offset & 0x3_fff0;
            let high = offset - low;
            let source = format!(
                "
        ila     $4,{low}
        ilhu    $5,{high}>>16
        a       $4,$4,$5
        a       $4,$4,$3
        command {opcode}, 0x10000, $4, {size}, 0
        wait_tags 1
        stop    1
"
            );
            let machine = Machine::new();
            machine.memory.register(BASE + 0x5_0000, vec![0; 256], Access::ReadOnly).unwrap();
            let (spe, entry) = machine.loaded(policy, &source);
            let stopped = run(&spe, entry);
            let Stop::Dma(DmaError::Storage { ea, command, .. }) = stopped.reason else {
                panic!("{opcode:#x} {offset:#x}: {stopped}");
            };
            assert_eq!(ea, BASE + fault, "{opcode:#x}");
            assert_eq!(u32::from(command), opcode);
        }
    }
}

#[test]
fn an_error_of_the_last_transfers_is_not_lost() {
    let source = "
        il      $4,0
        command PUT, 0x10000, $4, 16, 0
        stop    1
";
    let (spe, entry) = Machine::new().loaded(Policy::AtLast, source);
    let stopped = run(&spe, entry);
    assert!(matches!(stopped.reason, Stop::Dma(DmaError::Storage { .. })), "{stopped}");
}

#[test]
fn the_message_says_where_and_what() {
    let error = error_of(Policy::AtOnce, 0x40, 0x10000, 8, 16, 0);
    let text = error.to_string();
    for part in ["alignment", "0x40", "0x10000", "0x340000008", "16 bytes"] {
        assert!(text.contains(part), "{text}");
    }
}
