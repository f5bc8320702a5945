//! Reads the tests that are written as text.

/// When a queued transfer is done: the policies of a machine in the host's time, and simulated
/// time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Moment {
    Once,
    Last,
    Timed,
}

pub struct Value {
    pub bytes: Vec<u8>,
}

impl Value {
    /// A register's value: four words, or the preferred word, with zeros in the others.
    pub fn quad(&self) -> spu_emulator::interp::Quad {
        let mut bytes = [0; 16];
        bytes[..self.bytes.len()].copy_from_slice(&self.bytes);
        spu_emulator::interp::Quad::from_bytes(bytes)
    }
}

/// Something that is given before the run, or expected after it.
pub enum Item {
    Register(u8, Value),
    LocalStore(u32, Value),
    Main(u64, Value),
    Inbound(Vec<u32>),
    Outbound(u32),
    Signal(usize, u32),
    ReadOnly(u64),
    Mapped(u64),
    Stop(Vec<String>),
    Figure(String, u64),
    Races(Vec<String>),
    RaceText(Vec<String>),
}

pub struct Expected {
    pub spe: usize,
    pub line: usize,
    pub text: String,
    pub moment: Option<Moment>,
    pub item: Item,
}

/// A program, what it is given, and what is expected of it.
pub struct Case {
    pub line: usize,
    pub name: String,
    pub code: String,
    pub spes: u64,
    pub only: Option<Moment>,
    pub given: Vec<Item>,
    pub expected: Vec<Expected>,
}

fn number(text: &str) -> Option<u64> {
    match text.strip_prefix("0x") {
        Some(hex) => u64::from_str_radix(hex, 16).ok(),
        None => text.parse().ok(),
    }
}

/// Bytes: parts joined by `+`. A part is a word, words joined by commas, `BYTE*COUNT`, or
/// `pattern*COUNT`.
fn value(text: &str) -> Option<Value> {
    let mut bytes = Vec::new();
    for part in text.split('+') {
        if let Some((byte, count)) = part.split_once('*') {
            let count = number(count)? as usize;
            match byte {
                "pattern" => bytes.extend((0..count).map(|n| (n * 13 + n / 251) as u8)),
                _ => bytes.resize(bytes.len() + count, u8::try_from(number(byte)?).ok()?),
            }
        } else {
            for word in part.split(',') {
                bytes.extend(u32::try_from(number(word)?).ok()?.to_be_bytes());
            }
        }
    }
    Some(Value { bytes })
}

fn item(text: &str) -> Option<Item> {
    let (key, rest) = text.split_once('=')?;
    let word = || u32::try_from(number(rest)?).ok();
    if let Some(register) = key.strip_prefix('$') {
        let value = value(rest)?;
        let register = register.parse().ok().filter(|number| *number < 128)?;
        return matches!(value.bytes.len(), 4 | 16).then_some(Item::Register(register, value));
    }
    if let Some(address) = key.strip_prefix("ls:") {
        return Some(Item::LocalStore(u32::try_from(number(address)?).ok()?, value(rest)?));
    }
    if let Some(offset) = key.strip_prefix("main:") {
        return Some(Item::Main(number(offset)?, value(rest)?));
    }
    Some(match key {
        "inbound" => {
            let words = rest.split(',').map(|word| u32::try_from(number(word)?).ok());
            Item::Inbound(words.collect::<Option<_>>()?)
        }
        "outbound" => Item::Outbound(word()?),
        "signal1" => Item::Signal(1, word()?),
        "signal2" => Item::Signal(2, word()?),
        "readonly" => Item::ReadOnly(number(rest)?),
        "mapped" => Item::Mapped(number(rest)?),
        "stop" => Item::Stop(vec![format!("stop {:#06x} ", number(rest)?)]),
        "cycles" | "stopped" => Item::Figure(key.into(), number(rest)?),
        "races" if rest == "none" => Item::Races(Vec::new()),
        "races" => Item::Races(rest.split(',').map(str::to_owned).collect()),
        _ if key.contains('.') => Item::Figure(key.into(), number(rest)?),
        _ => return None,
    })
}

impl Item {
    fn can_be_given(&self) -> bool {
        !matches!(
            self,
            Self::Outbound(_)
                | Self::Stop(_)
                | Self::Figure(..)
                | Self::Races(_)
                | Self::RaceText(_)
        )
    }

    /// The number and the value of a register.
    pub fn register(&self) -> Option<(u8, spu_emulator::interp::Quad)> {
        if let Self::Register(number, value) = self { Some((*number, value.quad())) } else { None }
    }

    fn can_be_expected(&self) -> bool {
        !matches!(self, Self::Inbound(_) | Self::Signal(..) | Self::ReadOnly(_) | Self::Mapped(_))
    }
}

/// A test as it is written, before the columns of its rows are filled in.
#[derive(Default)]
struct Text<'a> {
    line: usize,
    name: &'a str,
    lines: Vec<(usize, &'a str)>,
    rows: Vec<(usize, Vec<&'a str>)>,
}

/// Reads a file. A mistake in it fails the test, with its line.
pub fn parse(file: &str, text: &str) -> Vec<Case> {
    let mut texts: Vec<Text> = Vec::new();
    for (number, line) in (1..).zip(text.lines()) {
        if let Some(name) = line.strip_prefix("test ") {
            texts.push(Text { line: number, name, ..Text::default() });
        } else if !line.is_empty() && !line.starts_with('#') {
            let last = texts.last_mut();
            let last = last.unwrap_or_else(|| panic!("{file}:{number}: no test begins before"));
            match line.strip_prefix("@row ") {
                Some(row) => last.rows.push((number, row.split('|').map(str::trim).collect())),
                None => last.lines.push((number, line)),
            }
        }
    }
    texts.iter().flat_map(|text| cases(file, text)).collect()
}

fn cases(file: &str, text: &Text) -> Vec<Case> {
    if text.rows.is_empty() {
        return vec![case(file, text, text.line, &[])];
    }
    text.rows.iter().map(|(line, row)| case(file, text, *line, row)).collect()
}

fn case(file: &str, text: &Text, line: usize, row: &[&str]) -> Case {
    let name = [&[text.name], row].concat().join(" | ");
    let (given, expected) = (Vec::new(), Vec::new());
    let mut case = Case { line, name, code: String::new(), spes: 1, only: None, given, expected };
    for &(at, raw) in &text.lines {
        let filled = row.iter().enumerate().fold(raw.to_owned(), |line, (column, cell)| {
            line.replace(&format!("{{{column}}}"), &cell.replace("; ", "\n "))
        });
        let Some(directive) = filled.strip_prefix('@') else {
            case.code += &filled;
            case.code.push('\n');
            continue;
        };
        // A row's own line is more precise than the line that all rows share.
        let at = if raw == filled { at } else { line };
        let (what, rest) = directive.split_once(' ').unwrap_or((directive, ""));
        let bad = |part: &str| -> ! { panic!("{file}:{at}: `{part}` is not understood") };
        let moment = |name: &str| match name {
            "once" => Some(Moment::Once),
            "last" => Some(Moment::Last),
            "timed" => Some(Moment::Timed),
            _ => None,
        };
        match what {
            "spes" => case.spes = rest.parse().unwrap_or_else(|_| bad(rest)),
            "only" => case.only = Some(moment(rest).unwrap_or_else(|| bad(rest))),
            "given" => {
                for part in rest.split_whitespace() {
                    let item = item(part).filter(Item::can_be_given);
                    case.given.push(item.unwrap_or_else(|| bad(part)));
                }
            }
            _ => {
                let moment = moment(what);
                if moment.is_none() && what != "then" {
                    bad(what);
                }
                let mut expect = |text: &str, spe, item| {
                    case.expected.push(Expected { spe, line: at, text: text.into(), moment, item });
                };
                let parts = |text: &str| text.split(" & ").map(str::to_owned).collect();
                if let Some(text) = rest.strip_prefix("error ") {
                    expect(rest, 0, Item::Stop(parts(text)));
                    continue;
                }
                if let Some(text) = rest.strip_prefix("race ") {
                    expect(rest, 0, Item::RaceText(parts(text)));
                    continue;
                }
                for part in rest.split_whitespace() {
                    let (spe, text) = match part.split_once(':') {
                        Some((spe, text)) if spe.parse().is_ok_and(|spe: u64| spe < case.spes) => {
                            (spe.parse().unwrap(), text)
                        }
                        _ => (0, part),
                    };
                    let item = item(text).filter(Item::can_be_expected);
                    expect(part, spe, item.unwrap_or_else(|| bad(part)));
                }
            }
        }
    }
    case
}
