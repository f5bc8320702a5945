//! Which engine continues.

use crate::stop::Stopped;

pub(crate) enum Dispatch {
    /// With a unit, if there is one, else with the interpreter.
    Any,
    /// With the interpreter, for one instruction.
    InterpretOne,
    /// With the interpreter, up to a taken branch.
    InterpretBlock,
    /// Not at all: the SPU has stopped.
    Stop(Stopped),
}
