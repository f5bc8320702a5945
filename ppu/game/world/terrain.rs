//! The ground of a world: a height field.

use std::sync::{Arc, OnceLock};

use glam::DVec3;
use scenes::{HeightField, HeightRegion, HeightSample};
use slotmap::SecondaryMap;

use super::checksum::Checksum;
use super::{MaterialId, World, WorldError, WorldErrorKind, check};

/// A height field, and what its colours are multiplied by.
pub(super) struct Terrain {
    field: Arc<HeightField>,
    material: MaterialId,
    /// A checksum of all but the material, once it is asked for.
    sum: OnceLock<u64>,
}

impl Terrain {
    /// Adds the height field to the world's checksum.
    pub fn sum(&self, sum: &mut Checksum) {
        sum.word(*self.sum.get_or_init(|| {
            let field = &self.field;
            let mut sum = Checksum::new();
            sum.vector(field.corner);
            sum.float(field.step());
            sum.float(field.unit());
            let [columns, rows] = field.size();
            sum.word(u64::from(columns));
            for row in 0..rows {
                for column in 0..columns {
                    let HeightSample { height, colour: [red, green, blue] } = field.at(column, row);
                    let [high, low] = height.to_be_bytes();
                    sum.word(u64::from_be_bytes([0, 0, 0, high, low, red, green, blue]));
                }
            }
            sum.number()
        }));
    }

    /// The height field.
    pub fn field(&self) -> &HeightField {
        &self.field
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
        // Its samples may get any height.
        let highest = DVec3::Y * (field.unit() * f64::from(u16::MAX));
        let (low, high) = field.bounds();
        for corner in [field.corner, field.corner + highest, low, high] {
            check::vector("a corner of the ground", corner)?;
        }
        let entry = self.materials.get_mut(material).ok_or(WorldErrorKind::NoMaterial)?;
        entry.users += 1;
        self.terrain = Some(Terrain { field, material, sum: OnceLock::new() });
        self.edits.rebuild = true;
        Ok(())
    }

    /// Changes the samples of a region of the ground, as [`HeightField::shape`] does: a brush, or a
    /// crater. A game that asks its own height field for heights shapes that one as well.
    ///
    /// Only what depends on the region is made anew, except that the first change takes as long as
    /// [`World::add_terrain`] did. If the ground becomes higher or lower than ever, a new scene is
    /// made.
    ///
    /// ```
    /// # use std::sync::Arc;
    /// # use cellray::game::{HeightField, Material, World};
    /// use cellray::game::{DVec3, HeightSample};
    ///
    /// # let mut world = World::new();
    /// # let white = world.add_material(Material::matte(1.0, 1.0, 1.0))?;
    /// # let slope = HeightField::new([64, 64], vec![900; 64 * 64], Vec::new(), 1.0, 0.01);
    /// # let slope = Arc::new(slope.expect("a slope"));
    /// # world.add_terrain(slope.clone(), white)?;
    /// let pit = slope.around(DVec3::new(3.0, 0.0, 5.0), 4.0);
    /// world.shape_terrain(&pit, |_, sample| HeightSample {
    ///     height: sample.height.saturating_sub(100),
    ///     ..sample
    /// })?;
    /// # Ok::<(), cellray::game::WorldError>(())
    /// ```
    ///
    /// # Errors
    /// The world has no height field.
    #[track_caller]
    pub fn shape_terrain(
        &mut self,
        region: &HeightRegion,
        change: impl FnMut([u32; 2], HeightSample) -> HeightSample,
    ) -> Result<(), WorldError> {
        let terrain = self.terrain.as_mut().ok_or(WorldErrorKind::NoTerrain)?;
        let region = region.within(terrain.field.size());
        if region.is_empty() {
            return Ok(());
        }
        let before = terrain.field.bounds();
        let field = Arc::make_mut(&mut terrain.field);
        field.shape(&region, change);
        self.edits.rebuild |= field.bounds() != before;
        terrain.sum.take();
        self.edits.ground = self.edits.ground.with(&region);
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
