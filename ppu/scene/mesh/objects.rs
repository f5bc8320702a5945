//! The spheres and cones that are in main memory.

use glam::DVec3;
use zerocopy::IntoBytes as _;

use super::tree::{Bounds, Kind, Piece};
use super::{MeshCone, MeshSphere};

/// A sphere or a cone.
#[derive(Clone, Copy, Debug)]
pub(in crate::scene) enum MeshObject {
    Sphere(MeshSphere),
    Cone(MeshCone),
}

impl MeshObject {
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
            Self::Sphere(sphere) => sphere.corners(),
            Self::Cone(cone) => cone.corners().map(|corner| corner.as_dvec3()),
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
