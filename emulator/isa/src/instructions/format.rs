//! Instruction formats: the positions of opcode, registers and constants in the word.

/// An instruction format. The comments number the bits from the left, as IBM does.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Format {
    /// RB 11-17, RA 18-24, RT 25-31.
    Rr,
    /// RT 4-10, RB 11-17, RA 18-24, RC 25-31.
    Rrr,
    /// Signed constant 11-17, RA 18-24, RT 25-31.
    Ri7,
    /// 155 - scale in 10-17, RA 18-24, RT 25-31.
    Ri8From155,
    /// 173 - scale in 10-17, RA 18-24, RT 25-31.
    Ri8From173,
    /// Signed constant 8-17, RA 18-24, RT 25-31.
    Ri10,
    /// Signed displacement in quadwords 8-17, RA 18-24, RT 25-31.
    Ri10Quadwords,
    /// Signed constant 9-24, RT 25-31.
    Ri16,
    /// Word address 9-24, RT 25-31.
    Ri16Absolute,
    /// Signed distance in words 9-24, RT 25-31.
    Ri16Relative,
    /// Unsigned constant 7-24, RT 25-31.
    Ri18,
    /// [`feature`](super::feature) bits 11-13, RA 18-24, RT 25-31.
    Flagged,
    /// Feature bits 11-13, branch distance 16-17 and 25-31, RA 18-24.
    Hint,
    /// Branch distance 7-8 and 25-31, word address 9-24.
    HintAbsolute,
    /// Branch distance 7-8 and 25-31, signed distance in words 9-24.
    HintRelative,
    /// Stop code 18-31.
    Stop,
}

impl Format {
    /// The number of opcode bits, which are the first bits of the word.
    #[must_use]
    pub const fn opcode_bits(self) -> u32 {
        match self {
            Self::Rrr => 4,
            Self::Ri18 | Self::HintAbsolute | Self::HintRelative => 7,
            Self::Ri10 | Self::Ri10Quadwords => 8,
            Self::Ri16 | Self::Ri16Absolute | Self::Ri16Relative => 9,
            Self::Ri8From155 | Self::Ri8From173 => 10,
            Self::Rr | Self::Ri7 | Self::Flagged | Self::Hint | Self::Stop => 11,
        }
    }
}
