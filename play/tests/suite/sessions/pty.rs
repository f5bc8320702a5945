//! A program on a terminal of its own.

use std::ffi::CStr;
use std::fs::{self, File};
use std::io::{Read as _, Write as _};
use std::os::fd::{AsRawFd as _, OwnedFd};
use std::os::unix::fs::OpenOptionsExt as _;
use std::os::unix::process::CommandExt as _;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, Receiver};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

/// How long anything may take, on a machine that is busy with other things. It only ends a test
/// that hangs.
const PATIENCE: Duration = Duration::from_secs(600);
/// What the test itself writes to the terminal when the program has ended.
const LAST: &str = "[the program has ended]";

pub struct Pty {
    child: Child,
    /// None once it has hung up.
    ours: Option<File>,
    is_hung_up: Arc<AtomicBool>,
    reader: Option<JoinHandle<()>>,
    /// Kept open, so that the terminal's state outlives the program.
    theirs: OwnedFd,
    /// The terminal's flags before the program began.
    found: Modes,
    chunks: Receiver<Vec<u8>>,
    bytes: Vec<u8>,
}

/// Flags of a terminal: input, output, control, local.
type Modes = [libc::tcflag_t; 4];

pub fn signal(process: u32, signal: i32) {
    // SAFETY: the process is a child that has not been waited for.
    assert_eq!(unsafe { libc::kill(process as libc::pid_t, signal) }, 0);
}

impl Pty {
    pub fn start(mut command: Command, columns: u16, rows: u16) -> Self {
        let (ours, theirs) = open();
        resize(&theirs, columns, rows);
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
        let is_hung_up = Arc::new(AtomicBool::new(false));
        let is_over = Arc::clone(&is_hung_up);
        let reader = thread::spawn(move || {
            let mut buffer = vec![0; 1 << 16];
            while !is_over.load(Ordering::SeqCst) {
                if is_readable(&reader) {
                    let Ok(count @ 1..) = reader.read(&mut buffer) else {
                        return;
                    };
                    if sender.send(buffer[..count].to_vec()).is_err() {
                        return;
                    }
                }
            }
        });
        Self {
            child,
            ours: Some(ours),
            is_hung_up,
            reader: Some(reader),
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

    /// Presses a key and releases it, as a terminal with the kitty protocol reports that. So it
    /// doesn't matter how soon the same key is pressed again.
    pub fn press(&mut self, key: char) {
        let code = u32::from(key);
        self.type_in(format!("\x1b[{code};1:1u\x1b[{code};1:3u"));
    }

    /// Waits until the session has stepped with all that was typed so far, of which the session's
    /// own keys are done first: shows the help and hides it again. The second time, the program
    /// reads the key at the beginning of a later frame than the first.
    pub fn wait_until_stepped(&mut self) {
        const HELP: &str = "take a picture";
        // What hides an earlier help may not have been read from the terminal yet.
        self.wait_until_shown(HELP, false);
        self.press('h');
        self.wait_until_shown(HELP, true);
        self.press('h');
        self.wait_until_shown(HELP, false);
    }

    /// Waits until the terminal shows a text, or no longer. What is written may lack characters of
    /// it that were there before.
    pub fn wait_until_shown(&mut self, text: &str, is_shown: bool) {
        self.wait_until(|seen| screen(seen).contains(text) == is_shown);
    }

    /// Waits until the program has been stopped by a signal.
    pub fn wait_until_stopped(&self) {
        let stat = format!("/proc/{}/stat", self.process());
        let begun = Instant::now();
        while !fs::read_to_string(&stat).is_ok_and(|stat| stat.contains(") T ")) {
            assert!(begun.elapsed() < PATIENCE, "it does not stop");
            thread::sleep(Duration::from_millis(20));
        }
    }

    pub fn type_in(&mut self, text: impl AsRef<[u8]>) {
        let ours = self.ours.as_mut().expect("not hung up");
        ours.write_all(text.as_ref()).expect("a terminal");
    }

    /// The terminal is gone, as a window that is closed or a line that breaks.
    pub fn hang_up(&mut self) {
        self.is_hung_up.store(true, Ordering::SeqCst);
        let reader = self.reader.take().expect("not hung up");
        reader.join().expect("a reader");
        self.ours = None;
    }

    pub fn resize(&mut self, columns: u16, rows: u16) {
        resize(&self.theirs, columns, rows);
    }

    /// The terminal's flags are others than before the program began.
    pub fn is_taken(&self) -> bool {
        modes(&self.theirs) != self.found
    }

    /// Waits until the terminal is taken, or put back.
    pub fn wait_until_taken(&self, is_taken: bool) {
        let begun = Instant::now();
        while self.is_taken() != is_taken {
            assert!(begun.elapsed() < PATIENCE, "{:?}", self.seen());
            thread::sleep(Duration::from_millis(20));
        }
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
            thread::sleep(Duration::from_millis(20));
            assert!(begun.elapsed() < PATIENCE, "it does not end: {:?}", self.seen());
        };
        if self.ours.is_some() {
            let theirs = self.theirs.try_clone().expect("a descriptor");
            File::from(theirs).write_all(LAST.as_bytes()).expect("a terminal");
            self.wait_for(LAST);
        }
        self.bytes.extend(self.chunks.try_iter().flatten());
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
        // A test that failed leaves no program running.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// Waits a little, at most.
fn is_readable(file: &File) -> bool {
    let mut poll = libc::pollfd { fd: file.as_raw_fd(), events: libc::POLLIN, revents: 0 };
    // SAFETY: one record, which outlives the call.
    unsafe { libc::poll(&raw mut poll, 1, 50) == 1 }
}

/// The lines that a terminal shows after all this was written to it.
fn screen(written: &str) -> String {
    const SIDE: usize = 128;
    let mut cells = vec![[' '; SIDE]; SIDE];
    let (mut row, mut column) = (0, 0);
    let mut rest = written.chars();
    while let Some(letter) = rest.next() {
        if letter == '\x1b' {
            let sequence = rest.as_str();
            let Some(end) = sequence.find(|end: char| end.is_ascii_alphabetic()) else {
                break;
            };
            if let Some(place) = sequence[..end].strip_prefix('[')
                && sequence[end..].starts_with('H')
            {
                let mut place = place.split(';').map(|number| number.parse().unwrap_or(1));
                let mut next = || place.next().unwrap_or(1).clamp(1, SIDE) - 1;
                (row, column) = (next(), next());
            }
            rest = sequence[end + 1..].chars();
        } else if !letter.is_control() && column < SIDE {
            cells[row][column] = letter;
            column += 1;
        }
    }
    let lines: Vec<String> = cells.iter().map(|line| line.iter().collect()).collect();
    lines.join("\n")
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

/// A terminal, both ends of which are closed in other programs: it hangs up when ours is closed
/// here.
fn open() -> (File, OwnedFd) {
    let open = |path: &str| {
        let mut options = File::options();
        options.read(true).write(true).custom_flags(libc::O_NOCTTY);
        options.open(path).expect(path)
    };
    let ours = open("/dev/ptmx");
    let mut name = [0; 64];
    let (pointer, length) = (name.as_mut_ptr().cast(), name.len());
    // SAFETY: the descriptor is open, and the second call writes a string of at most that length.
    let (unlocked, named) = unsafe {
        (libc::unlockpt(ours.as_raw_fd()), libc::ptsname_r(ours.as_raw_fd(), pointer, length))
    };
    assert_eq!((unlocked, named), (0, 0));
    let name = CStr::from_bytes_until_nul(&name).expect("a string");
    let theirs = open(name.to_str().expect("text"));
    (ours, theirs.into())
}

fn resize(terminal: &OwnedFd, columns: u16, rows: u16) {
    let size = libc::winsize { ws_row: rows, ws_col: columns, ws_xpixel: 0, ws_ypixel: 0 };
    // SAFETY: the call reads one winsize.
    let set = unsafe { libc::ioctl(terminal.as_raw_fd(), libc::TIOCSWINSZ, &raw const size) };
    assert_eq!(set, 0);
}
