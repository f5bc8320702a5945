//! SPU programs: ELF images in this program's memory.

use std::ffi::c_void;
use std::ops::Range;
use std::path::Path;
use std::{fs, ptr};

use zerocopy::{FromBytes, FromZeros as _, Immutable, IntoBytes, KnownLayout};

use super::elf;
use super::error::ProgramError;
use super::sys::spe_program_handle_t;
use protocol::formulation::Formulations;

/// Bytes aligned as the MFC likes its transfers.
#[repr(C, align(128))]
pub struct Image<Bytes: ?Sized>(pub Bytes);

/// An SPU ELF image, as libspe2 takes it.
#[derive(Clone, Copy, Debug)]
pub struct Program {
    image: &'static [u8],
}

/// A piece of memory as the MFC likes it.
#[derive(Clone, FromBytes, IntoBytes, Immutable, KnownLayout)]
#[repr(C, align(128))]
struct Line([u8; 128]);

/// A program by the names of its formulations.
type Built = ([&'static str; 4], &'static Image<[u8]>);

/// The tracer's programs, the standard one first.
static TRACERS: &[Built] = &include!(concat!(env!("OUT_DIR"), "/images.rs"));

impl Program {
    /// The tracer's own program, which intersects by the standard formulations.
    #[must_use]
    pub fn tracer() -> Self {
        Self {
            image: &TRACERS[0].1.0,
        }
    }

    /// The tracer's own program that intersects by these formulations: one of
    /// [`Formulations::shipped`].
    pub fn of(formulations: &Formulations) -> Result<Self, ProgramError> {
        let names = formulations.names();
        let built = TRACERS.iter().find(|(built, _)| *built == names);
        match built {
            Some((_, image)) => Ok(Self { image: &image.0 }),
            None => Err(ProgramError::NotShipped {
                asked: formulations.name(),
                sphere: formulations.named_sphere().name,
                triangle: formulations.triangle.name,
                shipped: TRACERS.iter().map(|(names, _)| names.join("-")).collect(),
            }),
        }
    }

    /// The formulations by which it intersects.
    pub fn formulations(&self) -> Result<Formulations, ProgramError> {
        elf::formulations(self.image)
    }

    /// Another program: a complete SPU ELF file. libspe2 trusts the offsets in it.
    ///
    /// # Safety
    ///
    /// The image must be a whole, well-formed ELF file: no header in it may point outside of it.
    #[must_use]
    pub unsafe fn from_elf(image: &'static [u8]) -> Self {
        Self { image }
    }

    /// The program of an ELF image, which is checked. Its memory is kept to the end of the
    /// process, as SPUs may always still be running it.
    pub fn from_image(image: &[u8]) -> Result<Self, ProgramError> {
        let lines = image.len().div_ceil(size_of::<Line>());
        let mut memory = vec![Line::new_zeroed(); lines];
        memory.as_mut_slice().as_mut_bytes()[..image.len()].copy_from_slice(image);
        elf::check(&memory.as_slice().as_bytes()[..image.len()])?;
        let memory: &'static [Line] = memory.leak();
        Ok(Self {
            image: &memory.as_bytes()[..image.len()],
        })
    }

    /// The program of an ELF file, as [`Program::from_image`].
    pub fn from_file(path: &Path) -> Result<Self, ProgramError> {
        let image = fs::read(path).map_err(|source| ProgramError::File {
            path: path.to_path_buf(),
            source,
        })?;
        Self::from_image(&image)
    }

    /// The names of the shaders in it; a shader's number is its place here.
    pub fn shaders(&self) -> Result<Vec<String>, ProgramError> {
        elf::shaders(self.image)
    }

    /// The number of the shader of this name.
    pub fn shader(&self, name: &str) -> Result<u32, ProgramError> {
        let known = self.shaders()?;
        let number = known.iter().position(|known| known == name);
        number
            .map(|number| number as u32)
            .ok_or_else(|| ProgramError::NoShader {
                name: name.to_owned(),
                known,
            })
    }

    /// Where in local store its instructions lie; nowhere if it has no sections.
    pub(super) fn code(&self) -> Vec<Range<u32>> {
        elf::code(self.image).unwrap_or_default()
    }

    /// The place of one of its instructions as `name+0x10`, if it has names.
    #[must_use]
    pub fn name_of(&self, address: u32) -> Option<String> {
        let (name, behind) = elf::name_of(self.image, address)?;
        Some(match behind {
            0 => name,
            _ => format!("{name}+{behind:#x}"),
        })
    }

    /// The ELF file.
    #[must_use]
    pub fn image(&self) -> &'static [u8] {
        self.image
    }

    pub(super) fn handle(&self) -> spe_program_handle_t {
        spe_program_handle_t {
            handle_size: size_of::<spe_program_handle_t>() as u32,
            elf_image: self.image.as_ptr().cast::<c_void>(),
            toe_shadow: ptr::null(),
        }
    }
}
