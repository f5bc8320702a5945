//! The ground of a world: a height field.

use std::sync::Arc;

use scenes::HeightField;
use slotmap::SecondaryMap;

use super::checksum::Checksum;
use super::{MaterialId, World, WorldError, WorldErrorKind, check};

/// A height field, and what its colours are multiplied by.
pub(super) struct Terrain {
    field: Arc<HeightField>,
    material: MaterialId,
    /// A checksum of all but the material.
    sum: u64,
}

impl Terrain {
    /// Adds the height field to the world's checksum.
    pub fn sum(&self, sum: &mut Checksum) {
        sum.word(self.sum);
    }

    /// Its material.
    pub fn material(&self) -> MaterialId {
        self.material
    }
}

impl World {
    /// Adds the ground: a height field, of which a world has one at most. Its corner is where it
    /// is; its rows go along x and z, and y is up. The colours of its samples are multiplied by the
    /// material's.
    ///
    /// Only Whitted's model draws it. [`World::pick`] does not find it;
    /// [`HeightField::ground`] has the height of each of its points.
    ///
    /// ```
    /// use std::sync::Arc;
    /// use cellray::game::{HeightField, Material, World};
    ///
    /// let heights = (0..64 * 64).map(|sample| sample % 64 * 100).collect();
    /// let slope = HeightField::new([64, 64], heights, Vec::new(), 1.0, 0.01).expect("a slope");
    /// let mut world = World::new();
    /// let white = world.add_material(Material::matte(1.0, 1.0, 1.0))?;
    /// world.add_terrain(Arc::new(slope), white)?;
    /// # Ok::<(), cellray::game::WorldError>(())
    /// ```
    ///
    /// # Errors
    /// There is a height field already, there is no such material, or a corner is out of range.
    #[track_caller]
    pub fn add_terrain(
        &mut self,
        field: Arc<HeightField>,
        material: MaterialId,
    ) -> Result<(), WorldError> {
        if self.terrain.is_some() {
            return Err(WorldErrorKind::SecondTerrain.into());
        }
        let (low, high) = field.bounds();
        check::vector("the corner of the ground", low)?;
        check::vector("the corner of the ground", high)?;
        let entry = self.materials.get_mut(material).ok_or(WorldErrorKind::NoMaterial)?;
        entry.users += 1;
        let mut sum = Checksum::new();
        sum.vector(field.corner);
        sum.float(field.step());
        sum.float(field.unit());
        let [columns, rows] = field.size().map(i64::from);
        sum.word(u64::from(field.size()[0]));
        for row in 0..rows {
            for column in 0..columns {
                let [red, green, blue] = field.colour(column, row);
                let [high, low] = field.sample(column, row).to_be_bytes();
                sum.word(u64::from_be_bytes([0, 0, 0, high, low, red, green, blue]));
            }
        }
        self.terrain = Some(Terrain { field, material, sum: sum.number() });
        self.edits.rebuild = true;
        Ok(())
    }

    /// The height field in a scene whose materials have these numbers.
    pub(super) fn placed_terrain(
        &self,
        places: &SecondaryMap<MaterialId, u32>,
    ) -> Option<Arc<HeightField>> {
        let Terrain { field, material, .. } = self.terrain.as_ref()?;
        let number = places.get(*material).copied().unwrap_or_default();
        if field.material == number {
            return Some(field.clone());
        }
        let mut field = HeightField::clone(field);
        field.material = number;
        Some(Arc::new(field))
    }
}
