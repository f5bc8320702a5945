//! Contexts and gangs: their directories, files and mappings.

use std::ffi::CStr;
use std::fs::File;
use std::io::Write;
use std::os::fd::{AsRawFd, RawFd};
use std::os::unix::fs::FileExt;
use std::process;
use std::sync::{Arc, Mutex};

use libc::{O_NONBLOCK, O_RDONLY, O_RDWR, O_WRONLY, c_uint, c_void};
use spu_emulator::local_store::SIZE;
use spu_emulator::signal::SignalRegister;
use spu_emulator::spe::TagWait;

use super::directory::{Directory, Words};
use super::mapping::Mapping;
use super::{ROOT, calls};
use crate::backend::Backend;
use crate::error::Errno;
use crate::mfc::Transfer;
use crate::problem_state::{AREAS, SIZE as AREAS_SIZE};
use crate::process_memory::ProcessMemory;
use crate::run::{Ended, StartRegisters};
use crate::types::{
    SPE_AFFINITY_MEMORY, SPE_CFG_SIGNOTIFY1_OR, SPE_CFG_SIGNOTIFY2_OR, SPE_EVENT_IN_MBOX,
    SPE_EVENT_OUT_INTR_MBOX, SPE_EVENT_TAG_GROUP, SPE_EVENTS_ENABLE, SPE_ISOLATE, SPE_MAP_PS,
    SPE_NOSCHED,
};

/// The offset of the multisource synchronisation register in the problem state.
const MULTISOURCE_SYNC: usize = 0;

pub(crate) struct Gang(Directory);

impl Gang {
    /// Creates a gang. `number` is unique in the process.
    pub(crate) fn create(number: usize) -> Result<Self, Errno> {
        let path = format!("{ROOT}/gang-{}-{number}", process::id());
        let directory = Directory::create(path, calls::GANG, None);
        directory.map(Self).map_err(|_| Errno(libc::EFAULT))
    }
}

/// A context in spufs. Its directory goes when this value is dropped.
pub(crate) struct Spufs {
    // Mappings and files end before the directory, and that before the gang's.
    local_store: Mapping,
    pub(super) areas: Option<Mapping>,
    memory: File,
    mbox: Words,
    mbox_stat: Words,
    ibox: Words,
    ibox_at_once: Words,
    ibox_stat: Words,
    wbox: Words,
    wbox_at_once: Words,
    wbox_stat: Words,
    signals: [Words; 2],
    pub(super) mfc: Words,
    pub(super) mfc_at_once: Words,
    pub(super) directory: Directory,
    _gang: Option<Arc<Gang>>,
    pub(super) events_enabled: bool,
    /// Proxy tags that were used and have not been reported complete.
    pub(super) issued_tags: Mutex<u32>,
}

fn creation_flags(flags: c_uint, neighbor: Option<RawFd>) -> c_uint {
    let flag = |ours, kernels| if flags & ours != 0 { kernels } else { 0 };
    flag(SPE_EVENTS_ENABLE, calls::EVENTS_ENABLED)
        | flag(SPE_NOSCHED, calls::NOSCHED)
        | flag(SPE_AFFINITY_MEMORY, calls::AFFINITY_MEMORY)
        | neighbor.map_or(0, |_| calls::AFFINITY_SPU)
}

impl Spufs {
    /// Creates a context with these creation flags of libspe2. `number` is unique in the process;
    /// `neighbor` is the directory of a context that this one wants to be near to.
    pub(crate) fn create(
        flags: c_uint,
        number: usize,
        neighbor: Option<RawFd>,
        gang: Option<Arc<Gang>>,
    ) -> Result<Self, Errno> {
        // An isolated context needs a loader for encrypted programs, and the PlayStation 3 has no
        // such contexts.
        if flags & SPE_ISOLATE != 0 {
            return Err(Errno(libc::ENODEV));
        }
        ProcessMemory::prepare().map_err(|_| Errno(libc::EFAULT))?;
        let creation = creation_flags(flags, neighbor);
        // Only affinity needs the gang's folder. Kernels from 6.15 on remove that folder when the
        // first context in it ends.
        let is_near = creation & (calls::AFFINITY_MEMORY | calls::AFFINITY_SPU) != 0;
        let gang = gang.filter(|_| is_near);
        let folder = gang.as_ref().map_or(ROOT, |gang| gang.0.path());
        let path = format!("{folder}/spethread-{}-{number}", process::id());
        let directory = Directory::create(path, creation, neighbor)?;
        let signal_types =
            [(c"signal1_type", SPE_CFG_SIGNOTIFY1_OR), (c"signal2_type", SPE_CFG_SIGNOTIFY2_OR)];
        for (name, flag) in signal_types {
            if flags & flag != 0 {
                let mut file = directory.open(name, O_RDWR).map_err(|_| Errno(libc::EFAULT))?;
                file.write_all(b"1").map_err(|_| Errno(libc::EFAULT))?;
            }
        }
        let unmapped = |_| Errno(libc::ENOMEM);
        let memory = directory.open(c"mem", O_RDWR).map_err(unmapped)?;
        let local_store = Mapping::new(&memory, SIZE as usize).map_err(unmapped)?;
        let maps_areas = flags & SPE_MAP_PS != 0;
        let areas = maps_areas
            .then(|| Mapping::new(&directory.open(c"psmap", O_RDWR)?, AREAS_SIZE))
            .transpose()
            .map_err(unmapped)?;
        let read = |name: &'static CStr| Words::new(name, O_RDONLY);
        let write = |name: &'static CStr| Words::new(name, O_WRONLY);
        Ok(Self {
            local_store,
            areas,
            memory,
            mbox: read(c"mbox"),
            mbox_stat: read(c"mbox_stat"),
            ibox: read(c"ibox"),
            ibox_at_once: Words::new(c"ibox", O_RDONLY | O_NONBLOCK),
            ibox_stat: read(c"ibox_stat"),
            wbox: write(c"wbox"),
            wbox_at_once: Words::new(c"wbox", O_WRONLY | O_NONBLOCK),
            wbox_stat: read(c"wbox_stat"),
            signals: [write(c"signal1"), write(c"signal2")],
            mfc: Words::new(c"mfc", O_RDWR),
            mfc_at_once: Words::new(c"mfc", O_RDWR | O_NONBLOCK),
            directory,
            _gang: gang,
            events_enabled: flags & SPE_EVENTS_ENABLE != 0,
            issued_tags: Mutex::new(0),
        })
    }

    /// Writes by the file and not by the mapping: while an SPE has the context, the mapping is
    /// device memory, to which the C library's block copies may not be made.
    pub(super) fn write_to_local_store(&self, address: u32, bytes: &[u8]) {
        if let Err(error) = self.memory.write_all_at(bytes, u64::from(address)) {
            messages::print!("libspe2: {}/mem: {error}", self.directory.path());
        }
    }

    fn read(&self, words: &Words) -> Result<Option<u32>, Errno> {
        words.read(&self.directory).map_err(|_| Errno(libc::EIO))
    }

    fn write(&self, words: &Words, word: u32) -> Result<bool, Errno> {
        let written = words.write(&self.directory, word);
        written.map_err(|_| Errno(libc::EIO))
    }

    fn count(&self, words: &Words) -> Result<usize, Errno> {
        Ok(self.read(words)?.unwrap_or(0) as usize)
    }
}

impl Backend for Spufs {
    fn local_store(&self) -> *mut u8 {
        self.local_store.as_ptr()
    }

    fn write_local_store(&self, address: u32, bytes: &[u8]) {
        self.write_to_local_store(address, bytes);
    }

    fn run(&self, at: u32, start: Option<&StartRegisters>) -> (u32, Ended) {
        self.run_from(at, start)
    }

    fn read_outbound(&self) -> Result<Option<u32>, Errno> {
        self.read(&self.mbox)
    }

    fn outbound_waiting(&self) -> Result<usize, Errno> {
        self.count(&self.mbox_stat)
    }

    fn write_inbound(&self, word: u32, wait: bool) -> Result<bool, Errno> {
        let file = if wait { &self.wbox } else { &self.wbox_at_once };
        self.write(file, word)
    }

    fn inbound_free(&self) -> Result<usize, Errno> {
        self.count(&self.wbox_stat)
    }

    fn read_outbound_interrupt(&self, wait: bool) -> Result<Option<u32>, Errno> {
        self.read(if wait { &self.ibox } else { &self.ibox_at_once })
    }

    fn outbound_interrupt_waiting(&self) -> Result<usize, Errno> {
        self.count(&self.ibox_stat)
    }

    fn signal(&self, register: SignalRegister, word: u32) -> Result<(), Errno> {
        let file = &self.signals[register as usize];
        self.write(file, word).map(|_| ())
    }

    fn maps_areas(&self) -> bool {
        self.areas.is_some()
    }

    fn area(&self, number: usize) -> Option<*mut c_void> {
        let areas = self.areas.as_ref()?;
        let offset = *AREAS.get(number)?;
        // SAFETY: every area lies in the mapping.
        let area = unsafe { areas.as_ptr().add(offset) };
        area.expose_provenance();
        Some(area.cast())
    }

    fn synchronise(&self) {
        if let Some(areas) = &self.areas {
            areas.store(MULTISOURCE_SYNC, 1);
        }
    }

    fn synchronisation(&self) -> u32 {
        let load = |areas: &Mapping| areas.load(MULTISOURCE_SYNC);
        self.areas.as_ref().map_or(0, load)
    }

    fn transfer(&self, transfer: &Transfer) -> Result<(), Errno> {
        self.give_command(transfer)
    }

    fn tag_status(&self, mask: u32, wait: TagWait) -> Result<u32, Errno> {
        self.complete_tags(mask, wait)
    }

    fn event_file(&self, event: c_uint) -> Result<Option<RawFd>, Errno> {
        let words = match event {
            SPE_EVENT_OUT_INTR_MBOX => &self.ibox_at_once,
            SPE_EVENT_IN_MBOX => &self.wbox_at_once,
            SPE_EVENT_TAG_GROUP => &self.mfc_at_once,
            _ => return Ok(None),
        };
        Ok(Some(words.file(&self.directory)?.as_raw_fd()))
    }

    fn directory(&self) -> Option<RawFd> {
        Some(self.directory.descriptor().as_raw_fd())
    }
}
