//! Material libraries of OBJ files.

use std::ffi::OsStr;
use std::fs;
use std::os::unix::ffi::OsStrExt as _;
use std::path::{Path, PathBuf};

use crate::Fault;
use crate::builder::Builder;
use crate::text::{Lines, first_word, number, shown, without_comment, without_mark, words};

/// Statements of pictures that are not drawn.
const OTHER_MAPS: [&[u8]; 20] = [
    b"map_ka",
    b"map_ks",
    b"map_ns",
    b"map_ke",
    b"map_refl",
    b"map_bump",
    b"bump",
    b"disp",
    b"decal",
    b"refl",
    b"norm",
    b"map_kn",
    b"map_pr",
    b"map_pm",
    b"map_ps",
    b"map_norm",
    b"map_disp",
    b"map_ao",
    b"map_rma",
    b"map_orm",
];
/// Statements without effect on a picture.
const WITHOUT_EFFECT: [&[u8]; 13] = [
    b"ka",
    b"tf",
    b"sharpness",
    b"km",
    b"pr",
    b"pm",
    b"ps",
    b"pc",
    b"pcr",
    b"aniso",
    b"anisor",
    b"map_aat",
    b"xr",
];

/// A material of a library, as the file has it.
#[derive(Clone, Debug, Default)]
pub(super) struct Definition {
    pub name: Vec<u8>,
    pub diffuse: Option<[f64; 3]>,
    pub specular: Option<[f64; 3]>,
    pub emission: Option<[f64; 3]>,
    pub shine: Option<f64>,
    pub dissolve: Option<f64>,
    /// `Tr`, which is one minus `d` where there is no `d`.
    pub transparency: Option<f64>,
    pub index: Option<f64>,
    pub illumination: Option<f64>,
    pub diffuse_map: Option<Map>,
    pub dissolve_map: Option<Map>,
}

/// A picture that a material names.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) struct Map {
    /// The picture's path; it need not exist.
    pub path: PathBuf,
    pub clamps: bool,
}

/// The libraries that an OBJ file names.
pub(super) struct Libraries {
    folder: PathBuf,
    loaded: Vec<PathBuf>,
    pub definitions: Vec<Definition>,
}

impl Libraries {
    pub fn new(file: &Path) -> Self {
        Self {
            folder: file.parent().unwrap_or(Path::new("")).to_owned(),
            loaded: Vec::new(),
            definitions: Vec::new(),
        }
    }

    /// The material with a name. If nothing else fits, names are the same that differ in the case
    /// of letters, or in comments after them: names may have the sign of a comment themselves.
    pub fn find(&self, name: &[u8]) -> Option<&Definition> {
        let bare = |name: &[u8]| without_comment(name).trim_ascii_end().to_ascii_lowercase();
        let find = |is_it: &dyn Fn(&[u8]) -> bool| {
            let mut all = self.definitions.iter();
            all.find(|material| is_it(&material.name))
        };
        find(&|known| known == name)
            .or_else(|| find(&|known| known.eq_ignore_ascii_case(name)))
            .or_else(|| find(&|known| bare(known) == bare(name)))
    }

    /// `mtllib`: one name that may have blanks, or several names.
    pub fn load(
        &mut self,
        line: usize,
        names: &[u8],
        file: &str,
        builder: &mut Builder,
    ) -> Result<(), Fault> {
        let mut rest = names.trim_ascii();
        if rest.is_empty() {
            builder.notes.line(file, line, "mtllib", "mtllib without a name");
        }
        while !rest.is_empty() {
            // The longest part that is a file; if none is, the first word.
            let ends = (1..=rest.len()).rev().filter(|&end| {
                end == rest.len()
                    || (rest[end].is_ascii_whitespace() && !rest[end - 1].is_ascii_whitespace())
            });
            let mut ends =
                ends.filter_map(|end| Some((end, existing(&self.folder, &rest[..end])?)));
            let (end, path) = ends.next().unwrap_or_else(|| {
                let word = words(rest).next().unwrap_or(rest);
                let end = if rest.windows(5).any(is_mtl) { word.len() } else { rest.len() };
                (end, joined(&self.folder, &rest[..end]))
            });
            self.library(&path, builder)?;
            rest = rest[end..].trim_ascii_start();
            if rest.starts_with(b"#") {
                break;
            }
        }
        Ok(())
    }

    fn library(&mut self, path: &Path, builder: &mut Builder) -> Result<(), Fault> {
        if self.loaded.iter().any(|loaded| loaded == path) {
            return Ok(());
        }
        self.loaded.push(path.to_owned());
        let file = path.display().to_string();
        match crate::bytes(path) {
            Ok(bytes) => self.read(&bytes, path, &file, builder),
            Err(Fault::Io(error)) => {
                let note = format!("{file}: {error}; its materials are grey instead");
                builder.notes.add(note);
                Ok(())
            }
            Err(fault) => Err(Fault::Library { file, fault: Box::new(fault) }),
        }
    }

    fn read(
        &mut self,
        bytes: &[u8],
        path: &Path,
        file: &str,
        builder: &mut Builder,
    ) -> Result<(), Fault> {
        let text = without_mark(bytes).map_err(|encoding| Fault::Library {
            file: file.to_owned(),
            fault: Box::new(Fault::Encoding(encoding)),
        })?;
        let folder = path.parent().unwrap_or(Path::new(""));
        let mut current: Option<Definition> = None;
        for (line, text) in Lines::new(text) {
            let (word, rest) = first_word(&text);
            if word.is_empty() || word.starts_with(b"#") {
                continue;
            }
            let mut note = |kind: &str, text: String| builder.notes.line(file, line, kind, &text);
            let word = word.to_ascii_lowercase();
            if word == b"newmtl" {
                let name = rest.trim_ascii().to_vec();
                if name.is_empty() {
                    note("newmtl", "newmtl without a name".into());
                }
                self.definitions.extend(current.take());
                current = Some(Definition { name, ..Definition::default() });
                continue;
            }
            let Some(material) = &mut current else {
                let text = format!("{} before the first newmtl is ignored", shown(&word));
                note("before", text);
                continue;
            };
            let numbers = without_comment(rest);
            match word.as_slice() {
                b"kd" => set_colour(&mut material.diffuse, "Kd", numbers, &mut note),
                b"ks" => set_colour(&mut material.specular, "Ks", numbers, &mut note),
                b"ke" => set_colour(&mut material.emission, "Ke", numbers, &mut note),
                b"ns" => set_number(&mut material.shine, "Ns", numbers, &mut note),
                b"ni" => set_number(&mut material.index, "Ni", numbers, &mut note),
                b"tr" => set_number(&mut material.transparency, "Tr", numbers, &mut note),
                b"illum" => set_number(&mut material.illumination, "illum", numbers, &mut note),
                b"d" => {
                    let numbers = numbers.trim_ascii_start();
                    let value = numbers.strip_prefix(b"-halo").unwrap_or(numbers);
                    set_number(&mut material.dissolve, "d", value, &mut note);
                }
                b"map_kd" => set_map(&mut material.diffuse_map, "map_Kd", rest, folder, &mut note),
                b"map_d" | b"map_tr" | b"map_opacity" => {
                    set_map(&mut material.dissolve_map, "map_d", rest, folder, &mut note);
                }
                other if OTHER_MAPS.contains(&other) => {
                    let text = "textures other than those of diffuse colours are ignored";
                    note("map", text.into());
                }
                other if WITHOUT_EFFECT.contains(&other) => {}
                other => {
                    let text = format!("unknown statement {}, which is ignored", shown(other));
                    note("unknown", text);
                }
            }
        }
        self.definitions.extend(current);
        Ok(())
    }
}

/// Whether five bytes are the end of a library's name, and what comes after it.
fn is_mtl(bytes: &[u8]) -> bool {
    bytes[..4].eq_ignore_ascii_case(b".mtl") && bytes[4].is_ascii_whitespace()
}

/// Sets a colour; one number stands for three.
fn set_colour(
    colour: &mut Option<[f64; 3]>,
    word: &str,
    text: &[u8],
    note: &mut impl FnMut(&str, String),
) {
    let found: Option<Vec<f64>> = words(text).take(3).map(number).collect();
    match found.as_deref() {
        Some(&[all]) => *colour = Some([all; 3]),
        Some(&[red, green, blue]) => *colour = Some([red, green, blue]),
        _ => note(
            word,
            format!("{word} needs one number or three, not {}; it is ignored", shown(text)),
        ),
    }
}

fn set_number(
    value: &mut Option<f64>,
    word: &str,
    text: &[u8],
    note: &mut impl FnMut(&str, String),
) {
    match words(text).next().and_then(number) {
        Some(number) => *value = Some(number),
        None => note(word, format!("{word} needs a number, not {}; it is ignored", shown(text))),
    }
}

fn set_map(
    map: &mut Option<Map>,
    word: &str,
    text: &[u8],
    folder: &Path,
    note: &mut impl FnMut(&str, String),
) {
    let (options, name) = split(text);
    if name.is_empty() {
        note(word, format!("{word} without the name of a picture"));
        return;
    }
    let clamps = options.as_slice() == [(&b"-clamp"[..], &b"on"[..])];
    if !options.is_empty() && !clamps {
        let text = "options of textures other than -clamp are ignored";
        note("options", text.into());
    }
    let bare = without_comment(name).trim_ascii_end();
    let found = existing(folder, name).or_else(|| existing(folder, bare));
    // A path of another computer.
    let last = name.rsplit(|byte| matches!(byte, b'/' | b'\\')).next();
    let found = found.or_else(|| existing(folder, last.unwrap_or(name)));
    *map = Some(Map { path: found.unwrap_or_else(|| joined(folder, name)), clamps });
}

fn without_quotes(name: &[u8]) -> &[u8] {
    let inner = name.strip_prefix(b"\"").and_then(|it| it.strip_suffix(b"\""));
    inner.unwrap_or(name)
}

/// An option of a texture, and its first value.
type MapOption<'a> = (&'a [u8], &'a [u8]);

/// The options of a texture, and the name of its picture.
fn split(text: &[u8]) -> (Vec<MapOption<'_>>, &[u8]) {
    let mut options = Vec::new();
    let mut rest = text.trim_ascii();
    while rest.starts_with(b"-") {
        let (option, after) = first_word(rest);
        let most = match option {
            b"-o" | b"-s" | b"-t" => 3,
            b"-mm" => 2,
            b"-blendu" | b"-blendv" | b"-cc" | b"-clamp" | b"-texres" | b"-bm" | b"-boost"
            | b"-imfchan" | b"-type" => 1,
            // The name of a picture that begins with a dash.
            _ => break,
        };
        rest = after;
        let mut first = None;
        for value in 0..most {
            let (word, after) = first_word(rest);
            // The second and third number may be missing.
            if value > 0 && number(word).is_none() {
                break;
            }
            first.get_or_insert(word);
            rest = after;
        }
        options.push((option, first.unwrap_or_default()));
    }
    (options, rest.trim_ascii())
}

/// The path of a name in a folder. Windows' backslashes separate folders, too.
fn joined(folder: &Path, name: &[u8]) -> PathBuf {
    let name = without_quotes(name);
    let slashes: Vec<u8> = name.iter().map(|&it| if it == b'\\' { b'/' } else { it }).collect();
    folder.join(OsStr::from_bytes(&slashes))
}

/// The file that a name means in a folder, if there is one: with the name itself, or with one that
/// differs in the case of letters, or in the encoding of other letters.
fn existing(folder: &Path, name: &[u8]) -> Option<PathBuf> {
    let name = without_quotes(name);
    for path in [folder.join(OsStr::from_bytes(name)), joined(folder, name)] {
        if path.is_file() {
            return Some(path);
        }
    }
    let path = joined(folder, name);
    let latin: String = name.iter().map(|&byte| char::from(byte)).collect();
    let latin = joined(folder, latin.as_bytes());
    if latin.is_file() {
        return Some(latin);
    }
    let wanted = path.file_name()?.as_bytes();
    let parent = path.parent().filter(|it| !it.as_os_str().is_empty());
    let mut alike: Vec<PathBuf> = fs::read_dir(parent.unwrap_or(Path::new(".")))
        .ok()?
        .filter_map(|entry| Some(entry.ok()?.path()))
        .filter(|it| {
            let other = it.file_name().unwrap_or_default().as_bytes();
            other.eq_ignore_ascii_case(wanted) && it.is_file()
        })
        .collect();
    alike.sort();
    alike.into_iter().next()
}
