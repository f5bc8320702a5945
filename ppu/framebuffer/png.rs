//! Writes frames as PNG pictures.
//!
//! Invariant: the picture's path has either the previous file or a complete new picture. The new
//! one is written under another name in the same folder, synced to the disk, and then renamed.

use super::{Framebuffer, FramebufferError, Geometry, Memory, Target};
use image::codecs::png::PngEncoder;
use image::{ImageEncoder, RgbImage};
use std::ffi::OsString;
use std::fs::{self, OpenOptions};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::process;
use std::sync::atomic::{AtomicU32, Ordering};

/// Writes `picture` to `path` as an 8-bit RGB PNG, and replaces an existing picture. A symbolic
/// link is followed.
///
/// # Errors
/// - `path` exists and isn't a regular file; it is not changed.
/// - The picture can't be written; an existing one is not changed.
pub fn write_png(path: &Path, picture: &RgbImage) -> Result<(), FramebufferError> {
    let place = replaceable(path)?;
    let partial = partial_beside(&place)?;
    let written = write_whole(&partial, picture).map_err(|source| FramebufferError::Png {
        path: path.to_owned(),
        source,
    });
    let placed = written.and_then(|()| {
        fs::rename(&partial, &place)
            .map_err(|source| FramebufferError::io("put a picture at", &place, source))
    });
    if placed.is_err() {
        // The first error is the one to report. A partial file that can't be removed can be told
        // by its name.
        let _ = fs::remove_file(&partial);
    }
    placed
}

/// The path with links resolved, if a picture may be written there.
fn replaceable(path: &Path) -> Result<PathBuf, FramebufferError> {
    match fs::metadata(path) {
        Ok(metadata) if metadata.is_file() => {
            fs::canonicalize(path).map_err(|source| FramebufferError::io("follow", path, source))
        }
        // Renaming over a device node would destroy it.
        Ok(_) => Err(FramebufferError::io(
            "write",
            path,
            io::Error::other("it exists and is not a regular file"),
        )),
        // Renaming would replace a dangling link instead of creating its target.
        Err(error) if error.kind() == io::ErrorKind::NotFound && path.is_symlink() => {
            Err(FramebufferError::io(
                "write",
                path,
                io::Error::other("it is a link to a missing file"),
            ))
        }
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(path.to_owned()),
        Err(source) => Err(FramebufferError::io("look at", path, source)),
    }
}

/// A name that no other writer uses, in the same folder and so on the same file system.
fn partial_beside(place: &Path) -> Result<PathBuf, FramebufferError> {
    static SERIAL: AtomicU32 = AtomicU32::new(0);
    let Some(name) = place.file_name() else {
        return Err(FramebufferError::io(
            "write",
            place,
            io::Error::from(io::ErrorKind::InvalidFilename),
        ));
    };
    let mut hidden = OsString::from(".");
    hidden.push(name);
    hidden.push(format!(
        ".{}-{}.partial",
        process::id(),
        SERIAL.fetch_add(1, Ordering::Relaxed)
    ));
    Ok(place.with_file_name(hidden))
}

fn write_whole(partial: &Path, picture: &RgbImage) -> Result<(), image::ImageError> {
    let file = OpenOptions::new()
        .write(true)
        .create_new(true)
        .open(partial)?;
    let mut writer = BufWriter::new(file);
    PngEncoder::new(&mut writer).write_image(
        picture.as_raw(),
        picture.width(),
        picture.height(),
        image::ExtendedColorType::Rgb8,
    )?;
    writer.flush()?;
    writer.get_ref().sync_all()?;
    Ok(())
}

/// A framebuffer whose presented frames each replace the picture at one path.
pub struct Png {
    path: PathBuf,
    memory: Memory,
}

impl Png {
    /// Prepares frames of size `geometry` for `path`. Nothing is written before the first frame.
    ///
    /// # Errors
    /// The size is out of range, there is not enough memory, or `path` isn't a regular file.
    pub fn new(path: &Path, geometry: Geometry) -> Result<Png, FramebufferError> {
        replaceable(path)?;
        let memory = Memory::new(geometry)?;
        Ok(Png {
            path: path.to_owned(),
            memory,
        })
    }
}

impl Framebuffer for Png {
    fn geometry(&self) -> Geometry {
        self.memory.geometry()
    }

    fn target(&mut self) -> Target {
        self.memory.target()
    }

    fn present(&mut self) -> Result<(), FramebufferError> {
        write_png(&self.path, &self.memory.rgb())
    }

    fn keeps_contents(&self) -> bool {
        self.memory.keeps_contents()
    }

    fn describe(&self) -> String {
        format!("PNG picture {}, {}", self.path.display(), self.geometry())
    }
}

#[cfg(test)]
mod tests {
    use super::super::pattern;
    use super::*;
    use std::os::unix::fs::{FileTypeExt, symlink};

    fn names(folder: &Path) -> Vec<OsString> {
        let mut names: Vec<_> = fs::read_dir(folder)
            .unwrap()
            .map(|entry| entry.unwrap().file_name())
            .collect();
        names.sort();
        names
    }

    #[test]
    fn a_picture_survives_the_round_trip() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("frame.png");
        let mut png = Png::new(
            &path,
            Geometry {
                width: 101,
                height: 57,
            },
        )
        .unwrap();
        assert!(names(folder.path()).is_empty());
        for seed in 0..2 {
            pattern::paint(png.target(), seed);
            png.present().unwrap();
            let picture = image::open(&path).unwrap();
            assert_eq!(picture.color(), image::ColorType::Rgb8);
            let picture = picture.into_rgb8();
            assert_eq!(picture.dimensions(), (101, 57));
            pattern::assert_shows(&picture, seed);
        }
        assert_eq!(names(folder.path()), ["frame.png"]);
    }

    #[test]
    fn a_failed_write_leaves_the_old_picture_and_no_other_file() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("frame.png");
        fs::write(&path, "old").unwrap();
        // The encoder refuses a picture without pixels after the partial file was created.
        assert!(matches!(
            write_png(&path, &RgbImage::new(0, 0)),
            Err(FramebufferError::Png { .. })
        ));
        assert_eq!(fs::read(&path).unwrap(), b"old");
        assert_eq!(names(folder.path()), ["frame.png"]);
    }

    #[test]
    fn a_link_is_followed_and_kept() {
        let folder = tempfile::tempdir().unwrap();
        let (real, link) = (
            folder.path().join("real.png"),
            folder.path().join("link.png"),
        );
        fs::write(&real, "old").unwrap();
        symlink(&real, &link).unwrap();
        write_png(&link, &RgbImage::new(2, 2)).unwrap();
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        assert_eq!(image::open(&real).unwrap().into_rgb8().dimensions(), (2, 2));
    }

    #[test]
    fn a_link_to_nothing_is_an_error() {
        let folder = tempfile::tempdir().unwrap();
        let link = folder.path().join("link.png");
        symlink(folder.path().join("nothing.png"), &link).unwrap();
        let error = write_png(&link, &RgbImage::new(2, 2)).unwrap_err();
        assert!(error.to_string().contains("link.png"), "{error}");
        assert!(link.is_symlink());
    }

    #[test]
    fn devices_folders_and_missing_folders_are_errors() {
        let folder = tempfile::tempdir().unwrap();
        let picture = RgbImage::new(2, 2);
        let node = Path::new("/dev/null");
        assert!(matches!(
            write_png(node, &picture),
            Err(FramebufferError::Io { .. })
        ));
        assert!(fs::metadata(node).unwrap().file_type().is_char_device());
        assert!(matches!(
            write_png(folder.path(), &picture),
            Err(FramebufferError::Io { .. })
        ));
        let missing = folder.path().join("none/frame.png");
        let error = write_png(&missing, &picture).unwrap_err();
        assert!(error.to_string().contains("none/frame.png"), "{error}");
    }
}
