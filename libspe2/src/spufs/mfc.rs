//! Proxy DMA, by the file `mfc` or by the registers of the mapped problem state.

use std::io::{self, Write};
use std::sync::{MutexGuard, PoisonError};
use std::thread;

use spu_emulator::spe::TagWait;

use super::context::Spufs;
use super::mapping::Mapping;
use crate::error::Errno;
use crate::mfc::{Transfer, asked};

const MFC_LSA: usize = 0x3004;
const MFC_EAH: usize = 0x3008;
const MFC_EAL: usize = 0x300c;
const MFC_SIZE_TAG: usize = 0x3010;
/// Written with a command's classes and opcode, and read for the command's status.
const MFC_COMMAND: usize = 0x3014;
const MFC_QUEUE_STATUS: usize = 0x3104;
const PROXY_QUERY_MASK: usize = 0x321c;
const PROXY_TAG_STATUS: usize = 0x322c;

/// The status bits of a command that was not accepted.
const REFUSED: u32 = 3;
/// The bits of the queue's status that count its free places.
const FREE_PLACES: u32 = 0xffff;

/// What a failed read or write of the file `mfc` becomes.
fn failed(_: io::Error) -> Errno {
    Errno(libc::EIO)
}

/// A command as the kernel reads it: a reserved word, local-store address, effective address, size,
/// tag, classes, opcode.
fn kernel_command(transfer: &Transfer, size: u16) -> [u8; 24] {
    let mut bytes = [0; 24];
    let ea = transfer.ea.expose_provenance() as u64;
    let class = (transfer.tid << 8 | transfer.rid) as u16;
    bytes[4..8].copy_from_slice(&transfer.ls.to_be_bytes());
    bytes[8..16].copy_from_slice(&ea.to_be_bytes());
    bytes[16..18].copy_from_slice(&size.to_be_bytes());
    bytes[18..20].copy_from_slice(&(transfer.tag as u16).to_be_bytes());
    bytes[20..22].copy_from_slice(&class.to_be_bytes());
    bytes[22..24].copy_from_slice(&(transfer.opcode as u16).to_be_bytes());
    bytes
}

/// Gives a command to the hardware, and waits while its queue is full.
fn give(areas: &Mapping, transfer: &Transfer) {
    let ea = transfer.ea.expose_provenance() as u64;
    let class = transfer.tid << 24 | transfer.rid << 16;
    loop {
        while areas.load(MFC_QUEUE_STATUS) & FREE_PLACES == 0 {
            thread::yield_now();
        }
        // A command needs all of its parameters each time.
        areas.store(MFC_LSA, transfer.ls);
        areas.store(MFC_EAH, (ea >> 32) as u32);
        areas.store(MFC_EAL, ea as u32);
        areas.store(MFC_SIZE_TAG, transfer.size << 16 | transfer.tag);
        areas.store(MFC_COMMAND, class | transfer.opcode);
        if areas.load(MFC_COMMAND) & REFUSED == 0 {
            return;
        }
    }
}

impl Spufs {
    fn issued(&self) -> MutexGuard<'_, u32> {
        self.issued_tags.lock().unwrap_or_else(PoisonError::into_inner)
    }

    pub(super) fn give_command(&self, transfer: &Transfer) -> Result<(), Errno> {
        let tag = 1 << transfer.tag;
        if let Some(areas) = &self.areas {
            // One command at a time, because its parameters are several registers.
            let mut issued = self.issued();
            give(areas, transfer);
            *issued |= tag;
            return Ok(());
        }
        // The kernel would refuse a size of more than 16 KB, but its field is shorter than ours.
        let size = u16::try_from(transfer.size).map_err(|_| Errno(libc::EIO))?;
        // Marked as issued before it is queued, so that whoever learns of its completion finds it
        // in the set.
        let before = *self.issued();
        *self.issued() |= tag;
        let written = self
            .mfc
            .file(&self.directory)
            .and_then(|mut file| file.write_all(&kernel_command(transfer, size)));
        if written.is_err() {
            *self.issued() &= !tag | before;
        }
        written.map_err(failed)
    }

    pub(super) fn complete_tags(&self, mask: u32, wait: TagWait) -> Result<u32, Errno> {
        match &self.areas {
            Some(areas) => {
                let issued = self.issued();
                Ok(tags_by_register(areas, asked(mask, *issued), wait))
            }
            None => self.tags_by_file(wait),
        }
    }

    /// The kernel records which tags were used, and which of them it has reported.
    fn tags_by_file(&self, wait: TagWait) -> Result<u32, Errno> {
        let mut complete = 0;
        loop {
            let waits = match wait {
                TagWait::Immediate => false,
                TagWait::Any => complete == 0,
                TagWait::All => true,
            };
            // Where no tag is outstanding, the kernel would wait for ever.
            if *self.issued() == 0 || !waits && complete != 0 {
                return Ok(complete);
            }
            let file = if waits { &self.mfc } else { &self.mfc_at_once };
            // Only waiting and `poll` ask the MFC for tags.
            if !waits && !file.is_readable(&self.directory).map_err(failed)? {
                return Ok(complete);
            }
            let status = file.read(&self.directory).map_err(failed)?;
            let mut issued = self.issued();
            let tags = status.unwrap_or(0) & *issued;
            *issued &= !tags;
            complete |= tags;
            if !waits {
                return Ok(complete);
            }
        }
    }
}

fn tags_by_register(areas: &Mapping, mask: u32, wait: TagWait) -> u32 {
    loop {
        areas.store(PROXY_QUERY_MASK, mask);
        let complete = areas.load(PROXY_TAG_STATUS);
        if wait == TagWait::Immediate || complete == mask {
            return complete;
        }
        thread::yield_now();
    }
}
