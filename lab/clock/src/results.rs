//! The file with the results of one machine.

use std::fs;

use cellray::spe::library_path;
use serde::{Deserialize, Serialize};

/// The result of one row.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Value {
    /// The row's name.
    pub row: String,
    /// The figure, in the row's unit.
    pub value: f64,
}

/// The machine that was measured.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Machine {
    /// The file of libspe2, or of this program if libspe2 is linked into it.
    pub libspe2: String,
    /// The kernel's version.
    pub kernel: String,
    /// The kernel's description of the processor and the machine.
    pub processor: Vec<String>,
}

impl Machine {
    /// This machine.
    #[must_use]
    pub fn here() -> Self {
        let read = |path| fs::read_to_string(path).unwrap_or_default();
        let lines = read("/proc/cpuinfo");
        let mut processor: Vec<String> = Vec::new();
        for line in lines.lines() {
            let named = ["cpu\t", "machine", "platform", "revision", "model name"];
            let line = line.split_whitespace().collect::<Vec<_>>().join(" ");
            let wanted = named.iter().any(|name| line.starts_with(name.trim_end()));
            if wanted && !line.starts_with("cpu MHz") && !processor.contains(&line) {
                processor.push(line);
            }
        }
        Self {
            libspe2: library_path().map_or_else(String::new, |path| path.display().to_string()),
            kernel: read("/proc/version").trim().to_owned(),
            processor,
        }
    }
}

/// The results of one machine.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Results {
    /// The version of this program.
    pub version: String,
    /// The machine.
    pub machine: Machine,
    /// The rows.
    pub rows: Vec<Value>,
}

/// The stored results of the emulator's model, with which other machines are compared.
#[must_use]
pub fn model() -> Vec<Value> {
    let text = include_str!("../model.json");
    let Ok(rows) = serde_json::from_str(text) else {
        unreachable!("a test reads the same file");
    };
    rows
}
