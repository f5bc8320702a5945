//! C's streams: a descriptor with a buffer.
//!
//! Invariant: at most one of the two buffers is in use. Before the stream changes from writing to
//! reading, everything is written. Before it changes from reading to writing, the descriptor is
//! moved back to where reading stopped (if it can be moved).

use std::ffi::CString;

use super::Errno;
use super::cpuinfo;
use super::errno::check;
use super::host::Host;
use super::scan::Input;

const BUFFER: usize = 4096;
/// Number of characters that can be pushed back. C guarantees one.
const PUSHED_BACK: usize = 8;

/// When written bytes are passed to the descriptor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Buffering {
    /// When the buffer is full.
    Full,
    /// At the end of each line, too.
    Line,
    /// At once.
    None,
}

/// The meaning of `fopen`'s mode string.
struct Mode {
    flags: i32,
    read: bool,
    write: bool,
}

impl Mode {
    fn parse(mode: &[u8]) -> Result<Self, Errno> {
        let update = mode.contains(&b'+');
        let (flags, read, write) = match mode.first() {
            Some(b'r') => (0, true, update),
            Some(b'w') => (libc::O_CREAT | libc::O_TRUNC, update, true),
            Some(b'a') => (libc::O_CREAT | libc::O_APPEND, update, true),
            _ => return Err(Errno(libc::EINVAL)),
        };
        let access = match (read, write) {
            (true, true) => libc::O_RDWR,
            (false, _) => libc::O_WRONLY,
            (true, false) => libc::O_RDONLY,
        };
        let exclusive = if mode.contains(&b'x') { libc::O_EXCL } else { 0 };
        Ok(Self { flags: flags | access | exclusive, read, write })
    }
}

pub(super) struct Stream {
    descriptor: i32,
    readable: bool,
    writable: bool,
    buffering: Buffering,
    capacity: usize,
    unwritten: Vec<u8>,
    /// Bytes read from the descriptor. The first `taken` of them are used.
    ahead: Vec<u8>,
    taken: usize,
    pushed_back: Vec<u8>,
    pub at_end: bool,
    pub failed: bool,
}

/// A path as a C string.
pub(super) fn c_path(path: Vec<u8>) -> Result<CString, Errno> {
    CString::new(path).map_err(|_| Errno(libc::EINVAL))
}

impl Stream {
    pub fn new(descriptor: i32, readable: bool, writable: bool, buffering: Buffering) -> Self {
        Self {
            descriptor,
            readable,
            writable,
            buffering,
            capacity: BUFFER,
            unwritten: Vec::new(),
            ahead: Vec::new(),
            taken: 0,
            pushed_back: Vec::new(),
            at_end: false,
            failed: false,
        }
    }

    /// `fopen`.
    pub fn open(path: Vec<u8>, mode: &[u8], host: &dyn Host) -> Result<Self, Errno> {
        const EVERYONE: libc::c_uint = 0o666;
        let mode = Mode::parse(mode)?;
        let path = c_path(path)?;
        let descriptor = cpuinfo::open(&path, mode.flags, EVERYONE)?;
        let buffering =
            if host.is_terminal(descriptor) { Buffering::Line } else { Buffering::Full };
        Ok(Self::new(descriptor, mode.read, mode.write, buffering))
    }

    /// `freopen` without a path: the file of the descriptor is opened again, and the new
    /// descriptor gets the old one's number. That needs `/proc`.
    pub fn reopen(mut self, mode: &[u8], host: &dyn Host) -> Result<Self, Errno> {
        // By the C standard, a failure to write the last bytes is ignored here.
        let _ = self.flush(host);
        self.forget_ahead();
        let old = self.descriptor;
        let path = format!("/proc/self/fd/{old}").into_bytes();
        let opened = Self::open(path, mode, host).and_then(|new| {
            // SAFETY: both descriptors belong to streams.
            let moved = check(unsafe { libc::dup2(new.descriptor, old) });
            // SAFETY: the new descriptor belongs to the new stream, which uses the old number.
            unsafe { libc::close(new.descriptor) };
            moved.map(|_| Self { descriptor: old, ..new })
        });
        if opened.is_err() {
            // SAFETY: the descriptor belongs to the old stream, which ends here.
            unsafe { libc::close(old) };
        }
        opened
    }

    pub fn descriptor(&self) -> i32 {
        self.descriptor
    }

    /// `setvbuf`. Bytes that are already buffered stay buffered.
    pub fn set_buffering(&mut self, buffering: Buffering, capacity: usize, host: &dyn Host) {
        if host.buffers(self.descriptor) {
            host.set_buffering(self.descriptor, buffering, capacity);
            return;
        }
        self.buffering = buffering;
        if capacity > 0 {
            self.capacity = capacity;
        }
    }

    fn fail(&mut self, errno: Errno) -> Errno {
        self.failed = true;
        errno
    }

    /// Writes the buffered bytes, the host's too. As in C, bytes that can't be written are lost.
    pub fn flush(&mut self, host: &dyn Host) -> Result<(), Errno> {
        self.pass_on(host)?;
        if self.writable
            && let Err(errno) = host.flush(self.descriptor)
        {
            return Err(self.fail(errno));
        }
        Ok(())
    }

    fn pass_on(&mut self, host: &dyn Host) -> Result<(), Errno> {
        let bytes = std::mem::take(&mut self.unwritten);
        let mut rest = bytes.as_slice();
        while !rest.is_empty() {
            match host.write_stream(self.descriptor, rest) {
                Ok(0) => return Err(self.fail(Errno(libc::EIO))),
                Ok(written) => rest = &rest[written..],
                Err(errno) => return Err(self.fail(errno)),
            }
        }
        Ok(())
    }

    /// Flushes a line-buffered stream before input is read, because a prompt may not end with a
    /// line end.
    pub fn flush_if_line_buffered(&mut self, host: &dyn Host) {
        if self.buffering == Buffering::Line {
            // The next write to the stream reports the failure.
            let _ = self.flush(host);
        }
    }

    pub fn write(&mut self, bytes: &[u8], host: &dyn Host) -> Result<(), Errno> {
        if !self.writable {
            return Err(self.fail(Errno(libc::EBADF)));
        }
        self.forget_ahead();
        self.unwritten.extend_from_slice(bytes);
        let flush = match self.buffering {
            Buffering::None => true,
            Buffering::Line => bytes.contains(&b'\n'),
            Buffering::Full => false,
        };
        if flush || self.unwritten.len() >= self.capacity {
            self.pass_on(host)?;
        }
        Ok(())
    }

    /// Moves the descriptor back over the bytes that were read ahead. If it can't be moved, they
    /// are kept.
    fn forget_ahead(&mut self) {
        let unused = (self.ahead.len() - self.taken + self.pushed_back.len()) as i64;
        if unused == 0 {
            return;
        }
        self.pushed_back.clear();
        self.ahead.clear();
        self.taken = 0;
        // SAFETY: `lseek` accepts any numbers. A pipe can't be moved, and that is not a failure of
        // this call.
        let _ = unsafe { libc::lseek64(self.descriptor, -unused, libc::SEEK_CUR) };
    }

    pub fn read_byte(&mut self, host: &dyn Host) -> Result<Option<u8>, Errno> {
        if let Some(byte) = self.pushed_back.pop() {
            return Ok(Some(byte));
        }
        if self.taken == self.ahead.len() && !self.fill(host)? {
            return Ok(None);
        }
        self.taken += 1;
        Ok(Some(self.ahead[self.taken - 1]))
    }

    fn fill(&mut self, host: &dyn Host) -> Result<bool, Errno> {
        if !self.readable {
            return Err(self.fail(Errno(libc::EBADF)));
        }
        self.flush(host)?;
        // In C11, the end-of-file state stays until it is cleared.
        if self.at_end {
            return Ok(false);
        }
        let wanted = if self.buffering == Buffering::None { 1 } else { BUFFER };
        self.ahead.resize(wanted, 0);
        self.taken = 0;
        let read = host.read_stream(self.descriptor, &mut self.ahead);
        self.ahead.truncate(read.unwrap_or(0));
        match read {
            Ok(0) => {
                self.at_end = true;
                Ok(false)
            }
            Ok(_) => Ok(true),
            Err(errno) => Err(self.fail(errno)),
        }
    }

    /// Reads until `most` bytes are read or the input ends. A failure after some bytes is reported
    /// by the next call.
    pub fn read(&mut self, most: usize, host: &dyn Host) -> Result<Vec<u8>, Errno> {
        let mut bytes = Vec::new();
        while bytes.len() < most {
            match self.read_byte(host) {
                Ok(Some(byte)) => bytes.push(byte),
                Ok(None) => break,
                Err(errno) if bytes.is_empty() => return Err(errno),
                Err(_) => break,
            }
        }
        Ok(bytes)
    }

    /// A line with its line end, of at most `most` bytes. `None` if no bytes are left.
    pub fn read_line(&mut self, most: usize, host: &dyn Host) -> Result<Option<Vec<u8>>, Errno> {
        let mut line = Vec::new();
        while line.len() < most {
            let Some(byte) = self.read_byte(host)? else {
                break;
            };
            line.push(byte);
            if byte == b'\n' {
                break;
            }
        }
        Ok((!line.is_empty()).then_some(line))
    }

    /// `ungetc`. Returns whether the byte fitted.
    pub fn push_back(&mut self, byte: u8) -> bool {
        let fits = self.readable && self.pushed_back.len() < PUSHED_BACK;
        if fits {
            self.pushed_back.push(byte);
            self.at_end = false;
        }
        fits
    }

    /// `ftell`.
    pub fn position(&mut self) -> Result<i64, Errno> {
        // SAFETY: `lseek` accepts any numbers.
        let at = check(unsafe { libc::lseek64(self.descriptor, 0, libc::SEEK_CUR) })?;
        let ahead = self.ahead.len() - self.taken + self.pushed_back.len();
        Ok(at + self.unwritten.len() as i64 - ahead as i64)
    }

    /// `fseek`.
    pub fn seek(&mut self, offset: i64, whence: i32, host: &dyn Host) -> Result<(), Errno> {
        self.flush(host)?;
        self.forget_ahead();
        // SAFETY: `lseek` accepts any numbers.
        check(unsafe { libc::lseek64(self.descriptor, offset, whence) })?;
        self.at_end = false;
        Ok(())
    }

    /// `fclose`: the descriptor is closed even if the last bytes can't be written.
    pub fn close(mut self, host: &dyn Host) -> Result<(), Errno> {
        let flushed = self.flush(host);
        self.forget_ahead();
        // SAFETY: the descriptor belongs to the stream.
        let closed = check(unsafe { libc::close(self.descriptor) });
        flushed.and(closed.map(|_| ()))
    }
}

/// A stream as an input of `scanf`.
pub(super) struct StreamInput<'a> {
    pub stream: &'a mut Stream,
    pub host: &'a dyn Host,
}

impl Input for StreamInput<'_> {
    fn next(&mut self) -> Result<Option<u8>, Errno> {
        self.stream.read_byte(self.host)
    }

    fn give_back(&mut self, byte: u8) {
        // The byte that was just read always fits.
        self.stream.push_back(byte);
    }
}
