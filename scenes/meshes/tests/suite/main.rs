//! Files of each format, right and wrong.

mod animated;
#[path = "../../examples/container/mod.rs"]
mod container;
mod damage;
mod faults;
mod files;
mod formats;
mod gltf;
mod heights;
mod pairs;
mod scans;
mod textures;
