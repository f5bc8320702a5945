//! One debugger's session.

use std::io::{self, Read, Write};
use std::sync::Arc;
use std::sync::mpsc::{self, Receiver, Sender};
use std::thread;

use gdbstub::common::{Signal, Tid};
use gdbstub::conn::Connection;
use gdbstub::stub::state_machine::GdbStubStateMachine as Machine;
use gdbstub::stub::{DisconnectReason, GdbStub, MultiThreadStopReason};
use spu_emulator::simulated::HelperThread;

use crate::state::Halt;
use crate::target::Target;
use crate::{Debugger, End};

/// What the server waits for.
pub enum Event {
    /// The debugger has sent bytes.
    Received(Vec<u8>),
    /// The debugger is gone.
    Closed,
    /// A halt or the end is to be reported.
    News,
}

/// The server's side of the stream.
struct Output<W>(W);

impl<W: Write> Connection for Output<W> {
    type Error = io::Error;

    fn write(&mut self, byte: u8) -> io::Result<()> {
        self.0.write_all(&[byte])
    }

    fn write_all(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.0.write_all(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.0.flush()
    }
}

/// Passes on what the debugger sends, from a thread of its own.
fn receive(mut reader: impl Read + Send + 'static, to: Sender<Event>) -> io::Result<()> {
    let receive = move || {
        let _helper = HelperThread::current();
        let mut bytes = [0; 4096];
        while let Ok(length @ 1..) = reader.read(&mut bytes) {
            if to.send(Event::Received(bytes[..length].to_vec())).is_err() {
                return;
            }
        }
        // Nobody minds if the session is over already.
        let _ = to.send(Event::Closed);
    };
    thread::Builder::new().spawn(receive).map(drop)
}

/// Serves one debugger until it leaves, its stream ends, or the program does.
pub fn converse(debugger: &Arc<Debugger>, reader: impl Read + Send + 'static, writer: impl Write) {
    let (sender, events) = mpsc::channel();
    debugger.wait_for_an_spe();
    if receive(reader, sender.clone()).is_ok() {
        debugger.change(|state| state.connect(sender));
        debugger.settle();
        // What is wrong with a connection ends it, and the user sees that on his side.
        let reason = exchange(debugger, Output(writer), &events);
        if reason == Some(DisconnectReason::Kill) {
            debugger.kill();
        }
        debugger.change(|state| state.disconnect());
    }
}

/// Returns why the session has ended, or `None` if the connection has failed.
fn exchange<W: Write>(
    debugger: &Arc<Debugger>,
    output: Output<W>,
    events: &Receiver<Event>,
) -> Option<DisconnectReason> {
    let mut target = Target::new(debugger);
    let mut machine = GdbStub::new(output).run_state_machine(&mut target).ok()?;
    let mut received = Vec::new().into_iter();
    loop {
        machine = match machine {
            Machine::Disconnected(machine) => return Some(machine.get_reason()),
            Machine::CtrlCInterrupt(machine) => {
                let reason = interrupt(debugger);
                machine.interrupt_handled(&mut target, Some(reason)).ok()?
            }
            Machine::Running(running) => match news(debugger) {
                Some(reason) => running.report_stop(&mut target, reason).ok()?,
                None => match next(&mut received, events)? {
                    Some(byte) => running.incoming_data(&mut target, byte).ok()?,
                    None => running.into(),
                },
            },
            Machine::Idle(idle) => match next(&mut received, events)? {
                Some(byte) => idle.incoming_data(&mut target, byte).ok()?,
                None => idle.into(),
            },
        };
    }
}

/// The next byte from the debugger, or `Some(None)` if there are news. `None` is the end.
fn next(received: &mut std::vec::IntoIter<u8>, events: &Receiver<Event>) -> Option<Option<u8>> {
    loop {
        if let Some(byte) = received.next() {
            return Some(Some(byte));
        }
        match events.recv() {
            Ok(Event::Received(bytes)) => *received = bytes.into_iter(),
            Ok(Event::News) => return Some(None),
            Ok(Event::Closed) | Err(_) => return None,
        }
    }
}

/// What is to be reported while the program runs.
fn news(debugger: &Debugger) -> Option<MultiThreadStopReason<u32>> {
    let pending = debugger.lock().pending.take();
    if let Some(halt) = pending {
        debugger.settle();
        return Some(stop_reason(halt));
    }
    let end = debugger.lock().end?;
    Some(match end {
        End::Exit(status) => MultiThreadStopReason::Exited(status),
        End::Signal(signal) => MultiThreadStopReason::Terminated(Signal(signal)),
    })
}

/// The user interrupts: all threads halt. One that has just halted by itself comes first.
fn interrupt(debugger: &Debugger) -> MultiThreadStopReason<u32> {
    debugger.change(|state| state.halted = true);
    debugger.settle();
    let mut state = debugger.lock();
    match state.pending.take() {
        Some(halt) => stop_reason(halt),
        None => match state.threads.keys().next() {
            Some(&tid) => MultiThreadStopReason::SignalWithThread { tid, signal: Signal::SIGINT },
            None => MultiThreadStopReason::Signal(Signal::SIGINT),
        },
    }
}

fn stop_reason((tid, halt): (Tid, Halt)) -> MultiThreadStopReason<u32> {
    let signal = |signal| MultiThreadStopReason::SignalWithThread { tid, signal };
    match halt {
        Halt::Stepped => signal(Signal::SIGTRAP),
        Halt::Breakpoint => MultiThreadStopReason::SwBreak(tid),
        Halt::Accessed(kind, addr) => MultiThreadStopReason::Watch { tid, kind, addr },
        Halt::Signal(number) => signal(Signal(number)),
    }
}
