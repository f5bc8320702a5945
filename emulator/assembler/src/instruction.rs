//! Instructions: mnemonics, operands and their ranges. The operands of each are those of the
//! instruction table.

use spu_isa::{Format, Instruction, Op, Operand, Target as Use, feature};

use crate::cursor::Cursor;
use crate::diagnostic::{Fault, advice};
use crate::expression::Expression;
use crate::program::RelocationKind;
use crate::source::{Field, Fixup, Source, check};

/// Other names of instructions. Those of branches may have the letters of feature bits, too.
const SYNONYMS: [(&str, Op); 4] =
    [("bif", Op::Biz), ("bit", Op::Binz), ("bihf", Op::Bihz), ("biht", Op::Bihnz)];

/// Registers that have names.
const REGISTERS: [(&str, u8); 4] = [("lr", 0), ("rp", 0), ("sp", 1), ("fp", 127)];

/// Channels that have names.
const CHANNELS: [(&str, u8); 28] = [
    ("SPU_RdEventStat", 0),
    ("SPU_WrEventMask", 1),
    ("SPU_WrEventAck", 2),
    ("SPU_RdSigNotify1", 3),
    ("SPU_RdSigNotify2", 4),
    ("SPU_WrDec", 7),
    ("SPU_RdDec", 8),
    ("MFC_WrMSSyncReq", 9),
    ("SPU_RdEventMask", 11),
    ("MFC_RdTagMask", 12),
    ("SPU_RdMachStat", 13),
    ("SPU_WrSRR0", 14),
    ("SPU_RdSRR0", 15),
    ("MFC_LSA", 16),
    ("MFC_EAH", 17),
    ("MFC_EAL", 18),
    ("MFC_Size", 19),
    ("MFC_TagID", 20),
    ("MFC_Cmd", 21),
    ("MFC_WrTagMask", 22),
    ("MFC_WrTagUpdate", 23),
    ("MFC_RdTagStat", 24),
    ("MFC_RdListStallStat", 25),
    ("MFC_WrListStallAck", 26),
    ("MFC_RdAtomicStat", 27),
    ("SPU_WrOutMbox", 28),
    ("SPU_RdInMbox", 29),
    ("SPU_WrOutIntrMbox", 30),
];

const EVERY: (i64, i64) = (i64::MIN, i64::MAX);

/// The instruction with this name in small letters, and its feature bits.
pub(crate) fn of_mnemonic(name: &str) -> Option<(Op, i32)> {
    let synonym = |name: &str| SYNONYMS.iter().find(|(other, _)| *other == name).map(|&(_, op)| op);
    let plain = |name: &str| Op::of_mnemonic(name).or_else(|| synonym(name));
    match name {
        "lr" => return Some((Op::Ori, 0)),
        "syncc" => return Some((Op::Sync, feature::CHANNEL_OR_PREFETCH)),
        "hbrp" => return Some((Op::Hbr, feature::CHANNEL_OR_PREFETCH)),
        _ => {}
    }
    if let Some(op) = plain(name) {
        return Some((op, 0));
    }
    let letters = [('d', feature::DISABLE), ('e', feature::ENABLE)];
    letters.into_iter().find_map(|(letter, bit)| {
        let op = plain(name.strip_suffix(letter)?)?;
        (op.row().format == Format::Flagged && op != Op::Sync).then_some((op, bit))
    })
}

/// Advice for an instruction or a directive that does not exist.
pub(crate) fn similar<'a>(name: &str, others: impl Iterator<Item = &'a str>) -> String {
    let rows = Op::rows().iter().map(|row| row.mnemonic);
    advice(name, rows.chain(SYNONYMS.map(|(name, _)| name)).chain(others))
}

/// The numbers that an operand accepts, and those of which the GNU assembler does not warn.
fn ranges(op: Op, operand: Operand) -> ((i64, i64), (i64, i64)) {
    let both = |range| (range, range);
    match operand {
        Operand::Immediate7 => match op {
            Op::Shli => ((0, 127), (0, 63)),
            Op::Shlhi | Op::Shlqbyi => ((0, 127), (0, 31)),
            Op::Rotmi | Op::Rotmai => ((-64, 63), (-63, 0)),
            Op::Rothmi | Op::Rotmahi | Op::Rotqmbyi => ((-32, 31), (-31, 0)),
            _ => both(EVERY),
        },
        Operand::Signed10 => match op {
            Op::Andbi | Op::Orbi | Op::Xorbi | Op::Ceqbi | Op::Cgtbi | Op::Clgtbi => {
                ((-512, 511), (-128, 255))
            }
            _ => both((-512, 511)),
        },
        Operand::Signed16 => both((-0x8000, 0x7fff)),
        Operand::Unsigned16 => both((-0x8000, 0xffff)),
        Operand::Unsigned18 => both((0, 0x3_ffff)),
        Operand::Displacement14 => both((-0x2000, 0x1fff)),
        Operand::Absolute => both((-0x2_0000, 0x3_ffff)),
        Operand::Relative => both((-0x4_0000, 0x3_ffff)),
        Operand::HintedBranch => both((-1024, 1023)),
        Operand::Scale => both((0, 127)),
        Operand::Code => both((0, 0x3fff)),
        _ => both(EVERY),
    }
}

/// The relocation of a symbol's address in this operand.
const fn relocation(op: Op, operand: Operand) -> Option<RelocationKind> {
    match operand {
        Operand::Immediate7 | Operand::Displacement7 => Some(RelocationKind::Addr7),
        Operand::Signed10 => Some(RelocationKind::Addr10Immediate),
        Operand::Signed16 | Operand::Unsigned16 => Some(RelocationKind::Addr16Immediate),
        Operand::Unsigned18 => Some(RelocationKind::Addr18),
        Operand::Displacement14 => Some(RelocationKind::Addr10),
        Operand::Absolute => Some(RelocationKind::Addr16),
        Operand::Relative => Some(RelocationKind::Rel16),
        Operand::HintedBranch if matches!(op, Op::Hbr) => Some(RelocationKind::Rel9Indirect),
        Operand::HintedBranch => Some(RelocationKind::Rel9),
        _ => None,
    }
}

/// Operands as a message names them.
fn usage(name: &str, operands: &[Operand]) -> String {
    let words: Vec<&str> = operands.iter().map(|&operand| word(operand)).collect();
    if words.is_empty() {
        return format!("{name} has no operands");
    }
    format!("the operands of {name} are {}", words.join(", "))
}

const fn word(operand: Operand) -> &'static str {
    match operand {
        Operand::Rt => "rt",
        Operand::Ra => "ra",
        Operand::Rb => "rb",
        Operand::Rc => "rc",
        Operand::Displacement7 | Operand::Displacement14 => "offset(ra)",
        Operand::Absolute | Operand::Relative => "target",
        Operand::HintedBranch => "branch",
        Operand::Scale => "scale",
        Operand::Channel => "channel",
        Operand::Special => "special register",
        Operand::Code => "code",
        _ => "constant",
    }
}

impl Source<'_> {
    /// Assembles an instruction, whose operands follow.
    pub(crate) fn instruction(
        &mut self,
        name: &str,
        op: Op,
        features: i32,
        cursor: &mut Cursor<'_>,
    ) -> Result<(), Fault> {
        cursor.skip_space();
        let start = cursor.at;
        let mut i = Instruction::new(op, [0; 4], features);
        let all = match name {
            "lr" => &[Operand::Rt, Operand::Ra],
            "hbrp" => &[][..],
            _ => op.row().operands,
        };
        let given = match cursor.is_at_end() {
            true => 0,
            false => 1 + commas(cursor.rest()),
        };
        let operands = match op {
            // The register of a halt and of fscrwr is not written, and may be left out.
            _ if op.row().target == Use::False && given + 1 == all.len() => &all[1..],
            Op::Stop | Op::Iret if given == 0 => &[],
            _ => all,
        };
        if given != operands.len() {
            return Err(Fault::new(start, format!("{}; {given} are given", usage(name, all))));
        }
        let here = self.here();
        for (number, &operand) in operands.iter().enumerate() {
            if number > 0 {
                cursor.expect(",")?;
            }
            self.operand(&mut i, operand, here, cursor)?;
        }
        cursor.finish()?;
        if op == Op::Nop {
            // The GNU assembler ignores the operand.
            i.rt = 0;
        }
        self.emit(&i.encode().to_be_bytes(), start)
    }

    fn operand(
        &mut self,
        i: &mut Instruction,
        operand: Operand,
        (section, offset): (usize, u32),
        cursor: &mut Cursor<'_>,
    ) -> Result<(), Fault> {
        let in_parentheses = matches!(operand, Operand::Displacement7 | Operand::Displacement14);
        if let Some(field) = operand.field()
            && !in_parentheses
        {
            *i.register_mut(field) = match operand {
                Operand::Channel => self.register(cursor, "ch", &CHANNELS, "channel")?,
                Operand::Special => self.register(cursor, "sp", &[], "special register")?,
                _ => self.register(cursor, "", &REGISTERS, "register")?,
            };
            return Ok(());
        }
        cursor.skip_space();
        let at = cursor.at;
        let value = self.expression(cursor)?;
        let mut kind = relocation(i.op, operand);
        let (mut accepted, mut usual) = ranges(i.op, operand);
        if cursor.take("@") {
            let half = match cursor.name() {
                Some("h" | "H") => RelocationKind::Addr16High,
                Some("l" | "L") => RelocationKind::Addr16Low,
                _ => return Err(Fault::new(at, "the halves of an address are @h and @l")),
            };
            if kind != Some(RelocationKind::Addr16Immediate) {
                return Err(Fault::new(at, "half an address is not possible here"));
            }
            kind = Some(half);
            (accepted, usual) = (EVERY, EVERY);
        }
        match (self.symbols.known(&value), kind) {
            (Some(number), _) => {
                check(number, accepted).map_err(|message| Fault::new(at, message))?;
                if let Err(message) = check(number, usual) {
                    self.warnings.push(Fault::new(at, message));
                }
                match kind {
                    Some(kind) => kind.set(i, number),
                    None => i.immediate = number as i32,
                }
            }
            (None, Some(kind)) => {
                self.fixup(section, offset, Field::Operand(kind, accepted), value, at);
            }
            (None, None) => self.fixup(section, offset, Field::Constant(accepted), value, at),
        }
        if in_parentheses {
            cursor.expect("(")?;
            i.ra = self.register(cursor, "", &REGISTERS, "register")?;
            cursor.expect(")")?;
        }
        Ok(())
    }

    pub(crate) fn fixup(
        &mut self,
        section: usize,
        offset: u32,
        field: Field,
        value: Expression,
        at: usize,
    ) {
        self.fixups.push(Fixup { section, offset, field, value, at });
    }

    /// A register or a channel: `$3`, `$ch3`, a name, or an expression that is its number, with or
    /// without the `$`.
    fn register(
        &mut self,
        cursor: &mut Cursor<'_>,
        prefix: &str,
        named: &[(&str, u8)],
        what: &str,
    ) -> Result<u8, Fault> {
        cursor.skip_space();
        let at = cursor.at;
        cursor.take("$");
        let start = cursor.clone();
        if let Some(name) = cursor.name() {
            let is_named = |&&(known, _): &&(&str, u8)| known.eq_ignore_ascii_case(name);
            if let Some(&(_, number)) = named.iter().find(is_named) {
                return Ok(number);
            }
            let digits = name.get(..prefix.len()).filter(|p| p.eq_ignore_ascii_case(prefix));
            let digits = digits.map_or("", |_| &name[prefix.len()..]);
            if !prefix.is_empty()
                && !digits.is_empty()
                && digits.bytes().all(|b| b.is_ascii_digit())
            {
                return numbered(digits.parse().unwrap_or(i64::MAX), what, at);
            }
            if self.symbols.constant(name).is_none() {
                let known = self.symbols.names().chain(named.iter().map(|&(name, _)| name));
                let message = format!("there is no {what} {name}{}", advice(name, known));
                return Err(Fault::new(at, message));
            }
        }
        *cursor = start;
        let number = self.number(cursor)?;
        numbered(number, what, at)
    }
}

fn numbered(number: i64, what: &str, at: usize) -> Result<u8, Fault> {
    match u8::try_from(number) {
        Ok(number) if number < 128 => Ok(number),
        _ => Err(Fault::new(at, format!("{number} is no {what}: they are numbered 0 to 127"))),
    }
}

/// The number of commas that separate operands. Those in a character constant do not.
fn commas(operands: &str) -> usize {
    operands.match_indices(',').filter(|&(at, _)| !operands[..at].ends_with('\'')).count()
}
