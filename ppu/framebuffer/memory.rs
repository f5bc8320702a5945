//! A framebuffer in memory, whose frames can be compared or written as pictures.

use super::buffer::FrameBuffer;
use super::{Framebuffer, FramebufferError, Geometry, PixelFormat, Target};
use image::RgbImage;

/// One frame in private memory, with rows aligned to 128 bytes.
pub struct Memory {
    frame: FrameBuffer,
}

impl Memory {
    /// A black frame of size `geometry`.
    ///
    /// # Errors
    /// The size is out of range, or there is not enough memory.
    pub fn new(geometry: Geometry) -> Result<Memory, FramebufferError> {
        Ok(Memory { frame: FrameBuffer::new(geometry)? })
    }

    /// A frame that shows a picture, until another is written over it.
    ///
    /// # Errors
    /// As for [`Memory::new`].
    pub fn showing(picture: &RgbImage) -> Result<Memory, FramebufferError> {
        let (width, height) = picture.dimensions();
        let mut memory = Memory::new(Geometry { width, height })?;
        for (row, shown) in memory.frame.rows_mut().zip(picture.rows()) {
            for (pixel, shown) in row.as_chunks_mut::<4>().0.iter_mut().zip(shown) {
                *pixel = PixelFormat::ARGB.word(shown.0).to_be_bytes();
            }
        }
        Ok(memory)
    }

    /// The pixels, row by row from the top, as red, green, blue.
    pub fn pixels(&self) -> impl Iterator<Item = [u8; 3]> {
        let pixel = |bytes: &[u8]| {
            let word = u32::from_be_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]);
            PixelFormat::ARGB.channels(word)
        };
        self.frame.rows().flat_map(move |row| row.chunks_exact(4).map(pixel))
    }

    /// Whether each pixel was written since the last call, row by row from the top. The SPUs write
    /// 0 to its byte without a channel, where this leaves another value.
    pub fn take_written(&mut self) -> Vec<bool> {
        let pixels = self.frame.rows_mut().flat_map(|row| row.as_chunks_mut::<4>().0);
        pixels.map(|pixel| std::mem::replace(&mut pixel[0], u8::MAX) == 0).collect()
    }

    /// A copy of the frame as a picture.
    pub fn rgb(&self) -> RgbImage {
        let Geometry { width, height } = self.frame.geometry();
        let mut picture = RgbImage::new(width, height);
        for (shown, pixel) in picture.pixels_mut().zip(self.pixels()) {
            shown.0 = pixel;
        }
        picture
    }
}

impl Framebuffer for Memory {
    fn geometry(&self) -> Geometry {
        self.frame.geometry()
    }

    fn target(&mut self) -> Target {
        self.frame.target(PixelFormat::ARGB)
    }

    /// Does nothing, because the finished frame is already where readers expect it.
    fn present(&mut self) -> Result<(), FramebufferError> {
        Ok(())
    }

    fn keeps_contents(&self) -> bool {
        true
    }

    fn picture(&self) -> Option<RgbImage> {
        Some(self.rgb())
    }

    fn describe(&self) -> String {
        format!("memory, {}, stride {} bytes", self.frame.geometry(), self.frame.stride())
    }
}

#[cfg(test)]
mod tests {
    use super::super::pattern;
    use super::*;

    #[test]
    fn frames_read_back_as_written() {
        for (width, height) in [(1, 1), (101, 57), (64, 3)] {
            let mut memory = Memory::new(Geometry { width, height }).unwrap();
            for seed in 0..2 {
                pattern::paint(memory.target(), seed);
                memory.present().unwrap();
                pattern::assert_shows(&memory.rgb(), seed);
            }
        }
    }

    #[test]
    fn side_of_zero_is_refused() {
        let error = Memory::new(Geometry { width: 0, height: 4 }).err().unwrap();
        assert!(error.to_string().contains("0x4"), "{error}");
    }
}
