//! The world: what a game changes from frame to frame, by handles.
//!
//! Owns the content: camera, background, lights, materials and objects, and the scene that is traced.
//! Invariants: a handle is valid until what it stands for is removed, and is never another's; every number is
//! one that the SPUs have room for; a world is traced as a scene of the same content would be.

mod check;
mod checksum;
mod error;
mod material;
mod traced;

pub use error::WorldError;
pub use material::{Light, Material};

use glam::DVec3;
use nff::depth::DepthShading;
use nff::{Shape, View};
use slotmap::{SecondaryMap, SlotMap, new_key_type};

use self::checksum::Checksum;
use self::traced::{Changes, Traced, Tracing};
use crate::scene::Look;

new_key_type! {
    /// Handle of an object in a [`World`]; the default one is none's.
    pub struct ObjectId;

    /// Handle of a material in a [`World`]; the default one is none's.
    pub struct MaterialId;

    /// Handle of a light in a [`World`]; the default one is none's.
    pub struct LightId;
}

struct Object {
    shape: Shape,
    material: MaterialId,
    visible: bool,
    fixed: bool,
    traced: Tracing,
}

struct Stuff {
    material: nff::Material,
    /// Objects that are made of it.
    users: u32,
    traced: Tracing,
}

struct Lamp {
    light: Light,
    traced: Tracing,
}

/// A scene that a game changes.
///
/// What is changed costs what has changed: records are written in place and the trees above them fitted again;
/// nothing is said of the rest, and where the eye stands still the [`Engine`](crate::Engine) traces only what the
/// change shows in (`keeps_contents` of the framebuffer permitting):
///
/// - nothing changed: nothing is traced;
/// - by depth shading: the tiles in which a changed sphere is or was seen; all, where the range of the shading has
///   changed with them, which [`World::set_fade`] prevents;
/// - by Whitted's model: the tiles in which a changed object is or was seen, and its shadows fall or fell, and
///   those in which mirrors, glass and objects with a game's own shader are seen, in all of which it may show;
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
    look: Look,
    fade: Option<DepthShading>,
    materials: SlotMap<MaterialId, Stuff>,
    lights: SlotMap<LightId, Lamp>,
    objects: SlotMap<ObjectId, Object>,
    /// What was traced last.
    traced: Option<Traced>,
    /// How the world differs from that.
    changes: Changes,
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
            look: Look::default(),
            fade: None,
            materials: SlotMap::with_key(),
            lights: SlotMap::with_key(),
            objects: SlotMap::with_key(),
            traced: None,
            changes: Changes::default(),
        }
    }

    /// The world that a scene shows. Its objects, materials and lights are in the scene's order.
    pub fn from_nff(scene: &nff::Scene, look: Look) -> Result<Self, WorldError> {
        let mut world = Self::new();
        world.name.clone_from(&scene.name);
        world.set_look(look);
        world.set_view(scene.view.clone())?;
        world.set_background(scene.background)?;
        world.set_ambient(scene.ambient)?;
        for &nff::Light { kind, colour, .. } in &scene.lights {
            world.add_light(Light { kind, colour })?;
        }
        let materials = scene.materials.iter();
        let ids: Vec<_> = materials
            .map(|material| world.add_material(material.into()))
            .collect::<Result<_, _>>()?;
        for object in &scene.objects {
            let material = ids.get(object.material as usize).copied();
            world.add(object.shape.clone(), material.unwrap_or_default())?;
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
                .map(|(line, lamp)| {
                    let Light { kind, colour } = lamp.light;
                    nff::Light { line, kind, colour }
                })
                .collect(),
            materials: (1..)
                .zip(self.materials.values())
                .map(|(line, stuff)| nff::Material {
                    line,
                    ..stuff.material.clone()
                })
                .collect(),
            objects: (1..)
                .zip(objects)
                .map(|(line, object)| nff::Object {
                    line,
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
        self.changes.anew = true;
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
        if self.view != view {
            self.view = view;
            self.changes.view = true;
        }
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
        if self.background != colour {
            self.background = colour;
            self.changes.background = true;
        }
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
        if self.ambient != brightness {
            self.ambient = brightness;
            self.changes.ambient = true;
        }
        Ok(())
    }

    /// How the world is made to look: the model, and its settings.
    #[must_use]
    pub fn look(&self) -> Look {
        self.look
    }

    /// Makes it look otherwise.
    pub fn set_look(&mut self, look: Look) {
        if self.look != look {
            self.look = look;
            self.changes.anew = true;
        }
    }

    /// Distances between which depth shading fades, where they were given.
    #[must_use]
    pub fn fade(&self) -> Option<DepthShading> {
        self.fade
    }

    /// Gives depth shading its distances. Without them (`None`) they are those of the nearest and the
    /// farthest sphere, and the picture's brightness changes where these move.
    pub fn set_fade(&mut self, fade: Option<DepthShading>) -> Result<(), WorldError> {
        if let Some(DepthShading { near, far }) = fade {
            check::fade(near, far)?;
        }
        if self.fade != fade {
            self.fade = fade;
            self.changes.spheres = true;
        }
        Ok(())
    }

    /// Adds a material.
    pub fn add_material(&mut self, material: Material) -> Result<MaterialId, WorldError> {
        check::material(&material)?;
        let id = self.materials.insert(Stuff {
            material: material.into_nff(0),
            users: 0,
            traced: Tracing::default(),
        });
        self.touch_material(id);
        Ok(id)
    }

    /// A material.
    pub fn material(&self, id: MaterialId) -> Result<Material, WorldError> {
        let stuff = self.materials.get(id).ok_or(WorldError::NoMaterial)?;
        Ok((&stuff.material).into())
    }

    /// Changes a material, and all objects made of it.
    pub fn set_material(&mut self, id: MaterialId, material: Material) -> Result<(), WorldError> {
        check::material(&material)?;
        let stuff = self.materials.get_mut(id).ok_or(WorldError::NoMaterial)?;
        let material = material.into_nff(0);
        if stuff.material == material {
            return Ok(());
        }
        // Of what lets light through, both sides are seen.
        let had_sides = stuff.material.transmittance > 0.0;
        let other_sides = had_sides != (material.transmittance > 0.0);
        stuff.material = material;
        self.touch_material(id);
        if other_sides {
            for (object, known) in &mut self.objects {
                if known.material == id {
                    self.changes.object(object, &mut known.traced);
                }
            }
        }
        Ok(())
    }

    /// Changes a material's colour, and that of all objects made of it.
    pub fn recolour(&mut self, id: MaterialId, colour: DVec3) -> Result<(), WorldError> {
        check::vector("colour", colour)?;
        let stuff = self.materials.get_mut(id).ok_or(WorldError::NoMaterial)?;
        if stuff.material.colour != colour {
            stuff.material.colour = colour;
            self.touch_material(id);
        }
        Ok(())
    }

    /// Removes a material that no object is made of.
    pub fn remove_material(&mut self, id: MaterialId) -> Result<(), WorldError> {
        match self.materials.get(id) {
            None => Err(WorldError::NoMaterial),
            Some(&Stuff { users, .. }) if users > 0 => Err(WorldError::MaterialInUse { users }),
            Some(_) => {
                // Nothing shows it: what is traced may keep it.
                self.materials.remove(id);
                Ok(())
            }
        }
    }

    /// All materials.
    pub fn materials(&self) -> impl Iterator<Item = MaterialId> {
        self.materials.keys()
    }

    /// Adds a light.
    pub fn add_light(&mut self, light: Light) -> Result<LightId, WorldError> {
        check::light(&light)?;
        // The others' brightness may depend on how many there are.
        self.changes.anew = true;
        Ok(self.lights.insert(Lamp {
            light,
            traced: Tracing::default(),
        }))
    }

    /// A light.
    pub fn light(&self, id: LightId) -> Result<Light, WorldError> {
        let lamp = self.lights.get(id).ok_or(WorldError::NoLight)?;
        Ok(lamp.light)
    }

    /// Moves a light, or changes its colour.
    pub fn set_light(&mut self, id: LightId, light: Light) -> Result<(), WorldError> {
        check::light(&light)?;
        let lamp = self.lights.get_mut(id).ok_or(WorldError::NoLight)?;
        if lamp.light != light {
            self.changes.anew |= lamp.light.colour.is_some() && light.colour.is_none();
            lamp.light = light;
            self.changes.light(id, &mut lamp.traced);
        }
        Ok(())
    }

    /// Removes a light.
    pub fn remove_light(&mut self, id: LightId) -> Result<(), WorldError> {
        self.lights.remove(id).ok_or(WorldError::NoLight)?;
        self.changes.anew = true;
        Ok(())
    }

    /// All lights.
    pub fn lights(&self) -> impl Iterator<Item = LightId> {
        self.lights.keys()
    }

    /// Adds an object of any shape, visible.
    pub fn add(&mut self, shape: Shape, material: MaterialId) -> Result<ObjectId, WorldError> {
        check::shape(&shape)?;
        let stuff = self.materials.get_mut(material);
        stuff.ok_or(WorldError::NoMaterial)?.users += 1;
        let id = self.objects.insert(Object {
            shape,
            material,
            visible: true,
            fixed: false,
            traced: Tracing::default(),
        });
        self.touch(id);
        Ok(id)
    }

    /// Adds a sphere.
    pub fn add_sphere(
        &mut self,
        centre: DVec3,
        radius: f64,
        material: MaterialId,
    ) -> Result<ObjectId, WorldError> {
        self.add(Shape::Sphere { centre, radius }, material)
    }

    /// Adds a polygon, counter-clockwise as seen from its front.
    pub fn add_polygon(
        &mut self,
        vertices: &[DVec3],
        material: MaterialId,
    ) -> Result<ObjectId, WorldError> {
        let vertices = vertices.to_vec();
        self.add(Shape::Polygon { vertices }, material)
    }

    /// Removes an object. Its handle is refused from then on, also when its place serves for another.
    pub fn remove(&mut self, id: ObjectId) -> Result<(), WorldError> {
        let object = self.objects.remove(id).ok_or(WorldError::NoObject)?;
        self.unuse(object.material);
        self.changes.removed(&object.traced);
        Ok(())
    }

    /// All objects, visible or not.
    pub fn objects(&self) -> impl Iterator<Item = ObjectId> {
        self.objects.keys()
    }

    /// How many objects there are.
    #[must_use]
    pub fn object_count(&self) -> usize {
        self.objects.len()
    }

    /// An object's shape.
    pub fn shape(&self, id: ObjectId) -> Result<&Shape, WorldError> {
        Ok(&self.object(id)?.shape)
    }

    /// Where an object is: a sphere's centre, a cone's base, the first vertex of all else.
    pub fn position(&self, id: ObjectId) -> Result<DVec3, WorldError> {
        Ok(position(&self.object(id)?.shape))
    }

    /// Moves an object, as it is, so that this becomes its [`World::position`].
    pub fn move_to(&mut self, id: ObjectId, position: DVec3) -> Result<(), WorldError> {
        let by = position - self.position(id)?;
        if by == DVec3::ZERO {
            return Ok(());
        }
        check::vector("position", position)?;
        let object = self.movable(id)?;
        check::moved(&object.shape, by)?;
        match &mut object.shape {
            // As it was given: the sum of the old one and the way would be rounded.
            Shape::Sphere { centre, .. } => *centre = position,
            Shape::Cone { base, apex, .. } => {
                *base = position;
                *apex += by;
            }
            Shape::Polygon { vertices } | Shape::Patch { vertices, .. } => {
                for vertex in vertices {
                    *vertex += by;
                }
            }
        }
        self.touch(id);
        Ok(())
    }

    /// Gives an object another shape.
    pub fn reshape(&mut self, id: ObjectId, shape: Shape) -> Result<(), WorldError> {
        check::shape(&shape)?;
        let object = self.movable(id)?;
        if object.shape != shape {
            object.shape = shape;
            self.touch(id);
        }
        Ok(())
    }

    /// What an object is made of.
    pub fn material_of(&self, id: ObjectId) -> Result<MaterialId, WorldError> {
        Ok(self.object(id)?.material)
    }

    /// Makes an object of another material.
    pub fn make_of(&mut self, id: ObjectId, material: MaterialId) -> Result<(), WorldError> {
        let before = self.material_of(id)?;
        let stuff = self.materials.get_mut(material);
        stuff.ok_or(WorldError::NoMaterial)?.users += 1;
        self.unuse(before);
        if before != material {
            self.object_mut(id)?.material = material;
            self.touch(id);
        }
        Ok(())
    }

    /// Whether an object is seen.
    pub fn is_visible(&self, id: ObjectId) -> Result<bool, WorldError> {
        Ok(self.object(id)?.visible)
    }

    /// Shows an object, or hides it. By Whitted's model its room in the SPUs' local store is kept.
    pub fn show(&mut self, id: ObjectId, visible: bool) -> Result<(), WorldError> {
        let object = self.object_mut(id)?;
        if object.visible != visible {
            object.visible = visible;
            self.touch(id);
        }
        Ok(())
    }

    /// Whether an object is fixed.
    pub fn is_fixed(&self, id: ObjectId) -> Result<bool, WorldError> {
        Ok(self.object(id)?.fixed)
    }

    /// Fixes an object: it refuses to be moved, so that what is meant to be written, sent and traced once is. It may
    /// be made of another material, hidden and removed.
    pub fn fix(&mut self, id: ObjectId) -> Result<(), WorldError> {
        self.object_mut(id)?.fixed = true;
        Ok(())
    }

    /// Frees an object that was fixed.
    pub fn free(&mut self, id: ObjectId) -> Result<(), WorldError> {
        self.object_mut(id)?.fixed = false;
        Ok(())
    }

    /// A number that tells this world's content from another's, the same on every machine: of objects, materials
    /// and lights in their order, the handles apart; of the look nothing.
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
        for lamp in self.lights.values() {
            sum.light(&lamp.light);
        }
        for object in self.objects.values() {
            sum.shape(&object.shape);
            sum.word(u64::from(object.visible));
            if let Some(stuff) = self.materials.get(object.material) {
                sum.material(&stuff.material);
            }
        }
        sum.number()
    }

    fn object(&self, id: ObjectId) -> Result<&Object, WorldError> {
        self.objects.get(id).ok_or(WorldError::NoObject)
    }

    fn object_mut(&mut self, id: ObjectId) -> Result<&mut Object, WorldError> {
        self.objects.get_mut(id).ok_or(WorldError::NoObject)
    }

    fn movable(&mut self, id: ObjectId) -> Result<&mut Object, WorldError> {
        let object = self.object_mut(id)?;
        if object.fixed {
            return Err(WorldError::Fixed);
        }
        Ok(object)
    }

    fn touch(&mut self, id: ObjectId) {
        if let Some(object) = self.objects.get_mut(id) {
            self.changes.object(id, &mut object.traced);
        }
    }

    fn touch_material(&mut self, id: MaterialId) {
        if let Some(stuff) = self.materials.get_mut(id) {
            self.changes.material(id, &mut stuff.traced);
        }
    }

    fn unuse(&mut self, material: MaterialId) {
        if let Some(stuff) = self.materials.get_mut(material) {
            stuff.users -= 1;
        }
    }
}

fn position(shape: &Shape) -> DVec3 {
    match shape {
        Shape::Sphere { centre, .. } => *centre,
        Shape::Cone { base, .. } => *base,
        Shape::Polygon { vertices } | Shape::Patch { vertices, .. } => {
            vertices.first().copied().unwrap_or_default()
        }
    }
}
