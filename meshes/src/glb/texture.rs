//! glTF's base colour textures.

use std::collections::HashMap;
use std::sync::Arc;

use gltf::json::Root;
use gltf::json::texture::WrappingMode;
use gltf::json::validation::Checked;
use nff::{Texture, Wrap};

use super::wrong;
use crate::Fault;
use crate::builder::Builder;
use crate::texture::decode;

/// The base colour texture of a material, and the set of texture coordinates that it is for.
pub(super) struct BaseColour {
    pub texture: Arc<Texture>,
    pub set: u32,
}

/// The textures of a file that were decoded, by their images and what is beyond their edges.
pub(super) struct Textures<'a> {
    json: &'a Root,
    blob: &'a [u8],
    known: HashMap<(usize, [Wrap; 2]), Arc<Texture>>,
}

impl<'a> Textures<'a> {
    pub fn new(json: &'a Root, blob: &'a [u8]) -> Self {
        let known = HashMap::new();
        Self { json, blob, known }
    }

    /// The texture of the material with this index, if it has one.
    pub fn of(
        &mut self,
        material: usize,
        builder: &mut Builder,
    ) -> Result<Option<BaseColour>, Fault> {
        let Some(material) = self.json.materials.get(material) else {
            return Ok(None);
        };
        let Some(found) = &material.pbr_metallic_roughness.base_color_texture else {
            return Ok(None);
        };
        let index = found.index.value();
        let set = found.tex_coord;
        let missing = |what: &str, index: usize| wrong(format!("{what} {index} doesn't exist"));
        let texture = self.json.textures.get(index);
        let texture = texture.ok_or_else(|| missing("texture", index))?;
        let sampler = match &texture.sampler {
            None => None,
            Some(index) => {
                let index = index.value();
                let sampler = self.json.samplers.get(index);
                Some(sampler.ok_or_else(|| missing("sampler", index))?)
            }
        };
        let wrap = sampler.map_or([Wrap::Repeat; 2], |sampler| {
            [sampler.wrap_s, sampler.wrap_t].map(|mode| match mode {
                Checked::Valid(WrappingMode::ClampToEdge) => Wrap::Clamp,
                Checked::Valid(WrappingMode::MirroredRepeat) => Wrap::Mirror,
                Checked::Valid(WrappingMode::Repeat) | Checked::Invalid => Wrap::Repeat,
            })
        });
        let image = texture.source.value();
        if let Some(texture) = self.known.get(&(image, wrap)) {
            let texture = texture.clone();
            return Ok(Some(BaseColour { texture, set }));
        }
        let bytes = self.image(image)?;
        let name = || format!("image {image}");
        let (texture, has_alpha) =
            decode(bytes, wrap).map_err(|what| Fault::Texture { name: name(), what })?;
        if has_alpha {
            builder.note("the alpha of textures is ignored");
        }
        let texture = builder.texture(texture)?;
        self.known.insert((image, wrap), texture.clone());
        Ok(Some(BaseColour { texture, set }))
    }

    /// The bytes of an image's file, which are in the binary chunk.
    fn image(&self, index: usize) -> Result<&'a [u8], Fault> {
        let bad = |what: String| Fault::Texture {
            name: format!("image {index}"),
            what,
        };
        let image = self.json.images.get(index);
        let image = image.ok_or_else(|| bad("it doesn't exist".into()))?;
        let Some(view) = &image.buffer_view else {
            let uri = image.uri.as_deref().unwrap_or_default();
            let start: String = uri.chars().take(60).collect();
            return Err(bad(format!(
                "it is not in the binary chunk, but at \"{start}\", which is not supported"
            )));
        };
        let number = view.value();
        let view = self.json.buffer_views.get(number);
        let view = view.ok_or_else(|| bad(format!("buffer view {number} doesn't exist")))?;
        let start = view.byte_offset.map_or(0, |offset| offset.0);
        let length = view.byte_length.0;
        let is_own = self
            .json
            .buffers
            .get(view.buffer.value())
            .is_some_and(|buffer| buffer.uri.is_none());
        if !is_own {
            return Err(bad("it is in another file, which is not supported".into()));
        }
        let end = start.checked_add(length);
        let part = end.and_then(|end| self.blob.get(start as usize..end as usize));
        part.ok_or_else(|| {
            bad(format!(
                "its {length} bytes from {start} on are not all in the {} bytes of the binary chunk",
                self.blob.len()
            ))
        })
    }
}
