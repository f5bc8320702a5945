//! The spheres and cones that are in main memory.

use glam::DVec3;
use protocol::layout::MeshVertex;
use zerocopy::big_endian::F32;
use zerocopy::{FromZeros as _, IntoBytes as _};

use super::tree::{Bounds, Kind, Piece};
use super::{MeshCone, MeshSphere};

/// A sphere or a cone.
#[derive(Clone, Copy, Debug)]
pub(in crate::scene) enum MeshObject {
    Sphere(MeshSphere),
    Cone(MeshCone),
}

impl MeshObject {
    /// The quadword of a cone's records that has the point at three quarters of its height.
    pub const POINT: u32 = 4;

    pub fn is_cone(&self) -> bool {
        matches!(self, Self::Cone(_))
    }

    /// Index of its material in the scene.
    pub fn material(&self) -> u32 {
        match self {
            Self::Sphere(sphere) => sphere.material,
            Self::Cone(cone) => cone.material,
        }
    }

    /// The corners of the box around it.
    pub fn corners(&self) -> [DVec3; 2] {
        match self {
            Self::Sphere(sphere) => {
                let (centre, radius) = (sphere.centre.as_dvec3(), f64::from(sphere.radius.abs()));
                [centre - radius, centre + radius]
            }
            Self::Cone(cone) => cone.corners().map(|corner| corner.as_dvec3()),
        }
    }

    /// Calls `put` with its records for sorting, where `material` is the number of the material in
    /// blocks.
    pub fn write(&self, material: u32, put: &mut dyn FnMut(&[MeshVertex])) {
        match self {
            Self::Sphere(sphere) => {
                let record: [MeshVertex; 3] = zerocopy::transmute!(sphere.record(material));
                put(&record);
            }
            Self::Cone(cone) => {
                let [a, b, c, d]: [MeshVertex; 4] = zerocopy::transmute!(cone.record(material));
                let position = cone.base + 0.75 * cone.height * cone.axis;
                let position = position.to_array().map(F32::new);
                put(&[a, b, c, d, MeshVertex { position, ..MeshVertex::new_zeroed() }]);
            }
        }
    }
}

/// The objects of a scene in main memory besides triangles.
#[derive(Clone, Debug, Default)]
pub struct MeshObjects {
    /// Spheres.
    pub spheres: Vec<MeshSphere>,
    /// Cones and cylinders.
    pub cones: Vec<MeshCone>,
}

impl MeshObjects {
    /// These objects.
    pub(in crate::scene) fn of(objects: impl Iterator<Item = MeshObject>) -> Self {
        let mut all = Self::default();
        for object in objects {
            match object {
                MeshObject::Sphere(sphere) => all.spheres.push(sphere),
                MeshObject::Cone(cone) => all.cones.push(cone),
            }
        }
        all
    }

    /// The number of objects.
    #[must_use]
    pub fn len(&self) -> usize {
        self.spheres.len() + self.cones.len()
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The materials of all objects, as indices in the scene.
    pub(super) fn materials(&self) -> impl Iterator<Item = u32> {
        let spheres = self.spheres.iter().map(|sphere| sphere.material);
        spheres.chain(self.cones.iter().map(|cone| cone.material))
    }

    pub(super) fn sphere_pieces(&self) -> Vec<Piece> {
        pieces(self.spheres.iter().map(MeshSphere::bounds))
    }

    pub(super) fn cone_pieces(&self) -> Vec<Piece> {
        pieces(self.cones.iter().map(MeshCone::bounds))
    }

    /// Appends an object's record in a block. `numbers` has the materials' numbers in blocks.
    pub(super) fn write(&self, kind: Kind, index: u32, numbers: &[u32], records: &mut Vec<u8>) {
        let index = index as usize;
        let number = |material: u32| numbers[material as usize];
        match kind {
            Kind::Triangles(_) | Kind::Heights | Kind::Blocks => {}
            Kind::Spheres => {
                let sphere = &self.spheres[index];
                records.extend(sphere.record(number(sphere.material)).as_bytes());
            }
            Kind::Cones => {
                let cone = &self.cones[index];
                records.extend(cone.record(number(cone.material)).as_bytes());
            }
        }
    }
}

fn pieces(bounds: impl Iterator<Item = Bounds>) -> Vec<Piece> {
    let numbered = bounds.zip(0..);
    numbered.map(|(bounds, index)| Piece { bounds, index }).collect()
}
