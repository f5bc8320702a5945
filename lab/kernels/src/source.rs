//! The kernels' sources: which there are, and what their headers say.
//!
//! Invariant: every `.s` file in a folder of kernels is a kernel whose name is the file's and the
//! header's.

use std::fs;
use std::path::{Path, PathBuf};

/// Where kernels are: those that programs of `cellray` have, and the laboratory's own.
const ROOMS: [&str; 6] = [
    "spu/isect",
    "lab/spu/isect",
    "lab/spu/math",
    "spu/shade",
    "spu/shaders",
    "spu/trace",
];

/// A kernel's source, as a person has written it.
#[derive(Clone, Copy, Debug)]
pub struct Source {
    /// The kernel.
    pub name: &'static str,
    /// The file, from the repository's root.
    pub file: &'static str,
    /// Its text.
    pub text: &'static str,
}

/// What a header says of its kernel.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Header {
    /// What the kernel does, in a line.
    pub doc: String,
    /// Its C prototype.
    pub prototype: String,
    /// The error that its author promises, with what it is counted in and the domain; empty if it
    /// computes exactly.
    pub error: String,
}

impl Source {
    /// All kernels below a folder that is the repository's root or has its kernels as they lie
    /// there. They are in the order in which the images have them: by the room's own name, then by
    /// theirs. Their texts are kept to the end of the process.
    pub fn all(root: &Path) -> Result<Vec<Self>, (PathBuf, std::io::Error)> {
        let mut sources = Vec::new();
        for room in ROOMS {
            let folder = root.join(room);
            let entries = fs::read_dir(&folder).map_err(|error| (folder.clone(), error))?;
            for entry in entries {
                let path = entry.map_err(|error| (folder.clone(), error))?.path();
                if path.extension().is_some_and(|extension| extension == "s") {
                    let text = fs::read_to_string(&path).map_err(|error| (path.clone(), error))?;
                    let name = path.file_stem().unwrap_or_default().to_string_lossy();
                    sources.push(Self {
                        name: name.to_string().leak(),
                        file: format!("{room}/{name}.s").leak(),
                        text: text.leak(),
                    });
                }
            }
        }
        let room = |source: &Self| Path::new(source.file).parent()?.file_name();
        sources.sort_by_key(|source| (room(source).map(ToOwned::to_owned), source.name));
        Ok(sources)
    }

    /// Whether programs of `cellray` have it, so that its schedule is in the repository.
    #[must_use]
    pub fn shipped(&self) -> bool {
        self.file.starts_with("spu/")
    }

    /// The file of the schedule in the repository, from its root; of a kernel that is shipped.
    #[must_use]
    pub fn scheduled_file(&self) -> Option<String> {
        let path = self.file.strip_prefix("spu/")?;
        Some(format!("spu/scheduled/{path}"))
    }

    /// The header; `None` if it has not the house's form.
    #[must_use]
    pub fn header(&self) -> Option<Header> {
        let lines: Vec<&str> = self
            .text
            .lines()
            .map_while(|line| line.strip_prefix('#'))
            .collect();
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
    /// The first number of the promised error.
    #[must_use]
    pub fn stated_error(&self) -> Option<f64> {
        let mut words = self.error.split_whitespace();
        words.find_map(|word| word.parse().ok())
    }

    /// Words of `$3` in which the kernel returns something.
    #[must_use]
    pub fn returned_words(&self) -> usize {
        match self.prototype.split(' ').next() {
            Some("void") => 0,
            Some(kind) if kind.starts_with("vec_") => 4,
            _ => 1,
        }
    }
}

/// The text behind a key, `C` or `Error`: its line, and those indented further.
fn entry(lines: &[&str], key: &str) -> Option<String> {
    let prefix = format!("   {key} ");
    let at = lines.iter().position(|line| line.starts_with(&prefix))?;
    let first = lines[at][prefix.len()..].trim();
    let further = lines[at + 1..]
        .iter()
        .take_while(|line| line.starts_with("           "));
    let words: Vec<&str> = std::iter::once(first)
        .chain(further.map(|line| line.trim()))
        .collect();
    Some(words.join(" "))
}
