//! Whitted's model on emulated SPUs, compared with the f64 reference.

mod antialias;
mod boxes;
mod chains;
mod colour;
mod colours;
mod counts;
mod fog;
mod frame;
mod invariance;
mod lamps;
mod materials;
mod meshes;
mod on_surface;
mod pictures;
mod placed;
mod polygons;
mod random;
mod scale;
mod terrain;
mod textures;
mod tolerance;
