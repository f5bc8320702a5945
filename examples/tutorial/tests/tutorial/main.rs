//! The programs of `docs/tutorial.md` as they are run, and the document itself.

mod ball;
mod document;
mod program;
mod steer;
mod stripes;
