//! The names of registers in the schedule.
//!
//! A value that stays in the source's register keeps the source's name. A value that had to move
//! gets this name with a number.

use std::collections::{BTreeMap, BTreeSet};

use super::source::Name;

/// The names in one source and its schedule.
pub(super) struct Names<'a> {
    given: Vec<Name<'a>>,
    used: BTreeSet<String>,
    /// Labels of the source that the schedule has not used yet.
    unclaimed: BTreeSet<String>,
    /// The new name for a name in the source and a new register number.
    moved: BTreeMap<(String, u8), String>,
    /// New names in the order in which they were needed.
    made: Vec<(String, u8)>,
}

impl<'a> Names<'a> {
    /// `used` are all names in the source.
    pub fn new(given: Vec<Name<'a>>, used: BTreeSet<String>) -> Self {
        Self { given, unclaimed: used.clone(), used, moved: BTreeMap::new(), made: Vec::new() }
    }

    /// The name of register `number` when it holds a value that the source has in `plain`.
    pub fn register(&mut self, number: u8, plain: u8, line: u64) -> String {
        if number == plain {
            return format!("${}", self.in_source(plain, line));
        }
        let base = self.in_source(plain, line).replace('+', "");
        let key = (base, number);
        if let Some(name) = self.moved.get(&key) {
            return format!("${name}");
        }
        let base = if key.0.starts_with(|c: char| c.is_ascii_digit()) {
            format!("r{}", key.0)
        } else {
            key.0.clone()
        };
        let free = |name: &String| !self.used.contains(name);
        let mut tries = (2u32..).map(|count| format!("{base}_{count}"));
        let name = tries.find(free).unwrap_or(base);
        self.used.insert(name.clone());
        self.moved.insert(key, name.clone());
        self.made.push((name.clone(), number));
        format!("${name}")
    }

    /// An unused label: `wanted` if possible, or else `wanted` with a number.
    pub fn label(&mut self, wanted: &str) -> String {
        if self.unclaimed.remove(wanted) {
            return wanted.to_owned();
        }
        let mut tries = [wanted.to_owned()]
            .into_iter()
            .chain((2u32..).map(|count| format!("{wanted}_{count}")));
        let free = tries.find(|name| !self.used.contains(name));
        let name = free.unwrap_or_else(|| wanted.to_owned());
        self.used.insert(name.clone());
        name
    }

    /// The new names since the last call, and the names that the source sets inside this function.
    pub fn take_made(&mut self, inside: (u64, u64)) -> Vec<(String, u8)> {
        let given = self.given.iter();
        let repeated =
            given.filter(|name| name.inside && (inside.0..inside.1).contains(&name.line));
        let mut all: Vec<(String, u8)> =
            repeated.map(|name| (name.name.to_owned(), name.number)).collect();
        all.append(&mut self.made);
        all
    }

    /// The source's name of a register at a line, without `$`. Line 0 is code that the scheduler
    /// added.
    fn in_source(&self, number: u8, line: u64) -> String {
        match number {
            0 => return "lr".into(),
            1 => return "sp".into(),
            _ => {}
        }
        let known = |name: &&Name<'_>| line == 0 || name.line < line;
        let names = self.given.iter().filter(known).filter(|name| name.number <= number);
        // The latest of the names for the nearest register.
        match names.max_by_key(|name| (name.number, name.line)) {
            Some(name) if name.number == number => name.name.to_owned(),
            Some(name) if name.number > 1 => format!("{}+{}", name.name, number - name.number),
            _ => number.to_string(),
        }
    }
}
