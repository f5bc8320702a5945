//! The program's peak memory use.

/// The largest resident size so far in bytes, if the system reports it.
pub(super) fn peak_bytes() -> Option<u64> {
    peak_of(&std::fs::read_to_string("/proc/self/status").ok()?)
}

/// The `VmHWM` line of Linux's `/proc/self/status`.
fn peak_of(status: &str) -> Option<u64> {
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    let kibibytes: u64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(kibibytes << 10)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn peak_is_read_from_proc() {
        let status =
            "Name:\tcellray\nVmPeak:\t  9999 kB\nVmHWM:\t    1234 kB\nVmRSS:\t      99 kB\n";
        assert_eq!(peak_of(status), Some(1234 * 1024));
        assert_eq!(peak_of("VmHWM:\t1234 pages\n"), None);
        assert_eq!(peak_of("Name:\tcellray\n"), None);
        let here = peak_bytes().expect("Linux reports it");
        assert!(here > 1 << 20, "{here}");
    }
}
