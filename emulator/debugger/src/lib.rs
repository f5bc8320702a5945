//! A debugger's view of emulated SPEs: a server of gdb's remote protocol, for which each SPE is a
//! thread.
//!
//! A thread that runs an SPE looks before each instruction whether it must halt
//! ([`Attached::before_instruction`]). If one halts, all halt. The server has a thread of its own.
//!
//! Invariant: what the server shows of an SPE is its state before the instruction at its program
//! counter. An SPE that sleeps in a channel, or that waits for its turn in simulated time, does not
//! get to its next instruction while the others halt. It is shown as it went into the instruction,
//! and its registers can't be changed. If something wakes it, it completes that instruction.

mod accesses;
pub mod client;
pub mod console;
mod registers;
mod server;
mod state;
mod target;

use std::io::{self, Read, Write};
use std::net::{Ipv4Addr, SocketAddr, TcpListener};
use std::ops::ControlFlow;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::Duration;

use gdbstub::common::Tid;
use spu_emulator::interp::Spu;
use spu_emulator::simulated::HelperThread;
use spu_emulator::spe::Spe;
use spu_emulator::stop::{Stop, Stopped};

use state::{Halt, State};

/// How a program ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// With this exit status.
    Exit(u8),
    /// The gdb signal that ended the program.
    Signal(u8),
}

/// gdb's number of the signal that Linux raises for such a stop, if it is a fault.
#[must_use]
pub fn signal_of(reason: &Stop) -> Option<u8> {
    const TRAP: u16 = 0x3fff;
    const SIGILL: u8 = 4;
    const SIGTRAP: u8 = 5;
    const SIGABRT: u8 = 6;
    const SIGBUS: u8 = 10;
    match reason {
        Stop::InvalidInstruction(_) => Some(SIGILL),
        Stop::Dma(_) => Some(SIGBUS),
        Stop::Signal(TRAP) => Some(SIGTRAP),
        Stop::Signal(_) | Stop::Requested | Stop::Waits => None,
        Stop::Halt | Stop::InvalidChannel(..) => Some(SIGABRT),
    }
}

/// The SPEs of a process or machine, as a debugger sees them.
pub struct Debugger {
    state: Mutex<State>,
    changed: Condvar,
    /// What the debugger's command `kill` does, before it ends the runs.
    kill: fn(),
}

impl Debugger {
    /// Without a server. `kill` ends the program when the debugger asks for it.
    #[must_use]
    pub fn new(kill: fn()) -> Arc<Self> {
        Arc::new(Self { state: Mutex::default(), changed: Condvar::new(), kill })
    }

    /// Serves one debugger after the other on this port of the loopback interface, from a thread of
    /// its own. Until the first has come, the SPEs wait. Returns the server's address.
    pub fn listen(self: &Arc<Self>, port: u16) -> io::Result<SocketAddr> {
        let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, port))?;
        let address = listener.local_addr()?;
        self.lock().halted = true;
        let debugger = Arc::clone(self);
        let serve = move || {
            let _helper = HelperThread::current();
            for stream in listener.incoming().flatten() {
                // A connection that fails is over, and the next one is served.
                let _ = stream.set_nodelay(true);
                if let Ok(reader) = stream.try_clone() {
                    debugger.serve(reader, stream);
                }
            }
        };
        thread::Builder::new().name("gdb".into()).spawn(serve)?;
        Ok(address)
    }

    /// Serves one debugger until it leaves or its stream ends, from the first instruction of an SPE
    /// on. All SPEs halt at first.
    pub fn serve(self: &Arc<Self>, reader: impl Read + Send + 'static, writer: impl Write) {
        server::converse(self, reader, writer);
    }

    /// Adds an SPE, which is a thread until the value is dropped.
    pub fn attach(self: &Arc<Self>, spe: &Arc<Spe>) -> Attached {
        let number = self.change(|state| state.add(spe));
        Attached { debugger: Arc::clone(self), number }
    }

    /// Notifies the debugger that the program has ended, and waits until it has handled that.
    pub fn ended(&self, end: End) {
        let mut state = self.lock();
        state.end = Some(end);
        state.nudge();
        while state.is_connected() && !state.killed {
            state = self.wait(state);
        }
    }

    /// Whether the debugger has killed the program.
    #[must_use]
    pub fn has_killed(&self) -> bool {
        self.lock().killed
    }

    fn lock(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn wait<'a>(&self, state: MutexGuard<'a, State>) -> MutexGuard<'a, State> {
        let waited = self.changed.wait(state);
        waited.unwrap_or_else(PoisonError::into_inner)
    }

    /// Changes the state, and wakes all who wait for a change.
    fn change<T>(&self, change: impl FnOnce(&mut State) -> T) -> T {
        let result = change(&mut self.lock());
        self.changed.notify_all();
        result
    }

    /// Waits for the first instruction of an SPE.
    fn wait_for_an_spe(&self) {
        let mut state = self.lock();
        while !state.started || state.threads.is_empty() {
            state = self.wait(state);
        }
    }

    /// Waits until each SPE has halted or sleeps in an instruction.
    fn settle(&self) {
        // There is no notification when an SPE falls asleep.
        const LOOK_EVERY: Duration = Duration::from_millis(1);
        let mut state = self.lock();
        while state.halted && state.is_any_awake() {
            let waited = self.changed.wait_timeout(state, LOOK_EVERY);
            state = waited.unwrap_or_else(PoisonError::into_inner).0;
        }
    }

    fn kill(&self) {
        (self.kill)();
        let spes = self.change(|state| {
            state.killed = true;
            state.spes()
        });
        for spe in spes {
            spe.request_stop();
        }
    }
}

/// An SPE as a debugger's thread.
pub struct Attached {
    debugger: Arc<Debugger>,
    number: Tid,
}

impl Attached {
    /// The SPE is about to run the instruction at its program counter. Halts there, if it must, and
    /// makes the debugger's changes. Breaks if the debugger has killed the program.
    pub fn before_instruction(&self, spu: &mut Spu, cycles: Option<u64>) -> ControlFlow<()> {
        let mut state = self.debugger.lock();
        if state.arrive(self.number, spu, cycles) {
            self.debugger.changed.notify_all();
        }
        loop {
            if state.killed {
                return ControlFlow::Break(());
            }
            if state.may_go(self.number) {
                state.change_registers(self.number, spu);
                let Some(halt) = state.reason(self.number) else {
                    state.leave(self.number, spu);
                    return ControlFlow::Continue(());
                };
                state.halt(self.number, halt);
            }
            state.park(self.number);
            self.debugger.changed.notify_all();
            state = self.debugger.wait(state);
        }
    }

    /// The SPE has stopped. If that ends the program with a signal, everything halts before, so
    /// that the user can look.
    pub fn stopped(&self, spe: &Spe, stopped: &Stopped, signal: Option<u8>) {
        spe.with_spu(|spu| {
            self.debugger.change(|state| state.stop(self.number, spu, stopped.pc));
        });
        if let Some(signal) = signal {
            let mut state = self.until_it_may_go(self.debugger.lock());
            if state.is_connected() && !state.killed {
                state.halt(self.number, Halt::Signal(signal));
                self.debugger.changed.notify_all();
                drop(self.until_it_may_go(state));
            }
        }
    }

    fn until_it_may_go<'a>(&self, mut state: MutexGuard<'a, State>) -> MutexGuard<'a, State>
    where
        Self: 'a,
    {
        while !state.may_go(self.number) && !state.killed {
            state = self.debugger.wait(state);
        }
        state
    }
}

impl Drop for Attached {
    fn drop(&mut self) {
        self.debugger.change(|state| state.remove(self.number));
    }
}
