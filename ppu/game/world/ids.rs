//! Handles of what a world is made of.

use slotmap::new_key_type;

new_key_type! {
    /// Handle of an object in a [`World`](super::World); the default one is none's.
    pub struct ObjectId;

    /// Handle of a material in a [`World`](super::World); the default one is none's.
    pub struct MaterialId;

    /// Handle of a light in a [`World`](super::World); the default one is none's.
    pub struct LightId;
}
