//! Sets of the 128 general registers.

use std::fmt;

/// A set of register numbers.
#[derive(Clone, Copy, Default, PartialEq, Eq, Hash)]
pub struct RegisterSet(u128);

impl RegisterSet {
    /// The empty set.
    pub const EMPTY: Self = Self(0);

    /// The set of one register. Only the low seven bits of the number are used.
    #[must_use]
    pub const fn of(register: u8) -> Self {
        Self(1 << (register & 127))
    }

    /// The members of both sets together.
    #[must_use]
    pub const fn union(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// Whether the sets have a member in common.
    #[must_use]
    pub const fn intersects(self, other: Self) -> bool {
        self.0 & other.0 != 0
    }

    /// Whether the register is a member.
    #[must_use]
    pub const fn contains(self, register: u8) -> bool {
        self.intersects(Self::of(register))
    }

    /// Whether the set is empty.
    #[must_use]
    pub const fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// The members in ascending order.
    pub fn iter(self) -> impl Iterator<Item = u8> {
        let mut rest = self.0;
        std::iter::from_fn(move || {
            if rest == 0 {
                return None;
            }
            let register = rest.trailing_zeros() as u8;
            rest &= rest - 1;
            Some(register)
        })
    }
}

impl fmt::Debug for RegisterSet {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_set().entries(self.iter()).finish()
    }
}
