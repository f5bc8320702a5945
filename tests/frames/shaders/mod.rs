//! Shaders that games bring: the rings of `examples/shader`, and those of `tests/shaders`, which break
//! the contract.

mod broken;
mod program;
mod rings;
