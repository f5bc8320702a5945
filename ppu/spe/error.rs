//! What can be wrong with an SPU program.

use std::path::PathBuf;

/// Why an image is no program, or has not what is looked for.
#[derive(Debug, thiserror::Error)]
pub enum ProgramError {
    /// A file can't be read.
    #[error("{}: {source}", path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// The system's error.
        source: std::io::Error,
    },
    /// The bytes are no ELF file of 32 bits, big-endian, or point outside of themselves.
    #[error("no SPU program: {0}")]
    Malformed(String),
    /// An ELF file for another machine.
    #[error("no SPU program: it is for the ELF machine {0}, and an SPU's is 23")]
    Machine(u16),
    /// Something is loaded beyond the local store.
    #[error("no SPU program: it is loaded up to {0:#x}, and the local store ends at 0x40000")]
    TooLarge(u64),
    /// There is no section `.shaders`.
    #[error("the SPU program has no table of shaders: it has to be linked by linker/spu.ld")]
    NoTable,
    /// It does not say by which formulations it intersects.
    #[error(
        "the SPU program does not name its formulations: it has to be built by spu-build's `tracer`"
    )]
    NoFormulations,
    /// There is no program of these formulations in this one.
    #[error(
        "no SPU program here intersects by {asked}, but by {}. The laboratory in cellray's repository builds it: \
         `cargo run --release --bin kernels -- image --sphere {sphere} --triangle {triangle} --out {sphere}.elf`; \
         then name it by --program {sphere}.elf",
        .shipped.join(", ")
    )]
    NotShipped {
        /// The names of all formulations that were asked for.
        asked: String,
        /// That of spheres.
        sphere: &'static str,
        /// That of triangles.
        triangle: &'static str,
        /// Those that there are programs of.
        shipped: Vec<String>,
    },
    /// It says so by names that are not known here.
    #[error(
        "the SPU program intersects by {0}, which this cellray does not know: one of them is too old"
    )]
    Formulations(String),
    /// The table of shaders is not made of entries.
    #[error("the SPU program's table of shaders is spoilt at entry {0}")]
    Table(usize),
    /// There is no shader of this name.
    #[error("the SPU program has no shader {name}; it has {}", .known.join(", "))]
    NoShader {
        /// The name.
        name: String,
        /// Those that there are.
        known: Vec<String>,
    },
}
