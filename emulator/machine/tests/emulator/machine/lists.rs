//! DMA lists: gathering, small elements, stall-and-notify.

use spu_emulator::mfc::{DmaError, Policy};
use spu_emulator::stop::{Stop, Stopped};

use super::support::{BASE, Machine, register, run, run_to_stop, start};

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
fn a_list_gathers_rows() {
    let source = "
        ila     $4,0x8000
        command GETL, 0x10000, $4, 4*8, 2
        wait_tags 4
        stop    1
";
    for policy in POLICIES {
        let machine = Machine::new();
        for row in 0..4 {
            machine.write(row * 0x1000, &[row as u8 + 1; 64]);
        }
        // The second element is small, so its address determines its position in the quadword.
        let (spe, entry) = machine.loaded(policy, source);
        list(&spe, &[(64, 0x3000), (4, 0x1008), (0, 0x2001), (16, 0x2010)]);
        assert_eq!(run_to_stop(&spe, entry), 1);
        let mut there = [0; 112];
        spe.local_store().read(0x10000, &mut there);
        let mut expected = [0; 112];
        expected[..64].fill(4);
        expected[72..76].fill(2);
        expected[80..96].fill(3);
        assert_eq!(there, expected);
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
fn a_list_of_puts_ends_at_the_element_that_fails() {
    const NOWHERE: u32 = 0x100_0000;
    let source = "
        ila     $4,0x8000
        command PUTL, 0x10000, $4, 4*8, 2
        wait_tags 4
        stop    1
";
    for policy in POLICIES {
        let machine = Machine::new();
        let (spe, entry) = machine.loaded(policy, source);
        list(&spe, &[(16, 0), (64, 64), (32, NOWHERE), (16, 128)]);
        spe.local_store().write(0x10000, &[7; 128]);
        let reason = run(&spe, entry).reason;
        let expected = DmaError::Storage {
            command: 0x24,
            lsa: 0x10050,
            ea: BASE + u64::from(NOWHERE),
            size: 32,
        };
        assert_eq!(reason, Stop::Dma(expected));
        assert_eq!(machine.read(0, 16), [7; 16]);
        assert_eq!(machine.read(64, 64), [7; 64]);
        assert_eq!(machine.read(128, 16), [0; 16]);
    }
}

#[test]
fn an_element_sends_what_the_one_before_it_has_written() {
    const STORE: u32 = 0x100_0000;
    let source = "
        ila     $4,0x8000
        command PUTL, 0x10000, $4, 3*8, 2
        wait_tags 4
        stop    1
";
    let machine = Machine::new();
    let (spe, entry) = machine.loaded(Policy::AtOnce, source);
    let ea = BASE + u64::from(STORE);
    let store = spe.local_store().clone();
    machine.memory.register_local_store(ea, store).unwrap();
    spe.map_local_store(ea);
    // The second element goes to this SPE's own local store, to where the third comes from.
    list(&spe, &[(16, 0), (16, STORE + 0x10020), (16, 16)]);
    for (at, byte) in [(0x10000, 1), (0x10010, 2), (0x10020, 3)] {
        spe.local_store().write(at, &[byte; 16]);
    }
    assert_eq!(run_to_stop(&spe, entry), 1);
    assert_eq!(machine.read(0, 16), [1; 16]);
    assert_eq!(machine.read(16, 16), [2; 16]);
}

#[test]
fn a_list_stalls_until_it_is_acknowledged() {
    // After the stall the program changes the next element's address. That is what stalls are for.
    let source = "
        ila     $4,0x8000
        command GETL, 0x10000, $4, 2*8, 7
        rdch    $10,$ch25
        rchcnt  $11,$ch25
        set_channel 22, 1<<7
        set_channel 23, 0
        rdch    $12,$ch24
        lqa     $13,0x10010
        lqa     $14,0x8000
        lqa     $15,0x8010
        stqa    $15,0x8000
        set_channel 26, 7
        wait_tags 1<<7
        lqa     $16,0x10010
        stop    1
";
    for policy in POLICIES {
        let machine = Machine::new();
        machine.write(0, &[1; 16]);
        machine.write(16, &[2; 16]);
        machine.write(32, &[3; 16]);
        let (spe, entry) = machine.loaded(policy, source);
        list(&spe, &[(STALL | 16, 0), (16, 16), (STALL | 16, 0), (16, 32)]);
        assert_eq!(run_to_stop(&spe, entry), 1);
        let read = [10, 11, 12, 13, 16].map(|n| register(&spe, n));
        assert_eq!(read, [1 << 7, 0, 0, 0, 0x0303_0303]);
    }
}

#[test]
fn what_follows_a_stalled_list_waits_if_it_has_to() {
    // getb waits for the stalled list of its tag, but a plain get with that tag does not. mfcsync
    // waits.
    let source = "
        ila     $4,0x8000
        command GETL, 0x10000, $4, 8, 1
        command GET, 0x10100, $3, 16, 1
        command GETB, 0x10200, $3, 16, 1
        command MFCSYNC, 0, $3, 0, 3
        command GET, 0x10300, $3, 16, 3
        rdch    $10,$ch25
        set_channel 22, 1<<5
        set_channel 23, 0
        rdch    $11,$ch24
        set_channel 22, 0xa
        set_channel 23, 0
        rdch    $12,$ch24
        rchcnt  $13,$ch21
        set_channel 26, 1
        wait_tags 0xa
        stop    1
";
    let machine = Machine::new();
    let (spe, entry) = machine.loaded(Policy::AtOnce, source);
    list(&spe, &[(STALL | 16, 0)]);
    assert_eq!(run_to_stop(&spe, entry), 1);
    let read = [10, 11, 12, 13, 71].map(|n| register(&spe, n));
    assert_eq!(read, [2, 1 << 5, 0, 12, 0xa]);
}

#[test]
fn nobody_else_wakes_a_stalled_list() {
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

#[test]
fn a_bad_element_is_an_error_after_the_good_ones() {
    let source = "
        ila     $4,0x8000
        command PUTL, 0x10000, $4, 2*8, 1
        wait_tags 2
        stop    1
";
    for (bad, offset) in [(17, 0), (0x7ff0, 0), (16, 4)] {
        let machine = Machine::new();
        let (spe, entry) = machine.loaded(Policy::AtOnce, source);
        spe.local_store().write(0x10000, &[5; 16]);
        list(&spe, &[(16, 0), (bad, offset + 64)]);
        let Stopped { reason, .. } = run(&spe, entry);
        assert!(
            matches!(reason, Stop::Dma(spu_emulator::mfc::DmaError::Alignment { .. })),
            "{reason:?}"
        );
        assert_eq!(machine.read(0, 16), [5; 16]);
    }
}
