//! Spheres and cones in main memory that move: their records, of which leaf blocks are made in the
//! order of codes for each picture ([`SortedMesh`]).
//!
//! Invariant: an object keeps the place of its records, and its material is one of those that the
//! blocks have.

use glam::DVec3;
use protocol::layout::{BUILD_CONE, BuildTriangle, MESH_MATERIALS, MeshVertex};
use scenes::Mesh;
use zerocopy::FromZeros as _;
use zerocopy::big_endian::U32;

use super::moved::{Line, MovedVertices, memory};
use super::objects::MeshObject;
use super::sorted::{Grid, MOST_TRIANGLES, Sorted, SortedMesh};
use super::tree::Bounds;
use super::{MeshBlocks, MeshCone, MeshSphere, MeshStatistics, NumberWidth, Numbers};

/// An object that is sorted.
#[derive(Clone, Copy, Debug)]
struct Slot {
    /// Its first quadword.
    place: u32,
    is_cone: bool,
    is_shown: bool,
    /// The corners of the box around it.
    corners: [DVec3; 2],
}

/// The objects of a scene that are sorted.
#[derive(Clone, Debug)]
pub struct MovingObjects {
    /// By their numbers in the scene.
    slots: Vec<Option<Slot>>,
    /// The number in blocks of each material of the scene that an object had at first.
    materials: Vec<Option<u32>>,
    are_changed: bool,
    are_others_shown: bool,
}

impl MovingObjects {
    /// Gives an object another shape and material; `false` if it has no place for them.
    pub fn set(&mut self, sorted: &mut SortedMesh, number: usize, object: &MeshObject) -> bool {
        let cone = match object {
            MeshObject::Sphere(sphere) => return self.set_sphere(sorted, number, sphere),
            MeshObject::Cone(cone) => cone,
        };
        let Some((slot, material)) = self.slot(number, cone.material, true) else {
            return false;
        };
        sorted.vertices.put_record(slot.place, &cone.quadwords(material));
        slot.corners = object.corners();
        true
    }

    /// [`MovingObjects::set`] for a sphere.
    #[inline]
    pub fn set_sphere(
        &mut self,
        sorted: &mut SortedMesh,
        number: usize,
        sphere: &MeshSphere,
    ) -> bool {
        let Some((slot, material)) = self.slot(number, sphere.material, false) else {
            return false;
        };
        sorted.vertices.put_record(slot.place, &sphere.quadwords(material));
        slot.corners = sphere.corners();
        true
    }

    /// The slot of an object that is changed, and the number in blocks of its material.
    #[inline]
    fn slot(&mut self, number: usize, material: u32, is_cone: bool) -> Option<(&mut Slot, u32)> {
        let slot = self.slots.get_mut(number)?.as_mut().filter(|slot| slot.is_cone == is_cone)?;
        let material = (*self.materials.get(material as usize)?)?;
        self.are_others_shown |= !slot.is_shown;
        slot.is_shown = true;
        self.are_changed = true;
        Some((slot, material))
    }

    /// Takes an object out of the picture.
    pub fn hide(&mut self, number: usize) {
        if let Some(slot) = self.slots.get_mut(number).and_then(Option::as_mut) {
            slot.is_shown = false;
            self.are_changed = true;
            self.are_others_shown = true;
        }
    }

    /// Whether some have changed since they were sorted.
    pub fn are_changed(&self) -> bool {
        self.are_changed
    }

    /// Makes what is sorted of the changed objects, and returns the corners of the box around all;
    /// `None` if there are none.
    pub fn apply(&mut self, sorted: &mut SortedMesh) -> Option<[DVec3; 2]> {
        if std::mem::take(&mut self.are_others_shown) {
            sorted.list(self.shown().map(Slot::element));
        }
        self.are_changed = false;
        sorted.vertices.are_others();
        let around =
            self.shown().map(|slot| slot.corners).reduce(|[low, high], [other_low, other_high]| {
                [low.min(other_low), high.max(other_high)]
            });
        let [low, high] = around?.map(|corner| corner.as_vec3());
        sorted.grid = Grid::new(Bounds { low, high });
        around
    }

    fn shown(&self) -> impl Iterator<Item = &Slot> {
        self.slots.iter().flatten().filter(|slot| slot.is_shown)
    }
}

impl Slot {
    fn element(&self) -> BuildTriangle {
        let (point, kind) = match self.is_cone {
            false => (self.place, 0),
            true => (self.place + MeshCone::POINT, BUILD_CONE),
        };
        BuildTriangle {
            code: U32::ZERO,
            first: self.place.into(),
            second: (point | kind).into(),
            third: point.into(),
        }
    }
}

impl SortedMesh {
    /// Replaces all that is sorted. In memory for as many nothing is allocated.
    fn list(&mut self, elements: impl Iterator<Item = BuildTriangle>) {
        self.triangles.clear();
        self.count = 0;
        for element in elements {
            let at = self.count as usize % 8;
            if at == 0 {
                self.triangles.push(Line([BuildTriangle::new_zeroed(); 8]));
            }
            if let Some(line) = self.triangles.last_mut() {
                line.0[at] = element;
            }
            self.count += 1;
        }
    }
}

impl MeshBlocks {
    /// The blocks of objects before they are made in the order of codes, and the records that they
    /// are made of. The objects are in the order of their numbers in the scene, which come first.
    /// `None` if they can't be: there are none, or too many, or too many materials.
    pub(in crate::scene) fn objects_to_sort(
        objects: &[(usize, MeshObject)],
        materials: usize,
        Numbers { firsts, minimum }: Numbers<'_>,
    ) -> Option<(Self, SortedMesh, MovingObjects)> {
        if objects.is_empty() || minimum != NumberWidth::Byte || objects.len() > MOST_TRIANGLES {
            return None;
        }
        let mut numbers = vec![None; materials];
        let mut used = Vec::new();
        let mut slots = vec![None; objects.last().map_or(0, |(number, _)| number + 1)];
        let mut records: Vec<MeshVertex> = Vec::new();
        let mut statistics = MeshStatistics::default();
        for (number, object) in objects {
            let first = firsts[object.material() as usize];
            let material = *numbers[first as usize].get_or_insert_with(|| {
                used.push(first);
                used.len() as u32 - 1
            });
            slots[*number] = Some(Slot {
                place: records.len() as u32,
                is_cone: object.is_cone(),
                is_shown: true,
                corners: object.corners(),
            });
            match object {
                MeshObject::Sphere(sphere) => {
                    records.extend(sphere.quadwords(material));
                    statistics.spheres += 1;
                }
                MeshObject::Cone(cone) => {
                    records.extend(cone.quadwords(material));
                    statistics.cones += 1;
                }
            }
        }
        if used.len() > MESH_MATERIALS as usize || records.len() > MovedVertices::MOST {
            return None;
        }
        let mut sorted = SortedMesh {
            what: Sorted::Objects,
            vertices: MovedVertices::of_records(&records),
            triangles: memory(objects.len().div_ceil(8)),
            count: 0,
            grid: Grid::default(),
        };
        let materials = firsts.iter().map(|&first| numbers[first as usize]).collect();
        let mut moving =
            MovingObjects { slots, materials, are_changed: true, are_others_shown: true };
        moving.apply(&mut sorted);
        let most = sorted.most_blocks();
        let blocks = Self { statistics, ..Self::unmade(&Mesh::default(), used, most) };
        Some((blocks, sorted, moving))
    }

    /// Makes space for the blocks of what is sorted.
    pub(crate) fn make_space(&mut self, sorted: &SortedMesh) {
        self.most = sorted.most_blocks();
    }
}
