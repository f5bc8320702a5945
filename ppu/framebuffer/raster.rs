//! How much of the screen a picture fills.

use std::fmt;

/// How much of a television's picture ps3fb uses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Raster {
    /// The area that every television shows, within black borders that the driver makes: 1124x644
    /// of 720p.
    Bordered,
    /// The full screen: 1280x720 of 720p.
    Full,
}

impl fmt::Display for Raster {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Raster::Bordered => "a mode with borders",
            Raster::Full => "a full-screen mode",
        })
    }
}
