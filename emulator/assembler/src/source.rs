//! Assembles a source: one pass over its statements fills the sections, and afterwards each
//! operand that was not known yet becomes a number or a relocation.

use spu_isa::{Instruction, Op};

use crate::cursor::{Cursor, statements};
use crate::diagnostic::{Diagnostic, Errors, Fault, Position};
use crate::directive::Stack;
use crate::expression::{self, Base, Expression, Value};
use crate::program::{
    Binding, Place, Program, Relocation, RelocationKind, Section, Symbol, SymbolKind, Target,
};
use crate::symbols::{Definition, SymbolId, Symbols};

/// The largest section: many times the local store.
const LARGEST: usize = 1 << 24;

/// An operand or a number whose value is not known yet.
pub(crate) struct Fixup {
    pub section: usize,
    pub offset: u32,
    pub field: Field,
    pub value: Expression,
    pub at: usize,
}

/// What a fixup changes.
#[derive(Clone, Copy)]
pub(crate) enum Field {
    /// Data with this number of bytes.
    Data(usize),
    /// An operand of an instruction.
    Operand(RelocationKind, (i64, i64)),
    /// A conversion's scale, for which there is no relocation.
    Constant((i64, i64)),
    /// A word or doubleword that gets an address of the PPE.
    Ppu(RelocationKind),
}

impl Field {
    const fn relocation(self) -> Option<RelocationKind> {
        match self {
            Self::Data(4) => Some(RelocationKind::Addr32),
            Self::Operand(kind, _) | Self::Ppu(kind) => Some(kind),
            Self::Data(_) | Self::Constant(_) => None,
        }
    }
}

/// A source that is being assembled.
pub(crate) struct Source<'a> {
    text: &'a str,
    pub sections: Vec<Section>,
    pub symbols: Symbols,
    pub stack: Stack,
    pub fixups: Vec<Fixup>,
    pub warnings: Vec<Fault>,
    pub uses_macros: bool,
}

/// Assembles a source. `name` is its name in messages.
pub(crate) fn assemble(name: &str, text: &str) -> Result<Program, Errors> {
    let mut source = Source {
        text,
        sections: Vec::new(),
        symbols: Symbols::default(),
        stack: Stack::default(),
        fixups: Vec::new(),
        warnings: Vec::new(),
        uses_macros: false,
    };
    source.section(".text");
    let mut faults = source.read();
    faults.extend(source.symbols.settle());
    source.fill_ends();
    let ids = source.exported();
    // An instruction with an error is missing, though one of its operands may have a fixup.
    if faults.is_empty() {
        faults.extend(source.relocate(&ids));
    }
    let (symbols, bad) = source.symbol_table(&ids);
    faults.extend(bad);
    let lines = Lines::new(text);
    let diagnose = |mut faults: Vec<Fault>| -> Vec<Diagnostic> {
        faults.sort_by_key(|fault| fault.at);
        let diagnostic = |fault: Fault| Diagnostic {
            file: name.to_owned(),
            position: lines.position(text, fault.at),
            message: fault.message,
        };
        faults.into_iter().map(diagnostic).collect()
    };
    if !faults.is_empty() {
        return Err(Errors { errors: diagnose(faults), uses_macros: source.uses_macros });
    }
    for section in &mut source.sections {
        for relocation in &mut section.relocations {
            // Until now, the line is the byte of the source.
            relocation.position = lines.position(text, relocation.position.line as usize);
        }
        for (_, position) in &mut section.places {
            *position = lines.position(text, position.line as usize);
        }
        section.relocations.sort_by_key(|relocation| relocation.offset);
    }
    let warnings = diagnose(source.warnings);
    Ok(Program { file: name.to_owned(), sections: source.sections, symbols, warnings })
}

/// Where the lines of a source begin.
struct Lines(Vec<usize>);

impl Lines {
    fn new(text: &str) -> Self {
        Self(std::iter::once(0).chain(text.match_indices('\n').map(|(at, _)| at + 1)).collect())
    }

    fn position(&self, text: &str, at: usize) -> Position {
        let line = self.0.partition_point(|&start| start <= at);
        let start = self.0[line - 1];
        let column = text.get(start..at).map_or(0, |before| before.chars().count()) + 1;
        Position { line: line as u32, column: column as u32 }
    }
}

impl Source<'_> {
    /// Reads all statements. After an error it goes on with the next one.
    fn read(&mut self) -> Vec<Fault> {
        let (clean, statements) = match statements(self.text) {
            Ok(found) => found,
            Err(fault) => return vec![fault],
        };
        let mut faults = Vec::new();
        for (start, end) in statements {
            let mut cursor = Cursor::new(&clean, start, end);
            if let Err(fault) = self.statement(&mut cursor) {
                faults.push(fault);
            }
        }
        faults
    }

    fn statement(&mut self, cursor: &mut Cursor<'_>) -> Result<(), Fault> {
        loop {
            cursor.skip_space();
            let start = cursor.clone();
            let word = match cursor.peek() {
                None => return Ok(()),
                Some(c) if c.is_ascii_digit() => cursor.take_while(|c| c.is_ascii_digit()),
                Some(_) => cursor.name().ok_or_else(|| cursor.unexpected("a statement"))?,
            };
            if cursor.take(":") {
                let place = self.here();
                self.symbols.define(word, place, start.at)?;
                continue;
            }
            if word.starts_with(|c: char| c.is_ascii_digit()) {
                *cursor = start;
                return Err(cursor.unexpected("a statement"));
            }
            if cursor.take("=") {
                cursor.take("=");
                let value = self.expression(cursor)?;
                self.symbols.set(word, value, start.at)?;
                return cursor.finish();
            }
            let lower = word.to_ascii_lowercase();
            if let Some((op, features)) = crate::instruction::of_mnemonic(&lower) {
                return self.instruction(&lower, op, features, cursor);
            }
            return self.directive(&lower, start.at, cursor);
        }
    }

    /// The section and offset of the next byte.
    pub(crate) fn here(&self) -> (usize, u32) {
        let section = self.stack.current;
        (section, self.sections[section].size())
    }

    pub(crate) fn expression(&mut self, cursor: &mut Cursor<'_>) -> Result<Expression, Fault> {
        let here = self.here();
        expression::parse(cursor, &mut self.symbols, here)
    }

    /// A number that must be known here.
    pub(crate) fn number(&mut self, cursor: &mut Cursor<'_>) -> Result<i64, Fault> {
        cursor.skip_space();
        let at = cursor.at;
        let value = self.expression(cursor)?;
        let value = self.symbols.evaluate(&value).map_err(|message| Fault::new(at, message))?;
        value.constant().ok_or_else(|| Fault::new(at, "this number must be known here"))
    }

    /// Appends bytes to the current section.
    pub(crate) fn emit(&mut self, bytes: &[u8], at: usize) -> Result<(), Fault> {
        let section = &mut self.sections[self.stack.current];
        if section.zeros && bytes.iter().any(|&byte| byte != 0) {
            return Err(Fault::new(at, format!("{} has zeros only", section.name)));
        }
        if section.bytes.len() + bytes.len() > LARGEST {
            return Err(Fault::new(at, format!("{} is larger than 16 MB", section.name)));
        }
        if section.executable && !bytes.is_empty() {
            // The byte of the source becomes a line when all are known.
            section.places.push((section.size(), Position { line: at as u32, column: 0 }));
        }
        section.bytes.extend_from_slice(bytes);
        Ok(())
    }

    /// Appends this byte `count` times.
    pub(crate) fn emit_run(&mut self, byte: u8, count: i64, at: usize) -> Result<(), Fault> {
        match usize::try_from(count).ok().filter(|&count| count <= LARGEST) {
            Some(count) => self.emit(&vec![byte; count], at),
            None => Err(Fault::new(at, format!("{count} is no size of at most 16 MB"))),
        }
    }

    /// Aligns the current section. Code is filled with instructions that do nothing, each in the
    /// slot of its own pipe.
    pub(crate) fn align(
        &mut self,
        alignment: u32,
        fill: Option<u8>,
        most: i64,
        at: usize,
    ) -> Result<(), Fault> {
        let section = &mut self.sections[self.stack.current];
        section.alignment = section.alignment.max(alignment);
        let gap = section.size().next_multiple_of(alignment) - section.size();
        if most > 0 && i64::from(gap) > most {
            return Ok(());
        }
        match fill {
            Some(fill) => self.emit_run(fill, gap.into(), at),
            None => {
                let bytes = padding(section, gap);
                self.emit(&bytes, at)
            }
        }
    }

    /// Fills each section up to its own alignment, as the GNU assembler does.
    fn fill_ends(&mut self) {
        for section in &mut self.sections {
            let gap = section.size().next_multiple_of(section.alignment) - section.size();
            let bytes = padding(section, gap);
            section.bytes.extend(bytes);
        }
    }

    /// The symbols that other files or tools may see.
    fn exported(&self) -> Vec<SymbolId> {
        let is_seen = |symbol: &crate::symbols::SourceSymbol| {
            let is_known = match &symbol.definition {
                Definition::Set(Expression::Leaf(value)) => value.constant().is_some(),
                Definition::Set(_) => false,
                _ => true,
            };
            let is_label = symbol.name.starts_with(".L") && symbol.definition != Definition::None;
            is_known && !symbol.hidden && !is_label
        };
        self.symbols.iter().filter(|(_, symbol)| is_seen(symbol)).map(|(id, _)| id).collect()
    }

    fn symbol_table(&self, ids: &[SymbolId]) -> (Vec<Symbol>, Vec<Fault>) {
        let mut faults = Vec::new();
        let table = ids.iter().map(|&id| {
            let symbol = &self.symbols[id];
            let size = symbol.size.as_ref().map_or(Ok(0), |(at, size)| {
                let value = self.symbols.evaluate(size).ok().and_then(Value::constant);
                value.ok_or_else(|| {
                    Fault::new(*at, format!("the size of {} is no number", symbol.name))
                })
            });
            let size = size.unwrap_or_else(|fault| {
                faults.push(fault);
                0
            });
            let (place, binding) = match &symbol.definition {
                Definition::Label(section, offset) => {
                    (Place::Section(*section, *offset), symbol.binding)
                }
                Definition::Set(Expression::Leaf(value)) => {
                    (Place::Absolute(value.number as u32), symbol.binding)
                }
                Definition::Common(alignment) => (Place::Common(*alignment), Binding::Global),
                _ if symbol.binding == Binding::Weak => (Place::Undefined, Binding::Weak),
                _ => (Place::Undefined, Binding::Global),
            };
            let (name, kind, size) = (symbol.name.clone(), symbol.kind, size as u32);
            Symbol { name, place, binding, kind, size }
        });
        let table = table.collect();
        (table, faults)
    }

    /// Gives each fixup its number or its relocation.
    fn relocate(&mut self, ids: &[SymbolId]) -> Vec<Fault> {
        let fixups = std::mem::take(&mut self.fixups);
        let settled = fixups.iter().filter_map(|fixup| {
            self.fix(fixup, ids).err().map(|message| Fault::new(fixup.at, message))
        });
        settled.collect()
    }

    fn fix(&mut self, fixup: &Fixup, ids: &[SymbolId]) -> Result<(), String> {
        let &Fixup { section, offset, field, .. } = fixup;
        let mut value = self.symbols.evaluate(&fixup.value)?;
        let mut kind = field.relocation();
        if let Some(minus) = value.minus {
            // The distance from a place in the same section is one from here.
            let from = self.symbols.place(minus).filter(|&(other, _)| other == section);
            let Some((_, from)) = from.filter(|_| matches!(field, Field::Data(4))) else {
                return Err("the distance between these places is not known".to_owned());
            };
            value.minus = None;
            value.number = value.number.wrapping_add(i64::from(offset) - from);
            kind = Some(RelocationKind::Rel32);
        }
        let is_ppu = matches!(field, Field::Ppu(_));
        let is_relative = kind.is_some_and(RelocationKind::is_relative);
        let Some(base) = value.plus else {
            if !is_relative && !is_ppu {
                return self.put(fixup, value.number);
            }
            let kind = kind.ok_or("an address is not possible here")?;
            return self.add(fixup, kind, Target::Absolute, value.number);
        };
        if self.symbols.is_open(base) {
            return Err("this symbol is defined by itself".to_owned());
        }
        let place = self.symbols.place(base);
        let named = match base {
            Base::Symbol(id) => Some((id, &self.symbols[id])),
            Base::Section(_) => None,
        };
        let is_local = named.is_none_or(|(_, symbol)| symbol.binding == Binding::Local);
        let is_function = named.is_some_and(|(_, symbol)| symbol.kind == SymbolKind::Function);
        // A linker may drop a group's section, but never a symbol.
        let in_group =
            named.is_some() && place.is_some_and(|(other, _)| self.sections[other].group.is_some());
        if let Some((other, to)) = place
            && is_local
            && is_relative
            && other == section
            && !self.keeps_relocation(fixup, is_function)
        {
            return self.put(fixup, value.number.wrapping_add(to - i64::from(offset)));
        }
        let kind = kind.ok_or("the address of a symbol does not fit here")?;
        match (place, named) {
            (Some((other, to)), _) if is_local && !is_function && !in_group => {
                self.add(fixup, kind, Target::Section(other), value.number.wrapping_add(to))
            }
            (_, Some((id, symbol))) => {
                let index = ids
                    .binary_search(&id)
                    .map_err(|_| format!("there is no label {} here", symbol.name))?;
                self.add(fixup, kind, Target::Symbol(index), value.number)
            }
            (_, None) => Err("the address of this place is not known".to_owned()),
        }
    }

    /// Whether a branch to a known place gets a relocation, from which tools see calls.
    fn keeps_relocation(&self, fixup: &Fixup, is_function: bool) -> bool {
        let bytes = &self.sections[fixup.section].bytes[fixup.offset as usize..];
        let word = bytes.first_chunk().map(|&bytes| u32::from_be_bytes(bytes));
        match (fixup.field, word.and_then(Op::of_word)) {
            (Field::Operand(RelocationKind::Rel16, _), Some(Op::Brsl)) => true,
            (Field::Operand(RelocationKind::Rel16, _), Some(Op::Br)) => is_function,
            _ => false,
        }
    }

    fn add(
        &mut self,
        fixup: &Fixup,
        kind: RelocationKind,
        target: Target,
        addend: i64,
    ) -> Result<(), String> {
        let addend =
            i32::try_from(addend).map_err(|_| format!("{addend} has more than 32 bits"))?;
        // The byte of the source becomes a line when all are known.
        let position = Position { line: fixup.at as u32, column: 0 };
        let relocation = Relocation { offset: fixup.offset, kind, target, addend, position };
        self.sections[fixup.section].relocations.push(relocation);
        Ok(())
    }

    /// Puts a number that has become known in its place.
    fn put(&mut self, fixup: &Fixup, value: i64) -> Result<(), String> {
        let bytes = &mut self.sections[fixup.section].bytes[fixup.offset as usize..];
        match fixup.field {
            Field::Data(size) => {
                if let Some(warning) = truncated(value, size) {
                    self.warnings.push(Fault::new(fixup.at, warning));
                }
                bytes[..size].copy_from_slice(&value.to_be_bytes()[8 - size..]);
            }
            Field::Operand(kind, range) => {
                check(value, range)?;
                kind.apply(value, bytes);
            }
            Field::Constant(range) => {
                check(value, range)?;
                if let Some(word) = bytes.first_chunk_mut::<4>()
                    && let Some(mut i) = Instruction::decode(u32::from_be_bytes(*word))
                {
                    i.immediate = value as i32;
                    *word = i.encode().to_be_bytes();
                }
            }
            Field::Ppu(kind) => kind.apply(value, bytes),
        }
        Ok(())
    }
}

/// A number must be in this range.
pub(crate) fn check(value: i64, (minimum, maximum): (i64, i64)) -> Result<(), String> {
    if (minimum..=maximum).contains(&value) {
        return Ok(());
    }
    Err(format!("{value} is outside {minimum} to {maximum}"))
}

/// A warning, if a number does not fit into `size` bytes.
pub(crate) fn truncated(value: i64, size: usize) -> Option<String> {
    let bits = 8 * size as u32;
    let fits = bits == 64 || (-1 << (bits - 1)..1 << bits).contains(&value);
    (!fits).then(|| format!("of {value:#x} only the low {bits} bits are stored"))
}

/// The bytes that fill a gap.
fn padding(section: &Section, gap: u32) -> Vec<u8> {
    const NOP: u32 = 0x4020_0000;
    const LNOP: u32 = 0x0020_0000;
    if !section.executable {
        return vec![0; gap as usize];
    }
    let end = section.size() + gap;
    let first = section.size().next_multiple_of(4).min(end);
    let zeros = std::iter::repeat_n(0, (first - section.size()) as usize);
    let slots = (first..end).step_by(4).map(|at| if at & 4 == 0 { NOP } else { LNOP });
    zeros.chain(slots.flat_map(u32::to_be_bytes)).collect()
}
