//! The origin of results: the host, the commit and the command.

use std::fs;
use std::process::Command;
use std::thread;

use crate::output::Origin;

/// For what can't be found out.
const UNKNOWN: &str = "unknown";

impl Origin {
    /// The origin of results that this process measures now.
    pub fn here() -> Self {
        Self {
            machine: machine(),
            commit: commit().unwrap_or_else(|| UNKNOWN.to_owned()),
            command: std::iter::once("cellray-bench".to_owned())
                .chain(std::env::args().skip(1))
                .collect::<Vec<_>>()
                .join(" "),
        }
    }
}

/// The name of the host's processor in Linux.
fn machine() -> String {
    let processors = thread::available_parallelism().map_or(1, usize::from);
    let cpuinfo = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = cpuinfo.lines().find_map(|line| {
        let (key, value) = line.split_once(':')?;
        ["model name", "cpu", "Model"].contains(&key.trim()).then(|| value.trim().to_owned())
    });
    let model = model.unwrap_or_else(|| UNKNOWN.to_owned());
    format!("{model} ({}), {processors} processors", std::env::consts::ARCH)
}

/// The commit of the sources from which this was built, if they still exist.
fn commit() -> Option<String> {
    let described = Command::new("git")
        .args(["-C", env!("CARGO_MANIFEST_DIR")])
        .args(["describe", "--always", "--dirty", "--abbrev=12"])
        .output()
        .ok()?;
    let text = String::from_utf8(described.stdout).ok()?;
    (described.status.success() && !text.trim().is_empty()).then(|| text.trim().to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn origin_fields_have_values() {
        let Origin { machine, commit, command } = Origin::here();
        assert!(machine.contains(std::env::consts::ARCH), "{machine}");
        let hex = |c: char| c.is_ascii_hexdigit();
        let known = commit.trim_end_matches("-dirty").chars().all(hex);
        assert!(commit == UNKNOWN || known, "{commit}");
        assert!(command.starts_with("cellray-bench"), "{command}");
    }
}
