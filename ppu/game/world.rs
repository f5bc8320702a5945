//! The world: what a game changes from frame to frame, by handles.
//!
//! Owns the content: camera, background, lights, materials and objects, and the scene that is
//! traced. Invariants: a handle is valid until what it stands for is removed, and is never
//! another's; every number is one that the SPUs have room for; a world is traced as a scene of the
//! same content would be.

mod check;
mod checksum;
mod content;
mod edits;
mod error;
mod ids;
mod material;
mod materials;
mod objects;
mod traced;

pub use error::WorldError;
pub use ids::{LightId, MaterialId, ObjectId};
pub use material::{Light, Material};

use glam::DVec3;
use nff::View;
use nff::depth::DepthShading;
use slotmap::{SecondaryMap, SlotMap};

use self::checksum::Checksum;
use self::content::{Object, WorldLight, WorldMaterial};
use self::edits::{Edits, Traced};
use crate::scene::RenderOptions;

/// A scene that a game changes.
///
/// What is changed costs what has changed: records are written in place and the trees above them
/// fitted again; nothing is said of the rest, and where the eye stands still the
/// [`Engine`](crate::Engine) traces only what the change shows in (`keeps_contents` of the
/// framebuffer permitting):
///
/// - nothing changed: nothing is traced;
/// - by depth shading: the tiles in which a changed sphere is or was seen; all, where the range of
///   the shading has changed with them, which [`World::set_fade`] prevents;
/// - by Whitted's model: the tiles in which a changed object is or was seen, and its shadows fall
///   or fell, and those in which mirrors, glass and objects with a game's own shader are seen, in
///   all of which it may show;
/// - all, when a light, the ambient light, the background, the eye or the look has changed.
///
/// The SPUs fetch the whole scene for each frame of which anything is traced.
///
/// ```
/// use cellray::game::{DVec3, Light, Material, World};
///
/// let mut world = World::new();
/// let red = world.add_material(Material::matte(0.9, 0.2, 0.1))?;
/// let ball = world.add_sphere(DVec3::ZERO, 0.5, red)?;
/// world.add_light(Light::at(DVec3::new(5.0, 9.0, 5.0)))?;
/// world.look_from(DVec3::new(0.0, 2.0, 8.0), DVec3::ZERO)?;
///
/// world.move_to(ball, DVec3::new(0.0, 1.0, 0.0))?;
/// world.recolour(red, DVec3::new(0.1, 0.2, 0.9))?;
/// world.remove(ball)?;
/// assert!(world.move_to(ball, DVec3::ZERO).is_err());
/// # Ok::<(), cellray::game::WorldError>(())
/// ```
pub struct World {
    name: String,
    view: View,
    background: DVec3,
    ambient: DVec3,
    render_options: RenderOptions,
    fade: Option<DepthShading>,
    materials: SlotMap<MaterialId, WorldMaterial>,
    lights: SlotMap<LightId, WorldLight>,
    objects: SlotMap<ObjectId, Object>,
    /// What was traced last.
    traced: Option<Traced>,
    /// What of the world has been touched since.
    edits: Edits,
}

impl Default for World {
    fn default() -> Self {
        Self::new()
    }
}

impl World {
    /// An empty black world; the eye is ten before the origin and looks at it, y is up.
    #[must_use]
    pub fn new() -> Self {
        Self {
            name: "world".into(),
            view: View {
                from: DVec3::new(0.0, 0.0, 10.0),
                at: DVec3::ZERO,
                up: DVec3::Y,
                angle: 40.0,
                hither: 0.0,
                resolution: (640, 360),
            },
            background: DVec3::ZERO,
            ambient: DVec3::ZERO,
            render_options: RenderOptions::default(),
            fade: None,
            materials: SlotMap::with_key(),
            lights: SlotMap::with_key(),
            objects: SlotMap::with_key(),
            traced: None,
            edits: Edits::default(),
        }
    }

    /// The world that a scene shows. Its objects, materials and lights are in the scene's order,
    /// and called by the lines that they are in.
    pub fn from_nff(scene: &nff::Scene, render_options: RenderOptions) -> Result<Self, WorldError> {
        let at = |line| {
            move |source| WorldError::At {
                file: scene.name.clone(),
                line,
                source: Box::new(source),
            }
        };
        let mut world = Self::new();
        world.name.clone_from(&scene.name);
        world.set_render_options(render_options);
        world.set_view(scene.view.clone())?;
        world.set_background(scene.background)?;
        world.set_ambient(scene.ambient)?;
        for &nff::Light { line, kind, colour } in &scene.lights {
            let id = world.add_light(Light { kind, colour }).map_err(at(line))?;
            world.lights[id].line = Some(line);
        }
        let mut ids = Vec::new();
        for material in &scene.materials {
            let id = world.add_material(material.into());
            let id = id.map_err(at(material.line))?;
            world.materials[id].line = Some(material.line);
            ids.push(id);
        }
        for object in &scene.objects {
            let material = ids.get(object.material as usize).copied();
            let id = world.add(object.shape.clone(), material.unwrap_or_default());
            let id = id.map_err(at(object.line))?;
            world.objects[id].line = Some(object.line);
        }
        Ok(world)
    }

    /// What the world shows, as a scene: what is not visible is left out.
    #[must_use]
    pub fn to_nff(&self) -> nff::Scene {
        self.content(|object| object.visible)
    }

    fn content(&self, wanted: impl Fn(&Object) -> bool) -> nff::Scene {
        let mut place = SecondaryMap::new();
        place.extend(self.materials.keys().zip(0..));
        let objects = self.objects.values().filter(|object| wanted(object));
        nff::Scene {
            name: self.name.clone(),
            view: self.view.clone(),
            background: self.background,
            ambient: self.ambient,
            lights: (1..)
                .zip(self.lights.values())
                .map(|(line, entry)| {
                    let Light { kind, colour } = entry.light;
                    let line = entry.line.unwrap_or(line);
                    nff::Light { line, kind, colour }
                })
                .collect(),
            materials: (1..)
                .zip(self.materials.values())
                .map(|(line, entry)| nff::Material {
                    line: entry.line.unwrap_or(line),
                    ..entry.material.clone()
                })
                .collect(),
            objects: (1..)
                .zip(objects)
                .map(|(line, object)| nff::Object {
                    line: object.line.unwrap_or(line),
                    material: place.get(object.material).copied().unwrap_or_default(),
                    shape: object.shape.clone(),
                })
                .collect(),
        }
    }

    /// What the world is called in messages and statistics.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Calls it so.
    pub fn set_name(&mut self, name: &str) {
        name.clone_into(&mut self.name);
        self.edits.anew = true;
    }

    /// The eye. Its resolution is not looked at: the picture is as large as the framebuffer.
    #[must_use]
    pub fn view(&self) -> &View {
        &self.view
    }

    /// Moves the eye, or turns it.
    pub fn set_view(&mut self, view: View) -> Result<(), WorldError> {
        for (what, place) in [
            ("view from", view.from),
            ("view at", view.at),
            ("view up", view.up),
        ] {
            check::vector(what, place)?;
        }
        // Of any size: the camera's other conditions are the view's own.
        view.camera(2, 2)?;
        self.view = view;
        Ok(())
    }

    /// Moves the eye to a place and turns it to another.
    pub fn look_from(&mut self, from: DVec3, at: DVec3) -> Result<(), WorldError> {
        self.set_view(View {
            from,
            at,
            ..self.view.clone()
        })
    }

    /// Colour where nothing is hit.
    #[must_use]
    pub fn background(&self) -> DVec3 {
        self.background
    }

    /// Changes that colour.
    pub fn set_background(&mut self, colour: DVec3) -> Result<(), WorldError> {
        check::vector("background", colour)?;
        self.background = colour;
        Ok(())
    }

    /// Brightness of the light that is everywhere.
    #[must_use]
    pub fn ambient(&self) -> DVec3 {
        self.ambient
    }

    /// Changes that brightness.
    pub fn set_ambient(&mut self, brightness: DVec3) -> Result<(), WorldError> {
        check::vector("ambient light", brightness)?;
        self.ambient = brightness;
        Ok(())
    }

    /// How the world is made to look: the model, and its settings.
    #[must_use]
    pub fn render_options(&self) -> RenderOptions {
        self.render_options
    }

    /// Makes it look otherwise.
    pub fn set_render_options(&mut self, render_options: RenderOptions) {
        if self.render_options != render_options {
            self.render_options = render_options;
            self.edits.anew = true;
        }
    }

    /// Distances between which depth shading fades, where they were given.
    #[must_use]
    pub fn fade(&self) -> Option<DepthShading> {
        self.fade
    }

    /// Gives depth shading its distances. Without them (`None`) they are those of the nearest and
    /// the farthest sphere, and the picture's brightness changes where these move.
    pub fn set_fade(&mut self, fade: Option<DepthShading>) -> Result<(), WorldError> {
        if let Some(DepthShading { near, far }) = fade {
            check::fade(near, far)?;
        }
        self.fade = fade;
        Ok(())
    }

    /// A number that tells this world's content from another's, the same on every machine: of
    /// objects, materials and lights in their order, the handles apart; of the look nothing.
    #[must_use]
    pub fn checksum(&self) -> u64 {
        let mut sum = Checksum::new();
        let View {
            from,
            at,
            up,
            angle,
            ..
        } = self.view;
        for vector in [from, at, up, self.background, self.ambient] {
            sum.vector(vector);
        }
        sum.float(angle);
        for entry in self.lights.values() {
            sum.light(&entry.light);
        }
        for object in self.objects.values() {
            sum.shape(&object.shape);
            sum.word(u64::from(object.visible));
            if let Some(entry) = self.materials.get(object.material) {
                sum.material(&entry.material);
            }
        }
        sum.number()
    }
}
