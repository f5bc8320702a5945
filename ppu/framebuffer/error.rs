//! What can go wrong with a framebuffer, in words that name the file and the values found.

use super::Geometry;
use super::raster::Raster;
use std::io;
use std::path::{Path, PathBuf};

/// Why a framebuffer could not be opened or a frame not be shown.
#[derive(Debug, thiserror::Error)]
pub enum FramebufferError {
    /// A side is zero or too long.
    #[error(transparent)]
    BadSize(nff::ViewError),
    /// A size is not written `WIDTHxHEIGHT`.
    #[error("{text:?} is no size: expected WIDTHxHEIGHT, as in 1280x720")]
    MalformedSize {
        /// The text as given.
        text: String,
    },
    /// Paths that have no number, or more than one.
    #[error("{pattern:?} numbers nothing: expected the number's place once, as in frame-%05d.png")]
    MalformedNumbering {
        /// The pattern as given.
        pattern: String,
    },
    /// Pictures were asked of a framebuffer whose frames can't be read back.
    #[error("what is shown there can't be read back as a picture")]
    NoPicture,
    /// A file has no geometry of its own and none was given.
    #[error("{}: no framebuffer device, and a file in the place of one needs a size", path.display())]
    SizeNeeded {
        /// The file.
        path: PathBuf,
    },
    /// The device's mode is not the size asked for.
    #[error("{}: asked for {requested}, but the device shows {actual}", path.display())]
    SizeMismatch {
        /// The device.
        path: PathBuf,
        /// What was asked for.
        requested: Geometry,
        /// What the driver says.
        actual: Geometry,
    },
    /// A file holds a framebuffer of another geometry, or was cut while open.
    #[error(
        "{}: holds {found} bytes, but a framebuffer of {geometry} takes {expected}: \
         it belongs to another geometry",
        path.display()
    )]
    FileSize {
        /// The file.
        path: PathBuf,
        /// Its length in bytes.
        found: u64,
        /// The length that `geometry` needs, in bytes.
        expected: u64,
        /// The size asked for.
        geometry: Geometry,
    },
    /// The path is neither a device nor a regular file.
    #[error("{}: is {kind}, not a framebuffer", path.display())]
    NotAFramebuffer {
        /// The path.
        path: PathBuf,
        /// What it is.
        kind: &'static str,
    },
    /// The operating system refused.
    #[error("cannot {action} {}: {source}", path.display())]
    Io {
        /// What was tried, as a verb.
        action: &'static str,
        /// On what.
        path: PathBuf,
        /// The system's answer.
        source: io::Error,
    },
    /// The driver refused a request that the program can't do without.
    #[error("{}: {request}: {source}", path.display())]
    Ioctl {
        /// The device.
        path: PathBuf,
        /// Name of the request.
        request: &'static str,
        /// The driver's answer.
        source: io::Error,
    },
    /// The driver's pixels are not 32 bits of 8-bit channels.
    #[error("{}: driver {driver}: {found}; only 32-bit packed true colour with 8-bit channels is supported", path.display())]
    UnsupportedPixels {
        /// The device.
        path: PathBuf,
        /// The driver's name for itself.
        driver: String,
        /// What it said.
        found: String,
    },
    /// The driver's numbers contradict each other.
    #[error("{}: driver {driver}: {why}", path.display())]
    BadSurface {
        /// The device.
        path: PathBuf,
        /// The driver's name for itself.
        driver: String,
        /// The contradiction.
        why: String,
    },
    /// Rendering straight into the device was asked for, but DMA can't reach it as it is laid out.
    #[error("{}: driver {driver}: cannot render straight into it: {why}", path.display())]
    NoDirect {
        /// The device.
        path: PathBuf,
        /// The driver's name for itself.
        driver: String,
        /// The obstacle.
        why: String,
    },
    /// A video mode was asked for that the device does not have.
    #[error("{}: cannot set {raster}: {why}", path.display())]
    NoVideoMode {
        /// The device, or the file in its place.
        path: PathBuf,
        /// What was asked for.
        raster: Raster,
        /// The obstacle, or the driver's answer.
        why: String,
    },
    /// There is no memory for a frame.
    #[error("no memory for a frame of {bytes} bytes")]
    OutOfMemory {
        /// The size asked of the allocator.
        bytes: usize,
    },
    /// A picture could not be written.
    #[error("cannot write {}: {source}", path.display())]
    Png {
        /// The picture's file.
        path: PathBuf,
        /// The encoder's answer.
        source: image::ImageError,
    },
}

impl FramebufferError {
    pub(super) fn io(action: &'static str, path: &Path, source: io::Error) -> FramebufferError {
        FramebufferError::Io {
            action,
            path: path.to_owned(),
            source,
        }
    }
}
