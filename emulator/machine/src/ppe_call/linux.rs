//! Stop 0x2104: Linux system calls, which newlib's `__linux_syscall` makes.
//!
//! On a console, the kernel carries them out. The word after the stop is the address of a block of
//! seven doublewords: the number of the call (PowerPC's), which the result replaces, and six
//! parameters. Pointers among them are effective addresses, and a failure is a negative error
//! number.
//!
//! Where effective addresses are addresses of the process, calls get the parameters as they are.
//! Elsewhere memory is copied, and structures are converted to the guest's byte order. Only the
//! calls of the table are served; the kernel has more. A signal can be sent to the own process
//! only.

use libc::c_long;

use super::errno::check;
use super::guest::Guest;
use super::{CallError, Errno, GuestMemory, Library};
use crate::local_store::SIZE;

const DOUBLEWORD: u32 = 8;
const PARAMETERS: usize = 6;
const BLOCK: u32 = DOUBLEWORD * (PARAMETERS as u32 + 1);
/// The largest number of bytes that are copied for a call.
const MOST: u64 = 1 << 20;
const FAULT: Errno = Errno(libc::EFAULT);

type Parameters = [u64; PARAMETERS];

/// What a parameter means.
#[derive(Clone, Copy)]
enum Role {
    Number,
    /// A string that ends in 0.
    Path,
    /// Bytes that the call reads. Their number is this parameter.
    Reads(usize),
    /// Bytes that the call writes. The size of their buffer is this parameter.
    Writes(usize),
    /// A structure of this many longs that the call reads, or null.
    ReadsLongs(usize),
    /// A structure of this many longs that the call writes, or null.
    WritesLongs(usize),
}
use Role::{Number, Path, Reads, ReadsLongs, Writes, WritesLongs};

struct SystemCall {
    number: u64,
    name: &'static str,
    roles: &'static [Role],
    /// Carries it out. Pointers among the parameters are the host's.
    call: fn(&Parameters) -> i64,
}

/// A table of calls: number, name, roles of the parameters, and the host's function with the
/// parameters that it gets, each as the type that the function expects.
macro_rules! system_calls {
    ($($number:literal $name:ident ($($role:expr),*) => $function:path, ($($index:literal),*);)*) => {
        &[$(SystemCall {
            number: $number,
            name: stringify!($name),
            roles: &[$($role),*],
            call: |_parameters| {
                // SAFETY: pointers are either buffers of this module, which the lengths describe,
                // or addresses that the guest may use as it may use all of its process.
                let result = unsafe { $function($(Parameter(_parameters[$index]).into()),*) };
                result as i64
            },
        },)*]
    };
}

/// A parameter in a register, of which a C function takes as much as its type holds.
#[derive(Clone, Copy)]
struct Parameter(u64);

macro_rules! parameter_as {
    ($($type:ty)*) => {$(
        impl From<Parameter> for $type {
            fn from(parameter: Parameter) -> Self {
                parameter.0 as Self
            }
        }
    )*};
}
parameter_as!(i32 u32 i64 u64 usize);

impl<T> From<Parameter> for *const T {
    fn from(parameter: Parameter) -> Self {
        std::ptr::with_exposed_provenance(parameter.0 as usize)
    }
}

impl<T> From<Parameter> for *mut T {
    fn from(parameter: Parameter) -> Self {
        std::ptr::with_exposed_provenance_mut(parameter.0 as usize)
    }
}

const CALLS: &[SystemCall] = system_calls! {
    3 read (Number, Writes(2), Number) => libc::read, (0, 1, 2);
    4 write (Number, Reads(2), Number) => libc::write, (0, 1, 2);
    5 open (Path, Number, Number) => functions::open, (0, 1, 2);
    6 close (Number) => libc::close, (0);
    8 creat (Path, Number) => libc::creat, (0, 1);
    9 link (Path, Path) => libc::link, (0, 1);
    10 unlink (Path) => libc::unlink, (0);
    12 chdir (Path) => libc::chdir, (0);
    13 time (WritesLongs(1)) => libc::time, (0);
    15 chmod (Path, Number) => libc::chmod, (0, 1);
    19 lseek (Number, Number, Number) => libc::lseek, (0, 1, 2);
    20 getpid () => libc::getpid, ();
    24 getuid () => libc::getuid, ();
    33 access (Path, Number) => libc::access, (0, 1);
    36 sync () => functions::sync, ();
    37 kill (Number, Number) => functions::kill, (0, 1);
    38 rename (Path, Path) => libc::rename, (0, 1);
    39 mkdir (Path, Number) => libc::mkdir, (0, 1);
    40 rmdir (Path) => libc::rmdir, (0);
    41 dup (Number) => libc::dup, (0);
    47 getgid () => libc::getgid, ();
    49 geteuid () => libc::geteuid, ();
    50 getegid () => libc::getegid, ();
    60 umask (Number) => libc::umask, (0);
    63 dup2 (Number, Number) => libc::dup2, (0, 1);
    64 getppid () => libc::getppid, ();
    78 gettimeofday (WritesLongs(2), WritesLongs(1)) => libc::gettimeofday, (0, 1);
    83 symlink (Path, Path) => libc::symlink, (0, 1);
    85 readlink (Path, Writes(2), Number) => libc::readlink, (0, 1, 2);
    92 truncate (Path, Number) => libc::truncate, (0, 1);
    93 ftruncate (Number, Number) => libc::ftruncate, (0, 1);
    94 fchmod (Number, Number) => libc::fchmod, (0, 1);
    118 fsync (Number) => libc::fsync, (0);
    133 fchdir (Number) => libc::fchdir, (0);
    148 fdatasync (Number) => libc::fdatasync, (0);
    158 sched_yield () => libc::sched_yield, ();
    162 nanosleep (ReadsLongs(2), WritesLongs(2)) => libc::nanosleep, (0, 1);
    179 pread64 (Number, Writes(2), Number, Number) => libc::pread, (0, 1, 2, 3);
    180 pwrite64 (Number, Reads(2), Number, Number) => libc::pwrite, (0, 1, 2, 3);
    207 gettid () => functions::gettid, ();
    246 clock_gettime (Number, WritesLongs(2)) => libc::clock_gettime, (0, 1);
    247 clock_getres (Number, WritesLongs(2)) => libc::clock_getres, (0, 1);
};

/// Functions that differ from the C library's. All are `unsafe` as the C library's are, so that the
/// table can call both alike; only `open` asks something of its caller.
mod functions {
    use libc::{c_char, c_int, c_long, c_uint};

    /// # Safety
    /// As `libc::open`, with the third parameter.
    pub unsafe fn open(path: *const c_char, flags: c_int, mode: c_uint) -> c_int {
        // SAFETY: the caller vouches for the path.
        unsafe { libc::open(path, flags, mode) }
    }

    pub unsafe fn sync() -> c_int {
        // SAFETY: `sync` takes no parameters.
        unsafe { libc::sync() };
        0
    }

    /// Older C libraries have no function for it.
    pub unsafe fn gettid() -> c_long {
        // SAFETY: the call takes no parameters.
        unsafe { libc::syscall(libc::SYS_gettid) }
    }

    pub unsafe fn kill(process: c_int, signal: c_int) -> c_int {
        let own = i32::try_from(std::process::id()) == Ok(process);
        if !own && signal != 0 {
            // SAFETY: the calling thread's errno can always be written.
            unsafe { *libc::__errno_location() = libc::EPERM };
            return -1;
        }
        // SAFETY: `kill` accepts any numbers.
        unsafe { libc::kill(process, signal) }
    }
}

/// The name of a system call, if it is served.
#[must_use]
pub fn system_call_name(number: u64) -> Option<&'static str> {
    find(number).map(|call| call.name)
}

fn find(number: u64) -> Option<&'static SystemCall> {
    CALLS.iter().find(|call| call.number == number)
}

/// The address of the block of the system call whose stop is followed by `address`, or `None` if
/// the kernel would report the stop, because the block does not lie in local store.
fn block(memory: Guest<'_>, address: u32) -> Option<u32> {
    let block = memory.word(address);
    (block <= SIZE - BLOCK).then_some(block)
}

/// The number of the system call whose stop is followed by `address`.
#[must_use]
pub fn system_call_number(memory: &dyn GuestMemory, address: u32) -> Option<u64> {
    let guest = Guest(memory);
    block(guest, address).map(|block| guest.doubleword(block))
}

impl Library {
    /// Carries out the system call whose stop is followed by `address`.
    pub(super) fn system_call(
        &self,
        memory: &dyn GuestMemory,
        address: u32,
    ) -> Result<(), CallError> {
        let guest = Guest(memory);
        let block =
            block(guest, address).ok_or(CallError::OutsideLocalStore(guest.word(address)))?;
        let parameters: Parameters =
            std::array::from_fn(|n| guest.doubleword(block + DOUBLEWORD * (n as u32 + 1)));
        let result = match find(guest.doubleword(block)) {
            None => Err(Errno(libc::ENOSYS)),
            Some(call) if self.heap().is_process() => carry_out(call, &parameters),
            Some(call) => self.carry_out_in_copies(call, &parameters),
        };
        let result = result.unwrap_or_else(|Errno(errno)| -i64::from(errno));
        guest.write(block, &result.to_be_bytes());
        Ok(())
    }

    /// Carries out a call with copies of the memory that its pointers point to.
    fn carry_out_in_copies(&self, call: &SystemCall, given: &Parameters) -> Result<i64, Errno> {
        let mut parameters = *given;
        let mut copies = Vec::new();
        for (n, role) in call.roles.iter().enumerate() {
            let bytes = match *role {
                Number => continue,
                ReadsLongs(_) | WritesLongs(_) if given[n] == 0 => continue,
                Path => self.path(given[n])?,
                Reads(length) | Writes(length) => {
                    parameters[length] = given[length].min(MOST);
                    let mut bytes = vec![0; parameters[length] as usize];
                    if matches!(role, Reads(_)) {
                        self.fetch(given[n], &mut bytes)?;
                    }
                    bytes
                }
                ReadsLongs(longs) => {
                    let mut bytes = vec![0; longs * DOUBLEWORD as usize];
                    self.fetch(given[n], &mut bytes)?;
                    host_longs(&bytes)
                }
                WritesLongs(longs) => vec![0; longs * size_of::<c_long>()],
            };
            let mut copy = Aligned::new(&bytes);
            parameters[n] = copy.0.as_mut_ptr().expose_provenance() as u64;
            copies.push((n, role, copy));
        }
        let result = carry_out(call, &parameters)?;
        for (n, role, copy) in copies {
            let written = match *role {
                Writes(_) => copy.bytes(result as usize),
                WritesLongs(longs) => guest_longs(&copy.bytes(longs * size_of::<c_long>())),
                _ => continue,
            };
            if !self.heap().write(given[n], &written) {
                return Err(FAULT);
            }
        }
        Ok(result)
    }

    fn fetch(&self, ea: u64, into: &mut [u8]) -> Result<(), Errno> {
        self.heap().read(ea, into).then_some(()).ok_or(FAULT)
    }

    /// The path at an effective address, with its terminating 0.
    fn path(&self, ea: u64) -> Result<Vec<u8>, Errno> {
        let mut path = Vec::new();
        while path.len() < libc::PATH_MAX as usize {
            let mut byte = [0];
            self.fetch(ea.wrapping_add(path.len() as u64), &mut byte)?;
            path.push(byte[0]);
            if byte == [0] {
                return Ok(path);
            }
        }
        Err(Errno(libc::ENAMETOOLONG))
    }
}

fn carry_out(call: &SystemCall, parameters: &Parameters) -> Result<i64, Errno> {
    check((call.call)(parameters))
}

/// The host's longs of the guest's, which are doublewords.
fn host_longs(guest: &[u8]) -> Vec<u8> {
    let doublewords = guest.as_chunks().0.iter();
    doublewords.flat_map(|&bytes| (u64::from_be_bytes(bytes) as c_long).to_ne_bytes()).collect()
}

#[allow(clippy::unnecessary_cast, reason = "a long has 32 bits on some hosts")]
fn guest_longs(host: &[u8]) -> Vec<u8> {
    let longs = host.as_chunks().0.iter();
    longs.flat_map(|&bytes| (c_long::from_ne_bytes(bytes) as i64).to_be_bytes()).collect()
}

#[derive(Clone, Copy)]
#[repr(C, align(8))]
struct Doubleword([u8; 8]);

/// Bytes with the alignment of a structure.
struct Aligned(Vec<Doubleword>);

impl Aligned {
    fn new(bytes: &[u8]) -> Self {
        let doubleword =
            |chunk: &[u8]| Doubleword(std::array::from_fn(|n| chunk.get(n).copied().unwrap_or(0)));
        // A pointer to no bytes must be valid, too.
        let end = Doubleword([0; 8]);
        Self(bytes.chunks(8).map(doubleword).chain([end]).collect())
    }

    fn bytes(&self, length: usize) -> Vec<u8> {
        self.0.iter().flat_map(|doubleword| doubleword.0).take(length).collect()
    }
}
