//! Random commands: whatever a program writes to the MFC's channels, the machine must not panic,
//! hang, or access memory that it was not given.

use proptest::prelude::*;

use crate::prelude::*;
use crate::support::{MEMORY, run};

/// `ilhu`, `iohl` and `wrch` of a value.
fn write_channel(channel: u32, value: u32) -> [u32; 3] {
    let register = 10;
    [
        0x082 << 23 | (value >> 16) << 7 | register,
        0x0c1 << 23 | (value & 0xffff) << 7 | register,
        0x10d << 21 | channel << 7 | register,
    ]
}

/// The six parameters of a command, most of them near values that the MFC accepts.
fn command() -> impl Strategy<Value = [u32; 6]> {
    const OPCODES: [u32; 32] = [
        0x20, 0x21, 0x22, 0x24, 0x25, 0x26, 0x30, 0x31, 0x32, 0x34, 0x35, 0x36, 0x40, 0x41, 0x42,
        0x44, 0x45, 0x46, 0xa0, 0xa1, 0xa2, 0xb0, 0xb4, 0xb8, 0xc0, 0xc8, 0xcc, 0xd0, 0x80, 0x89,
        0x28, 0x43,
    ];
    let lsa = prop_oneof![(0x400_u32..0x4200).prop_map(|n| n * 16), any::<u32>()];
    let base = BASE as u32;
    let ea = prop_oneof![
        4 => (0_u32..0x4100).prop_map(move |n| base + n * 16),
        2 => (0x400_u32..0x4000).prop_map(|n| n * 16),
        1 => any::<u32>()
    ];
    let high = prop_oneof![5 => Just((BASE >> 32) as u32), 1 => any::<u32>()];
    let size = prop_oneof![
        (0_u32..64).prop_map(|n| n * 16),
        prop::sample::select(vec![0, 1, 2, 4, 8, 16384]),
        any::<u32>()
    ];
    let tag = prop_oneof![5 => 0_u32..4, 1 => any::<u32>()];
    let opcode = prop_oneof![9 => prop::sample::select(OPCODES.to_vec()), 1 => any::<u32>()];
    (lsa, high, ea, size, tag, opcode).prop_map(|(a, b, c, d, e, f)| [a, b, c, d, e, f])
}

fn program(commands: &[[u32; 6]], wait: u32) -> Vec<u32> {
    let mut words = Vec::new();
    for command in commands {
        for (channel, value) in (16..).zip(command) {
            words.extend(write_channel(channel, *value));
        }
    }
    words.extend(write_channel(22, 0xf));
    words.extend(write_channel(23, wait));
    words.push(0x00d << 21 | 24 << 7 | 11);
    words.push(1);
    words
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(3000))]

    #[test]
    fn random_commands_end_in_a_typed_stop(
        commands in prop::collection::vec(command(), 1..12),
        wait in 0_u32..4,
        at_last: bool,
        filling: u8,
    ) {
        let machine = Machine::new();
        let guard = vec![0xa5; 4096];
        machine
            .memory
            .register(BASE + MEMORY as u64, guard.clone(), Access::ReadOnly)
            .unwrap();
        let policy = if at_last { Policy::AtLast } else { Policy::AtOnce };
        let spe = machine.spe(Config { policy, ..Config::default() });
        // List commands read their elements from here, some with the stall bit.
        spe.local_store().write(0x4000, &vec![filling; 0x3c000]);
        for (at, word) in (0..).step_by(4).zip(program(&commands, wait)) {
            spe.local_store().write(at, &word.to_be_bytes());
        }
        let running = start(&spe, 0);
        let stopped = match running.try_wait() {
            Some(stopped) => stopped,
            None => {
                // The program waits for a stalled list, or for a tag that can't complete. Only a
                // stop request ends that.
                spe.request_stop();
                running.wait()
            }
        };
        // A command may have overwritten the program. Then any stop is correct.
        let written = commands.iter().any(|command| command[5] & 0xf0 == 0x40 || command[5] == 0xd0);
        prop_assert!(
            written || matches!(stopped.reason, Stop::Signal(1) | Stop::Dma(_) | Stop::Requested),
            "{stopped}"
        );
        let mut after = vec![0; guard.len()];
        spu_emulator::memory::MainMemory::read(&*machine.memory, BASE + MEMORY as u64, &mut after)
            .unwrap();
        prop_assert!(after == guard);
        // The program can be run again, after each command in the queue has reported its error,
        // and after a request that came too late has been obeyed. A transfer that was still in the
        // queue may overwrite the program, so that it is written anew for each run.
        let most = commands.len() + 1;
        let others = (0..=most).take_while(|_| {
            spe.local_store().write(0, &1_u32.to_be_bytes());
            run(&spe, 0).reason != Stop::Signal(1)
        });
        prop_assert!(others.count() <= most);
    }
}
