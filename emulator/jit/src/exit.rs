//! Why compiled code ended.

/// Why compiled code ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Exit {
    /// No unit starts at the program counter, or its trace is longer than the rest of the budget.
    Left,
    /// The interpreter must run the next instruction.
    Interpret,
    /// The unit with this number can't continue at the program counter: the interpreter must.
    Failed(u32),
    /// The next instructions access a watched quadword. The interpreter must run them.
    Watched,
    /// Local store no longer holds the code of the unit with this number. The unit did nothing.
    Stale(u32),
    /// The [baseline](crate::Tier::Baseline) unit with this number was entered often since it last
    /// reported so. It did nothing.
    Hot(u32),
}

impl Exit {
    pub(crate) const LEFT: u32 = 0;
    pub(crate) const INTERPRET: u32 = 1;
    pub(crate) const FAILED: u32 = 2;
    pub(crate) const STALE: u32 = 3;
    pub(crate) const WATCHED: u32 = 4;
    pub(crate) const HOT: u32 = 5;

    /// The reason in the status that a unit returns, with the number of the unit in the context.
    #[must_use]
    pub fn of(status: u32, unit: u32) -> Self {
        match status {
            Self::LEFT => Self::Left,
            Self::INTERPRET => Self::Interpret,
            Self::FAILED => Self::Failed(unit),
            Self::WATCHED => Self::Watched,
            Self::HOT => Self::Hot(unit),
            _ => Self::Stale(unit),
        }
    }
}
