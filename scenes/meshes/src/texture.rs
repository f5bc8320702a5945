//! Decodes the pictures of textures.

use std::collections::HashMap;
use std::io::Cursor;
use std::sync::Arc;

use image::{ImageFormat, ImageReader, Limits};
use scenes::{Material, Texture, Wrap};

/// The most texels of all textures of a file. SPUs read them from main memory, where they take
/// 8 bytes each with the smaller levels.
pub const MAX_TEXELS: usize = 1 << 24;
/// The most pixels across and down of a picture that is decoded; larger textures than
/// [`Texture::MAX_SIDE`] are made smaller.
const MAX_PIXELS: u32 = 16_384;

#[derive(Clone)]
pub(crate) struct Decoded {
    pub texture: Arc<Texture>,
    /// Alpha of each texel, if the picture has any.
    pub alpha: Option<Arc<Vec<u8>>>,
    pub note: Option<String>,
}

/// Decodes a PNG or a JPEG.
pub(crate) fn decode(bytes: &[u8], wrap: [Wrap; 2]) -> Result<Decoded, String> {
    let (picture, note) = picture(bytes)?;
    let width = picture.width;
    let alpha = picture.has_alpha.then(|| picture.alpha());
    let texels = picture.texels.into_iter().map(|[red, green, blue, _]| [red, green, blue]);
    let texture = Texture::new(width, texels.collect(), wrap).ok_or("it has no pixels")?;
    Ok(Decoded { texture: Arc::new(texture), alpha: alpha.map(Arc::new), note })
}

/// The alpha of each pixel of a picture that is a mask, or its brightness if it has none, and the
/// picture's width.
pub(crate) fn decode_mask(bytes: &[u8]) -> Result<(u32, Vec<u8>), String> {
    let (picture, _) = picture(bytes)?;
    let values = if picture.has_alpha {
        picture.alpha()
    } else {
        // The weights of ITU-R BT.709.
        let brightness = |&[red, green, blue, _]: &[u8; 4]| {
            let [red, green, blue] = [red, green, blue].map(u32::from);
            ((2126 * red + 7152 * green + 722 * blue + 5000) / 10_000) as u8
        };
        picture.texels.iter().map(brightness).collect()
    };
    Ok((picture.width, values))
}

/// A picture: red, green, blue and alpha, row by row.
struct Picture {
    width: u32,
    height: u32,
    texels: Vec<[u8; 4]>,
    has_alpha: bool,
}

impl Picture {
    fn alpha(&self) -> Vec<u8> {
        self.texels.iter().map(|texel| texel[3]).collect()
    }
}

/// What decodes a PNG or a JPEG that is not too large.
pub(crate) fn reader(bytes: &[u8]) -> Result<ImageReader<Cursor<&[u8]>>, String> {
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
    Ok(reader)
}

/// A picture that is no larger than a texture may be.
fn picture(bytes: &[u8]) -> Result<(Picture, Option<String>), String> {
    let decoded = reader(bytes)?.decode().map_err(|error| error.to_string())?;
    let has_alpha = decoded.color().has_alpha();
    let pixels = decoded.into_rgba8();
    let (width, height) = (pixels.width(), pixels.height());
    let mut picture = Picture {
        width,
        height,
        texels: pixels.pixels().map(|pixel| pixel.0).collect(),
        has_alpha,
    };
    while picture.width.max(picture.height) > Texture::MAX_SIDE {
        picture.texels = halved(picture.width, picture.height, &picture.texels);
        picture.width = half(picture.width);
        picture.height = half(picture.height);
    }
    let note = (picture.width != width).then(|| {
        format!(
            "it has {width}x{height} pixels and is drawn with {}x{}",
            picture.width, picture.height
        )
    });
    Ok((picture, note))
}

/// Half of a side, but at least 1.
fn half(side: u32) -> u32 {
    (side / 2).max(1)
}

/// The texels of half as many columns and rows. Each is the mean of the four that it covers; of an
/// odd side, the last column or row is left out. The crate `image` resizes by functions of the
/// system's library, whose results differ between systems.
fn halved<const N: usize>(width: u32, height: u32, texels: &[[u8; N]]) -> Vec<[u8; N]> {
    let texel = |column: u32, row: u32| {
        let (column, row) = (column.min(width - 1), row.min(height - 1));
        texels[row as usize * width as usize + column as usize]
    };
    let mean = |column: u32, row: u32| {
        let four = [
            texel(column, row),
            texel(column + 1, row),
            texel(column, row + 1),
            texel(column + 1, row + 1),
        ];
        std::array::from_fn(|channel| {
            let sum: u32 = four.iter().map(|texel| u32::from(texel[channel])).sum();
            ((sum + 2) / 4) as u8
        })
    };
    let rows = 0..half(height);
    rows.flat_map(|row| (0..half(width)).map(move |column| (column, row)))
        .map(|(column, row)| mean(2 * column, 2 * row))
        .collect()
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
        let largest = smaller.iter_mut().max_by_key(|texture| texture.texels().len())?;
        let texels = halved(largest.width(), largest.height(), largest.texels());
        *largest = Arc::new(Texture::new(half(largest.width()), texels, largest.wrap())?);
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
