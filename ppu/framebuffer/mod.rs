//! Framebuffers: the console's screen, a file instead of it, memory, or PNG pictures.
//!
//! Owns the geometry, pixel format and addresses of the buffer that a frame is written to, and the
//! time at which a finished frame is shown. It is independent of scenes and work units: the SPUs
//! write finished rows by DMA through a [`Target`], and then the frame loop calls
//! [`Framebuffer::present`].
//!
//! Invariant: every [`Target`] follows the DMA rules stated there, whatever the driver offers. If
//! a driver's memory doesn't follow them, the frame is made in private memory and copied.

#[cfg(unix)]
mod arming;
mod buffer;
#[cfg(unix)]
mod console;
#[cfg(unix)]
mod corners;
#[cfg(unix)]
mod device;
#[cfg(unix)]
mod display;
#[cfg(unix)]
mod driver;
mod error;
#[cfg(unix)]
mod file;
#[cfg(unix)]
mod file_limit;
#[cfg(unix)]
mod forward;
#[cfg(unix)]
mod interrupted;
#[cfg(unix)]
mod ioctl;
#[cfg(unix)]
mod labels;
#[cfg(unix)]
mod last_resort;
mod memory;
#[cfg(unix)]
mod numbered;
#[cfg(unix)]
mod open;
#[cfg(test)]
mod pattern;
#[cfg(unix)]
mod picture_file;
mod pixel;
mod raster;
#[cfg(unix)]
mod surface;
#[cfg(unix)]
mod switching;
#[cfg(unix)]
mod video_mode;

#[cfg(unix)]
pub use corners::Corners;
#[cfg(unix)]
pub use device::{Device, Mode};
pub use error::FramebufferError;
#[cfg(unix)]
pub use file::File;
#[cfg(unix)]
pub use file_limit::refuse_large_files;
#[cfg(unix)]
pub use interrupted::Interrupted;
#[cfg(unix)]
pub use labels::Labels;
#[cfg(unix)]
pub use last_resort::LastResort;
#[cfg(unix)]
pub(crate) use last_resort::restore_screen;
pub use memory::Memory;
#[cfg(unix)]
pub use numbered::NumberedPath;
#[cfg(unix)]
pub use open::{open, open_with};
#[cfg(unix)]
pub use picture_file::{PictureFile, write_labelled, write_picture};
pub use pixel::PixelFormat;
pub use raster::Raster;

use std::fmt;
use std::ptr::NonNull;
use std::str::FromStr;

use image::RgbImage;

/// The bytes of a pixel. Only 32-bit formats are supported, because the PS3's driver has no other.
pub const PIXEL_BYTES: u32 = 4;

/// The alignment of a row's start in bytes: the MFC transfers whole quadwords.
pub const DMA_ALIGN: usize = 16;

/// The number of pixels that an SPU writes at once: four words are a quadword.
pub const PIXEL_GROUP: u32 = 4;

/// The size of a picture in pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Geometry {
    /// Pixels in a row.
    pub width: u32,
    /// Rows.
    pub height: u32,
}

impl Geometry {
    /// The largest width and height, which the SPUs accept too. With it every byte offset fits 32
    /// bits, including padding.
    pub const MAX_SIDE: u32 = {
        assert!(scenes::MAX_SIDE == protocol::layout::MAX_SIDE);
        scenes::MAX_SIDE
    };

    /// A checked geometry.
    ///
    /// # Errors
    /// [`FramebufferError::BadSize`] if a side isn't 1 to [`Geometry::MAX_SIDE`].
    pub fn new(width: u32, height: u32) -> Result<Geometry, FramebufferError> {
        let geometry = Geometry { width, height };
        geometry.check()?;
        Ok(geometry)
    }

    /// Checks both sides.
    ///
    /// # Errors
    /// [`FramebufferError::BadSize`] if a side isn't 1 to [`Geometry::MAX_SIDE`].
    pub fn check(self) -> Result<(), FramebufferError> {
        scenes::check_size(self.width, self.height).map_err(FramebufferError::BadSize)
    }

    /// The bytes of a row as an SPU writes it, in whole groups of four pixels.
    pub fn written_row_bytes(self) -> u32 {
        self.width.next_multiple_of(PIXEL_GROUP) * PIXEL_BYTES
    }

    /// The bytes of a row that are shown.
    pub(crate) fn shown_row_bytes(self) -> usize {
        self.width as usize * PIXEL_BYTES as usize
    }
}

impl fmt::Display for Geometry {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}x{}", self.width, self.height)
    }
}

impl FromStr for Geometry {
    type Err = FramebufferError;

    /// Parses `WIDTHxHEIGHT`, as in `1280x720`.
    fn from_str(text: &str) -> Result<Geometry, FramebufferError> {
        let malformed = || FramebufferError::MalformedSize { text: text.to_owned() };
        let (width, height) = text.split_once('x').ok_or_else(malformed)?;
        let is_number =
            |digits: &str| !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit());
        if !is_number(width) || !is_number(height) {
            return Err(malformed());
        }
        let number = |digits: &str| {
            let too_large = |_| FramebufferError::BadSize(scenes::ViewError::Size(text.to_owned()));
            digits.parse().map_err(too_large)
        };
        Geometry::new(number(width)?, number(height)?)
    }
}

/// The buffer that the next frame is written to.
///
/// - `base` is a multiple of [`DMA_ALIGN`], and so is `stride`.
/// - `stride` is at least [`Geometry::written_row_bytes`], and `bytes` is at least `stride` times
///   the height.
///
/// The PPU and DMA may write through `base` from the [`Framebuffer::target`] call that returned it
/// until the next call of any method of that framebuffer, or its drop.
#[derive(Clone, Copy, Debug)]
pub struct Target {
    /// The address of the first row.
    pub base: NonNull<u8>,
    /// The number of bytes from `base` that may be written.
    pub bytes: usize,
    /// The number of bytes from one row to the next.
    pub stride: u32,
    /// The size of the picture.
    pub geometry: Geometry,
    /// The positions of the channels in the word that an SPU stores.
    pub format: PixelFormat,
}

/// A destination of frames.
pub trait Framebuffer: Send {
    /// The size of the picture. It doesn't change while the framebuffer is open.
    fn geometry(&self) -> Geometry;

    /// The buffer for the next frame. With two buffers the address alternates, so call this for
    /// every frame.
    fn target(&mut self) -> Target;

    /// Shows the frame that was written to the last [`Framebuffer::target`]. All DMA into it must
    /// be complete.
    ///
    /// # Errors
    /// The device, the file or the picture can't be written.
    fn present(&mut self) -> Result<(), FramebufferError>;

    /// Whether the targets keep their contents, because nobody else writes to them now. If two
    /// successive calls return true, everything that was written between them is still there.
    fn keeps_contents(&self) -> bool {
        false
    }

    /// The frame that was shown last, or `None` if it can't be read back.
    fn picture(&self) -> Option<RgbImage> {
        None
    }

    /// A line of text for users: the kind of framebuffer, its size, stride, and how frames are
    /// shown.
    fn describe(&self) -> String;
}

#[cfg(unix)]
/// Options for opening a framebuffer. The defaults suit each kind best.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Options {
    /// The size of the picture. A file needs one. A device has its own, and another one is an
    /// error.
    pub size: Option<Geometry>,
    /// The video mode to set on ps3fb until the framebuffer is dropped; an error for other
    /// drivers.
    pub raster: Option<Raster>,
    /// Where a device's frames are made. `None` selects [`Mode::Direct`] if the device's memory is
    /// known to be main memory (mainline ps3fb) and is aligned for DMA, otherwise
    /// [`Mode::Shadow`].
    pub mode: Option<Mode>,
    /// Whether a device with memory for two frames shows one while the other is rendered.
    pub two_frames: bool,
    /// Whether a device waits for the vertical blank before a frame is shown.
    pub vsync: bool,
}

#[cfg(unix)]
impl Default for Options {
    fn default() -> Options {
        Options { size: None, raster: None, mode: None, two_frames: true, vsync: true }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn size_text_is_read_strictly() {
        assert_eq!("1280x720".parse::<Geometry>().unwrap(), Geometry { width: 1280, height: 720 });
        for text in [
            "", "x", "1280", "1280x", "x720", "1280X720", "+1x2", "-1x2", "1x2x3", "1 x2", "x2",
            "1x",
        ] {
            let error = text.parse::<Geometry>().unwrap_err();
            assert!(matches!(error, FramebufferError::MalformedSize { .. }), "{text:?}: {error}");
            assert!(error.to_string().contains(&format!("{text:?}")));
        }
        for text in ["0x1", "1x0", "8193x1", "1x8193", "99999999999x1"] {
            let error = text.parse::<Geometry>().unwrap_err();
            assert_eq!(
                error.to_string(),
                format!("a picture of {text} pixels: each side must be 1 to 8192")
            );
        }
    }

    #[test]
    fn rows_are_written_in_whole_groups() {
        for (width, bytes) in [(1, 16), (4, 16), (5, 32), (101, 416), (1124, 4496)] {
            assert_eq!(Geometry { width, height: 1 }.written_row_bytes(), bytes);
        }
    }
}
