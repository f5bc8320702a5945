//! Tests the programs of `docs/tutorial.md` and the document itself.

mod ball;
mod document;
mod program;
mod steer;
mod stripes;
