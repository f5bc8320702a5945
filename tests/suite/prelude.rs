//! The common imports of these tests.

pub use std::fs;
pub use std::path::{Path, PathBuf};
pub use std::process::Command;
pub use std::sync::Arc;
pub use std::time::Duration;

pub use cellray::framebuffer::{Framebuffer, Geometry, Memory};
pub use cellray::game::{
    DAffine3, Light, Material, MaterialId, ObjectId, World, WorldError, WorldErrorKind,
};
pub use cellray::scene::{Colour, Model, RenderOptions};
pub use cellray::spe::Program;
pub use cellray::work::{Skip, Split};
pub use cellray::{Engine, EngineError, Scene, Settings, SharedMemory};
pub use glam::DVec3;
pub use image::RgbImage;
pub use protocol::layout::{Frame, MESH_BLOCK, MESH_LEAF, SCENE_ADDRESS};
pub use rand::{Rng, SeedableRng};
pub use rand_chacha::ChaCha8Rng;
pub use scenes::{Shader, Shape};
pub use zerocopy::{FromBytes, IntoBytes};

pub use crate::recorder::{Recorder, Snapshot, nff_scene, render};
