//! A driver that follows a script and records the calls. A witness can read its memory.

use super::super::super::driver::{Driver, Mapping};
use super::super::super::ioctl::{FbBitfield, FbFixScreeninfo, FbVarScreeninfo, Ps3fbIoctlRes};
use super::super::super::last_resort::{Argument, Place, RestorePromise};
use super::super::super::{FramebufferError, Geometry, Options, pattern};
use super::super::{Device, Mode};
use memmap2::MmapRaw;
use std::fs;
use std::io;
use std::os::unix::fs::FileExt;
use std::path::Path;
use std::sync::{Arc, Mutex};

#[derive(Clone, Debug, PartialEq)]
pub(super) enum Call {
    Getmode,
    Setmode(u32),
    Screeninfo,
    On,
    Off,
    Fsel(u32),
    Vsync,
    Pan(u32, u32),
}

/// A scripted driver. The calls in `failing` return their errno.
pub(super) struct Script {
    pub(super) var: FbVarScreeninfo,
    pub(super) fix: FbFixScreeninfo,
    pub(super) num_frames: u32,
    /// The video mode, and the results of FBIOGET after another mode was set.
    pub(super) mode: u32,
    pub(super) other_mode: Option<(FbVarScreeninfo, FbFixScreeninfo)>,
    /// The number of bytes in the mapping before the framebuffer.
    pub(super) start: usize,
    failing: Vec<(Call, i32)>,
    memory: fs::File,
    calls: Arc<Mutex<Vec<Call>>>,
}

/// A test's view of a driver that the device owns.
pub(super) struct Witness {
    memory: fs::File,
    start: usize,
    calls: Arc<Mutex<Vec<Call>>>,
}

pub(super) const PATH: &str = "/dev/fb0";
pub(super) const MIB: u32 = 1 << 20;

impl Script {
    pub(super) fn new(
        id: &str,
        width: u32,
        height: u32,
        line_length: u32,
        smem_len: u32,
    ) -> Script {
        let channel = |offset| FbBitfield { offset, length: 8, msb_right: 0 };
        let var = FbVarScreeninfo {
            xres: width,
            yres: height,
            xres_virtual: width,
            yres_virtual: height,
            bits_per_pixel: 32,
            red: channel(16),
            green: channel(8),
            blue: channel(0),
            transp: channel(24),
            ..Default::default()
        };
        let mut fix = FbFixScreeninfo { smem_len, visual: 2, line_length, ..Default::default() };
        fix.id[..id.len()].copy_from_slice(id.as_bytes());
        Script {
            var,
            fix,
            num_frames: 2,
            mode: 3,
            other_mode: None,
            start: 0,
            failing: Vec::new(),
            memory: tempfile::tempfile().unwrap(),
            calls: Arc::default(),
        }
    }

    /// The mainline driver at 720p, without borders and with its default memory.
    pub(super) fn ps3fb() -> Script {
        Script::new("ps3fb", 1280, 720, 5120, 9 * MIB - 0x1_0000)
    }

    /// A driver whose screen can be moved over a picture of twice its height.
    pub(super) fn panning() -> Script {
        let mut script = Script::new("simple", 101, 57, 404, 404 * 57 * 2);
        script.var.yres_virtual = 57 * 2;
        script.fix.ypanstep = 1;
        script
    }

    pub(super) fn failing(mut self, failing: impl IntoIterator<Item = (Call, i32)>) -> Script {
        self.failing.extend(failing);
        self
    }

    /// Opens a device of this size with this driver.
    pub(super) fn open(
        self,
        size: Option<Geometry>,
        mode: Option<Mode>,
    ) -> (Result<Device, FramebufferError>, Witness) {
        self.open_with(Options { size, mode, ..Options::default() })
    }

    /// Opens a device with this driver.
    pub(super) fn open_with(self, options: Options) -> (Result<Device, FramebufferError>, Witness) {
        let length = self.start as u64 + u64::from(self.fix.smem_len);
        self.memory.set_len(length).unwrap();
        self.memory.write_all_at(&vec![0xA5; length as usize], 0).unwrap();
        let witness = Witness {
            memory: self.memory.try_clone().unwrap(),
            start: self.start,
            calls: self.calls.clone(),
        };
        let path = Path::new(PATH);
        let console = Err(io::Error::from(io::ErrorKind::Unsupported));
        let device = Device::look(Box::new(self), path, options)
            .and_then(|found| Device::start(found, path, options, console));
        (device, witness)
    }

    /// The description of this driver without changing anything, and the calls made for it.
    pub(super) fn inspect(self) -> (String, Vec<Call>) {
        self.memory.set_len(self.fix.smem_len.into()).unwrap();
        let (path, calls) = (Path::new(PATH), self.calls.clone());
        let found = Device::look(Box::new(self), path, Options::default()).unwrap();
        let summary = found.summary(path);
        (summary, std::mem::take(&mut *calls.lock().unwrap()))
    }

    fn call(&mut self, call: Call) -> io::Result<()> {
        self.calls.lock().unwrap().push(call.clone());
        match self.failing.iter().find(|(failing, _)| *failing == call) {
            Some((_, errno)) => Err(io::Error::from_raw_os_error(*errno)),
            None => Ok(()),
        }
    }
}

impl Driver for Script {
    fn var_screeninfo(&mut self) -> io::Result<FbVarScreeninfo> {
        Ok(self.var)
    }
    fn fix_screeninfo(&mut self) -> io::Result<FbFixScreeninfo> {
        Ok(self.fix)
    }
    fn map(&mut self, _: &FbFixScreeninfo) -> io::Result<Mapping> {
        Ok(Mapping::new(MmapRaw::map_raw(&self.memory)?, self.start))
    }
    fn pan_display(&mut self, var: &FbVarScreeninfo) -> io::Result<()> {
        self.call(Call::Pan(var.xoffset, var.yoffset))
    }
    fn wait_for_vsync(&mut self) -> io::Result<()> {
        self.call(Call::Vsync)
    }
    fn ps3fb_getmode(&mut self) -> io::Result<u32> {
        self.call(Call::Getmode).map(|()| self.mode)
    }
    fn ps3fb_setmode(&mut self, mode: u32) -> io::Result<()> {
        self.call(Call::Setmode(mode))?;
        self.mode = mode;
        if let Some((var, fix)) = self.other_mode.take() {
            (self.var, self.fix) = (var, fix);
        }
        Ok(())
    }
    fn ps3fb_screeninfo(&mut self) -> io::Result<Ps3fbIoctlRes> {
        let num_frames = self.num_frames;
        self.call(Call::Screeninfo).map(|()| Ps3fbIoctlRes { num_frames, ..Default::default() })
    }
    fn ps3fb_on(&mut self) -> io::Result<()> {
        self.call(Call::On)
    }
    fn ps3fb_off(&mut self) -> io::Result<()> {
        self.call(Call::Off)
    }
    fn ps3fb_fsel(&mut self, frame: u32) -> io::Result<()> {
        self.call(Call::Fsel(frame))
    }
    fn promise(&self, _: Place, _: u32, _: Argument) -> Option<RestorePromise> {
        None
    }
}

impl Witness {
    /// The calls since the last question.
    pub(super) fn calls(&self) -> Vec<Call> {
        std::mem::take(&mut *self.calls.lock().unwrap())
    }

    /// Asserts that the frame at `offset` has the test picture of `seed`, in the host's native
    /// pixels.
    pub(super) fn assert_shows(
        &self,
        geometry: Geometry,
        line_length: u32,
        offset: usize,
        seed: u32,
    ) {
        let mut picture = image::RgbImage::new(geometry.width, geometry.height);
        for (x, y, pixel) in picture.enumerate_pixels_mut() {
            let at = self.start + offset + (y * line_length + x * 4) as usize;
            let mut bytes = [0; 4];
            self.memory.read_exact_at(&mut bytes, at as u64).unwrap();
            let word = u32::from_ne_bytes(bytes);
            pixel.0 = [(word >> 16) as u8, (word >> 8) as u8, word as u8];
        }
        pattern::assert_shows(&picture, seed);
    }

    /// The bytes of the framebuffer's memory in `range`.
    pub(super) fn bytes(&self, range: std::ops::Range<usize>) -> Vec<u8> {
        let mut bytes = vec![0; range.len()];
        self.memory.read_exact_at(&mut bytes, (self.start + range.start) as u64).unwrap();
        bytes
    }
}
