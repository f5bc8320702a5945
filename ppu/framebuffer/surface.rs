//! A driver's description of its screen, checked and converted. This file makes no calls.
//!
//! Invariant: at every frame offset that this returns, all shown pixels of the frame are within
//! the device's memory.

use super::ioctl::{FB_TYPE_PACKED_PIXELS, FB_VISUAL_TRUECOLOR, FbFixScreeninfo, FbVarScreeninfo};
use super::{DMA_ALIGN, FramebufferError, Geometry, PIXEL_BYTES, PixelFormat};
use std::path::Path;

/// The name that the PS3's driver reports.
pub(super) const PS3FB: &str = "ps3fb";

/// How to select the frame that a driver shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Scheme {
    /// With PS3FB_IOCTL_FSEL.
    Ps3fb,
    /// By moving the screen over a taller picture.
    Pan,
    /// There is only one frame, which is always visible.
    Single,
}

/// A screen of 32-bit pixels.
#[derive(Debug)]
pub(super) struct Surface {
    pub(super) driver: String,
    pub(super) geometry: Geometry,
    pub(super) format: PixelFormat,
    /// The number of bytes from a row to the next.
    pub(super) line_length: u32,
    /// The size of the device's memory in bytes.
    smem_len: usize,
    /// The rows of the whole picture, of which the screen shows `geometry.height`.
    virtual_rows: u32,
    xoffset: u32,
    yoffset: u32,
    ypanstep: u32,
    most_frames: u32,
}

impl Surface {
    pub(super) fn new(
        path: &Path,
        var: &FbVarScreeninfo,
        fix: &FbFixScreeninfo,
    ) -> Result<Surface, FramebufferError> {
        let driver = driver_name(&fix.id);
        let bad_surface = |why: String| FramebufferError::BadSurface {
            path: path.to_owned(),
            driver: driver.clone(),
            why,
        };
        let format =
            pixel_format(var, fix).map_err(|found| FramebufferError::UnsupportedPixels {
                path: path.to_owned(),
                driver: driver.clone(),
                found,
            })?;
        let geometry =
            Geometry::new(var.xres, var.yres).map_err(|error| bad_surface(error.to_string()))?;
        let surface = Surface {
            driver: driver.clone(),
            geometry,
            format,
            line_length: fix.line_length,
            smem_len: fix.smem_len as usize,
            virtual_rows: var.yres_virtual.max(var.yres),
            xoffset: var.xoffset,
            yoffset: var.yoffset,
            ypanstep: u32::from(fix.ypanstep),
            most_frames: 2,
        };
        if surface.column_offset() + geometry.shown_row_bytes() as u64 > u64::from(fix.line_length)
        {
            return Err(bad_surface(format!(
                "{} pixels at offset {} in lines of {} bytes",
                var.xres, var.xoffset, fix.line_length
            )));
        }
        if !surface.holds(surface.visible_offset()) {
            return Err(bad_surface(format!(
                "{geometry} at offset {},{} in lines of {} bytes does not fit its {} bytes of memory",
                var.xoffset, var.yoffset, fix.line_length, fix.smem_len
            )));
        }
        Ok(surface)
    }

    /// Uses only one frame from now on.
    pub(super) fn use_one_frame(&mut self) {
        self.most_frames = 1;
    }

    /// The scheme that the driver's numbers promise. The driver may still lack its calls.
    pub(super) fn scheme(&self) -> Scheme {
        let height = self.geometry.height;
        let steps_fit = self.ypanstep != 0 && height.is_multiple_of(self.ypanstep);
        if self.is_ps3fb() {
            if self.is_main_memory() { Scheme::Ps3fb } else { Scheme::Single }
        } else if self.most_frames > 1
            && steps_fit
            && self.virtual_rows / 2 >= height
            && self.holds(self.frame_offset(Scheme::Pan, 1))
        {
            Scheme::Pan
        } else {
            Scheme::Single
        }
    }

    /// The number of frames that the memory holds with `scheme`, at most two.
    pub(super) fn frames(&self, scheme: Scheme) -> u32 {
        let second = self.most_frames > 1
            && scheme != Scheme::Single
            && self.holds(self.frame_offset(scheme, 1));
        if second { 2 } else { 1 }
    }

    /// The byte offset of a frame's first pixel.
    pub(super) fn frame_offset(&self, scheme: Scheme, frame: u32) -> u64 {
        let line = u64::from(self.line_length);
        match scheme {
            // The driver copies from the pan offset within each frame.
            Scheme::Ps3fb => {
                self.visible_offset() + u64::from(frame) * u64::from(self.virtual_rows) * line
            }
            Scheme::Pan => {
                u64::from(frame) * u64::from(self.geometry.height) * line + self.column_offset()
            }
            Scheme::Single => self.visible_offset(),
        }
    }

    /// Why SPUs can't write to the frame at `address`, which is `offset` bytes into the memory;
    /// `None` if they can.
    pub(super) fn direct_obstacle(&self, address: usize, offset: u64) -> Option<String> {
        let line = self.line_length;
        // If both are multiples of a quadword, a line that holds the shown pixels also has space
        // for their last group of four.
        if !address.is_multiple_of(DMA_ALIGN) {
            Some(format!("a frame starts at address {address:#x}, not on {DMA_ALIGN} bytes"))
        } else if !(line as usize).is_multiple_of(DMA_ALIGN) {
            Some(format!("a line takes {line} bytes, which is not a multiple of {DMA_ALIGN}"))
        } else if offset + u64::from(line) * u64::from(self.geometry.height) > self.smem_len as u64
        {
            Some("its memory ends within the padding of the last line".to_owned())
        } else {
            None
        }
    }

    fn is_ps3fb(&self) -> bool {
        self.driver == PS3FB
    }

    /// Whether ps3fb's memory is main memory, which SPUs can access and which has its frames one
    /// after the other. The mainline driver reserves whole MiB, at most 48, and keeps 64 KiB of
    /// them for itself. Patched drivers that map the video memory report whole MiB; their frames'
    /// positions are unknown.
    fn is_main_memory(&self) -> bool {
        const KEPT: usize = 64 << 10;
        const MIB: usize = 1 << 20;
        let reserved = self.smem_len + KEPT;
        reserved.is_multiple_of(MIB) && reserved <= 48 * MIB
    }

    fn column_offset(&self) -> u64 {
        u64::from(self.xoffset) * u64::from(PIXEL_BYTES)
    }

    fn visible_offset(&self) -> u64 {
        (u64::from(self.yoffset) * u64::from(self.line_length)).saturating_add(self.column_offset())
    }

    /// Whether all shown pixels of a frame at `offset` are within the memory.
    fn holds(&self, offset: u64) -> bool {
        let last_row = u64::from(self.geometry.height - 1) * u64::from(self.line_length);
        let end = offset.saturating_add(last_row + self.geometry.shown_row_bytes() as u64);
        end <= self.smem_len as u64
    }
}

/// The driver's name, up to the first zero byte.
pub(super) fn driver_name(id: &[u8; 16]) -> String {
    let name = id.split(|&byte| byte == 0).next().unwrap_or_default();
    String::from_utf8_lossy(name).into_owned()
}

/// The pixel format, or the driver's description if it is not supported.
fn pixel_format(var: &FbVarScreeninfo, fix: &FbFixScreeninfo) -> Result<PixelFormat, String> {
    if var.bits_per_pixel != 32 {
        return Err(format!("{} bits a pixel", var.bits_per_pixel));
    }
    if fix.kind != FB_TYPE_PACKED_PIXELS || fix.visual != FB_VISUAL_TRUECOLOR {
        return Err(format!("type {}, visual {}", fix.kind, fix.visual));
    }
    if var.grayscale != 0 || var.nonstd != 0 {
        return Err(format!("grayscale or FOURCC {:#x}, nonstd {}", var.grayscale, var.nonstd));
    }
    let channels = [var.red, var.green, var.blue];
    let bytes = channels.iter().all(|channel| channel.length == 8 && channel.msb_right == 0);
    let [red, green, blue] = channels.map(|channel| channel.offset);
    PixelFormat::from_native_offsets(red, green, blue, cfg!(target_endian = "big"))
        .filter(|_| bytes)
        .ok_or_else(|| {
            let bits = channels.map(|channel| format!("{}+{}", channel.offset, channel.length));
            format!("red, green, blue at bits {}", bits.join(", "))
        })
}
