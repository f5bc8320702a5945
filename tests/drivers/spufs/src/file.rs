//! The files of a context.

use std::sync::Arc;
use std::time::Instant;

use libc::c_int;
use spu_emulator::local_store::SIZE;
use spu_emulator::mfc::MAX_TRANSFER;
use spu_emulator::signal::{SignalMode, SignalRegister};
use spu_emulator::spe::{ProxyCommand, TagWait};

use crate::context::{Context, lock};
use crate::error::Errno;
use crate::fault;
use crate::problem_state::SIZE as AREAS_SIZE;
use crate::readiness::{event_descriptor, into_raw, wait_for};
use crate::table::{Open, table};

/// A file's name, as it is used here.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Mem,
    Mbox,
    MboxStat,
    Ibox,
    IboxStat,
    Wbox,
    WboxStat,
    Signal(SignalRegister),
    SignalType(SignalRegister),
    Mfc,
    Psmap,
}

impl Kind {
    fn named(name: &str) -> Option<Self> {
        Some(match name {
            "mem" => Self::Mem,
            "mbox" => Self::Mbox,
            "mbox_stat" => Self::MboxStat,
            "ibox" => Self::Ibox,
            "ibox_stat" => Self::IboxStat,
            "wbox" => Self::Wbox,
            "wbox_stat" => Self::WboxStat,
            "signal1" => Self::Signal(SignalRegister::One),
            "signal2" => Self::Signal(SignalRegister::Two),
            "signal1_type" => Self::SignalType(SignalRegister::One),
            "signal2_type" => Self::SignalType(SignalRegister::Two),
            "mfc" => Self::Mfc,
            "psmap" => Self::Psmap,
            _ => return None,
        })
    }

    /// Whether the file may be opened for reading, and for writing.
    fn allows(self) -> [bool; 2] {
        match self {
            Self::Mbox | Self::MboxStat | Self::Ibox | Self::IboxStat | Self::WboxStat => {
                [true, false]
            }
            Self::Wbox => [false, true],
            _ => [true, true],
        }
    }
}

/// `openat` in a context's directory.
pub(crate) fn open(context: &Arc<Context>, name: &str, flags: c_int) -> Result<c_int, Errno> {
    let kind = Kind::named(name).ok_or(Errno(libc::ENOENT))?;
    let access = flags & libc::O_ACCMODE;
    let [reads, writes] = kind.allows();
    if access != libc::O_WRONLY && !reads || access != libc::O_RDONLY && !writes {
        return Err(Errno(libc::EACCES));
    }
    let levels = &context.levels;
    let descriptor = match kind {
        Kind::Ibox => levels.interrupt.descriptor()?,
        Kind::Wbox => levels.inbound.descriptor()?,
        Kind::Mfc => levels.tags.descriptor()?,
        _ => event_descriptor()?,
    };
    if matches!(kind, Kind::Ibox | Kind::Wbox) {
        // Its readiness follows the SPE's mailboxes.
        context.spe();
    }
    let descriptor = into_raw(descriptor);
    let file =
        Open::File { context: Arc::clone(context), kind, waits: flags & libc::O_NONBLOCK == 0 };
    table().insert(descriptor, file);
    Ok(descriptor)
}

/// An open file, for one call.
pub(crate) struct File<'a> {
    pub descriptor: c_int,
    pub context: &'a Context,
    pub kind: Kind,
    pub waits: bool,
}

impl File<'_> {
    /// Waits for what `poll` takes, if the file waits at all.
    fn wait<T>(&self, events: i16, mut poll: impl FnMut() -> Option<T>) -> Result<T, Errno> {
        loop {
            if let Some(value) = poll() {
                return Ok(value);
            }
            if !self.waits {
                return Err(Errno(libc::EAGAIN));
            }
            wait_for(self.descriptor, events)?;
        }
    }

    fn word(&self) -> Result<u32, Errno> {
        let spe = self.context.spe();
        let now = || Some(Instant::now());
        Ok(match self.kind {
            Kind::Mbox => spe.read_outbound(now()).ok_or(Errno(libc::EAGAIN))?,
            Kind::MboxStat => spe.outbound_waiting() as u32,
            Kind::Ibox => self.wait(libc::POLLIN, || spe.read_outbound_interrupt(now()))?,
            Kind::IboxStat => spe.outbound_interrupt_waiting() as u32,
            Kind::WboxStat => spe.inbound_free() as u32,
            Kind::Mfc => self.wait(libc::POLLIN, || self.complete_tags())?,
            _ => return Err(Errno(libc::EINVAL)),
        })
    }

    /// Asks the MFC for all outstanding tags, as `poll` and a read that waits do. A read that does
    /// not wait gets only tags that were asked for.
    pub fn ask_for_tags(&self) {
        if self.kind == Kind::Mfc {
            *lock(&self.context.asked_tags) = *lock(&self.context.tags);
        }
    }

    /// The tags that are complete, asked for and not reported, if there are any.
    fn complete_tags(&self) -> Option<u32> {
        if self.waits {
            self.ask_for_tags();
        }
        let mut tags = lock(&self.context.tags);
        let asked = *tags & *lock(&self.context.asked_tags);
        let complete = self.context.spe().proxy_tags(asked, TagWait::Immediate);
        *tags &= !complete;
        self.context.levels.tags.set(*tags != 0);
        (complete != 0).then_some(complete)
    }

    /// Whether a call waits for a word, for a place for one or for a tag.
    fn may_wait(&self) -> bool {
        self.waits && matches!(self.kind, Kind::Ibox | Kind::Wbox | Kind::Mfc)
    }

    pub fn read(&self, into: &mut [u8]) -> Result<usize, Errno> {
        fault::check_contention(self.may_wait())?;
        let into = into.get_mut(..4).ok_or(Errno(libc::EINVAL))?;
        into.copy_from_slice(&self.word()?.to_be_bytes());
        Ok(into.len())
    }

    pub fn write(&self, from: &[u8]) -> Result<usize, Errno> {
        fault::check_contention(self.may_wait())?;
        match self.kind {
            Kind::SignalType(register) => {
                let mode = match from.first() {
                    Some(b'0') => SignalMode::Overwrite,
                    Some(b'1') => SignalMode::Or,
                    _ => return Err(Errno(libc::EINVAL)),
                };
                self.context.set_mode(register as usize, mode)?;
                return Ok(from.len());
            }
            Kind::Mfc => {
                let command = from.try_into().map_err(|_| Errno(libc::EINVAL))?;
                self.command(command)?;
                return Ok(from.len());
            }
            _ => {}
        }
        let word = from.first_chunk().ok_or(Errno(libc::EINVAL))?;
        let word = u32::from_be_bytes(*word);
        let spe = self.context.spe();
        match self.kind {
            Kind::Signal(register) => spe.signal(register, word),
            Kind::Wbox => {
                let write = || spe.write_inbound(word, Some(Instant::now())).then_some(());
                self.wait(libc::POLLOUT, write)?;
            }
            _ => return Err(Errno(libc::EINVAL)),
        }
        Ok(4)
    }

    /// Gives a proxy command, in the kernel's form.
    fn command(&self, command: &[u8; 24]) -> Result<(), Errno> {
        let half = |at: usize| u32::from(u16::from_be_bytes([command[at], command[at + 1]]));
        let word = |at: usize| half(at) << 16 | half(at + 2);
        let given = ProxyCommand {
            lsa: word(4),
            ea: u64::from(word(8)) << 32 | u64::from(word(12)),
            size: half(16),
            tag: half(18),
            opcode: half(22),
        };
        let class = half(20);
        if class != 0 || !kernel_accepts(&given) {
            return Err(Errno(libc::EINVAL));
        }
        if !self.context.wait_until_loaded(self.waits) {
            return Err(Errno(libc::EAGAIN));
        }
        let mut tags = lock(&self.context.tags);
        let spe = self.context.spe();
        if let Err(error) = spe.proxy_command(given) {
            spe.proxy_failed(error);
        }
        *tags |= 1 << given.tag;
        self.context.levels.tags.set(true);
        Ok(())
    }

    /// `pwrite` to local store, which ends at its end.
    pub fn write_at(&self, from: &[u8], offset: u64) -> Result<usize, Errno> {
        if self.kind != Kind::Mem {
            return Err(Errno(libc::ESPIPE));
        }
        let size = u64::from(SIZE);
        if offset >= size && !from.is_empty() {
            return Err(Errno(libc::EFBIG));
        }
        let fits = from.len().min((size - offset.min(size)) as usize);
        let store = self.context.spe().local_store();
        store.write(offset as u32, &from[..fits]);
        Ok(fits)
    }

    /// `mmap` from the start of the file. Returns the address.
    pub fn map(&self, size: usize, flags: c_int) -> Result<usize, Errno> {
        let (most, address) = match self.kind {
            Kind::Mem => (SIZE as usize, None),
            Kind::Psmap => (AREAS_SIZE, Some(self.context.problem_state()?)),
            _ => return Err(Errno(libc::ENODEV)),
        };
        if flags & libc::MAP_SHARED == 0 || size > most {
            return Err(Errno(libc::EINVAL));
        }
        let store = || self.context.spe().local_store().as_ptr().expose_provenance();
        Ok(address.unwrap_or_else(store))
    }
}

/// The kernel's checks of a command.
fn kernel_accepts(command: &ProxyCommand) -> bool {
    /// Tags from here on are the kernel's.
    const TAGS: u32 = 16;
    let low = command.lsa & 15;
    let aligned = match command.size & 15 {
        0 => low == 0,
        size @ (1 | 2 | 4 | 8) => low.is_multiple_of(size),
        _ => false,
    };
    aligned
        && low == command.ea as u32 & 15
        && command.size <= MAX_TRANSFER
        && command.tag < TAGS
        && matches!(command.opcode, 0x20..=0x22 | 0x40..=0x42)
}
