//! The materials and lights of a world.

use glam::DVec3;
use nff::{LightKind, Shader};

use super::traced::Tracing;
use super::{Lamp, LightId, MaterialId, Stuff, World, WorldError, check};

/// How an object looks. The fields are those of NFF's `f` and `#cellray shader`.
///
/// ```
/// use cellray::game::{DVec3, Material, Shader};
///
/// let gold = Material { shine: 40.0, ..Material::shiny(1.0, 0.8, 0.3) };
/// let tiles = Material {
///     shader: Shader::Checker { other: DVec3::splat(0.1), size: 1.0 },
///     ..Material::matte(0.9, 0.9, 0.9)
/// };
/// assert_eq!(gold.specular, 0.3);
/// assert_ne!(gold, tiles);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// Red, green and blue, from 0 to 1.
    pub colour: DVec3,
    /// Diffuse share, Kd.
    pub diffuse: f64,
    /// Specular share, Ks: of the highlight, and of what a mirror reflects.
    pub specular: f64,
    /// Exponent of Phong's highlight.
    pub shine: f64,
    /// Share of light let through, T; 0 is opaque.
    pub transmittance: f64,
    /// Index of refraction.
    pub refraction_index: f64,
    /// What makes its colour; [`Shader::Own`] names one of the SPU program's.
    pub shader: Shader,
}

impl Material {
    /// Without highlight or mirror.
    #[must_use]
    pub fn matte(red: f64, green: f64, blue: f64) -> Self {
        Self {
            colour: DVec3::new(red, green, blue),
            diffuse: 1.0,
            specular: 0.0,
            shine: 1.0,
            transmittance: 0.0,
            refraction_index: 1.0,
            shader: Shader::Phong,
        }
    }

    /// With a highlight, and a mirror that takes three tenths.
    #[must_use]
    pub fn shiny(red: f64, green: f64, blue: f64) -> Self {
        Self {
            diffuse: 0.7,
            specular: 0.3,
            shine: 20.0,
            ..Self::matte(red, green, blue)
        }
    }

    /// That reflects nearly all.
    #[must_use]
    pub fn mirror() -> Self {
        Self {
            diffuse: 0.1,
            specular: 0.9,
            shine: 100.0,
            ..Self::matte(1.0, 1.0, 1.0)
        }
    }

    /// That lets nearly all light through, with the refraction of crown glass.
    #[must_use]
    pub fn glass() -> Self {
        Self {
            diffuse: 0.0,
            specular: 0.1,
            shine: 100.0,
            transmittance: 0.9,
            refraction_index: 1.5,
            ..Self::matte(1.0, 1.0, 1.0)
        }
    }

    /// That shows its colour as it is, whatever light there is.
    #[must_use]
    pub fn flat(red: f64, green: f64, blue: f64) -> Self {
        Self {
            shader: Shader::Flat,
            ..Self::matte(red, green, blue)
        }
    }
}

impl Material {
    /// The same in a scene; messages say this line.
    pub(super) fn into_nff(self, line: u32) -> nff::Material {
        nff::Material {
            line,
            colour: self.colour,
            diffuse: self.diffuse,
            specular: self.specular,
            shine: self.shine,
            transmittance: self.transmittance,
            refraction_index: self.refraction_index,
            shader: self.shader,
        }
    }
}

impl From<&nff::Material> for Material {
    fn from(material: &nff::Material) -> Self {
        Self {
            colour: material.colour,
            diffuse: material.diffuse,
            specular: material.specular,
            shine: material.shine,
            transmittance: material.transmittance,
            refraction_index: material.refraction_index,
            shader: material.shader.clone(),
        }
    }
}

/// A light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light {
    /// Where it is.
    pub kind: LightKind,
    /// Its colour; without one, a grey by the number of all lights (see [`nff::Scene::brightness`]).
    pub colour: Option<DVec3>,
}

impl Light {
    /// In a place.
    #[must_use]
    pub fn at(position: DVec3) -> Self {
        Self {
            kind: LightKind::Point { position },
            colour: None,
        }
    }

    /// Infinitely far in a direction.
    #[must_use]
    pub fn sun(to_light: DVec3) -> Self {
        Self {
            kind: LightKind::Directional { to_light },
            colour: None,
        }
    }

    /// The same light with a colour.
    #[must_use]
    pub fn coloured(self, red: f64, green: f64, blue: f64) -> Self {
        Self {
            colour: Some(DVec3::new(red, green, blue)),
            ..self
        }
    }
}

impl World {
    /// Adds a material.
    pub fn add_material(&mut self, material: Material) -> Result<MaterialId, WorldError> {
        check::material(&material)?;
        let id = self.materials.insert(Stuff {
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
                    self.edits.object(object, &mut known.traced);
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
        self.edits.anew = true;
        Ok(self.lights.insert(Lamp {
            line: None,
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
            self.edits.anew |= lamp.light.colour.is_some() && light.colour.is_none();
            lamp.light = light;
            self.edits.light(id, &mut lamp.traced);
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
        if let Some(stuff) = self.materials.get_mut(id) {
            self.edits.material(id, &mut stuff.traced);
        }
    }
}
