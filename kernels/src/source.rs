//! The kernels' sources: which there are, and what their headers say.
//!
//! Invariant: every file below `spu/plain` is a kernel whose name is the file's and the header's.

/// A kernel's plain source, which is embedded.
#[derive(Clone, Copy, Debug)]
pub struct Source {
    /// The kernel.
    pub name: &'static str,
    /// The file, from the repository's root.
    pub file: &'static str,
    /// Its text.
    pub text: &'static str,
    /// Whether there is a scheduled version too.
    pub scheduled: bool,
}

/// All kernels, by path.
pub const SOURCES: &[Source] = &include!(concat!(env!("OUT_DIR"), "/sources.rs"));

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
    /// The kernel of this name.
    #[must_use]
    pub fn find(name: &str) -> Option<&'static Self> {
        SOURCES.iter().find(|source| source.name == name)
    }

    /// The file of the scheduled version, from the repository's root.
    #[must_use]
    pub fn scheduled_file(&self) -> String {
        self.file.replacen("spu/plain/", "spu/", 1)
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
