//! What of a world is not yet in the scene that is traced, and that scene.

use super::ids::{LightId, MaterialId, ObjectId};
use crate::scene::Scene;
use crate::scene::block::ShaderEntries;
use crate::spe::Program;

/// A scene that was traced.
pub(super) struct Traced {
    pub scene: Scene,
    pub shaders: ShaderEntries,
    /// Of which the shaders are.
    pub program: Program,
}

/// What is known of the trace of something in the world.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Tracing {
    /// Its number in the scene; nothing if it is not in there.
    pub number: Option<usize>,
    /// Whether it is among the edits.
    pub is_touched: bool,
}

/// What has been touched of a world since its scene was made or changed, and so has to be brought
/// into it. Where the picture then differs is not found here.
#[derive(Default)]
pub(super) struct Edits {
    /// Whether the scene has to be laid out anew.
    pub anew: bool,
    pub objects: Vec<ObjectId>,
    pub materials: Vec<MaterialId>,
    pub lights: Vec<LightId>,
    /// Numbers of objects that there are no more.
    pub removed: Vec<usize>,
}

impl Edits {
    pub fn object(&mut self, id: ObjectId, traced: &mut Tracing) {
        if !std::mem::replace(&mut traced.is_touched, true) {
            self.objects.push(id);
        }
    }

    pub fn material(&mut self, id: MaterialId, traced: &mut Tracing) {
        if !std::mem::replace(&mut traced.is_touched, true) {
            self.materials.push(id);
        }
    }

    pub fn light(&mut self, id: LightId, traced: &mut Tracing) {
        if !std::mem::replace(&mut traced.is_touched, true) {
            self.lights.push(id);
        }
    }

    pub fn removed(&mut self, traced: &Tracing) {
        self.removed.extend(traced.number);
    }

    /// Forgets all, and keeps the memory.
    pub fn clear(&mut self) {
        self.anew = false;
        self.objects.clear();
        self.materials.clear();
        self.lights.clear();
        self.removed.clear();
    }
}
