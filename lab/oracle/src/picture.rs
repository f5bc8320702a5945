//! Pictures of 8-bit red, green and blue, and their PNG files.
//!
//! Invariant: the number of pixels is width times height, and [`scenes::check_size`] accepts the
//! size.

use std::fs::{self, File};
use std::io::BufReader;
use std::path::Path;

use image::{ImageFormat, ImageReader, RgbImage};
use scenes::check_size;

use crate::{Error, Settings};

/// A picture of 8-bit red, green and blue.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Picture {
    image: RgbImage,
}

impl Picture {
    /// A black picture.
    ///
    /// # Errors
    /// The size is out of range.
    pub fn black(width: u32, height: u32) -> Result<Self, Error> {
        check_size(width, height)?;
        Ok(Self { image: RgbImage::new(width, height) })
    }

    /// Reads a PNG of 8-bit red, green and blue.
    ///
    /// # Errors
    /// The file can't be read, is not such a PNG, or is too large.
    pub fn read_png(path: &Path) -> Result<Self, Error> {
        let failed = |source| Error::Png { path: path.to_owned(), source };
        let file = File::open(path).map_err(|error| failed(error.into()))?;
        let reader = ImageReader::with_format(BufReader::new(file), ImageFormat::Png);
        match reader.decode().map_err(failed)? {
            image::DynamicImage::ImageRgb8(image) => {
                check_size(image.width(), image.height())?;
                Ok(Self { image })
            }
            other => {
                Err(Error::Kind { path: path.to_owned(), kind: format!("{:?}", other.color()) })
            }
        }
    }

    /// Writes a PNG; `-` is standard output.
    ///
    /// # Errors
    /// The name has the extension of another format, or the file can't be written.
    pub fn write_png(&self, path: &Path) -> Result<(), Error> {
        self.write_png_with(path, &Settings::default())
    }

    /// The same with the settings that the picture was made with.
    ///
    /// # Errors
    /// As for [`Self::write_png`].
    pub fn write_png_with(&self, path: &Path, settings: &Settings) -> Result<(), Error> {
        let failed =
            |error: std::io::Error| Error::Png { path: path.to_owned(), source: error.into() };
        if path == Path::new("-") {
            let bytes = self.encode(settings).map_err(|error| failed(error.into()))?;
            return messages::write_data(bytes).map_err(failed);
        }
        if path.extension().is_some_and(|extension| !extension.eq_ignore_ascii_case("png")) {
            return Err(Error::Format { path: path.to_owned() });
        }
        let bytes = self.encode(settings).map_err(|error| failed(error.into()))?;
        fs::write(path, bytes).map_err(failed)
    }

    fn encode(&self, settings: &Settings) -> Result<Vec<u8>, png::EncodingError> {
        let mut bytes = Vec::new();
        let mut encoder = png::Encoder::new(&mut bytes, self.width(), self.height());
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_compression(png::Compression::Fast);
        for (keyword, text) in settings.texts() {
            // Text of other characters than Latin-1's has a kind of its own.
            if text.is_ascii() {
                encoder.add_text_chunk(keyword, text)?;
            } else {
                encoder.add_itxt_chunk(keyword, text)?;
            }
        }
        let mut writer = encoder.write_header()?;
        writer.write_image_data(self.image.as_raw())?;
        writer.finish()?;
        Ok(bytes)
    }

    /// The width in pixels.
    #[must_use]
    pub fn width(&self) -> u32 {
        self.image.width()
    }

    /// The height in pixels.
    #[must_use]
    pub fn height(&self) -> u32 {
        self.image.height()
    }

    /// The pixels, row by row from the top.
    #[must_use]
    pub fn pixels(&self) -> &[[u8; 3]] {
        self.image.as_chunks().0
    }

    /// The pixels, mutable.
    pub fn pixels_mut(&mut self) -> &mut [[u8; 3]] {
        self.image.as_chunks_mut().0
    }
}
