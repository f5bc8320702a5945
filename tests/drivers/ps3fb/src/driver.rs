//! ps3fb, as the kernel's source has it: video modes, frames, what is copied to the television.
//!
//! Invariant: every reply follows from the mode and the memory's size, by the driver's own
//! arithmetic.

use super::Errno;
use libc::c_void;
use std::fs::File;
use std::os::unix::fs::FileExt;

const MIB: u32 = 1 << 20;
/// What the driver keeps of its memory for the video chip's commands.
const COMMANDS: u32 = 64 << 10;
const FULL: u32 = 0x80;
const BASE: u32 = 0x0F;

/// Pixels of each video mode, from number 1 on: within borders, and native. Those of monitors,
/// from 11 on, have no borders.
const MODES: [[(u32, u32); 2]; 13] = [
    [(576, 384), (720, 480)],
    [(576, 384), (720, 480)],
    [(1124, 644), (1280, 720)],
    [(1688, 964), (1920, 1080)],
    [(1688, 964), (1920, 1080)],
    [(576, 460), (720, 576)],
    [(576, 460), (720, 576)],
    [(1124, 644), (1280, 720)],
    [(1688, 964), (1920, 1080)],
    [(1688, 964), (1920, 1080)],
    [(1280, 768), (1280, 768)],
    [(1280, 1024), (1280, 1024)],
    [(1920, 1200), (1920, 1200)],
];

pub(super) struct Driver {
    memory: File,
    screen: File,
    mode: u32,
    smem_len: u32,
    /// Whether it maps the video memory, as a patch has it: no copies, lines as the chip has them.
    patched: bool,
    /// Bits of a pixel; the console's driver has no other number than 32.
    depth: u32,
    /// Calls to wait or select that it still handles; `None` for ever.
    patience: Option<u32>,
}

impl Driver {
    /// A driver by words: `mode:N` and `memory:MIB` (131 and 9 when left out), `patched`,
    /// `depth:BITS`, and `vanishes:N`, after which the device is gone.
    pub(super) fn new(words: &str, memory: File, screen: File) -> Driver {
        let mut driver = Driver {
            memory,
            screen,
            mode: 3 | FULL,
            smem_len: 9 * MIB - COMMANDS,
            patched: false,
            depth: 32,
            patience: None,
        };
        for word in words.split_whitespace() {
            let (name, value) = word.split_once(':').unwrap_or((word, "0"));
            let value: u32 = value.parse().unwrap_or_else(|error| panic!("PS3FB: {word}: {error}"));
            match name {
                "mode" => driver.mode = value,
                "memory" => driver.smem_len = value * MIB - COMMANDS,
                "patched" => (driver.patched, driver.smem_len) = (true, 32 * MIB),
                "depth" => driver.depth = value,
                "vanishes" => driver.patience = Some(value),
                _ => panic!("PS3FB: {word} is no word for a driver"),
            }
        }
        driver
            .memory
            .set_len(driver.smem_len.into())
            .unwrap_or_else(|error| panic!("PS3FB_MEMORY: {error}"));
        driver
    }

    fn native(&self) -> (u32, u32) {
        MODES[(self.mode & BASE) as usize - 1][1]
    }

    fn shown(&self) -> (u32, u32) {
        MODES[(self.mode & BASE) as usize - 1][usize::from(self.mode & FULL != 0)]
    }

    fn line_length(&self) -> u32 {
        if self.patched { self.native().0 * 4 } else { (self.shown().0 * 4).next_multiple_of(64) }
    }

    fn frames(&self) -> u32 {
        let (width, height) = self.native();
        self.smem_len / (width * 4 * height).max(self.line_length() * self.shown().1)
    }

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
        let words = argument.cast::<u32>();
        // SAFETY: the caller's promise: each request's structure holds the words written or read
        // here.
        unsafe {
            match request {
                // FBIOGET_VSCREENINFO
                0x4600 => {
                    let (width, height) = self.shown();
                    words.cast::<[u32; 40]>().write([0; 40]);
                    for (at, value) in
                        [(0, width), (4, height), (8, width), (12, height), (24, self.depth)]
                    {
                        words.byte_add(at).write(value);
                    }
                    for (at, offset) in [(32, 16), (44, 8), (56, 0), (68, 24)] {
                        words.byte_add(at).write(offset);
                        words.byte_add(at + 4).write(8);
                    }
                    Ok(())
                }
                // FBIOGET_FSCREENINFO
                0x4602 => {
                    words.cast::<[u32; 20]>().write([0; 20]);
                    words.cast::<[u8; 5]>().write(*b"ps3fb");
                    for (at, value) in [(24, self.smem_len), (36, 2), (48, self.line_length())] {
                        words.byte_add(at).write(value);
                    }
                    Ok(())
                }
                // FBIO_WAITFORVSYNC
                0x8004_4620 => {
                    note("WAITFORVSYNC".to_owned());
                    self.wait()
                }
                // PS3FB_IOCTL_SETMODE
                0x8004_7201 => {
                    let mode = words.read();
                    note(format!("SETMODE {mode}"));
                    self.set_mode(mode)
                }
                // PS3FB_IOCTL_GETMODE
                0x4004_7202 => {
                    words.write(self.mode);
                    Ok(())
                }
                // PS3FB_IOCTL_SCREENINFO
                0x4004_7203 => {
                    let (stride, (width, height)) = (self.line_length() / 4, self.shown());
                    let reply = [stride, height, (stride - width) / 2, 0, self.frames()];
                    words.cast::<[u32; 5]>().write(reply);
                    Ok(())
                }
                // PS3FB_IOCTL_ON
                0x2000_7204 => {
                    note("ON".to_owned());
                    Ok(())
                }
                // PS3FB_IOCTL_OFF
                0x2000_7205 => {
                    note("OFF".to_owned());
                    Ok(())
                }
                // PS3FB_IOCTL_FSEL
                0x8004_7206 => {
                    let frame = words.read();
                    note(format!("FSEL {frame}"));
                    self.wait()?;
                    self.select(frame)
                }
                _ => Err(libc::ENOTTY),
            }
        }
    }

    fn wait(&mut self) -> Result<(), Errno> {
        match &mut self.patience {
            Some(0) => Err(libc::ENODEV),
            Some(left) => {
                *left -= 1;
                Ok(())
            }
            None => Ok(()),
        }
    }

    fn set_mode(&mut self, mode: u32) -> Result<(), Errno> {
        if !(1..=MODES.len() as u32).contains(&(mode & BASE)) {
            return Err(libc::EINVAL);
        }
        let before = std::mem::replace(&mut self.mode, mode);
        if self.line_length() * self.shown().1 > self.smem_len {
            self.mode = before;
            return Err(libc::ENOMEM);
        }
        let cleared = self.memory.write_all_at(&vec![0; self.smem_len as usize], 0);
        cleared.map_err(|error| error.raw_os_error().unwrap_or(libc::EIO))
    }

    /// Copies a frame to the screen.
    fn select(&self, frame: u32) -> Result<(), Errno> {
        if frame >= self.frames() {
            return Err(libc::EINVAL);
        }
        let mut picture = vec![0; (self.line_length() * self.shown().1) as usize];
        let offset = u64::from(frame) * picture.len() as u64;
        let copied = self
            .memory
            .read_exact_at(&mut picture, offset)
            .and_then(|()| self.screen.set_len(picture.len() as u64))
            .and_then(|()| self.screen.write_all_at(&picture, 0));
        copied.map_err(|error| error.raw_os_error().unwrap_or(libc::EIO))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::os::fd::FromRawFd;

    /// A driver whose memory nobody looks at.
    fn driver(words: &str) -> Driver {
        let file = || {
            let name = c"ps3fb";
            // SAFETY: the name is a zero-terminated string; the descriptor is new and nobody
            // else's.
            unsafe { File::from_raw_fd(libc::memfd_create(name.as_ptr(), 0)) }
        };
        Driver::new(words, file(), file())
    }

    #[test]
    fn frames_and_lines_equal_kernel_arithmetic() {
        // Words, bytes of a line, frames: what the driver's source gives for each.
        for (words, line, frames) in [
            ("mode:129", 2880, 6),
            ("mode:129 memory:18", 2880, 13),
            ("mode:3", 4544, 2),
            ("mode:3 memory:18", 4544, 5),
            ("mode:131", 5120, 2),
            ("mode:5", 6784, 1),
            ("mode:133", 7680, 1),
            ("mode:133 memory:18", 7680, 2),
            ("mode:3 patched", 5120, 9),
        ] {
            let driver = driver(words);
            assert_eq!((driver.line_length(), driver.frames()), (line, frames), "{words}");
        }
    }

    #[test]
    fn unavailable_mode_is_refused_and_not_set() {
        let mut small = driver("mode:3 memory:3");
        assert_eq!(small.set_mode(131), Err(libc::ENOMEM));
        assert_eq!(small.set_mode(14), Err(libc::EINVAL));
        assert_eq!(small.mode, 3);
        assert_eq!(small.set_mode(130), Ok(()));
        assert_eq!(small.select(2), Err(libc::EINVAL));
    }
}
