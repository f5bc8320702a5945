//! Loading programs: the assembler's output, damaged images, random bytes.

use crate::prelude::*;
use proptest::prelude::*;
use spu_emulator::elf::{ElfError, Image, file_length};

const SOURCE: &str = "
        il      $3,1
here:   stop    0x2000
        .data
        .global table
table:  .long   0x11223344
        .section .bss,\"aw\",@nobits
        .global zeros
zeros:  .space  64
";

fn header_field(image: &[u8], offset: usize) -> usize {
    u32::from_be_bytes(image[offset..offset + 4].try_into().unwrap()) as usize
}

/// Offset of the first program header.
fn program_header(image: &[u8]) -> usize {
    header_field(image, 28)
}

#[test]
fn segments_are_copied_and_the_rest_is_cleared() {
    let bytes = assemble(SOURCE);
    let image = Image::parse(&bytes).unwrap();
    let store = LocalStore::new();
    store.write(0, &vec![0xee; SIZE as usize]);
    image.load(&store, 0);
    assert_eq!(image.symbol("_start"), Some(image.entry()));
    assert_eq!(store.load_word(image.symbol("table").unwrap()), 0x1122_3344);
    assert_eq!(store.load_word(image.entry() + 4), 0x2000);
    let last = image.segments().last().unwrap();
    let end = last.address + last.memory_size;
    if last.memory_size as usize > last.bytes.len() {
        assert_eq!(store.load_word(end - 4), 0);
    }
    assert_eq!(store.load_word(SIZE - 4), 0xeeee_eeee);
}

#[test]
fn memory_beyond_the_files_bytes_is_zero() {
    let mut bytes = assemble(SOURCE);
    // p_memsz of the first segment: 256 bytes more than the file has.
    let at = program_header(&bytes) + 20;
    let larger = header_field(&bytes, at) as u32 + 256;
    bytes[at..at + 4].copy_from_slice(&larger.to_be_bytes());
    let image = Image::parse(&bytes).unwrap();
    let store = LocalStore::new();
    store.write(0, &vec![0xee; SIZE as usize]);
    image.load(&store, 0);
    let first = &image.segments()[0];
    let mut tail = vec![1; first.memory_size as usize - first.bytes.len()];
    store.read(first.address + first.bytes.len() as u32, &mut tail);
    assert!(tail.len() >= 256 && tail.iter().all(|&byte| byte == 0));
}

#[test]
fn addresses_have_names() {
    let bytes = assemble(SOURCE);
    let image = Image::parse(&bytes).unwrap();
    let here = image.symbol("here").unwrap();
    assert_eq!(image.nearest_symbol(here), Some(("here", 0)));
    assert_eq!(image.nearest_symbol(here + 8), Some(("here", 8)));
    assert_eq!(image.symbol("nowhere"), None);
}

#[test]
fn invalid_spu_program_is_refused_with_reason() {
    let good = assemble(SOURCE);
    let with = |at: usize, byte: u8| {
        let mut bytes = good.clone();
        bytes[at] = byte;
        Image::parse(&bytes).unwrap_err()
    };
    assert_eq!(with(0, 0), ElfError::NotElf);
    assert_eq!(Image::parse(&[]).unwrap_err(), ElfError::NotElf);
    for (index, byte) in [(4, 2), (5, 1), (6, 2), (7, 3), (8, 1)] {
        assert!(matches!(
            with(index, byte),
            ElfError::Identification { index: at, .. } if at == index
        ));
    }
    assert_eq!(with(17, 1), ElfError::Type(1));
    assert_eq!(with(19, 21), ElfError::Machine(21));
    assert!(matches!(Image::parse(&good[..40]).unwrap_err(), ElfError::Malformed(_)));
    // A segment at the end of local store, and one that is larger than local store.
    let header = program_header(&good);
    assert!(matches!(with(header + 9, 4), ElfError::OutsideLocalStore { .. }));
    assert!(matches!(with(header + 20, 1), ElfError::OutsideLocalStore { .. }));
    // A segment that starts outside the file.
    assert!(matches!(with(header + 4, 0x7f), ElfError::Malformed(_)));
}

#[test]
fn an_overlay_is_left_to_the_program() {
    let mut bytes = assemble(SOURCE);
    let header = program_header(&bytes);
    let first: Vec<u8> = bytes[header..header + 32].to_vec();
    let count = Image::parse(&bytes).unwrap().segments().len();
    assert!(count >= 2, "the linker script gives data its own segment");
    // The second segment is at the place of the first.
    bytes[header + 32..header + 64].copy_from_slice(&first);
    assert_eq!(Image::parse(&bytes).unwrap().segments().len(), count - 1);
}

#[test]
fn other_ear_symbols_are_refused() {
    let refused = assemble(".global _EAR_other\n_EAR_other: stop 0\n");
    assert!(matches!(Image::parse(&refused).unwrap_err(), ElfError::UnsupportedToe(_)));
    let plain = assemble(".global _EAR_\n_EAR_: stop 0\n");
    Image::parse(&plain).unwrap();
}

#[test]
fn the_length_is_found_from_the_headers() {
    let bytes = assemble(SOURCE);
    let fetch = |offset: u64, into: &mut [u8]| {
        let from = bytes.get(offset as usize..);
        match from.and_then(|from| from.get(..into.len())) {
            Some(from) => {
                into.copy_from_slice(from);
                true
            }
            None => false,
        }
    };
    assert_eq!(file_length(fetch), Ok(bytes.len() as u64));
    assert!(file_length(|_, _| false).is_err());
}

/// A program with some bytes changed. Most of them remain near enough to ELF to pass the first
/// checks.
fn damaged() -> impl Strategy<Value = Vec<u8>> {
    let good = assemble(SOURCE);
    let changes = prop::collection::vec((0..good.len(), any::<u8>()), 1..8);
    changes.prop_map(move |changes| {
        let mut bytes = good.clone();
        for (at, byte) in changes {
            bytes[at] = byte;
        }
        bytes
    })
}

fn load_or_refuse(bytes: &[u8]) {
    if let Ok(image) = Image::parse(bytes) {
        image.load(&LocalStore::new(), 0);
        let _ = image.nearest_symbol(u32::MAX);
    }
    let _ = file_length(|offset, into| {
        let from = usize::try_from(offset).ok().and_then(|at| bytes.get(at..));
        from.and_then(|from| from.get(..into.len()))
            .map(|from| into.copy_from_slice(from))
            .is_some()
    });
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn damaged_programs_never_panic(bytes in damaged()) {
        load_or_refuse(&bytes);
    }

    #[test]
    fn random_bytes_never_panic(mut bytes in prop::collection::vec(any::<u8>(), 0..400), elf: bool) {
        if elf && bytes.len() >= 20 {
            bytes[..9].copy_from_slice(&[0x7f, b'E', b'L', b'F', 1, 2, 1, 0, 0]);
            bytes[16..20].copy_from_slice(&[0, 2, 0, 23]);
        }
        load_or_refuse(&bytes);
    }
}
