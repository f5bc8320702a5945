//! The plain functions of an object: their instructions, the addresses that these refer to, and
//! their source lines.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use object::read::elf::ElfFile32;
use object::{
    BigEndian, Object, ObjectKind, ObjectSection, ObjectSymbol, RelocationFlags, RelocationTarget,
    SectionIndex, SymbolKind, SymbolSection,
};

use super::Kind;
use super::error::{ScheduleError, Unschedulable};
use super::function::{Block, Function, Node, Reference, Symbol};
use crate::code::{Code, CodeError};
use spu_isa::{Class, Format, Instruction, Op, Target, feature};

/// The relocation types whose value is the bare symbol in assembly notation.
const PLAIN: [u32; 8] = [1, 2, 5, 7, 8, 9, 10, 12];
/// The upper half of an address, and the lower half.
const HIGH: u32 = 3;
const LOW: u32 = 4;

type File<'data> = ElfFile32<'data, BigEndian>;

pub(super) struct Plain<'data> {
    file: File<'data>,
    code: Code,
    /// Names of the places in sections.
    places: BTreeMap<(usize, u64), String>,
}

/// An error and its line.
pub(super) type Fault = (u64, Unschedulable);

pub(super) struct FunctionCode {
    pub name: String,
    pub start: u32,
    pub end: u32,
    pub placed: Vec<Placed>,
}

pub(super) struct Placed {
    pub address: u32,
    pub word: u32,
    pub i: Instruction,
    /// The address that it refers to. Blocks of its own function are named by their addresses.
    pub reference: Option<Reference>,
    pub line: u64,
}

impl<'data> Plain<'data> {
    pub fn parse(data: &'data [u8]) -> Result<Self, ScheduleError> {
        let code = Code::parse(data)?;
        let file = File::parse(data).map_err(CodeError::Elf)?;
        if file.kind() != ObjectKind::Relocatable {
            return Err(ScheduleError::Linked);
        }
        if code.sources().is_empty() {
            return Err(ScheduleError::NoLines);
        }
        let mut places = BTreeMap::new();
        for symbol in file.symbols() {
            let named = symbol.name().unwrap_or_default();
            if let Some(index) = symbol.section_index()
                && symbol.kind() != SymbolKind::Section
                && !named.is_empty()
            {
                let place = (index.0, symbol.address());
                places.entry(place).or_insert_with(|| named.to_owned());
            }
        }
        Ok(Self { file, code, places })
    }

    /// The values of the symbols that are plain numbers, which `.set` defines.
    pub fn numbers(&self) -> BTreeMap<String, u64> {
        let symbols = self.file.symbols();
        let absolute = symbols.filter(|symbol| symbol.section() == SymbolSection::Absolute);
        absolute
            .filter_map(|symbol| Some((symbol.name().ok()?.to_owned(), symbol.address())))
            .collect()
    }

    /// All symbol names.
    pub fn names(&self) -> BTreeSet<String> {
        let symbols = self.file.symbols();
        symbols.filter_map(|symbol| symbol.name().ok().map(str::to_owned)).collect()
    }

    /// Whether the line table names the source.
    pub fn comes_from(&self, source: &str) -> bool {
        let name = Path::new(source).file_name();
        let sources = self.code.sources();
        sources.iter().any(|(_, at)| at.file.file_name() == name)
    }

    /// The code of the function with this name, or `None` if there is none.
    pub fn function_code(
        &self,
        name: &str,
        kind: Kind,
        source: &str,
    ) -> Result<Option<FunctionCode>, Fault> {
        let found = self.code.functions().iter().find(|found| found.name == name);
        let symbol = self.file.symbols().find(|symbol| symbol.name() == Ok(name));
        let (Some(found), Some(symbol)) = (found, symbol) else {
            return Ok(None);
        };
        let lines: BTreeMap<u32, u64> = self
            .code
            .sources()
            .into_iter()
            .filter(|(_, at)| at.file.file_name() == Path::new(source).file_name())
            .map(|(address, at)| (address, at.line))
            .collect();
        let line = |address: u32| lines.get(&address).copied().unwrap_or(0);
        let start = found.start;
        let (Some(section), Ok(within)) = (symbol.section_index(), u32::try_from(symbol.address()))
        else {
            return Ok(None);
        };
        let view = View {
            plain: self,
            section,
            base: start.wrapping_sub(within),
            range: start..found.end,
            kind,
        };
        let relocations = view.relocations();
        let mut placed = Vec::new();
        for (address, word) in self.code.words(found.start, found.end) {
            let fault = |what| (line(address), what);
            let i = Instruction::decode(word).ok_or_else(|| fault(Unschedulable::Word(word)))?;
            let reference = view.reference(address, i, relocations.get(&address)).map_err(fault)?;
            placed.push(Placed { address, word, i, reference, line: line(address) });
        }
        Ok(Some(FunctionCode { name: name.to_owned(), start, end: found.end, placed }))
    }

    /// The code of a function as blocks.
    pub fn function(&self, function_code: &FunctionCode, kind: Kind) -> Result<Function, Fault> {
        let FunctionCode { name, start, end, placed } = function_code;
        if start % 8 != 0 {
            let line = placed.first().map_or(0, |first| first.line);
            return Err((line, Unschedulable::Alignment(name.clone())));
        }
        let mut nodes = Vec::new();
        let mut starts = BTreeSet::from([*start]);
        for Placed { address, word, i, reference, line } in placed {
            let fault = |what| (*line, what);
            let is_hint = i.op.row().class == Class::Hb;
            if is_hint && kind == Kind::Kernel {
                return Err(fault(Unschedulable::Hint));
            }
            let hinted = is_hint.then(|| address.wrapping_add_signed(i.branch_distance.into()));
            if let Some(branch) = hinted {
                if !(*start..*end).contains(&branch) || self.code.label(branch).is_none() {
                    return Err(fault(Unschedulable::Address(branch)));
                }
                starts.insert(branch);
            }
            if let Some(Reference::Block(target)) = reference {
                starts.insert(*target as u32);
            }
            let node = Node {
                i: *i,
                plain: *i,
                reference: reference.clone(),
                hinted: hinted.map(|branch| branch as usize),
                line: *line,
                origin: Some(*address),
                may_alias: false,
                one_pass: false,
                min_passes: 1,
                in_order: false,
                stage: 0,
                moved: None,
                reason: "",
            };
            if node.ends_block() {
                starts.insert(address + 4);
            }
            if self.code.label(*address).is_some() {
                starts.insert(*address);
            }
            // In drivers, they keep hints away from branches.
            if is_no_operation(*i) && kind == Kind::Kernel {
                continue;
            }
            if !has_notation(*i, *word) {
                return Err(fault(Unschedulable::Notation(*word)));
            }
            nodes.push((*address, node));
        }
        starts.remove(end);
        Ok(Function {
            name: name.clone(),
            kind,
            blocks: self.blocks(*start, &starts, nodes),
            results: 0,
            copies: BTreeMap::new(),
        })
    }

    /// Where this object has a name that another object uses: its place and its offset from the
    /// place's start, as in [`Symbol`].
    pub fn place_of(&self, name: &str) -> Option<(String, i64)> {
        let section_name = |index| {
            let section = self.file.section_by_index(index).ok()?;
            section.name().ok().map(str::to_owned)
        };
        let mut symbols = self.file.symbols();
        if let Some(symbol) = symbols.find(|symbol| symbol.name() == Ok(name)) {
            return match symbol.section_index() {
                Some(index) => Some((section_name(index)?, symbol.address() as i64)),
                None => Some((name.to_owned(), 0)),
            };
        }
        self.file.section_by_name(name)?;
        Some((name.to_owned(), 0))
    }

    /// Splits the instructions at `starts`. Each start becomes the id of its block.
    fn blocks(&self, start: u32, starts: &BTreeSet<u32>, nodes: Vec<(u32, Node)>) -> Vec<Block> {
        let block = |&at: &u32| Block {
            id: at as usize,
            name: self.code.label(at).filter(|_| at != start).map(str::to_owned),
            nodes: Vec::new(),
            cycles: None,
        };
        let mut blocks: Vec<Block> = starts.iter().map(block).collect();
        for (address, node) in nodes {
            let at = blocks.partition_point(|block| block.id <= address as usize) - 1;
            blocks[at].nodes.push(node);
        }
        blocks
    }
}

/// A function's position in the object.
struct View<'a, 'data> {
    plain: &'a Plain<'data>,
    section: SectionIndex,
    /// The section's address in [`Code`].
    base: u32,
    range: std::ops::Range<u32>,
    kind: Kind,
}

/// A relocation: its type and its target.
struct Link {
    kind: u32,
    section: Option<SectionIndex>,
    name: String,
    offset: i64,
}

impl View<'_, '_> {
    fn relocations(&self) -> BTreeMap<u32, Link> {
        let file = &self.plain.file;
        let Ok(section) = file.section_by_index(self.section) else {
            return BTreeMap::new();
        };
        let links = section.relocations().filter_map(|(offset, relocation)| {
            let RelocationTarget::Symbol(index) = relocation.target() else {
                return None;
            };
            let RelocationFlags::Elf { r_type } = relocation.flags() else {
                return None;
            };
            let symbol = file.symbol_by_index(index).ok()?;
            let section = symbol.section_index();
            let start = section.map_or(0, |_| symbol.address() as i64);
            let link = Link {
                kind: r_type.0,
                section,
                name: symbol.name().unwrap_or_default().to_owned(),
                offset: start + relocation.addend(),
            };
            Some((self.base.wrapping_add(offset as u32), link))
        });
        links.collect()
    }

    fn reference(
        &self,
        address: u32,
        i: Instruction,
        link: Option<&Link>,
    ) -> Result<Option<Reference>, Unschedulable> {
        let relative = matches!(i.op.row().format, Format::Ri16Relative | Format::HintRelative);
        let link = match link {
            Some(link) => link,
            None if relative => &Link {
                kind: PLAIN[3],
                section: Some(self.section),
                name: String::new(),
                offset: i64::from(address.wrapping_add_signed(i.immediate)) - i64::from(self.base),
            },
            None => return Ok(None),
        };
        let part = match link.kind {
            HIGH => "@h",
            LOW => "@l",
            kind if PLAIN.contains(&kind) => "",
            kind => return Err(Unschedulable::Relocation(kind)),
        };
        if link.section == Some(self.section) {
            let target = (i64::from(self.base) + link.offset) as u32;
            if self.range.contains(&target) {
                let row = i.op.row();
                let branches = row.class == Class::Br && row.target != Target::Rt;
                // Drivers call parts of themselves, and take addresses to jump to.
                let driver = row.class == Class::Br || i.op == Op::Ila;
                let named =
                    branches || row.class == Class::Hb || self.kind == Kind::Driver && driver;
                if !named || !target.is_multiple_of(4) {
                    return Err(Unschedulable::Address(target));
                }
                return Ok(Some(Reference::Block(target as usize)));
            }
        }
        let Some(section) = link.section else {
            return Ok(Some(Reference::Symbol(Symbol {
                name: link.name.clone(),
                addend: link.offset,
                part,
                place: link.name.clone(),
                offset: link.offset,
            })));
        };
        let place = self.plain.file.section_by_index(section);
        let place = place.ok().and_then(|place| place.name().ok().map(str::to_owned));
        let place = place.ok_or(Unschedulable::Address(address))?;
        let first = (section.0, 0);
        let last = (section.0, u64::try_from(link.offset).unwrap_or(0));
        let named = self.plain.places.range(first..=last).next_back();
        let (name, start) = match named {
            Some(((_, start), name)) => (name.clone(), *start as i64),
            None => (place.clone(), 0),
        };
        Ok(Some(Reference::Symbol(Symbol {
            name,
            addend: link.offset - start,
            part,
            place,
            offset: link.offset,
        })))
    }
}

pub(super) fn is_no_operation(i: Instruction) -> bool {
    matches!(i.op.row().class, Class::Nop | Class::Lnop)
}

/// Whether the word can be written in assembly: reserved fields and unused fields must be 0.
fn has_notation(i: Instruction, word: u32) -> bool {
    let row = i.op.row();
    let constant = match row.format {
        Format::Flagged if i.op == Op::Sync => {
            [0, feature::CHANNEL_OR_PREFETCH].contains(&i.immediate)
        }
        Format::Flagged => [0, feature::DISABLE, feature::ENABLE].contains(&i.immediate),
        Format::Ri8From155 | Format::Ri8From173 => (0..=127).contains(&i.immediate),
        _ => true,
    };
    constant && i.without_reserved().encode() == word
}
