//! The identity of a program.

use std::fmt;
use std::str::FromStr;

use thiserror::Error;

/// Identifies a program by the 64-bit FNV-1a hash of its ELF file. Its text form has 16
/// hexadecimal digits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ProgramId(u64);

impl ProgramId {
    /// The identity of the program in an ELF file, from the whole file.
    #[must_use]
    pub fn of(image: &[u8]) -> Self {
        const OFFSET: u64 = 0xcbf2_9ce4_8422_2325;
        const PRIME: u64 = 0x0100_0000_01b3;
        let step = |hash: u64, &byte: &u8| (hash ^ u64::from(byte)).wrapping_mul(PRIME);
        Self(image.iter().fold(OFFSET, step))
    }
}

impl fmt::Display for ProgramId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:016x}", self.0)
    }
}

/// A text that is not the identity of a program.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{0:?} is not a program's hash of 16 hexadecimal digits")]
pub struct NoProgramId(String);

impl FromStr for ProgramId {
    type Err = NoProgramId;

    fn from_str(text: &str) -> Result<Self, NoProgramId> {
        let digits = text.len() == 16 && text.bytes().all(|byte| byte.is_ascii_hexdigit());
        let hash = u64::from_str_radix(text, 16).ok().filter(|_| digits);
        hash.map(Self).ok_or_else(|| NoProgramId(text.to_owned()))
    }
}
