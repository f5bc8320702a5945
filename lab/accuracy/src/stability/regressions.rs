//! Inputs that were once the worst of their family. Every run tries them again.
//!
//! Each family has a file `regressions/<family>.json` with words in hexadecimal. The files in the
//! repository are compiled into the program.

use std::collections::BTreeMap;
use std::path::Path;

use serde::{Deserialize, Serialize};

use super::report::Report;
use crate::file::OutputError;
use crate::stability::prelude::*;

/// Saved inputs by family and subject.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Regressions {
    inputs: BTreeMap<(String, String), Vec<Vec<u32>>>,
}

/// Why saved inputs can't be read or written.
#[derive(Debug, Error)]
pub enum RegressionsError {
    /// A file has the wrong format.
    #[error("saved inputs of {family}: {error}")]
    Form {
        /// The family of the file.
        family: String,
        /// What is wrong.
        error: serde_json::Error,
    },
    /// A word is not a hexadecimal number of 32 bits.
    #[error("saved inputs of {family}: \"{word}\" is not a hexadecimal word")]
    Word {
        /// The family of the file.
        family: String,
        /// The word.
        word: String,
    },
    /// A file can't be written.
    #[error(transparent)]
    Write(#[from] OutputError),
}

impl RegressionsError {
    fn form(family: &str) -> impl FnOnce(serde_json::Error) -> Self {
        let family = family.to_owned();
        |error| Self::Form { family, error }
    }
}

/// The file of a family.
#[derive(Deserialize, Serialize)]
struct File {
    inputs: Vec<Input>,
}

#[derive(Deserialize, Serialize)]
struct Input {
    /// The subject that the cases test.
    subject: String,
    /// If the family has errors, the size of the error when the input was saved.
    worst: f64,
    /// The words of the case.
    words: String,
}

/// The files in the repository.
macro_rules! files {
    ($($family:literal)*) => {
        const FILES: &[(&str, &str)] = &[$((
            $family,
            include_str!(concat!("../../regressions/", $family, ".json")),
        )),*];
    };
}

files! {
    "estimate-borders"
    "extreme-words"
    "leave-cones"
    "leave-rectangles"
    "leave-spheres"
    "leave-streamed-cones"
    "leave-streamed-spheres"
    "leave-thin-cones"
    "leave-triangles"
    "mesh-far-out"
    "mesh-lattice"
    "mesh-lumpy"
    "mesh-thin"
    "mirror-chain"
    "refract-critical"
    "refract-grazing"
    "shadow-spheres"
    "shadow-triangles"
    "sphere-grazing"
    "sphere-nearest"
    "sphere-scales"
    "sphere-surface"
    "triangle-degenerate"
    "triangle-edges"
    "triangle-needles"
}

impl Regressions {
    /// The inputs in the repository.
    ///
    /// # Errors
    /// Fails if a file has the wrong format.
    pub fn kept() -> Result<Self, RegressionsError> {
        let mut kept = Self::default();
        for (family, text) in FILES {
            kept.add(family, text)?;
        }
        Ok(kept)
    }

    /// The inputs in one family's file.
    ///
    /// # Errors
    /// Fails if the file has the wrong format.
    pub fn of_file(family: &str, text: &str) -> Result<Self, RegressionsError> {
        let mut kept = Self::default();
        kept.add(family, text)?;
        Ok(kept)
    }

    /// Adds the inputs in a family's file.
    fn add(&mut self, family: &str, text: &str) -> Result<(), RegressionsError> {
        let file: File = serde_json::from_str(text).map_err(RegressionsError::form(family))?;
        for input in file.inputs {
            let words = input.words.split_whitespace().map(|word| {
                u32::from_str_radix(word, 16).map_err(|_| RegressionsError::Word {
                    family: family.to_owned(),
                    word: word.to_owned(),
                })
            });
            let words = words.collect::<Result<Vec<u32>, _>>()?;
            let key = (family.to_owned(), input.subject);
            self.inputs.entry(key).or_default().push(words);
        }
        Ok(())
    }

    /// The saved inputs of a family for a subject.
    pub fn of(&self, family: &str, subject: &str) -> impl Iterator<Item = &[u32]> {
        let key = (family.to_owned(), subject.to_owned());
        let inputs = self.inputs.get(&key).map_or(&[][..], Vec::as_slice);
        inputs.iter().map(Vec::as_slice)
    }
}

/// Writes the worst inputs in a report to one file for each family, replacing existing files.
///
/// # Errors
/// Fails if a file can't be written.
pub fn keep(report: &Report, folder: &Path) -> Result<(), RegressionsError> {
    let mut files: BTreeMap<&str, File> = BTreeMap::new();
    for row in report.rows.iter().filter(|row| !row.tally.input.is_empty()) {
        let file = files.entry(row.family).or_insert(File { inputs: Vec::new() });
        file.inputs.push(Input {
            subject: row.subject.clone(),
            worst: row.tally.worst,
            words: row.hex().join(" "),
        });
    }
    std::fs::create_dir_all(folder).map_err(OutputError::of(folder.display()))?;
    for (family, file) in files {
        let path = folder.join(format!("{family}.json"));
        let text = serde_json::to_string_pretty(&file).map_err(RegressionsError::form(family))?;
        std::fs::write(&path, text + "\n").map_err(OutputError::of(path.display()))?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn regression_file_lists_inputs_by_subject() {
        let text = r#"{"inputs": [
            {"subject": "a", "worst": 1.5, "words": "3f800000 00000001"},
            {"subject": "b", "worst": 0.0, "words": "ffffffff"}
        ]}"#;
        let kept = Regressions::of_file("family", text).expect("a good file");
        let of = |subject| kept.of("family", subject).collect::<Vec<_>>();
        assert_eq!(of("a"), [&[0x3f80_0000, 1][..]]);
        assert_eq!(of("b"), [&[u32::MAX][..]]);
        assert!(of("c").is_empty());
    }

    #[test]
    fn invalid_regression_file_is_rejected_with_reason() {
        let text = r#"{"inputs": [{"subject": "a", "worst": 1, "words": "3f80000g"}]}"#;
        let error = Regressions::of_file("family", text).expect_err("no hexadecimal word");
        assert!(error.to_string().contains("3f80000g"), "{error}");
        let error = Regressions::of_file("family", "[]").expect_err("no file");
        assert!(error.to_string().contains("family"), "{error}");
    }
}
