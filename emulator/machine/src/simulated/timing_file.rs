//! Timings from a file, in TOML. What the file does not name is the console's.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use serde::de::{Deserialize, Deserializer, Error, Unexpected, Visitor};
use toml::de::DeTable;

use super::figures::Timing;
use super::time::Tenths;

/// The largest figure that a file may have. It is a millisecond or so in cycles, and no sum of
/// figures overflows.
const LARGEST: u64 = 10_000_000;

/// Why there is no timing.
#[derive(Debug, thiserror::Error)]
pub enum TimingFileError {
    /// The file can't be read.
    #[error("{}: {source}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// The reason.
        source: io::Error,
    },
    /// The file is no TOML, or has a name or a kind of value that a timing has not. The source
    /// names the line.
    #[error("{}: {source}", path.display())]
    Parse {
        /// The file.
        path: PathBuf,
        /// What is wrong, and in which line.
        source: Box<toml::de::Error>,
    },
    /// A figure is too small or too large.
    #[error("{}:{line}: {table}.{field} is {min} to {max}, not {value}", path.display())]
    Range {
        /// The file.
        path: PathBuf,
        /// The line, from 1.
        line: usize,
        /// The table.
        table: &'static str,
        /// The field.
        field: &'static str,
        /// Its minimum.
        min: f64,
        /// Its maximum.
        max: f64,
        /// The value in the file.
        value: f64,
    },
}

impl Timing {
    /// Reads a timing from a file in TOML with the tables `pipelines`
    /// ([`Rules`](spu_isa::timing::Rules)), `memory` ([`MemoryFigures`](super::MemoryFigures)) and
    /// `ppe` ([`PpeFigures`](super::PpeFigures)). Fields have the names of the structs' fields.
    /// What the file leaves out is the console's.
    ///
    /// # Errors
    ///
    /// Fails if the file can't be read, names something that a timing has not, or has a value out
    /// of range.
    pub fn read(path: &Path) -> Result<Self, TimingFileError> {
        let text = fs::read_to_string(path)
            .map_err(|source| TimingFileError::Read { path: path.to_owned(), source })?;
        Self::parse(path, &text)
    }

    fn parse(path: &Path, text: &str) -> Result<Self, TimingFileError> {
        let failed =
            |source| TimingFileError::Parse { path: path.to_owned(), source: Box::new(source) };
        let timing: Self = toml::from_str(text).map_err(failed)?;
        let document = DeTable::parse(text).map_err(failed)?;
        for figure in timing.figures() {
            if (figure.min..=LARGEST).contains(&figure.value) {
                continue;
            }
            let (field, unit) = match figure.name.strip_suffix("_tenths") {
                Some(field) => (field, Tenths::PER_CYCLE as f64),
                None => (figure.name, 1.0),
            };
            let table = document.get_ref().get(figure.table);
            let entry = table
                .and_then(|table| table.get_ref().as_table())
                .and_then(|table| table.get(field));
            let start = entry.map_or(0, |entry| entry.span().start);
            return Err(TimingFileError::Range {
                path: path.to_owned(),
                line: text[..start].matches('\n').count() + 1,
                table: figure.table,
                field,
                min: figure.min as f64 / unit,
                max: LARGEST as f64 / unit,
                value: figure.value as f64 / unit,
            });
        }
        Ok(timing)
    }
}

impl<'de> Deserialize<'de> for Tenths {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        struct Cycles;
        impl Visitor<'_> for Cycles {
            type Value = Tenths;

            fn expecting(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                formatter.write_str("a number of cycles with at max one decimal")
            }

            fn visit_i64<E: Error>(self, cycles: i64) -> Result<Tenths, E> {
                let tenths = cycles.checked_mul(Tenths::PER_CYCLE as i64);
                let tenths = tenths.and_then(|tenths| u64::try_from(tenths).ok());
                let wrong = || E::invalid_value(Unexpected::Signed(cycles), &self);
                tenths.map(Tenths).ok_or_else(wrong)
            }

            fn visit_f64<E: Error>(self, cycles: f64) -> Result<Tenths, E> {
                let tenths = (cycles * Tenths::PER_CYCLE as f64).round();
                let exact = tenths >= 0.0
                    && tenths <= LARGEST as f64 * 10.0
                    && tenths / Tenths::PER_CYCLE as f64 == cycles;
                if exact {
                    Ok(Tenths(tenths as u64))
                } else {
                    Err(E::invalid_value(Unexpected::Float(cycles), &self))
                }
            }
        }
        from.deserialize_any(Cycles)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parse(text: &str) -> Result<Timing, String> {
        let timing = Timing::parse(Path::new("slow.toml"), text);
        timing.map_err(|error| error.to_string())
    }

    #[test]
    fn a_file_changes_what_it_names() {
        assert_eq!(parse(""), Ok(Timing::default()));
        let text = "[memory]\nget_line = 20.5\nput_line = 21\nget_latency = 400\n\
                    [pipelines]\nmiss_cycles = 19\nhints = false\n[ppe]\ncall_cycles = 0\n";
        let mut expected = Timing::default();
        expected.memory.get_line = Tenths(205);
        expected.memory.put_line = Tenths(210);
        expected.memory.get_latency = 400;
        expected.rules.miss_cycles = 19;
        expected.rules.hints = false;
        expected.ppe.call_cycles = 0;
        assert_eq!(parse(text), Ok(expected));
    }

    #[test]
    fn an_error_names_file_line_and_field() {
        for (text, parts) in [
            ("[memory]\n\nget_lime = 1", &["line 3", "get_lime"][..]),
            ("[pipeline]", &["line 1", "pipeline", "pipelines"]),
            ("[memory]\nget_line = 17.35", &["line 2", "get_line", "17.35"]),
            ("[memory]\nget_line = -1", &["line 2", "get_line", "-1"]),
            ("[memory]\nget_line = inf", &["line 2", "get_line", "inf"]),
            ("[ppe]\ncall_cycles = \"x\"", &["line 2", "call_cycles"]),
            ("[ppe]\ncall_cycles = -4", &["line 2", "call_cycles", "-4"]),
            ("[ppe", &["line 1"]),
            ("[memory]\nget_line = 0", &[":2: memory.get_line is 0.1 to 1000000, not 0"]),
            (
                "[ppe]\n\nrun_cycles = 99999999",
                &[":3: ppe.run_cycles is 0 to 10000000, not 99999999"],
            ),
            ("memory = { outstanding_lines = 0 }", &[":1: memory.outstanding_lines is 1"]),
        ] {
            let error = parse(text).unwrap_err();
            assert!(error.starts_with("slow.toml"), "{error}");
            for part in parts {
                assert!(error.contains(part), "{text:?}: {error}");
            }
        }
        let missing = Timing::read(Path::new("/missing.toml")).unwrap_err();
        assert!(missing.to_string().starts_with("/missing.toml: "));
    }
}
