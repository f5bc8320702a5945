//! A server for gdb's remote protocol: `spu run --gdb PORT`.
//!
//! The server and the SPU share a thread: while the program runs, the server looks for an
//! interrupt every few thousand instructions. A watchpoint stops the program when the watched bytes
//! have changed, whoever changed them, DMA included.

mod registers;
mod target;

use std::io;
use std::net::{Ipv4Addr, TcpListener};

use gdbstub::common::Signal;
use gdbstub::conn::ConnectionExt;
use gdbstub::stub::run_blocking::{BlockingEventLoop, Event, WaitForStopReasonError};
use gdbstub::stub::{DisconnectReason, GdbStub, SingleThreadStopReason};
use gdbstub::target::ext::breakpoints::WatchKind;
use spu_emulator::stop::Stop;

use super::bench::Bench;
use super::error::RunError;
use super::machine::{End, Machine};
use target::{Debugger, Halt};

/// Instructions between two looks for an interrupt.
const BETWEEN_LOOKS: u32 = 4096;

/// Waits for a debugger on this port of the loopback interface and obeys it. Returns how the
/// program ended, or `None` if the debugger left before.
pub fn serve(
    port: u16,
    machine: &mut Machine,
    bench: &mut Bench<'_>,
) -> Result<Option<End>, RunError> {
    let failed = |error: io::Error| {
        let what = error.to_string();
        RunError::Debugger { port, what }
    };
    let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, port)).map_err(failed)?;
    let address = listener.local_addr().map_err(failed)?;
    eprintln!("spu: waiting for a debugger: target remote {address}");
    let (stream, _) = listener.accept().map_err(failed)?;
    let mut debugger = Debugger::new(machine, bench);
    let connection: Box<dyn ConnectionExt<Error = io::Error>> = Box::new(stream);
    match GdbStub::new(connection).run_blocking::<Loop<'_, '_>>(&mut debugger) {
        Ok(DisconnectReason::Disconnect) => Ok(debugger.end),
        Ok(DisconnectReason::Kill) => Ok(Some(End::Killed(debugger.machine.at()))),
        Ok(_) => Ok(debugger.end),
        Err(error) => {
            let what = error.to_string();
            Err(RunError::Debugger { port, what })
        }
    }
}

struct Loop<'a, 'b>(std::marker::PhantomData<Debugger<'a, 'b>>);

type Stopped = SingleThreadStopReason<u32>;

impl<'a, 'b> BlockingEventLoop for Loop<'a, 'b> {
    type Target = Debugger<'a, 'b>;
    type Connection = Box<dyn ConnectionExt<Error = io::Error>>;
    type StopReason = Stopped;

    fn wait_for_stop_reason(
        debugger: &mut Debugger<'a, 'b>,
        connection: &mut Self::Connection,
    ) -> Result<Event<Stopped>, WaitForStopReasonError<std::convert::Infallible, io::Error>> {
        let mut left = 0;
        loop {
            if left == 0 {
                let waiting = connection
                    .peek()
                    .map_err(WaitForStopReasonError::Connection)?;
                if waiting.is_some() {
                    let byte = connection
                        .read()
                        .map_err(WaitForStopReasonError::Connection)?;
                    return Ok(Event::IncomingData(byte));
                }
                left = BETWEEN_LOOKS;
            }
            left -= 1;
            if let Some(halt) = debugger.step() {
                return Ok(Event::TargetStopped(stop_reason(halt, debugger)));
            }
        }
    }

    fn on_interrupt(_: &mut Debugger<'a, 'b>) -> Result<Option<Stopped>, std::convert::Infallible> {
        Ok(Some(Stopped::Signal(Signal::SIGINT)))
    }
}

fn stop_reason(halt: Halt, debugger: &Debugger<'_, '_>) -> Stopped {
    match halt {
        Halt::Stepped => Stopped::DoneStep,
        Halt::Breakpoint => Stopped::SwBreak(()),
        Halt::Changed(addr) => Stopped::Watch {
            tid: (),
            kind: WatchKind::Write,
            addr,
        },
        // The user can still look at the program. It ends when it is to go on.
        Halt::Failing => Stopped::Signal(signal(debugger.end.as_ref())),
        Halt::Ended => match &debugger.end {
            Some(End::Exit(code)) => Stopped::Exited(*code),
            end => Stopped::Terminated(signal(end.as_ref())),
        },
    }
}

/// The signal that Linux raises for such an end.
fn signal(end: Option<&End>) -> Signal {
    match end {
        Some(End::Fault(stopped)) => match &stopped.reason {
            Stop::InvalidInstruction(_) => Signal::SIGILL,
            Stop::Dma(_) => Signal::SIGBUS,
            Stop::Signal(0x3fff) => Signal::SIGTRAP,
            _ => Signal::SIGABRT,
        },
        Some(End::Call(..)) => Signal::SIGSYS,
        _ => Signal::SIGABRT,
    }
}
