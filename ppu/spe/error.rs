//! The errors of SPU programs.

use std::path::PathBuf;

/// Why an image is not a valid program, or lacks something.
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
    /// The bytes aren't a big-endian 32-bit ELF file, or it points outside of itself.
    #[error("not an SPU program: {0}")]
    Malformed(String),
    /// The ELF file is for another machine.
    #[error("not an SPU program: it is for the ELF machine {0}, but an SPU's is 23")]
    Machine(u16),
    /// A segment is loaded beyond the end of local store.
    #[error("not an SPU program: it is loaded up to {0:#x}, but the local store ends at 0x40000")]
    TooLarge(u64),
    /// The image has no section `.shaders`.
    #[error("the SPU program has no table of shaders: it must be linked with linker/spu.ld")]
    NoTable,
    /// The image does not name its formulations.
    #[error(
        "the SPU program does not name its formulations: it must be built with spu-build's `tracer`"
    )]
    NoFormulations,
    /// This program has no SPU program with these formulations.
    #[error(
        "no built-in SPU program intersects spheres by {sphere} and triangles by {triangle}; there are programs \
         for spheres by {}, all with triangles by {of_triangles}. Build one in cellray's repository: \
         `cargo run --release --bin kernels -- image --sphere {sphere} --triangle {triangle} --out {sphere}.elf`; \
         then select it with --program {sphere}.elf",
        .shipped.join(", ")
    )]
    NotShipped {
        /// The name of the formulation for spheres.
        sphere: &'static str,
        /// The name of the formulation for triangles.
        triangle: &'static str,
        /// The names of the built-in programs' formulations for spheres.
        shipped: Vec<&'static str>,
        /// The name of their formulation for triangles.
        of_triangles: &'static str,
    },
    /// The image names formulations that this program doesn't have.
    #[error(
        "the SPU program has the formulations {0}, which this version of cellray does not support: one of the two is too old"
    )]
    Formulations(String),
    /// An entry of the table of shaders is damaged.
    #[error("the SPU program's table of shaders is damaged at entry {0}")]
    Table(usize),
    /// The program has no shader with this name.
    #[error("the SPU program has no shader {name}; it has {}", .known.join(", "))]
    NoShader {
        /// The requested name.
        name: String,
        /// The names of the program's shaders.
        known: Vec<String>,
    },
}
