//! The kernels' sources and their headers.
//!
//! Invariant: every `.s` file in a folder of kernels is a kernel with the name of the file and of
//! the header.

use std::fs;
use std::path::{Path, PathBuf};

/// The folders of kernels: those for `cellray`'s programs, and those for the laboratory.
const FOLDERS: [&str; 7] = [
    "spu/build",
    "spu/isect",
    "lab/spu/isect",
    "lab/spu/math",
    "spu/shade",
    "spu/shaders",
    "spu/trace",
];

/// A kernel's hand-written source.
#[derive(Clone, Copy, Debug)]
pub struct Source {
    /// The kernel's name.
    pub name: &'static str,
    /// The file's path from the repository's root.
    pub file: &'static str,
    /// The file's text.
    pub text: &'static str,
}

/// The header of a kernel.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Header {
    /// What the kernel does, in one line.
    pub doc: String,
    /// Its C prototype.
    pub prototype: String,
    /// The error that the author states, with its unit and its domain. Empty if the kernel
    /// computes exactly.
    pub error: String,
}

impl Source {
    /// All kernels below a folder, which is the repository's root or has the same folders of
    /// kernels. They are in the order of the images: by the folder's own name, and then by their
    /// names. Their texts are kept until the process ends.
    pub fn all(root: &Path) -> Result<Vec<Self>, (PathBuf, std::io::Error)> {
        let mut sources = Vec::new();
        for kernels in FOLDERS {
            let folder = root.join(kernels);
            let entries = fs::read_dir(&folder).map_err(|error| (folder.clone(), error))?;
            for entry in entries {
                let path = entry.map_err(|error| (folder.clone(), error))?.path();
                if path.extension().is_some_and(|extension| extension == "s") {
                    let text = fs::read_to_string(&path).map_err(|error| (path.clone(), error))?;
                    let name = path.file_stem().unwrap_or_default().to_string_lossy();
                    sources.push(Self {
                        name: name.to_string().leak(),
                        file: format!("{kernels}/{name}.s").leak(),
                        text: text.leak(),
                    });
                }
            }
        }
        let parent = |source: &Self| Path::new(source.file).parent()?.file_name();
        sources.sort_by_key(|source| (parent(source).map(ToOwned::to_owned), source.name));
        Ok(sources)
    }

    /// Whether programs of `cellray` contain it.
    #[must_use]
    pub fn shipped(&self) -> bool {
        self.file.starts_with("spu/")
    }

    /// The header, or `None` if it does not have the project's format.
    #[must_use]
    pub fn header(&self) -> Option<Header> {
        let lines: Vec<&str> = self.text.lines().map_while(|line| line.strip_prefix('#')).collect();
        let doc = lines.first()?.trim_start().strip_prefix(self.name)?;
        let doc = doc.strip_prefix(' ')?.trim();
        Some(Header {
            doc: doc.to_owned(),
            prototype: entry(&lines, "C")?,
            error: entry(&lines, "Error").unwrap_or_default(),
        })
    }
}

impl Header {
    /// The first number of the stated error.
    #[must_use]
    pub fn stated_error(&self) -> Option<f64> {
        let mut words = self.error.split_whitespace();
        words.find_map(|word| word.parse().ok())
    }

    /// The number of words of `$3` in which the kernel returns something.
    #[must_use]
    pub fn returned_words(&self) -> usize {
        match self.prototype.split(' ').next() {
            Some("void") => 0,
            Some(kind) if kind.starts_with("vec_") => 4,
            _ => 1,
        }
    }
}

/// The text of a field, `C` or `Error`: its line and the following lines that are indented
/// further.
fn entry(lines: &[&str], key: &str) -> Option<String> {
    let prefix = format!("   {key} ");
    let at = lines.iter().position(|line| line.starts_with(&prefix))?;
    let first = lines[at][prefix.len()..].trim();
    let further = lines[at + 1..].iter().take_while(|line| line.starts_with("           "));
    let words: Vec<&str> = std::iter::once(first).chain(further.map(|line| line.trim())).collect();
    Some(words.join(" "))
}
