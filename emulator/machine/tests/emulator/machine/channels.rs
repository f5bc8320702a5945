//! Which channels exist, in which direction, and their counts when idle.

use crate::prelude::*;
use crate::support::run;

/// Channel number, whether it can be read, and its count when idle, as the architecture's manual
/// has them.
const CHANNELS: [(u8, bool, u32); 28] = [
    (0, true, 0),
    (1, false, 1),
    (2, false, 1),
    (3, true, 0),
    (4, true, 0),
    (7, false, 1),
    (8, true, 1),
    (9, false, 1),
    (11, true, 1),
    (12, true, 1),
    (13, true, 1),
    (14, false, 1),
    (15, true, 1),
    (16, false, 1),
    (17, false, 1),
    (18, false, 1),
    (19, false, 1),
    (20, false, 1),
    (21, false, 16),
    (22, false, 1),
    (23, false, 1),
    (24, true, 0),
    (25, true, 0),
    (26, false, 1),
    (27, true, 0),
    (28, false, 1),
    (29, true, 0),
    (30, false, 1),
];

#[test]
fn idle_counts() {
    let mut source = String::new();
    for channel in 0..128 {
        source += &format!("        rchcnt $10,$ch{channel}\n");
        source += &format!("        stqa $10,{}\n", 0x8000 + channel * 16);
    }
    source += "        stop 1\n";
    let (spe, entry) = Machine::new().loaded(Policy::AtOnce, &source);
    assert_eq!(run_to_stop(&spe, entry), 1);
    for channel in 0..128_u8 {
        let count = spe.local_store().load_word(0x8000 + u32::from(channel) * 16);
        let known = CHANNELS.iter().find(|(number, ..)| *number == channel);
        assert_eq!(count, known.map_or(0, |known| known.2), "channel {channel}");
    }
}

#[test]
fn channels_have_one_direction_and_others_do_not_exist() {
    for channel in 0..128_u8 {
        let known = CHANNELS.iter().find(|(number, ..)| *number == channel);
        let cases = [(true, ChannelAccess::Read, 0x00d), (false, ChannelAccess::Write, 0x10d)];
        for (reads, access, opcode) in cases {
            if known.is_some_and(|known| known.1 == reads) {
                continue;
            }
            let word = opcode << 21 | u32::from(channel) << 7;
            let spe = Machine::new().spe(Config::default());
            spe.local_store().write(0, &u32::to_be_bytes(word));
            let stopped = run(&spe, 0);
            assert_eq!(stopped.reason, Stop::InvalidChannel(channel, access));
            assert_eq!(stopped.pc, 0);
        }
    }
}
