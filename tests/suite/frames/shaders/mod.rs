//! Shaders of games: the rings of `examples/shader`, and those of `broken_shaders`, which break
//! the contract.

mod broken;
mod program;
mod rings;
