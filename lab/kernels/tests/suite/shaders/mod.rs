//! The shaders that the program comes with, and `shaders_run`, which calls shaders.

mod built_in;
mod run;
