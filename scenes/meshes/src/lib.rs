//! Loads OBJ, PLY, STL and glTF files, and height maps, as scenes for Whitted's model.
//!
//! Owns the formats, how their materials become those of [`scenes::Material`], and the view and
//! lights of files that have none. Tracing a scene is not its concern. Invariant: a loaded mesh
//! has at least one triangle with an area, all of its vertices and materials exist, and all its
//! numbers are finite. If one of its materials has a texture, it has texture coordinates.

mod builder;
mod colours;
mod error;
mod foreign;
mod framing;
mod gltf;
mod heights;
mod likely;
mod mask;
pub mod mountains;
mod notes;
mod obj;
mod ply;
mod stl;
mod terrain;
mod text;
mod texture;

use std::fs::File;
use std::io::{ErrorKind, Read as _};
use std::path::Path;
use std::sync::Arc;

use scenes::Scene;

use builder::Builder;
pub use builder::{MAX_MATERIALS, MAX_TRIANGLES};
pub use error::{Error, Fault};
pub use gltf::Animation;
pub use texture::MAX_TEXELS;

/// The size in bytes of the largest file that is read.
const MAX_FILE: u64 = 1 << 31;
/// The bytes at a file's beginning that identify its format.
const BEGINNING: u64 = 4096;

/// How arrays of numpy begin.
const NPY_MARK: &[u8] = b"\x93NUMPY";

/// A scene, and notes for the user about how it was read.
#[derive(Debug, Clone, PartialEq)]
pub struct Loaded {
    /// The scene.
    pub scene: Scene,
    /// Whether the scene's only light is one that the file lacks: a sun over the left shoulder of
    /// who looks by the scene's view. A viewer may have it come with the eye.
    pub added_light: bool,
    /// The animation of the scene's mesh, if the file has one. The mesh has its form at the time 0.
    pub animation: Option<Animation>,
    /// What was left out, each with its file, and with its line if it is one.
    pub notes: Vec<String>,
}

/// Loads the scene that a user has named: a file that ends in `.obj`, `.ply`, `.stl`, `.gltf`
/// `.glb`, `.png`, `.hgt` or `.npy`, `terrain:LEVEL` or `mountains:LEVEL` for a generated one of
/// 2^LEVEL by 2^LEVEL squares, or anything that [`scenes::load`] accepts. A glTF file has its first
/// animation.
///
/// # Errors
/// There is no such file or generated scene, the file can't be read, or isn't of the format of its
/// name; any error of [`scenes::load`].
pub fn load(name: &Path) -> Result<Loaded, Error> {
    load_animated(name, None)
}

/// Loads a scene as [`load`] does, with one of its animations: by its name or its number from 0 on,
/// or `none`.
///
/// # Errors
/// As for [`load`], or the file has no such animation.
pub fn load_animated(name: &Path, animation: Option<&str>) -> Result<Loaded, Error> {
    let loaded = read(name, animation)?;
    let is_gltf = || matches!(Format::of(name), Ok(Some(Format::Gltf | Format::Glb)));
    match animation {
        Some(animation) if animation != gltf::NONE && !is_gltf() => {
            let fault = Fault::NoAnimation { name: animation.to_owned(), known: Vec::new() };
            Err(Error::of(&name.display().to_string(), fault))
        }
        _ => Ok(loaded),
    }
}

fn read(name: &Path, animation: Option<&str>) -> Result<Loaded, Error> {
    let file = name.display().to_string();
    let wrong = |fault| Error::of(&file, fault);
    if let Some(level) = file.strip_prefix(terrain::PREFIX) {
        let mut builder = Builder::default();
        let done = terrain::generate(level, &mut builder);
        return done.and_then(|()| builder.finish(&file)).map_err(wrong);
    }
    if let Some(level) = file.strip_prefix(mountains::PREFIX) {
        return mountains::generate(&file, level).map_err(wrong);
    }
    let found = name.symlink_metadata();
    if found.is_err_and(|error| error.kind() == ErrorKind::NotFound)
        && let Some(what) = likely::hint(name)
    {
        return Err(Error::Unknown { name: file, what });
    }
    let Some(format) = Format::of(name).map_err(wrong)? else {
        let mut scene = scenes::load(name)?;
        let mut notes = Vec::new();
        if let Some(map) = &scene.height_map {
            let (field, of_map) = heights::named(&scene, map)?;
            scene.heights = Some(Arc::new(field));
            notes = of_map;
        }
        return Ok(Loaded { scene, added_light: false, animation: None, notes });
    };
    let read = || -> Result<Loaded, Fault> {
        let bytes = bytes(name)?;
        let mut builder = Builder::default();
        match format {
            Format::Obj => obj::read(&bytes, name, &mut builder)?,
            Format::Ply => ply::read(&bytes, name, &mut builder)?,
            Format::Stl => stl::read(&bytes, &mut builder)?,
            Format::Glb => return gltf::read_binary(&bytes, name, animation),
            Format::Gltf => return gltf::read_text(&bytes, name, animation),
            Format::Heights(format) => return heights::read(&bytes, name, format),
        }
        builder.finish(&file)
    };
    read().map_err(wrong)
}

#[derive(Clone, Copy)]
enum Format {
    Obj,
    Ply,
    Stl,
    Glb,
    Gltf,
    Heights(heights::Format),
}

impl Format {
    /// The format of a file: the only one possible for its beginning, whatever its name is; then
    /// the one of its name; then the one possible without a name. `None` for a scene of [`nff`].
    fn of(name: &Path) -> Result<Option<Self>, Fault> {
        let (beginning, size) = beginning(name);
        let marked = Self::of_mark(&beginning, size);
        let named = Self::of_name(name);
        // glTF's JSON may have its mark anywhere.
        let is_json = beginning.trim_ascii_start().starts_with(b"{");
        let is_gltf = is_json && matches!(named, Some(Self::Gltf | Self::Glb));
        if marked.is_none() && !is_gltf {
            if let Some(foreign) = foreign::of_bytes(&beginning) {
                return Err(Fault::Foreign(foreign));
            }
            if named.is_none()
                && let Some(foreign) = foreign::of_name(name, &beginning)
            {
                return Err(Fault::Foreign(foreign));
            }
        }
        let gltf = is_gltf.then_some(Self::Gltf);
        let likely = || obj::is_likely(&beginning).then_some(Self::Obj);
        Ok(marked.or(gltf).or(named).or_else(likely))
    }

    fn of_mark(beginning: &[u8], size: u64) -> Option<Self> {
        let text = beginning.strip_prefix(b"\xef\xbb\xbf").unwrap_or(beginning);
        let text = text.trim_ascii_start();
        let has = |word: &[u8]| text.windows(word.len()).any(|part| part == word);
        if beginning.starts_with(b"glTF") {
            Some(Self::Glb)
        } else if beginning.starts_with(b"\x89PNG") {
            Some(Self::Heights(heights::Format::Png))
        } else if beginning.starts_with(NPY_MARK) {
            Some(Self::Heights(heights::Format::Npy))
        } else if text.starts_with(b"ply\n") || text.starts_with(b"ply\r") {
            Some(Self::Ply)
        } else if text.starts_with(b"solid") && has(b"facet") && has(b"vertex")
            || stl::is_binary(beginning, size)
        {
            Some(Self::Stl)
        } else if text.starts_with(b"{") && has(b"\"asset\"") {
            Some(Self::Gltf)
        } else {
            None
        }
    }

    fn of_name(name: &Path) -> Option<Self> {
        let ending = name.extension()?.to_str()?.to_ascii_lowercase();
        match ending.as_str() {
            "obj" => Some(Self::Obj),
            "ply" => Some(Self::Ply),
            "stl" => Some(Self::Stl),
            "gltf" => Some(Self::Gltf),
            "glb" | "vrm" => Some(Self::Glb),
            "png" => Some(Self::Heights(heights::Format::Png)),
            "hgt" => Some(Self::Heights(heights::Format::Hgt)),
            "npy" => Some(Self::Heights(heights::Format::Npy)),
            _ => None,
        }
    }
}

/// The first bytes of a file, and its size; none if it can't be read, or is no file that can be
/// read twice.
fn beginning(name: &Path) -> (Vec<u8>, u64) {
    let mut bytes = Vec::new();
    let size = name.metadata().ok().filter(|data| data.is_file());
    let size = size.map_or(0, |data| data.len());
    if size > 0
        && let Ok(file) = File::open(name)
    {
        // Whoever reads the file later reports that it can't be read.
        let _ = file.take(BEGINNING).read_to_end(&mut bytes);
    }
    (bytes, size)
}

/// Reads a file that is not too large.
fn bytes(name: &Path) -> Result<Vec<u8>, Fault> {
    let file = File::open(name)?;
    let size = file.metadata()?.len();
    if size > MAX_FILE {
        return Err(Fault::TooLarge { size });
    }
    let mut bytes = Vec::with_capacity(size as usize);
    // A device or a pipe has no size, and may have no end.
    file.take(MAX_FILE + 1).read_to_end(&mut bytes)?;
    match bytes.len() as u64 {
        size if size > MAX_FILE => Err(Fault::TooLarge { size }),
        _ => Ok(bytes),
    }
}
