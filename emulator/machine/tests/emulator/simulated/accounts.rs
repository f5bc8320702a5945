//! The account of cycles. What a single program can see of the time is in `filetests/time.spu`.

use spu_isa::timing::Cause;

use crate::prelude::*;
use crate::support::start_later;

/// The properties of every SPE's figures.
pub fn check(spe: &SpeReport) {
    let account = &spe.account;
    assert_eq!(spe.stopped + account.cycles(), spe.clock);
    assert_eq!(account.single() + account.dual() + account.stalled(), account.cycles());
    assert_eq!(spe.busy() + spe.waits.total(), account.cycles());
    // The pipeline counts sleep in a channel as waiting for the channel or for the MFC.
    let slept = account.waited(Cause::Channel) + account.waited(Cause::Dma);
    assert_eq!(spe.waits.total(), slept);
}

#[test]
fn every_account_adds_up_in_a_crowd() {
    let source = "
        ila     $5,20
        shli    $6,$4,14
        a       $6,$6,$3
again:  command GET, 0x10000, $6, 2048, 1
        command PUTF, 0x10000, $6, 1024, 1
        command GETLLAR, 0x11000, $3, 128, 0
        rdch    $7,$ch27
        wait_tags 2
        ai      $5,$5,-1
        brnz    $5,again
        rdch    $8,$ch29
        stop    0x2000
";
    let machine = Machine::simulated();
    let image = assemble(source);
    let spes: Vec<_> = (0..6).map(|_| machine.with_image(&image)).collect();
    let running: Vec<_> = (0..)
        .zip(&spes)
        .map(|(number, (spe, entry))| start_later(spe, *entry, number, Duration::ZERO))
        .collect();
    // After 300 ms of simulated time all of them sleep.
    let simulation = machine.simulation();
    let limit = Some(Duration::from_millis(300));
    let none = simulation.wait(simulation.new_key(), limit, || None::<()>);
    assert!(none.is_none());
    let earlier = machine.report();
    for (spe, _) in &spes {
        assert!(spe.write_inbound(9, None));
    }
    machine.depart();
    for one in running {
        one.end();
    }
    let report = machine.report();
    for (spe, earlier) in report.spes.iter().zip(&earlier.spes) {
        check(spe);
        check(earlier);
        assert!(spe.clock > earlier.clock);
        // They slept for all of those 300 ms, except during their work.
        assert!(spe.waits.mailbox > 955_000_000, "{:?}", spe.waits);
        assert!(spe.waits.tag > 0);
        assert_eq!(spe.commands.bytes_out, 20 * 1024);
        assert_eq!(spe.commands.bytes_in, 20 * 2048);
    }
}
