//! Problem-state areas: registers by plain loads and stores.

use std::ptr;

use spe2::context::{spe_context_create, spe_ps_area_get};
use spe2::event::{
    spe_event_handler_create, spe_event_handler_destroy, spe_event_handler_register,
};
use spe2::mailbox::{spe_mssync_start, spe_mssync_status};
use spe2::mfc::{spe_mfcio_get, spe_mfcio_tag_status_read};
use spe2::types::{
    SPE_DEFAULT_ENTRY, SPE_EVENT_TAG_GROUP, SPE_EVENTS_ENABLE, SPE_EXIT, SPE_MAP_PS,
    SPE_RUNTIME_EXCEPTION, SPE_TAG_ANY, SpeEventData, SpeEventUnit,
};

use crate::support::{Aligned, Context, assert_fails, assert_null, elsewhere};

const MSSYNC: u32 = 0;
const COMMAND: u32 = 1;
const CONTROL: u32 = 2;
const SIGNAL_1: u32 = 3;
const SIGNAL_2: u32 = 4;

#[derive(Clone, Copy)]
struct Area(*mut u32);

impl Area {
    fn of(context: &Context, number: u32) -> Self {
        let area = unsafe { spe_ps_area_get(context.pointer(), number) };
        assert!(!area.is_null());
        Self(area.cast())
    }

    fn load(self, offset: usize) -> u32 {
        unsafe { self.0.byte_add(offset).read_volatile() }
    }

    fn store(self, offset: usize, value: u32) {
        unsafe { self.0.byte_add(offset).write_volatile(value) };
    }
}

fn mapped(source: &str) -> Context {
    let context = Context::new(SPE_MAP_PS | SPE_EVENTS_ENABLE);
    context.load(source);
    context
}

/// Sends the sum of a word of each mailbox and signal register, and the first again.
const SUM: &str = "
        rdch    $3,$ch29
        rdch    $4,$ch3
        rdch    $5,$ch4
        a       $6,$3,$4
        a       $6,$6,$5
        wrch    $ch28,$6
        wrch    $ch30,$3
        stop    0x2007
";

#[test]
fn mailboxes_and_signals_are_registers() {
    let context = mapped(SUM);
    let control = Area::of(&context, CONTROL);
    assert_eq!(control.load(0x14), 4 << 8);
    control.store(0xc, 100);
    control.store(0xc, 7);
    assert_eq!(control.load(0x14), 2 << 8);
    Area::of(&context, SIGNAL_1).store(0xc, 20);
    Area::of(&context, SIGNAL_2).store(0xc, 3);
    assert_eq!(control.load(0x24), 0);
    let stop = elsewhere(|| context.run(), || ());
    assert_eq!((stop.reason, stop.code), (SPE_EXIT, 7));
    assert_eq!(control.load(0x14), 1 << 16 | 3 << 8 | 1);
    assert_eq!(control.load(0x4), 123);
    assert_eq!(control.load(0x14), 1 << 16 | 3 << 8, "reading takes the word");
    assert_eq!(control.load(0x24), 0x2007_0002);
    assert_eq!(control.load(0x34), 32);
}

/// Writes the registers of a command, in their order.
fn give(command: Area, lsa: u32, ea: u64, size_and_tag: u32, opcode: u32) {
    command.store(0x4, lsa);
    command.store(0x8, (ea >> 32) as u32);
    command.store(0xc, ea as u32);
    command.store(0x10, size_and_tag);
    command.store(0x14, opcode);
}

/// Provenance: see `Sequence` in the library.
#[test]
fn command_without_its_parameters_is_sequence_error() {
    const SEQUENCE_ERROR: u32 = 1;
    let context = mapped("stop 0x2000");
    let mut there = Aligned::<16>::new();
    there.0 = [7; 16];
    let (high, low) = ((there.ea() >> 32) as u32, there.ea() as u32);
    let command = Area::of(&context, COMMAND);
    let status = || command.load(0x14) & 3;
    let lsa = (0x4, 0x8000);
    let ea = [(0x8, high), (0xc, low)];
    let size = (0x10, 16 << 16 | 3);
    let get = (0x14, 0x40);
    assert_eq!(status(), SEQUENCE_ERROR, "nothing was written");
    let wrong: [(&str, &[(usize, u32)]); 8] = [
        ("alone", &[get]),
        ("without the LSA", &[ea[0], ea[1], size, get]),
        ("without the EAH", &[lsa, ea[1], size, get]),
        ("without the EAL", &[lsa, ea[0], size, get]),
        ("without size and tag", &[lsa, ea[0], ea[1], get]),
        ("size before the EA", &[lsa, size, ea[0], ea[1], get]),
        ("the LSA last", &[ea[0], ea[1], size, lsa, get]),
        ("twice", &[lsa, ea[0], ea[1], size, get, get]),
    ];
    for (what, stores) in wrong {
        context.set_local_store(0x8000, &[0; 16]);
        for &(offset, value) in stores {
            command.store(offset, value);
        }
        assert_eq!(status(), SEQUENCE_ERROR, "{what}");
        let found = context.local_store(0x8000, 16);
        let was_given = what == "twice";
        assert_eq!(found == [7; 16], was_given, "{what}");
    }
    // A sequence within another, as by a signal's handler, leaves the first one incomplete.
    command.store(lsa.0, lsa.1);
    give(command, 0x8000, there.ea(), 16 << 16 | 3, 0x40);
    assert_eq!(status(), 0);
    for (offset, value) in [ea[0], ea[1], size, get] {
        command.store(offset, value);
    }
    assert_eq!(status(), SEQUENCE_ERROR);
    // It begins anew with the LSA, and its status is read once.
    command.store(0x8, high);
    give(command, 0x8000, there.ea(), 16 << 16 | 3, 0x40);
    assert_eq!([status(), status()], [0, SEQUENCE_ERROR]);
    assert_eq!(context.local_store(0x8000, 16), [7; 16]);
}

#[test]
fn commands_are_given_by_registers() {
    let context = mapped("stop 0x2000");
    let mut there = Aligned::<128>::new();
    there.0 = std::array::from_fn(|n| n as u8);
    let command = Area::of(&context, COMMAND);
    assert_eq!(command.load(0x104) & 0xffff, 8);
    give(command, 0x8000, there.ea(), 128 << 16 | 5, 0x40);
    assert_eq!(command.load(0x14) & 3, 0);
    command.store(0x21c, 1 << 5);
    assert_eq!(command.load(0x22c), 1 << 5);
    assert_eq!(context.local_store(0x8000, 128), there.0);
    // An error is reported by the run, as nobody checks the command.
    give(command, 0x8000, there.ea(), 24 << 16, 0x40);
    assert_eq!(command.load(0x14) & 3, 0);
    let stop = elsewhere(|| context.run(), || ());
    assert_eq!((stop.reason, stop.code), (SPE_RUNTIME_EXCEPTION, 8));
}

#[test]
fn functions_equal_problem_state_registers() {
    let context = mapped("stop 0x2000");
    let mut there = Aligned::<16>::new();
    there.0 = [9; 16];
    let mut status = 0;
    unsafe {
        assert_eq!(spe_mfcio_get(context.pointer(), 0x9000, there.pointer(), 16, 2, 0, 0), 0);
        for mask in [0, 1 << 2] {
            let status = &raw mut status;
            let read = spe_mfcio_tag_status_read(context.pointer(), mask, SPE_TAG_ANY, status);
            assert_eq!(read, 0);
            assert_eq!(*status, 1 << 2);
        }
        assert_eq!(spe_mssync_start(context.pointer()), 0);
        assert_eq!(spe_mssync_status(context.pointer()), 0);
        Area::of(&context, MSSYNC).store(0, 1);
        assert_eq!(Area::of(&context, MSSYNC).load(0), 0);
        let handler = spe_event_handler_create();
        let mut unit = SpeEventUnit {
            events: SPE_EVENT_TAG_GROUP,
            spe: context.pointer(),
            data: SpeEventData { u64: 0 },
        };
        assert_fails(spe_event_handler_register(handler, &raw mut unit), libc::ENOTSUP);
        assert_eq!(spe_event_handler_destroy(handler), 0);
        assert_null(spe_ps_area_get(context.pointer(), 5), libc::EINVAL);
    }
    assert_eq!(context.local_store(0x9000, 16), [9; 16]);
}

/// One SPE sends a signal to the address of another's register.
#[test]
fn spes_send_signals_to_areas() {
    let receiver = mapped("rdch $3,$ch3\n wrch $ch28,$3\n stop 0x2000");
    let sender = Context::owning(unsafe { spe_context_create(0, ptr::null_mut()) });
    sender.load(
        "
        ori     $2,$4,0
        rotqbyi $10,$4,4
        command SNDSIG, 0x800c, $10, 4, 0
        wait_tags 1
        stop    0x2000
",
    );
    let register = unsafe { Area::of(&receiver, SIGNAL_1).0.byte_add(0xc) };
    let ea = register.expose_provenance() as u64;
    // The word is the last of its quadword, as the register is.
    sender.set_local_store(0x800c, &0x1234_u32.to_be_bytes());
    let run = || sender.run_from(SPE_DEFAULT_ENTRY, 0, ea, 0);
    let stop = elsewhere(run, || ());
    assert_eq!(stop.reason, SPE_EXIT);
    let stop = elsewhere(|| receiver.run(), || ());
    assert_eq!(stop.reason, SPE_EXIT);
    assert_eq!(Area::of(&receiver, CONTROL).load(4), 0x1234);
}
