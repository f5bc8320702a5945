//! The tracer's images, which are stored with the sources, so that an SPU assembler is only needed
//! to change the SPU program.
//!
//! Invariant: an image is used only if the checksum of all its source code equals the one that is
//! stored next to it.

use std::fs;
use std::path::{Path, PathBuf};

use protocol::assembler;
use protocol::formulation::Formulations;

use crate::{Error, Image, Tools, file_error, tracer, write};

/// The file with the checksum of the sources.
const CHECKSUM: &str = "sources.crc32";

/// The folder of the images: `spu/images`.
#[must_use]
pub fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("spu/images")
}

/// The file name of the image with these formulations.
#[must_use]
pub fn file(formulations: &Formulations) -> String {
    format!("cellray-spu-{}.elf", formulations.name())
}

/// Builds the stored images into `folder`, without line tables, which would contain paths of this
/// machine. Object files go into `work`.
///
/// # Errors
///
/// Fails if a source can't be assembled, or if a file can't be read or written.
pub fn build(tools: &Tools, work: &Path, folder: &Path) -> Result<(), Error> {
    fs::create_dir_all(folder).map_err(|source| file_error(folder, source))?;
    let program = tracer()?.without_line_tables();
    let objects = program.assemble(tools, work)?;
    for formulations in Formulations::shipped() {
        let image = folder.join(file(&formulations));
        let program = program.clone().formulations(formulations);
        program.link(tools, work, &objects, &image)?;
    }
    write(&folder.join(CHECKSUM), &checksum(&program)?)
}

/// Returns the folder of the images if they were built from the present sources.
///
/// # Errors
///
/// Fails with [`Error::StaleImages`] if the sources have changed, and if a file can't be read.
pub fn find() -> Result<PathBuf, Error> {
    let folder = folder();
    let path = folder.join(CHECKSUM);
    let noted = fs::read_to_string(&path).map_err(|source| file_error(&path, source))?;
    if noted == checksum(&tracer()?)? { Ok(folder) } else { Err(Error::StaleImages(folder)) }
}

/// Adds a source without blank lines and the comments that have no effect on an image. The
/// scheduler reads the results in a header, and two marks after instructions.
fn add_code(text: &str, sum: &mut crc32fast::Hasher) {
    let steers = |comment: &str| {
        let marks = ["Out ", "may alias", "one pass"];
        comment.starts_with("           ") || marks.iter().any(|mark| comment.contains(mark))
    };
    let code = text.lines().map(|line| match line.split_once('#') {
        Some((code, comment)) if !steers(comment) => code,
        _ => line,
    });
    for line in code.map(str::trim_end).filter(|line| !line.is_empty()) {
        sum.update(line.as_bytes());
        sum.update(b"\n");
    }
}

/// The checksum of everything that a program is made of, in the format of the checksum file.
fn checksum(program: &Image) -> Result<String, Error> {
    let mut inputs = program.inputs()?;
    inputs.retain(|path| path.is_file());
    inputs.sort();
    let mut sum = crc32fast::Hasher::new();
    for path in &inputs {
        let name = path.file_name().unwrap_or_default();
        sum.update(name.as_encoded_bytes());
        let text = fs::read_to_string(path).map_err(|source| file_error(path, source))?;
        add_code(&text, &mut sum);
    }
    add_code(&assembler::constants(), &mut sum);
    for formulations in Formulations::shipped() {
        sum.update(formulations.name().as_bytes());
        for (role, kernel) in formulations.roles() {
            sum.update(role.as_bytes());
            sum.update(kernel.as_bytes());
        }
    }
    Ok(format!("{:08x}\n", sum.finalize()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sum_of(text: &str) -> u32 {
        let mut sum = crc32fast::Hasher::new();
        add_code(text, &mut sum);
        sum.finalize()
    }

    #[test]
    fn comments_change_checksum_only_if_scheduler_reads_them() {
        let code = sum_of("        ai $3,$3,1\n        bi $lr\n");
        assert_eq!(code, sum_of("# one more\n        ai $3,$3,1  # here\n\n        bi $lr\n"));
        assert_ne!(code, sum_of("        ai $3,$3,2\n        bi $lr\n"));
        let results = sum_of("#   Out     $3 the sum\n        ai $3,$3,1\n        bi $lr\n");
        assert_ne!(code, results);
    }

    #[test]
    fn images_match_checksum_of_sources() {
        let folder = find().unwrap();
        for formulations in Formulations::shipped() {
            let image = fs::read(folder.join(file(&formulations))).unwrap();
            assert!(image.starts_with(b"\x7fELF"));
        }
    }
}
