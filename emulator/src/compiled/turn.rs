//! What an SPU does next.

use crate::stop::Stopped;

/// What comes next.
pub(crate) enum Turn {
    /// A unit, if there is one, else the interpreter.
    Any,
    /// The interpreter, for one instruction.
    Instruction,
    /// The interpreter, up to a taken branch.
    Block,
    /// Nothing: the SPU has stopped.
    Stop(Stopped),
}
