//! Handles of objects, meshes, materials and lights.

use slotmap::new_key_type;

new_key_type! {
    /// Handle of an object in a [`World`](super::World). No object has the default one.
    pub struct ObjectId;

    /// Handle of a mesh at a place in a [`World`](super::World). No mesh has the default one.
    pub struct MeshId;

    /// Handle of a material in a [`World`](super::World). No material has the default one.
    pub struct MaterialId;

    /// Handle of a light in a [`World`](super::World). No light has the default one.
    pub struct LightId;
}
