//! Stubs of an older version of the C library, to link against where a newer one is installed.
//!
//! A linker binds a function to its newest version in the library that it finds, and the program
//! then needs that version wherever it runs. The installed library still contains the older
//! versions, for programs that were linked long ago. The stubs made here have each function at its
//! newest version that is old enough, in the library that contained it at that time, and no newer
//! functions. `start.c` and `status.c` have those functions of which each program contained a copy
//! at that time, and which are now in the library.

use std::collections::BTreeMap;
use std::ffi::OsString;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use object::elf::FileHeader64;
use object::read::elf::{ElfFile64, FileHeader as _};
use object::{Endianness, Object as _, ObjectSymbol, ObjectSymbolTable as _, SymbolKind};

use super::share;
use crate::{Error, file_error, output, run, write};

/// The newest versions that a program may require: those of the oldest glibc that Rust's standard
/// library supports, and of the GCC of that time.
const NEWEST: [(&str, &[u32]); 2] = [("GLIBC", &[2, 17]), ("GCC", &[4, 8])];

/// The soname of the main library.
const LIBC: &str = "libc.so.6";
/// Each library's soname, and the prefixes of the names that it contained before they moved to the
/// main library.
const LIBRARIES: [(&str, &[&str]); 8] = [
    (LIBC, &[]),
    ("libm.so.6", &[]),
    ("libpthread.so.0", &["pthread_", "sem_"]),
    ("libdl.so.2", &["dl"]),
    ("librt.so.1", &["aio_", "lio_", "mq_", "shm_", "timer_"]),
    ("libutil.so.1", &["forkpty", "log", "openpty"]),
    (LIBGCC, &[]),
    (LOADER, &[]),
];
const LIBGCC: &str = "libgcc_s.so.1";
const LOADER: &str = "ld64.so.1";

/// The function that calls a program's `main`. `start.c` contains a function of this name, which
/// calls this one.
const START: &str = "__libc_start_main";
/// The functions that a program contains copies of. Each is linked only where it is called.
const COPIES: [(&str, &str); 2] =
    [("start", include_str!("start.c")), ("status", include_str!("status.c"))];

/// A name in a library with its newest version that is old enough.
struct Name {
    version: String,
    /// The size in bytes, unless it is a function.
    bytes: Option<u64>,
    /// Whether there is also a newer version.
    renewed: bool,
}

type Names = BTreeMap<String, Name>;

/// Makes stubs in `folder` for the libraries that the target's `compiler` links to. A linker that
/// searches this folder first uses the stubs.
pub fn build(compiler: &Path, folder: &Path) -> Result<(), Error> {
    let mut stubs = BTreeMap::<&str, Names>::new();
    for (soname, _) in LIBRARIES {
        let Some(library) = installed(compiler, soname)? else {
            continue;
        };
        for (name, found) in names(&library)? {
            let home = if soname == LIBC && found.renewed { home(&name) } else { soname };
            stubs.entry(home).or_default().insert(name, found);
        }
    }
    let Some(start) = stubs.get(LIBC).and_then(|names| names.get(START)) else {
        let why = format!("{} has no {START} in {LIBC}", compiler.display());
        return Err(Error::Library(why));
    };
    let copies = folder.join("libcopies.a");
    archive(compiler, &format!("{START}@{}", start.version), &copies)?;
    for (soname, names) in &stubs {
        let library = match *soname {
            LIBC | LIBGCC | LOADER => part(folder, soname),
            _ => folder.join(format!("{}.so", soname.split('.').next().unwrap_or_default())),
        };
        make(compiler, soname, names, &library)?;
    }
    // Written like the files of these names in the installed libraries.
    let mut parts = vec![copies, part(folder, LIBC)];
    parts.extend(installed(compiler, "libc_nonshared.a")?);
    let mut group: Vec<_> = parts.iter().map(|part| quoted(part)).collect();
    if stubs.contains_key(LOADER) {
        group.push(format!("AS_NEEDED ( {} )", quoted(&part(folder, LOADER))));
    }
    write(&folder.join("libc.so"), &format!("GROUP ( {} )\n", group.join(" ")))?;
    if stubs.contains_key(LIBGCC) {
        let group = format!("GROUP ( {} -lgcc )\n", quoted(&part(folder, LIBGCC)));
        write(&folder.join("libgcc_s.so"), &group)?;
    }
    Ok(())
}

/// The stub that a linker script names. It does not have the library's own file name, because
/// cargo makes the loader search the folder too when it runs tests.
fn part(folder: &Path, soname: &str) -> PathBuf {
    folder.join(format!("stub-{soname}"))
}

fn quoted(path: &Path) -> String {
    format!("\"{}\"", path.display())
}

/// The library that contained a name before it moved to the main library with a new version.
fn home(name: &str) -> &'static str {
    let was_there =
        |(_, begins): &&(&str, &[&str])| begins.iter().any(|begin| name.starts_with(begin));
    LIBRARIES.iter().find(was_there).map_or(LIBC, |(soname, _)| *soname)
}

/// The path of one of the compiler's own files, if it has the file.
fn installed(compiler: &Path, file: &str) -> Result<Option<PathBuf>, Error> {
    let printed = output(Command::new(compiler).arg(format!("-print-file-name={file}")))?;
    let path = PathBuf::from(printed.trim());
    // For a file that it does not have, the compiler prints the name unchanged.
    Ok((path.components().count() > 1).then_some(path))
}

/// The numbers of a version by which it is compared with others of its kind, if it is old enough.
fn age(version: &str) -> Option<Vec<u32>> {
    let (kind, numbers) = version.split_once('_')?;
    let (_, newest) = NEWEST.iter().find(|(name, _)| *name == kind)?;
    let numbers: Vec<u32> =
        numbers.split('.').map(|number| number.parse().ok()).collect::<Option<_>>()?;
    (numbers.as_slice() <= *newest).then_some(numbers)
}

/// All names that a library has at a version that is old enough.
fn names(library: &Path) -> Result<Names, Error> {
    let data = fs::read(library).map_err(|source| file_error(library, source))?;
    let failed = |error: object::Error| Error::Library(format!("{}: {error}", library.display()));
    let file = ElfFile64::<Endianness>::parse(&*data).map_err(failed)?;
    let header: &FileHeader64<Endianness> = file.elf_header();
    let endian = file.endian();
    let versions = header
        .sections(endian, &*data)
        .and_then(|sections| sections.versions(endian, &*data))
        .map_err(failed)?;
    let mut names = Names::new();
    let (Some(versions), Some(symbols)) = (versions, file.dynamic_symbol_table()) else {
        return Ok(names);
    };
    let mut renewed = Vec::new();
    // The versions themselves are symbols without a section.
    let has_section = |symbol: &_| ObjectSymbol::section_index(symbol).is_some();
    for symbol in symbols.symbols().filter(has_section) {
        let index = versions.version_index(endian, symbol.index());
        let Some(version) = versions.version(index.index()).map_err(failed)? else {
            continue;
        };
        let name = symbol.name().map_err(failed)?.to_owned();
        let version = String::from_utf8_lossy(version.name()).into_owned();
        let Some(age) = age(&version) else {
            renewed.push(name);
            continue;
        };
        let is_data = matches!(symbol.kind(), SymbolKind::Data | SymbolKind::Tls);
        let found = Name { version, bytes: is_data.then(|| symbol.size()), renewed: false };
        match names.get(&name) {
            Some(other) if self::age(&other.version) > Some(age) => {}
            _ => _ = names.insert(name, found),
        }
    }
    for name in renewed {
        if let Some(found) = names.get_mut(&name) {
            found.renewed = true;
        }
    }
    Ok(names)
}

fn make(compiler: &Path, soname: &str, names: &Names, library: &Path) -> Result<(), Error> {
    let mut source = String::new();
    let mut versions = BTreeMap::<_, Vec<_>>::new();
    for (name, Name { version, bytes, .. }) in names {
        let _ = match bytes {
            Some(bytes) => writeln!(source, "char {name}[{}];", (*bytes).max(1)),
            // The linker finds the function of `start.c` by its plain name, and this one by its
            // version.
            None if name == START => writeln!(
                source,
                "void start(void) {{}}\n__asm__(\".symver start, {name}@{version}\");"
            ),
            None => writeln!(source, "void {name}(void) {{}}"),
        };
        versions.entry((age(version), version)).or_default().push(name.as_str());
    }
    let mut script = String::new();
    let mut before = "";
    for ((_, version), names) in &versions {
        let local = if before.is_empty() { " local: *;" } else { "" };
        let names = names.join("; ");
        let _ = writeln!(script, "{version} {{ global: {names};{local} }} {before};");
        before = version.as_str();
    }
    let map = library.with_extension("map");
    write(&map, &script)?;
    let mut versions = OsString::from("-Wl,--version-script=");
    versions.push(map);
    share(compiler, soname, &source, &[versions], library)
}

fn archive(compiler: &Path, start: &str, archive: &Path) -> Result<(), Error> {
    let printed = output(Command::new(compiler).arg("-print-prog-name=ar"))?;
    let mut archiver = Command::new(printed.trim());
    archiver.arg("rcs").arg(archive);
    for (name, text) in COPIES {
        let source = archive.with_file_name(format!("{name}.c"));
        let object = source.with_extension("o");
        write(&source, text)?;
        let mut command = Command::new(compiler);
        command.args(["-O2", "-fPIC", "-fvisibility=hidden", "-c"]);
        command.arg(format!("-DSTART=\"{start}\""));
        run(command.arg("-o").arg(&object).arg(&source))?;
        archiver.arg(&object);
    }
    run(&mut archiver)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn versions_are_compared_as_numbers() {
        assert!(age("GLIBC_2.3.4") > age("GLIBC_2.3"));
        assert!(age("GLIBC_2.17") > age("GLIBC_2.4"));
        for later in ["GLIBC_2.17.1", "GLIBC_2.35", "GCC_7.0.0"] {
            assert_eq!(age(later), None, "{later}");
        }
        for other in ["GLIBC_PRIVATE", "GLIBC_ABI_DT_RELR", "FOO_1", "2.3"] {
            assert_eq!(age(other), None, "{other}");
        }
    }

    #[test]
    fn moved_function_keeps_its_former_library() {
        assert_eq!(home("pthread_create"), "libpthread.so.0");
        assert_eq!(home("dlsym"), "libdl.so.2");
        assert_eq!(home("timer_create"), "librt.so.1");
        assert_eq!(home("__libc_start_main"), LIBC);
    }
}
