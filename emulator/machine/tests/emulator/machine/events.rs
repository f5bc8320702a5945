//! Events, interrupts, the decrementer.

use crate::prelude::*;
use crate::support::at_once;

#[test]
fn the_decrementers_event_wakes_the_sleeper() {
    // 798000 ticks are 10 ms.
    let source = "
        set_channel 1, 0x20
        ilhu    $10,12
        iohl    $10,11568
        wrch    $ch7,$10
        rdch    $11,$ch0
        rdch    $12,$ch8
        set_channel 2, 0x20
        rchcnt  $13,$ch0
        stop    1
";
    let (spe, entry) = Machine::new().loaded(Policy::AtOnce, source);
    let begin = Instant::now();
    assert_eq!(run_to_stop(&spe, entry), 1);
    assert!(begin.elapsed() >= Duration::from_millis(10));
    let [event, value, count] = [11, 12, 13].map(|n| register(&spe, n));
    assert_eq!((event, count), (0x20, 0));
    assert!(value.cast_signed() < 0, "{value:#x}");
}

#[test]
fn the_decrementer_counts_down_and_can_be_frozen() {
    let source = "
        rdch    $10,$ch8
        ilhu    $11,0x4000
        wrch    $ch7,$11
        wrch    $ch28,$11
        rdch    $12,$ch29
        rdch    $13,$ch8
        set_channel 2, 0x20
        rdch    $14,$ch8
        rdch    $12,$ch29
        rdch    $15,$ch8
        stop    1
";
    let (spe, entry) = Machine::new().loaded(Policy::AtOnce, source);
    let running = start(&spe, entry);
    assert!(spe.read_outbound(soon()).is_some());
    for _ in 0..2 {
        std::thread::sleep(Duration::from_millis(20));
        assert!(spe.write_inbound(0, soon()));
    }
    running.wait();
    let [before, after, frozen, later] = [10, 13, 14, 15].map(|n| register(&spe, n));
    assert_eq!(before, 0);
    assert!(0x4000_0000 - after >= 79_800 * 20, "{after:#x}");
    assert_eq!(frozen, later);
}

#[test]
fn mailbox_and_signal_events_are_edges_that_stay_until_acknowledged() {
    let source = "
        set_channel 1, 0x310
        rdch    $10,$ch0
        rchcnt  $11,$ch0
        set_channel 2, 0x10
        rchcnt  $12,$ch0
        rdch    $13,$ch29
        rdch    $14,$ch0
        set_channel 2, 0x200
        stop    1
";
    let (spe, entry) = Machine::new().loaded(Policy::AtOnce, source);
    assert!(spe.write_inbound(3, at_once()));
    assert!(spe.write_inbound(4, at_once()));
    let running = start(&spe, entry);
    assert!(running.sleeps());
    spe.signal(SignalRegister::One, 9);
    running.wait();
    let read = [10, 11, 12, 13, 14].map(|n| register(&spe, n));
    assert_eq!(read, [0x10, 0, 0, 3, 0x200]);
}

#[test]
fn outbound_mailbox_space_is_an_event() {
    let source = "
        set_channel 28, 1
        set_channel 30, 2
        set_channel 1, 0xc0
        rdch    $10,$ch0
        stop    1
";
    let (spe, entry) = Machine::new().loaded(Policy::AtOnce, source);
    let running = start(&spe, entry);
    assert!(running.sleeps());
    assert_eq!(spe.read_outbound_interrupt(soon()), Some(2));
    running.wait();
    assert_eq!(register(&spe, 10), 0x40);
}

#[test]
fn an_event_interrupts_an_enabled_program() {
    // The interrupt goes to address 0, where the program starts with a branch to its handler.
    let source = "
        br      choose
        .space  60
choose: brnz    $20,taken
        il      $20,1
        set_channel 1, 0x10
        ila     $21,loop
        bie     $21
loop:   ai      $22,$22,1
        stqa    $22,0x8000
        br      loop
taken:  rdch    $10,$ch0
        rdch    $11,$ch13
        rdch    $12,$ch15
        rdch    $13,$ch29
        stop    1
";
    let (spe, entry) = Machine::new().loaded(Policy::AtOnce, source);
    let running = start(&spe, entry);
    assert!(running.stores_to(0x8000));
    assert!(spe.write_inbound(42, at_once()));
    running.wait();
    let [event, status, return_address, word] = [10, 11, 12, 13].map(|n| register(&spe, n));
    assert_eq!((event, status, word), (0x10, 0, 42));
    let image = register(&spe, 21);
    assert!((image..image + 12).contains(&return_address));
}
