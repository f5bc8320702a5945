//! What nearly every game uses: `use cellray::prelude::*;`.

pub use crate::game::{
    Axis, Button, DVec3, Frame, Game, Input, Key, Label, Light, LightId, Material, MaterialId,
    Mouse, MouseButton, ObjectId, Pick, Shader, Shape, Side, Start, Target, World, WorldError,
};
