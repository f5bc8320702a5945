//! The suite's results as a table and as JSON.

use std::fmt;

use serde_json::{Value, json};

use super::Size;
use super::family::{Family, Tally};
use super::statement::Bound;

/// A part of the report.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Section {
    /// Kernels with difficult inputs.
    Stress,
    /// Guarantees about scenes.
    Guarantees,
}

impl Section {
    /// All sections in the report's order.
    pub const ALL: [Self; 2] = [Self::Stress, Self::Guarantees];

    fn title(self) -> &'static str {
        match self {
            Self::Stress => "Stress",
            Self::Guarantees => "Guarantees",
        }
    }
}

/// The results of a family.
#[derive(Clone, Debug)]
pub struct Row {
    /// The section that it belongs to.
    pub section: Section,
    /// The family's name.
    pub family: &'static str,
    /// What the cases test.
    pub subject: String,
    /// The unit of the error.
    pub unit: &'static str,
    /// The bound of the error.
    pub bound: Bound,
    /// The number of saved inputs that were tried.
    pub replayed: u64,
    /// The results of all cases.
    pub tally: Tally,
}

/// The results of all families.
#[derive(Clone, Debug)]
pub struct Report {
    /// The seed of the random inputs.
    pub seed: u64,
    /// The number of cases.
    pub size: Size,
    /// One row for each family and subject.
    pub rows: Vec<Row>,
}

impl Row {
    /// The row of a family, with the results of saved and of new inputs.
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

    /// The words of the worst input.
    pub fn hex(&self) -> Vec<String> {
        let words = self.tally.input.iter();
        words.map(|word| format!("{word:08x}")).collect()
    }

    fn record(&self) -> Value {
        json!({
            "section": self.section.title(),
            "family": self.family,
            "subject": self.subject,
            "cases": self.tally.cases,
            "counted": self.tally.counted,
            "replayed": self.replayed,
            "wrong": self.tally.wrong,
            "worst": self.tally.worst,
            "unit": self.unit,
            "bound": self.bound.value,
            "source": self.bound.source,
            "held": self.held(),
            "input": self.hex(),
        })
    }
}

impl Report {
    /// Whether all bounds hold. False if there are none.
    pub fn held(&self) -> bool {
        !self.rows.is_empty() && self.rows.iter().all(Row::held)
    }

    /// The report as JSON, in which nothing depends on the host.
    pub fn json(&self) -> Value {
        let rows: Vec<Value> = self.rows.iter().map(Row::record).collect();
        json!({ "seed": self.seed, "size": self.size, "held": self.held(), "rows": rows })
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

/// A column: its heading, whether it is aligned to the left, and the function that makes its
/// cells.
type Column = (&'static str, bool, fn(&Row) -> String);

const COLUMNS: [Column; 9] = [
    ("family", true, |row| row.family.to_owned()),
    ("of", true, |row| row.subject.clone()),
    ("cases", false, |row| row.tally.cases.to_string()),
    ("counted", false, |row| row.tally.counted.to_string()),
    ("wrong", false, |row| row.tally.wrong.to_string()),
    ("worst", false, |row| short(row.tally.worst)),
    ("bound", false, |row| short(row.bound.value)),
    ("in, by", true, |row| format!("{}; {}", row.unit, row.bound.source)),
    ("", true, |row| (if row.held() { "ok" } else { "FAILED" }).to_owned()),
];

/// Writes the rows with columns as wide as needed.
fn table(f: &mut fmt::Formatter<'_>, rows: &[&Row]) -> fmt::Result {
    let mut lines = vec![String::new(); rows.len() + 1];
    for (title, left, cell) in COLUMNS {
        let cells = rows.iter().map(|row| cell(row));
        let cells: Vec<String> = std::iter::once(title.to_owned()).chain(cells).collect();
        let widths = cells.iter().map(|cell| cell.chars().count());
        let width = widths.max().unwrap_or(0);
        for (line, cell) in lines.iter_mut().zip(cells) {
            line.push_str(&if left {
                format!("{cell:<width$}  ")
            } else {
                format!("{cell:>width$}  ")
            });
        }
    }
    lines.iter().try_for_each(|line| writeln!(f, "{}", line.trim_end()))
}

/// A number with few digits.
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
            bound: Bound { value: 2.0, source: "a test".to_owned() },
            replayed: 1,
            tally: Tally { cases: 9, counted: 8, wrong, worst, input: vec![0x3f80_0000, 1] },
        }
    }

    fn report(rows: Vec<Row>) -> Report {
        Report { seed: 7, size: Size::Quick, rows }
    }

    #[test]
    fn report_prints_failure_with_input() {
        let report = report(vec![row(1.5, 0), row(2.5, 0), row(0.5, 1)]);
        assert!(!report.held());
        let text = report.to_string();
        assert_eq!(text.matches(" ok").count(), 1, "{text}");
        let expected = "FAILED a family, a kernel: 3f800000 00000001";
        assert_eq!(text.matches(expected).count(), 2, "{text}");
    }

    #[test]
    fn json_report_has_rows_and_verdict() {
        let report = report(vec![row(1.5, 0)]);
        assert!(report.held());
        let value = report.json();
        assert_eq!(value["held"], true);
        assert_eq!(value["rows"][0]["worst"], 1.5);
        assert_eq!(value["rows"][0]["input"][0], "3f800000");
    }

    #[test]
    fn empty_report_does_not_hold() {
        assert!(!report(Vec::new()).held());
    }
}
