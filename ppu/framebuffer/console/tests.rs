//! Tests of the console's logic with a terminal that records its calls.

use super::super::ioctl::KD_TEXT;
use super::*;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Arc, Mutex};

#[derive(Clone, Copy, Debug, PartialEq)]
enum Call {
    Mode(i32),
    Changes(VtMode),
    Acknowledge(i32),
    Discard,
}

/// The calls of a terminal, and the number that it reports to be on the screen.
#[derive(Clone, Default)]
struct Notes {
    calls: Arc<Mutex<Vec<Call>>>,
    on_screen: Arc<Mutex<Option<u16>>>,
}

impl Notes {
    /// The calls since the last question.
    fn calls(&self) -> Vec<Call> {
        std::mem::take(&mut *self.calls.lock().unwrap())
    }

    fn note(&self, call: Call) {
        self.calls.lock().unwrap().push(call);
    }

    fn show(&self, terminal: Option<u16>) {
        *self.on_screen.lock().unwrap() = terminal;
    }
}

struct Noted {
    found: io::Result<i32>,
    denied: bool,
    /// Whether no other terminal waits for the screen.
    unasked: bool,
    changes: Option<VtMode>,
    notes: Notes,
}

const UNKNOWN: i32 = libc::ENOTTY;

impl Terminal for Noted {
    fn mode(&self) -> io::Result<i32> {
        self.found.as_ref().copied().map_err(|error| io::Error::from(error.kind()))
    }

    fn set_mode(&mut self, mode: i32) -> io::Result<()> {
        self.notes.note(Call::Mode(mode));
        if self.denied { Err(io::Error::from(io::ErrorKind::PermissionDenied)) } else { Ok(()) }
    }

    fn on_screen(&self) -> io::Result<u16> {
        let shown = *self.notes.on_screen.lock().unwrap();
        shown.ok_or(io::Error::from_raw_os_error(UNKNOWN))
    }

    fn changes(&self) -> io::Result<VtMode> {
        self.changes.ok_or(io::Error::from_raw_os_error(UNKNOWN))
    }

    fn set_changes(&self, changes: VtMode) -> io::Result<()> {
        self.notes.note(Call::Changes(changes));
        Ok(())
    }

    fn acknowledge(&self, reply: i32) -> io::Result<()> {
        self.notes.note(Call::Acknowledge(reply));
        if self.unasked { Err(io::Error::from(io::ErrorKind::InvalidInput)) } else { Ok(()) }
    }

    fn discard_input(&self) {
        self.notes.note(Call::Discard);
    }
}

fn noted(found: io::Result<i32>, denied: bool) -> (Box<Noted>, Notes) {
    let notes = Notes::default();
    let noted = Noted { found, denied, unasked: false, changes: None, notes: notes.clone() };
    (Box::new(noted), notes)
}

#[test]
fn previous_mode_is_restored() {
    for found in [KD_TEXT, KD_GRAPHICS] {
        let (terminal, notes) = noted(Ok(found), false);
        drop(Console::take("tty", terminal).unwrap());
        let calls = [Call::Mode(KD_GRAPHICS), Call::Mode(found), Call::Discard];
        assert_eq!(notes.calls(), calls);
    }
}

#[test]
fn previous_mode_is_restored_after_panic() {
    let (terminal, notes) = noted(Ok(KD_TEXT), false);
    let console = Console::take("tty", terminal).unwrap();
    let panicked = catch_unwind(AssertUnwindSafe(move || {
        let _console = console;
        std::panic::resume_unwind(Box::new(()));
    }));
    assert!(panicked.is_err());
    let calls = [Call::Mode(KD_GRAPHICS), Call::Mode(KD_TEXT), Call::Discard];
    assert_eq!(notes.calls(), calls);
}

#[test]
fn file_without_terminal_requests_is_not_changed() {
    let (terminal, notes) = noted(Err(io::Error::from_raw_os_error(UNKNOWN)), false);
    assert!(Console::take("tty", terminal).is_err());
    assert_eq!(notes.calls(), []);
    let (terminal, notes) = noted(Ok(KD_TEXT), true);
    assert!(Console::take("tty", terminal).is_err());
    assert_eq!(notes.calls()[0], Call::Mode(KD_GRAPHICS));
}

#[test]
fn screen_is_owned_only_while_own_terminal_is_shown() {
    let (terminal, notes) = noted(Ok(KD_TEXT), false);
    notes.show(Some(2));
    let console = Console::take("tty", terminal).unwrap();
    for (shown, ours) in [(Some(2), true), (Some(3), false), (None, false), (Some(2), true)] {
        notes.show(shown);
        assert_eq!(console.has_the_screen(), ours, "{shown:?}");
    }
    // If the number was unknown at the start, a later one is not trusted.
    let (terminal, notes) = noted(Ok(KD_TEXT), false);
    let console = Console::take("tty", terminal).unwrap();
    assert!(!console.has_the_screen());
    notes.show(Some(2));
    assert!(!console.has_the_screen());
}

/// How the kernel switches terminals by default.
const AUTO: VtMode = VtMode { mode: 0, waitv: 3, relsig: 0, acqsig: 0, frsig: 5 };

#[test]
fn kernel_refuses_terminal_requests_on_other_files() {
    let mut null = VirtualTerminal::open(Path::new("/dev/null")).unwrap();
    let results = [
        null.mode().map(drop),
        null.set_mode(KD_GRAPHICS),
        null.on_screen().map(drop),
        null.changes().map(drop),
        null.set_changes(AUTO),
        null.acknowledge(VT_RELEASED),
    ];
    for result in results {
        // The user-mode emulator returns the second for a request that it doesn't support.
        let unknown = [Some(libc::ENOTTY), Some(libc::ENOSYS)];
        assert!(unknown.contains(&result.unwrap_err().raw_os_error()));
    }
}

/// Each scenario runs in a process of its own, because signals belong to the process.
mod switching {
    use super::*;
    use crate::framebuffer::interrupted::Interrupted;
    use crate::framebuffer::interrupted::tests::in_child;
    use std::thread;
    use std::time::Duration;

    fn raise(signal: i32) {
        signal_hook::low_level::raise(signal).unwrap();
    }

    fn taken() -> (Console, Notes) {
        let (mut terminal, notes) = noted(Ok(KD_TEXT), false);
        terminal.changes = Some(AUTO);
        (Console::take("tty", terminal).unwrap(), notes)
    }

    #[test]
    fn screen_switches_to_another_terminal_and_back() {
        let status = in_child(|| {
            let (mut console, notes) = taken();
            let [Call::Mode(KD_GRAPHICS), Call::Changes(ours)] = notes.calls()[..] else {
                return 1;
            };
            let signals = (i32::from(ours.relsig), i32::from(ours.acqsig));
            assert_eq!(signals, (libc::SIGRTMIN(), libc::SIGRTMIN() + 1));
            assert_eq!((ours.mode, ours.waitv, ours.frsig), (VT_PROCESS, 3, 5));
            for _ in 0..3 {
                assert!(console.request().is_none() && console.come_back());
                assert_eq!(notes.calls(), []);
                raise(signals.0);
                assert_eq!(console.request(), Some(ScreenRequest::Leave));
                console.leave(ScreenRequest::Leave);
                assert_eq!(notes.calls(), [Call::Acknowledge(VT_RELEASED)]);
                // SAFETY: names this thread, which outlives the one that sends to it.
                let waits = unsafe { libc::pthread_self() };
                let kernel = thread::spawn(move || {
                    thread::sleep(Duration::from_millis(50));
                    // SAFETY: the thread is joined before the waiting one ends.
                    unsafe { libc::pthread_kill(waits, libc::SIGRTMIN() + 1) };
                });
                assert!(console.come_back());
                kernel.join().unwrap();
                assert_eq!(notes.calls(), [Call::Acknowledge(VT_ACKACQ)]);
            }
            drop(console);
            let calls = [Call::Changes(AUTO), Call::Mode(KD_TEXT), Call::Discard];
            assert_eq!(notes.calls(), calls);
            7
        });
        assert!(libc::WIFEXITED(status), "{status:#x}");
        assert_eq!(libc::WEXITSTATUS(status), 7);
    }

    #[test]
    fn screen_is_kept_if_no_terminal_waits_for_it() {
        let status = in_child(|| {
            let (mut terminal, notes) = noted(Ok(KD_TEXT), false);
            terminal.changes = Some(AUTO);
            terminal.unasked = true;
            let mut console = Console::take("tty", terminal).unwrap();
            notes.calls();
            raise(libc::SIGRTMIN());
            console.leave(console.request().unwrap());
            // Returns immediately, because nobody would return the screen.
            assert!(console.come_back());
            assert_eq!(notes.calls(), [Call::Acknowledge(VT_RELEASED)]);
            7
        });
        assert!(libc::WIFEXITED(status), "{status:#x}");
        assert_eq!(libc::WEXITSTATUS(status), 7);
    }

    /// A program that starts while another terminal is shown gets the screen without having
    /// released it.
    #[test]
    fn earlier_acquisition_does_not_count_after_a_later_release() {
        let status = in_child(|| {
            let interrupted = Interrupted::install().unwrap();
            let (mut console, _) = taken();
            raise(libc::SIGRTMIN() + 1);
            assert!(console.request().is_none() && console.come_back());
            raise(libc::SIGRTMIN());
            console.leave(console.request().unwrap());
            // Otherwise it would wait forever, as it should.
            raise(libc::SIGTERM);
            assert!(!console.come_back());
            drop(interrupted);
            7
        });
        assert!(libc::WIFEXITED(status), "{status:#x}");
        assert_eq!(libc::WEXITSTATUS(status), 7);
    }

    #[test]
    fn program_without_screen_can_be_ended() {
        let status = in_child(|| {
            let interrupted = Interrupted::install().unwrap();
            let (mut console, notes) = taken();
            raise(libc::SIGRTMIN());
            console.leave(console.request().unwrap());
            raise(libc::SIGTERM);
            assert!(!console.come_back() && console.request().is_none());
            assert_eq!(interrupted.signal(), Some(libc::SIGTERM));
            notes.calls();
            drop(console);
            let calls = [Call::Changes(AUTO), Call::Mode(KD_TEXT), Call::Discard];
            assert_eq!(notes.calls(), calls);
            7
        });
        assert!(libc::WIFEXITED(status), "{status:#x}");
        assert_eq!(libc::WEXITSTATUS(status), 7);
    }

    #[test]
    fn stopped_program_restores_text_mode() {
        let status = in_child(|| {
            let (mut console, notes) = taken();
            let [_, Call::Changes(ours)] = notes.calls()[..] else {
                return 1;
            };
            raise(libc::SIGTSTP);
            assert_eq!(console.request(), Some(ScreenRequest::Stop));
            // SAFETY: waits for the child made here, which continues this process once it is
            // stopped.
            unsafe {
                let stopped = libc::getpid();
                let shell = libc::fork();
                if shell == 0 {
                    let stat = format!("/proc/{stopped}/stat");
                    while !std::fs::read_to_string(&stat).is_ok_and(|stat| stat.contains(") T ")) {
                        libc::usleep(1000);
                    }
                    libc::kill(stopped, libc::SIGCONT);
                    libc::_exit(0);
                }
                console.leave(ScreenRequest::Stop);
                libc::waitpid(shell, std::ptr::null_mut(), 0);
            }
            assert!(console.come_back());
            let calls = [
                Call::Changes(AUTO),
                Call::Mode(KD_TEXT),
                Call::Discard,
                Call::Mode(KD_GRAPHICS),
                Call::Changes(ours),
            ];
            assert_eq!(notes.calls(), calls);
            7
        });
        assert!(libc::WIFEXITED(status), "{status:#x}");
        assert_eq!(libc::WEXITSTATUS(status), 7);
    }
}
