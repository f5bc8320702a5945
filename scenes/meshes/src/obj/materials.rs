//! The materials of OBJ files as those of Whitted's model.

use std::collections::HashMap;
use std::path::Path;
use std::sync::Arc;

use glam::DVec3;
use scenes::{Material, Wrap};

use super::library::{Definition, Libraries, Map};
use super::{FaceMaterial, NONE};
use crate::Fault;
use crate::builder::Builder;
use crate::mask::Mask;
use crate::text::shown;
use crate::texture::{Decoded, decode, decode_mask};

/// The first illumination model with reflection by ray tracing.
const REFLECTS: f64 = 3.0;
/// The grey of surfaces without a colour.
const GREY: f64 = 0.8;
/// The alpha from which on a surface with a mask is there.
const LIMIT: f64 = 0.5;

/// The builder's materials of a file, made when a face needs them.
pub(super) struct Materials<'a> {
    names: &'a [Vec<u8>],
    libraries: &'a Libraries,
    /// By the name's index, whether it is textured, and whether its vertices have colours.
    made: HashMap<(u32, bool, bool), FaceMaterial>,
    textures: HashMap<Map, Option<Decoded>>,
}

impl<'a> Materials<'a> {
    pub fn new(names: &'a [Vec<u8>], libraries: &'a Libraries) -> Self {
        Self { names, libraries, made: HashMap::new(), textures: HashMap::new() }
    }

    /// The material of a face with this name's index.
    pub fn of(
        &mut self,
        name: u32,
        has_places: bool,
        has_colour: bool,
        file: &str,
        line: usize,
        builder: &mut Builder,
    ) -> Result<FaceMaterial, Fault> {
        if let Some(&known) = self.made.get(&(name, has_places, has_colour)) {
            return Ok(known);
        }
        let text = self.names.get(name as usize).filter(|_| name != NONE);
        let definition = text.and_then(|name| self.libraries.find(name));
        if let (Some(text), None) = (text, definition) {
            let note = format!("no library has the material {}; it is grey", shown(text));
            builder.notes.line(file, line, &note, &note);
        }
        let made = match definition {
            Some(definition) => {
                self.make(definition, has_places, has_colour, file, line, builder)?
            }
            None => FaceMaterial {
                number: builder.material(Material::matte(DVec3::splat(bare(has_colour))), None)?,
                is_textured: false,
                is_coloured: has_colour,
            },
        };
        self.made.insert((name, has_places, has_colour), made);
        Ok(made)
    }

    fn make(
        &mut self,
        definition: &Definition,
        has_places: bool,
        has_colour: bool,
        file: &str,
        line: usize,
        builder: &mut Builder,
    ) -> Result<FaceMaterial, Fault> {
        let maps = [&definition.diffuse_map, &definition.dissolve_map];
        let wants_places = maps.iter().any(|map| map.is_some());
        if wants_places && !has_places {
            let text = format!(
                "the material {} has a texture, but a face has no texture coordinates; it is drawn without it",
                shown(&definition.name)
            );
            builder.notes.line(file, line, &text, &text);
        }
        let [colours, holes] = maps.map(|map| map.as_ref().filter(|_| has_places));
        let texture = colours.and_then(|map| self.texture(map, builder));
        let mask = holes.and_then(|map| self.mask(map, builder));
        let has_texture = texture.is_some();
        let mut made = material(definition, has_texture || has_colour);
        made.texture = texture;
        Ok(FaceMaterial {
            number: builder.material(made, mask.clone())?,
            is_textured: has_texture || mask.is_some(),
            is_coloured: has_colour,
        })
    }

    /// The texture of a picture; if there is none, a note gives the reason.
    fn texture(&mut self, map: &Map, builder: &mut Builder) -> Option<Arc<scenes::Texture>> {
        if let Some(known) = self.textures.get(map) {
            return known.as_ref().map(|it| it.texture.clone());
        }
        let wrap = [wrap(map); 2];
        let found = bytes(&map.path).and_then(|bytes| decode(&bytes, wrap));
        let found = match found {
            Ok(found) => {
                if let Some(note) = &found.note {
                    let name = map.path.display();
                    builder.notes.add(format!("the texture {name}: {note}"));
                }
                Some(found)
            }
            Err(what) => {
                without(&map.path, &what, builder);
                None
            }
        };
        let texture = found.as_ref().map(|it| it.texture.clone());
        if found.as_ref().is_some_and(|it| it.alpha.is_some()) {
            let note = "the alpha of textures is ignored without map_d";
            builder.notes.add(note);
        }
        self.textures.insert(map.clone(), found);
        texture
    }

    fn mask(&self, map: &Map, builder: &mut Builder) -> Option<Arc<Mask>> {
        match bytes(&map.path).and_then(|bytes| decode_mask(&bytes)) {
            Ok((width, values)) => {
                let mask = Mask::new(width, &values, 1.0, LIMIT, [wrap(map); 2]);
                (!mask.is_whole()).then(|| Arc::new(mask))
            }
            Err(what) => {
                without(&map.path, &what, builder);
                None
            }
        }
    }
}

fn wrap(map: &Map) -> Wrap {
    if map.clamps { Wrap::Clamp } else { Wrap::Repeat }
}

fn bytes(path: &Path) -> Result<Vec<u8>, String> {
    crate::bytes(path).map_err(|fault| fault.to_string())
}

fn without(path: &Path, what: &str, builder: &mut Builder) {
    let name = path.display();
    let note = format!("the texture {name}: {what}; surfaces are drawn without it");
    builder.notes.add(note);
}

/// The colour of a surface without one: that of its texture or its vertices, or a grey.
fn bare(has_colours: bool) -> f64 {
    if has_colours { 1.0 } else { GREY }
}

/// The shares of a material. Only illumination models with ray tracing reflect: the highlight and
/// the mirror have one share in Whitted's model, and most files mean the highlight alone.
fn material(found: &Definition, has_colours: bool) -> Material {
    let share = |value: f64| value.clamp(0.0, 1.0);
    let colour = |colour: [f64; 3]| DVec3::from(colour).clamp(DVec3::ZERO, DVec3::ONE);
    let reflects = found.illumination.is_some_and(|model| model >= REFLECTS);
    let specular = found.specular.filter(|_| reflects);
    let specular = specular.map_or(0.0, |it| share(it[0].max(it[1]).max(it[2])));
    let dissolve = found.dissolve.or(found.transparency.map(|it| 1.0 - it));
    Material {
        specular,
        shine: found.shine.unwrap_or(1.0).clamp(1.0, 1000.0),
        transmittance: 1.0 - dissolve.map_or(1.0, share),
        refraction_index: found.index.unwrap_or(1.0).clamp(1.0, 10.0),
        emission: found.emission.map_or(DVec3::ZERO, colour),
        ..Material::matte(found.diffuse.map_or(DVec3::splat(bare(has_colours)), colour))
    }
}
