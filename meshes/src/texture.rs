//! Decodes the pictures of textures.

use std::collections::HashMap;
use std::io::Cursor;
use std::sync::Arc;

use image::imageops::{FilterType, resize};
use image::{DynamicImage, ImageFormat, ImageReader, Limits, RgbImage};
use nff::{Material, Texture, Wrap};

/// The most texels of all textures of a file. SPUs read them from main memory, where they take
/// 8 bytes each with the smaller levels.
pub const MAX_TEXELS: usize = 1 << 24;
/// The most pixels across and down of a picture that is decoded; larger textures than
/// [`Texture::MAX_SIDE`] are made smaller.
const MAX_PIXELS: u32 = 16_384;

/// A decoded picture.
#[derive(Clone)]
pub(crate) struct Decoded {
    pub texture: Arc<Texture>,
    /// Alpha of each texel, if the picture has any.
    pub alpha: Option<Arc<Vec<u8>>>,
    /// What a user should know.
    pub note: Option<String>,
}

/// Decodes a PNG or a JPEG.
pub(crate) fn decode(bytes: &[u8], wrap: [Wrap; 2]) -> Result<Decoded, String> {
    let (picture, note) = picture(bytes)?;
    let has_alpha = picture.color().has_alpha();
    let width = picture.width();
    let alpha = has_alpha.then(|| picture.to_rgba8().pixels().map(|it| it.0[3]).collect());
    let texels = picture.into_rgb8().pixels().map(|pixel| pixel.0).collect();
    let texture = Texture::new(width, texels, wrap).ok_or("it has no pixels")?;
    Ok(Decoded {
        texture: Arc::new(texture),
        alpha: alpha.map(Arc::new),
        note,
    })
}

/// The brightness of each pixel of a picture whose grey is a mask, or its alpha if it has any, and
/// the picture's width.
pub(crate) fn decode_mask(bytes: &[u8]) -> Result<(u32, Vec<u8>), String> {
    let (picture, _) = picture(bytes)?;
    let values = if picture.color().has_alpha() {
        picture.to_rgba8().pixels().map(|it| it.0[3]).collect()
    } else {
        picture.to_luma8().into_raw()
    };
    Ok((picture.width(), values))
}

/// A picture that is no larger than a texture may be.
fn picture(bytes: &[u8]) -> Result<(DynamicImage, Option<String>), String> {
    let mut reader = ImageReader::new(Cursor::new(bytes))
        .with_guessed_format()
        .map_err(|error| error.to_string())?;
    match reader.format() {
        Some(ImageFormat::Png | ImageFormat::Jpeg) => {}
        _ => return Err(format!("it is {}", kind(bytes))),
    }
    let mut limits = Limits::default();
    limits.max_image_width = Some(MAX_PIXELS);
    limits.max_image_height = Some(MAX_PIXELS);
    limits.max_alloc = Some(1 << 31);
    reader.limits(limits);
    let picture = reader.decode().map_err(|error| error.to_string())?;
    let (width, height) = (picture.width(), picture.height());
    let most = Texture::MAX_SIDE;
    if width.max(height) <= most {
        return Ok((picture, None));
    }
    let smaller = picture.resize(most, most, FilterType::Triangle);
    let note = format!(
        "it has {width}x{height} pixels and is drawn with {}x{}",
        smaller.width(),
        smaller.height()
    );
    Ok((smaller, Some(note)))
}

/// What a picture is that can't be decoded.
fn kind(bytes: &[u8]) -> &'static str {
    let is_at =
        |start: usize, mark: &[u8]| bytes.get(start..).is_some_and(|it| it.starts_with(mark));
    if is_at(0, b"RIFF") && is_at(8, b"WEBP") {
        "a WebP picture; convert it to PNG or JPEG"
    } else if is_at(0, b"\xabKTX ") {
        "a KTX picture; convert it to PNG or JPEG"
    } else if is_at(0, b"DDS ") {
        "a DDS picture; convert it to PNG or JPEG"
    } else if is_at(0, b"GIF8") {
        "a GIF picture; convert it to PNG or JPEG"
    } else if is_at(0, b"BM") {
        "a BMP picture; convert it to PNG or JPEG"
    } else if is_at(0, b"II*\0") || is_at(0, b"MM\0*") {
        "a TIFF picture; convert it to PNG or JPEG"
    } else {
        "neither a PNG nor a JPEG"
    }
}

/// Halves the largest textures of materials until all of them together are few enough texels.
/// Returns a note if that changed anything.
pub(crate) fn shrink(materials: &mut [Material]) -> Option<String> {
    let mut textures: Vec<Arc<Texture>> = Vec::new();
    for texture in materials.iter().filter_map(|it| it.texture.as_ref()) {
        if !textures.iter().any(|known| Arc::ptr_eq(known, texture)) {
            textures.push(texture.clone());
        }
    }
    let total = |textures: &[Arc<Texture>]| -> usize {
        textures.iter().map(|texture| texture.texels().len()).sum()
    };
    let before = total(&textures);
    if before <= MAX_TEXELS {
        return None;
    }
    let mut smaller = textures.clone();
    while total(&smaller) > MAX_TEXELS {
        let largest = smaller
            .iter_mut()
            .max_by_key(|texture| texture.texels().len())?;
        *largest = Arc::new(halved(largest)?);
    }
    let replaced: HashMap<*const Texture, &Arc<Texture>> =
        textures.iter().map(Arc::as_ptr).zip(&smaller).collect();
    for texture in materials.iter_mut().filter_map(|it| it.texture.as_mut()) {
        if let Some(&new) = replaced.get(&Arc::as_ptr(texture)) {
            *texture = new.clone();
        }
    }
    let after = total(&smaller);
    Some(format!(
        "the textures have {before} texels, more than {MAX_TEXELS}; they are drawn with {after}"
    ))
}

/// A texture with half as many texels across and down.
fn halved(texture: &Texture) -> Option<Texture> {
    let (width, height) = (texture.width(), texture.height());
    let bytes = texture.texels().as_flattened().to_vec();
    let picture = RgbImage::from_raw(width, height, bytes)?;
    let half = |side: u32| (side / 2).max(1);
    let smaller = resize(&picture, half(width), half(height), FilterType::Triangle);
    let texels = smaller.pixels().map(|pixel| pixel.0).collect();
    Texture::new(half(width), texels, texture.wrap())
}
