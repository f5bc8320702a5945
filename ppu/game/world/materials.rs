//! The materials and lights of a world.

use glam::DVec3;

use super::content::{WorldLight, WorldMaterial};
use super::edits::SceneEntry;
use super::{Light, LightId, Material, MaterialId, World, WorldError, WorldErrorKind, check};

impl World {
    /// Adds a material.
    ///
    /// # Errors
    /// A number is out of range.
    #[track_caller]
    pub fn add_material(&mut self, material: Material) -> Result<MaterialId, WorldError> {
        check::material(&material)?;
        let id = self.materials.insert(WorldMaterial {
            line: None,
            material: material.into_nff(0),
            users: 0,
            traced: SceneEntry::default(),
        });
        self.touch_material(id);
        Ok(id)
    }

    /// Returns a material.
    ///
    /// # Errors
    /// There is no such material.
    #[track_caller]
    pub fn material(&self, id: MaterialId) -> Result<Material, WorldError> {
        let entry = self.materials.get(id).ok_or(WorldErrorKind::NoMaterial)?;
        Ok((&entry.material).into())
    }

    /// Changes a material, and all objects made of it.
    ///
    /// # Errors
    /// There is no such material, or a number is out of range.
    #[track_caller]
    pub fn set_material(&mut self, id: MaterialId, material: Material) -> Result<(), WorldError> {
        check::material(&material)?;
        let entry = self.materials.get_mut(id).ok_or(WorldErrorKind::NoMaterial)?;
        let material = material.into_nff(0);
        if entry.material == material {
            return Ok(());
        }
        // Transparent objects have two visible sides, so their records change too.
        let was_transparent = entry.material.transmittance > 0.0;
        let sides_change = was_transparent != (material.transmittance > 0.0);
        entry.material = material;
        self.touch_material(id);
        if sides_change {
            self.edits.rebuild |= self.meshes.values().any(|mesh| mesh.used().contains(&id));
            for (object, known) in &mut self.objects {
                if known.material == id {
                    self.edits.object(object, known);
                }
            }
        }
        Ok(())
    }

    /// Changes a material's colour, and that of all objects made of it.
    ///
    /// # Errors
    /// There is no such material, or a number is out of range.
    #[track_caller]
    pub fn recolour(&mut self, id: MaterialId, colour: impl Into<DVec3>) -> Result<(), WorldError> {
        let colour = colour.into();
        check::vector("colour", colour)?;
        let entry = self.materials.get_mut(id).ok_or(WorldErrorKind::NoMaterial)?;
        if entry.material.colour != colour {
            entry.material.colour = colour;
            self.touch_material(id);
        }
        Ok(())
    }

    /// Removes a material that no object is made of.
    ///
    /// # Errors
    /// There is no such material, or objects are made of it.
    #[track_caller]
    pub fn remove_material(&mut self, id: MaterialId) -> Result<(), WorldError> {
        match self.materials.get(id) {
            None => Err(WorldErrorKind::NoMaterial.into()),
            Some(&WorldMaterial { users, .. }) if users > 0 => {
                Err(WorldErrorKind::MaterialInUse { users }.into())
            }
            Some(_) => {
                // No object shows it, so the traced scene may keep its record.
                self.materials.remove(id);
                Ok(())
            }
        }
    }

    /// The handles of all materials.
    pub fn materials(&self) -> impl Iterator<Item = MaterialId> {
        self.materials.keys()
    }

    /// The most lights of a world.
    pub const MAX_LIGHTS: usize = protocol::layout::MAX_LIGHTS as usize;

    /// Adds a light.
    ///
    /// # Errors
    /// A number is out of range, or a directional light has no direction.
    #[track_caller]
    pub fn add_light(&mut self, light: Light) -> Result<LightId, WorldError> {
        check::light(&light)?;
        // The brightness of the other lights may depend on how many there are.
        self.edits.rebuild = true;
        Ok(self.lights.insert(WorldLight { line: None, light, traced: SceneEntry::default() }))
    }

    /// Returns a light.
    ///
    /// # Errors
    /// There is no such light.
    #[track_caller]
    pub fn light(&self, id: LightId) -> Result<Light, WorldError> {
        let entry = self.lights.get(id).ok_or(WorldErrorKind::NoLight)?;
        Ok(entry.light)
    }

    /// Moves a light, or changes its colour.
    ///
    /// # Errors
    /// There is no such light, a number is out of range, or a directional light has no direction.
    #[track_caller]
    pub fn set_light(&mut self, id: LightId, light: Light) -> Result<(), WorldError> {
        check::light(&light)?;
        let entry = self.lights.get_mut(id).ok_or(WorldErrorKind::NoLight)?;
        if entry.light != light {
            self.edits.rebuild |= entry.light.colour.is_some() && light.colour.is_none();
            entry.light = light;
            self.edits.light(id, &mut entry.traced);
        }
        Ok(())
    }

    /// Removes a light.
    ///
    /// # Errors
    /// There is no such light.
    #[track_caller]
    pub fn remove_light(&mut self, id: LightId) -> Result<(), WorldError> {
        self.lights.remove(id).ok_or(WorldErrorKind::NoLight)?;
        self.edits.rebuild = true;
        Ok(())
    }

    /// The handles of all lights.
    pub fn lights(&self) -> impl Iterator<Item = LightId> {
        self.lights.keys()
    }

    fn touch_material(&mut self, id: MaterialId) {
        if let Some(entry) = self.materials.get_mut(id) {
            self.edits.material(id, &mut entry.traced);
        }
    }
}
