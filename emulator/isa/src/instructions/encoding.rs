//! Decodes words to instructions, and encodes instructions as words.
//!
//! Invariant: encoding a decoded instruction yields the same word, except that reserved bits
//! become 0.

use super::format::Format;
use super::instruction::Instruction;
use super::op::Op;
use crate::address::LIMIT_MASK;

/// The field of `bits` bits in `word` that ends at (IBM) bit `last`.
const fn field(word: u32, last: u32, bits: u32) -> u32 {
    (word >> (31 - last)) & ((1 << bits) - 1)
}

const fn signed_field(word: u32, last: u32, bits: u32) -> i32 {
    (word << (last + 1 - bits)) as i32 >> (32 - bits)
}

const fn place(value: u32, last: u32, bits: u32) -> u32 {
    (value & ((1 << bits) - 1)) << (31 - last)
}

/// Distance in bytes from a hint to its branch: nine signed bits in two parts of the word.
const fn branch_distance(word: u32, high_last: u32) -> i16 {
    let words = field(word, high_last, 2) << 7 | field(word, 31, 7);
    ((words << 23) as i32 >> 23) as i16 * 4
}

const fn place_branch_distance(bytes: i16, high_last: u32) -> u32 {
    let words = (bytes >> 2) as u32;
    place(words >> 7, high_last, 2) | place(words, 31, 7)
}

impl Format {
    /// The fields of `word`, which holds an `op` with this format.
    const fn unpack(self, op: Op, word: u32) -> Instruction {
        let (rt, ra) = (field(word, 31, 7) as u8, field(word, 24, 7) as u8);
        let mut i = Instruction::new(op, [rt, ra, 0, 0], 0);
        match self {
            Self::Rr => i.rb = field(word, 17, 7) as u8,
            Self::Rrr => {
                i.rt = field(word, 10, 7) as u8;
                i.rb = field(word, 17, 7) as u8;
                i.rc = field(word, 31, 7) as u8;
            }
            Self::Ri7 => i.immediate = signed_field(word, 17, 7),
            Self::Ri8From155 => i.immediate = 155 - field(word, 17, 8) as i32,
            Self::Ri8From173 => i.immediate = 173 - field(word, 17, 8) as i32,
            Self::Ri10 => i.immediate = signed_field(word, 17, 10),
            Self::Ri10Quadwords => i.immediate = signed_field(word, 17, 10) * 16,
            Self::Ri16 => {
                i.ra = 0;
                i.immediate = signed_field(word, 24, 16);
            }
            Self::Ri16Absolute => {
                i.ra = 0;
                i.immediate = (field(word, 24, 16) * 4) as i32;
            }
            Self::Ri16Relative => {
                i.ra = 0;
                i.immediate = signed_field(word, 24, 16) * 4;
            }
            Self::Ri18 => {
                i.ra = 0;
                i.immediate = field(word, 24, 18) as i32;
            }
            Self::Flagged => i.immediate = field(word, 13, 3) as i32,
            Self::Hint => {
                i.rt = 0;
                i.branch_distance = branch_distance(word, 17);
                i.immediate = field(word, 13, 3) as i32;
            }
            Self::HintAbsolute => {
                i.rt = 0;
                i.ra = 0;
                i.branch_distance = branch_distance(word, 8);
                i.immediate = (field(word, 24, 16) * 4) as i32;
            }
            Self::HintRelative => {
                i.rt = 0;
                i.ra = 0;
                i.branch_distance = branch_distance(word, 8);
                i.immediate = signed_field(word, 24, 16) * 4;
            }
            Self::Stop => {
                i.rt = 0;
                i.ra = 0;
                i.immediate = field(word, 31, 14) as i32;
            }
        }
        i
    }

    /// The word without its opcode bits. Each field is reduced to the low bits that fit.
    const fn pack(self, i: Instruction) -> u32 {
        let immediate = i.immediate as u32;
        let rt = place(i.rt as u32, 31, 7);
        let ra = place(i.ra as u32, 24, 7);
        let rb = place(i.rb as u32, 17, 7);
        match self {
            Self::Rr => rb | ra | rt,
            Self::Rrr => place(i.rt as u32, 10, 7) | rb | ra | place(i.rc as u32, 31, 7),
            Self::Ri7 => place(immediate, 17, 7) | ra | rt,
            Self::Ri8From155 => place(155u32.wrapping_sub(immediate), 17, 8) | ra | rt,
            Self::Ri8From173 => place(173u32.wrapping_sub(immediate), 17, 8) | ra | rt,
            Self::Ri10 => place(immediate, 17, 10) | ra | rt,
            Self::Ri10Quadwords => place(immediate >> 4, 17, 10) | ra | rt,
            Self::Ri16 => place(immediate, 24, 16) | rt,
            Self::Ri16Absolute | Self::Ri16Relative => {
                place((immediate & LIMIT_MASK) >> 2, 24, 16) | rt
            }
            Self::Ri18 => place(immediate, 24, 18) | rt,
            Self::Flagged => place(immediate, 13, 3) | ra | rt,
            Self::Hint => {
                place(immediate, 13, 3) | place_branch_distance(i.branch_distance, 17) | ra
            }
            Self::HintAbsolute | Self::HintRelative => {
                place((immediate & LIMIT_MASK) >> 2, 24, 16)
                    | place_branch_distance(i.branch_distance, 8)
            }
            Self::Stop => place(immediate, 31, 14),
        }
    }
}

impl Instruction {
    /// The instruction in `word`, or `None` if its opcode is not assigned. Reserved bits are
    /// ignored, as in the GNU disassembler.
    #[inline]
    #[must_use]
    pub fn decode(word: u32) -> Option<Self> {
        let op = Op::of_word(word)?;
        Some(op.row().format.unpack(op, word))
    }

    /// The instruction's word. Of a field that is too wide, the low bits are used.
    #[must_use]
    pub fn encode(self) -> u32 {
        let row = self.op.row();
        u32::from(row.opcode) << 21 | row.format.pack(self)
    }
}
