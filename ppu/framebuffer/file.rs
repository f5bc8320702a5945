//! A regular file instead of /dev/fb0, for tests, emulators and machines without a screen.
//!
//! The file has the format of ps3fb's memory for the same geometry: bytes A, R, G, B, rows padded
//! to 64 bytes, no header. Programs that map or read the file see the frame while it is made, as
//! on the device.
//!
//! Invariant: every byte of the mapping has space on the disk, so writing can't fail for lack of
//! space. It can only fail if another program truncates the file.

use super::{Framebuffer, FramebufferError, Geometry, PIXEL_BYTES, PixelFormat, Target};
use memmap2::{MmapOptions, MmapRaw};
use std::fs::{self, OpenOptions};
use std::io;
use std::os::fd::AsRawFd;
use std::path::{Path, PathBuf};
use std::ptr::NonNull;

/// ps3fb rounds a row up to a multiple of this many bytes (firmware 1.90 and later).
const ROW_ALIGN: u32 = 64;

/// A mapped file with one frame.
pub struct File {
    path: PathBuf,
    file: fs::File,
    map: MmapRaw,
    geometry: Geometry,
    stride: u32,
}

impl File {
    /// Opens or creates the file at `path` for frames of `size`.
    ///
    /// # Errors
    /// - `size` is `None`, or out of range.
    /// - The file exists with a length that doesn't match `size`; it is not changed.
    /// - The file can't be created, extended or mapped.
    pub fn open(path: &Path, size: Option<Geometry>) -> Result<File, FramebufferError> {
        let geometry =
            size.ok_or_else(|| FramebufferError::SizeNeeded { path: path.to_owned() })?;
        geometry.check()?;
        let stride = (geometry.width * PIXEL_BYTES).next_multiple_of(ROW_ALIGN);
        let expected = u64::from(stride) * u64::from(geometry.height);
        let file = OpenOptions::new()
            .read(true)
            .write(true)
            .create(true)
            .truncate(false)
            .open(path)
            .map_err(|source| FramebufferError::io("open", path, source))?;
        let found = length(&file, path)?;
        if found != 0 && found != expected {
            return Err(FramebufferError::FileSize {
                path: path.to_owned(),
                found,
                expected,
                geometry,
            });
        }
        allocate(&file, expected)
            .map_err(|source| FramebufferError::io("allocate", path, source))?;
        let map = MmapOptions::new()
            .len(expected as usize)
            .map_raw(&file)
            .map_err(|source| FramebufferError::io("map", path, source))?;
        Ok(File { path: path.to_owned(), file, map, geometry, stride })
    }
}

fn length(file: &fs::File, path: &Path) -> Result<u64, FramebufferError> {
    let metadata =
        file.metadata().map_err(|source| FramebufferError::io("inspect", path, source))?;
    Ok(metadata.len())
}

/// Gives `file` this length with all blocks allocated. Without them, a store to a hole on a full
/// disk would kill the program; this call returns an error instead.
fn allocate(file: &fs::File, bytes: u64) -> io::Result<()> {
    let bytes = libc::off_t::try_from(bytes).map_err(io::Error::other)?;
    // SAFETY: the descriptor is open for as long as `file` is borrowed.
    match unsafe { libc::posix_fallocate(file.as_raw_fd(), 0, bytes) } {
        0 => Ok(()),
        error => Err(io::Error::from_raw_os_error(error)),
    }
}

impl Framebuffer for File {
    fn geometry(&self) -> Geometry {
        self.geometry
    }

    fn target(&mut self) -> Target {
        Target {
            base: NonNull::new(self.map.as_mut_ptr()).expect("a mapping is never at address zero"),
            bytes: self.map.len(),
            stride: self.stride,
            geometry: self.geometry,
            format: PixelFormat::ARGB,
        }
    }

    /// The frame is already in the file, visible to its readers. This only checks that the file
    /// still has its length for the next frame.
    fn present(&mut self) -> Result<(), FramebufferError> {
        let (found, expected) = (length(&self.file, &self.path)?, self.map.len() as u64);
        if found < expected {
            return Err(FramebufferError::FileSize {
                path: self.path.clone(),
                found,
                expected,
                geometry: self.geometry,
            });
        }
        Ok(())
    }

    /// While this program shows frames in the file, others only read it.
    fn keeps_contents(&self) -> bool {
        true
    }

    fn describe(&self) -> String {
        format!("file {}, {}, stride {} bytes", self.path.display(), self.geometry, self.stride)
    }
}

#[cfg(test)]
mod tests {
    use super::super::pattern;
    use super::*;
    use std::os::unix::fs::PermissionsExt;

    const ODD: Geometry = Geometry { width: 101, height: 57 };
    /// 101 pixels are 404 bytes, 448 when rounded up to 64.
    const ODD_STRIDE: usize = 448;

    #[test]
    fn new_file_has_driver_layout_and_pixels() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("fb0");
        let mut file = File::open(&path, Some(ODD)).unwrap();
        assert_eq!(fs::read(&path).unwrap(), vec![0; ODD_STRIDE * 57]);
        pattern::paint(file.target(), 3);
        file.present().unwrap();
        let bytes = fs::read(&path).unwrap();
        for y in 0..57 {
            for x in 0..101 {
                let [red, green, blue] = pattern::colour(x, y, 3);
                let at = y as usize * ODD_STRIDE + x as usize * 4;
                assert_eq!(bytes[at..at + 4], [0, red, green, blue], "pixel {x},{y}");
            }
        }
    }

    #[test]
    fn existing_frame_of_same_geometry_is_taken_over() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("fb0");
        fs::write(&path, vec![7; ODD_STRIDE * 57]).unwrap();
        drop(File::open(&path, Some(ODD)).unwrap());
        assert_eq!(fs::read(&path).unwrap(), vec![7; ODD_STRIDE * 57]);
    }

    #[test]
    fn every_stride_is_aligned_for_dma() {
        let folder = tempfile::tempdir().unwrap();
        for width in 1..=70 {
            let path = folder.path().join(width.to_string());
            pattern::paint(
                File::open(&path, Some(Geometry { width, height: 2 })).unwrap().target(),
                0,
            );
        }
    }

    #[test]
    fn file_of_another_geometry_is_refused_and_kept() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("fb0");
        fs::write(&path, "something else").unwrap();
        let text = File::open(&path, Some(ODD)).err().unwrap().to_string();
        assert!(
            text.contains("14 bytes") && text.contains("25536") && text.contains("101x57"),
            "{text}"
        );
        assert_eq!(fs::read(&path).unwrap(), b"something else");
    }

    #[test]
    fn file_cut_while_open_is_reported() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("fb0");
        let mut file = File::open(&path, Some(ODD)).unwrap();
        fs::write(&path, "").unwrap();
        assert!(matches!(file.present(), Err(FramebufferError::FileSize { found: 0, .. })));
    }

    #[test]
    fn missing_folders_and_folders_are_errors() {
        let folder = tempfile::tempdir().unwrap();
        for path in [folder.path().join("none/fb0"), folder.path().to_owned()] {
            let error = File::open(&path, Some(ODD)).err().unwrap();
            assert!(matches!(&error, FramebufferError::Io { action: "open", .. }), "{error}");
            assert!(error.to_string().contains(&path.display().to_string()));
        }
    }

    #[test]
    fn read_only_file_is_error() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("fb0");
        fs::write(&path, "").unwrap();
        fs::set_permissions(&path, fs::Permissions::from_mode(0o444)).unwrap();
        fs::set_permissions(folder.path(), fs::Permissions::from_mode(0o755)).unwrap();
        // The superuser may write to any file, so this thread opens it as user nobody.
        const NOBODY: libc::uid_t = 65534;
        // SAFETY: the call only changes the user that this thread's file accesses are checked for.
        let user = unsafe { libc::setfsuid(NOBODY) };
        let opened = File::open(&path, Some(ODD));
        // SAFETY: as above; this restores the user.
        unsafe { libc::setfsuid(user as libc::uid_t) };
        match opened.err().unwrap() {
            FramebufferError::Io { action: "open", source, .. } => {
                assert_eq!(source.kind(), io::ErrorKind::PermissionDenied);
            }
            other => panic!("{other}"),
        }
    }
}
