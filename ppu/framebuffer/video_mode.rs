//! ps3fb's video modes: with borders, as televisions cut some of the picture, or of the whole
//! screen.
//!
//! Invariant: a mode that was changed is put back when the [`Moded`] driver is dropped. The mode
//! is not part of what the driver forgets when it is closed.

use super::FramebufferError;
use super::driver::Driver;
use super::ioctl::Encoding;
use super::last_resort::{Argument, Place, PutBack};
use super::raster::Raster;
use super::surface::PS3FB;
use std::ops::{Deref, DerefMut};
use std::path::Path;

/// Bits of a mode's number that say which; 0 leaves it to the kernel.
const BASE: u32 = 0x0F;
/// Last mode of a television: those above are of monitors, which cut nothing.
const LAST_TELEVISION: u32 = 10;
/// Bit of a mode that fills the whole screen.
const FULL: u32 = 0x80;

/// A driver whose video mode may have been changed.
pub(super) struct Moded {
    // Dropped first: it needs the driver open.
    _promise: Option<PutBack>,
    driver: Box<dyn Driver>,
    found: Option<u32>,
}

impl Moded {
    /// The driver in the mode that it is in.
    pub(super) fn keep(driver: Box<dyn Driver>) -> Moded {
        Moded {
            driver,
            found: None,
            _promise: None,
        }
    }

    /// Changes the mode of ps3fb, which `name` should be, to the one of the same lines and rate
    /// that has `raster`, if it is another.
    pub(super) fn set(
        &mut self,
        raster: Raster,
        name: &str,
        path: &Path,
    ) -> Result<(), FramebufferError> {
        let refused = |why: String| FramebufferError::NoVideoMode {
            path: path.to_owned(),
            raster,
            why,
        };
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
        let promise = self
            .driver
            .promise(Place::Mode, request, Argument::Word(found));
        self.driver
            .ps3fb_setmode(wanted)
            .map_err(|error| refused(format!("PS3FB_IOCTL_SETMODE {wanted}: {error}")))?;
        self.found = Some(found);
        self._promise = promise;
        Ok(())
    }
}

/// The number of the mode like `mode` that has `raster`, where there is one.
fn with_raster(mode: u32, raster: Raster) -> Option<u32> {
    let television = mode & BASE <= LAST_TELEVISION;
    match raster {
        Raster::Full if television => Some(mode | FULL),
        Raster::Full => Some(mode),
        Raster::Bordered if television => Some(mode & !FULL),
        Raster::Bordered => None,
    }
}

impl Deref for Moded {
    type Target = dyn Driver;

    fn deref(&self) -> &(dyn Driver + 'static) {
        self.driver.as_ref()
    }
}

impl DerefMut for Moded {
    fn deref_mut(&mut self) -> &mut (dyn Driver + 'static) {
        self.driver.as_mut()
    }
}

impl Drop for Moded {
    fn drop(&mut self) {
        if let Some(mode) = self.found {
            // There is nobody left to tell.
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
            // Automatic: the kernel chooses the lines.
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
