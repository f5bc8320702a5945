//! The machine's processors, as the kernel describes them.

use std::fs;
use std::path::Path;

use libc::c_int;

use crate::error::Errno;
use crate::types::{SPE_CPU_IS_CELLBE, SPE_CPU_IS_CELLEDP};

/// The hardware threads of a Cell processor.
const THREADS: usize = 2;

/// The number of SPEs. Only entries with a number are counted: newer kernels have others beside
/// them.
pub(crate) fn spes() -> Result<c_int, Errno> {
    numbered(Path::new("/sys/devices/system/spu"), "spu").map(|spes| spes as c_int)
}

pub(crate) fn nodes() -> Result<c_int, Errno> {
    let threads = numbered(Path::new("/sys/devices/system/cpu"), "cpu")?;
    Ok((threads / THREADS).max(1) as c_int)
}

/// The kind of Cell.
pub(crate) fn kind() -> c_int {
    kind_in(&fs::read_to_string("/proc/cpuinfo").unwrap_or_default())
}

/// The number of entries of a folder whose names are `prefix` and a number.
fn numbered(folder: &Path, prefix: &str) -> Result<usize, Errno> {
    let is_numbered = |name: &str| {
        let number = name.strip_prefix(prefix);
        number.is_some_and(|number| number.parse::<u32>().is_ok())
    };
    let mut count = 0;
    for entry in fs::read_dir(folder)? {
        count += usize::from(entry?.file_name().to_str().is_some_and(is_numbered));
    }
    Ok(count)
}

/// The kind of Cell by the version of its PPE in the kernel's description.
fn kind_in(description: &str) -> c_int {
    if description.contains("(pvr 0070 3000)") { SPE_CPU_IS_CELLEDP } else { SPE_CPU_IS_CELLBE }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_numbered_entries_are_counted() {
        let folder = tempfile::tempdir().unwrap();
        for name in ["spu0", "spu1", "spu15", "spu", "spux", "power", "uevent"] {
            fs::write(folder.path().join(name), "").unwrap();
        }
        assert_eq!(numbered(folder.path(), "spu"), Ok(3));
        let missing = numbered(&folder.path().join("missing"), "spu");
        assert_eq!(missing, Err(Errno(libc::ENOENT)));
    }

    #[test]
    fn kinds_of_cell() {
        let console = "cpu\t\t: Cell Broadband Engine, altivec supported\n\
                       revision\t: 16.0 (pvr 0070 1000)\n";
        assert_eq!(kind_in(console), SPE_CPU_IS_CELLBE);
        let blade = console.replace("1000", "3000");
        assert_eq!(kind_in(&blade), SPE_CPU_IS_CELLEDP);
    }
}
