//! glTF's base colour textures.

use std::collections::HashMap;

use scenes::Wrap;

use super::accessor::Data;
use super::json;
use super::resource;
use crate::builder::Builder;
use crate::texture::{Decoded, decode};
use std::borrow::Cow;
use std::path::Path;

/// glTF's numbers of what is beyond a texture's edges.
const CLAMP_TO_EDGE: u32 = 33071;
const MIRRORED_REPEAT: u32 = 33648;

/// Extensions that put a texture's picture elsewhere, with the names of the formats.
const FORMATS: [(&str, &str); 4] = [
    ("KHR_texture_basisu", "KTX2"),
    ("EXT_texture_webp", "WebP"),
    ("EXT_texture_avif", "AVIF"),
    ("MSFT_texture_dds", "DDS"),
];

/// The textures of a file that were decoded, by their images and what is beyond their edges.
#[derive(Default)]
pub(super) struct Textures {
    known: HashMap<(usize, [Wrap; 2]), Option<Decoded>>,
}

impl Textures {
    /// A texture; `None`, with a note, if it can't be shown.
    pub fn of(
        &mut self,
        info: &json::TextureInfo,
        data: &Data<'_>,
        folder: &Path,
        builder: &mut Builder,
    ) -> Option<Decoded> {
        let index = info.index;
        let (image, wrap) = match place(index, data) {
            Ok(found) => found,
            Err(what) => {
                without(&format!("texture {index}"), &what, builder);
                return None;
            }
        };
        let found = self.known.entry((image, wrap)).or_insert_with(|| {
            let bytes = bytes(image, data, folder);
            match bytes.and_then(|bytes| decode(&bytes, wrap)) {
                Ok(found) => {
                    if let Some(note) = &found.note {
                        builder.notes.add(format!("image {image}: {note}"));
                    }
                    Some(found)
                }
                Err(what) => {
                    without(&format!("image {image}"), &what, builder);
                    None
                }
            }
        });
        found.clone()
    }
}

fn without(name: &str, what: &str, builder: &mut Builder) {
    let note = format!("{name}: {what}; surfaces are drawn without it");
    builder.notes.add(note);
}

/// The image of a texture, and what is beyond its edges.
fn place(index: usize, data: &Data<'_>) -> Result<(usize, [Wrap; 2]), String> {
    let root = data.root;
    let texture = root.textures.get(index).ok_or("it doesn't exist")?;
    let Some(image) = texture.source else {
        let mut formats = FORMATS.iter();
        return Err(match formats.find(|(name, _)| texture.extensions.contains_key(*name)) {
            Some((name, format)) => format!(
                "it is a {format} picture ({name}); convert the file's textures to PNG or JPEG"
            ),
            None => "it has no image".into(),
        });
    };
    let sampler = match texture.sampler {
        None => None,
        Some(index) => {
            let sampler = root.samplers.get(index);
            Some(sampler.ok_or_else(|| format!("sampler {index} doesn't exist"))?)
        }
    };
    let wrap = sampler.map_or([Wrap::Repeat; 2], |sampler| {
        [sampler.wrap_s, sampler.wrap_t].map(|mode| match mode {
            Some(CLAMP_TO_EDGE) => Wrap::Clamp,
            Some(MIRRORED_REPEAT) => Wrap::Mirror,
            _ => Wrap::Repeat,
        })
    });
    Ok((image, wrap))
}

fn bytes<'a>(index: usize, data: &'a Data<'_>, folder: &Path) -> Result<Cow<'a, [u8]>, String> {
    let image = data.root.images.get(index).ok_or("it doesn't exist")?;
    match (image.buffer_view, &image.uri) {
        (Some(view), _) => data.view(view).map(Cow::Borrowed).map_err(|what| format!("it {what}")),
        (None, Some(uri)) => resource::bytes(uri, folder),
        (None, None) => Err("it has neither a buffer view nor a URI".into()),
    }
}
