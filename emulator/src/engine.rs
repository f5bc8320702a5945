//! Which engine runs the instructions of a machine's SPEs.

/// How a machine's SPEs run their instructions. Results and cycles are the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Engine {
    /// One instruction after the other.
    Interpreter,
    /// Compiled for the host where code runs often. Where this crate was built without its
    /// feature `compiler`, or the host has none, that is the interpreter.
    Compiler,
    /// Compiled and interpreted, block by block, and compared: slow.
    Check,
}

impl Default for Engine {
    /// The compiler.
    fn default() -> Self {
        Self::Compiler
    }
}
