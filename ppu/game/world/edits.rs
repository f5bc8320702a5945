//! The scene that was traced last, and the changes of the world that aren't in it yet.

use std::sync::Arc;

use scenes::{HeightRegion, Mesh, Shape};

use super::content::Object;
use super::ids::{LightId, MaterialId, ObjectId};
use crate::scene::Scene;
use crate::scene::block::ShaderEntries;
use crate::spe::Program;

/// The scene that was traced last.
pub(super) struct Traced {
    pub scene: Scene,
    pub shaders: ShaderEntries,
    /// The program that has the shaders.
    pub program: Program,
    /// All meshes as one, with the polygons that do not fit into local store.
    pub mesh: Option<Arc<Mesh>>,
    /// Whether there are such polygons.
    pub has_gathered: bool,
    /// Whether the program's SPUs can refit meshes.
    pub can_refit: bool,
}

/// Where an object, light or material is in the traced scene.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct SceneEntry {
    /// Its number in the scene; `None` if it isn't in the scene.
    pub number: Option<usize>,
    /// The number of [`Edits::clear`] that forgets its last change; 0 if it has never changed.
    touched: u64,
    /// Whether it is a polygon that is part of the scene's mesh.
    pub is_in_mesh: bool,
}

/// The changes of a world that its scene doesn't have yet. Where they change the picture is found
/// elsewhere, in `ppu/work/snapshot.rs`.
#[derive(Default)]
pub(super) struct Edits {
    /// Whether a new scene must be made.
    pub rebuild: bool,
    pub objects: Vec<ObjectId>,
    /// Whether there may be a polygon among the objects.
    pub may_have_polygons: bool,
    pub materials: Vec<MaterialId>,
    pub lights: Vec<LightId>,
    /// Whether meshes have other places.
    pub moved_meshes: bool,
    /// Where the ground was changed.
    pub ground: HeightRegion,
    /// Numbers of removed objects.
    pub removed: Vec<usize>,
    /// How many times all changes were forgotten.
    clears: u64,
}

impl SceneEntry {
    /// Whether it is the first change that clear number `clear` forgets. The marks of ten thousand
    /// objects need not be wiped thus.
    #[inline]
    fn touch(&mut self, clear: u64) -> bool {
        std::mem::replace(&mut self.touched, clear) != clear
    }
}

impl Edits {
    #[inline]
    pub fn object(&mut self, id: ObjectId, object: &mut Object) {
        self.may_have_polygons |=
            matches!(object.shape, Shape::Polygon { .. } | Shape::Patch { .. });
        if object.traced.touch(self.clears + 1) {
            self.objects.push(id);
        }
    }

    pub fn material(&mut self, id: MaterialId, traced: &mut SceneEntry) {
        if traced.touch(self.clears + 1) {
            self.materials.push(id);
        }
    }

    pub fn light(&mut self, id: LightId, traced: &mut SceneEntry) {
        if traced.touch(self.clears + 1) {
            self.lights.push(id);
        }
    }

    /// Whether objects have changed or were removed.
    pub fn have_objects(&self) -> bool {
        !(self.objects.is_empty() && self.removed.is_empty())
    }

    pub fn removed(&mut self, traced: &SceneEntry) {
        self.rebuild |= traced.is_in_mesh;
        self.removed.extend(traced.number);
    }

    /// Forgets all changes, and keeps the memory.
    pub fn clear(&mut self) {
        self.clears += 1;
        self.may_have_polygons = false;
        self.rebuild = false;
        self.moved_meshes = false;
        self.ground = HeightRegion::default();
        self.objects.clear();
        self.materials.clear();
        self.lights.clear();
        self.removed.clear();
    }
}
