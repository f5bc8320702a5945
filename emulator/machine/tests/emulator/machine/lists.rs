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
