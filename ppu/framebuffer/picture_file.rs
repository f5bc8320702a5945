//! Writes frames as PNG or JPEG pictures.
//!
//! Invariant: the picture's path has either the previous file or a complete new picture. The new
//! one is written under another name in the same folder, synced to the disk, and then renamed.
//! Pipes and character devices have no previous picture, and are written to.

use super::{Framebuffer, FramebufferError, Geometry, Labels, Memory, Target};
use image::codecs::jpeg::JpegEncoder;
use image::{ExtendedColorType, ImageEncoder, ImageError, RgbImage};
use std::ffi::OsString;
use std::fs::{self, OpenOptions};
use std::io::{self, BufWriter, Write};
use std::os::unix::fs::FileTypeExt as _;
use std::path::{Path, PathBuf};
use std::process;
use std::sync::atomic::{AtomicU32, Ordering};

/// The quality of JPEG pictures, of 100: their compression is hardly visible in rendered pictures,
/// whose edges are sharper than those of photographs.
const JPEG_QUALITY: u8 = 95;

/// Writes `picture` to `path` with 8 bits a channel, and replaces an existing picture. The name's
/// extension decides between PNG and JPEG; without one it is PNG. A symbolic link is followed, a
/// pipe or a character device is written to, and `-` is standard output.
///
/// # Errors
/// - The extension is that of another format.
/// - `path` exists and is neither a regular file nor one that can be written to in order; it is not
///   changed.
/// - The picture can't be written; an existing one is not changed.
pub fn write_picture(path: &Path, picture: &RgbImage) -> Result<(), FramebufferError> {
    write_labelled(path, picture, &Labels::default())
}

/// The same with these labels in the file, if it is a PNG.
///
/// # Errors
/// As for [`write_picture`].
pub fn write_labelled(
    path: &Path,
    picture: &RgbImage,
    labels: &Labels,
) -> Result<(), FramebufferError> {
    let format = Format::of(path)?;
    let failed = |source| FramebufferError::Picture { path: path.to_owned(), source };
    match Place::of(path)? {
        Place::Output => {
            let mut bytes = Vec::new();
            format.encode(picture, labels, &mut bytes).map_err(failed)?;
            messages::write_data(bytes).map_err(|error| failed(error.into()))
        }
        Place::Direct => write_direct(path, format, picture, labels).map_err(failed),
        Place::File(place) => {
            let partial = partial_beside(&place)?;
            let written = write_whole(&partial, format, picture, labels).map_err(failed);
            let placed = written.and_then(|()| {
                fs::rename(&partial, &place)
                    .map_err(|source| FramebufferError::io("write the picture", &place, source))
            });
            if placed.is_err() {
                // The first error is the one to report. A partial file that can't be removed can
                // be recognized by its name.
                let _ = fs::remove_file(&partial);
            }
            placed
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Format {
    Png,
    Jpeg,
}

impl Format {
    /// The format that a name asks for.
    pub(super) fn of(path: &Path) -> Result<Self, FramebufferError> {
        let Some(extension) = path.extension() else {
            return Ok(Self::Png);
        };
        let known = [("png", Self::Png), ("jpg", Self::Jpeg), ("jpeg", Self::Jpeg)];
        let found = known.iter().find(|(name, _)| extension.eq_ignore_ascii_case(name));
        found
            .map(|&(_, format)| format)
            .ok_or_else(|| FramebufferError::PictureFormat { path: path.to_owned() })
    }

    fn encode(
        self,
        picture: &RgbImage,
        labels: &Labels,
        writer: impl Write,
    ) -> Result<(), ImageError> {
        let (width, height) = picture.dimensions();
        match self {
            Self::Png => encode_png(picture, labels, writer)
                .map_err(|error| ImageError::IoError(error.into())),
            Self::Jpeg => JpegEncoder::new_with_quality(writer, JPEG_QUALITY).write_image(
                picture.as_raw(),
                width,
                height,
                ExtendedColorType::Rgb8,
            ),
        }
    }
}

fn encode_png(
    picture: &RgbImage,
    labels: &Labels,
    writer: impl Write,
) -> Result<(), png::EncodingError> {
    let mut encoder = png::Encoder::new(writer, picture.width(), picture.height());
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_compression(png::Compression::Fast);
    encoder.set_filter(png::Filter::Adaptive);
    labels.add_to(&mut encoder)?;
    let mut writer = encoder.write_header()?;
    writer.write_image_data(picture.as_raw())?;
    writer.finish()
}

/// Where a picture goes.
enum Place {
    /// To standard output.
    Output,
    /// To a pipe or a character device, which renaming a file over it would destroy.
    Direct,
    /// To this file, whose links are resolved.
    File(PathBuf),
}

impl Place {
    fn of(path: &Path) -> Result<Self, FramebufferError> {
        if path == Path::new("-") {
            return Ok(Self::Output);
        }
        match fs::metadata(path) {
            Ok(metadata) if metadata.is_file() => fs::canonicalize(path)
                .map(Self::File)
                .map_err(|source| FramebufferError::io("follow", path, source)),
            Ok(metadata)
                if metadata.file_type().is_char_device() || metadata.file_type().is_fifo() =>
            {
                Ok(Self::Direct)
            }
            Ok(_) => Err(FramebufferError::io(
                "write",
                path,
                io::Error::other("it exists and is not a file, a pipe or a character device"),
            )),
            // Renaming would replace a dangling link instead of creating its target.
            Err(error) if error.kind() == io::ErrorKind::NotFound && path.is_symlink() => {
                Err(FramebufferError::io(
                    "write",
                    path,
                    io::Error::other("it is a link to a missing file"),
                ))
            }
            Err(error) if error.kind() == io::ErrorKind::NotFound => {
                let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
                match folder.filter(|folder| !folder.is_dir()) {
                    // Reported before a frame is traced in vain.
                    Some(folder) => {
                        let missing = format!("there is no folder {}", folder.display());
                        Err(FramebufferError::io("write", path, io::Error::other(missing)))
                    }
                    None => Ok(Self::File(path.to_owned())),
                }
            }
            Err(source) => Err(FramebufferError::io("inspect", path, source)),
        }
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
    hidden.push(format!(".{}-{}.partial", process::id(), SERIAL.fetch_add(1, Ordering::Relaxed)));
    Ok(place.with_file_name(hidden))
}

fn write_whole(
    partial: &Path,
    format: Format,
    picture: &RgbImage,
    labels: &Labels,
) -> Result<(), ImageError> {
    let file = OpenOptions::new().write(true).create_new(true).open(partial)?;
    let mut writer = BufWriter::new(file);
    format.encode(picture, labels, &mut writer)?;
    writer.flush()?;
    writer.get_ref().sync_all()?;
    Ok(())
}

fn write_direct(
    path: &Path,
    format: Format,
    picture: &RgbImage,
    labels: &Labels,
) -> Result<(), ImageError> {
    let mut writer = BufWriter::new(OpenOptions::new().write(true).open(path)?);
    format.encode(picture, labels, &mut writer)?;
    Ok(writer.flush()?)
}

/// A framebuffer whose presented frames each replace the picture at one path.
pub struct PictureFile {
    path: PathBuf,
    memory: Memory,
    labels: Labels,
}

impl PictureFile {
    /// Prepares frames of size `geometry` for `path`. Nothing is written before the first frame.
    ///
    /// # Errors
    /// The size is out of range, there is not enough memory, or no picture can be written to
    /// `path`; see [`write_picture`].
    pub fn new(path: &Path, geometry: Geometry) -> Result<PictureFile, FramebufferError> {
        Format::of(path)?;
        Place::of(path)?;
        let memory = Memory::new(geometry)?;
        Ok(PictureFile { path: path.to_owned(), memory, labels: Labels::default() })
    }

    /// The same with these labels in the file.
    #[must_use]
    pub fn labelled(self, labels: Labels) -> PictureFile {
        PictureFile { labels, ..self }
    }
}

impl Framebuffer for PictureFile {
    fn geometry(&self) -> Geometry {
        self.memory.geometry()
    }

    fn target(&mut self) -> Target {
        self.memory.target()
    }

    fn present(&mut self) -> Result<(), FramebufferError> {
        write_labelled(&self.path, &self.memory.rgb(), &self.labels)
    }

    fn keeps_contents(&self) -> bool {
        self.memory.keeps_contents()
    }

    fn describe(&self) -> String {
        format!("picture {}, {}", self.path.display(), self.geometry())
    }
}

#[cfg(test)]
mod tests {
    use super::super::pattern;
    use super::*;
    use std::os::unix::fs::symlink;

    fn names(folder: &Path) -> Vec<OsString> {
        let mut names: Vec<_> =
            fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name()).collect();
        names.sort();
        names
    }

    #[test]
    fn picture_round_trip_is_lossless() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("frame.png");
        let mut file = PictureFile::new(&path, Geometry { width: 101, height: 57 }).unwrap();
        assert!(names(folder.path()).is_empty());
        for seed in 0..2 {
            pattern::paint(file.target(), seed);
            file.present().unwrap();
            let picture = image::open(&path).unwrap();
            assert_eq!(picture.color(), image::ColorType::Rgb8);
            let picture = picture.into_rgb8();
            assert_eq!(picture.dimensions(), (101, 57));
            pattern::assert_shows(&picture, seed);
        }
        assert_eq!(names(folder.path()), ["frame.png"]);
    }

    #[test]
    fn labels_are_stored_without_pixel_changes() {
        let folder = tempfile::tempdir().unwrap();
        let [plain, labelled] = ["plain.png", "labelled.png"].map(|name| folder.path().join(name));
        let picture = RgbImage::from_fn(64, 32, |x, y| image::Rgb([x as u8 * 3, y as u8 * 7, 90]));
        write_picture(&plain, &picture).unwrap();
        let mut labels = Labels::default();
        labels.set("scene", "scenes/größe.nff");
        labels.set("contrast", 16);
        labels.set("contrast", 32);
        write_labelled(&labelled, &picture, &labels).unwrap();
        assert_eq!(image::open(&labelled).unwrap().into_rgb8(), picture);
        assert!(Labels::are_in(&labelled) && Labels::are_in(&plain));

        let file = fs::File::open(&labelled).unwrap();
        let reader = png::Decoder::new(io::BufReader::new(file)).read_info();
        let info = reader.unwrap().info().clone();
        let latin = info.uncompressed_latin1_text;
        let latin: Vec<_> = latin.iter().map(|text| (&*text.keyword, &*text.text)).collect();
        let version = concat!("cellray ", env!("CARGO_PKG_VERSION"));
        let expected = [("Software", version), ("cellray:contrast", "32")];
        assert_eq!(latin, expected);
        let scene = &info.utf8_text[0];
        assert_eq!(scene.keyword, "cellray:scene");
        assert_eq!(scene.get_text().unwrap(), "scenes/größe.nff");

        picture.save(&plain).unwrap();
        assert!(!Labels::are_in(&plain) && !Labels::are_in(&folder.path().join("none.png")));
    }

    #[test]
    fn failed_write_keeps_old_picture_only() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("frame.png");
        fs::write(&path, "old").unwrap();
        // The encoder refuses a picture without pixels after the partial file was created.
        assert!(matches!(
            write_picture(&path, &RgbImage::new(0, 0)),
            Err(FramebufferError::Picture { .. })
        ));
        assert_eq!(fs::read(&path).unwrap(), b"old");
        assert_eq!(names(folder.path()), ["frame.png"]);
    }

    #[test]
    fn link_is_followed_and_kept() {
        let folder = tempfile::tempdir().unwrap();
        let (real, link) = (folder.path().join("real.png"), folder.path().join("link.png"));
        fs::write(&real, "old").unwrap();
        symlink(&real, &link).unwrap();
        write_picture(&link, &RgbImage::new(2, 2)).unwrap();
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        assert_eq!(image::open(&real).unwrap().into_rgb8().dimensions(), (2, 2));
    }

    #[test]
    fn dangling_link_is_an_error() {
        let folder = tempfile::tempdir().unwrap();
        let link = folder.path().join("link.png");
        symlink(folder.path().join("nothing.png"), &link).unwrap();
        let error = write_picture(&link, &RgbImage::new(2, 2)).unwrap_err();
        assert!(error.to_string().contains("link.png"), "{error}");
        assert!(link.is_symlink());
    }

    #[test]
    fn extension_selects_format() {
        let folder = tempfile::tempdir().unwrap();
        let picture = RgbImage::from_fn(64, 32, |x, y| image::Rgb([x as u8 * 3, y as u8 * 7, 90]));
        for (name, format) in [
            ("a.png", image::ImageFormat::Png),
            ("a.PNG", image::ImageFormat::Png),
            ("a", image::ImageFormat::Png),
            ("a.jpg", image::ImageFormat::Jpeg),
            ("a.Jpeg", image::ImageFormat::Jpeg),
        ] {
            let path = folder.path().join(name);
            write_picture(&path, &picture).unwrap();
            let bytes = fs::read(&path).unwrap();
            assert_eq!(image::guess_format(&bytes).unwrap(), format, "{name}");
            let read = image::load_from_memory(&bytes).unwrap().into_rgb8();
            let off = |(a, b): (&u8, &u8)| a.abs_diff(*b);
            let worst = read.iter().zip(picture.iter()).map(off).max().unwrap();
            let most = u8::from(format == image::ImageFormat::Jpeg) * 12;
            assert!(worst <= most, "{name}: {worst}");
        }
        for name in ["a.gif", "a.png.bak", "a."] {
            let path = folder.path().join(name);
            let geometry = Geometry::new(8, 8).unwrap();
            for error in [
                write_picture(&path, &picture).unwrap_err(),
                PictureFile::new(&path, geometry).err().unwrap(),
            ] {
                let text = error.to_string();
                assert!(text.contains(name) && text.contains(".png, .jpg"), "{text}");
            }
            assert!(!path.exists(), "{name}");
        }
    }

    #[test]
    fn output_may_be_a_pipe() {
        let folder = tempfile::tempdir().unwrap();
        let pipe = folder.path().join("pipe.png");
        let name = std::ffi::CString::new(pipe.as_os_str().as_encoded_bytes()).unwrap();
        // SAFETY: the name is a string that ends with 0.
        assert_eq!(unsafe { libc::mkfifo(name.as_ptr(), 0o600) }, 0);
        let read = std::thread::spawn({
            let pipe = pipe.clone();
            move || fs::read(pipe).unwrap()
        });
        write_picture(&pipe, &RgbImage::new(3, 2)).unwrap();
        let picture = image::load_from_memory(&read.join().unwrap()).unwrap();
        assert_eq!((picture.width(), picture.height()), (3, 2));
        assert!(fs::metadata(&pipe).unwrap().file_type().is_fifo());
        assert_eq!(names(folder.path()), ["pipe.png"]);
    }

    #[test]
    fn character_device_is_written_and_kept() {
        let picture = RgbImage::new(2, 2);
        let node = Path::new("/dev/null");
        write_picture(node, &picture).unwrap();
        assert!(fs::metadata(node).unwrap().file_type().is_char_device());
        let full = Path::new("/dev/full");
        let error = write_picture(full, &picture).unwrap_err();
        assert!(error.to_string().contains("/dev/full"), "{error}");
    }

    #[test]
    fn folders_and_missing_folders_are_errors() {
        let folder = tempfile::tempdir().unwrap();
        let picture = RgbImage::new(2, 2);
        assert!(matches!(
            write_picture(folder.path(), &picture),
            Err(FramebufferError::Io { .. } | FramebufferError::PictureFormat { .. })
        ));
        let missing = folder.path().join("none/frame.png");
        let error = write_picture(&missing, &picture).unwrap_err();
        assert!(error.to_string().contains("none/frame.png"), "{error}");
    }
}
