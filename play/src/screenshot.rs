//! Screenshots with numbered names.
//!
//! Invariant: an existing file is never replaced.

use std::fs::{self, OpenOptions};
use std::io;
use std::path::{Path, PathBuf};

use cellray::framebuffer::write_picture;
use image::RgbImage;

const MAX_NUMBER: u32 = 9999;

/// Why a screenshot can't be written.
#[derive(Debug, thiserror::Error)]
pub enum ScreenshotError {
    /// The file can't be created.
    #[error("cannot write {}: {source}", path.display())]
    Io {
        path: PathBuf,
        /// The system's error.
        source: io::Error,
    },
    /// The picture can't be written.
    #[error(transparent)]
    Png(#[from] cellray::framebuffer::FramebufferError),
    /// All numbers are in use.
    #[error(
        "{}: all of {stem}-0001.png to {stem}-{MAX_NUMBER}.png exist already",
        folder.display()
    )]
    Full {
        folder: PathBuf,
        /// The beginning of the names.
        stem: String,
    },
}

/// Writes a picture as `STEM-NNNN.png` with the lowest free number, and returns its path.
///
/// # Errors
/// The file can't be created or written, or all numbers are in use.
pub fn write(folder: &Path, stem: &str, picture: &RgbImage) -> Result<PathBuf, ScreenshotError> {
    for number in 1..=MAX_NUMBER {
        let path = folder.join(format!("{stem}-{number:04}.png"));
        // The file is created first, so that a concurrent writer gets another name.
        match OpenOptions::new().write(true).create_new(true).open(&path) {
            Ok(_) => {
                if let Err(error) = write_picture(&path, picture) {
                    // The first error is the one to report.
                    let _ = fs::remove_file(&path);
                    return Err(error.into());
                }
                return Ok(path);
            }
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
            Err(source) => return Err(ScreenshotError::Io { path, source }),
        }
    }
    Err(ScreenshotError::Full { folder: folder.to_owned(), stem: stem.to_owned() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn existing_files_are_kept() {
        let folder = tempfile::tempdir().expect("a folder");
        let name = |number: u32| folder.path().join(format!("s-{number:04}.png"));
        fs::write(name(2), "a file of the user").expect("a file");
        let picture = RgbImage::new(3, 2);
        for number in [1, 3, 4] {
            let path = write(folder.path(), "s", &picture).expect("a picture");
            assert_eq!(path, name(number));
            assert_eq!(image::open(path).expect("a PNG").into_rgb8(), picture);
        }
        assert_eq!(fs::read(name(2)).expect("still there"), b"a file of the user");
    }

    #[test]
    fn failed_screenshot_leaves_no_file() {
        let folder = tempfile::tempdir().expect("a folder");
        // The encoder refuses a picture without pixels.
        let error = write(folder.path(), "s", &RgbImage::new(0, 0)).expect_err("no picture");
        assert!(error.to_string().contains("s-0001.png"), "{error}");
        assert_eq!(fs::read_dir(folder.path()).expect("a folder").count(), 0);
        let error = write(&folder.path().join("none"), "s", &picture()).expect_err("no folder");
        assert!(error.to_string().contains("none/s-0001.png"), "{error}");
    }

    fn picture() -> RgbImage {
        RgbImage::new(1, 1)
    }
}
