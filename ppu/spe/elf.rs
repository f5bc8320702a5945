//! Reads an SPU program's ELF image.
//!
//! Invariant: an image that [`check`] accepts is safe for libspe2, which trusts the offsets in it.

use std::ops::Range;

use object::read::elf::{ElfFile32, FileHeader as _, ProgramHeader as _, SectionHeader as _};
use object::{BigEndian, Object as _, ObjectSection as _, ObjectSymbol as _, SectionKind};

use super::error::ProgramError;
use protocol::formulation::Formulations;

const LOCAL_STORE: u64 = 0x40000;
/// The size of an entry in the table of shaders, and the name's offset: `spu/include/shader.inc`.
const ENTRY_SIZE: usize = 32;
const NAME: usize = 16;

/// Checks that everything its headers point to is in the image, and fits a local store.
pub(super) fn check(image: &[u8]) -> Result<(), ProgramError> {
    let file = parse(image)?;
    let machine = file.elf_header().e_machine(BigEndian);
    if machine != object::elf::EM_SPU {
        return Err(ProgramError::Machine(machine.0));
    }
    for header in file.elf_program_headers() {
        let outside = |()| ProgramError::Malformed("a segment is outside of the file".into());
        header.data(BigEndian, image).map_err(outside)?;
        let end = u64::from(header.p_vaddr(BigEndian)) + u64::from(header.p_memsz(BigEndian));
        if header.p_type(BigEndian) == object::elf::PT_LOAD && end > LOCAL_STORE {
            return Err(ProgramError::TooLarge(end));
        }
    }
    for section in file.elf_section_table().iter() {
        section.data(BigEndian, image).map_err(malformed)?;
    }
    Ok(())
}

/// The bytes that segments load to a range of load addresses, up to the last one's end there, in
/// whole quadwords. The range's end is a multiple of a quadword. A load address is the one in local
/// store, but for the code for cuts and the code for leaf blocks.
pub(super) fn loaded(image: &[u8], range: Range<u32>) -> Result<Vec<u8>, ProgramError> {
    let file = parse(image)?;
    let mut bytes = Vec::new();
    for header in file.elf_program_headers() {
        let start = header.p_paddr(BigEndian);
        let outside = |()| ProgramError::Malformed("a segment is outside of the file".into());
        let data = header.data(BigEndian, image).map_err(outside)?;
        let (low, high) = (start.max(range.start), range.end.min(start + data.len() as u32));
        if header.p_type(BigEndian) != object::elf::PT_LOAD || low >= high {
            continue;
        }
        let part = &data[(low - start) as usize..(high - start) as usize];
        let at = (low - range.start) as usize;
        let end = (at + part.len()).next_multiple_of(16);
        bytes.resize(bytes.len().max(end), 0);
        bytes[at..at + part.len()].copy_from_slice(part);
    }
    Ok(bytes)
}

/// The names in the table of shaders.
pub(super) fn shaders(image: &[u8]) -> Result<Vec<String>, ProgramError> {
    let file = parse(image)?;
    let table = file.section_by_name(".shaders");
    let table = table.ok_or(ProgramError::NoTable)?;
    let table = table.data().map_err(malformed)?;
    let entries = table.chunks(ENTRY_SIZE).enumerate();
    let names = entries.map(|(number, entry)| {
        let name = entry.get(NAME..ENTRY_SIZE).unwrap_or_default();
        let length = name.iter().position(|byte| *byte == 0);
        let (name, rest) = name.split_at(length.unwrap_or(name.len()));
        match std::str::from_utf8(name) {
            Ok(name) if !name.is_empty() && rest.iter().all(|byte| *byte == 0) => {
                Ok(name.to_owned())
            }
            _ => Err(ProgramError::Table(number)),
        }
    });
    names.collect()
}

pub(super) fn formulations(image: &[u8]) -> Result<Formulations, ProgramError> {
    let file = parse(image)?;
    let note = file.section_by_name(".formulation");
    let note = note.ok_or(ProgramError::NoFormulations)?;
    let note = note.data().map_err(malformed)?;
    let note = String::from_utf8_lossy(note);
    let names: Vec<&str> = note.split_terminator('\0').collect();
    let found = <[&str; 4]>::try_from(&names[..]).ok();
    let found = found.and_then(Formulations::named);
    found.ok_or_else(|| ProgramError::Formulations(names.join(", ")))
}

/// The ranges of its instructions in local store.
pub(super) fn code(image: &[u8]) -> Result<Vec<Range<u32>>, ProgramError> {
    let file = parse(image)?;
    let code = file.sections().filter(|section| section.kind() == SectionKind::Text);
    let range = |address: u64, size: u64| address as u32..address.saturating_add(size) as u32;
    Ok(code.map(|section| range(section.address(), section.size())).collect())
}

/// The nearest symbol at or before an address of its instructions, and the distance to it.
pub(super) fn name_of(image: &[u8], address: u32) -> Option<(String, u32)> {
    let file = parse(image).ok()?;
    let is_code = |index| {
        let section = file.section_by_index(index);
        section.is_ok_and(|section| section.kind() == SectionKind::Text)
    };
    let names = file.symbols().filter_map(|symbol| {
        let offset = u64::from(address).checked_sub(symbol.address())?;
        let name = symbol.name().ok().filter(|name| !name.is_empty())?;
        let is_code = symbol.section_index().is_some_and(is_code);
        is_code.then(|| (offset as u32, name.to_owned()))
    });
    let (offset, name) = names.min()?;
    Some((name, offset))
}

fn parse(image: &[u8]) -> Result<ElfFile32<'_, BigEndian>, ProgramError> {
    ElfFile32::parse(image).map_err(malformed)
}

fn malformed(error: object::Error) -> ProgramError {
    ProgramError::Malformed(error.to_string())
}

#[cfg(test)]
mod tests {
    use super::super::error::ProgramError;
    use super::super::program::Program;

    /// The tracer's image with the first `from` in it replaced.
    fn changed(from: &[u8], to: &[u8]) -> Vec<u8> {
        let mut image = Program::tracer().image().to_vec();
        let at = image.windows(from.len()).position(|found| found == from);
        let at = at.expect("it is in the image");
        image[at..at + to.len()].copy_from_slice(to);
        image
    }

    #[test]
    fn tracers_shaders_are_sorted_and_numbered() {
        let program = Program::from_image(Program::tracer().image()).expect("a program");
        assert_eq!(program.shaders().expect("a table"), ["checker", "depth", "portal", "sky"]);
        assert_eq!(program.shader("depth").expect("there"), 1);
        let error = program.shader("dept").expect_err("not there");
        assert_eq!(
            error.to_string(),
            "the SPU program has no shader dept; it has checker, depth, portal, sky"
        );
    }

    #[test]
    fn truncated_images_are_refused() {
        let image = Program::tracer().image();
        for length in (0..image.len()).step_by(97) {
            let error = Program::from_image(&image[..length]).expect_err("a part");
            assert!(matches!(error, ProgramError::Malformed(_)), "{length}: {error}");
        }
    }

    #[test]
    fn other_machines_and_addresses_beyond_the_local_store_are_refused() {
        let mut image = Program::tracer().image().to_vec();
        image[18..20].copy_from_slice(&21_u16.to_be_bytes());
        let error = Program::from_image(&image).expect_err("a PPE's");
        assert!(matches!(error, ProgramError::Machine(21)), "{error}");

        let mut image = Program::tracer().image().to_vec();
        let headers = u32::from_be_bytes(image[28..32].try_into().unwrap()) as usize;
        let (address, memory) = (headers + 8, headers + 20);
        image[address..address + 4].copy_from_slice(&0x3ff00_u32.to_be_bytes());
        image[memory..memory + 4].copy_from_slice(&0x200_u32.to_be_bytes());
        let error = Program::from_image(&image).expect_err("too far");
        assert!(matches!(error, ProgramError::TooLarge(0x40100)), "{error}");
        image[memory..memory + 4].copy_from_slice(&u32::MAX.to_be_bytes());
        let error = Program::from_image(&image).expect_err("too far");
        assert!(matches!(error, ProgramError::TooLarge(_)), "{error}");
    }

    /// Random bytes in the headers give a result or an error, and never a slice out of bounds.
    #[test]
    fn damaged_headers_are_handled() {
        let mut image = Program::tracer().image().to_vec();
        let sections = u32::from_be_bytes(image[32..36].try_into().unwrap()) as usize;
        let mut refused = 0;
        for at in (0..0x100).chain(sections..image.len()) {
            for value in [0, 0x7f, 0x80, 0xff] {
                let kept = std::mem::replace(&mut image[at], value);
                let checked = super::check(&image).and_then(|()| super::shaders(&image));
                refused += u32::from(checked.is_err());
                image[at] = kept;
            }
        }
        assert!(refused > 200, "only {refused} refused");
    }

    #[test]
    fn image_without_shader_table_is_an_error() {
        let program = Program::from_image(&changed(b".shaders\0", b".shadows\0"));
        let error = program.expect("a program").shaders().expect_err("no table");
        assert!(matches!(error, ProgramError::NoTable), "{error}");
        let program = Program::from_image(&changed(b"checker\0", b"\0hecker\0"));
        let error = program.expect("a program").shaders().expect_err("no name");
        assert!(matches!(error, ProgramError::Table(0)), "{error}");
    }

    #[test]
    fn missing_file_is_named() {
        let error = Program::from_file("no/such.elf".as_ref()).expect_err("none");
        assert!(error.to_string().starts_with("no/such.elf: "), "{error}");
    }
}
