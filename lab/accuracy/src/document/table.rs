//! Markdown tables.

use std::fmt;

/// A column's heading, and the function that makes its cells.
pub(super) type Column<R> = (&'static str, fn(&R) -> String);

/// A table with headings. Columns are as wide as their contents.
#[derive(Clone, Debug)]
pub(super) struct Table {
    rows: Vec<Vec<String>>,
}

impl Table {
    pub fn new<'a>(head: impl IntoIterator<Item = &'a str>) -> Self {
        let head = head.into_iter().map(str::to_owned).collect();
        Self { rows: vec![head] }
    }

    /// A table with a row for each of these.
    pub fn of<R>(rows: impl IntoIterator<Item = R>, columns: &[Column<R>]) -> Self {
        let mut table = Self::new(columns.iter().map(|(title, _)| *title));
        for row in rows {
            table.row(columns.iter().map(|(_, cell)| cell(&row)));
        }
        table
    }

    pub fn row(&mut self, cells: impl IntoIterator<Item = String>) {
        self.rows.push(cells.into_iter().collect());
    }
}

impl fmt::Display for Table {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let width = |column: usize| {
            let cells = self.rows.iter().filter_map(|row| row.get(column));
            cells.map(|cell| cell.chars().count()).max().unwrap_or(0)
        };
        let columns = self.rows[0].len();
        let widths: Vec<usize> = (0..columns).map(width).collect();
        for (number, row) in self.rows.iter().enumerate() {
            for (cell, &width) in row.iter().zip(&widths) {
                // Numbers are aligned to the right.
                if number > 0 && cell.starts_with(|first: char| first.is_ascii_digit()) {
                    write!(out, "| {cell:>width$} ")?;
                } else {
                    write!(out, "| {cell:<width$} ")?;
                }
            }
            writeln!(out, "|")?;
            if number == 0 {
                for width in &widths {
                    write!(out, "|{}", "-".repeat(width + 2))?;
                }
                writeln!(out, "|")?;
            }
        }
        Ok(())
    }
}

/// A number with three significant digits.
pub(super) fn figure(value: f64) -> String {
    match value.abs() {
        0.0 => "0".to_owned(),
        1e5.. => format!("{value:.1e}"),
        100.0.. => format!("{value:.0}"),
        10.0.. => format!("{value:.1}"),
        0.01.. => format!("{value:.2}"),
        _ => format!("{value:.1e}"),
    }
}

/// A number, or an empty cell.
pub(super) fn option(value: Option<f64>) -> String {
    value.map_or_else(String::new, figure)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_as_wide_as_their_cells() {
        let mut table = Table::new(["name", "ulps"]);
        table.row(["a longer one".to_owned(), "3.1".to_owned()]);
        let text = "| name         | ulps |\n|--------------|------|\n| a longer one |  3.1 |\n";
        assert_eq!(table.to_string(), text);
    }

    #[test]
    fn figures_have_three_digits() {
        let figures = [0.0, 2.0, 41.26, 1234.6, 5e6, 0.0012].map(figure);
        assert_eq!(figures, ["0", "2.00", "41.3", "1235", "5.0e6", "1.2e-3"]);
    }
}
