//! The choice of the engine that runs the instructions of a machine's SPEs.

/// How a machine's SPEs run their instructions. All engines give the same results and cycles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Engine {
    /// Interprets one instruction after the other.
    Interpreter,
    /// Compiles hot code for the host, and interprets the rest. If this crate was built without
    /// its feature `compiler`, or the host has no compiler, this is the interpreter.
    Compiler,
    /// Runs compiled code, then the same instructions with the interpreter, and compares the
    /// results. This is slow.
    Check,
}

impl Default for Engine {
    /// The compiler.
    fn default() -> Self {
        Self::Compiler
    }
}
