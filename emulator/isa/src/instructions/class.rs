//! Execution classes: which pipe an instruction takes and when its result can be used.
//!
//! Names are those of the binutils opcode table, latencies those of IBM's SDK tutorial.

/// One of the two pipes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Pipe {
    /// Pipe 0, "execute": fixed and floating point.
    Even,
    /// Pipe 1, "load": memory, shuffles, branches, channels.
    Odd,
}

/// An execution class.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Class {
    /// Simple fixed point, logical, compares, halts.
    Fx2,
    /// Shifts and rotates of words and halfwords.
    Fx3,
    /// Byte operations.
    Fxb,
    /// Single-precision add, multiply, fused operations.
    Fp6,
    /// Integer multiply, conversions, `fi`, `fscrwr`.
    Fp7,
    /// Double precision.
    Fpd,
    /// `nop`.
    Nop,
    /// Shuffles, quadword shifts, gathers, insertion controls, estimates.
    Shuf,
    /// Loads and stores.
    Ls,
    /// Branch hints.
    Hb,
    /// Branches, synchronisation, stops.
    Br,
    /// Channels and special-purpose registers.
    Spr,
    /// `lnop`.
    Lnop,
}

impl Class {
    /// The pipe in which all instructions of the class issue.
    #[inline]
    #[must_use]
    pub const fn pipe(self) -> Pipe {
        match self {
            Self::Fx2 | Self::Fx3 | Self::Fxb | Self::Fp6 | Self::Fp7 | Self::Fpd | Self::Nop => {
                Pipe::Even
            }
            Self::Shuf | Self::Ls | Self::Hb | Self::Br | Self::Spr | Self::Lnop => Pipe::Odd,
        }
    }

    /// Cycles from issue until a dependent instruction can issue. For [`Class::Hb`], cycles until
    /// the hint works. 0 for the two no-operations, which have no result.
    #[inline]
    #[must_use]
    pub const fn latency(self) -> u32 {
        match self {
            Self::Nop | Self::Lnop => 0,
            Self::Fx2 => 2,
            Self::Fx3 | Self::Fxb | Self::Shuf | Self::Br => 4,
            Self::Fp6 | Self::Ls | Self::Spr => 6,
            Self::Fp7 => 7,
            Self::Fpd => 13,
            Self::Hb => 16,
        }
    }
}
