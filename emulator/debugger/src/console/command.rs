//! The console's commands.

use super::closest;

pub const HELP: &str = "\
break PLACE             halt before the instruction at PLACE             b
delete [PLACE]          remove the breakpoint there, or all              d
breakpoints             list them
continue                run to a breakpoint or the program's end         c
step [N]                run one instruction, or N                        s
next [N]                the same, but a call counts as one               n
finish                  run until this function has returned
registers [float] [$N]  all registers or some, as hex words or floats    r, p
set $N WORD...          change a register's first word, or all four
set $pc PLACE           go on elsewhere
set PLACE WORD          change a word of local store
memory PLACE [N]        N words of local store, 16 at first              x
disassemble [PLACE] [N] N instructions, 10 at first                      dis
backtrace               the functions that were called, by the stack     bt
frame                   the next instruction                             f
mfc                     DMA commands that are not complete, tags
channels                mailboxes, signals, events, decrementer          ch
cycles                  the clock, in simulated time
quit                    end the program and the session                  q
PLACE is an address, a symbol, symbol+offset, or $pc. Numbers are decimal, or hexadecimal after 0x.
An empty line does nothing. The end of the commands is quit.
";

/// A place in local store.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Target {
    /// The program counter.
    Here,
    Address(u32),
    /// A symbol, and the distance from it.
    Symbol(String, u32),
}

/// Which registers to show, and how.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Wanted {
    pub as_floats: bool,
    /// All, if there are none.
    pub numbers: Vec<u8>,
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Command {
    Break(Target),
    Delete(Option<Target>),
    Breakpoints,
    Continue,
    Step(u64),
    Next(u64),
    Finish,
    Registers(Wanted),
    /// The first word, or all four.
    SetRegister(u8, Vec<u32>),
    SetPc(Target),
    SetWord(Target, u32),
    Memory(Target, u32),
    /// Without a place, around the program counter.
    Disassemble(Option<Target>, u32),
    Backtrace,
    Frame,
    Mfc,
    Channels,
    Cycles,
    Help,
    Quit,
}

/// The commands' names, and what else they can be called.
const NAMES: [(&str, &[&str]); 20] = [
    ("break", &["b"]),
    ("delete", &["d"]),
    ("breakpoints", &[]),
    ("continue", &["c"]),
    ("step", &["s", "si", "stepi"]),
    ("next", &["n", "ni", "nexti"]),
    ("finish", &["fin"]),
    ("registers", &["r", "regs", "p", "print"]),
    ("set", &[]),
    ("memory", &["x", "mem"]),
    ("disassemble", &["dis"]),
    ("backtrace", &["bt", "where"]),
    ("frame", &["f"]),
    ("mfc", &[]),
    ("channels", &["ch"]),
    ("cycles", &[]),
    ("help", &["h", "?"]),
    ("quit", &["q", "exit"]),
    ("run", &[]),
    ("list", &["l"]),
];

fn number(text: &str) -> Result<u64, String> {
    let parsed = match text.strip_prefix("0x").or_else(|| text.strip_prefix("0X")) {
        Some(digits) => u64::from_str_radix(digits, 16),
        None => text.parse(),
    };
    parsed.map_err(|_| format!("{text} is no number"))
}

/// A word, which may be negative.
fn word(text: &str) -> Result<u32, String> {
    let (digits, is_negative) = match text.strip_prefix('-') {
        Some(digits) => (digits, true),
        None => (text, false),
    };
    let value = number(digits)?;
    let word = u32::try_from(value).map_err(|_| format!("{text} does not fit in 32 bits"))?;
    Ok(if is_negative { word.wrapping_neg() } else { word })
}

fn place(text: &str) -> Result<Target, String> {
    let text = text.strip_prefix('*').unwrap_or(text);
    if text == "$pc" || text == "." {
        return Ok(Target::Here);
    }
    if text.starts_with(|first: char| first.is_ascii_digit()) {
        return word(text).map(Target::Address);
    }
    match text.split_once('+') {
        Some((symbol, distance)) => Ok(Target::Symbol(symbol.into(), word(distance)?)),
        None => Ok(Target::Symbol(text.into(), 0)),
    }
}

/// `$3`
fn register(text: &str) -> Result<u8, String> {
    const COUNT: u8 = 128;
    let named = match text {
        "$lr" => Some(0),
        "$sp" => Some(1),
        _ => text.strip_prefix('$').and_then(|digits| digits.parse().ok()),
    };
    named
        .filter(|&number| number < COUNT)
        .ok_or_else(|| format!("{text} is no register; they are $0 to $127, $lr and $sp"))
}

fn registers(arguments: &[&str]) -> Result<Command, String> {
    let mut wanted = Wanted::default();
    for &argument in arguments {
        match argument {
            "float" | "floats" => wanted.as_floats = true,
            _ => wanted.numbers.push(register(argument)?),
        }
    }
    Ok(Command::Registers(wanted))
}

fn set(arguments: &[&str]) -> Result<Command, String> {
    let expected = "set needs a register or place and its value: set $3 5, set main+16 0x40200000";
    let (&target, values) = arguments.split_first().ok_or(expected)?;
    let values = match values {
        ["=", values @ ..] => values,
        values => values,
    };
    match (target, values) {
        ("$pc", [to]) => Ok(Command::SetPc(place(to)?)),
        (_, [_] | [_, _, _, _]) if target.starts_with('$') => {
            let words = values.iter().map(|value| word(value));
            Ok(Command::SetRegister(register(target)?, words.collect::<Result<_, _>>()?))
        }
        (_, [value]) if !target.starts_with('$') => {
            Ok(Command::SetWord(place(target)?, word(value)?))
        }
        _ if target.starts_with('$') => Err(format!("{target} takes one word, or four")),
        _ => Err(expected.into()),
    }
}

/// The command's whole name.
fn known(asked: &str) -> Result<&'static str, String> {
    let named = NAMES.iter().find(|(name, others)| *name == asked || others.contains(&asked));
    if let Some((name, _)) = named {
        return Ok(name);
    }
    let names = NAMES.iter().map(|(name, _)| *name);
    Err(match closest(asked, names) {
        Some(name) => format!("there is no command {asked}; did you mean {name}?"),
        None => format!("there is no command {asked}; help lists them"),
    })
}

/// What a line asks for; `None` if it is empty or a comment.
pub fn parse(line: &str) -> Result<Option<Command>, String> {
    let line = line.split('#').next().unwrap_or_default();
    let mut words: Vec<&str> = line.split_whitespace().collect();
    if words.first() == Some(&"info") {
        // As in gdb.
        words.remove(0);
        if words.is_empty() {
            words.push("help");
        }
    }
    let Some((&asked, arguments)) = words.split_first() else {
        return Ok(None);
    };
    let name = known(asked)?;
    let count = |default: u64| match arguments {
        [] => Ok(default),
        [count] => match number(count)? {
            0 => Err(format!("{name} needs at least 1")),
            count => Ok(count),
        },
        _ => Err(format!("{name} takes one number")),
    };
    let some = |default: u32, text: Option<&&str>| match text {
        None => Ok(default),
        Some(text) => match number(text)? {
            many @ 1..=0x1_0000 => Ok(many as u32),
            _ => Err(format!("{text} is not 1 to 65536")),
        },
    };
    let none = |command: Command| match arguments {
        [] => Ok(command),
        _ => Err(format!("{name} takes nothing")),
    };
    let command = match name {
        "break" => match arguments {
            [] => Command::Break(Target::Here),
            [at] => Command::Break(place(at)?),
            _ => return Err("break takes one place".into()),
        },
        "delete" => match arguments {
            [] => Command::Delete(None),
            [at] => Command::Delete(Some(place(at)?)),
            _ => return Err("delete takes one place".into()),
        },
        "breakpoints" => none(Command::Breakpoints)?,
        "continue" | "run" => none(Command::Continue)?,
        "step" => Command::Step(count(1)?),
        "next" => Command::Next(count(1)?),
        "finish" => none(Command::Finish)?,
        "registers" => registers(arguments)?,
        "set" => set(arguments)?,
        "memory" => match arguments {
            [at] | [at, _] => Command::Memory(place(at)?, some(16, arguments.get(1))?),
            _ => return Err("memory takes a place, and how many words".into()),
        },
        "disassemble" | "list" => match arguments {
            [] => Command::Disassemble(None, 10),
            [at] | [at, _] => Command::Disassemble(Some(place(at)?), some(10, arguments.get(1))?),
            _ => return Err("disassemble takes a place, and how many instructions".into()),
        },
        "backtrace" => none(Command::Backtrace)?,
        "frame" => none(Command::Frame)?,
        "mfc" => none(Command::Mfc)?,
        "channels" => none(Command::Channels)?,
        "cycles" => none(Command::Cycles)?,
        "quit" => none(Command::Quit)?,
        _ => Command::Help,
    };
    Ok(Some(command))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_read_as_in_gdb() {
        let symbol = |name: &str, distance| Target::Symbol(name.into(), distance);
        let lines = [
            ("b main", Command::Break(symbol("main", 0))),
            ("break *0x100", Command::Break(Target::Address(0x100))),
            ("info registers", Command::Registers(Wanted::default())),
            ("x main+0x10 4", Command::Memory(symbol("main", 16), 4)),
            ("set $3 = 1 2 3 -1", Command::SetRegister(3, vec![1, 2, 3, u32::MAX])),
            ("set 0x100 7", Command::SetWord(Target::Address(0x100), 7)),
            ("set $pc $pc", Command::SetPc(Target::Here)),
            ("c # go on", Command::Continue),
        ];
        for (line, command) in lines {
            assert_eq!(parse(line), Ok(Some(command)), "{line}");
        }
        assert_eq!(parse(""), Ok(None));
        assert_eq!(parse("# only this"), Ok(None));
    }

    #[test]
    fn wrong_lines_say_what_is_expected() {
        let lines = [
            ("contine", "did you mean continue?"),
            ("frobnicate", "help lists them"),
            ("step x", "x is no number"),
            ("step 0", "at least 1"),
            ("registers $128", "$0 to $127"),
            ("set", "set $3 5"),
            ("set $3 1 2", "one word, or four"),
            ("memory", "takes a place"),
            ("memory 0 0", "not 1 to 65536"),
            ("break 0x100000000", "does not fit in 32 bits"),
            ("continue 3", "takes nothing"),
        ];
        for (line, expected) in lines {
            let error = parse(line).expect_err(line);
            assert!(error.contains(expected), "{line}: {error}");
        }
    }
}
