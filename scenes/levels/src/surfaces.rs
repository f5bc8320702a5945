//! The materials of a level: one for each picture.

use std::collections::HashMap;
use std::sync::Arc;

use glam::{DVec2, DVec3};
use scenes::{Material, Shader, Texture, Wrap};

use crate::graphics::FLAT;
use crate::holes::{Rectangle, rectangles};
use crate::{Error, Name, Pictures, Sprite};

/// The flat of sectors that are open to the sky.
pub const SKY: &str = "F_SKY1";
/// The shader that mixes two colours by the height of a ray's direction.
const GRADIENT: &str = "sky";
/// The pictures of skies, of which the first that exists is taken.
const SKIES: [&str; 4] = ["SKY1", "SKY2", "SKY3", "SKY4"];
/// The most textures: as many as have their records in local store beside those of a level.
const MAX_TEXTURES: usize = 240;

/// What a material shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Surface {
    /// The picture of a wall.
    Wall(Name),
    /// The picture of a floor or a ceiling.
    Flat(Name),
    /// The picture of a thing.
    Sprite(Name),
    /// The sky.
    Sky,
}

/// A material, and the size of its picture in units.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Shown {
    pub material: u32,
    /// A factor of the light.
    pub colour: DVec3,
    pub size: DVec2,
}

/// The materials that a level has so far.
pub(crate) struct Surfaces<'a, P> {
    pictures: &'a P,
    known: HashMap<Surface, Shown>,
    /// The parts of pictures with holes, unless they have too many.
    holes: HashMap<Surface, Option<Arc<[Rectangle]>>>,
    /// The material of those without a texture, which have a colour instead.
    plain: Option<u32>,
    pub materials: Vec<Material>,
    pub surfaces: Vec<Surface>,
    pub notes: Vec<String>,
}

impl<'a, P: Pictures> Surfaces<'a, P> {
    pub fn new(pictures: &'a P) -> Self {
        let nothing = Vec::new;
        Self {
            pictures,
            known: HashMap::new(),
            holes: HashMap::new(),
            plain: None,
            materials: nothing(),
            surfaces: Vec::new(),
            notes: Vec::new(),
        }
    }

    /// The material that shows this.
    pub fn shown(&mut self, surface: Surface) -> Result<Shown, Error> {
        if let Some(known) = self.known.get(&surface) {
            return Ok(*known);
        }
        let square = DVec2::splat(FLAT as f64);
        let (picture, what) = match surface {
            Surface::Wall(name) => (self.pictures.wall(name)?, "wall"),
            Surface::Flat(name) => (self.pictures.flat(name)?, "floor"),
            Surface::Sprite(name) => (self.sprite(name)?.map(|it| it.picture), "thing"),
            Surface::Sky => (None, "sky"),
        };
        let mut size = square;
        let mut colour = None;
        let mut material = Material::matte(DVec3::ONE);
        if surface == Surface::Sky {
            material = self.sky()?;
        } else if let Some(picture) = picture {
            size = DVec2::new(picture.width as f64, picture.height() as f64);
            if picture.has_holes() && !matches!(surface, Surface::Sprite(_)) {
                self.holes.insert(surface, rectangles(&picture).map(Arc::from));
            }
            let texels = picture.filled();
            if self.surfaces.len() < MAX_TEXTURES {
                let texture = Texture::new(picture.width as u32, texels, [Wrap::Repeat; 2]);
                material =
                    Material { texture: texture.map(Arc::new), ..Material::matte(DVec3::ONE) };
            } else {
                colour = Some(mean(&texels));
                self.notes.push(format!(
                    "there are more than {MAX_TEXTURES} textures; {surface:?} has only its mean colour"
                ));
            }
        } else if let Surface::Wall(name) | Surface::Flat(name) | Surface::Sprite(name) = surface {
            colour = Some(DVec3::splat(0.5));
            self.notes.push(format!("there is no picture of a {what} with the name {name}"));
        }
        let next = self.materials.len() as u32;
        let number = match colour {
            Some(_) => *self.plain.get_or_insert(next),
            None => next,
        };
        if number == next {
            self.materials.push(material);
            self.surfaces.push(surface);
        }
        let colour = colour.unwrap_or(DVec3::ONE);
        let shown = Shown { material: number, colour, size };
        self.known.insert(surface, shown);
        Ok(shown)
    }

    /// The picture of a thing; `None` if no thing has one of this name.
    pub fn sprite(&self, name: Name) -> Result<Option<Sprite>, Error> {
        self.pictures.sprite(name)
    }

    /// The rectangles of texels of a known picture with holes, or none if they are too many; `None`
    /// if it has no holes.
    pub fn holes(&self, surface: Surface) -> Option<Option<Arc<[Rectangle]>>> {
        self.holes.get(&surface).cloned()
    }

    /// The sky: a gradient of the colours at the bottom and at the top of its picture, because what
    /// a ray sees of it depends on the ray's direction alone.
    fn sky(&self) -> Result<Material, Error> {
        let mut colours = [DVec3::new(0.7, 0.78, 0.9), DVec3::new(0.25, 0.4, 0.75)];
        for name in SKIES {
            if let Some(picture) = self.pictures.wall(Name::new(name))? {
                let texels: Vec<[u8; 3]> = picture.texels.into_iter().flatten().collect();
                let part = (texels.len() / 4).max(1);
                let bottom = mean(&texels[texels.len().saturating_sub(part)..]);
                let top = mean(&texels[..part.min(texels.len())]);
                colours = [bottom, top];
                break;
            }
        }
        let [horizon, zenith] = colours;
        Ok(Material {
            emission: horizon,
            diffuse: 0.0,
            shader: Shader::Own { name: GRADIENT.to_owned(), parameters: [0.0, 1.0, 0.0, 0.0] },
            ..Material::matte(zenith)
        })
    }
}

/// The mean colour of texels.
fn mean(texels: &[[u8; 3]]) -> DVec3 {
    let sum: DVec3 = texels.iter().map(|texel| DVec3::from(texel.map(f64::from))).sum();
    sum / (255.0 * texels.len().max(1) as f64)
}
