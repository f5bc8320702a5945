//! The objects of a world.

use glam::DVec3;
use scenes::{Shape, unit};

use super::content::Object;
use super::edits::SceneEntry;
use super::{MaterialId, ObjectId, World, WorldError, WorldErrorKind, check};
use crate::scene::single::LARGEST;

impl World {
    /// Adds a visible object of any shape.
    ///
    /// # Errors
    /// - There is no such material.
    /// - A number of the shape is out of range, or the shape has no surface.
    #[track_caller]
    pub fn add(&mut self, shape: Shape, material: MaterialId) -> Result<ObjectId, WorldError> {
        check::shape(&shape)?;
        let entry = self.materials.get_mut(material);
        entry.ok_or(WorldErrorKind::NoMaterial)?.users += 1;
        let id = self.objects.insert(Object {
            line: None,
            shape,
            material,
            visible: true,
            fixed: false,
            traced: SceneEntry::default(),
        });
        self.touch(id);
        Ok(id)
    }

    /// Adds a sphere.
    ///
    /// # Errors
    /// As for [`World::add`].
    #[track_caller]
    pub fn add_sphere(
        &mut self,
        centre: impl Into<DVec3>,
        radius: f64,
        material: MaterialId,
    ) -> Result<ObjectId, WorldError> {
        let centre = centre.into();
        self.add(Shape::Sphere { centre, radius }, material)
    }

    /// Adds a polygon. Its vertices are counter-clockwise as seen from the front.
    ///
    /// # Errors
    /// As for [`World::add`].
    #[track_caller]
    pub fn add_polygon(
        &mut self,
        vertices: &[impl Into<DVec3> + Copy],
        material: MaterialId,
    ) -> Result<ObjectId, WorldError> {
        let vertices = vertices.iter().map(|&vertex| vertex.into()).collect();
        self.add(Shape::Polygon { vertices }, material)
    }

    /// Adds a square of a plane: it has edges of this length around `centre`, and is seen from
    /// where `normal` points, which is perpendicular to it.
    ///
    /// # Errors
    /// As for [`World::add`], or the normal is 0.
    #[track_caller]
    pub fn add_plane(
        &mut self,
        centre: impl Into<DVec3>,
        normal: impl Into<DVec3>,
        edge: f64,
        material: MaterialId,
    ) -> Result<ObjectId, WorldError> {
        let (centre, normal) = (centre.into(), normal.into());
        check::vector("centre", centre)?;
        check::vector("normal", normal)?;
        let normal = unit(normal).ok_or(WorldErrorKind::NoSurface("the normal of a plane is 0"))?;
        // Edges along the axes for a level plane.
        let axis = match normal.x.abs() < 0.5 {
            true => DVec3::X,
            false => DVec3::Z,
        };
        let right = (axis - normal * normal.dot(axis)).normalize() * (edge / 2.0);
        let up = normal.cross(right);
        let vertices = [-right - up, right - up, right + up, up - right];
        self.add_polygon(&vertices.map(|vertex| centre + vertex), material)
    }

    /// Adds a box between two opposite corners, as six polygons.
    /// [`Mesh::cuboid`](scenes::Mesh::cuboid) is a box that can be turned.
    ///
    /// # Errors
    /// As for [`World::add`], or the box has no volume.
    #[track_caller]
    pub fn add_box(
        &mut self,
        corner: impl Into<DVec3>,
        opposite: impl Into<DVec3>,
        material: MaterialId,
    ) -> Result<[ObjectId; 6], WorldError> {
        let (corner, opposite) = (corner.into(), opposite.into());
        check::vector("corner", corner)?;
        check::vector("corner", opposite)?;
        let (low, high) = (corner.min(opposite), corner.max(opposite));
        if (high - low).min_element() == 0.0 {
            return Err(WorldErrorKind::NoSurface("a box has no volume").into());
        }
        let mut sides = [ObjectId::default(); 6];
        for (side, corners) in sides.iter_mut().zip(scenes::cuboid(low, high)) {
            *side = self.add_polygon(&corners, material)?;
        }
        Ok(sides)
    }

    /// Removes an object. Its handle is refused from then on, even when another object takes its
    /// place.
    ///
    /// # Errors
    /// There is no such object.
    #[track_caller]
    pub fn remove(&mut self, id: ObjectId) -> Result<(), WorldError> {
        let object = self.objects.remove(id).ok_or(WorldErrorKind::NoObject)?;
        self.unuse(object.material);
        self.edits.removed(&object.traced);
        Ok(())
    }

    /// The handles of all objects, visible or not.
    pub fn objects(&self) -> impl Iterator<Item = ObjectId> {
        self.objects.keys()
    }

    /// The number of objects, visible or not.
    #[must_use]
    pub fn object_count(&self) -> usize {
        self.objects.len()
    }

    /// An object's shape.
    ///
    /// # Errors
    /// There is no such object.
    #[track_caller]
    pub fn shape(&self, id: ObjectId) -> Result<&Shape, WorldError> {
        Ok(&self.object(id)?.shape)
    }

    /// An object's position: a sphere's centre, a cone's base, a polygon's first vertex.
    ///
    /// # Errors
    /// There is no such object.
    #[track_caller]
    pub fn position(&self, id: ObjectId) -> Result<DVec3, WorldError> {
        Ok(place(&self.object(id)?.shape))
    }

    /// Moves an object without turning it, so that `position` becomes its [`World::position`].
    ///
    /// # Errors
    /// There is no such object, it is fixed, or a number is out of range.
    #[track_caller]
    pub fn move_to(&mut self, id: ObjectId, position: impl Into<DVec3>) -> Result<(), WorldError> {
        let to = position.into();
        // A short way for spheres: games move thousands of them in a frame.
        if let Some(object) = self.objects.get_mut(id)
            && let Shape::Sphere { centre, .. } = &mut object.shape
            && !object.fixed
            && to.abs().element_sum() <= LARGEST
        {
            if *centre != to {
                *centre = to;
                self.edits.object(id, object);
            }
            return Ok(());
        }
        Ok(self.move_shape(id, to)?)
    }

    fn move_shape(&mut self, id: ObjectId, to: DVec3) -> Result<(), WorldErrorKind> {
        let by = to - place(&self.object(id)?.shape);
        if by == DVec3::ZERO {
            return Ok(());
        }
        check::vector("position", to)?;
        let object = self.movable(id)?;
        check::moved(&object.shape, by)?;
        match &mut object.shape {
            // Assigned, because the sum of the old centre and the distance would be rounded.
            Shape::Sphere { centre, .. } => *centre = to,
            Shape::Cone { base, apex, .. } => {
                *base = to;
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
    ///
    /// # Errors
    /// - There is no such object, or it is fixed.
    /// - A number of the shape is out of range, or the shape has no surface.
    #[track_caller]
    pub fn reshape(&mut self, id: ObjectId, shape: Shape) -> Result<(), WorldError> {
        check::shape(&shape)?;
        let object = self.movable(id)?;
        if object.shape != shape {
            object.shape = shape;
            self.touch(id);
        }
        Ok(())
    }

    /// The material that an object is made of.
    ///
    /// # Errors
    /// There is no such object.
    #[track_caller]
    pub fn material_of(&self, id: ObjectId) -> Result<MaterialId, WorldError> {
        Ok(self.object(id)?.material)
    }

    /// Gives an object another material.
    ///
    /// # Errors
    /// There is no such object or material.
    #[track_caller]
    pub fn make_of(&mut self, id: ObjectId, material: MaterialId) -> Result<(), WorldError> {
        let before = self.material_of(id)?;
        let entry = self.materials.get_mut(material);
        entry.ok_or(WorldErrorKind::NoMaterial)?.users += 1;
        self.unuse(before);
        if before != material {
            self.object_mut(id)?.material = material;
            self.touch(id);
        }
        Ok(())
    }

    /// Whether an object is visible.
    ///
    /// # Errors
    /// There is no such object.
    #[track_caller]
    pub fn is_visible(&self, id: ObjectId) -> Result<bool, WorldError> {
        Ok(self.object(id)?.visible)
    }

    /// Shows or hides an object. With Whitted's model a hidden object keeps its place in the SPUs'
    /// local store.
    ///
    /// # Errors
    /// There is no such object.
    #[track_caller]
    pub fn show(&mut self, id: ObjectId, visible: bool) -> Result<(), WorldError> {
        let object = self.object_mut(id)?;
        if object.visible != visible {
            object.visible = visible;
            self.touch(id);
        }
        Ok(())
    }

    /// Whether an object is fixed.
    ///
    /// # Errors
    /// There is no such object.
    #[track_caller]
    pub fn is_fixed(&self, id: ObjectId) -> Result<bool, WorldError> {
        Ok(self.object(id)?.fixed)
    }

    /// Fixes an object: moving and reshaping it is refused from now on. This guards scenery that
    /// should be written and traced only once. The object's material can still be changed, and it
    /// can be hidden and removed.
    ///
    /// # Errors
    /// There is no such object.
    #[track_caller]
    pub fn fix(&mut self, id: ObjectId) -> Result<(), WorldError> {
        self.object_mut(id)?.fixed = true;
        Ok(())
    }

    /// Frees a fixed object, so that it can be moved again.
    ///
    /// # Errors
    /// There is no such object.
    #[track_caller]
    pub fn free(&mut self, id: ObjectId) -> Result<(), WorldError> {
        self.object_mut(id)?.fixed = false;
        Ok(())
    }

    fn object(&self, id: ObjectId) -> Result<&Object, WorldErrorKind> {
        self.objects.get(id).ok_or(WorldErrorKind::NoObject)
    }

    fn object_mut(&mut self, id: ObjectId) -> Result<&mut Object, WorldErrorKind> {
        self.objects.get_mut(id).ok_or(WorldErrorKind::NoObject)
    }

    fn movable(&mut self, id: ObjectId) -> Result<&mut Object, WorldErrorKind> {
        let object = self.object_mut(id)?;
        if object.fixed {
            return Err(WorldErrorKind::Fixed);
        }
        Ok(object)
    }

    fn touch(&mut self, id: ObjectId) {
        if let Some(object) = self.objects.get_mut(id) {
            self.edits.object(id, object);
        }
    }

    pub(super) fn unuse(&mut self, material: MaterialId) {
        if let Some(entry) = self.materials.get_mut(material) {
            entry.users -= 1;
        }
    }
}

fn place(shape: &Shape) -> DVec3 {
    match shape {
        Shape::Sphere { centre, .. } => *centre,
        Shape::Cone { base, .. } => *base,
        Shape::Polygon { vertices } | Shape::Patch { vertices, .. } => {
            vertices.first().copied().unwrap_or_default()
        }
    }
}
