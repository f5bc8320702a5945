//! ps3fb's video modes: with borders, because televisions cut off some of the picture, or full
//! screen.
//!
//! Invariant: a changed mode is restored when the [`VideoModeGuard`] is dropped. The driver would
//! keep the changed mode after it is closed.

use super::FramebufferError;
use super::driver::Driver;
use super::ioctl::Encoding;
use super::last_resort::{Argument, Place, RestorePromise};
use super::raster::Raster;
use super::surface::PS3FB;
use std::ops::{Deref, DerefMut};
use std::path::Path;

/// The bits of a mode's number that select its lines and rate; 0 leaves the choice to the kernel.
const BASE: u32 = 0x0F;
/// The last mode for televisions. The modes above are for monitors, which cut nothing off.
const LAST_TELEVISION: u32 = 10;
/// The bit of a mode's number that selects the full screen.
const FULL: u32 = 0x80;

/// A driver whose video mode may have been changed. Dropping it restores the mode.
pub(super) struct VideoModeGuard {
    // Dropped first: it needs the driver open.
    _promise: Option<RestorePromise>,
    driver: Box<dyn Driver>,
    found: Option<u32>,
}

impl VideoModeGuard {
    /// Wraps a driver, and leaves its mode unchanged.
    pub(super) fn keep(driver: Box<dyn Driver>) -> VideoModeGuard {
        VideoModeGuard { driver, found: None, _promise: None }
    }

    /// Changes the mode of ps3fb to the one with the same lines and rate, and with `raster`.
    /// `name` is the driver's; any other than ps3fb is an error.
    pub(super) fn set(
        &mut self,
        raster: Raster,
        name: &str,
        path: &Path,
    ) -> Result<(), FramebufferError> {
        let refused =
            |why: String| FramebufferError::NoVideoMode { path: path.to_owned(), raster, why };
        if name != PS3FB {
            return Err(refused(format!("driver {name} is not {PS3FB}")));
        }
        let found = self
            .driver
            .ps3fb_getmode()
            .map_err(|error| refused(format!("PS3FB_IOCTL_GETMODE: {error}")))?;
        let Some(wanted) = with_raster(found, raster) else {
            return Err(refused(format!(
                "video mode {found} is a monitor's, which has no borders"
            )));
        };
        if wanted == found {
            return Ok(());
        }
        let request = const { Encoding::HOST.ps3fb_ioctl_setmode() };
        let promise = self.driver.promise(Place::Mode, request, Argument::Word(found));
        self.driver
            .ps3fb_setmode(wanted)
            .map_err(|error| refused(format!("PS3FB_IOCTL_SETMODE {wanted}: {error}")))?;
        self.found = Some(found);
        self._promise = promise;
        Ok(())
    }
}

/// The number of the mode like `mode` but with `raster`, if there is one.
fn with_raster(mode: u32, raster: Raster) -> Option<u32> {
    let television = mode & BASE <= LAST_TELEVISION;
    match raster {
        Raster::Full if television => Some(mode | FULL),
        Raster::Full => Some(mode),
        Raster::Bordered if television => Some(mode & !FULL),
        Raster::Bordered => None,
    }
}

impl Deref for VideoModeGuard {
    type Target = dyn Driver;

    fn deref(&self) -> &(dyn Driver + 'static) {
        self.driver.as_ref()
    }
}

impl DerefMut for VideoModeGuard {
    fn deref_mut(&mut self) -> &mut (dyn Driver + 'static) {
        self.driver.as_mut()
    }
}

impl Drop for VideoModeGuard {
    fn drop(&mut self) {
        if let Some(mode) = self.found {
            // A drop can't report an error.
            let _ = self.driver.ps3fb_setmode(mode);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn modes_differ_in_one_bit() {
        let cases = [
            (3, Raster::Full, Some(131)),
            (131, Raster::Full, Some(131)),
            (131, Raster::Bordered, Some(3)),
            (8 | 0x1000, Raster::Full, Some(136 | 0x1000)),
            // Mode 0: the kernel chooses the lines.
            (0, Raster::Full, Some(128)),
            (10, Raster::Bordered, Some(10)),
            (11, Raster::Full, Some(11)),
            (13 | 0x40, Raster::Bordered, None),
        ];
        for (mode, raster, expected) in cases {
            assert_eq!(with_raster(mode, raster), expected, "{mode} {raster}");
        }
    }
}
