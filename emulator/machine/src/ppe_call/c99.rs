//! Class 0x2100: C99's streams.

use std::ffi::CString;
use std::sync::{Mutex, MutexGuard};

use super::errno::check;
use super::guest::{Block, Reply};
use super::host::Host;
use super::print::print;
use super::scan::{Text, scan};
use super::stream::{Buffering, Stream, StreamInput, c_path};
use super::va_list::VaList;
use super::{Call, Errno, Library, calls};
use crate::local_store::SIZE;
use crate::lock::lock;
use spu_isa::LIMIT_MASK;

/// Handles 1 to 3 are the standard streams. Handles up to 16 are for streams that are opened.
const HANDLES: usize = 17;
const FIRST_OPENED: usize = 4;
const STDIN: u32 = 1;
const STDOUT: u32 = 2;
const STDERR: u32 = 3;
const EOF: i32 = -1;
/// The values of `_IOFBF`, `_IOLBF` and `_IONBF` in the guest's `stdio.h`.
const BUFFERING: [Buffering; 3] = [Buffering::Full, Buffering::Line, Buffering::None];

pub(super) const CALLS: &[Call] = calls! {
    clearerr => |library, block| {
        // This C function returns nothing, so a handle that is not open can't be reported.
        let _ = library.stream(block.word(0), |stream, _| {
            stream.at_end = false;
            stream.failed = false;
            Ok(())
        });
        Reply::Nothing
    },
    fclose => |library, block| library.fclose(block).into(),
    feof => |library, block| library.stream(block.word(0), |stream, _| Ok(i32::from(stream.at_end))).into(),
    ferror => |library, block| library.stream(block.word(0), |stream, _| Ok(i32::from(stream.failed))).into(),
    fflush => |library, block| library.fflush(block.word(0)).into(),
    fgetc => |library, block| library.get_byte(block.word(0)),
    fgetpos => |library, block| library.fgetpos(block).into(),
    fgets => |library, block| library.fgets(block),
    fileno => |library, block| library.stream(block.word(0), |stream, _| Ok(stream.descriptor())).into(),
    fopen => |library, block| handle(library.fopen(block)),
    fputc => |library, block| library.put_byte(block.word(0), block.word(1)),
    fputs => |library, block| library.put(block.word(1), &block.string(0)).map(|()| 1).into(),
    fread => |library, block| library.fread(block),
    freopen => |library, block| handle(library.freopen(block)),
    fseek => |library, block| library.seek(block.word(0), block.int(1), block.int(2)).into(),
    fsetpos => |library, block| {
        let position = block.guest.word(block.word(1)) as i32;
        library.seek(block.word(0), position, libc::SEEK_SET).into()
    },
    ftell => |library, block| library.ftell(block.word(0)).into(),
    fwrite => |library, block| library.fwrite(block),
    getc => |library, block| library.get_byte(block.word(0)),
    getchar => |library, _| library.get_byte(STDIN),
    gets => |library, block| library.gets(block),
    perror => |library, block| library.perror(block),
    putc => |library, block| library.put_byte(block.word(0), block.word(1)),
    putchar => |library, block| library.put_byte(block.word(0), STDOUT),
    puts => |library, block| library.puts(&block.string(0)).into(),
    remove => |_, block| remove(block).into(),
    rename => |_, block| rename(block).into(),
    rewind => |library, block| {
        // This C function returns nothing, so a failure can't be reported.
        let _ = library.stream(block.word(0), |stream, host| {
            let moved = stream.seek(0, libc::SEEK_SET, host);
            stream.failed = false;
            moved
        });
        Reply::Nothing
    },
    setbuf => |library, block| {
        let buffering = if block.word(1) == 0 { Buffering::None } else { Buffering::Full };
        // This C function returns nothing, so a handle that is not open can't be reported.
        let _ = library.stream(block.word(0), |stream, host| {
            stream.set_buffering(buffering, 0, host);
            Ok(())
        });
        Reply::Nothing
    },
    setvbuf => |library, block| library.setvbuf(block).into(),
    system => |_, block| system(block).into(),
    tmpfile => |library, _| handle(library.tmpfile()),
    // Another program could use the name first. libspe2 refuses this call, and so do we.
    tmpnam => |_, _| 0.into(),
    ungetc => |library, block| library.ungetc(block),
    vfprintf => |library, block| library.printf(block, block.word(0), 1).into(),
    vfscanf => |library, block| library.scanf(block, block.word(0), 1).into(),
    vprintf => |library, block| library.printf(block, STDOUT, 0).into(),
    vscanf => |library, block| library.scanf(block, STDIN, 0).into(),
    vsnprintf => |_, block| print_string(block, block.word(1), 2).into(),
    vsprintf => |_, block| print_string(block, SIZE, 1).into(),
    vsscanf => |_, block| scan_string(block).into(),
};

pub(super) struct Streams {
    open: [Mutex<Option<Stream>>; HANDLES],
}

impl Streams {
    pub fn new(host: &dyn Host) -> Self {
        let mut open = [const { Mutex::new(None) }; HANDLES];
        let output =
            if host.is_terminal(libc::STDOUT_FILENO) { Buffering::Line } else { Buffering::Full };
        let standard = [
            (STDIN, libc::STDIN_FILENO, true, Buffering::Full),
            (STDOUT, libc::STDOUT_FILENO, false, output),
            (STDERR, libc::STDERR_FILENO, false, Buffering::None),
        ];
        for (handle, descriptor, readable, buffering) in standard {
            let buffering = if host.buffers(descriptor) { Buffering::None } else { buffering };
            let stream = Stream::new(descriptor, readable, !readable, buffering);
            open[handle as usize] = Mutex::new(Some(stream));
        }
        Self { open }
    }

    /// Flushes every stream. Returns the first failure.
    /// A stream that another thread is using is left out if it has nothing to write, because that
    /// A stream that another thread is using is left out, because that thread may wait in it for
    /// input.
    pub fn flush_all(&self, host: &dyn Host) -> Result<(), Errno> {
        let mut result = Ok(());
        for slot in &self.open {
            if let Ok(mut slot) = slot.try_lock()
                && let Some(stream) = slot.as_mut()
            {
                result = result.and(stream.flush(host));
            }
        }
        result
    }

    fn slot(&self, handle: u32) -> Result<MutexGuard<'_, Option<Stream>>, Errno> {
        let slot = self.open.get(handle as usize);
        slot.filter(|_| handle != 0).map(lock).ok_or(Errno(libc::EBADF))
    }

    /// A free slot for a stream that is to be opened. A slot that another thread has locked is in
    /// use.
    fn free_slot(&self) -> Result<(usize, MutexGuard<'_, Option<Stream>>), Errno> {
        (FIRST_OPENED..HANDLES)
            .find_map(|handle| {
                let slot = self.open[handle].try_lock().ok()?;
                slot.is_none().then_some((handle, slot))
            })
            .ok_or(Errno(libc::EMFILE))
    }
}

/// A handle, or the null pointer and the error number.
fn handle(opened: Result<usize, Errno>) -> Reply {
    match opened {
        Ok(handle) => Reply::Word(handle as u32, 0),
        Err(errno) => Reply::Word(0, errno.0),
    }
}

/// The pointer on success, or the null pointer.
fn pointer(address: u32, found: Result<bool, Errno>) -> Reply {
    match found {
        Ok(true) => Reply::Word(address, 0),
        Ok(false) => Reply::Word(0, 0),
        Err(errno) => Reply::Word(0, errno.0),
    }
}

impl Library {
    /// Uses the open stream with this handle.
    fn stream<T>(
        &self,
        handle: u32,
        body: impl FnOnce(&mut Stream, &dyn Host) -> Result<T, Errno>,
    ) -> Result<T, Errno> {
        let mut slot = self.streams.slot(handle)?;
        let stream = slot.as_mut().ok_or(Errno(libc::EBADF))?;
        body(stream, self.host.as_ref())
    }

    fn fclose(&self, block: Block<'_>) -> Result<(), Errno> {
        let stream = self.streams.slot(block.word(0))?.take();
        let stream = stream.ok_or(Errno(libc::EBADF))?;
        stream.close(self.host.as_ref())
    }

    fn fflush(&self, handle: u32) -> Result<(), Errno> {
        if handle == 0 {
            return self.flush();
        }
        self.stream(handle, Stream::flush)
    }

    fn get_byte(&self, handle: u32) -> Reply {
        // A user must see a prompt before typing the input.
        if handle == STDIN {
            // If standard output is closed, there is no question.
            let _ = self.stream(STDOUT, |stdout, host| {
                stdout.flush_if_line_buffered(host);
                Ok(())
            });
        }
        self.stream(handle, Stream::read_byte).map(|byte| byte.map_or(EOF, i32::from)).into()
    }

    fn put(&self, handle: u32, bytes: &[u8]) -> Result<(), Errno> {
        self.stream(handle, |stream, host| stream.write(bytes, host))
    }

    fn put_byte(&self, character: u32, handle: u32) -> Reply {
        let byte = character as u8;
        self.put(handle, &[byte]).map(|()| i32::from(byte)).into()
    }

    fn puts(&self, text: &[u8]) -> Result<i32, Errno> {
        let line = [text, b"\n"].concat();
        self.put(STDOUT, &line).map(|()| line.len() as i32)
    }

    fn fgets(&self, block: Block<'_>) -> Reply {
        let (address, size) = (block.word(0), block.int(1));
        let line = self.stream(block.word(2), |stream, host| {
            let most = usize::try_from(size).ok().and_then(|size| size.checked_sub(1));
            let most = most.ok_or(Errno(libc::EINVAL))?;
            stream.read_line(most.min(SIZE as usize - 1), host)
        });
        let found = line.map(|line| {
            if let Some(line) = &line {
                block.guest.set_string(address, line);
            }
            line.is_some()
        });
        pointer(address, found)
    }

    fn gets(&self, block: Block<'_>) -> Reply {
        let address = block.word(0);
        // The limit is the rest of local store, less one byte for the terminating 0.
        let most = (SIZE - (address & LIMIT_MASK) - 1) as usize;
        let line = self.stream(STDIN, |stream, host| stream.read_line(most, host));
        let found = line.map(|line| {
            if let Some(line) = &line {
                let line = line.strip_suffix(b"\n").unwrap_or(line);
                block.guest.set_string(address, line);
            }
            line.is_some()
        });
        pointer(address, found)
    }

    fn fopen(&self, block: Block<'_>) -> Result<usize, Errno> {
        let (handle, mut slot) = self.streams.free_slot()?;
        let (Some(path), Some(mode)) = (block.optional_string(0), block.optional_string(1)) else {
            return Err(Errno(libc::EFAULT));
        };
        *slot = Some(Stream::open(path, &mode, self.host.as_ref())?);
        Ok(handle)
    }

    /// The old file is closed even if the new one can't be opened. Without a path, the stream's
    /// own file is opened again with the new mode.
    fn freopen(&self, block: Block<'_>) -> Result<usize, Errno> {
        let handle = block.word(2);
        let host = self.host.as_ref();
        let mut slot = self.streams.slot(handle)?;
        let old = slot.take();
        let Some(mode) = block.optional_string(1) else {
            return Err(Errno(libc::EFAULT));
        };
        let Some(path) = block.optional_string(0) else {
            let old = old.ok_or(Errno(libc::EBADF))?;
            *slot = Some(old.reopen(&mode, host)?);
            return Ok(handle as usize);
        };
        if let Some(old) = old {
            // By the C standard, a failure to close is ignored here.
            let _ = old.close(host);
        }
        *slot = Some(Stream::open(path, &mode, host)?);
        Ok(handle as usize)
    }

    fn tmpfile(&self) -> Result<usize, Errno> {
        let (handle, mut slot) = self.streams.free_slot()?;
        let template = std::env::temp_dir().join("spuXXXXXX").into_os_string();
        let template = c_path(std::os::unix::ffi::OsStringExt::into_vec(template))?;
        let mut path = template.into_bytes_with_nul();
        // SAFETY: the template ends in 0, and it is our own buffer.
        let descriptor = check(unsafe { libc::mkstemp(path.as_mut_ptr().cast()) })?;
        // SAFETY: the path ends in 0. The unlinked file is deleted when it is closed.
        check(unsafe { libc::unlink(path.as_ptr().cast()) })?;
        *slot = Some(Stream::new(descriptor, true, true, Buffering::Full));
        Ok(handle)
    }

    fn setvbuf(&self, block: Block<'_>) -> Result<(), Errno> {
        let (mode, size) = (block.word(2), block.word(3));
        let buffering = BUFFERING.get(mode as usize).ok_or(Errno(libc::EINVAL))?;
        self.stream(block.word(0), |stream, host| {
            stream.set_buffering(*buffering, size.min(SIZE) as usize, host);
            Ok(())
        })
    }

    fn seek(&self, handle: u32, offset: i32, whence: i32) -> Result<(), Errno> {
        self.stream(handle, |stream, host| stream.seek(offset.into(), whence, host))
    }

    fn ftell(&self, handle: u32) -> Result<i32, Errno> {
        let position = self.stream(handle, |stream, _| stream.position())?;
        i32::try_from(position).map_err(|_| Errno(libc::EOVERFLOW))
    }

    fn fgetpos(&self, block: Block<'_>) -> Result<(), Errno> {
        let position = self.ftell(block.word(0))?;
        block.guest.set_word(block.word(1), position as u32);
        Ok(())
    }

    /// Reads `nmemb` items, at most as many bytes as local store has. The result is the number of
    /// whole items.
    fn fread(&self, block: Block<'_>) -> Reply {
        let [address, size, count] = [0, 1, 2].map(|n| block.word(n));
        let most = (u64::from(size) * u64::from(count)).min(SIZE.into());
        let read = self.stream(block.word(3), |stream, host| stream.read(most as usize, host));
        match read {
            Ok(bytes) => {
                block.guest.write(address, &bytes);
                Reply::Word((bytes.len() as u32).checked_div(size).unwrap_or(0), 0)
            }
            Err(errno) => Reply::Word(0, errno.0),
        }
    }

    fn fwrite(&self, block: Block<'_>) -> Reply {
        let [address, size, count] = [0, 1, 2].map(|n| block.word(n));
        let length = (u64::from(size) * u64::from(count)).min(SIZE.into()) as u32;
        let bytes = block.guest.bytes(address, length);
        match self.put(block.word(3), &bytes) {
            Ok(()) => Reply::Word(length.checked_div(size).unwrap_or(0), 0),
            Err(errno) => Reply::Word(0, errno.0),
        }
    }

    fn ungetc(&self, block: Block<'_>) -> Reply {
        let (character, handle) = (block.int(0), block.word(1));
        let pushed = character != EOF
            && self
                .stream(handle, |stream, _| Ok(stream.push_back(character as u8)))
                .is_ok_and(|pushed| pushed);
        if pushed { i32::from(character as u8).into() } else { EOF.into() }
    }

    fn perror(&self, block: Block<'_>) -> Reply {
        let mut line = block.optional_string(0).unwrap_or_default();
        if !line.is_empty() {
            line.extend(b": ");
        }
        line.extend(Errno(block.int(1)).text().into_bytes());
        line.push(b'\n');
        // If standard error can't be written, the failure can't be reported.
        let _ = self.put(STDERR, &line);
        Reply::Nothing
    }

    /// `format` is the number of the cell that points to the format string. The variadic list
    /// follows it.
    fn printf(&self, block: Block<'_>, handle: u32, format: u32) -> Result<i32, Errno> {
        let text = print_arguments(block, format)?;
        self.put(handle, &text).map(|()| text.len() as i32)
    }

    fn scanf(&self, block: Block<'_>, handle: u32, format: u32) -> Result<i32, Errno> {
        let arguments = VaList::at(block.guest, block.cell(format + 1));
        let format = block.string(format);
        self.stream(handle, |stream, host| {
            let mut input = StreamInput { stream, host };
            scan(block.guest, &format, arguments, &mut input)
        })
    }
}

fn print_arguments(block: Block<'_>, format: u32) -> Result<Vec<u8>, Errno> {
    let arguments = VaList::at(block.guest, block.cell(format + 1));
    print(block.guest, &block.string(format), arguments)
}

/// Prints into the string of cell 0, which has `size` bytes. Returns the length of the text.
fn print_string(block: Block<'_>, size: u32, format: u32) -> Result<i32, Errno> {
    let text = print_arguments(block, format)?;
    let most = size.min(SIZE) as usize;
    if most > 0 {
        let kept = &text[..text.len().min(most - 1)];
        block.guest.set_string(block.word(0), kept);
    }
    Ok(text.len() as i32)
}

fn scan_string(block: Block<'_>) -> Result<i32, Errno> {
    const FORMAT: u32 = 1;
    let arguments = VaList::at(block.guest, block.cell(FORMAT + 1));
    let mut input = Text { bytes: block.string(0), at: 0 };
    scan(block.guest, &block.string(FORMAT), arguments, &mut input)
}

fn remove(block: Block<'_>) -> Result<i32, Errno> {
    let path = c_path(block.string(0))?;
    // SAFETY: the path ends in 0.
    check(unsafe { libc::remove(path.as_ptr()) })
}

fn rename(block: Block<'_>) -> Result<i32, Errno> {
    let (from, to) = (c_path(block.string(0))?, c_path(block.string(1))?);
    // SAFETY: the paths end in 0.
    check(unsafe { libc::rename(from.as_ptr(), to.as_ptr()) })
}

/// A null pointer queries whether there is a command processor.
fn system(block: Block<'_>) -> Result<i32, Errno> {
    let command: Option<CString> = block.optional_string(0).map(c_path).transpose()?;
    let command = command.as_ref().map_or(std::ptr::null(), |text| text.as_ptr());
    // SAFETY: the command is null or ends in 0.
    check(unsafe { libc::system(command) })
}
