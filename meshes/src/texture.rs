//! Decodes the pictures of textures.

use std::io::Cursor;

use image::{ImageFormat, ImageReader, Limits};
use nff::{Texture, Wrap};

/// The most texels of all textures of a file. SPUs read them from main memory, where they take
/// 8 bytes each with the smaller levels.
pub const MAX_TEXELS: usize = 1 << 24;

/// Decodes a PNG or a JPEG. Returns whether it has an alpha channel, too, which is left out.
pub(crate) fn decode(bytes: &[u8], wrap: [Wrap; 2]) -> Result<(Texture, bool), String> {
    let reader = || {
        let reader = ImageReader::new(Cursor::new(bytes)).with_guessed_format();
        let known = reader
            .ok()
            .filter(|reader| matches!(reader.format(), Some(ImageFormat::Png | ImageFormat::Jpeg)));
        known.ok_or_else(|| String::from("it is neither a PNG nor a JPEG"))
    };
    let told = |error: image::ImageError| error.to_string();
    let (width, height) = reader()?.into_dimensions().map_err(told)?;
    let most = Texture::MAX_SIDE;
    if width.max(height) > most {
        return Err(format!(
            "it has {width}x{height} pixels; the most is {most}x{most}"
        ));
    }
    let mut reader = reader()?;
    let mut limits = Limits::default();
    limits.max_image_width = Some(most);
    limits.max_image_height = Some(most);
    reader.limits(limits);
    let picture = reader.decode().map_err(told)?;
    let has_alpha = picture.color().has_alpha();
    let texels = picture.into_rgb8().pixels().map(|pixel| pixel.0).collect();
    let texture = Texture::new(width, texels, wrap).ok_or("it has no pixels")?;
    Ok((texture, has_alpha))
}
