//! Transfers: sizes, wrapping, tags, other SPEs, and the mistakes that `Policy::AtLast` reveals.

use crate::prelude::*;
use spu_emulator::spe::{ProxyCommand, TagWait};

const POLICIES: [Policy; 2] = [Policy::AtOnce, Policy::AtLast];

fn pattern(length: usize) -> Vec<u8> {
    (0..length).map(|n| (n * 13 + n / 251) as u8).collect()
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
        assert!(begin.elapsed() < crate::support::TIMEOUT);
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
