//! Keeps the traced scene in step with its world.
//!
//! Invariants: after [`World::scene`] the scene equals one that is newly made of the world, except
//! for the order of its records and the shape of its trees, which no picture shows. If nothing was
//! added, this allocates no memory.

use std::borrow::Cow;
use std::sync::Arc;

use scenes::{Mesh, Shape};

use super::content::{Object, WorldMaterial};
use super::edits::Traced;
use super::{World, WorldError};
use crate::scene::block::ShaderEntries;
use crate::scene::mesh::{are_many, gathered, gathered_all};
use crate::scene::{BuildBy, RefitBy, Scene, SceneBlock, SceneError, Sphere};
use crate::spe::Program;
use protocol::layout::MAX_SPHERES;

/// From this number of moved vertices on, SPUs refit a mesh. Then the PPU is spared about as much
/// time as the SPUs need to trace the whole picture: `docs/meshes.md` has the measurements.
const SPUS_REFIT: usize = 1000;

/// From this number of pictures in a row on that need a new tree of a mesh, SPUs build it. They
/// take a tenth of the time that the PPU does, but rays make more tests with it, so a tree that
/// lasts is not theirs. Spheres and cones in main memory that move would take the PPU even longer
/// than a mesh, so it builds no tree of these.
const SHORT_LIVED: u32 = 3;

impl WorldMaterial {
    /// Sets the material's number in the scene, which error messages use if it has no line.
    fn number(&mut self, number: usize) {
        self.traced.number = Some(number);
        self.material.line = self.line.unwrap_or(number as u32 + 1);
    }
}

impl World {
    /// The scene of the world in its current state, for an [`Engine`](crate::Engine) that runs
    /// `program`.
    ///
    /// Changes since the last call are made in place. No memory is allocated if objects were moved,
    /// shown, hidden or given other materials, or if materials, lights or the eye have changed.
    /// Added objects and materials use the space of removed ones, or spare capacity. If there is
    /// none, a new scene is made. A new scene is also made when lights or meshes are added or
    /// removed, when the [`RenderOptions`](crate::scene::RenderOptions) change, when a polygon
    /// changes that is in main memory, or when spheres and cones there begin to change, or are
    /// added, or are there beside a mesh. Meshes, spheres and cones that move get new blocks.
    ///
    /// # Errors
    /// - The world doesn't fit the SPUs' local store.
    /// - The program lacks a shader that a material names.
    #[track_caller]
    pub fn scene(&mut self, program: &Program) -> Result<&Scene, WorldError> {
        let is_whitted = self.render_options.is_whitted(self.light_count());
        let block = self.traced.as_ref().and_then(|traced| traced.scene.block());
        let streams_objects = block.is_some_and(SceneBlock::streams_objects);
        let objects_move = streams_objects && self.edits.have_objects();
        let traced = self.traced.take().filter(|traced| {
            !self.edits.rebuild
                && std::ptr::eq(traced.program.image(), program.image())
                && traced.scene.block().is_some() == is_whitted
        });
        let changed = match traced {
            Some(mut traced) => self.change(&mut traced)?.then_some(traced),
            None => None,
        };
        let mut traced = match changed {
            Some(traced) => {
                self.new_scenes = 0;
                traced
            }
            None => {
                self.new_scenes = self.new_scenes.saturating_add(1);
                self.lay_out(program, objects_move)?
            }
        };
        traced.scene.write()?;
        if self.edits.moved_meshes || self.edits.rebuild {
            self.meshes_are_traced();
        }
        self.edits.clear();
        Ok(&self.traced.insert(traced).scene)
    }

    /// Makes a new scene of the whole world. `objects_move`: spheres and cones in main memory have
    /// changed.
    fn lay_out(&mut self, program: &Program, objects_move: bool) -> Result<Traced, WorldError> {
        // An image without a table has no shaders that a material could name.
        let shaders = ShaderEntries::new(program.shaders().unwrap_or_default());
        // Whitted's model keeps space for hidden objects.
        let mut options = self.traced_options();
        let can_refit = !program.build_code().is_empty();
        let is_short_lived = self.new_scenes >= SHORT_LIVED;
        options.build_by = match options.build_by {
            Some(BuildBy::SpuCodes) if !can_refit => Some(BuildBy::PpuCodes),
            None if (is_short_lived || objects_move) && can_refit => Some(BuildBy::SpuCodes),
            chosen => chosen,
        };
        let is_whitted = options.is_whitted(self.light_count());
        let shown = self.content(|object| object.visible);
        let has_hidden = self.objects.values().any(|object| !object.visible);
        let gathered = match is_whitted {
            true => gathered(&shown),
            false => Cow::Borrowed(&shown),
        };
        let mut has_gathered = matches!(gathered, Cow::Owned(_));
        let mut keeps_hidden = is_whitted && has_hidden && !has_gathered;
        let mut content = match keeps_hidden {
            true => Cow::Owned(self.content(|_| true)),
            false => gathered,
        };
        let streams_objects =
            |scene: &Scene| scene.block().is_some_and(SceneBlock::streams_objects);
        let mut outcome = Scene::with_spare_capacity(&content, options, &shaders);
        if keeps_hidden && outcome.as_ref().map_or(true, streams_objects) {
            keeps_hidden = false;
            content = Cow::Borrowed(&shown);
            outcome = Scene::with_spare_capacity(&content, options, &shaders);
        }
        if let Err(SceneError::Block(error)) = &outcome
            && error.is_out_of_memory()
            && let Some(all) = gathered_all(&shown)
        {
            has_gathered = true;
            content = Cow::Owned(all);
            outcome = Scene::with_spare_capacity(&content, options, &shaders);
        }
        let mut scene = outcome?;
        scene.check_streaming(program)?;
        for (number, entry) in self.materials.values_mut().enumerate() {
            entry.number(number);
        }
        for (number, entry) in self.lights.values_mut().enumerate() {
            entry.traced.number = Some(number);
        }
        let mut numbers = 0..;
        let mut shown_objects = shown.objects.iter();
        let mut rest = content.objects.iter().peekable();
        for object in self.objects.values_mut() {
            let in_scene = is_whitted && (object.visible || keeps_hidden);
            // What was gathered is missing among the other objects, which have kept their order.
            let shown = match object.visible {
                true => shown_objects.next().filter(|_| has_gathered),
                false => None,
            };
            object.traced.is_in_mesh = shown.is_some_and(|shown| rest.next_if_eq(&shown).is_none());
            let is_numbered = in_scene && !object.traced.is_in_mesh;
            object.traced.number = is_numbered.then(|| numbers.next()).flatten();
            let Some(number) = object.traced.number else {
                continue;
            };
            if let Some(block) = scene.block_mut().filter(|_| !object.visible) {
                block.hide_object(number);
            }
        }
        scene.set_view(&self.view);
        if !is_whitted {
            self.set_spheres(&mut scene)?;
        }
        let mesh = content.mesh.clone();
        Ok(Traced { scene, shaders, program: *program, mesh, has_gathered, can_refit })
    }

    /// Brings the world's changes into a scene; `false` if they don't fit.
    fn change(&mut self, traced: &mut Traced) -> Result<bool, WorldError> {
        let Traced { scene, shaders, mesh, has_gathered, can_refit, .. } = traced;
        let has_other_view = *scene.view() != self.view;
        scene.set_view(&self.view);
        let (background, sky) = self.backdrop();
        scene.set_background(background, sky, self.fog, shaders)?;
        if let Some(block) = scene.block_mut() {
            if let Some(terrain) = self.terrain.as_ref().filter(|_| !self.edits.ground.is_empty()) {
                block.shape_ground(terrain.field(), &self.edits.ground);
            }
            return Ok(self.keeps_polygons(*has_gathered)
                && self.move_meshes(scene, mesh, *can_refit, has_other_view)
                && self.change_whitted(scene, shaders)?);
        }
        self.set_spheres(scene)?;
        Ok(true)
    }

    /// Whether no polygon has changed that is in main memory, or would be in a new scene.
    fn keeps_polygons(&self, has_gathered: bool) -> bool {
        let is_polygon = |id| {
            let shape = self.objects.get(id).map(|object| &object.shape);
            matches!(shape, Some(Shape::Polygon { .. } | Shape::Patch { .. }))
        };
        let edits = &self.edits;
        if !edits.may_have_polygons || !edits.objects.iter().copied().any(is_polygon) {
            return true;
        }
        let visible = self.objects.values().filter(|object| object.visible);
        !has_gathered && !are_many(visible.map(|object| &object.shape))
    }

    /// Brings the places of meshes into a scene; `false` if it needs another tree.
    fn move_meshes(
        &self,
        scene: &mut Scene,
        mesh: &mut Option<Arc<Mesh>>,
        can_refit: bool,
        has_other_view: bool,
    ) -> bool {
        let block = scene.block_mut();
        if !self.edits.moved_meshes {
            // All rays are traced again for another view.
            return !has_other_view || block.is_none_or(SceneBlock::keep_mesh);
        }
        let (Some(block), Some(mesh)) = (block, mesh) else {
            return false;
        };
        if block.mesh().is_none() {
            return false;
        }
        let mesh = Arc::make_mut(mesh);
        let moved = self.write_moved(mesh);
        if self.have_other_shapes() && block.lacks_triangles(mesh) {
            return false;
        }
        // Where few vertices move, the PPU finds the parts of the picture that stay as they are.
        let is_worth_it = moved >= SPUS_REFIT && 2 * moved >= mesh.positions.len();
        let by = match self.render_options.refit_by {
            _ if !can_refit => RefitBy::Ppu,
            Some(by) => by,
            None if is_worth_it => RefitBy::Spus,
            None => RefitBy::Ppu,
        };
        block.refit_mesh(mesh, by)
    }

    fn set_spheres(&self, scene: &mut Scene) -> Result<(), WorldError> {
        let colour = self.traced_options().colour;
        let drawn = |object: &Object| match object.shape {
            Shape::Sphere { centre, radius } if radius > 0.0 && object.visible => {
                let entry = self.materials.get(object.material)?;
                Some(Sphere { centre, radius, colour: colour.light(entry.material.colour) })
            }
            _ => None,
        };
        let count = self.objects.values().filter_map(drawn).count();
        if count > MAX_SPHERES as usize {
            let file = self.name.clone();
            return Err(SceneError::TooManySpheres { file, count }.into());
        }
        scene.set_spheres(self.objects.values().filter_map(drawn), self.fade);
        Ok(())
    }

    fn change_whitted(
        &mut self,
        scene: &mut Scene,
        shaders: &ShaderEntries,
    ) -> Result<bool, WorldError> {
        let Some(block) = scene.block_mut() else {
            return Ok(false);
        };
        if self.edits.have_objects() && !block.may_change_objects()
            || !block.set_eye(self.view.from)
        {
            return Ok(false);
        }
        let ambient = self.ambient_light();
        let Self { edits, objects, materials, lights, .. } = self;
        block.set_ambient(ambient).map_err(SceneError::from)?;
        for number in &edits.removed {
            block.remove_object(*number);
        }
        for id in &edits.lights {
            let Some(entry) = lights.get(*id) else {
                continue;
            };
            let (number, light) = (entry.traced.number, entry.light);
            let Some(number) = number else {
                return Ok(false);
            };
            let fits = block.set_light(number, light.kind, light.colour);
            if !fits.map_err(SceneError::from)? {
                return Ok(false);
            }
        }
        for id in &edits.materials {
            let Some(entry) = materials.get_mut(*id) else {
                continue;
            };
            let number = entry.traced.number.or_else(|| block.add_material());
            let Some(number) = number else {
                return Ok(false);
            };
            entry.number(number);
            let fits = block.set_material(number, &entry.material, shaders);
            if !fits.map_err(SceneError::from)? {
                return Ok(false);
            }
        }
        // Spheres that move may be ten thousand. The world has checked their numbers. What is left
        // is for the loop below.
        if let Some(mut spheres) = block.moving_spheres() {
            edits.objects.retain(|id| {
                let Some(object) = objects.get(*id) else { return false };
                let Shape::Sphere { centre, radius } = object.shape else { return true };
                let (Some(number), true) = (object.traced.number, object.visible) else {
                    return true;
                };
                let Some(entry) = materials.get(object.material) else { return true };
                let Some(material) = entry.traced.number else { return true };
                !spheres.set(number, (centre, radius), (material, &entry.material))
            });
        }
        for id in &edits.objects {
            let Some(object) = objects.get_mut(*id) else {
                continue;
            };
            let entry = materials.get(object.material);
            let material = entry.and_then(|entry| Some((entry.traced.number?, &entry.material)));
            let Some(material) = material else {
                return Ok(false);
            };
            let (shape, traced) = (&object.shape, &mut object.traced);
            let fits = match (traced.number, object.visible) {
                (None, false) => Ok(true),
                (None, true) => block.add_object(shape, material, shaders).map(|number| {
                    traced.number = number;
                    number.is_some()
                }),
                (Some(number), true) => block.set_object(number, shape, material, shaders),
                (Some(number), false) => {
                    block.hide_object(number);
                    Ok(true)
                }
            };
            if !fits.map_err(SceneError::from)? {
                return Ok(false);
            }
        }
        Ok(block.move_objects() && block.bound_chains())
    }
}
