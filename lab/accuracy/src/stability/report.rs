//! What the suite has found: a table to read, and JSON.

use std::fmt;

use serde::Serialize;
use serde_json::{Value, json};

use super::Size;
use super::family::{Family, Tally};
use super::statement::Bound;

/// A part of the report.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Section {
    /// Kernels under stress.
    Stress,
    /// What holds of scenes.
    Guarantees,
}

impl Section {
    /// All of them, in the report's order.
    pub const ALL: [Self; 2] = [Self::Stress, Self::Guarantees];

    fn title(self) -> &'static str {
        match self {
            Self::Stress => "Stress",
            Self::Guarantees => "Guarantees",
        }
    }
}

/// What was found of a family.
#[derive(Clone, Debug)]
pub struct Row {
    /// Where it belongs.
    pub section: Section,
    /// The family.
    pub family: &'static str,
    /// What it was tried on.
    pub subject: String,
    /// What the error is counted in.
    pub unit: &'static str,
    /// What it is held to.
    pub bound: Bound,
    /// Kept inputs that were tried.
    pub replayed: u64,
    /// All that was tried.
    pub tally: Tally,
}

/// All that was found.
#[derive(Clone, Debug)]
pub struct Report {
    /// Seed of the random inputs.
    pub seed: u64,
    /// How many there were.
    pub size: Size,
    /// A family and what it was tried on, each.
    pub rows: Vec<Row>,
}

#[derive(Serialize)]
struct RowRecord<'a> {
    section: &'static str,
    family: &'static str,
    subject: &'a str,
    cases: u64,
    counted: u64,
    replayed: u64,
    wrong: u64,
    worst: f64,
    unit: &'static str,
    bound: f64,
    source: &'a str,
    held: bool,
    input: Vec<String>,
}

impl Row {
    /// The row of a family, of what was kept and what is new.
    pub fn new(section: Section, family: Family, replayed: Tally, tally: Tally) -> Self {
        let mut all = replayed;
        let replayed = all.cases;
        all.append(tally);
        Self {
            section,
            family: family.name,
            subject: family.subject,
            unit: family.unit,
            bound: family.bound,
            replayed,
            tally: all,
        }
    }

    /// Whether the bound holds.
    pub fn held(&self) -> bool {
        self.tally.holds(&self.bound)
    }

    /// The worst input's words.
    pub fn hex(&self) -> Vec<String> {
        let words = self.tally.input.iter();
        words.map(|word| format!("{word:08x}")).collect()
    }

    fn record(&self) -> RowRecord<'_> {
        RowRecord {
            section: self.section.title(),
            family: self.family,
            subject: &self.subject,
            cases: self.tally.cases,
            counted: self.tally.counted,
            replayed: self.replayed,
            wrong: self.tally.wrong,
            worst: self.tally.worst,
            unit: self.unit,
            bound: self.bound.value,
            source: &self.bound.source,
            held: self.held(),
            input: self.hex(),
        }
    }
}

impl Report {
    /// Whether all bounds hold, and there were any.
    pub fn held(&self) -> bool {
        !self.rows.is_empty() && self.rows.iter().all(Row::held)
    }

    /// The report for programs: nothing in it depends on the host.
    pub fn json(&self) -> Value {
        let rows: Vec<RowRecord<'_>> = self.rows.iter().map(Row::record).collect();
        let size = match self.size {
            Size::Quick => "quick",
            Size::Default => "default",
            Size::Full => "full",
        };
        json!({ "seed": self.seed, "size": size, "held": self.held(), "rows": rows })
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for section in Section::ALL {
            let rows: Vec<&Row> = self.rows.iter().filter(|r| r.section == section).collect();
            if rows.is_empty() {
                continue;
            }
            writeln!(f, "{}\n", section.title())?;
            table(f, &rows)?;
            writeln!(f)?;
        }
        for row in self.rows.iter().filter(|row| !row.held()) {
            let (family, subject, hex) = (row.family, &row.subject, row.hex().join(" "));
            writeln!(f, "FAILED {family}, {subject}: {hex}")?;
        }
        Ok(())
    }
}

/// The rows with columns as wide as they need.
fn table(f: &mut fmt::Formatter<'_>, rows: &[&Row]) -> fmt::Result {
    const LEFT: [bool; 9] = [true, true, false, false, false, false, false, true, true];
    let titles = [
        "family", "of", "cases", "counted", "wrong", "worst", "bound", "in, by", "",
    ];
    let mut cells = vec![titles.map(str::to_owned)];
    cells.extend(rows.iter().map(|row| {
        [
            row.family.to_owned(),
            row.subject.clone(),
            row.tally.cases.to_string(),
            row.tally.counted.to_string(),
            row.tally.wrong.to_string(),
            short(row.tally.worst),
            short(row.bound.value),
            format!("{}; {}", row.unit, row.bound.source),
            (if row.held() { "ok" } else { "FAILED" }).to_owned(),
        ]
    }));
    let widths: [usize; 9] = std::array::from_fn(|column| {
        let lengths = cells.iter().map(|row| row[column].chars().count());
        lengths.max().unwrap_or(0)
    });
    for row in &cells {
        let mut line = String::new();
        for ((cell, width), left) in row.iter().zip(widths).zip(LEFT) {
            let cell = if left {
                format!("{cell:<width$}")
            } else {
                format!("{cell:>width$}")
            };
            line.push_str(&cell);
            line.push_str("  ");
        }
        writeln!(f, "{}", line.trim_end())?;
    }
    Ok(())
}

/// A number in few digits.
fn short(value: f64) -> String {
    if value == 0.0 || (0.01..100_000.0).contains(&value) {
        format!("{value:.2}")
    } else {
        format!("{value:.1e}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(worst: f64, wrong: u64) -> Row {
        Row {
            section: Section::Stress,
            family: "a family",
            subject: "a kernel".to_owned(),
            unit: "ulp of t",
            bound: Bound {
                value: 2.0,
                source: "a test".to_owned(),
            },
            replayed: 1,
            tally: Tally {
                cases: 9,
                counted: 8,
                wrong,
                worst,
                input: vec![0x3f80_0000, 1],
            },
        }
    }

    fn report(rows: Vec<Row>) -> Report {
        Report {
            seed: 7,
            size: Size::Quick,
            rows,
        }
    }

    #[test]
    fn what_fails_is_said_with_its_input() {
        let report = report(vec![row(1.5, 0), row(2.5, 0), row(0.5, 1)]);
        assert!(!report.held());
        let text = report.to_string();
        assert_eq!(text.matches(" ok").count(), 1, "{text}");
        let said = "FAILED a family, a kernel: 3f800000 00000001";
        assert_eq!(text.matches(said).count(), 2, "{text}");
    }

    #[test]
    fn json_says_the_same() {
        let report = report(vec![row(1.5, 0)]);
        assert!(report.held());
        let value = report.json();
        assert_eq!(value["held"], true);
        assert_eq!(value["rows"][0]["worst"], 1.5);
        assert_eq!(value["rows"][0]["input"][0], "3f800000");
    }

    #[test]
    fn no_rows_hold_nothing() {
        assert!(!report(Vec::new()).held());
    }
}
