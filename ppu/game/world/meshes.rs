//! The meshes of a world, each at a place of its own.
//!
//! Invariant: all vertices, normals and materials that a triangle names exist, and are in range at
//! the mesh's place. The picture shows one mesh that is made of all of them, so several places of
//! one [`Mesh`] share its memory here, but each has triangles of its own in the SPUs' blocks.

use std::sync::{Arc, OnceLock};

use glam::{DAffine3, DMat3, DVec3, Vec3};
use scenes::{Mesh, Visibility, unit};
use slotmap::SecondaryMap;

use super::checksum::Checksum;
use super::pick::{Crossing, Ray, Target};
use super::{MaterialId, MeshId, World, WorldError, WorldErrorKind, check};

/// A mesh at a place.
pub(super) struct WorldMesh {
    mesh: Arc<Mesh>,
    /// The materials that its triangles' numbers mean.
    materials: Vec<MaterialId>,
    /// Those that its triangles have.
    used: Vec<MaterialId>,
    place: DAffine3,
    /// The corners of the box around it, in its own coordinates.
    bounds: (DVec3, DVec3),
    visible: bool,
    /// Whether its place has changed since the world was traced.
    has_moved: bool,
    /// Whether its vertices have moved in its own coordinates since a tree was built.
    has_other_shape: bool,
    /// A checksum of all but the place and the materials, once it is asked for.
    sum: OnceLock<u64>,
}

impl WorldMesh {
    /// Adds the mesh to the world's checksum.
    pub fn sum(&self, sum: &mut Checksum) {
        sum.word(*self.sum.get_or_init(|| {
            let mut sum = Checksum::new();
            sum.mesh(&self.mesh);
            sum.number()
        }));
        sum.word(u64::from(self.visible));
        let DAffine3 { matrix3, translation } = self.place;
        for vector in [matrix3.x_axis, matrix3.y_axis, matrix3.z_axis, translation] {
            sum.vector(vector);
        }
    }

    /// The materials that its triangles have.
    pub fn used(&self) -> &[MaterialId] {
        &self.used
    }

    fn is_mirrored(&self) -> bool {
        self.place.matrix3.determinant() < 0.0
    }

    /// Writes the positions relative to an origin, and the normals if there is space for any.
    fn write(&self, origin: DVec3, positions: &mut [[f32; 3]], normals: &mut [[f32; 3]]) {
        if self.place == DAffine3::IDENTITY && origin == self.mesh.origin {
            positions.copy_from_slice(&self.mesh.positions);
        } else {
            for (to, &from) in positions.iter_mut().zip(&self.mesh.positions) {
                let position = self.mesh.origin + Vec3::from(from).as_dvec3();
                let place = self.place.transform_point3(position) - origin;
                *to = place.as_vec3().to_array();
            }
        }
        if self.mesh.normals.is_empty() {
            return;
        }
        if self.place == DAffine3::IDENTITY {
            normals.copy_from_slice(&self.mesh.normals);
            return;
        }
        let matrix = normal_matrix(self.place.matrix3);
        for (to, &from) in normals.iter_mut().zip(&self.mesh.normals) {
            let normal = matrix * Vec3::from(from).as_dvec3();
            *to = unit(normal).unwrap_or_default().as_vec3().to_array();
        }
    }
}

/// What turns normals: the inverse transpose, but for a positive factor.
fn normal_matrix(matrix: DMat3) -> DMat3 {
    let [x, y, z] = [matrix.x_axis, matrix.y_axis, matrix.z_axis];
    let cofactors = DMat3::from_cols(y.cross(z), z.cross(x), x.cross(y));
    if matrix.determinant() < 0.0 { -cofactors } else { cofactors }
}

impl World {
    /// Adds a visible mesh at a place: its vertices are transformed by `place`. `materials` are
    /// those that the numbers of the mesh's triangles mean.
    ///
    /// One mesh may be at several places: add clones of the [`Arc`]. Only Whitted's model draws
    /// meshes. If one mesh of a world is visible from both sides, all are.
    ///
    /// ```
    /// use std::sync::Arc;
    /// use cellray::game::{DAffine3, DVec3, Material, Mesh, World};
    ///
    /// let triangle = Arc::new(Mesh {
    ///     positions: vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
    ///     triangles: vec![[0, 1, 2]],
    ///     materials: vec![0],
    ///     ..Mesh::default()
    /// });
    /// let mut world = World::new();
    /// let red = world.add_material(Material::matte(0.9, 0.2, 0.1))?;
    /// let left = DAffine3::from_translation(DVec3::new(-2.0, 0.0, 0.0));
    /// let mesh = world.add_mesh(triangle.clone(), &[red], left)?;
    /// world.add_mesh(triangle, &[red], DAffine3::IDENTITY)?;
    /// world.place_mesh(mesh, left * DAffine3::from_rotation_y(0.5))?;
    /// # Ok::<(), cellray::game::WorldError>(())
    /// ```
    ///
    /// # Errors
    /// - A triangle names a vertex or a material that doesn't exist, or there is no triangle.
    /// - The number of normals, of texture coordinates, of colours or of triangles' materials is
    ///   wrong.
    /// - A number is out of range, or the place is flat.
    #[track_caller]
    pub fn add_mesh(
        &mut self,
        mesh: Arc<Mesh>,
        materials: &[MaterialId],
        place: DAffine3,
    ) -> Result<MeshId, WorldError> {
        let used = check::mesh(&mesh, materials.len())?;
        let bounds = mesh.bounds().unwrap_or_default();
        check::place(bounds, place)?;
        let used: Vec<MaterialId> = used.into_iter().map(|number| materials[number]).collect();
        if !used.iter().all(|&id| self.materials.contains_key(id)) {
            return Err(WorldErrorKind::NoMaterial.into());
        }
        for &id in &used {
            if let Some(entry) = self.materials.get_mut(id) {
                entry.users += 1;
            }
        }
        self.edits.rebuild = true;
        Ok(self.meshes.insert(WorldMesh {
            bounds,
            mesh,
            materials: materials.to_vec(),
            used,
            place,
            visible: true,
            has_moved: false,
            has_other_shape: false,
            sum: OnceLock::new(),
        }))
    }

    /// Adds the mesh of a loaded file, with its materials, at a place.
    ///
    /// ```no_run
    /// use cellray::prelude::*;
    ///
    /// fn add_chess(world: &mut World) -> Result<MeshId, WorldError> {
    ///     // In a game: cellray_play::meshes::load.
    ///     let file = meshes::load("chess.glb".as_ref()).map_err(WorldError::game)?;
    ///     world.add_model(&file.scene, DAffine3::from_scale(DVec3::splat(0.1)))
    /// }
    /// ```
    ///
    /// # Errors
    /// As for [`World::add_mesh`] and [`World::add_material`], or the scene has no mesh.
    #[track_caller]
    pub fn add_model(
        &mut self,
        model: &scenes::Scene,
        place: DAffine3,
    ) -> Result<MeshId, WorldError> {
        let mesh = model.mesh.clone();
        let mesh = mesh.ok_or(WorldErrorKind::NoSurface("the model has no triangles"))?;
        let mut materials = Vec::new();
        for material in &model.materials {
            materials.push(self.add_material(material.into())?);
        }
        self.add_mesh(mesh, &materials, place)
    }

    /// Puts a mesh at another place.
    ///
    /// # Errors
    /// There is no such mesh, a number is out of range, or the place is flat.
    #[track_caller]
    pub fn place_mesh(&mut self, id: MeshId, place: DAffine3) -> Result<(), WorldError> {
        let entry = self.meshes.get_mut(id).ok_or(WorldErrorKind::NoMesh)?;
        if entry.place == place {
            return Ok(());
        }
        check::place(entry.bounds, place)?;
        let was_mirrored = entry.is_mirrored();
        entry.place = place;
        if entry.visible {
            entry.has_moved = true;
            self.edits.moved_meshes = true;
            // Mirrored triangles have their vertices in another order.
            self.edits.rebuild |= was_mirrored != entry.is_mirrored();
        }
        Ok(())
    }

    /// Moves the vertices of a mesh in its own coordinates, and gives them other normals. Both are
    /// as many as before. A mesh that is at several places is changed only at this one.
    ///
    /// ```
    /// # use std::sync::Arc;
    /// # use cellray::game::{DAffine3, Material, Mesh, World};
    /// # let flag = Arc::new(Mesh {
    /// #     positions: vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
    /// #     triangles: vec![[0, 1, 2]],
    /// #     materials: vec![0],
    /// #     ..Mesh::default()
    /// # });
    /// # let mut world = World::new();
    /// # let red = world.add_material(Material::matte(0.9, 0.2, 0.1))?;
    /// let id = world.add_mesh(flag, &[red], DAffine3::IDENTITY)?;
    /// world.shape_mesh(id, &[[0.0, 0.0, 0.0], [1.0, 0.0, 0.3], [0.0, 1.0, 0.0]], &[])?;
    /// # Ok::<(), cellray::game::WorldError>(())
    /// ```
    ///
    /// # Errors
    /// There is no such mesh, there are too few or too many positions or normals, or a number is
    /// out of range. Then no vertex has moved.
    #[track_caller]
    pub fn shape_mesh(
        &mut self,
        id: MeshId,
        positions: &[[f32; 3]],
        normals: &[[f32; 3]],
    ) -> Result<(), WorldError> {
        let entry = self.meshes.get_mut(id).ok_or(WorldErrorKind::NoMesh)?;
        entry.bounds = check::vertices(&entry.mesh, positions, normals, entry.place)?;
        let mesh = Arc::make_mut(&mut entry.mesh);
        mesh.positions.copy_from_slice(positions);
        mesh.normals.copy_from_slice(normals);
        entry.sum.take();
        entry.has_other_shape = true;
        if entry.visible {
            entry.has_moved = true;
            self.edits.moved_meshes = true;
        }
        Ok(())
    }

    /// The place of a mesh.
    ///
    /// # Errors
    /// There is no such mesh.
    #[track_caller]
    pub fn mesh_place(&self, id: MeshId) -> Result<DAffine3, WorldError> {
        Ok(self.meshes.get(id).ok_or(WorldErrorKind::NoMesh)?.place)
    }

    /// Shows or hides a mesh.
    ///
    /// # Errors
    /// There is no such mesh.
    #[track_caller]
    pub fn show_mesh(&mut self, id: MeshId, visible: bool) -> Result<(), WorldError> {
        let entry = self.meshes.get_mut(id).ok_or(WorldErrorKind::NoMesh)?;
        self.edits.rebuild |= entry.visible != visible;
        entry.visible = visible;
        Ok(())
    }

    /// Removes a mesh. Its handle is refused from then on.
    ///
    /// # Errors
    /// There is no such mesh.
    #[track_caller]
    pub fn remove_mesh(&mut self, id: MeshId) -> Result<(), WorldError> {
        let entry = self.meshes.remove(id).ok_or(WorldErrorKind::NoMesh)?;
        for material in entry.used {
            self.unuse(material);
        }
        self.edits.rebuild = true;
        Ok(())
    }

    /// The handles of all meshes, visible or not.
    pub fn meshes(&self) -> impl Iterator<Item = MeshId> {
        self.meshes.keys()
    }

    /// All visible meshes as one; `places` are the numbers of the materials in the scene.
    pub(super) fn joined_mesh(&self, places: &SecondaryMap<MaterialId, u32>) -> Option<Arc<Mesh>> {
        let number = |id: &MaterialId| places.get(*id).copied().unwrap_or_default();
        let visible = || self.meshes.values().filter(|entry| entry.visible);
        let first = visible().next()?;
        let numbers = first.materials.iter().map(number);
        if visible().count() == 1
            && first.place == DAffine3::IDENTITY
            && numbers.eq(0..first.materials.len() as u32)
        {
            return Some(first.mesh.clone());
        }
        let has_normals = visible().any(|entry| !entry.mesh.normals.is_empty());
        let has_coordinates = visible().any(|entry| !entry.mesh.texture_coordinates.is_empty());
        let has_colours = visible().any(|entry| !entry.mesh.colours.is_empty());
        let has_visibility = visible().any(|entry| !entry.mesh.visibility.is_empty());
        let mut joined = Mesh {
            // Whatever depends on places would differ between a world in which meshes have moved
            // and a new one.
            origin: first.mesh.origin,
            two_sided: visible().any(|entry| entry.mesh.two_sided),
            ..Mesh::default()
        };
        for entry in visible() {
            let first = joined.positions.len();
            let after = first + entry.mesh.positions.len();
            joined.positions.resize(after, [0.0; 3]);
            joined.normals.resize(if has_normals { after } else { 0 }, [0.0; 3]);
            let normals = joined.normals.get_mut(first..).unwrap_or_default();
            entry.write(joined.origin, &mut joined.positions[first..], normals);
            if has_coordinates {
                let coordinates = &entry.mesh.texture_coordinates;
                joined.texture_coordinates.extend_from_slice(coordinates);
                joined.texture_coordinates.resize(after, [0.0; 2]);
            }
            if has_colours {
                joined.colours.extend_from_slice(&entry.mesh.colours);
                joined.colours.resize(after, [1.0; 3]);
            }
            let is_mirrored = entry.is_mirrored();
            let triangles = entry.mesh.triangles.iter().map(|triangle| {
                let [a, b, c] = triangle.map(|vertex| first as u32 + vertex);
                if is_mirrored { [a, c, b] } else { [a, b, c] }
            });
            joined.triangles.extend(triangles);
            let materials = entry.mesh.materials.iter();
            let materials = materials.map(|&material| number(&entry.materials[material as usize]));
            joined.materials.extend(materials);
            if has_visibility {
                joined.visibility.extend_from_slice(&entry.mesh.visibility);
                joined.visibility.resize(joined.triangles.len(), Visibility::default());
            }
        }
        Some(Arc::new(joined))
    }

    /// The visible meshes that a ray meets: the triangle of each that it meets first, and where.
    pub(super) fn meshes_met(&self, ray: &Ray) -> impl Iterator<Item = (Target, Crossing)> {
        let visible = || self.meshes.iter().filter(|(_, entry)| entry.visible);
        let two_sided = visible().any(|(_, entry)| entry.mesh.two_sided);
        visible().filter_map(move |(id, entry)| {
            // The distance is the same in the mesh's coordinates, where the direction has another
            // length.
            let inverse = entry.place.inverse();
            let ray = Ray {
                origin: inverse.transform_point3(ray.origin),
                direction: inverse.transform_vector3(ray.direction),
            };
            if !ray.meets_box(entry.bounds.0, entry.bounds.1) {
                return None;
            }
            let seen_through = entry.materials.iter().map(|&id| self.is_transparent(id));
            let seen_through: Vec<bool> = seen_through.collect();
            let mesh = &entry.mesh;
            let met = (0..mesh.triangles.len()).filter_map(|triangle| {
                let both_sides = two_sided || seen_through[mesh.materials[triangle] as usize];
                let corners = mesh.places(triangle);
                Some((triangle, ray.triangle(corners, both_sides)?))
            });
            let (triangle, (distance, normal)) =
                met.min_by(|(_, a), (_, b)| a.0.total_cmp(&b.0))?;
            let normal = normal_matrix(entry.place.matrix3) * normal;
            Some((Target::Mesh(id, triangle), (distance, normal)))
        })
    }

    /// Writes the vertices of the meshes that have moved into the joined mesh. Returns their
    /// number.
    pub(super) fn write_moved(&self, joined: &mut Mesh) -> usize {
        let mut first = 0;
        let mut moved = 0;
        for entry in self.meshes.values().filter(|entry| entry.visible) {
            let range = first..first + entry.mesh.positions.len();
            first = range.end;
            if entry.has_moved {
                moved += range.len();
                let normals = joined.normals.get_mut(range.clone()).unwrap_or_default();
                entry.write(joined.origin, &mut joined.positions[range], normals);
            }
        }
        moved
    }

    /// Whether triangles may have got an area since the tree was built.
    pub(super) fn have_other_shapes(&self) -> bool {
        self.meshes.values().any(|entry| entry.visible && entry.has_other_shape)
    }

    /// Notes that the scene has all meshes at their places.
    pub(super) fn meshes_are_traced(&mut self) {
        for entry in self.meshes.values_mut() {
            entry.has_moved = false;
        }
    }
}

/// The corners of a box.
pub(super) fn corners(bounds: (DVec3, DVec3)) -> impl Iterator<Item = DVec3> {
    (0..8).map(move |corner| {
        let (low, high) = bounds;
        let pick = |axis: usize| if corner >> axis & 1 == 0 { low } else { high }[axis];
        DVec3::new(pick(0), pick(1), pick(2))
    })
}
