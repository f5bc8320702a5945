//! The types that nearly every game uses: `use cellray::prelude::*;`.

pub use crate::game::{
    Axis, Button, DAffine3, DVec3, Frame, Game, Input, Key, Label, Light, LightId, Material,
    MaterialId, Mesh, MeshId, Mouse, MouseButton, ObjectId, OrbitCamera, Pick, Random, Shader,
    Shape, Side, Sky, Start, Target, Texture, WalkCamera, World, WorldError,
};
