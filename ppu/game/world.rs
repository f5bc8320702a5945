//! The world: the content that a game changes from frame to frame, by handles.
//!
//! Owns the camera, background, lights, materials, objects, meshes, and the scene that is traced.
//! Invariants: a handle is valid until its object, light or material is removed, and is never
//! reused for another one; every number is in the range that the SPUs can represent; a world is
//! traced exactly like a scene with the same content.

mod check;
mod checksum;
mod content;
mod edits;
mod error;
mod ids;
mod material;
mod materials;
mod meshes;
mod objects;
mod pick;
mod terrain;
mod traced;

pub use error::{WorldError, WorldErrorKind};
pub use ids::{LightId, MaterialId, MeshId, ObjectId};
pub use material::{Light, Material};
pub use pick::{Pick, Target};

use std::borrow::Cow;

use glam::{DAffine3, DVec3};
use scenes::depth::DepthShading;
use scenes::{Fog, Sky, View, daylight};
use slotmap::{SecondaryMap, SlotMap};

use self::checksum::Checksum;
use self::content::{Object, WorldLight, WorldMaterial};
use self::edits::{Edits, Traced};
use self::meshes::WorldMesh;
use self::terrain::Terrain;
use crate::scene::mesh::gathered;
use crate::scene::{Look, Model, RenderOptions};

/// The light of a world that has none: the sun of a day, where it stands for the first view of a
/// [`World::new`].
fn default_light() -> scenes::Light {
    scenes::Light {
        line: 0,
        kind: scenes::LightKind::Directional { to_light: DVec3::new(1.0, 2.0, 1.5) },
        colour: Some(daylight::SUN),
    }
}

/// A scene that a game changes.
///
/// The cost of a change depends only on the change: its records are written in place, and the
/// bounding volumes above them are refitted. While the eye stands still, and if the framebuffer
/// keeps its contents (`keeps_contents`), the [`Engine`](crate::Engine) traces only the tiles that
/// a change can show in:
///
/// - Nothing has changed: no tiles.
/// - Depth shading: the tiles in which a changed sphere is or was visible. If the range of the
///   shading changes with the spheres, all tiles; [`World::set_fade`] prevents that.
/// - Whitted's model: the tiles in which a changed object is or was visible, those on which its
///   shadow falls or fell, and those in which mirrors, glass or objects with a game's own shader
///   are visible, because the object may show in them.
/// - A mesh in main memory has moved, or the ground has changed: all tiles.
/// - A light, the ambient light, the background, the eye or the [`RenderOptions`] have changed: all
///   tiles.
///
/// For every frame with any tiles to trace, the SPUs fetch the whole scene.
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
    background: Option<DVec3>,
    sky: Option<Sky>,
    fog: Option<Fog>,
    ambient: DVec3,
    render_options: RenderOptions,
    /// How whoever looks at the world wants it, instead of the options' own choice.
    look: Option<Look>,
    fade: Option<DepthShading>,
    has_default_light: bool,
    materials: SlotMap<MaterialId, WorldMaterial>,
    lights: SlotMap<LightId, WorldLight>,
    objects: SlotMap<ObjectId, Object>,
    meshes: SlotMap<MeshId, WorldMesh>,
    terrain: Option<Terrain>,
    /// The scene that was traced last.
    traced: Option<Traced>,
    /// For how many pictures in a row a new scene was made.
    new_scenes: u32,
    /// The changes since then.
    edits: Edits,
}

impl Default for World {
    fn default() -> Self {
        Self::new()
    }
}

impl World {
    /// An empty world. The eye is at (0, 0, 10) and looks at the origin; y is up.
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
            background: None,
            sky: None,
            fog: None,
            ambient: DVec3::ZERO,
            render_options: RenderOptions::default(),
            look: None,
            fade: None,
            has_default_light: true,
            materials: SlotMap::with_key(),
            lights: SlotMap::with_key(),
            objects: SlotMap::with_key(),
            meshes: SlotMap::with_key(),
            terrain: None,
            traced: None,
            new_scenes: 0,
            edits: Edits::default(),
        }
    }

    /// A world with a scene's content. Objects, materials and lights keep the scene's order, and
    /// error messages name them by their lines in the file. With Whitted's model, more than 512
    /// triangles become a mesh and are no objects.
    ///
    /// # Errors
    /// The scene's content breaks a rule of the world; see [`WorldError`]. The error names the file
    /// and the line of an object, material or light.
    #[track_caller]
    pub fn from_nff(
        scene: &scenes::Scene,
        render_options: RenderOptions,
    ) -> Result<Self, WorldError> {
        let scene = match render_options.is_whitted(scene.lights.len()) {
            true => gathered(scene),
            false => Cow::Borrowed(scene),
        };
        let scene = &*scene;
        let at = |line| {
            move |source: WorldError| WorldErrorKind::At {
                file: scene.name.clone(),
                line,
                source: Box::new(source.into_kind()),
            }
        };
        let mut world = Self::new();
        world.name.clone_from(&scene.name);
        world.has_default_light = false;
        world.set_render_options(render_options);
        world.set_view(scene.view.clone())?;
        world.set_background(scene.background)?;
        world.set_sky(scene.sky)?;
        world.set_fog(scene.fog)?;
        world.set_ambient(scene.ambient)?;
        for &scenes::Light { line, kind, colour } in &scene.lights {
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
        if let Some(mesh) = &scene.mesh {
            world.add_mesh(mesh.clone(), &ids, DAffine3::IDENTITY)?;
        }
        if let Some(heights) = &scene.heights {
            let material = ids.get(heights.material as usize).copied();
            world.add_terrain(heights.clone(), material.unwrap_or_default())?;
        }
        Ok(world)
    }

    /// The world's content as a scene, without the hidden objects.
    #[must_use]
    pub fn to_nff(&self) -> scenes::Scene {
        self.content(|object| object.visible)
    }

    fn content(&self, wanted: impl Fn(&Object) -> bool) -> scenes::Scene {
        let mut place = SecondaryMap::new();
        place.extend(self.materials.keys().zip(0..));
        let objects = self.objects.values().filter(|object| wanted(object));
        let (background, sky) = self.backdrop();
        scenes::Scene {
            name: self.name.clone(),
            view: self.view.clone(),
            background,
            sky,
            fog: self.fog,
            ambient: self.ambient_light(),
            lights: (1..)
                .zip(self.lights.values())
                .map(|(line, entry)| {
                    let Light { kind, colour } = entry.light;
                    let line = entry.line.unwrap_or(line);
                    scenes::Light { line, kind, colour }
                })
                .chain(self.needs_light().then(default_light))
                .collect(),
            materials: (1..)
                .zip(self.materials.values())
                .map(|(line, entry)| scenes::Material {
                    line: entry.line.unwrap_or(line),
                    ..entry.material.clone()
                })
                .collect(),
            objects: (1..)
                .zip(objects)
                .map(|(line, object)| scenes::Object {
                    line: object.line.unwrap_or(line),
                    material: place.get(object.material).copied().unwrap_or_default(),
                    shape: object.shape.clone(),
                })
                .collect(),
            mesh: self.joined_mesh(&place),
            heights: self.placed_terrain(&place),
            height_map: None,
        }
    }

    /// Whether the default light shines: nothing else does, and nothing asks for depth shading.
    fn needs_light(&self) -> bool {
        self.has_default_light
            && self.lights.is_empty()
            && self.fade.is_none()
            && self.render_options.model == Model::Scene
    }

    /// The number of lights in the traced scene.
    fn light_count(&self) -> usize {
        self.lights.len() + usize::from(self.needs_light())
    }

    /// The ambient light of the traced scene.
    fn ambient_light(&self) -> DVec3 {
        if self.needs_light() && self.ambient == DVec3::ZERO {
            daylight::AMBIENT
        } else {
            self.ambient
        }
    }

    /// Whether a world without lights gets a default light, as a [`World::new`] does: a sun over
    /// the right shoulder, some ambient light, and the sky of a day unless the world has a
    /// background. It goes out as soon as a light is added. Without it, and without lights, a world
    /// is traced with depth shading, as it is with [`Model::Depth`] or [`World::set_fade`].
    pub fn set_default_light(&mut self, is_wanted: bool) {
        if self.has_default_light != is_wanted {
            self.has_default_light = is_wanted;
            self.edits.rebuild = true;
        }
    }

    /// The world's name in messages and statistics.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Sets the world's name.
    pub fn set_name(&mut self, name: &str) {
        name.clone_into(&mut self.name);
        self.edits.rebuild = true;
    }

    /// The view. Its resolution is not used: the picture is as large as the framebuffer.
    #[must_use]
    pub fn view(&self) -> &View {
        &self.view
    }

    /// Sets the view: moves or turns the eye, or changes its angle.
    ///
    /// # Errors
    /// A number is out of range, or the view shows nothing.
    #[track_caller]
    pub fn set_view(&mut self, view: View) -> Result<(), WorldError> {
        for (what, place) in [("view from", view.from), ("view at", view.at), ("view up", view.up)]
        {
            check::vector(what, place)?;
        }
        // Any size will do: the camera's other conditions concern only the view.
        view.camera(2, 2)?;
        self.view = view;
        Ok(())
    }

    /// Moves the eye to `from`, and turns it towards `at`.
    ///
    /// # Errors
    /// As for [`World::set_view`].
    #[track_caller]
    pub fn look_from(
        &mut self,
        from: impl Into<DVec3>,
        at: impl Into<DVec3>,
    ) -> Result<(), WorldError> {
        self.set_view(View { from: from.into(), at: at.into(), ..self.view.clone() })
    }

    /// The background: the colour of rays that hit nothing, or with a sky of those to the horizon.
    #[must_use]
    pub fn background(&self) -> DVec3 {
        self.background.unwrap_or_default()
    }

    /// Sets the background.
    ///
    /// # Errors
    /// A number is out of range.
    #[track_caller]
    pub fn set_background(&mut self, colour: impl Into<DVec3>) -> Result<(), WorldError> {
        let colour = colour.into();
        check::vector("background", colour)?;
        self.background = Some(colour);
        Ok(())
    }

    /// The background's gradient, if [`World::set_sky`] set one.
    #[must_use]
    pub fn sky(&self) -> Option<Sky> {
        self.sky
    }

    /// Sets a gradient from the background at the horizon to another colour at the zenith, or none.
    /// Whitted's model shows it, directly and in mirrors and glass.
    ///
    /// # Errors
    /// A number is out of range, or the direction to the zenith is 0.
    #[track_caller]
    pub fn set_sky(&mut self, sky: Option<Sky>) -> Result<(), WorldError> {
        if let Some(Sky { zenith, up }) = sky {
            check::vector("sky", zenith)?;
            check::vector("direction to the zenith", up)?;
            if up == DVec3::ZERO {
                return Err(WorldErrorKind::NoZenith.into());
            }
        }
        self.sky = sky;
        Ok(())
    }

    /// The fog, if [`World::set_fog`] set any.
    #[must_use]
    pub fn fog(&self) -> Option<Fog> {
        self.fog
    }

    /// Sets fog, which hides what is far away, or none. Only Whitted's model shows it.
    ///
    /// # Errors
    /// A number is out of range, or the density is below 0.
    #[track_caller]
    pub fn set_fog(&mut self, fog: Option<Fog>) -> Result<(), WorldError> {
        if let Some(Fog { colour, density }) = fog {
            check::vector("fog", colour)?;
            check::vector("density of the fog", DVec3::splat(density))?;
            if density < 0.0 {
                return Err(WorldErrorKind::NegativeFog(density).into());
            }
        }
        self.fog = fog;
        Ok(())
    }

    /// The background of the traced scene and its gradient.
    fn backdrop(&self) -> (DVec3, Option<Sky>) {
        match self.background {
            None if self.sky.is_none() && self.needs_light() => {
                (daylight::HORIZON, Some(Sky::of_day(self.view.up)))
            }
            background => (background.unwrap_or_default(), self.sky),
        }
    }

    /// The ambient light's brightness in red, green and blue.
    #[must_use]
    pub fn ambient(&self) -> DVec3 {
        self.ambient
    }

    /// Sets the ambient light's brightness.
    ///
    /// # Errors
    /// A number is out of range.
    #[track_caller]
    pub fn set_ambient(&mut self, brightness: impl Into<DVec3>) -> Result<(), WorldError> {
        let brightness = brightness.into();
        check::vector("ambient light", brightness)?;
        self.ambient = brightness;
        Ok(())
    }

    /// The model that the world is rendered with, and the model's settings.
    #[must_use]
    pub fn render_options(&self) -> RenderOptions {
        self.render_options
    }

    /// Sets the model and its settings.
    pub fn set_render_options(&mut self, render_options: RenderOptions) {
        if self.render_options != render_options {
            self.render_options = render_options;
            self.edits.rebuild = true;
        }
    }

    /// Sets the look, which replaces that of its [`RenderOptions`]. This is for the program that
    /// shows a game, not for the game: [`Session::set_look`](super::Session::set_look).
    pub fn set_look(&mut self, look: Option<Look>) {
        if self.look != look {
            self.look = look;
            self.edits.rebuild = true;
        }
    }

    fn traced_options(&self) -> RenderOptions {
        let options = self.render_options;
        self.look.map_or(options, |look| look.of(options, self.light_count()))
    }

    /// The distances between which depth shading fades, if [`World::set_fade`] set them.
    #[must_use]
    pub fn fade(&self) -> Option<DepthShading> {
        self.fade
    }

    /// Sets the distances between which depth shading fades. With `None` they are those of the
    /// nearest and the farthest sphere, so the picture's brightness changes when these move.
    ///
    /// # Errors
    /// A distance is out of range or negative, or `far` is not above `near`.
    #[track_caller]
    pub fn set_fade(&mut self, fade: Option<DepthShading>) -> Result<(), WorldError> {
        if let Some(DepthShading { near, far }) = fade {
            check::fade(near, far)?;
        }
        self.fade = fade;
        Ok(())
    }

    /// A checksum of the world's content, the same on every machine. It covers objects, materials
    /// and lights in their order, but neither the handles nor the [`RenderOptions`].
    #[must_use]
    pub fn checksum(&self) -> u64 {
        let mut sum = Checksum::new();
        let View { from, at, up, angle, .. } = self.view;
        for vector in [from, at, up, self.background(), self.ambient] {
            sum.vector(vector);
        }
        if let Some(Sky { zenith, up }) = self.sky {
            sum.vector(zenith);
            sum.vector(up);
        }
        if let Some(Fog { colour, density }) = self.fog {
            sum.vector(colour);
            sum.float(density);
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
        if let Some(terrain) = &self.terrain {
            terrain.sum(&mut sum);
            if let Some(entry) = self.materials.get(terrain.material()) {
                sum.material(&entry.material);
            }
        }
        for mesh in self.meshes.values() {
            mesh.sum(&mut sum);
            for &id in mesh.used() {
                if let Some(entry) = self.materials.get(id) {
                    sum.material(&entry.material);
                }
            }
        }
        sum.number()
    }
}
