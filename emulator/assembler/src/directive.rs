//! Directives: sections, data, alignment, and facts about symbols.

use crate::cursor::Cursor;
use crate::diagnostic::Fault;
use crate::instruction::similar;
use crate::program::{Binding, RelocationKind, Section, SymbolKind};
use crate::source::{Field, Source, truncated};
use crate::symbols::Definition;

/// The current section, and those to return to.
#[derive(Default)]
pub(crate) struct Stack {
    pub current: usize,
    previous: usize,
    pushed: Vec<(usize, usize)>,
}

/// The directives of the GNU assembler for which its preprocessor or other files are needed.
const MACROS: &str = "macro endm exitm purgem rept irp irpc endr if ifdef ifndef ifb ifnb ifc ifnc \
    ifeq ifne else elseif endif include incbin altmacro error";

/// All others, for advice.
const DIRECTIVES: &str = ".text .data .bss .rodata .section .pushsection .popsection .previous \
    .align .p2align .balign .byte .short .hword .half .2byte .word .int .long .4byte .quad .8byte \
    .float .single .double .ascii .asciz .string .space .skip .zero .fill .set .equ .equiv .global \
    .globl .weak .extern .comm .size .type .ident .file .include .macro .rept .irp .if .endif";

impl Source<'_> {
    /// Carries out the directive with this name in small letters. The point before it may be
    /// missing.
    pub(crate) fn directive(
        &mut self,
        name: &str,
        at: usize,
        cursor: &mut Cursor<'_>,
    ) -> Result<(), Fault> {
        let bare = name.strip_prefix('.').unwrap_or(name);
        match bare {
            "text" | "data" | "bss" | "rodata" => {
                let name = format!(".{bare}");
                self.switch(&name);
            }
            "section" | "pushsection" => {
                let pushed = (self.stack.current, self.stack.previous);
                self.section_directive(cursor)?;
                if bare == "pushsection" {
                    self.stack.pushed.push(pushed);
                }
            }
            "popsection" => {
                let back = self.stack.pushed.pop();
                (self.stack.current, self.stack.previous) =
                    back.ok_or_else(|| Fault::new(at, "no .pushsection is before this"))?;
            }
            "previous" => std::mem::swap(&mut self.stack.current, &mut self.stack.previous),
            "align" | "p2align" | "balign" => self.align_directive(bare == "balign", cursor)?,
            "byte" => self.numbers(1, cursor)?,
            "short" | "hword" | "half" | "2byte" => self.numbers(2, cursor)?,
            "word" | "int" | "long" | "4byte" => self.numbers(4, cursor)?,
            "quad" | "8byte" => self.numbers(8, cursor)?,
            "float" | "single" => self.floats(cursor, |text| {
                let number: f32 = text.parse().ok()?;
                number.is_finite().then(|| number.to_be_bytes().to_vec())
            })?,
            "double" => self.floats(cursor, |text| {
                let number: f64 = text.parse().ok()?;
                number.is_finite().then(|| number.to_be_bytes().to_vec())
            })?,
            "ascii" => self.strings(&[], cursor)?,
            "asciz" | "string" => self.strings(&[0], cursor)?,
            "space" | "skip" | "zero" => {
                let count = self.number(cursor)?;
                let fill = if cursor.take(",") { self.number(cursor)? } else { 0 };
                self.emit_run(fill as u8, count, at)?;
            }
            "fill" => self.fill(at, cursor)?,
            "set" | "equ" | "equiv" | "eqv" => {
                cursor.skip_space();
                let at = cursor.at;
                let name = cursor.expect_name()?;
                cursor.expect(",")?;
                let value = self.expression(cursor)?;
                self.symbols.set(name, value, at)?;
            }
            "global" | "globl" | "weak" | "extern" => self.bind(bare, cursor)?,
            "comm" => self.common(cursor)?,
            "size" => {
                let name = cursor.expect_name()?;
                let id = self.symbols.mention(name, at);
                cursor.expect(",")?;
                let size = self.expression(cursor)?;
                self.symbols[id].size = Some((at, size));
            }
            "type" => self.type_directive(at, cursor)?,
            "ident" => {
                let string = cursor.string()?;
                self.ident(&string, at)?;
            }
            // The names of sources are in line tables only.
            "file" => drop(cursor.string()?),
            _ if MACROS.split(' ').any(|name| name == bare) => {
                self.uses_macros = true;
                let message = format!(
                    "{name} is for the SPU binutils: macros, conditions and other files are not \
                     assembled here"
                );
                return Err(Fault::new(at, message));
            }
            _ => {
                let what = if name.starts_with('.') { "directive" } else { "instruction" };
                let near = similar(name, DIRECTIVES.split(' '));
                return Err(Fault::new(at, format!("there is no {what} {name}{near}")));
            }
        }
        cursor.finish()
    }

    /// The section with this name, which is made if it is new.
    pub(crate) fn section(&mut self, name: &str) -> usize {
        if let Some(found) = self.sections.iter().position(|section| section.name == name) {
            return found;
        }
        let is = |prefix: &str| {
            let rest = name.strip_prefix(prefix);
            rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
        };
        let executable = is(".text") || is(".init") || is(".fini");
        let writable = is(".data") || is(".bss");
        self.sections.push(Section {
            name: name.to_owned(),
            allocated: executable || writable || is(".rodata"),
            writable,
            executable,
            zeros: is(".bss"),
            alignment: 1,
            ..Section::default()
        });
        self.sections.len() - 1
    }

    fn switch(&mut self, name: &str) {
        self.stack.previous = self.stack.current;
        self.stack.current = self.section(name);
    }

    /// `.section name,"flags",@type,size`
    fn section_directive(&mut self, cursor: &mut Cursor<'_>) -> Result<(), Fault> {
        let name = match cursor.peek() {
            Some('"') => String::from_utf8_lossy(&cursor.string()?).into_owned(),
            _ => cursor.take_while(|c| !c.is_whitespace() && c != ',').to_owned(),
        };
        if name.is_empty() {
            return Err(cursor.unexpected("a section's name"));
        }
        let is_new = self.sections.iter().all(|section| section.name != name);
        self.switch(&name);
        if !cursor.take(",") {
            return Ok(());
        }
        cursor.skip_space();
        let at = cursor.at;
        let flags = cursor.string()?;
        let has = |flag| flags.contains(&flag);
        if let Some(&flag) = flags.iter().find(|flag| !b"awxMSG".contains(flag)) {
            let flag = char::from(flag);
            return Err(Fault::new(
                at,
                format!("the flag {flag} of a section is not one of awxMSG"),
            ));
        }
        let mut kind = None;
        let (mut entry, mut group) = (None, None);
        if cursor.take(",") {
            if !(cursor.take("@") || cursor.take("%")) {
                return Err(cursor.unexpected("@progbits or @nobits"));
            }
            kind = match cursor.name() {
                Some("progbits" | "note") => Some(false),
                Some("nobits") => Some(true),
                _ => return Err(cursor.unexpected("@progbits or @nobits")),
            };
            if has(b'M') && cursor.take(",") {
                entry = Some(self.number(cursor)? as u32);
            }
            if has(b'G') {
                cursor.expect(",")?;
                let name = cursor.expect_name()?;
                self.symbols.mention(name, at);
                cursor.expect(",")?;
                cursor.expect("comdat")?;
                group = Some(name.to_owned());
            }
        }
        if is_new {
            let section = &mut self.sections[self.stack.current];
            section.allocated = has(b'a');
            section.writable = has(b'w');
            section.executable = has(b'x');
            section.strings = has(b'S');
            section.merged = entry;
            section.group = group;
            section.zeros = kind.unwrap_or(section.zeros);
        }
        Ok(())
    }

    /// `.align exponent,fill,most`, or `.balign` with a number of bytes.
    fn align_directive(&mut self, in_bytes: bool, cursor: &mut Cursor<'_>) -> Result<(), Fault> {
        cursor.skip_space();
        let at = cursor.at;
        let given = if cursor.is_at_end() { 0 } else { self.number(cursor)? };
        let alignment = match in_bytes {
            true => u32::try_from(given.max(1)).ok().filter(|bytes| bytes.is_power_of_two()),
            false => u32::try_from(given).ok().and_then(|exponent| 1_u32.checked_shl(exponent)),
        };
        let alignment = alignment.filter(|&bytes| bytes <= 1 << 18).ok_or_else(|| {
            Fault::new(at, format!("{given} is no alignment: at most 256 KB, and a power of two"))
        })?;
        let (mut fill, mut most) = (None, 0);
        if cursor.take(",") {
            if !matches!(cursor.peek(), None | Some(',')) {
                fill = Some(self.number(cursor)? as u8);
            }
            if cursor.take(",") {
                most = self.number(cursor)?;
            }
        }
        self.align(alignment, fill, most, at)
    }

    /// Numbers of `size` bytes each.
    fn numbers(&mut self, size: usize, cursor: &mut Cursor<'_>) -> Result<(), Fault> {
        if cursor.is_at_end() {
            return Ok(());
        }
        loop {
            cursor.skip_space();
            let at = cursor.at;
            let value = self.expression(cursor)?;
            let mut field = Field::Data(size);
            if cursor.take("@") {
                let kind = match (cursor.name(), size) {
                    (Some("ppu"), 4) => RelocationKind::Ppu32,
                    (Some("ppu"), 8) => RelocationKind::Ppu64,
                    _ => {
                        return Err(Fault::new(
                            at,
                            "of data, only @ppu is known, in words or doublewords",
                        ));
                    }
                };
                field = Field::Ppu(kind);
            }
            let number = match self.symbols.known(&value) {
                Some(number) => number,
                None => {
                    let (section, offset) = self.here();
                    self.fixup(section, offset, field, value, at);
                    0
                }
            };
            if let Some(warning) = truncated(number, size) {
                self.warnings.push(Fault::new(at, warning));
            }
            self.emit(&number.to_be_bytes()[8 - size..], at)?;
            if !cursor.take(",") {
                return Ok(());
            }
        }
    }

    fn floats(
        &mut self,
        cursor: &mut Cursor<'_>,
        bytes: impl Fn(&str) -> Option<Vec<u8>>,
    ) -> Result<(), Fault> {
        if cursor.is_at_end() {
            return Ok(());
        }
        loop {
            cursor.skip_space();
            let at = cursor.at;
            let text = cursor.take_while(|c| c != ',').trim_end();
            // A 0 and a letter may stand before a number, as in 0f1.5.
            let (sign, digits) = match text.strip_prefix('-') {
                Some(digits) => ("-", digits),
                None => ("", text.strip_prefix('+').unwrap_or(text)),
            };
            let digits = match digits.as_bytes() {
                [b'0', letter, ..] if letter.is_ascii_alphabetic() => &digits[2..],
                _ => digits,
            };
            let is_number = digits.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c));
            let made = is_number.then(|| bytes(&format!("{sign}{digits}"))).flatten();
            // A number that is too small for the type is none, as one that is too large.
            let mantissa = digits.split(['e', 'E']).next().unwrap_or("");
            let is_zero = !mantissa.contains(|c: char| matches!(c, '1'..='9'));
            let made = made.filter(|made| {
                is_zero || made[0] << 1 != 0 || made[1..].iter().any(|&byte| byte != 0)
            });
            let made = made
                .ok_or_else(|| Fault::new(at, format!("{text} is no number that this type has")))?;
            self.emit(&made, at)?;
            if !cursor.take(",") {
                return Ok(());
            }
        }
    }

    /// Strings, each with this end.
    fn strings(&mut self, end: &[u8], cursor: &mut Cursor<'_>) -> Result<(), Fault> {
        loop {
            cursor.skip_space();
            let at = cursor.at;
            let string = cursor.string()?;
            self.emit(&[&string, end].concat(), at)?;
            if !cursor.take(",") {
                return Ok(());
            }
        }
    }

    /// `.fill count,size,value`: of a value, four bytes are used, and zeros follow.
    fn fill(&mut self, at: usize, cursor: &mut Cursor<'_>) -> Result<(), Fault> {
        let count = self.number(cursor)?;
        let size = if cursor.take(",") { self.number(cursor)? } else { 1 };
        let value = if cursor.take(",") { self.number(cursor)? } else { 0 };
        let Some(size) = usize::try_from(size).ok().filter(|&size| size <= 8) else {
            return Err(Fault::new(at, format!("{size} is no size of 0 to 8 bytes")));
        };
        let mut entry = [0; 8];
        entry[..4].copy_from_slice(&(value as u32).to_be_bytes());
        let entry = if size < 4 { &entry[4 - size..4] } else { &entry[..size] };
        let total = count.max(0).saturating_mul(size as i64);
        let count = usize::try_from(count.max(0)).ok().filter(|_| total <= 1 << 24);
        let count = count.ok_or_else(|| Fault::new(at, "more than 16 MB"))?;
        if size == 0 {
            return Ok(());
        }
        self.emit(&entry.repeat(count), at)
    }

    fn bind(&mut self, how: &str, cursor: &mut Cursor<'_>) -> Result<(), Fault> {
        loop {
            cursor.skip_space();
            let at = cursor.at;
            let name = cursor.expect_name()?;
            match how {
                // Every symbol that is not defined is taken from other files.
                "extern" => {}
                "weak" => {
                    let id = self.symbols.mention(name, at);
                    self.symbols[id].binding = Binding::Weak;
                }
                _ => {
                    let id = self.symbols.mention(name, at);
                    self.symbols[id].binding = Binding::Global;
                }
            }
            if !cursor.take(",") {
                return Ok(());
            }
        }
    }

    /// `.comm name,size,alignment`
    fn common(&mut self, cursor: &mut Cursor<'_>) -> Result<(), Fault> {
        cursor.skip_space();
        let at = cursor.at;
        let name = cursor.expect_name()?;
        cursor.expect(",")?;
        let size = self.expression(cursor)?;
        let alignment = if cursor.take(",") { self.number(cursor)? } else { 1 };
        let alignment = u32::try_from(alignment).ok().filter(|bytes| bytes.is_power_of_two());
        let alignment = alignment.ok_or_else(|| Fault::new(at, "no power of two as alignment"))?;
        let id = self.symbols.mention(name, at);
        if self.symbols[id].definition != Definition::None {
            return Err(Fault::new(at, format!("{name} is defined already")));
        }
        let symbol = &mut self.symbols[id];
        symbol.definition = Definition::Common(alignment);
        symbol.binding = Binding::Global;
        symbol.kind = SymbolKind::Object;
        symbol.size = Some((at, size));
        Ok(())
    }

    /// `.type name,@function`
    fn type_directive(&mut self, at: usize, cursor: &mut Cursor<'_>) -> Result<(), Fault> {
        let name = cursor.expect_name()?;
        let id = self.symbols.mention(name, at);
        cursor.take(",");
        let kind = match cursor.peek() {
            Some('"') => String::from_utf8_lossy(&cursor.string()?).into_owned(),
            _ => {
                if !cursor.take("@") {
                    cursor.take("%");
                }
                cursor.expect_name()?.to_owned()
            }
        };
        self.symbols[id].kind = match kind.as_str() {
            "function" | "STT_FUNC" => SymbolKind::Function,
            "object" | "STT_OBJECT" => SymbolKind::Object,
            "notype" | "STT_NOTYPE" => SymbolKind::None,
            _ => {
                let message = format!("{kind} is no type: function, object and notype are");
                return Err(Fault::new(at, message));
            }
        };
        Ok(())
    }

    /// Appends a string to the section of comments.
    fn ident(&mut self, string: &[u8], at: usize) -> Result<(), Fault> {
        let current = self.stack.current;
        self.stack.current = self.section(".comment");
        let section = &mut self.sections[self.stack.current];
        (section.merged, section.strings) = (Some(1), true);
        let first: &[u8] = if section.bytes.is_empty() { &[0] } else { &[] };
        let done = self.emit(&[first, string, &[0]].concat(), at);
        self.stack.current = current;
        done
    }
}
