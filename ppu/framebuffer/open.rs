//! Opens a framebuffer by its path: a device, or a file instead of one.

use super::device::Device;
use super::file::File;
use super::{Framebuffer, FramebufferError, Geometry, Options};
use std::fs;
use std::io;
use std::os::unix::fs::FileTypeExt;
use std::path::Path;

/// Opens the framebuffer at `path` with `size` and otherwise default options; see [`open_with`].
///
/// # Errors
/// As for [`open_with`].
pub fn open(path: &Path, size: Option<Geometry>) -> Result<Box<dyn Framebuffer>, FramebufferError> {
    open_with(path, Options { size, ..Options::default() })
}

/// Opens the framebuffer at `path`. A character device is opened with its driver. A regular file,
/// or a path that doesn't exist yet, is used as a file instead of a device.
///
/// # Errors
/// - The path is neither a character device nor a regular file.
/// - The device or the file can't be opened; see [`FramebufferError`].
pub fn open_with(path: &Path, options: Options) -> Result<Box<dyn Framebuffer>, FramebufferError> {
    let file = || -> Result<Box<dyn Framebuffer>, FramebufferError> {
        match options.raster {
            Some(raster) => Err(FramebufferError::NoVideoMode {
                path: path.to_owned(),
                raster,
                why: "it is a file".to_owned(),
            }),
            None => Ok(Box::new(File::open(path, options.size)?)),
        }
    };
    let kind = match fs::metadata(path) {
        Ok(metadata) => metadata.file_type(),
        Err(error) if error.kind() == io::ErrorKind::NotFound => {
            return file();
        }
        Err(source) => return Err(FramebufferError::io("inspect", path, source)),
    };
    if kind.is_char_device() {
        Ok(Box::new(Device::open(path, options)?))
    } else if kind.is_file() {
        file()
    } else {
        let kind = if kind.is_dir() {
            "a directory"
        } else if kind.is_block_device() {
            "a block device"
        } else if kind.is_fifo() {
            "a pipe"
        } else {
            "a socket"
        };
        Err(FramebufferError::NotAFramebuffer { path: path.to_owned(), kind })
    }
}

#[cfg(test)]
mod tests {
    use super::super::Raster;
    use super::*;
    use std::ffi::CString;
    use std::os::unix::ffi::OsStrExt;
    use std::os::unix::net::UnixListener;

    #[test]
    fn directory_pipe_or_socket_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let size = Some(Geometry { width: 4, height: 4 });
        let socket = folder.path().join("socket");
        let _listener = UnixListener::bind(&socket).unwrap();
        let pipe = folder.path().join("pipe");
        let name = CString::new(pipe.as_os_str().as_bytes()).unwrap();
        // SAFETY: the name is a zero-terminated string.
        assert_eq!(unsafe { libc::mkfifo(name.as_ptr(), 0o600) }, 0);
        let kinds = [(folder.path(), "a directory"), (&socket, "a socket"), (&pipe, "a pipe")];
        for (path, kind) in kinds {
            match open(path, size).err().unwrap() {
                FramebufferError::NotAFramebuffer { kind: found, .. } => assert_eq!(found, kind),
                other => panic!("{other}"),
            }
        }
    }

    #[test]
    fn character_device_without_framebuffer_requests_is_refused() {
        let error = open(Path::new("/dev/null"), None).err().unwrap();
        let text = error.to_string();
        assert!(text.contains("/dev/null") && text.contains("FBIOGET_VSCREENINFO"), "{text}");
    }

    #[test]
    fn absent_path_becomes_file() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("fb0");
        let size = Geometry { width: 101, height: 57 };
        assert_eq!(open(&path, Some(size)).unwrap().geometry(), size);
        assert_eq!(open(&path, Some(size)).unwrap().geometry(), size);
        assert!(matches!(open(&path, None).err().unwrap(), FramebufferError::SizeNeeded { .. }));
        let full = Options { size: Some(size), raster: Some(Raster::Full), ..Options::default() };
        let text = open_with(&path, full).err().unwrap().to_string();
        assert!(text.contains("full-screen") && text.contains("file"), "{text}");
    }
}
