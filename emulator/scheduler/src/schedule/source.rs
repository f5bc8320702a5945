//! The text of a plain source, and the parts of it that the scheduler keeps.

use std::collections::BTreeMap;
use std::ops::Range;
use std::path::Path;

use super::error::Unschedulable;
use super::function::{Registers, bit};
use spu_isa::Op;

/// The directives that have done their work once the object exists.
const EXPANDED: [&str; 28] = [
    ".irp", ".irpc", ".rept", ".endr", ".set", ".equ", ".if", ".ifb", ".ifnb", ".ifc", ".ifnc",
    ".ifdef", ".ifndef", ".ifeq", ".ifne", ".ifge", ".ifgt", ".ifle", ".iflt", ".else", ".elseif",
    ".endif", ".align", ".p2align", ".balign", ".loc", ".error", ".warning",
];

/// How the header line begins that lists the registers that a function writes, and a further line.
const USES: &str = "#   Uses    ";
const FURTHER: &str = "#           ";
/// The width of a line in columns.
const WIDTH: usize = 100;

/// A function's lines, counted from 0.
#[derive(Clone, Debug)]
pub(super) struct Lines {
    pub name: String,
    /// The first line, which is before the code and stays.
    pub first: usize,
    /// The last line, which is after the code and stays.
    pub end: usize,
}

pub(super) struct Source<'a> {
    pub lines: Vec<&'a str>,
}

/// A register's name, which is valid from this line on.
pub(super) struct Name<'a> {
    pub line: u64,
    pub name: &'a str,
    pub number: u8,
    /// Whether it is set inside a function, so that the schedule must repeat it.
    pub inside: bool,
}

type Fault = (u64, Unschedulable);

impl<'a> Source<'a> {
    pub fn new(text: &'a str) -> Self {
        Self { lines: text.lines().collect() }
    }

    /// The functions that the source contains.
    pub fn functions(&self) -> Result<Vec<Lines>, Fault> {
        let mut functions: Vec<Lines> = Vec::new();
        let mut at = 0;
        while at < self.lines.len() {
            let Some(name) = self.starts(at) else {
                at += 1;
                continue;
            };
            let after = self.lines.iter().enumerate().skip(at + 1);
            let mut ends = after.filter(|(_, line)| ends(line, name));
            let Some((end, _)) = ends.next() else {
                return Err((at as u64 + 1, Unschedulable::NoEnd(name.to_owned())));
            };
            functions.push(Lines { name: name.to_owned(), first: at, end });
            at = end + 1;
        }
        Ok(functions)
    }

    /// The function that starts at a line, by the macro or by a label of function type.
    fn starts(&self, at: usize) -> Option<&'a str> {
        let line = code(self.lines[at]).trim();
        if let Some(name) = line.strip_prefix("function ") {
            return Some(name.trim());
        }
        let name = line.strip_suffix(':')?.trim();
        let typed = |line: &&&str| {
            let line = code(line).trim();
            let rest = line.strip_prefix(".type").unwrap_or_default();
            rest.contains("function") && rest.split(',').next().map(str::trim) == Some(name)
        };
        self.lines.iter().find(typed).map(|_| name)
    }

    /// Reports anything in a function that the schedule would lose.
    pub fn check(&self, function: &Lines) -> Result<(), Fault> {
        for at in function.first + 1..function.end {
            let word = code(self.lines[at]).split_whitespace().next();
            if let Some(word) = word.filter(|word| word.starts_with('.') && !word.ends_with(':'))
                && !EXPANDED.contains(&word)
            {
                return Err((at as u64 + 1, Unschedulable::Directive(word.to_owned())));
            }
        }
        Ok(())
    }

    /// A line's comment without `#`. Lines count from 1.
    pub fn comment(&self, line: u64) -> &'a str {
        let text = (line as usize).checked_sub(1).and_then(|at| self.lines.get(at));
        let comment = text.and_then(|text| text.split_once('#'));
        comment.map_or("", |(_, comment)| comment.trim())
    }

    /// The names of registers. `numbers` are the values at the end of the source. A name whose
    /// value has changed, or that is also used as a plain number, is left out. Only these values
    /// are known of included files: if the source has no name for a number, the alphabetically
    /// first of their names is used.
    pub fn register_names<'n>(
        &self,
        functions: &[Lines],
        numbers: &'n BTreeMap<String, u64>,
    ) -> Vec<Name<'n>>
    where
        'a: 'n,
    {
        let mut names = self.included_names(numbers);
        for (at, line) in self.lines.iter().enumerate() {
            let Some((name, value)) = set(line) else {
                continue;
            };
            let number = numbers.get(name).copied().filter(|&number| number < 128);
            let changed = value.parse().is_ok_and(|value: u64| Some(value) != number);
            let Some(number) = number.filter(|_| !changed && !self.used_bare(name)) else {
                continue;
            };
            names.push(Name {
                line: at as u64 + 1,
                name,
                number: number as u8,
                inside: functions.iter().any(|lines| (lines.first..lines.end).contains(&at)),
            });
        }
        names
    }

    fn included_names<'n>(&self, numbers: &'n BTreeMap<String, u64>) -> Vec<Name<'n>> {
        let own: Vec<&str> = self.lines.iter().filter_map(|line| Some(set(line)?.0)).collect();
        let is_taken = |number: u64| own.iter().any(|&name| numbers.get(name) == Some(&number));
        let mut by_number: BTreeMap<u64, Vec<&'n str>> = BTreeMap::new();
        for (name, &number) in numbers {
            // Constants have names in capitals.
            let is_register = number < 128 && name.starts_with(|c: char| c.is_ascii_lowercase());
            if is_register && !own.contains(&name.as_str()) && !is_taken(number) {
                by_number.entry(number).or_default().push(name);
            }
        }
        // They are in alphabetical order.
        let first = by_number.into_iter();
        first
            .map(|(number, names)| Name {
                line: 0,
                name: names[0],
                number: number as u8,
                inside: false,
            })
            .collect()
    }

    /// Whether a name is used somewhere without the `$` of a register.
    fn used_bare(&self, name: &str) -> bool {
        self.lines.iter().any(|line| {
            if set(line).is_some_and(|(set, _)| set == name) {
                return false;
            }
            let line = code(line);
            let first = line.split_whitespace().next().unwrap_or_default();
            // Arguments of macros are often only part of a name.
            let counts = Op::of_mnemonic(first).is_some() || [".set", ".rept"].contains(&first);
            let in_name = |c: char| c.is_ascii_alphanumeric() || "_.$\\".contains(c);
            counts
                && line.match_indices(name).any(|(at, _)| {
                    let before = line[..at].chars().next_back();
                    let after = line[at + name.len()..].chars().next();
                    at > 0
                        && !before.is_some_and(in_name)
                        && !after.is_some_and(in_name)
                        && !line[..at].trim().is_empty()
                })
        })
    }

    /// The registers that the header lists as results of a function, or `None` if it has no such
    /// line.
    pub fn results(&self, function: &Lines) -> Option<Registers> {
        let header = self.lines[..function.first].iter().rposition(|line| out(line).is_some())?;
        let mut registers = 0;
        let first = out(self.lines[header]).unwrap_or_default();
        let more = self.lines[header + 1..].iter();
        let more = more.map_while(|line| line.strip_prefix(FURTHER));
        for text in [first].into_iter().chain(more) {
            registers |= named_registers(text);
        }
        Some(registers)
    }

    /// The line of the header that lists the registers that a function writes, counted from 0.
    pub fn uses(&self, function: &Lines) -> Option<usize> {
        self.lines[..function.first].iter().rposition(|line| line.starts_with(USES))
    }

    /// Copies lines, counted from 0. A line that names the source, called `path`, follows the
    /// leading comment. The lines of `used` get these registers instead of their own.
    pub fn copy(
        &self,
        range: Range<usize>,
        path: &str,
        used: &BTreeMap<usize, Registers>,
        text: &mut String,
    ) {
        let header = self.lines.iter().take_while(|line| line.starts_with('#'));
        let after = header.count();
        for at in range {
            if at == after {
                let name = Path::new(path).file_name().unwrap_or_default();
                text.push_str("# Scheduled by spu schedule from ");
                text.push_str(&name.to_string_lossy());
                text.push('\n');
            }
            match used.get(&at) {
                Some(&registers) => push_uses(self.lines[at], registers, text),
                None => text.push_str(self.lines[at]),
            }
            text.push('\n');
        }
    }
}

/// A line without its comment.
fn code(line: &str) -> &str {
    line.split('#').next().unwrap_or_default()
}

/// The name and value of a `.set`.
fn set(line: &str) -> Option<(&str, &str)> {
    let rest = code(line).trim().strip_prefix(".set")?;
    let (name, value) = rest.split_once(',')?;
    Some((name.trim(), value.trim()))
}

fn ends(line: &str, name: &str) -> bool {
    let line = code(line).trim();
    let of = |prefix| {
        let rest = line.strip_prefix(prefix)?;
        Some(rest.split(',').next()?.trim() == name)
    };
    of("endfunction ").or_else(|| of(".size ")) == Some(true)
}

/// The text after `Out` in a line of the header.
fn out(line: &str) -> Option<&str> {
    let text = line.strip_prefix('#')?;
    let (before, after) = text.split_once("Out ")?;
    let first = before.trim().is_empty();
    (first && before.len() == 3 || before.ends_with("  ")).then_some(after)
}

/// Parses registers and ranges of them, such as `$3` and `$10-$12`.
fn named_registers(text: &str) -> Registers {
    let mut registers = 0;
    let mut before: Option<(u8, &str)> = None;
    for part in text.split('$').skip(1) {
        let digits = part.bytes().take_while(u8::is_ascii_digit).count();
        let Ok(number) = part[..digits].parse::<u8>() else {
            before = None;
            continue;
        };
        let rest = &part[digits..];
        let from = match before {
            Some((from, "-")) => from,
            _ => number,
        };
        registers |= (from..=number).fold(0, |set, register| set | bit(register));
        before = Some((number, rest));
    }
    registers
}

/// Copies the header line of the registers that a function writes, but with these registers. The
/// rest of the line stays.
fn push_uses(line: &str, registers: Registers, text: &mut String) {
    let given = &line[USES.len()..];
    let rest = given.find("   ").map_or("", |at| &given[at..]);
    let mut ranges = ranges(registers);
    let last = ranges.pop().unwrap_or_else(|| "-".to_owned());
    let parts = ranges.into_iter().map(|range| range + ",");
    let mut written = USES.to_owned();
    for part in parts.chain([last + rest]) {
        if !written.ends_with("  ") {
            let fits = written.len() + 1 + part.len() <= WIDTH;
            if fits {
                written.push(' ');
            } else {
                text.push_str(&written);
                text.push('\n');
                written = FURTHER.to_owned();
            }
        }
        written.push_str(&part);
    }
    text.push_str(&written);
}

/// The registers from $2 on in the notation `$3` and `$10-$12`.
fn ranges(registers: Registers) -> Vec<String> {
    let mut ranges = Vec::new();
    let mut register = 2u8;
    while register < 128 {
        let first = register;
        while register < 128 && registers & bit(register) != 0 {
            register += 1;
        }
        match register - first {
            0 => register += 1,
            1 => ranges.push(format!("${first}")),
            _ => ranges.push(format!("${first}-${}", register - 1)),
        }
    }
    ranges
}

#[cfg(test)]
mod tests {
    use super::*;

    fn written(line: &str, registers: &[u8]) -> String {
        let set = registers.iter().fold(0, |set, &register| set | bit(register));
        let mut text = String::new();
        push_uses(line, set, &mut text);
        text
    }

    #[test]
    fn a_header_is_given_the_registers_that_the_schedule_writes() {
        let line = "#   Uses    $3-$4, $10-$23   Saves  -   Stack  0   Calls  -";
        assert_eq!(
            written(line, &[0, 1, 3, 5, 6, 7, 79, 127]),
            "#   Uses    $3, $5-$7, $79, $127   Saves  -   Stack  0   Calls  -"
        );
        assert_eq!(written("#   Uses    $3", &[2]), "#   Uses    $2");
        assert_eq!(written("#   Uses    $3   Saves  -", &[]), "#   Uses    -   Saves  -");
    }

    #[test]
    fn many_registers_take_further_lines() {
        let every_other: Vec<u8> = (2..80).step_by(2).collect();
        let text = written("#   Uses    $3   Saves  -   Stack  0   Calls  -", &every_other);
        let lines: Vec<&str> = text.lines().collect();
        assert!(lines.len() > 1 && lines.iter().all(|line| line.len() <= WIDTH), "{text}");
        assert!(lines[1..].iter().all(|line| line.starts_with(FURTHER)), "{text}");
        assert_eq!(
            named_registers(&text),
            every_other.iter().fold(0, |set, &register| set | bit(register))
        );
        assert!(text.ends_with("$78   Saves  -   Stack  0   Calls  -"), "{text}");
    }
}
