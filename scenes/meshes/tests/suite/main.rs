//! Files of each format, right and wrong.

mod damage;
mod faults;
mod files;
mod formats;
mod gltf;
mod pairs;
mod scans;
mod textures;
