//! Opening and loading programs.

use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::path::Path;
use std::ptr;

use spe2::image::{spe_image_close, spe_image_open, spe_program_load};
use spe2::types::SpeProgramHandle;

use spu_build::for_tests::build_instructions;

use crate::support::{Context, assert_fails, assert_null, open_image};

fn file(folder: &Path, contents: &[u8], mode: u32) -> std::path::PathBuf {
    let path = folder.join("image");
    fs::write(&path, contents).unwrap();
    fs::set_permissions(&path, fs::Permissions::from_mode(mode)).unwrap();
    path
}

#[test]
fn missing_or_invalid_files_are_not_opened() {
    let folder = tempfile::tempdir().unwrap();
    assert_null(open_image(&folder.path().join("missing")), libc::ENOENT);
    assert_null(unsafe { spe_image_open(ptr::null()) }, libc::EFAULT);
    assert_null(open_image(folder.path()), libc::EINVAL);
    let program = fs::read(build_instructions("stop 0x2000", folder.path())).unwrap();
    assert_null(open_image(&file(folder.path(), &program, 0o644)), libc::EACCES);
    for garbage in [&b""[..], b"#!/bin/sh\n", &program[..60], &[0xff; 5000]] {
        assert_null(open_image(&file(folder.path(), garbage, 0o755)), libc::EINVAL);
    }
    // Our own executable is an ELF file, but not for the SPU.
    let own = std::env::current_exe().unwrap();
    assert_null(open_image(&own), libc::EINVAL);
}

#[test]
fn opening_leaves_no_file_open() {
    let folder = tempfile::tempdir().unwrap();
    let path = build_instructions("stop 0x2000", folder.path());
    let links = || {
        fs::read_dir("/proc/self/fd")
            .unwrap()
            .filter_map(|entry| fs::read_link(entry.ok()?.path()).ok())
            .filter(|target| target == &path)
            .count()
    };
    let program = open_image(&path);
    assert!(!program.is_null());
    assert_eq!(links(), 0);
    assert_eq!(unsafe { spe_image_close(program) }, 0);
}

#[test]
fn null_programs() {
    let context = Context::new(0);
    unsafe {
        assert_fails(spe_image_close(ptr::null_mut()), libc::EINVAL);
        assert_fails(spe_program_load(context.pointer(), ptr::null_mut()), libc::EINVAL);
        let handle =
            open_image(&build_instructions("stop 0x2000", tempfile::tempdir().unwrap().path()));
        assert_fails(spe_program_load(ptr::null_mut(), handle), libc::ESRCH);
        assert_eq!(spe_image_close(handle), 0);
    }
}

#[test]
fn embedded_image_is_loaded_from_its_address() {
    let folder = tempfile::tempdir().unwrap();
    let mut program = fs::read(build_instructions("stop 0x2007", folder.path())).unwrap();
    let mut handle = SpeProgramHandle {
        handle_size: 24,
        elf_image: program.as_mut_ptr().cast(),
        toe_shadow: ptr::null_mut(),
    };
    let context = Context::new(0);
    assert_eq!(unsafe { spe_program_load(context.pointer(), &raw mut handle) }, 0);
    assert_eq!(context.run().code, 7);
    // One address where nothing is mapped, and one that holds something else.
    handle.elf_image = ptr::without_provenance_mut(16);
    assert_fails(unsafe { spe_program_load(context.pointer(), &raw mut handle) }, libc::EINVAL);
    let mut junk = [0x7f_u8; 64];
    handle.elf_image = junk.as_mut_ptr().cast();
    assert_fails(unsafe { spe_program_load(context.pointer(), &raw mut handle) }, libc::EINVAL);
}

#[test]
fn toe_contains_image_address() {
    let folder = tempfile::tempdir().unwrap();
    // The linker script has no place for it, so the linker puts it after the rest.
    let source = "
        stop    0x2000
        .section .toe,\"a\",@nobits
        .global _EAR_
_EAR_:  .space  16
";
    let path = build_instructions(source, folder.path());
    let handle = open_image(&path);
    assert!(!handle.is_null());
    let context = Context::new(0);
    assert_eq!(unsafe { spe_program_load(context.pointer(), handle) }, 0);
    let elf = fs::read(&path).unwrap();
    let toe = spu_emulator::elf::Image::parse(&elf).unwrap().toe().unwrap();
    let ea = unsafe { (*handle).elf_image }.expose_provenance() as u64;
    let mut expected = [0; 16];
    expected[..8].copy_from_slice(&ea.to_be_bytes());
    assert_eq!(context.local_store(toe, 16), expected);
    assert_eq!(unsafe { spe_image_close(handle) }, 0);
}
