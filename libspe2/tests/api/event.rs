//! Event handlers, with which one thread waits for many contexts.

use std::ffi::c_void;
use std::ptr;
use std::time::{Duration, Instant};

use spe2::event::{
    spe_event_handler_create, spe_event_handler_deregister, spe_event_handler_destroy,
    spe_event_handler_register, spe_event_wait,
};
use spe2::mailbox::{spe_in_mbox_write, spe_out_intr_mbox_read};
use spe2::mfc::{spe_mfcio_put, spe_mfcio_tag_status_read};
use spe2::run::spe_stop_info_read;
use spe2::types::{
    SPE_EVENT_IN_MBOX, SPE_EVENT_OUT_INTR_MBOX, SPE_EVENT_SPE_STOPPED, SPE_EVENT_TAG_GROUP,
    SPE_EVENTS_ENABLE, SPE_MBOX_ALL_BLOCKING, SPE_MBOX_ANY_NONBLOCKING, SPE_TAG_ALL, SpeContext,
    SpeEventData, SpeEventUnit,
};

use crate::support::{Aligned, Context, assert_fails, elsewhere, no_stop_info};

struct Handler(*mut c_void);

impl Drop for Handler {
    fn drop(&mut self) {
        assert_eq!(unsafe { spe_event_handler_destroy(self.0) }, 0);
    }
}

fn unit(spe: *mut SpeContext, events: u32, data: u64) -> SpeEventUnit {
    SpeEventUnit { events, spe, data: SpeEventData { u64: data } }
}

impl Handler {
    fn new() -> Self {
        let pointer = unsafe { spe_event_handler_create() };
        assert!(!pointer.is_null());
        Self(pointer)
    }

    fn register(&self, context: &Context, events: u32, data: u64) -> i32 {
        let mut unit = unit(context.pointer(), events, data);
        unsafe { spe_event_handler_register(self.0, &raw mut unit) }
    }

    fn deregister(&self, context: &Context, events: u32) -> i32 {
        let mut unit = unit(context.pointer(), events, 0);
        unsafe { spe_event_handler_deregister(self.0, &raw mut unit) }
    }

    /// The events that are up: (context, event, data).
    fn wait(&self, most: usize, timeout: i32) -> Vec<(*mut SpeContext, u32, u64)> {
        let mut units = vec![unit(ptr::null_mut(), 0, 0); most];
        let count = unsafe { spe_event_wait(self.0, units.as_mut_ptr(), most as i32, timeout) };
        assert!(count >= 0);
        units.truncate(count as usize);
        units.iter().map(|unit| (unit.spe, unit.events, unsafe { unit.data.u64 })).collect()
    }
}

#[test]
fn arguments() {
    let handler = Handler::new();
    let context = Context::new(SPE_EVENTS_ENABLE);
    let without_events = Context::new(0);
    let mut good = unit(context.pointer(), SPE_EVENT_IN_MBOX, 0);
    let mut no_context = unit(ptr::null_mut(), SPE_EVENT_IN_MBOX, 0);
    let mut units = [good; 1];
    let calls = [spe_event_handler_register, spe_event_handler_deregister];
    unsafe {
        for call in calls {
            assert_fails(call(ptr::null_mut(), &raw mut good), libc::ESRCH);
            assert_fails(call(handler.0, ptr::null_mut()), libc::EINVAL);
            assert_fails(call(handler.0, &raw mut no_context), libc::EINVAL);
            let mut unit = unit(without_events.pointer(), SPE_EVENT_IN_MBOX, 0);
            assert_fails(call(handler.0, &raw mut unit), libc::ENOTSUP);
            unit.spe = context.pointer();
            unit.events = 0x10;
            assert_fails(call(handler.0, &raw mut unit), libc::ENOTSUP);
            unit.events = 0;
            assert_eq!(call(handler.0, &raw mut unit), 0);
        }
        assert_fails(spe_event_handler_destroy(ptr::null_mut()), libc::ESRCH);
        let array = units.as_mut_ptr();
        assert_fails(spe_event_wait(ptr::null_mut(), array, 1, 0), libc::ESRCH);
        assert_fails(spe_event_wait(handler.0, ptr::null_mut(), 1, 0), libc::EINVAL);
        assert_fails(spe_event_wait(handler.0, array, 0, 0), libc::EINVAL);
        assert_fails(spe_event_wait(handler.0, array, -1, 0), libc::EINVAL);
    }
    assert_eq!(handler.register(&context, SPE_EVENT_IN_MBOX, 0), 0);
    assert_fails(handler.register(&context, SPE_EVENT_IN_MBOX, 0), libc::EEXIST);
    assert_fails(handler.deregister(&context, SPE_EVENT_TAG_GROUP), libc::ENOENT);
    assert_eq!(handler.deregister(&context, SPE_EVENT_IN_MBOX), 0);
    assert_fails(handler.deregister(&context, SPE_EVENT_IN_MBOX), libc::ENOENT);
}

#[test]
fn event_wait_times_out() {
    let handler = Handler::new();
    let context = Context::new(SPE_EVENTS_ENABLE);
    assert_eq!(handler.register(&context, SPE_EVENT_OUT_INTR_MBOX, 0), 0);
    assert_eq!(handler.wait(1, 0), []);
    let begin = Instant::now();
    assert_eq!(handler.wait(1, 50), []);
    assert!(begin.elapsed() >= Duration::from_millis(50));
}

#[test]
fn inbound_mailbox_event_is_set_until_mailbox_is_full() {
    let handler = Handler::new();
    let context = Context::new(SPE_EVENTS_ENABLE);
    assert_eq!(handler.register(&context, SPE_EVENT_IN_MBOX, 77), 0);
    let mut words = [0; 4];
    let up = [(context.pointer(), SPE_EVENT_IN_MBOX, 77)];
    assert_eq!(handler.wait(4, 0), up);
    assert_eq!(handler.wait(4, -1), up);
    let data = words.as_mut_ptr();
    let written = unsafe { spe_in_mbox_write(context.pointer(), data, 4, SPE_MBOX_ALL_BLOCKING) };
    assert_eq!(written, 4);
    assert_eq!(handler.wait(4, 0), []);
}

/// Waits for a word and sends it back through the interrupt mailbox. A 0 ends the program.
const ECHO: &str = "
again:  rdch    $10,$ch29
        brz     $10,done
        wrch    $ch30,$10
        br      again
done:   stop    0x2000
";

fn send(context: &Context, word: u32) {
    let mut word = word;
    let sent =
        unsafe { spe_in_mbox_write(context.pointer(), &raw mut word, 1, SPE_MBOX_ALL_BLOCKING) };
    assert_eq!(sent, 1);
}

#[test]
fn one_thread_waits_for_two_contexts() {
    let contexts = [Context::with_program(ECHO), Context::with_program(ECHO)];
    let handler = Handler::new();
    for (n, context) in contexts.iter().enumerate() {
        let events = SPE_EVENT_OUT_INTR_MBOX | SPE_EVENT_SPE_STOPPED;
        assert_eq!(handler.register(context, events, n as u64), 0);
    }
    let meanwhile = || {
        for round in 1..=100 {
            let n = round as usize % 2;
            send(&contexts[n], round);
            let up = handler.wait(4, 600_000);
            let expected = [(contexts[n].pointer(), SPE_EVENT_OUT_INTR_MBOX, n as u64)];
            assert_eq!(up, expected);
            let mut word = 0;
            let read = unsafe {
                spe_out_intr_mbox_read(
                    contexts[n].pointer(),
                    &raw mut word,
                    1,
                    SPE_MBOX_ANY_NONBLOCKING,
                )
            };
            assert_eq!((read, word), (1, round));
        }
        for (n, context) in contexts.iter().enumerate() {
            send(context, 0);
            let up = handler.wait(4, 600_000);
            assert_eq!(up, [(context.pointer(), SPE_EVENT_SPE_STOPPED, n as u64)]);
            let mut info = no_stop_info();
            assert_eq!(unsafe { spe_stop_info_read(context.pointer(), &raw mut info) }, 0);
            assert_eq!(info.stop_reason, 1);
        }
        assert_eq!(handler.wait(4, 0), []);
    };
    let run = || {
        std::thread::scope(|scope| {
            let second = scope.spawn(|| contexts[1].run().returned);
            (contexts[0].run().returned, second.join().unwrap())
        })
    };
    assert_eq!(elsewhere(run, meanwhile), (0, 0));
}

#[test]
fn stop_events_are_queued_while_registered() {
    let context = Context::with_program("stop 0x2001\n stop 0x2002\n");
    let handler = Handler::new();
    assert_eq!(handler.register(&context, SPE_EVENT_SPE_STOPPED, 0), 0);
    let first = elsewhere(|| context.run(), || ());
    elsewhere(|| context.run_from(first.entry, 0, 0, 0), || ());
    for expected in [1, 2] {
        assert_eq!(handler.wait(1, 0).len(), 1);
        let mut info = no_stop_info();
        assert_eq!(unsafe { spe_stop_info_read(context.pointer(), &raw mut info) }, 0);
        assert_eq!(unsafe { info.result.code }, expected);
    }
    assert_eq!(handler.wait(1, 0), []);
}

#[test]
fn tag_event_is_set_until_read() {
    let context = Context::new(SPE_EVENTS_ENABLE);
    let handler = Handler::new();
    assert_eq!(handler.register(&context, SPE_EVENT_TAG_GROUP, 5), 0);
    assert_eq!(handler.wait(1, 0), []);
    let mut there = Aligned::<16>::new();
    context.while_it_runs(|| {
        let put = unsafe { spe_mfcio_put(context.pointer(), 0, there.pointer(), 16, 3, 0, 0) };
        assert_eq!(put, 0);
    });
    assert_eq!(handler.wait(1, 600_000), [(context.pointer(), SPE_EVENT_TAG_GROUP, 5)]);
    let mut status = 0;
    let read =
        unsafe { spe_mfcio_tag_status_read(context.pointer(), 0, SPE_TAG_ALL, &raw mut status) };
    assert_eq!((read, status), (0, 8));
    assert_eq!(handler.wait(1, 0), []);
}

#[test]
fn event_count_is_limited_by_argument() {
    let contexts: Vec<Context> = (0..3).map(|_| Context::new(SPE_EVENTS_ENABLE)).collect();
    let handler = Handler::new();
    for context in &contexts {
        assert_eq!(handler.register(context, SPE_EVENT_IN_MBOX, 0), 0);
    }
    assert_eq!(handler.wait(2, 0).len(), 2);
    assert_eq!(handler.wait(9, 0).len(), 3);
}
