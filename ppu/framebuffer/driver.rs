//! The calls of a framebuffer driver, one method each, without any logic.
//!
//! Tests implement the trait with a scripted driver in place of the kernel's.

use super::ioctl::{self, Encoding, FbFixScreeninfo, FbVarScreeninfo, Ps3fbIoctlRes};
use super::last_resort::{Argument, Place, RestorePromise};
use memmap2::{MmapOptions, MmapRaw};
use std::fs::{File, OpenOptions};
use std::io;
use std::os::fd::{AsFd, AsRawFd};
use std::os::unix::fs::OpenOptionsExt;
use std::path::Path;

/// The device's memory in this process.
pub(super) struct Mapping {
    map: MmapRaw,
    /// The offset of the framebuffer. The kernel maps from the page that it begins in.
    start: usize,
}

impl Mapping {
    /// The framebuffer occupies the bytes of `map` from `start` on.
    pub(super) fn new(map: MmapRaw, start: usize) -> Mapping {
        Mapping { map, start }
    }

    /// The address of the framebuffer's first byte.
    pub(super) fn base(&self) -> *mut u8 {
        self.map.as_mut_ptr().wrapping_add(self.start)
    }
}

/// A framebuffer driver. Errors are the calls' errno, unchanged.
pub(super) trait Driver: Send {
    /// FBIOGET_VSCREENINFO.
    fn var_screeninfo(&mut self) -> io::Result<FbVarScreeninfo>;
    /// FBIOGET_FSCREENINFO.
    fn fix_screeninfo(&mut self) -> io::Result<FbFixScreeninfo>;
    /// Maps all of the memory that `fix` describes.
    fn map(&mut self, fix: &FbFixScreeninfo) -> io::Result<Mapping>;
    /// FBIOPAN_DISPLAY, which uses only the offsets in `var`.
    fn pan_display(&mut self, var: &FbVarScreeninfo) -> io::Result<()>;
    /// FBIO_WAITFORVSYNC.
    fn wait_for_vsync(&mut self) -> io::Result<()>;
    /// PS3FB_IOCTL_GETMODE.
    fn ps3fb_getmode(&mut self) -> io::Result<u32>;
    /// PS3FB_IOCTL_SETMODE: sets a video mode and clears the memory.
    fn ps3fb_setmode(&mut self, mode: u32) -> io::Result<()>;
    /// PS3FB_IOCTL_SCREENINFO.
    fn ps3fb_screeninfo(&mut self) -> io::Result<Ps3fbIoctlRes>;
    /// PS3FB_IOCTL_ON: from now on only `ps3fb_fsel` shows frames.
    fn ps3fb_on(&mut self) -> io::Result<()>;
    /// PS3FB_IOCTL_OFF: the kernel shows frame 0 at every vertical blank.
    fn ps3fb_off(&mut self) -> io::Result<()>;
    /// PS3FB_IOCTL_FSEL: copies this frame to the video memory and shows it.
    fn ps3fb_fsel(&mut self, frame: u32) -> io::Result<()>;
    /// Promises to restore `place` with a request if the program ends without a drop. `None` if
    /// there is no device that outlives the program.
    fn promise(&self, place: Place, request: u32, argument: Argument) -> Option<RestorePromise>;
}

/// The kernel's driver of a device node.
pub(super) struct KernelDriver {
    device: File,
}

impl KernelDriver {
    pub(super) fn open(path: &Path) -> io::Result<KernelDriver> {
        // The path may be another device, for example a serial line, on which opening would wait
        // without O_NONBLOCK.
        let flags = libc::O_NONBLOCK | libc::O_NOCTTY;
        let device = OpenOptions::new().read(true).write(true).custom_flags(flags).open(path)?;
        Ok(KernelDriver { device })
    }

    fn request<T>(&mut self, request: u32, argument: &mut T) -> io::Result<()> {
        // SAFETY: the descriptor is open. Each caller passes the structure that its request reads
        // or writes, and it outlives the call.
        let result = unsafe {
            libc::ioctl(self.device.as_raw_fd(), request as libc::Ioctl, argument as *mut T)
        };
        if result < 0 { Err(io::Error::last_os_error()) } else { Ok(()) }
    }
}

impl Driver for KernelDriver {
    fn var_screeninfo(&mut self) -> io::Result<FbVarScreeninfo> {
        let mut var = FbVarScreeninfo::default();
        self.request(ioctl::FBIOGET_VSCREENINFO, &mut var)?;
        Ok(var)
    }

    fn fix_screeninfo(&mut self) -> io::Result<FbFixScreeninfo> {
        let mut fix = FbFixScreeninfo::default();
        self.request(ioctl::FBIOGET_FSCREENINFO, &mut fix)?;
        Ok(fix)
    }

    fn map(&mut self, fix: &FbFixScreeninfo) -> io::Result<Mapping> {
        // SAFETY: sysconf only reads its argument.
        let page = unsafe { libc::sysconf(libc::_SC_PAGESIZE) };
        let page = libc::c_ulong::try_from(page).map_err(io::Error::other)?;
        let start = (fix.smem_start % page) as usize;
        let map = MmapOptions::new().len(start + fix.smem_len as usize).map_raw(&self.device)?;
        Ok(Mapping::new(map, start))
    }

    fn pan_display(&mut self, var: &FbVarScreeninfo) -> io::Result<()> {
        self.request(ioctl::FBIOPAN_DISPLAY, &mut var.clone())
    }

    fn wait_for_vsync(&mut self) -> io::Result<()> {
        let mut first_screen = 0u32;
        self.request(const { Encoding::HOST.fbio_waitforvsync() }, &mut first_screen)
    }

    fn ps3fb_getmode(&mut self) -> io::Result<u32> {
        let mut mode = 0u32;
        self.request(const { Encoding::HOST.ps3fb_ioctl_getmode() }, &mut mode)?;
        Ok(mode)
    }

    fn ps3fb_setmode(&mut self, mut mode: u32) -> io::Result<()> {
        self.request(const { Encoding::HOST.ps3fb_ioctl_setmode() }, &mut mode)
    }

    fn ps3fb_screeninfo(&mut self) -> io::Result<Ps3fbIoctlRes> {
        let mut screen = Ps3fbIoctlRes::default();
        self.request(const { Encoding::HOST.ps3fb_ioctl_screeninfo() }, &mut screen)?;
        Ok(screen)
    }

    fn ps3fb_on(&mut self) -> io::Result<()> {
        self.request(const { Encoding::HOST.ps3fb_ioctl_on() }, &mut ())
    }

    fn ps3fb_off(&mut self) -> io::Result<()> {
        self.request(const { Encoding::HOST.ps3fb_ioctl_off() }, &mut ())
    }

    fn ps3fb_fsel(&mut self, mut frame: u32) -> io::Result<()> {
        self.request(const { Encoding::HOST.ps3fb_ioctl_fsel() }, &mut frame)
    }

    fn promise(&self, place: Place, request: u32, argument: Argument) -> Option<RestorePromise> {
        Some(RestorePromise::promise(place, self.device.as_fd(), request, argument))
    }
}
