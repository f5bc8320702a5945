//! The errors of framebuffers. Their messages name the file and the values found.

use super::Geometry;
use super::raster::Raster;
use std::io;
use std::path::{Path, PathBuf};

/// Why a framebuffer can't be opened, or a frame can't be shown.
#[derive(Debug, thiserror::Error)]
pub enum FramebufferError {
    /// A side of the picture is zero or too long.
    #[error(transparent)]
    BadSize(scenes::ViewError),
    /// A text is not of the form `WIDTHxHEIGHT`.
    #[error("{text:?} is not a size: expected WIDTHxHEIGHT, as in 1280x720")]
    MalformedSize {
        /// The text as given.
        text: String,
    },
    /// A pattern for paths has no place for a number, or more than one.
    #[error(
        "{pattern:?} is not a pattern: expected one place for the number, as in frame-%05d.png"
    )]
    MalformedNumbering {
        /// The pattern as given.
        pattern: String,
    },
    /// Pictures are requested from a framebuffer whose frames can't be read back.
    #[error("frames in this framebuffer can't be read back as pictures")]
    NoPicture,
    /// A file is to be used as a framebuffer, but no size was given.
    #[error("{}: not a framebuffer device, and a file instead of one needs a size", path.display())]
    SizeNeeded {
        /// The file.
        path: PathBuf,
    },
    /// The device has another size than the requested one.
    #[error("{}: requested {requested}, but the device shows {actual}", path.display())]
    SizeMismatch {
        /// The device.
        path: PathBuf,
        /// The requested size.
        requested: Geometry,
        /// The size that the driver reports.
        actual: Geometry,
    },
    /// A file has the length of another geometry, or was truncated while open.
    #[error(
        "{}: holds {found} bytes, but a framebuffer of {geometry} takes {expected}: \
         it belongs to another geometry",
        path.display()
    )]
    FileSize {
        /// The file.
        path: PathBuf,
        /// The file's length in bytes.
        found: u64,
        /// The length that `geometry` needs, in bytes.
        expected: u64,
        /// The requested size.
        geometry: Geometry,
    },
    /// The path is neither a device nor a regular file.
    #[error("{}: is {kind}, not a framebuffer", path.display())]
    NotAFramebuffer {
        /// The path.
        path: PathBuf,
        /// The kind of file that it is.
        kind: &'static str,
    },
    /// The operating system refused an action.
    #[error("cannot {action} {}: {source}", path.display())]
    Io {
        /// The action, as a verb.
        action: &'static str,
        /// The file.
        path: PathBuf,
        /// The system's error.
        source: io::Error,
    },
    /// The driver refused a request that the program needs.
    #[error("{}: {request}: {source}", path.display())]
    Ioctl {
        /// The device.
        path: PathBuf,
        /// The name of the request.
        request: &'static str,
        /// The driver's error.
        source: io::Error,
    },
    /// The driver's pixels are not 32 bits of 8-bit channels.
    #[error("{}: driver {driver}: {found}; only 32-bit packed true colour with 8-bit channels is supported", path.display())]
    UnsupportedPixels {
        /// The device.
        path: PathBuf,
        /// The name that the driver reports.
        driver: String,
        /// The format that it reports.
        found: String,
    },
    /// The driver's numbers contradict each other.
    #[error("{}: driver {driver}: {why}", path.display())]
    BadSurface {
        /// The device.
        path: PathBuf,
        /// The name that the driver reports.
        driver: String,
        /// The contradiction.
        why: String,
    },
    /// Rendering directly into the device is requested, but DMA can't write to its memory.
    #[error("{}: driver {driver}: cannot render directly into its memory: {why}", path.display())]
    NoDirect {
        /// The device.
        path: PathBuf,
        /// The name that the driver reports.
        driver: String,
        /// The obstacle.
        why: String,
    },
    /// The device doesn't have the requested video mode.
    #[error("{}: cannot set {raster}: {why}", path.display())]
    NoVideoMode {
        /// The device, or the file that is used instead.
        path: PathBuf,
        /// The requested raster.
        raster: Raster,
        /// The obstacle, or the driver's error.
        why: String,
    },
    /// There is not enough memory for a frame.
    #[error("no memory for a frame of {bytes} bytes")]
    OutOfMemory {
        /// The size of the frame.
        bytes: usize,
    },
    /// The name of a picture has the extension of a format that is not written.
    #[error("{}: pictures are written as .png, .jpg or .jpeg; a name without an extension is a PNG", path.display())]
    PictureFormat {
        /// The picture's path.
        path: PathBuf,
    },
    /// A picture could not be written.
    #[error("cannot write {}: {source}", path.display())]
    Picture {
        /// The picture's path.
        path: PathBuf,
        /// The encoder's error.
        source: image::ImageError,
    },
}

impl FramebufferError {
    pub(super) fn io(action: &'static str, path: &Path, source: io::Error) -> FramebufferError {
        FramebufferError::Io { action, path: path.to_owned(), source }
    }
}
