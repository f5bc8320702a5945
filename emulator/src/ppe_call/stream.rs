//! C's streams: a descriptor with a buffer.
//!
//! Invariant: at most one of the two buffers holds something. Whoever turns from writing to
//! reading finds everything written; whoever turns from reading to writing, the descriptor where
//! reading stopped (if it can be moved).

use std::ffi::CString;

use super::Errno;
use super::errno::check;
use super::outside::Outside;
use super::scan::Input;

const BUFFER: usize = 4096;
/// Characters that can be pushed back: C promises one.
const PUSHED_BACK: usize = 8;

/// When written bytes reach the descriptor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Buffering {
    Full,
    Line,
    None,
}

/// What `fopen`'s mode string says.
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
        let exclusive = if mode.contains(&b'x') {
            libc::O_EXCL
        } else {
            0
        };
        Ok(Self {
            flags: flags | access | exclusive,
            read,
            write,
        })
    }
}

pub(super) struct Stream {
    descriptor: i32,
    readable: bool,
    writable: bool,
    buffering: Buffering,
    capacity: usize,
    unwritten: Vec<u8>,
    /// Bytes read from the descriptor, of which `taken` were used.
    ahead: Vec<u8>,
    taken: usize,
    pushed_back: Vec<u8>,
    pub at_end: bool,
    pub failed: bool,
}

/// A path as the system takes it.
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
    pub fn open(path: Vec<u8>, mode: &[u8], outside: &mut dyn Outside) -> Result<Self, Errno> {
        const EVERYONE: libc::c_uint = 0o666;
        let mode = Mode::parse(mode)?;
        let path = c_path(path)?;
        // SAFETY: the path ends in 0.
        let descriptor = check(unsafe { libc::open(path.as_ptr(), mode.flags, EVERYONE) })?;
        let buffering = if outside.is_terminal(descriptor) {
            Buffering::Line
        } else {
            Buffering::Full
        };
        Ok(Self::new(descriptor, mode.read, mode.write, buffering))
    }

    pub fn descriptor(&self) -> i32 {
        self.descriptor
    }

    /// `setvbuf`; what is buffered stays.
    pub fn set_buffering(&mut self, buffering: Buffering, capacity: usize) {
        self.buffering = buffering;
        if capacity > 0 {
            self.capacity = capacity;
        }
    }

    fn fail(&mut self, errno: Errno) -> Errno {
        self.failed = true;
        errno
    }

    /// Writes out what is buffered. What could not be written is lost, as in C.
    pub fn flush(&mut self, outside: &mut dyn Outside) -> Result<(), Errno> {
        let bytes = std::mem::take(&mut self.unwritten);
        let mut rest = bytes.as_slice();
        while !rest.is_empty() {
            match outside.write(self.descriptor, rest) {
                Ok(0) => return Err(self.fail(Errno(libc::EIO))),
                Ok(written) => rest = &rest[written..],
                Err(errno) => return Err(self.fail(errno)),
            }
        }
        Ok(())
    }

    /// Before somebody is asked for input: what he is to see has no line end yet.
    pub fn flush_if_line_buffered(&mut self, outside: &mut dyn Outside) {
        if self.buffering == Buffering::Line {
            // The failure shows when the stream is written the next time.
            let _ = self.flush(outside);
        }
    }

    pub fn write(&mut self, bytes: &[u8], outside: &mut dyn Outside) -> Result<(), Errno> {
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
            self.flush(outside)?;
        }
        Ok(())
    }

    /// Gives back to the descriptor what was read too much; one that can't be moved keeps it.
    fn forget_ahead(&mut self) {
        let unused = (self.ahead.len() - self.taken + self.pushed_back.len()) as i64;
        if unused == 0 {
            return;
        }
        self.pushed_back.clear();
        self.ahead.clear();
        self.taken = 0;
        // SAFETY: it takes any numbers. A pipe can't be moved, which is no failure of the call.
        let _ = unsafe { libc::lseek(self.descriptor, -unused, libc::SEEK_CUR) };
    }

    pub fn read_byte(&mut self, outside: &mut dyn Outside) -> Result<Option<u8>, Errno> {
        if let Some(byte) = self.pushed_back.pop() {
            return Ok(Some(byte));
        }
        if self.taken == self.ahead.len() && !self.fill(outside)? {
            return Ok(None);
        }
        self.taken += 1;
        Ok(Some(self.ahead[self.taken - 1]))
    }

    fn fill(&mut self, outside: &mut dyn Outside) -> Result<bool, Errno> {
        if !self.readable {
            return Err(self.fail(Errno(libc::EBADF)));
        }
        self.flush(outside)?;
        // C11: the end is sticky until it is cleared.
        if self.at_end {
            return Ok(false);
        }
        let wanted = if self.buffering == Buffering::None {
            1
        } else {
            BUFFER
        };
        self.ahead.resize(wanted, 0);
        self.taken = 0;
        let read = outside.read(self.descriptor, &mut self.ahead);
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

    /// Reads until the slice is full or the input ends; a failure after some bytes shows the next
    /// time.
    pub fn read(&mut self, most: usize, outside: &mut dyn Outside) -> Result<Vec<u8>, Errno> {
        let mut bytes = Vec::new();
        while bytes.len() < most {
            match self.read_byte(outside) {
                Ok(Some(byte)) => bytes.push(byte),
                Ok(None) => break,
                Err(errno) if bytes.is_empty() => return Err(errno),
                Err(_) => break,
            }
        }
        Ok(bytes)
    }

    /// A line with its end, of at most `most` bytes; `None` if there is nothing left.
    pub fn read_line(
        &mut self,
        most: usize,
        outside: &mut dyn Outside,
    ) -> Result<Option<Vec<u8>>, Errno> {
        let mut line = Vec::new();
        while line.len() < most {
            let Some(byte) = self.read_byte(outside)? else {
                break;
            };
            line.push(byte);
            if byte == b'\n' {
                break;
            }
        }
        Ok((!line.is_empty()).then_some(line))
    }

    /// `ungetc`; says whether there was room.
    pub fn push_back(&mut self, byte: u8) -> bool {
        let room = self.readable && self.pushed_back.len() < PUSHED_BACK;
        if room {
            self.pushed_back.push(byte);
            self.at_end = false;
        }
        room
    }

    /// `ftell`.
    pub fn position(&mut self) -> Result<i64, Errno> {
        // SAFETY: it takes any numbers.
        let at = check(unsafe { libc::lseek(self.descriptor, 0, libc::SEEK_CUR) })?;
        let ahead = self.ahead.len() - self.taken + self.pushed_back.len();
        Ok(at + self.unwritten.len() as i64 - ahead as i64)
    }

    /// `fseek`.
    pub fn seek(
        &mut self,
        offset: i64,
        whence: i32,
        outside: &mut dyn Outside,
    ) -> Result<(), Errno> {
        self.flush(outside)?;
        self.forget_ahead();
        // SAFETY: it takes any numbers.
        check(unsafe { libc::lseek(self.descriptor, offset, whence) })?;
        self.at_end = false;
        Ok(())
    }

    /// `fclose`: the descriptor is closed even if the last bytes can't be written.
    pub fn close(mut self, outside: &mut dyn Outside) -> Result<(), Errno> {
        let flushed = self.flush(outside);
        self.forget_ahead();
        // SAFETY: the descriptor is the stream's own.
        let closed = check(unsafe { libc::close(self.descriptor) });
        flushed.and(closed.map(|_| ()))
    }
}

/// A stream as what `scanf` reads.
pub(super) struct StreamInput<'a> {
    pub stream: &'a mut Stream,
    pub outside: &'a mut dyn Outside,
}

impl Input for StreamInput<'_> {
    fn next(&mut self) -> Result<Option<u8>, Errno> {
        self.stream.read_byte(self.outside)
    }

    fn give_back(&mut self, byte: u8) {
        // There is room for what was just taken.
        self.stream.push_back(byte);
    }
}
