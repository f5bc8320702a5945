//! Whole frames on emulated SPUs: pictures, the work-unit protocol, SPU programs that fail, and
//! shaders of games.

mod build;
mod colours;
mod descriptor;
mod faults;
mod fixture;
mod heights;
mod long_frames;
mod materials;
mod mesh;
mod pictures;
mod protocol;
mod random;
mod retained;
mod shaders;
mod sort;
mod textures;
mod visibility;
mod waiting;
