//! A virtual terminal that is on the screen, and stays there.

use super::Errno;
use libc::c_void;

#[derive(Default)]
pub(super) struct Terminal {
    mode: u32,
    changes: [u8; 8],
}

impl Terminal {
    /// Handles a request.
    ///
    /// # Safety
    /// `argument` must be what `request` takes.
    pub(super) unsafe fn ioctl(
        &mut self,
        request: u32,
        argument: *mut c_void,
        note: &mut dyn FnMut(String),
    ) -> Result<(), Errno> {
        // SAFETY: the caller's promise: each request's structure holds what is written or read
        // here.
        unsafe {
            match request {
                // KDSETMODE takes a number.
                0x4B3A => {
                    self.mode = argument.addr() as u32;
                    note(format!("KDSETMODE {}", self.mode));
                }
                // KDGETMODE
                0x4B3B => argument.cast::<u32>().write(self.mode),
                // VT_GETMODE
                0x5601 => argument.cast::<[u8; 8]>().write(self.changes),
                // VT_SETMODE
                0x5602 => {
                    self.changes = argument.cast::<[u8; 8]>().read();
                    note(format!("VT_SETMODE {}", self.changes[0]));
                }
                // VT_GETSTATE
                0x5603 => argument.cast::<[u16; 3]>().write([1, 0, 2]),
                _ => return Err(libc::ENOTTY),
            }
        }
        Ok(())
    }
}
