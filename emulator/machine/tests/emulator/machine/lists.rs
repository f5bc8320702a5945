//! DMA lists: gathering, small elements, stall-and-notify.

use crate::prelude::*;

const POLICIES: [Policy; 2] = [Policy::AtOnce, Policy::AtLast];
const STALL: u32 = 0x8000_0000;

/// Writes a list of (first word, offset from [`BASE`]) at local-store address 0x8000.
fn list(spe: &spu_emulator::spe::Spe, elements: &[(u32, u32)]) {
    for (n, &(first, offset)) in elements.iter().enumerate() {
        let mut bytes = [0; 8];
        bytes[..4].copy_from_slice(&first.to_be_bytes());
        bytes[4..].copy_from_slice(&(BASE as u32 + offset).to_be_bytes());
        spe.local_store().write(0x8000 + n as u32 * 8, &bytes);
    }
}

#[test]
fn a_list_scatters_two_thousand_elements() {
    let source = "
        ila     $4,0x8000
        command PUTL, 0x10000, $4, 2048*8, 31
        set_channel 22, 0
        ilhu    $70,0x8000
        wrch    $ch22,$70
        set_channel 23, 2
        rdch    $10,$ch24
        stop    1
";
    let machine = Machine::new();
    let (spe, entry) = machine.loaded(Policy::AtOnce, source);
    let elements: Vec<(u32, u32)> = (0..2048).map(|n| (16, (2047 - n) * 16)).collect();
    list(&spe, &elements);
    for n in 0..2048_u32 {
        spe.local_store().write(0x10000 + n * 16, &n.to_be_bytes());
    }
    assert_eq!(run_to_stop(&spe, entry), 1);
    assert_eq!(register(&spe, 10), 1 << 31);
    for n in 0..2048 {
        assert_eq!(machine.word(n * 16), 2047 - n as u32);
    }
}

#[test]
fn a_list_gathers_two_thousand_elements() {
    let source = "
        ila     $4,0x8000
        command GETL, 0x10000, $4, 2048*8, 1
        wait_tags 2
        stop    1
";
    for policy in POLICIES {
        let machine = Machine::new();
        let (spe, entry) = machine.loaded(policy, source);
        let elements: Vec<(u32, u32)> = (0..2048).map(|n| (16, (2047 - n) * 16)).collect();
        list(&spe, &elements);
        for n in 0..2048_u32 {
            machine.write(u64::from(n) * 16, &n.to_be_bytes());
        }
        assert_eq!(run_to_stop(&spe, entry), 1);
        for n in 0..2048 {
            assert_eq!(spe.local_store().load_word(0x10000 + n * 16), 2047 - n);
        }
    }
}

/// Elements are read when those before them are done.
#[test]
fn a_list_may_overwrite_its_later_elements() {
    let source = "
        ila     $4,0x8000
        command GETL, 0x8000, $4, 24, 1
        wait_tags 2
        stop    1
";
    let machine = Machine::new();
    let (spe, entry) = machine.loaded(Policy::AtOnce, source);
    list(&spe, &[(16, 0x100), (16, 0x200), (16, 0x200)]);
    let [first, second] = [0x300, 0x400].map(|offset| BASE as u32 + offset);
    let arriving = [16, first, 16, second].map(u32::to_be_bytes).concat();
    machine.write(0x100, &arriving);
    machine.write(0x200, &[2; 16]);
    machine.write(0x300, &[3; 16]);
    // The second element is the one that the first has brought, and brings the third.
    machine.write(0x400, &arriving);
    assert_eq!(run_to_stop(&spe, entry), 1);
    let word = |at| spe.local_store().load_word(at);
    assert_eq!([0x8000, 0x8004, 0x8008, 0x800c].map(word), [16, first, 16, second]);
    assert_eq!([0x8010, 0x8014].map(word), [16, first]);
    assert_eq!([0x8020, 0x8024].map(word), [0x0303_0303; 2]);
}

#[test]
fn unacknowledged_stalled_list_keeps_waiting() {
    let source = "
        ila     $4,0x8000
        command GETL, 0x10000, $4, 8, 1
        wait_tags 2
        stop    1
";
    for policy in POLICIES {
        let (spe, entry) = Machine::new().loaded(policy, source);
        list(&spe, &[(STALL | 16, 0)]);
        let running = start(&spe, entry);
        assert!(running.sleeps());
        spe.request_stop();
        assert_eq!(running.wait().reason, Stop::Requested);
    }
}
