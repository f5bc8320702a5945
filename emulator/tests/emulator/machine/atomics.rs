//! Atomic commands and reservations.

use spu_emulator::memory::MainMemory;
use spu_emulator::mfc::Policy;

use super::support::{BASE, Machine, register, run_to_stop, soon, start};

/// Adds 1 to the word at the base, $5 times.
const COUNT: &str = "
        ila     $5,10000
again:  command GETLLAR, 0x10000, $3, 128, 0
        rdch    $10,$ch27
        lqa     $11,0x10000
        ai      $12,$11,1
        shufb   $11,$12,$11,$14
        stqa    $11,0x10000
        command PUTLLC, 0x10000, $3, 128, 0
        rdch    $10,$ch27
        brnz    $10,again
        ai      $5,$5,-1
        brnz    $5,again
        stop    0x2000
";

#[test]
fn six_spes_count_without_losing_one() {
    for policy in [Policy::AtOnce, Policy::AtLast] {
        let machine = Machine::new();
        let source = format!("        cwd $14,0($13)\n{COUNT}");
        let running: Vec<_> = (0..6)
            .map(|_| {
                let (spe, entry) = machine.loaded(policy, &source);
                start(&spe, entry)
            })
            .collect();
        for one in running {
            one.wait();
        }
        assert_eq!(machine.word(0), 60_000);
    }
}

#[test]
fn the_status_tells_which_command_it_was() {
    let source = "
        command GETLLAR, 0x10000, $3, 128, 0
        rdch    $10,$ch27
        command PUTLLC, 0x10000, $3, 128, 0
        rdch    $11,$ch27
        command PUTLLC, 0x10000, $3, 128, 0
        rdch    $12,$ch27
        command PUTLLUC, 0x10000, $3, 128, 0
        rchcnt  $13,$ch27
        rdch    $14,$ch27
        rchcnt  $15,$ch27
        command PUTQLLUC, 0x10000, $3, 128, 6
        rchcnt  $16,$ch27
        wait_tags 1<<6
        stop    1
";
    let (spe, entry) = Machine::new().loaded(Policy::AtOnce, source);
    assert_eq!(run_to_stop(&spe, entry), 1);
    let read = [10, 11, 12, 13, 14, 15, 16, 71].map(|n| register(&spe, n));
    assert_eq!(read, [4, 0, 1, 1, 2, 0, 0, 1 << 6]);
}

/// Reserves the line at the base, performs some action, and puts conditionally. Returns the put's
/// status and the pending events.
fn after_reserving(what: &str) -> (u32, u32) {
    let source = format!(
        "
        set_channel 1, 0x400
        command GETLLAR, 0x10000, $3, 128, 0
        rdch    $10,$ch27
        ila     $4,0x1000
        a       $4,$4,$3
{what}
        command PUTLLC, 0x10000, $3, 128, 0
        rdch    $11,$ch27
        il      $12,0
        rchcnt  $13,$ch0
        brz     $13,done
        rdch    $12,$ch0
done:   stop    1
"
    );
    let (spe, entry) = Machine::new().loaded(Policy::AtOnce, &source);
    assert_eq!(run_to_stop(&spe, entry), 1);
    (register(&spe, 11), register(&spe, 12))
}

/// As it was measured on a console.
#[test]
fn what_the_spu_does_itself_to_its_reservation() {
    assert_eq!(after_reserving(""), (0, 0));
    let own_put = "        command PUT, 0x10000, $3, 16, 0\n        wait_tags 1\n";
    assert_eq!(after_reserving(own_put), (1, 0x400));
    let put_elsewhere = "        command PUT, 0x10000, $4, 16, 0\n        wait_tags 1\n";
    assert_eq!(after_reserving(put_elsewhere), (0, 0));
    let unconditional = "        command PUTLLUC, 0x10000, $3, 128, 0\n        rdch $20,$ch27\n";
    assert_eq!(after_reserving(unconditional), (1, 0));
    let other_line = "        command GETLLAR, 0x10000, $4, 128, 0\n        rdch $20,$ch27\n";
    assert_eq!(after_reserving(other_line), (1, 0));
    let other_put = "        command PUTLLC, 0x10000, $4, 128, 0\n        rdch $20,$ch27\n";
    assert_eq!(after_reserving(other_put), (1, 0));
}

/// Reserves the line, sends a word to the PPE, and sleeps until the reservation is lost.
const WAIT_FOR_LOSS: &str = "
        set_channel 1, 0x400
        command GETLLAR, 0x10000, $3, 128, 0
        rdch    $10,$ch27
        wrch    $ch28,$10
        rdch    $11,$ch0
        command PUTLLC, 0x10000, $3, 128, 0
        rdch    $12,$ch27
        stop    1
";

#[test]
fn anothers_put_breaks_the_reservation_and_wakes_the_sleeper() {
    let writers = [
        "command PUT, 0x10000, $3, 16, 0",
        "command PUTLLUC, 0x10000, $3, 128, 0",
        "command PUTQLLUC, 0x10000, $3, 128, 0",
        "command GETLLAR, 0x10000, $3, 128, 0\n command PUTLLC, 0x10000, $3, 128, 0",
    ];
    for writer in writers {
        let machine = Machine::new();
        let (sleeper, entry) = machine.loaded(Policy::AtOnce, WAIT_FOR_LOSS);
        let running = start(&sleeper, entry);
        assert_eq!(sleeper.read_outbound(soon()), Some(4));
        let (spe, writer_entry) = machine.loaded(Policy::AtOnce, &format!("{writer}\n stop 2\n"));
        assert_eq!(run_to_stop(&spe, writer_entry), 2);
        running.wait();
        let read = (register(&sleeper, 11), register(&sleeper, 12));
        assert_eq!(read, (0x400, 1), "{writer}");
    }
}

#[test]
fn the_ppes_own_store_is_noticed_too() {
    let machine = Machine::new();
    let (sleeper, entry) = machine.loaded(Policy::AtOnce, WAIT_FOR_LOSS);
    let running = start(&sleeper, entry);
    assert_eq!(sleeper.read_outbound(soon()), Some(4));
    machine.memory.write(BASE + 127, &[1]).unwrap();
    running.wait();
    let read = (register(&sleeper, 11), register(&sleeper, 12));
    assert_eq!(read, (0x400, 1));
}

#[test]
fn low_address_bits_do_not_count() {
    let source = "
        ai      $4,$3,0x64
        command GETLLAR, 0x10035, $4, 0, 0
        rdch    $10,$ch27
        stop    1
";
    let machine = Machine::new();
    machine.write(0, &[8; 128]);
    let (spe, entry) = machine.loaded(Policy::AtOnce, source);
    assert_eq!(run_to_stop(&spe, entry), 1);
    let mut line = [0; 128];
    spe.local_store().read(0x10000, &mut line);
    assert_eq!(line, [8; 128]);
}
