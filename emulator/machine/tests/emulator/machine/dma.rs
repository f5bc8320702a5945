//! Transfers: sizes, wrapping, tags, other SPEs, and the mistakes that `Policy::AtLast` reveals.

use std::time::Duration;

use spu_emulator::mfc::Policy;
use spu_emulator::signal::SignalRegister;
use spu_emulator::spe::{Config, ProxyCommand, TagWait};
use spu_emulator::stop::{Stop, Stopped};

use super::support::{BASE, Machine, assemble, load, register, run_to_stop, soon, start};

const POLICIES: [Policy; 2] = [Policy::AtOnce, Policy::AtLast];

fn pattern(length: usize) -> Vec<u8> {
    (0..length).map(|n| (n * 13 + n / 251) as u8).collect()
}

#[test]
fn the_largest_transfer_goes_in_and_out() {
    let source = "
        command GET, 0x10000, $3, 0x4000, 5
        wait_tags 1<<5
        ila     $4,0x8000
        a       $4,$3,$4
        command PUT, 0x10000, $4, 0x4000, 6
        wait_tags 1<<6
        stop    1
";
    for policy in POLICIES {
        let machine = Machine::new();
        machine.write(0, &pattern(0x4000));
        let (spe, entry) = machine.loaded(policy, source);
        assert_eq!(run_to_stop(&spe, entry), 1);
        assert_eq!(register(&spe, 71), 1 << 6);
        assert!(machine.read(0x8000, 0x4000) == pattern(0x4000));
    }
}

#[test]
fn a_transfer_wraps_at_the_end_of_local_store() {
    let source = "
        command GET, 0x3fff0, $3, 48, 0
        wait_tags 1
        stop    1
";
    let machine = Machine::new();
    machine.write(0, &pattern(48));
    let spe = machine.spe(Config::default());
    // The transfer wraps, and would overwrite a program at address 0.
    let image = assemble(&format!("br over\n .space 64\nover:\n{source}"));
    let entry = load(&spe, &image);
    assert_eq!(run_to_stop(&spe, entry), 1);
    let mut there = [0; 48];
    spe.local_store().read(0x3fff0, &mut there);
    assert_eq!(there[..], pattern(48));
}

#[test]
fn small_transfers_move_exactly_their_bytes() {
    for size in [1, 2, 4, 8] {
        let offset = 16 - size;
        let source = format!(
            "
        ai      $4,$3,{offset}
        command PUT, 0x10000+{offset}, $4, {size}, 1
        wait_tags 2
        stop    1
"
        );
        let machine = Machine::new();
        let (spe, entry) = machine.loaded(Policy::AtOnce, &source);
        spe.local_store().write(0x10000, &[0xff; 32]);
        assert_eq!(run_to_stop(&spe, entry), 1);
        let mut expected = [0; 32];
        expected[offset..16].fill(0xff);
        assert_eq!(machine.read(0, 32), expected);
    }
}

/// Reads local store directly after a get, with or without a wait.
fn first_word_after_get(policy: Policy, wait: &str) -> u32 {
    let source = format!(
        "
        command GET, 0x10000, $3, 16, 0
        {wait}
        lqa     $10,0x10000
        stop    1
"
    );
    let machine = Machine::new();
    machine.write(0, &0x1234_5678_u32.to_be_bytes());
    let (spe, entry) = machine.loaded(policy, &source);
    assert_eq!(run_to_stop(&spe, entry), 1);
    register(&spe, 10)
}

#[test]
fn transfers_at_last_show_a_missing_wait() {
    assert_eq!(first_word_after_get(Policy::AtOnce, ""), 0x1234_5678);
    assert_eq!(first_word_after_get(Policy::AtLast, ""), 0);
    for policy in POLICIES {
        assert_eq!(first_word_after_get(policy, "wait_tags 1"), 0x1234_5678);
    }
    // Waiting for another tag does not wait for this one.
    assert_eq!(first_word_after_get(Policy::AtLast, "wait_tags 2"), 0);
}

#[test]
fn transfers_at_last_show_parameters_that_were_not_written_again() {
    let source = "
        command GET, 0x10000, $3, 16, 0
        set_channel 21, GET
        wait_tags 1
        stop    1
";
    let (spe, entry) = Machine::new().loaded(Policy::AtOnce, source);
    assert_eq!(run_to_stop(&spe, entry), 1);
    let (spe, entry) = Machine::new().loaded(Policy::AtLast, source);
    assert!(matches!(start(&spe, entry).wait().reason, Stop::Dma(_)));
}

#[test]
fn a_polled_status_ends() {
    let source = "
        command GET, 0x10000, $3, 16, 3
        set_channel 22, 8
again:  set_channel 23, 0
        rdch    $10,$ch24
        ai      $11,$11,1
        brz     $10,again
        command GET, 0x10000, $3, 16, 3
        set_channel 22, 8
        set_channel 23, 2
count:  rchcnt  $12,$ch24
        ai      $13,$13,1
        brz     $12,count
        rdch    $10,$ch24
        stop    1
";
    for (policy, polls) in [(Policy::AtOnce, 1), (Policy::AtLast, 2)] {
        let (spe, entry) = Machine::new().loaded(policy, source);
        assert_eq!(run_to_stop(&spe, entry), 1);
        let read = [10, 11, 13].map(|n| register(&spe, n));
        assert_eq!(read, [8, polls, polls]);
    }
}

#[test]
fn any_waits_for_one_tag_and_masks_the_others() {
    let source = "
        command GET, 0x10000, $3, 16, 1
        command GET, 0x10010, $3, 16, 2
        command GET, 0x10020, $3, 16, 4
        set_channel 22, 6
        set_channel 23, 1
        rdch    $10,$ch24
        rdch    $11,$ch12
        stop    1
";
    for (policy, status) in [(Policy::AtOnce, 6), (Policy::AtLast, 4)] {
        let (spe, entry) = Machine::new().loaded(policy, source);
        assert_eq!(run_to_stop(&spe, entry), 1);
        assert_eq!((register(&spe, 10), register(&spe, 11)), (status, 6));
    }
}

#[test]
fn more_commands_than_the_queue_holds_are_all_done() {
    let source = "
        rchcnt  $10,$ch21
        il      $20,40
        lr      $4,$3
again:  command PUT, 0x10000, $4, 16, 9
        ai      $4,$4,16
        ai      $20,$20,-1
        brnz    $20,again
        rchcnt  $11,$ch21
        wait_tags 1<<9
        stop    1
";
    for (policy, room) in [(Policy::AtOnce, 16), (Policy::AtLast, 0)] {
        let machine = Machine::new();
        let (spe, entry) = machine.loaded(policy, source);
        spe.local_store().write(0x10000, &[7; 16]);
        assert_eq!(run_to_stop(&spe, entry), 1);
        assert_eq!((register(&spe, 10), register(&spe, 11)), (16, room));
        assert!(machine.read(0, 640).iter().all(|&byte| byte == 7));
        assert_eq!(machine.read(640, 16), [0; 16]);
    }
}

#[test]
fn a_program_that_stops_has_done_what_it_asked_for() {
    let machine = Machine::new();
    let source = "command PUT, 0x10000, $3, 16, 0\n stop 1\n";
    let (spe, entry) = machine.loaded(Policy::AtLast, source);
    spe.local_store().write(0x10000, &[9; 16]);
    assert_eq!(run_to_stop(&spe, entry), 1);
    assert_eq!(machine.read(0, 16), [9; 16]);
}

#[test]
fn a_sleeping_spu_does_not_keep_its_data_for_ever() {
    let machine = Machine::new();
    let source = "command PUT, 0x10000, $3, 16, 0\n rdch $10,$ch29\n stop 1\n";
    let (spe, entry) = machine.loaded(Policy::AtLast, source);
    spe.local_store().write(0x10000, &[9; 16]);
    let running = start(&spe, entry);
    let begin = std::time::Instant::now();
    while machine.read(0, 1) != [9] {
        assert!(begin.elapsed() < super::support::TIMEOUT);
        std::thread::sleep(Duration::from_millis(1));
    }
    assert!(spe.write_inbound(0, soon()));
    running.wait();
}

#[test]
fn spes_reach_each_others_local_store_and_signals() {
    const STORE: u64 = BASE + 0x100_0000;
    const SIGNAL: u64 = BASE + 0x200_000c;
    let machine = Machine::new();
    let (receiver, entry) =
        machine.loaded(Policy::AtOnce, "rdch $10,$ch4\n lqa $11,0x8000\n stop 1\n");
    machine.memory.register_local_store(STORE, receiver.local_store().clone()).unwrap();
    receiver.map_signal(SignalRegister::Two, SIGNAL);
    let source = "
        ila     $4,0x8000
        ilhu    $5,0x100
        a       $4,$4,$5
        a       $4,$4,$3
        command PUT, 0x10000, $4, 16, 1
        ilhu    $6,0x200
        ai      $6,$6,12
        a       $6,$6,$3
        command SNDSIG+2, 0x1001c, $6, 4, 1
        wait_tags 2
        stop    2
";
    let (sender, sender_entry) = machine.loaded(Policy::AtLast, source);
    sender.local_store().write(0x10000, &[0x5a; 16]);
    sender.local_store().write(0x1001c, &[0, 0, 1, 2]);
    let running = start(&receiver, entry);
    assert_eq!(run_to_stop(&sender, sender_entry), 2);
    assert_eq!(running.wait().reason, Stop::Signal(1));
    assert_eq!(register(&receiver, 10), 0x102);
    assert_eq!(register(&receiver, 11), 0x5a5a_5a5a);
}

fn proxy(opcode: u32, ea: u64, size: u32, tag: u32) -> ProxyCommand {
    ProxyCommand { opcode, lsa: 0x20000, ea, size, tag }
}

#[test]
fn proxy_commands_move_data_and_report_their_tags() {
    for policy in POLICIES {
        let machine = Machine::new();
        machine.write(0, &pattern(64));
        let spe = machine.spe(Config { policy, ..Config::default() });
        spe.proxy_command(proxy(0x40, BASE, 64, 3)).unwrap();
        assert_eq!(spe.proxy_tags(8, TagWait::All), 8);
        for n in 1..=20 {
            spe.proxy_command(proxy(0x22, BASE + n * 64, 64, 4)).unwrap();
        }
        assert_eq!(spe.proxy_tags(1 << 4 | 1 << 3, TagWait::All), 0x18);
        for n in 1..=20 {
            assert_eq!(machine.read(n * 64, 64), pattern(64));
        }
    }
}

#[test]
fn proxy_transfers_at_last_wait_to_be_asked_twice() {
    let machine = Machine::new();
    let spe = machine.spe(Config { policy: Policy::AtLast, ..Config::default() });
    spe.local_store().write(0x20000, &[1; 16]);
    spe.proxy_command(proxy(0x20, BASE, 16, 1)).unwrap();
    assert_eq!(machine.word(0), 0);
    assert_eq!(spe.proxy_tags(2, TagWait::Immediate), 0);
    assert_eq!(spe.proxy_tags(2, TagWait::Immediate), 2);
    assert_eq!(machine.word(0), 0x0101_0101);
}

#[test]
fn a_proxy_fault_stops_the_spu() {
    let (spe, entry) = Machine::new().loaded(Policy::AtOnce, "rdch $10,$ch29\n stop 1\n");
    let running = start(&spe, entry);
    spe.proxy_command(proxy(0x40, 0x10, 16, 1)).unwrap();
    let Stopped { reason, npc, .. } = running.wait();
    assert!(matches!(reason, Stop::Dma(_)), "{reason:?}");
    // The SPU can continue.
    assert!(spe.write_inbound(1, soon()));
    assert_eq!(run_to_stop(&spe, npc), 1);
}
