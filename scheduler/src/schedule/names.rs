//! What registers are called in the schedule.
//!
//! A value that is where the source had it keeps the source's name. One that had to move is called
//! after it, with a number.

use std::collections::{BTreeMap, BTreeSet};

use super::source::Name;

/// The names of one source and its schedule.
pub(super) struct Names<'a> {
    given: Vec<Name<'a>>,
    /// Names that exist already.
    used: BTreeSet<String>,
    /// Those of the source that no label of the schedule has yet.
    unclaimed: BTreeSet<String>,
    /// By the name in the source and the new number.
    moved: BTreeMap<(String, u8), String>,
    /// In the order in which they were needed.
    made: Vec<(String, u8)>,
}

impl<'a> Names<'a> {
    /// `used` are all names of the source.
    pub fn new(given: Vec<Name<'a>>, used: BTreeSet<String>) -> Self {
        Self {
            given,
            unclaimed: used.clone(),
            used,
            moved: BTreeMap::new(),
            made: Vec::new(),
        }
    }

    /// What `number` is called, which holds a value that the source has in `plain`.
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

    /// A label that nothing else has: the one that is wanted if the source has it.
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

    /// The names that the source does not set outside its functions, since the last call.
    pub fn take_made(&mut self, inside: (u64, u64)) -> Vec<(String, u8)> {
        let given = self.given.iter();
        let repeated =
            given.filter(|name| name.inside && (inside.0..inside.1).contains(&name.line));
        let mut all: Vec<(String, u8)> = repeated
            .map(|name| (name.name.to_owned(), name.number))
            .collect();
        all.append(&mut self.made);
        all
    }

    /// The source's name, without its sign, as of a line; what the scheduler added has line 0.
    fn in_source(&self, number: u8, line: u64) -> String {
        match number {
            0 => return "lr".into(),
            1 => return "sp".into(),
            _ => {}
        }
        let known = |name: &&Name<'_>| line == 0 || name.line < line;
        let names = self
            .given
            .iter()
            .filter(known)
            .filter(|name| name.number <= number);
        // The latest of the nearest.
        match names.max_by_key(|name| (name.number, name.line)) {
            Some(name) if name.number == number => name.name.to_owned(),
            Some(name) if name.number > 1 => format!("{}+{}", name.name, number - name.number),
            _ => number.to_string(),
        }
    }
}
