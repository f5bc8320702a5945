//! Atomic commands and reservations.

use spu_emulator::memory::{LINE, MainMemory, MemoryFault, Place};

use crate::prelude::*;
use crate::support::{MEMORY, load};

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

/// Memory that is mapped at [`BASE`] and again at [`AGAIN`], and whose accesses take two steps,
/// between which other threads run.
struct TwiceInSteps(RegisteredMemory);

const AGAIN: u64 = BASE + (1 << 24);

impl TwiceInSteps {
    fn machine() -> Arc<machine::Machine> {
        let memory = RegisteredMemory::new();
        let bytes = vec![0; MEMORY];
        memory.register(BASE, bytes, Access::ReadWrite).unwrap();
        machine::Machine::new(Arc::new(Self(memory)))
    }

    fn at_base(ea: u64) -> u64 {
        if ea < AGAIN { ea } else { ea - AGAIN + BASE }
    }
}

impl MainMemory for TwiceInSteps {
    fn read(&self, ea: u64, into: &mut [u8]) -> Result<(), MemoryFault> {
        let ea = Self::at_base(ea);
        let (first, second) = into.split_at_mut(into.len() / 2);
        self.0.read(ea, first)?;
        thread::yield_now();
        self.0.read(ea + first.len() as u64, second)
    }

    fn write(&self, ea: u64, from: &[u8]) -> Result<(), MemoryFault> {
        let ea = Self::at_base(ea);
        let (first, second) = from.split_at(from.len() / 2);
        self.0.write(ea, first)?;
        thread::yield_now();
        self.0.write(ea + first.len() as u64, second)
    }

    fn place(&self, ea: u64) -> Option<Place> {
        Some(Place { file: (0, 1), offset: Self::at_base(ea) - BASE })
    }

    fn compare_exchange_line(
        &self,
        ea: u64,
        expected: &[u8; LINE],
        new: &[u8; LINE],
    ) -> Result<bool, MemoryFault> {
        let mut current = [0; LINE];
        self.read(ea, &mut current)?;
        if current != *expected {
            return Ok(false);
        }
        self.write(ea, new).map(|()| true)
    }
}

fn on(machine: &Arc<machine::Machine>, source: &str) -> (Arc<Spe>, u32) {
    let spe = Spe::new(machine, Config::default());
    let entry = load(&spe, &assemble(source));
    (spe, entry)
}

/// Gets and puts the two lines at the base, and counts in $7 how often the first and the last
/// quadword of a line differ. It puts lines of its own number only.
fn gets_and_puts(number: u32, get: &str, put: &str) -> String {
    format!(
        "
        il      $5,500
        il      $7,0
again:  {get}
        .irp    line,0x10000,0x10080
        lqa     $10,\\line
        lqa     $11,\\line+112
        ceq     $12,$10,$11
        gb      $12,$12
        ceqi    $12,$12,15
        ai      $7,$7,1
        a       $7,$7,$12
        .endr
        il      $13,{number}
        .irp    at,0,16,32,48,64,80,96,112,128,144,160,176,192,208,224,240
        stqa    $13,0x10000+\\at
        .endr
        {put}
        ai      $5,$5,-1
        brnz    $5,again
        stop    1
"
    )
}

#[test]
fn lines_are_seen_whole() {
    let get = "command GET, 0x10000, $3, 256, 0\n wait_tags 1";
    let put = "command PUT, 0x10000, $3, 256, 0\n wait_tags 1";
    let get_line = "command GETLLAR, 0x10000, $3, 128, 0\n rdch $70,$ch27";
    let put_line = "command PUTLLUC, 0x10000, $3, 128, 0\n rdch $70,$ch27";
    let put_if = "command PUTLLC, 0x10000, $3, 128, 0\n rdch $70,$ch27";
    let list = "
        ila     $74,0x20000
        il      $75,256
        stqa    $75,0x20000
        cwd     $76,4($74)
        lqa     $75,0x20000
        shufb   $75,$3,$75,$76
        stqa    $75,0x20000
        command PUTL, 0x10000, $74, 8, 0
        wait_tags 1";
    let machine = TwiceInSteps::machine();
    let running: Vec<_> =
        [(get, put), (get, put_line), (get_line, put), (get_line, put_if), (get, list)]
            .into_iter()
            .zip(1..)
            .map(|((get, put), number)| {
                let (spe, entry) = on(&machine, &gets_and_puts(number, get, put));
                (start(&spe, entry), spe)
            })
            .collect();
    for (one, spe) in running {
        one.wait();
        assert_eq!(register(&spe, 7), 0);
    }
}

#[test]
fn a_line_with_two_addresses_has_one_reservation() {
    let writers = [
        "command PUT, 0x10000, $3, 16, 0\n wait_tags 1",
        "command PUT, 0x10000, $4, 0x1000, 0\n wait_tags 1",
        "command PUTLLUC, 0x10000, $3, 128, 0\n rdch $10,$ch27",
        "command PUTQLLUC, 0x10000, $3, 128, 0\n wait_tags 1",
        "command GETLLAR, 0x10000, $3, 128, 0\n rdch $10,$ch27
         command PUTLLC, 0x10000, $3, 128, 0\n rdch $10,$ch27",
    ];
    for writer in writers {
        let machine = TwiceInSteps::machine();
        let (sleeper, entry) = on(&machine, &format!("ai $3,$3,128\n{WAIT_FOR_LOSS}"));
        let running = start(&sleeper, entry);
        assert_eq!(sleeper.read_outbound(soon()), Some(4));
        let source = format!("ilhu $5,0x100\n a $4,$3,$5\n ai $3,$4,128\n {writer}\n stop 2\n");
        let (spe, writer_entry) = on(&machine, &source);
        assert_eq!(run_to_stop(&spe, writer_entry), 2);
        running.wait();
        let read = (register(&sleeper, 11), register(&sleeper, 12));
        assert_eq!(read, (0x400, 1), "{writer}");
    }
}

/// Three SPEs use one address, and three the other.
#[test]
fn six_spes_count_by_two_addresses() {
    let machine = TwiceInSteps::machine();
    let running: Vec<_> = (0..6)
        .map(|number| {
            let again = if number % 2 == 0 { "" } else { "a $3,$3,$6" };
            let source = format!(
                "        ilhu $6,0x100\n {again}\n cwd $14,0($13)\n{}",
                COUNT.replace("10000\nagain", "1000\nagain")
            );
            let (spe, entry) = on(&machine, &source);
            start(&spe, entry)
        })
        .collect();
    for one in running {
        one.wait();
    }
    let mut word = [0; 4];
    machine.memory().read(BASE, &mut word).unwrap();
    assert_eq!(u32::from_be_bytes(word), 6000);
}
