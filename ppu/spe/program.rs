//! SPU programs: ELF images in this program's memory.

use std::fs;
use std::ops::Range;
use std::path::Path;

use zerocopy::{FromBytes, FromZeros as _, Immutable, IntoBytes, KnownLayout};

use super::elf;
use super::error::ProgramError;
use protocol::formulation::Formulations;
use protocol::layout::{
    BOX_CODE, BOX_CODE_CAPACITY, BUILD_CODE, BUILD_CODE_CAPACITY, COLOUR_CODE,
    COLOUR_CODE_CAPACITY, CUTS_CODE_CAPACITY, CUTS_CODE_LOAD, DEPTH_CODE, DEPTH_CODE_CAPACITY,
    EYE_CODE, EYE_CODE_CAPACITY, HEIGHT_CODE, HEIGHT_CODE_CAPACITY, MESH_CODE_CAPACITY,
    OBJECTS_CODE_LOAD, TEXTURE_CODE, TEXTURE_CODE_CAPACITY,
};

/// Bytes with the alignment for the fastest transfers.
#[repr(C, align(128))]
pub struct Image<Bytes: ?Sized>(pub Bytes);

/// An SPU program: an ELF image that libspe2 can load.
#[derive(Clone, Copy, Debug)]
pub struct Program {
    image: &'static [u8],
}

/// A line of memory, the unit of the fastest transfers.
#[derive(Clone, FromBytes, IntoBytes, Immutable, KnownLayout)]
#[repr(C, align(128))]
struct Line([u8; 128]);

/// The names of a program's formulations, and its image.
type Built = ([&'static str; 4], &'static Image<[u8]>);

/// The built-in programs, the standard one first.
static TRACERS: &[Built] = &include!(concat!(env!("OUT_DIR"), "/images.rs"));

impl Program {
    /// The tracer's program with the standard formulations.
    #[must_use]
    pub fn tracer() -> Self {
        Self { image: &TRACERS[0].1.0 }
    }

    /// The tracer's program with these formulations, which must be among
    /// [`Formulations::shipped`].
    ///
    /// # Errors
    /// There is no built-in program with these formulations.
    pub fn of(formulations: &Formulations) -> Result<Self, ProgramError> {
        let names = formulations.names();
        let built = TRACERS.iter().find(|(built, _)| *built == names);
        match built {
            Some((_, image)) => Ok(Self { image: &image.0 }),
            None => Err(ProgramError::NotShipped {
                sphere: formulations.named_sphere().name,
                triangle: formulations.triangle.name,
                shipped: Formulations::shipped().map(|of| of.named_sphere().name).to_vec(),
                of_triangles: Formulations::standard().triangle.name,
            }),
        }
    }

    /// The formulations of the program.
    ///
    /// # Errors
    /// The image does not name its formulations, or the names are unknown.
    pub fn formulations(&self) -> Result<Formulations, ProgramError> {
        elf::formulations(self.image)
    }

    /// A program of a complete SPU ELF file, without checking it. libspe2 trusts the offsets in
    /// it.
    ///
    /// # Safety
    ///
    /// The image must be a complete, well-formed ELF file. No header may point outside of it.
    #[must_use]
    pub unsafe fn from_elf(image: &'static [u8]) -> Self {
        Self { image }
    }

    /// Checks an ELF image, and makes a program of it. The copy of the image is never freed,
    /// because SPUs may still be running it.
    ///
    /// # Errors
    /// The image is not a valid SPU program.
    pub fn from_image(image: &[u8]) -> Result<Self, ProgramError> {
        let lines = image.len().div_ceil(size_of::<Line>());
        let mut memory = vec![Line::new_zeroed(); lines];
        memory.as_mut_slice().as_mut_bytes()[..image.len()].copy_from_slice(image);
        elf::check(&memory.as_slice().as_bytes()[..image.len()])?;
        let memory: &'static [Line] = memory.leak();
        Ok(Self { image: &memory.as_bytes()[..image.len()] })
    }

    /// Reads an ELF file; see [`Program::from_image`].
    ///
    /// # Errors
    /// The file can't be read, or is not a valid SPU program.
    pub fn from_file(path: &Path) -> Result<Self, ProgramError> {
        let image = fs::read(path)
            .map_err(|source| ProgramError::File { path: path.to_path_buf(), source })?;
        Self::from_image(&image)
    }

    /// The names of the program's shaders, in the order of their numbers.
    ///
    /// # Errors
    /// The image has no table of shaders, or a damaged one.
    pub fn shaders(&self) -> Result<Vec<String>, ProgramError> {
        elf::shaders(self.image)
    }

    /// The number of the shader with this name.
    ///
    /// # Errors
    /// The program has no shader with this name, or no valid table of shaders.
    pub fn shader(&self, name: &str) -> Result<u32, ProgramError> {
        let known = self.shaders()?;
        let number = known.iter().position(|known| known == name);
        number
            .map(|number| number as u32)
            .ok_or_else(|| ProgramError::NoShader { name: name.to_owned(), known })
    }

    /// The code that traces meshes in main memory, with its constants and variables: what is
    /// loaded from `EYE_CODE` on, in whole quadwords. It is empty if the program has none.
    #[must_use]
    pub fn mesh_code(&self) -> Vec<u8> {
        let addresses = EYE_CODE..EYE_CODE + EYE_CODE_CAPACITY + MESH_CODE_CAPACITY;
        elf::loaded(self.image, addresses).unwrap_or_default()
    }

    /// The code that looks up textures, in the same way: what is loaded from `TEXTURE_CODE` on.
    #[must_use]
    pub fn texture_code(&self) -> Vec<u8> {
        let addresses = TEXTURE_CODE..TEXTURE_CODE + TEXTURE_CODE_CAPACITY;
        elf::loaded(self.image, addresses).unwrap_or_default()
    }

    /// The code that interpolates colours of vertices, from `COLOUR_CODE` on, with zeros up to the
    /// end of its range. It is empty if the program has none.
    #[must_use]
    pub fn colour_code(&self) -> Vec<u8> {
        let addresses = COLOUR_CODE..COLOUR_CODE + COLOUR_CODE_CAPACITY;
        let mut code = elf::loaded(self.image, addresses).unwrap_or_default();
        if !code.is_empty() {
            code.resize(COLOUR_CODE_CAPACITY as usize, 0);
        }
        code
    }

    /// The code that makes triangles of height fields, in the same way, from `HEIGHT_CODE` on, and
    /// after it that for colours of vertices.
    #[must_use]
    pub fn height_code(&self) -> Vec<u8> {
        let addresses = HEIGHT_CODE..HEIGHT_CODE + HEIGHT_CODE_CAPACITY;
        let mut code = elf::loaded(self.image, addresses).unwrap_or_default();
        if !code.is_empty() {
            code.resize(HEIGHT_CODE_CAPACITY as usize, 0);
            code.extend(self.colour_code());
        }
        code
    }

    /// The code that finds height fields by cuts, in the same way.
    #[must_use]
    pub fn cuts_code(&self) -> Vec<u8> {
        let addresses = CUTS_CODE_LOAD..CUTS_CODE_LOAD + CUTS_CODE_CAPACITY;
        elf::loaded(self.image, addresses).unwrap_or_default()
    }

    /// The code that traces tiles with depth shading: what is loaded from `DEPTH_CODE` on.
    #[must_use]
    pub fn depth_code(&self) -> Vec<u8> {
        let addresses = DEPTH_CODE..DEPTH_CODE + DEPTH_CODE_CAPACITY;
        elf::loaded(self.image, addresses).unwrap_or_default()
    }

    /// The code that tests boxes, in the same way: what is loaded from `BOX_CODE` on.
    #[must_use]
    pub fn box_code(&self) -> Vec<u8> {
        let addresses = BOX_CODE..BOX_CODE + BOX_CODE_CAPACITY;
        elf::loaded(self.image, addresses).unwrap_or_default()
    }

    /// The code that refits and builds meshes: what is loaded from `BUILD_CODE` on, with the code
    /// for spheres and cones in place of that for boxes. It is empty if the program has none.
    #[must_use]
    pub fn build_code(&self) -> Vec<u8> {
        let loaded = |first: u32, bytes: u32| {
            elf::loaded(self.image, first..first + bytes).unwrap_or_default()
        };
        let mut code = loaded(BUILD_CODE, BUILD_CODE_CAPACITY);
        let objects = loaded(OBJECTS_CODE_LOAD, BOX_CODE_CAPACITY);
        let place = code.get_mut((BOX_CODE - BUILD_CODE) as usize..).unwrap_or_default();
        place.iter_mut().zip(objects).for_each(|(byte, own)| *byte = own);
        code
    }

    /// The ranges of its instructions in local store; empty if it has no sections.
    pub(super) fn code(&self) -> Vec<Range<u32>> {
        elf::code(self.image).unwrap_or_default()
    }

    /// The function of one of its instructions, as `name+0x10`; `None` if the program has no
    /// symbols.
    #[must_use]
    pub fn name_of(&self, address: u32) -> Option<String> {
        let (name, offset) = elf::name_of(self.image, address)?;
        Some(match offset {
            0 => name,
            _ => format!("{name}+{offset:#x}"),
        })
    }

    /// The bytes of the ELF file.
    #[must_use]
    pub fn image(&self) -> &'static [u8] {
        self.image
    }
}
