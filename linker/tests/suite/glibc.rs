//! Programs that are linked against the stubs of the C library require nothing newer than glibc
//! 2.17, and run with the installed library.

use std::fs;
use std::path::Path;
use std::process::Command;

use object::Endianness;
use object::read::elf::{ElfFile64, FileHeader as _};
use spu_build::stub::glibc;

/// Functions that later versions of glibc have in another library, at another version, or that
/// they added.
const SOURCE: &str = "
#include <dlfcn.h>
#include <math.h>
#include <pthread.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static void *nothing(void *argument) { return argument; }

__attribute__((visibility(\"default\"))) long asks(double side)
{
    pthread_t thread;
    struct stat status;
    /* A function that is chosen for the processor when the program starts. */
    if (memcpy(&thread, &thread, sizeof thread) != &thread) return -4;
    if (pthread_create(&thread, 0, nothing, 0) != 0 || pthread_join(thread, 0) != 0) return -1;
    if (stat(\"/\", &status) != 0 || !S_ISDIR(status.st_mode)) return -2;
    if (dlsym(RTLD_DEFAULT, \"read\") == 0) return -3;
    return (long)hypot(side, 4 * side / 3);
}
";

const PROGRAM: &str = "
extern long asks(double side);
int main(void) { return (int)asks(3.0); }
";

/// Compiles with `cc`, without the compiler's built-in functions.
fn compile(options: &[&str], folder: &Path, name: &str, source: &str) {
    let file = folder.join(format!("{name}.c"));
    fs::write(&file, source).unwrap();
    let output = Command::new("cc")
        .current_dir(folder)
        .args(["-D_GNU_SOURCE", "-fno-builtin", "-o", name])
        .arg(&file)
        .args(options)
        .output()
        .unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}

/// The libraries and versions that a file requires, such as `libm.so.6 GLIBC_2.17`.
fn needs(path: &Path) -> Vec<String> {
    let data = fs::read(path).unwrap();
    let file = ElfFile64::<Endianness>::parse(&*data).unwrap();
    let endian = file.endian();
    let sections = file.elf_header().sections(endian, &*data).unwrap();
    let (mut needs, strings) = sections.gnu_verneed(endian, &*data).unwrap().unwrap();
    let strings = sections.strings(endian, &*data, strings).unwrap();
    let mut found = Vec::new();
    let text = |name: &[u8]| String::from_utf8_lossy(name).into_owned();
    while let Some((library, mut versions)) = needs.next().unwrap() {
        let library = text(library.file(endian, strings).unwrap());
        while let Some(version) = versions.next().unwrap() {
            let version = text(version.name(endian, strings).unwrap());
            found.push(format!("{library} {version}"));
        }
    }
    found
}

/// The part after `GLIBC_2.` of the versions that are newer than glibc 2.17.
fn too_new(needs: &[String]) -> Vec<&String> {
    let minor = |need: &str| need.split("GLIBC_2.").nth(1)?.split('.').next()?.parse().ok();
    let is_new = |need: &&String| minor(need).is_none_or(|minor: u32| minor > 17);
    needs.iter().filter(is_new).collect()
}

#[test]
fn program_linked_to_stubs_needs_no_newer_glibc() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let stub = folder.join("stub");
    fs::create_dir(&stub).unwrap();
    glibc::build(Path::new("cc"), &stub).unwrap();

    let here = format!("-L{}", stub.display());
    let libraries = ["-shared", "-fPIC", "-Wl,--no-undefined", "-Wl,--as-needed"];
    let links = [&libraries[..], &["-lpthread", "-ldl", "-lm", "-lc"]].concat();
    compile(&links, folder, "libnew.so", SOURCE);
    let with_stub = [&[here.as_str()], &links[..]].concat();
    compile(&with_stub, folder, "libold.so", SOURCE);

    // Linking against the installed library must require more, or this test would prove nothing.
    let new = needs(&folder.join("libnew.so"));
    assert!(!too_new(&new).is_empty(), "{new:?}");
    let old = needs(&folder.join("libold.so"));
    assert!(too_new(&old).is_empty(), "{old:?}");
    for library in ["libc.so.6", "libm.so.6", "libpthread.so.0", "libdl.so.2"] {
        assert!(old.iter().any(|need| need.starts_with(library)), "{old:?}");
    }

    compile(&["libold.so", "-Wl,-rpath,$ORIGIN"], folder, "program", PROGRAM);
    let status = Command::new(folder.join("program")).status().unwrap();
    assert_eq!(status.code(), Some(5));
}

#[test]
fn compiler_without_c_library_is_an_error() {
    let folder = tempfile::tempdir().unwrap();
    let compiler = folder.path().join("compiler");
    fs::write(&compiler, "#!/bin/sh\necho \"${1#-print-file-name=}\"\n").unwrap();
    use std::os::unix::fs::PermissionsExt as _;
    fs::set_permissions(&compiler, fs::Permissions::from_mode(0o755)).unwrap();
    let error = glibc::build(&compiler, folder.path()).unwrap_err();
    let text = error.to_string();
    assert!(text.contains("libc.so.6") && text.contains("compiler"), "{text}");
}
