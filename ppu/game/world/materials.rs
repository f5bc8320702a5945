//! The materials and lights of a world.

use glam::DVec3;

use super::content::{WorldLight, WorldMaterial};
use super::edits::Tracing;
use super::{Light, LightId, Material, MaterialId, World, WorldError, check};

impl World {
    /// Adds a material.
    pub fn add_material(&mut self, material: Material) -> Result<MaterialId, WorldError> {
        check::material(&material)?;
        let id = self.materials.insert(WorldMaterial {
            line: None,
            material: material.into_nff(0),
            users: 0,
            traced: Tracing::default(),
        });
        self.touch_material(id);
        Ok(id)
    }

    /// A material.
    pub fn material(&self, id: MaterialId) -> Result<Material, WorldError> {
        let entry = self.materials.get(id).ok_or(WorldError::NoMaterial)?;
        Ok((&entry.material).into())
    }

    /// Changes a material, and all objects made of it.
    pub fn set_material(&mut self, id: MaterialId, material: Material) -> Result<(), WorldError> {
        check::material(&material)?;
        let entry = self.materials.get_mut(id).ok_or(WorldError::NoMaterial)?;
        let material = material.into_nff(0);
        if entry.material == material {
            return Ok(());
        }
        // Of what lets light through, both sides are seen.
        let had_sides = entry.material.transmittance > 0.0;
        let other_sides = had_sides != (material.transmittance > 0.0);
        entry.material = material;
        self.touch_material(id);
        if other_sides {
            for (object, known) in &mut self.objects {
                if known.material == id {
                    self.edits.object(object, &mut known.traced);
                }
            }
        }
        Ok(())
    }

    /// Changes a material's colour, and that of all objects made of it.
    pub fn recolour(&mut self, id: MaterialId, colour: DVec3) -> Result<(), WorldError> {
        check::vector("colour", colour)?;
        let entry = self.materials.get_mut(id).ok_or(WorldError::NoMaterial)?;
        if entry.material.colour != colour {
            entry.material.colour = colour;
            self.touch_material(id);
        }
        Ok(())
    }

    /// Removes a material that no object is made of.
    pub fn remove_material(&mut self, id: MaterialId) -> Result<(), WorldError> {
        match self.materials.get(id) {
            None => Err(WorldError::NoMaterial),
            Some(&WorldMaterial { users, .. }) if users > 0 => {
                Err(WorldError::MaterialInUse { users })
            }
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
        self.edits.anew = true;
        Ok(self.lights.insert(WorldLight {
            line: None,
            light,
            traced: Tracing::default(),
        }))
    }

    /// A light.
    pub fn light(&self, id: LightId) -> Result<Light, WorldError> {
        let entry = self.lights.get(id).ok_or(WorldError::NoLight)?;
        Ok(entry.light)
    }

    /// Moves a light, or changes its colour.
    pub fn set_light(&mut self, id: LightId, light: Light) -> Result<(), WorldError> {
        check::light(&light)?;
        let entry = self.lights.get_mut(id).ok_or(WorldError::NoLight)?;
        if entry.light != light {
            self.edits.anew |= entry.light.colour.is_some() && light.colour.is_none();
            entry.light = light;
            self.edits.light(id, &mut entry.traced);
        }
        Ok(())
    }

    /// Removes a light.
    pub fn remove_light(&mut self, id: LightId) -> Result<(), WorldError> {
        self.lights.remove(id).ok_or(WorldError::NoLight)?;
        self.edits.anew = true;
        Ok(())
    }

    /// All lights.
    pub fn lights(&self) -> impl Iterator<Item = LightId> {
        self.lights.keys()
    }

    fn touch_material(&mut self, id: MaterialId) {
        if let Some(entry) = self.materials.get_mut(id) {
            self.edits.material(id, &mut entry.traced);
        }
    }
}
