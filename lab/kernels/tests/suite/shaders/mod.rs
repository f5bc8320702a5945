//! The built-in shaders, and `shaders_run`, which calls shaders.

mod built_in;
mod run;
