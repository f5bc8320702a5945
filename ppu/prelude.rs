//! What nearly every game uses: `use cellray::prelude::*;`.

pub use crate::game::{
    Axis, Button, DVec3, Frame, Game, Input, Key, Light, LightId, Material, MaterialId, Mouse,
    MouseButton, ObjectId, Pick, Shader, Shape, Start, Target, World, WorldError,
};
