//! Pictures whose pixels are averages of four rays through their corners, as the Standard
//! Procedural Databases require.
//!
//! Invariant: the traced frame has one more row and one more column than the picture. The rays'
//! colours are rounded to bytes before they are averaged, so a pixel is up to half a step off its
//! exact mean.

use super::{
    Framebuffer, FramebufferError, Geometry, Labels, Memory, PictureFile, Target, write_labelled,
};
use image::{Rgb, RgbImage};
use std::path::{Path, PathBuf};

/// A framebuffer for rays through corners. Every presented frame replaces the picture at its path,
/// if it has one.
pub struct Corners {
    memory: Memory,
    path: Option<PathBuf>,
    labels: Labels,
}

impl Corners {
    /// Prepares frames for a picture of size `geometry`. Nothing is written before the first
    /// frame.
    ///
    /// # Errors
    /// - No picture can be written to `path`.
    /// - The frame, which is one larger in both directions, exceeds the largest size, or there is
    ///   not enough memory for it.
    pub fn new(path: Option<&Path>, geometry: Geometry) -> Result<Corners, FramebufferError> {
        if let Some(path) = path {
            PictureFile::new(path, geometry)?;
        }
        let memory =
            Memory::new(Geometry { width: geometry.width + 1, height: geometry.height + 1 })?;
        Ok(Corners { memory, path: path.map(Path::to_owned), labels: Labels::default() })
    }

    /// The same with these labels in the file.
    #[must_use]
    pub fn labelled(self, labels: Labels) -> Corners {
        Corners { labels, ..self }
    }

    fn averaged(&self) -> RgbImage {
        let rays = self.memory.rgb();
        RgbImage::from_fn(rays.width() - 1, rays.height() - 1, |x, y| {
            let corners = [(x, y), (x + 1, y), (x, y + 1), (x + 1, y + 1)];
            let mean = |channel: usize| {
                let sum: u16 =
                    corners.iter().map(|&(x, y)| u16::from(rays.get_pixel(x, y)[channel])).sum();
                ((sum + 2) / 4) as u8
            };
            Rgb([mean(0), mean(1), mean(2)])
        })
    }
}

impl Framebuffer for Corners {
    fn geometry(&self) -> Geometry {
        self.memory.geometry()
    }

    fn target(&mut self) -> Target {
        self.memory.target()
    }

    fn present(&mut self) -> Result<(), FramebufferError> {
        match &self.path {
            Some(path) => write_labelled(path, &self.averaged(), &self.labels),
            None => Ok(()),
        }
    }

    fn keeps_contents(&self) -> bool {
        self.memory.keeps_contents()
    }

    fn describe(&self) -> String {
        let Geometry { width, height } = self.geometry();
        format!("picture of {}x{} means of four rays", width - 1, height - 1)
    }
}

#[cfg(test)]
mod tests {
    use super::super::pattern;
    use super::*;

    #[test]
    fn pixel_is_mean_of_corners() {
        let geometry = Geometry { width: 9, height: 5 };
        let mut corners = Corners::new(None, geometry).unwrap();
        assert_eq!(corners.geometry().to_string(), "10x6");
        pattern::paint(corners.target(), 3);
        let (rays, picture) = (corners.memory.rgb(), corners.averaged());
        assert_eq!(picture.dimensions(), (9, 5));
        for (x, y, pixel) in picture.enumerate_pixels() {
            for channel in 0..3 {
                let sum: f64 = [(0, 0), (1, 0), (0, 1), (1, 1)]
                    .iter()
                    .map(|(right, down)| f64::from(rays.get_pixel(x + right, y + down)[channel]))
                    .sum();
                assert_eq!(f64::from(pixel[channel]), (sum / 4.0 + 0.5).floor());
            }
        }
    }

    #[test]
    fn picture_is_written_when_presented() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("p.png");
        let geometry = Geometry { width: 4, height: 4 };
        let mut corners = Corners::new(Some(&path), geometry).unwrap();
        assert!(!path.exists());
        corners.present().unwrap();
        assert_eq!(image::image_dimensions(&path).unwrap(), (4, 4));
    }
}
