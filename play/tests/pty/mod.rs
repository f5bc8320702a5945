//! A program on a terminal of its own.

use std::fs::File;
use std::io::{Read as _, Write as _};
use std::os::fd::{AsRawFd as _, FromRawFd as _, OwnedFd};
use std::os::unix::process::CommandExt as _;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::mpsc::{self, Receiver};
use std::thread;
use std::time::{Duration, Instant};

/// How long anything may take.
const PATIENCE: Duration = Duration::from_secs(60);

pub struct Pty {
    child: Child,
    ours: File,
    /// Kept open, so that the terminal's state outlives the program.
    theirs: OwnedFd,
    /// The terminal's flags before the program began.
    found: Modes,
    chunks: Receiver<Vec<u8>>,
    bytes: Vec<u8>,
}

/// Flags of a terminal: input, output, control, local.
type Modes = [libc::tcflag_t; 4];

/// Sends a signal.
pub fn signal(process: u32, signal: i32) {
    // SAFETY: the process is a child that has not been waited for.
    assert_eq!(unsafe { libc::kill(process as libc::pid_t, signal) }, 0);
}

impl Pty {
    pub fn start(mut command: Command, columns: u16, rows: u16) -> Self {
        let (mut ours, mut theirs) = (-1, -1);
        let size = window(columns, rows);
        // SAFETY: the call writes two descriptors and reads one winsize.
        let opened = unsafe {
            libc::openpty(
                &raw mut ours,
                &raw mut theirs,
                std::ptr::null_mut(),
                std::ptr::null(),
                &raw const size,
            )
        };
        assert_eq!(opened, 0);
        // SAFETY: both were just opened, and are nobody else's.
        let (ours, theirs) = unsafe { (File::from_raw_fd(ours), OwnedFd::from_raw_fd(theirs)) };
        let found = modes(&theirs);
        let stdio = || Stdio::from(theirs.try_clone().expect("a descriptor"));
        command.stdin(stdio()).stdout(stdio()).stderr(stdio());
        // SAFETY: both calls may be made between fork and exec.
        unsafe {
            command.pre_exec(|| {
                libc::setsid();
                libc::ioctl(0, libc::TIOCSCTTY, 0);
                Ok(())
            });
        }
        let child = command.spawn().expect("the program");
        let mut reader = ours.try_clone().expect("a descriptor");
        let (sender, chunks) = mpsc::channel();
        thread::spawn(move || {
            let mut buffer = vec![0; 1 << 16];
            while let Ok(count @ 1..) = reader.read(&mut buffer) {
                if sender.send(buffer[..count].to_vec()).is_err() {
                    return;
                }
            }
        });
        Self {
            child,
            ours,
            theirs,
            found,
            chunks,
            bytes: Vec::new(),
        }
    }

    pub fn process(&self) -> u32 {
        self.child.id()
    }

    /// All that was written so far.
    pub fn seen(&self) -> String {
        String::from_utf8_lossy(&self.bytes).into_owned()
    }

    pub fn wait_for(&mut self, text: &str) {
        self.wait_until(|seen| seen.contains(text));
    }

    pub fn wait_until(&mut self, is_there: impl Fn(&str) -> bool) {
        let begun = Instant::now();
        while !is_there(&self.seen()) {
            assert!(begun.elapsed() < PATIENCE, "only {:?}", self.seen());
            if let Ok(chunk) = self.chunks.recv_timeout(Duration::from_millis(100)) {
                self.bytes.extend(chunk);
            }
        }
    }

    pub fn type_in(&mut self, text: &str) {
        self.ours.write_all(text.as_bytes()).expect("a terminal");
    }

    pub fn resize(&mut self, columns: u16, rows: u16) {
        let size = window(columns, rows);
        // SAFETY: the call reads one winsize.
        let set = unsafe { libc::ioctl(self.ours.as_raw_fd(), libc::TIOCSWINSZ, &raw const size) };
        assert_eq!(set, 0);
    }

    /// The terminal's flags are others than before the program began.
    pub fn is_taken(&self) -> bool {
        modes(&self.theirs) != self.found
    }

    /// Waits for the program's end.
    pub fn end(&mut self) -> ExitStatus {
        let begun = Instant::now();
        let status = loop {
            while let Ok(chunk) = self.chunks.recv_timeout(Duration::from_millis(20)) {
                self.bytes.extend(chunk);
            }
            if let Some(status) = self.child.try_wait().expect("a child") {
                break status;
            }
            assert!(
                begun.elapsed() < PATIENCE,
                "it does not end: {:?}",
                self.seen()
            );
        };
        while let Ok(chunk) = self.chunks.recv_timeout(Duration::from_millis(100)) {
            self.bytes.extend(chunk);
        }
        status
    }

    /// The terminal is as it was: its flags, its screen, its cursor.
    pub fn assert_restored(&self) {
        assert_eq!(modes(&self.theirs), self.found);
        let seen = self.seen();
        for (begin, end) in [
            ("\x1b[?1049h", "\x1b[?1049l"),
            ("\x1b[?25l", "\x1b[?25h"),
            ("\x1b[>11u", "\x1b[<u"),
            ("\x1b[?1002h", "\x1b[?1002l"),
        ] {
            let (begin, end) = (seen.rfind(begin), seen.rfind(end));
            assert!(begin.is_some() && end > begin, "{begin:?} {end:?}");
        }
    }
}

impl Drop for Pty {
    fn drop(&mut self) {
        // A test that failed leaves no program behind.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

fn modes(terminal: &OwnedFd) -> Modes {
    let mut modes = std::mem::MaybeUninit::<libc::termios>::uninit();
    // SAFETY: the call writes a termios or fails.
    let got = unsafe { libc::tcgetattr(terminal.as_raw_fd(), modes.as_mut_ptr()) };
    assert_eq!(got, 0);
    // SAFETY: it succeeded.
    let modes = unsafe { modes.assume_init() };
    [modes.c_iflag, modes.c_oflag, modes.c_cflag, modes.c_lflag]
}

fn window(columns: u16, rows: u16) -> libc::winsize {
    libc::winsize {
        ws_row: rows,
        ws_col: columns,
        ws_xpixel: 0,
        ws_ypixel: 0,
    }
}
